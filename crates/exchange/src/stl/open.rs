//! Where triangles leave a surface open, so that a tool may come through.

use std::collections::BTreeMap;

use aptc_geometry::Vec3;

/// Corners within this share of the size of all are one: files have six digits or more.
const SAME: f64 = 1e-6;
/// Cells in which corners are looked for are so many times as wide.
const WIDE: f64 = 64.0;

/// Of triangles with edges that have a triangle on one side alone, how many and where.
pub(super) fn told(all: &[[Vec3; 3]]) -> Option<String> {
    let mut corners = Corners::of(all);
    // Edges by their corners; of those whose corners are one there is nothing to see.
    let mut edges = BTreeMap::<[usize; 2], (u32, [Vec3; 2])>::new();
    for t in all {
        let ids = t.map(|p| corners.number(p));
        for k in 0..3 {
            let j = (k + 1) % 3;
            let (a, b) = (ids[k].min(ids[j]), ids[k].max(ids[j]));
            if a != b {
                edges.entry([a, b]).or_insert((0, [t[k], t[j]])).0 += 1;
            }
        }
    }
    let open: Vec<[Vec3; 2]> = edges.values().filter(|e| e.0 == 1).map(|e| e.1).collect();
    let length = |e: &[Vec3; 2]| (e[1] - e[0]).norm();
    let longest = open.iter().max_by(|a, b| length(a).total_cmp(&length(b)))?;
    let [from, to] = longest.map(|p| format!("{}, {}, {}", p.x, p.y, p.z));
    Some(format!(
        "its triangles do not close: {} edges have one on one side alone, the longest from {from} to {to}; where that is a hole, a tool that comes through it is not seen",
        open.len()
    ))
}

/// Corners by number, those that are one but for digits by the same.
struct Corners {
    near: f64,
    cells: BTreeMap<[i64; 3], Vec<(Vec3, usize)>>,
    n: usize,
}

impl Corners {
    fn of(all: &[[Vec3; 3]]) -> Self {
        let size = all.iter().flatten().fold(0.0_f64, |s, p| s.max(p.amax()));
        Self { near: SAME * size, cells: BTreeMap::new(), n: 0 }
    }

    fn number(&mut self, p: Vec3) -> usize {
        let cell = |x: f64| -> i64 {
            #[expect(clippy::cast_possible_truncation, reason = "at most 1 / SAME")]
            let whole = (x / (WIDE * self.near)).floor() as i64;
            whole
        };
        let [low, high] = [-self.near, self.near].map(|by| p.add_scalar(by).map(cell));
        let mut own = None;
        for x in low.x..=high.x {
            for y in low.y..=high.y {
                for z in low.z..=high.z {
                    let held = self.cells.get(&[x, y, z]).into_iter().flatten();
                    let mut held = held.filter(|(q, _)| (q - p).amax() <= self.near);
                    own = own.or(held.next().map(|(_, n)| *n));
                }
            }
        }
        own.unwrap_or_else(|| {
            let at = p.map(cell);
            self.cells.entry([at.x, at.y, at.z]).or_default().push((p, self.n));
            self.n += 1;
            self.n - 1
        })
    }
}
