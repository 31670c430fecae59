//! POCKET (APT: `APOCK`): a convex polygon cleared from the inside out.
//!
//! The passes are closed polygons, each the next one inwards by the programmed cut. They are computed from
//! the outside and cut from the inside, always beginning at the corner of the first point.

use aptc_geometry::{Form, Plane, Vec3};
use aptc_protap::Pocket;

use crate::state::{Part, Settings, Tool};

/// Least and greatest number of corners.
const CORNERS: std::ops::RangeInclusive<usize> = 3..=20;

/// More passes than this are a mistake in the numbers.
const MOST_PASSES: usize = 10_000;

/// Closed polygons, innermost first; the last is the finish pass.
pub(crate) type Passes = Vec<Vec<Vec3>>;

/// Why there are no passes.
pub(crate) type Reason = String;

/// The passes of a pocket.
pub(crate) fn passes(p: &Pocket, settings: &Settings, tool: &Tool) -> Result<Passes, Reason> {
    let cutter = settings.cutter.map_or(0.0, |c| c.diameter / 2.0);
    let [keep_offsets, kind] = p.flags;
    let points = if kind >= 2 { project(&p.vertices, settings, tool)? } else { p.vertices.clone() };
    let mut figure = Figure::new(&points)?;
    if kind % 2 == 1 {
        figure = figure.inset(cutter).ok_or("the cutter does not fit into the pocket")?;
    }
    let positive = |x: f64| x > 0.0 && x.is_finite();
    if !positive(p.radius) || !positive(p.cut) || !positive(p.finish) || !positive(cutter) {
        return Err("effective radius, cuts and cutter must be above zero".into());
    }
    let mut passes = vec![figure.closed()];
    let mut cut = p.finish * cutter;
    while passes.len() < MOST_PASSES {
        let room = figure.room();
        if room <= p.radius {
            passes.reverse();
            return Ok(passes);
        }
        let mut step = cut;
        if keep_offsets == 0 {
            // So deep may the next pass lie that no material stays at the sharpest corner.
            step = step.min(p.radius * (1.0 + figure.sharpest()));
        }
        if room - step / 2.0 <= p.radius {
            step /= 2.0;
        }
        if step >= room {
            // The innermost pass still has to be a figure.
            step = room - p.radius / 2.0;
        }
        figure = figure.inset(step).ok_or("the pocket collapses")?;
        passes.push(figure.closed());
        cut = p.cut * cutter;
    }
    Err("the cut is too small for the pocket".into())
}

/// Points moved along the tool axis onto the part surface.
fn project(points: &[Vec3], settings: &Settings, tool: &Tool) -> Result<Vec<Vec3>, Reason> {
    let plane = match &settings.part {
        Part::Surface(s) => match s.form.shape() {
            Form::Plane(p) => *p,
            _ => return Err("the part surface of this kind of pocket must be a plane".into()),
        },
        Part::Auto => Plane { n: tool.ta, d: tool.ta.dot(&tool.te) },
    };
    let rate = plane.n.dot(&tool.ta);
    if rate.abs() < 0.2 {
        return Err("the part plane is too steep for the tool axis".into());
    }
    Ok(points.iter().map(|p| p - tool.ta * (plane.distance(*p) / rate)).collect())
}

/// A convex polygon in a plane.
#[derive(Clone, Debug)]
struct Figure {
    normal: Vec3,
    /// Sides in order: a point, the unit direction along, the place of its start among the given points.
    sides: Vec<Side>,
    corners: Vec<Vec3>,
}

#[derive(Clone, Copy, Debug)]
struct Side {
    on: Vec3,
    along: Vec3,
    index: usize,
}

impl Figure {
    fn new(points: &[Vec3]) -> Result<Self, Reason> {
        let n = points.len();
        if !CORNERS.contains(&n) {
            return Err(format!("a pocket has 3 to 20 corners, not {n}"));
        }
        let next = |i: usize| points[(i + 1) % n];
        let area: Vec3 = (0..n).map(|i| points[i].cross(&next(i))).sum();
        let size = points.iter().map(|p| (p - points[0]).norm()).fold(0.0, f64::max);
        let normal = area / area.norm();
        if area.norm() <= 1e-9 * size * size {
            return Err("the corners of the pocket lie on a line".into());
        }
        if points.iter().any(|p| (p - points[0]).dot(&normal).abs() > 1e-6 * size) {
            return Err("the corners of the pocket do not lie in a plane".into());
        }
        let mut sides = Vec::with_capacity(n);
        for (index, on) in points.iter().copied().enumerate() {
            let v = next(index) - on;
            if v.norm() <= 1e-9 * size {
                return Err("a corner of the pocket is given twice".into());
            }
            sides.push(Side { on, along: v.normalize(), index });
        }
        for i in 0..n {
            if sides[i].along.cross(&sides[(i + 1) % n].along).dot(&normal) < -1e-9 {
                return Err("the pocket has a corner that points inwards".into());
            }
        }
        Ok(Self { normal, sides, corners: points.to_vec() })
    }

    /// The polygon with all sides moved in; sides that vanish are left out.
    fn inset(&self, by: f64) -> Option<Self> {
        let inwards = |s: &Side| self.normal.cross(&s.along);
        let mut sides: Vec<Side> =
            self.sides.iter().map(|s| Side { on: s.on + inwards(s) * by, ..*s }).collect();
        // Each round drops the sides that run backwards; a convex figure has at most all of them.
        for _ in 0..self.sides.len() {
            if sides.len() < 3 {
                return None;
            }
            let n = sides.len();
            let corners: Option<Vec<Vec3>> =
                (0..n).map(|i| cross(&sides[(i + n - 1) % n], &sides[i], self.normal)).collect();
            let corners = corners?;
            let lengths: Vec<f64> =
                (0..n).map(|i| (corners[(i + 1) % n] - corners[i]).dot(&sides[i].along)).collect();
            let worst = (0..n).min_by(|a, b| lengths[*a].total_cmp(&lengths[*b]))?;
            if lengths[worst] > 0.0 {
                return Some(Self { normal: self.normal, sides, corners });
            }
            if lengths.iter().all(|l| *l <= 0.0) {
                return None;
            }
            sides.remove(worst);
        }
        None
    }

    /// Greatest distance of an inner point from the sides.
    fn room(&self) -> f64 {
        let (mut a, mut b) = (0.0, 0.0);
        for p in &self.corners {
            b = (p - self.corners[0]).norm().max(b);
        }
        for _ in 0..60 {
            let m = 0.5 * (a + b);
            if self.inset(m).is_some() { a = m } else { b = m }
        }
        a
    }

    /// Sine of half the sharpest corner.
    fn sharpest(&self) -> f64 {
        let n = self.sides.len();
        (0..n)
            .map(|i| {
                let (a, b) = (self.sides[i].along, self.sides[(i + 1) % n].along);
                // The inner angle is what the turn leaves of 180 degrees.
                ((1.0 + a.dot(&b)) / 2.0).max(0.0).sqrt()
            })
            .fold(1.0, f64::min)
    }

    /// Corners from the one of the first point on, and that one again.
    fn closed(&self) -> Vec<Vec3> {
        let n = self.corners.len();
        let first = (0..n).min_by_key(|i| self.sides[*i].index).unwrap_or(0);
        // When the side that begins at the first point has vanished, its corner is the end of the last.
        (0..=n).map(|i| self.corners[(first + i) % n]).collect()
    }
}

/// The common point of two lines in the plane.
fn cross(a: &Side, b: &Side, normal: Vec3) -> Option<Vec3> {
    let det = a.along.cross(&b.along).dot(&normal);
    if det <= 1e-9 {
        return None;
    }
    let t = (b.on - a.on).cross(&b.along).dot(&normal) / det;
    Some(a.on + a.along * t)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square(side: f64) -> Vec<Vec3> {
        [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)]
            .map(|(x, y)| Vec3::new(x * side, y * side, 1.0))
            .to_vec()
    }

    #[test]
    fn a_square_shrinks_and_vanishes_at_its_half() {
        let f = Figure::new(&square(4.0)).unwrap();
        assert_eq!(f.inset(1.0).unwrap().corners[0], Vec3::new(1.0, 1.0, 1.0));
        assert!(f.inset(2.1).is_none());
        assert!((f.room() - 2.0).abs() < 1e-9);
        assert!((f.sharpest() - 0.5f64.sqrt()).abs() < 1e-12);
    }

    #[test]
    fn a_short_side_vanishes() {
        // A square with one corner cut off.
        let mut p = square(4.0);
        p[2] = Vec3::new(4.0, 3.5, 1.0);
        p.insert(3, Vec3::new(3.5, 4.0, 1.0));
        let f = Figure::new(&p).unwrap();
        assert_eq!(f.inset(0.1).unwrap().sides.len(), 5);
        assert_eq!(f.inset(1.0).unwrap().sides.len(), 4);
    }

    #[test]
    fn a_corner_that_points_inwards_is_refused() {
        let mut p = square(4.0);
        p.insert(1, Vec3::new(2.0, 1.0, 1.0));
        assert!(Figure::new(&p).is_err());
    }
}
