//! The stock: a block of material from which cuts take away and through which no rapid motion may go.
//!
//! The material is kept as a height over each cell of a grid (a Z map), so the check is for tools that
//! stand along Z. A cut lowers the cells under the cutter; a rapid motion that would lower one by more than
//! the resolution of the grid allows for goes through material. What the grid cannot tell (a graze of
//! less than a cell at the cutter's side) is not reported: each report is true, with place and depth.

use aptc_geometry::{Profile, Vec3, trig};

/// Cells along the longer side of the block, at most.
const MOST_CELLS: usize = 400;

/// Steps by which the lowest place of a sloping motion over a cell is enclosed; each leaves 0.62 of the last.
const STEPS: u32 = 24;

/// A block of material and what cuts have left of it.
#[derive(Clone, Debug)]
pub(crate) struct Stock {
    min: Vec3,
    max: Vec3,
    cell: f64,
    n: [usize; 2],
    heights: Vec<f64>,
}

/// Where a motion is deepest in the material.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Hit {
    /// The place on the stock.
    pub(crate) at: Vec3,
    /// How far below the material's surface the cutter is there.
    pub(crate) depth: f64,
}

impl Stock {
    /// The block between two corners; `None` when it has no volume.
    pub(crate) fn new(a: Vec3, b: Vec3) -> Option<Self> {
        let (min, max) = (a.inf(&b), a.sup(&b));
        let size = max - min;
        let whole = size.iter().all(|s| s.is_finite() && *s > 0.0);
        if !whole {
            return None;
        }
        let most = f64::from(u16::try_from(MOST_CELLS).unwrap_or(u16::MAX));
        let cell = size.x.max(size.y) / most;
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "1 to 400")]
        let n = [size.x, size.y].map(|s| ((s / cell).ceil() as usize).clamp(1, MOST_CELLS));
        Some(Self { min, max, cell, n, heights: vec![max.z; n[0] * n[1]] })
    }

    /// A cut along a straight line takes material away.
    pub(crate) fn cut(&mut self, from: Vec3, to: Vec3, cutter: Option<&Profile>) {
        let radius = cutter.map_or(0.0, Profile::widest);
        // Even a cutter finer than the grid takes the cells away through which it goes.
        let over = Over { profile: cutter, spare: 0.0, reach: radius.max(0.75 * self.cell) };
        self.each_cell(from, to, over.reach, |cell, height| {
            if let Some(low) = over.lowest(from, to, cell)
                && low < *height
            {
                *height = low;
            }
        });
    }

    /// The deepest place of a straight motion in the material, if it goes through any.
    pub(crate) fn hit(&mut self, from: Vec3, to: Vec3, cutter: Option<&Profile>) -> Option<Hit> {
        let radius = cutter.map_or(0.0, Profile::widest);
        // What a cell holds is known at its middle: the cutter counts as narrower by most of a cell, and a
        // cutter finer than that as a line.
        let spare = (0.75 * self.cell).min(0.5 * radius);
        // Half the diagonal of a cell, so that a line always goes through one.
        let reach = (radius - spare).max(0.72 * self.cell);
        let over = Over { profile: cutter, spare, reach };
        let (bottom, mut worst) = (self.min.z, None::<Hit>);
        let least = 1e-3 * self.cell;
        if self.beside(from, to, radius) {
            return None;
        }
        self.each_cell(from, to, reach, |cell, height| {
            let Some(low) = over.lowest(from, to, cell) else { return };
            let depth = *height - low.max(bottom);
            if *height > bottom && depth > least && worst.is_none_or(|w| depth > w.depth) {
                worst = Some(Hit { at: Vec3::new(cell.x, cell.y, low.max(bottom)), depth });
            }
        });
        worst
    }

    /// Whether a motion of that radius stays beside the block on one side of it.
    fn beside(&self, from: Vec3, to: Vec3, radius: f64) -> bool {
        (0..2).any(|i| {
            from[i].max(to[i]) + radius < self.min[i] || from[i].min(to[i]) - radius > self.max[i]
        })
    }

    /// Calls `f` with the middle and the height of each cell that a motion of that radius may touch.
    fn each_cell(&mut self, from: Vec3, to: Vec3, radius: f64, mut f: impl FnMut(Vec3, &mut f64)) {
        if from.z.min(to.z) >= self.max.z || self.beside(from, to, radius) {
            return;
        }
        let range = |i: usize| {
            let (low, high) = (from[i].min(to[i]) - radius, from[i].max(to[i]) + radius);
            let index = |v: f64| {
                let c = (v - self.min[i]) / self.cell;
                #[expect(
                    clippy::cast_possible_truncation,
                    clippy::cast_sign_loss,
                    reason = "clamped"
                )]
                let c = c.floor().clamp(0.0, 65535.0) as usize;
                c
            };
            index(low)..(index(high) + 1).min(self.n[i])
        };
        let (columns, rows) = (range(0), range(1));
        for row in rows {
            for column in columns.clone() {
                let middle = |i: usize, k: usize| {
                    self.min[i]
                        + self.cell * (0.5 + f64::from(u16::try_from(k).unwrap_or(u16::MAX)))
                };
                let cell = Vec3::new(middle(0, column), middle(1, row), 0.0);
                f(cell, &mut self.heights[row * self.n[0] + column]);
            }
        }
    }
}

/// A cutter over the grid.
#[derive(Clone, Copy, Debug)]
struct Over<'p> {
    profile: Option<&'p Profile>,
    /// It counts as narrower by this.
    spare: f64,
    /// Cells farther from its path than this are not touched.
    reach: f64,
}

impl Over<'_> {
    /// Height of the cutter's surface above the tool end; a cutter finer than the grid counts as a line.
    fn height(&self, distance: f64) -> f64 {
        let at = |p: &Profile| p.height_at((distance + self.spare).min(p.widest()));
        self.profile.and_then(at).unwrap_or(0.0)
    }

    /// The lowest that the cutter gets over a cell; `None` beside its path.
    fn lowest(&self, from: Vec3, to: Vec3, cell: Vec3) -> Option<f64> {
        let (dx, dy) = (to.x - from.x, to.y - from.y);
        let length2 = dx * dx + dy * dy;
        let nearest = if length2 > 0.0 {
            (((cell.x - from.x) * dx + (cell.y - from.y) * dy) / length2).clamp(0.0, 1.0)
        } else {
            0.0
        };
        let distance = |t: f64| trig::hypot(cell.x - from.x - t * dx, cell.y - from.y - t * dy);
        let reach = self.reach;
        if distance(nearest) > reach {
            return None;
        }
        let rise = to.z - from.z;
        let at = |t: f64| from.z + t * rise + self.height(distance(t));
        if length2 <= 0.0 {
            return Some(from.z.min(to.z) + self.height(distance(0.0)));
        }
        if rise.abs() <= 0.0 {
            return Some(at(nearest));
        }
        // Height over the cell is convex along the motion while the cell is under the cutter.
        let half =
            ((reach * reach - distance(nearest) * distance(nearest)).max(0.0) / length2).sqrt();
        let (mut low, mut high) = ((nearest - half).max(0.0), (nearest + half).min(1.0));
        for _ in 0..STEPS {
            let third = (high - low) * 0.381_966;
            if at(low + third) <= at(high - third) {
                high -= third;
            } else {
                low += third;
            }
        }
        Some(at(f64::midpoint(low, high)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use aptc_geometry::Cutter;

    fn block() -> Stock {
        Stock::new(Vec3::new(0.0, 0.0, -20.0), Vec3::new(100.0, 50.0, 0.0)).unwrap()
    }

    fn v(x: f64, y: f64, z: f64) -> Vec3 {
        Vec3::new(x, y, z)
    }

    fn mill(diameter: f64, corner: f64) -> Profile {
        Profile::new(&Cutter::mill(diameter, corner, 50.0)).unwrap()
    }

    #[test]
    fn over_and_beside_the_block_is_free_and_through_it_is_not() {
        let (mut s, mill) = (block(), mill(10.0, 0.0));
        let end_mill = || Some(&mill);
        assert_eq!(s.hit(v(-20.0, 25.0, 0.0), v(120.0, 25.0, 0.0), end_mill()), None);
        assert_eq!(s.hit(v(-20.0, -5.5, -10.0), v(120.0, -5.5, -10.0), end_mill()), None);
        let hit = s.hit(v(-20.0, 25.0, -3.0), v(120.0, 25.0, -3.0), end_mill()).unwrap();
        assert!((hit.depth - 3.0).abs() < 1e-12);
        // Without CUTTER the tool is a line, also when it goes aslant.
        assert_eq!(s.hit(v(-40.0, 20.0, -5.0), v(20.0, -40.0, -5.0), None), None);
        assert!(s.hit(v(50.0, 25.0, 5.0), v(50.0, 25.0, -1.0), None).is_some());
    }

    #[test]
    fn the_way_back_through_a_slot_is_free_with_the_same_cutter_only() {
        let wide = mill(14.0, 0.0);
        for cutter in [mill(10.0, 0.0), mill(10.0, 5.0), mill(10.0, 2.0), mill(0.1, 0.0)] {
            let cutter = &cutter;
            let mut s = block();
            let (a, b) = (v(-10.0, 20.0, -4.0), v(60.0, 31.0, -9.0));
            s.cut(a, b, Some(cutter));
            assert_eq!(s.hit(b, a, Some(cutter)), None, "back along the slot");
            assert_eq!(s.hit(b, v(60.0, 31.0, 10.0), Some(cutter)), None, "up out of it");
            assert!(s.hit(b, a, Some(&wide)).is_some());
            let deeper = s.hit(b, v(60.0, 31.0, -9.5), Some(cutter)).unwrap();
            assert!((deeper.depth - 0.5).abs() < 0.2, "{}", deeper.depth);
        }
    }

    #[test]
    fn the_lowest_of_a_sloping_ball_is_that_of_dense_sampling() {
        let ball = mill(8.0, 4.0);
        let ball = Over { profile: Some(&ball), spare: 0.0, reach: 4.0 };
        let (from, to) = (v(0.0, 0.0, 0.0), v(20.0, 5.0, -7.0));
        for i in 0..200 {
            let k = f64::from(i);
            let cell = v((k * 7.31) % 24.0 - 2.0, (k * 3.77) % 9.0 - 2.0, 0.0);
            let sampled = (0..=20_000)
                .filter_map(|j| {
                    let p = from + (to - from) * (f64::from(j) / 20_000.0);
                    let d = trig::hypot(cell.x - p.x, cell.y - p.y);
                    (d <= 4.0).then(|| p.z + 4.0 - (16.0 - d * d).max(0.0).sqrt())
                })
                .fold(f64::INFINITY, f64::min);
            match ball.lowest(from, to, cell) {
                Some(low) => assert!((low - sampled).abs() < 2e-3, "{cell}: {low} {sampled}"),
                None => assert!(sampled.is_infinite()),
            }
        }
    }

    #[test]
    fn a_block_without_volume_is_none() {
        assert!(Stock::new(Vec3::zeros(), v(1.0, 1.0, 0.0)).is_none());
        assert!(Stock::new(Vec3::zeros(), v(f64::NAN, 1.0, 1.0)).is_none());
    }
}
