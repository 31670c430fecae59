//! A body of triangles that closes: what lies inside of it.

use std::collections::BTreeMap;

use crate::Vec3;

/// Corners within this share of the size of all are one: files have six digits or more.
const SAME: f64 = 1e-6;
/// Cells in which corners are looked for are so many times as wide.
const WIDE: f64 = 64.0;
/// Directions of rays, tried until one passes no edge. None is along anything that is likely to be built.
const RAYS: [[f64; 3]; 6] = [
    [0.531, 0.297, 0.793],
    [-0.413, 0.787, 0.459],
    [0.719, -0.601, 0.347],
    [0.227, 0.373, -0.899],
    [-0.859, -0.197, 0.471],
    [-0.337, -0.613, -0.714],
];

/// Triangles without an open edge.
#[derive(Clone, Debug, PartialEq)]
pub struct Shell {
    /// Those that are one but for digits have the same corners.
    triangles: Vec<[Vec3; 3]>,
    /// Does each edge run as often one way as the other, so that the way in which triangles are turned counts?
    turned: bool,
    bounds: [Vec3; 2],
}

/// Edges by the numbers of their corners, that of the lower first: how often they run up and down, and where.
pub type Edges = BTreeMap<[usize; 2], ([u32; 2], [Vec3; 2])>;

/// The edges of triangles; those whose corners are one are none.
pub fn edges(all: &[[Vec3; 3]]) -> Edges {
    let mut corners = Corners::of(all);
    let numbered: Vec<_> = all.iter().map(|t| t.map(|p| corners.number(p))).collect();
    edges_of(all, &numbered)
}

fn edges_of(all: &[[Vec3; 3]], numbered: &[[usize; 3]]) -> Edges {
    let mut edges = Edges::new();
    for (t, ids) in all.iter().zip(numbered) {
        for k in 0..3 {
            let j = (k + 1) % 3;
            let (a, b) = (ids[k], ids[j]);
            if a != b {
                let entry = edges.entry([a.min(b), a.max(b)]);
                entry.or_insert(([0; 2], [t[k], t[j]])).0[usize::from(a > b)] += 1;
            }
        }
    }
    edges
}

impl Shell {
    /// `None` of triangles that leave an edge open, or meet in such a number at one that they bound nothing.
    pub fn closed(all: &[[Vec3; 3]]) -> Option<Self> {
        let mut corners = Corners::of(all);
        let numbered: Vec<_> = all.iter().map(|t| t.map(|p| corners.number(p))).collect();
        let edges = edges_of(all, &numbered);
        let turned = edges.values().all(|([up, down], _)| up == down);
        if edges.is_empty() || edges.values().any(|([up, down], _)| (up + down) % 2 == 1) {
            return None;
        }
        // A ray could meet one without area at its edges alone.
        let wide = |[a, b, c]: &&[usize; 3]| a != b && b != c && c != a;
        let triangles = numbered.iter().filter(wide).map(|ids| ids.map(|i| corners.places[i]));
        let triangles = triangles.collect();
        let first = corners.places[0];
        let bounds = corners.places.iter().fold([first; 2], |[a, b], p| [a.inf(p), b.sup(p)]);
        Some(Self { triangles, turned, bounds })
    }

    /// How far `p` is from the nearest triangle, if it is inside; `None` of a point that is outside.
    ///
    /// Inside is what a ray leaves through more triangles from within than from without, or the other way round; of triangles
    /// that are turned anyhow, what it leaves through an odd number. Both hold for every ray that meets no edge: next
    /// triangles are held to the same numbers of their common edge, so that it passes through one of them. A point of which
    /// none of some rays tells counts as outside.
    pub fn holds(&self, p: Vec3) -> Option<f64> {
        let [low, high] = self.bounds;
        if (0..3).any(|i| p[i] < low[i] || p[i] > high[i]) {
            return None;
        }
        let [n, sum] = RAYS.iter().find_map(|d| self.crossed(p, Vec3::from(*d)))?;
        let inside = if self.turned { sum != 0 } else { n % 2 == 1 };
        inside.then(|| self.triangles.iter().map(|t| apart(p, t)).fold(f64::INFINITY, f64::min))
    }

    /// How many triangles the ray passes, and how many more from within than from without; `None` where it meets an edge.
    fn crossed(&self, from: Vec3, along: Vec3) -> Option<[i64; 2]> {
        let mut out = [0, 0];
        for t in &self.triangles {
            let [a, b, c] = t.map(|p| p - from);
            let across = [b.cross(&c), c.cross(&a), a.cross(&b)];
            let s = across.map(|x| along.dot(&x));
            if s.iter().any(|x| *x < 0.0) && s.iter().any(|x| *x > 0.0) {
                continue;
            }
            if s.contains(&0.0) {
                return None;
            }
            let slope = s[0] + s[1] + s[2];
            if a.dot(&across[0]) / slope > 0.0 {
                out = [out[0] + 1, out[1] + if slope > 0.0 { 1 } else { -1 }];
            }
        }
        Some(out)
    }
}

/// The distance of a point from a triangle.
fn apart(p: Vec3, [a, b, c]: &[Vec3; 3]) -> f64 {
    let normal = (b - a).cross(&(c - a));
    let sides = [(a, b), (b, c), (c, a)];
    let within =
        |(from, to): &(&Vec3, &Vec3)| normal.cross(&(*to - *from)).dot(&(p - *from)) >= 0.0;
    if sides.iter().all(within)
        && let Some(n) = normal.try_normalize(0.0)
    {
        return n.dot(&(p - a)).abs();
    }
    let to_side = |(from, to): (&Vec3, &Vec3)| {
        let way = to - from;
        let t = (p - from).dot(&way) / way.norm_squared().max(f64::MIN_POSITIVE);
        (from + way * t.clamp(0.0, 1.0) - p).norm()
    };
    sides.into_iter().map(to_side).fold(f64::INFINITY, f64::min)
}

/// Corners by number, those that are one but for digits by the same.
struct Corners {
    near: f64,
    cells: BTreeMap<[i64; 3], Vec<usize>>,
    places: Vec<Vec3>,
}

impl Corners {
    fn of(all: &[[Vec3; 3]]) -> Self {
        let size = all.iter().flatten().fold(0.0_f64, |s, p| s.max(p.amax()));
        Self { near: SAME * size, cells: BTreeMap::new(), places: Vec::new() }
    }

    fn number(&mut self, p: Vec3) -> usize {
        let cell = |x: f64| -> i64 {
            #[expect(clippy::cast_possible_truncation, reason = "at most 1 / SAME")]
            let whole = (x / (WIDE * self.near)).floor() as i64;
            whole
        };
        let [low, high] = [-self.near, self.near].map(|by| p.add_scalar(by).map(cell));
        for x in low.x..=high.x {
            for y in low.y..=high.y {
                for z in low.z..=high.z {
                    let mut held = self.cells.get(&[x, y, z]).into_iter().flatten();
                    let same = |i: &&usize| (self.places[**i] - p).amax() <= self.near;
                    if let Some(i) = held.find(same) {
                        return *i;
                    }
                }
            }
        }
        let at = p.map(cell);
        self.cells.entry([at.x, at.y, at.z]).or_default().push(self.places.len());
        self.places.push(p);
        self.places.len() - 1
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::trig;

    /// A box about `center` with its faces out, or in.
    fn cuboid(center: Vec3, half: Vec3, out: bool) -> Vec<[Vec3; 3]> {
        let at = |i: usize| {
            let sign = |bit: usize| if i & bit == 0 { -1.0 } else { 1.0 };
            center + Vec3::new(sign(1), sign(2), sign(4)).component_mul(&half)
        };
        let faces =
            [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
        let two = faces.iter().flat_map(|f| [[f[0], f[1], f[2]], [f[0], f[2], f[3]]]);
        let turn = |[a, b, c]: [usize; 3]| if out { [a, b, c] } else { [c, b, a] };
        two.map(|t| turn(t).map(at)).collect()
    }

    /// A ball of strips between circles of latitude.
    fn ball(center: Vec3, radius: f64, n: u32) -> Vec<[Vec3; 3]> {
        let at = |i: u32, j: u32| {
            let pi = std::f64::consts::PI;
            let (s, c) = trig::sin_cos(pi * f64::from(i) / f64::from(n));
            let (sin, cos) = trig::sin_cos(2.0 * pi * f64::from(j % (2 * n)) / f64::from(2 * n));
            center + Vec3::new(s * cos, s * sin, c) * radius
        };
        let piece = |i, j| {
            [[at(i, j), at(i + 1, j), at(i + 1, j + 1)], [at(i, j), at(i + 1, j + 1), at(i, j + 1)]]
        };
        let all = (0..n).flat_map(|i| (0..2 * n).flat_map(move |j| piece(i, j)));
        all.filter(|[a, b, c]| a != b && b != c && c != a).collect()
    }

    #[test]
    fn a_box_holds_what_is_in_it() {
        for shift in [Vec3::zeros(), Vec3::new(300.0, -200.0, 70.0)] {
            for out in [true, false] {
                let shell = Shell::closed(&cuboid(shift, Vec3::new(3.0, 2.0, 1.0), out)).unwrap();
                // The middle, and places from which rays along the axes or diagonals would meet edges.
                for (x, depth) in [([0.0; 3], 1.0), ([2.5, 0.0, 0.0], 0.5), ([1.0, 1.0, -0.8], 0.2)]
                {
                    let found = shell.holds(shift + Vec3::from(x)).unwrap();
                    assert!((found - depth).abs() < 1e-9, "{found} {depth}");
                }
                for x in [[3.1, 0.0, 0.0], [0.0, 0.0, -1.5], [2.9, 2.1, 0.9], [90.0, 0.0, 0.0]] {
                    assert_eq!(shell.holds(shift + Vec3::from(x)), None);
                }
            }
        }
    }

    #[test]
    fn a_ball_holds_what_is_nearer_to_its_middle() {
        let center = Vec3::new(10.0, 20.0, -5.0);
        let shell = Shell::closed(&ball(center, 4.0, 24)).unwrap();
        for k in 0..400 {
            let (s, c) = trig::sin_cos(2.4 * f64::from(k));
            let z = -1.0 + f64::from(k) / 200.0;
            let r = 8.0 * f64::from(k % 17) / 16.0;
            let p =
                center + Vec3::new(c, s, 0.0) * (r * (1.0 - z * z).sqrt()) + Vec3::z() * (r * z);
            // Facets lie within half a percent of the ball.
            if (r - 4.0).abs() > 0.05 {
                let found = shell.holds(p);
                assert_eq!(found.is_some(), r < 4.0, "{p:?}");
                assert!(found.is_none_or(|d| (d - (4.0 - r)).abs() < 0.05), "{found:?} {r}");
            }
        }
    }

    #[test]
    fn a_speck_does_not_open_a_body() {
        let mut all = cuboid(Vec3::zeros(), Vec3::new(3.0, 2.0, 1.0), true);
        let p = all[0][0];
        all.push([p, p + Vec3::x() * 1e-7, p + Vec3::y() * 1e-7]);
        all.push([p, p + Vec3::x() * 1e-7, all[0][1]]);
        let shell = Shell::closed(&all).unwrap();
        assert!(shell.holds(Vec3::new(0.1, 0.2, 0.3)).is_some());
        assert_eq!(shell.holds(Vec3::new(0.1, 2.2, 0.3)), None);
    }

    #[test]
    fn what_is_open_holds_nothing() {
        let mut all = cuboid(Vec3::zeros(), Vec3::repeat(1.0), true);
        all.pop();
        assert_eq!(Shell::closed(&all), None);
        assert_eq!(edges(&all).values().filter(|e| e.0[0] + e.0[1] == 1).count(), 3);
        assert_eq!(Shell::closed(&[]), None);
    }

    #[test]
    fn hollows_are_outside_and_what_two_bodies_share_is_inside() {
        let outer = cuboid(Vec3::zeros(), Vec3::repeat(3.0), true);
        let inner = |out| cuboid(Vec3::zeros(), Vec3::repeat(1.0), out);
        let hollow = Shell::closed(&[outer.clone(), inner(false)].concat()).unwrap();
        assert_eq!(hollow.holds(Vec3::new(0.1, 0.2, 0.3)), None);
        assert!(hollow.holds(Vec3::new(2.0, 0.1, 0.2)).is_some());
        let two = Shell::closed(&[outer.clone(), inner(true)].concat()).unwrap();
        assert!(two.holds(Vec3::new(0.1, 0.2, 0.3)).is_some());
        // Turned anyhow, the number alone tells.
        let mut anyhow = outer;
        anyhow[0].swap(0, 1);
        let shell = Shell::closed(&anyhow).unwrap();
        assert!(shell.holds(Vec3::new(0.1, 0.2, 0.3)).is_some());
        assert_eq!(shell.holds(Vec3::new(0.1, 3.2, 0.3)), None);
    }
}
