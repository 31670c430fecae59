//! The level path between VTLAXS/ON and OFF, by the way along it.

use aptc_cldata::{Kind, flatten};
use aptc_geometry::Vec3;

use super::Section;
use super::corner::Corner;

pub(super) const WITHOUT_MULTAX: &str = "VTLAXS without MULTAX";

/// The level path: vertices, the way to each, and the record each belongs to.
pub(super) struct Path {
    vertices: Vec<Vec3>,
    way: Vec<f64>,
    record: Vec<usize>,
}

impl Path {
    pub(super) fn new(section: &Section) -> Result<Self, (&'static str, &'static str)> {
        let Some(start) = section.start else {
            return Err(("VTLAXS before the tool has a position", "begin with FROM or GOTO"));
        };
        let mut path = Self { vertices: vec![start.te], way: vec![0.0], record: vec![0] };
        let mut last = start;
        for (i, record) in section.held.iter().enumerate() {
            let Kind::Motion(m) = &record.kind else { continue };
            if !m.with_axis {
                return Err((WITHOUT_MULTAX, "write MULTAX before the motion"));
            }
            for p in flatten::positions(m, Some(last), 1e-3 * section.radius) {
                let step = (p.te - path.vertices[path.vertices.len() - 1]).norm();
                let way = path.way[path.way.len() - 1] + step;
                path.vertices.push(p.te);
                path.way.push(way);
                path.record.push(i);
                if (p.ta - Vec3::z()).norm() > 1e-9 {
                    return Err((
                        "VTLAXS with a tool that is not upright",
                        "write TLAXIS/0,0,1 before the motion",
                    ));
                }
                last = p;
            }
        }
        let z = start.te.z;
        let slack = 1e-6 * section.radius.max(path.length());
        if path.vertices.iter().any(|p| (p.z - z).abs() > slack) {
            return Err((
                "VTLAXS along a path that is not level",
                "all positions between ON and OFF, and the one before, need the same z",
            ));
        }
        if path.length() <= 0.0 {
            return Err(("VTLAXS without motion", "put the motion between ON and OFF"));
        }
        Ok(path)
    }

    pub(super) fn length(&self) -> f64 {
        self.way[self.way.len() - 1]
    }

    /// The way up to the last vertex of the motions before a record.
    pub(super) fn up_to_record(&self, record: usize) -> f64 {
        let n = self.record.iter().take_while(|r| **r < record).count();
        self.way[n.max(1) - 1]
    }

    /// Vertices of a record as ways, with the steps at a corner in their places.
    pub(super) fn stations(&self, record: usize, corner: Option<&Corner>) -> Vec<f64> {
        let own = |i: &usize| self.record[*i] == record;
        let mut list: Vec<f64> = (1..self.way.len()).filter(own).map(|i| self.way[i]).collect();
        let (Some(corner), Some(first), Some(last)) =
            (corner, list.first().copied(), list.last().copied())
        else {
            return list;
        };
        let before = (1..self.way.len()).find(own).map_or(first, |i| self.way[i - 1]);
        let slack = 1e-9 * self.length();
        list.retain(|s| !corner.covers(*s, slack));
        let steps = corner.steps.iter().copied();
        // The corner itself ends the motion into it.
        list.extend(steps.filter(|s| *s > before + slack && *s <= last + slack));
        list.sort_by(f64::total_cmp);
        list
    }

    /// Point and directions of arriving and leaving at a way.
    pub(super) fn at(&self, s: f64) -> (Vec3, Vec3, Vec3) {
        let n = self.way.len();
        let i = self.way.partition_point(|w| *w < s - 1e-12 * self.length()).clamp(1, n - 1);
        let (a, b) = (self.vertices[i - 1], self.vertices[i]);
        let (wa, wb) = (self.way[i - 1], self.way[i]);
        let t = if wb > wa { ((s - wa) / (wb - wa)).clamp(0.0, 1.0) } else { 1.0 };
        let point = a + (b - a) * t;
        let arriving = self.direction(i);
        let at_vertex = (s - wb).abs() <= 1e-9 * self.length();
        let leaving = if at_vertex && i + 1 < n { self.direction(i + 1) } else { arriving };
        (point, arriving, leaving)
    }

    /// Direction of the chord that ends at vertex `i`; of the nearest one when it has no length.
    fn direction(&self, i: usize) -> Vec3 {
        let chord = |i: usize| (self.vertices[i] - self.vertices[i - 1]).try_normalize(0.0);
        let ahead = (i..self.vertices.len()).find_map(chord);
        ahead.or_else(|| (1..i).rev().find_map(chord)).unwrap_or_else(Vec3::x)
    }
}
