//! The cells of a sculptured surface with its straight continuation: where it may be nearest to a point, or be met
//! by a line.
//!
//! A cell is held by a parallelogram `c + s a + t b` with `s`, `t` from -1 to 1, and by balls about its second
//! derivatives, which say how far it bends out of it. Cells stand in a tree of boxes; one that bends too much to
//! be judged is cut in four, a few times.

mod beneath;
mod clear;
mod grid;
mod make;
mod part;
mod touching;

use core::array;
use std::sync::OnceLock;

use super::{Domain, Jet, Placed};
use crate::Vec3;
use crate::balls::{Ball, Below, balls};
use crate::sculpt::Sculptured;
pub use beneath::{Disk, Facing, Next};
use grid::Grid;
use part::Formed;
pub use touching::Touching;

/// Cells in a leaf of the tree.
const LEAF: usize = 4;
/// Balls that wait to be looked at: a tree of as many levels holds more cells than there are numbers.
const WAITING: usize = 128;
/// How often a cell is cut in four; then it is taken to hold one nearest place only, and to be met once.
const CUTS: u32 = 3;
/// Sine of an angle at which the way to a point is taken to stand across the surface: so much of a cell's size the
/// distance may be wrong.
const LEVEL: f64 = 1e-12;
/// Share of a cell within which a place is at its end, and of the slope of a distance that is one.
const AT_END: f64 = 1e-9;

/// The cells of a surface.
#[derive(Clone, Debug)]
pub(super) struct Cells {
    cells: Vec<Cell>,
    tree: Vec<Ball>,
    grid: Grid,
    /// How each cell turns and bends, once that is asked for.
    formed: OnceLock<Vec<Formed>>,
}

/// A rectangle of the parameters.
#[derive(Clone, Copy, Debug)]
struct Cell {
    /// Column and row of its patch.
    patch: [usize; 2],
    mid: [f64; 2],
    half: [f64; 2],
    /// The point in the middle.
    c: Vec3,
    /// Derivatives there times the half widths.
    side: [Vec3; 2],
    /// For uu, uv and vv centre and radius of a ball that holds the derivative everywhere, times the half widths.
    bend: [(Vec3, f64); 3],
    /// No such derivative is greater.
    most: [f64; 3],
    /// No point is farther from the middle.
    reach: f64,
    /// At which ends of the parameters does the surface go on without an edge?
    smooth: Smooth,
}

/// What of a cell is the same wherever it is seen from.
#[derive(Clone, Copy, Debug)]
struct Sizes {
    /// Lengths of both derivatives, their product, and by how much they change.
    long: [f64; 2],
    lean: f64,
    turns: [f64; 2],
    /// Lengths of the second ones in their middle.
    bend: [f64; 3],
}

/// For each parameter: at its low and at its high end.
type Smooth = [[bool; 2]; 2];

/// What is known of the nearest place so far.
struct Search {
    p: Vec3,
    least: f64,
    place: Placed,
    /// By less than this a place is not nearer: rounding would take it for one at the border of a cell.
    noise: f64,
}

impl Cells {
    /// Of a surface over 0 to 1 and beyond as the domain says; `None` where a point is not finite.
    pub(super) fn new(surface: &Sculptured, domain: &Domain) -> Option<Self> {
        let mut cells = make::cells(surface, domain);
        if cells.iter().any(|c| !c.c.iter().all(|x| x.is_finite())) {
            return None;
        }
        let tree = balls(&mut cells, LEAF, |c| (c.c, c.reach, c.extent()));
        let grid = Grid::new(&cells);
        Some(Self { cells, tree, grid, formed: OnceLock::new() })
    }

    /// Parameters of the place nearest to `p`; `descend` comes from parameters to those of the dip they lie in, within
    /// a rectangle, with the square of the distance. Distances that differ by less than `noise` are equal.
    ///
    /// Every cell is put aside by a bound of its distance, or because the distance has one dip in it, which is
    /// found; what is left after some cuts is searched from one place. So also across edges, where patches that
    /// adjoin have not the same tangents.
    pub(super) fn nearest(
        &self,
        (p, noise): (Vec3, f64),
        domain: &Domain,
        jet: impl Fn([usize; 2], f64, f64) -> Jet,
        descend: impl Fn(Option<[usize; 2]>, [f64; 2], &Domain) -> (f64, Placed),
    ) -> Option<Placed> {
        let (square, place) = descend(None, self.guess(p)?, domain);
        let mut search = Search { p, least: square.sqrt(), place, noise };
        self.each(p, square.sqrt(), |cell| {
            search.look(cell, CUTS, &jet, &descend);
            search.least
        });
        // A dip a little beyond the border of its cell is not nearer by more than the noise, and yet elsewhere.
        let Placed { u, v, .. } = search.place;
        Some(descend(None, [u, v], domain).1)
    }

    /// Distance of the nearest dip from `p` of those that `dip` gives one for; `dip` goes downhill freely from
    /// parameters. At most `limit`.
    pub(super) fn rival(
        &self,
        p: Vec3,
        limit: f64,
        jet: impl Fn([usize; 2], f64, f64) -> Jet,
        descend: impl Fn(Option<[usize; 2]>, [f64; 2], &Domain) -> (f64, Placed),
        dip: impl Fn(f64, f64) -> Option<f64>,
    ) -> f64 {
        let mut least = limit;
        self.each(p, limit, |cell| {
            let mut parts = vec![(*cell, CUTS)];
            while let Some((cell, left)) = parts.pop() {
                let st = cell.toward(p);
                if cell.bound(p, st) >= least || cell.falls_beyond(p) {
                    continue;
                }
                if left > 0 && !cell.has_one_dip(p) {
                    parts.extend(cell.parts(&jet).map(|c| (c, left - 1)));
                    continue;
                }
                let (square, place) =
                    descend(Some(cell.patch), cell.parameters(st), &cell.domain());
                if square < least * least
                    && !cell.leads_beyond(p, &place)
                    && let Some(square) = dip(place.u, place.v)
                {
                    least = least.min(square.sqrt());
                }
            }
            least
        });
        least
    }

    /// The cells that may come nearer to `p` than `least`, which `look` lowers.
    fn each(&self, p: Vec3, mut least: f64, mut look: impl FnMut(&Cell) -> f64) {
        let mut waiting = [0_usize; WAITING];
        let mut n = usize::from(!self.tree.is_empty());
        while n > 0 {
            n -= 1;
            let ball = &self.tree[waiting[n]];
            if ball.apart(p) >= least * least {
                continue;
            }
            match ball.below {
                Below::Balls(pair) => {
                    // The nearer one is looked at first.
                    let first = self.tree[pair[0]].nearer(&self.tree[pair[1]], p);
                    let pair = if first { [pair[1], pair[0]] } else { pair };
                    for i in pair {
                        if n < WAITING {
                            waiting[n] = i;
                            n += 1;
                        }
                    }
                }
                Below::Things(from, to) => {
                    for cell in &self.cells[from..to] {
                        least = look(cell);
                    }
                }
            }
        }
    }

    /// The cells that may come nearer to a body than the first of the limits, which `take` may change: `far` tells the signed distance of
    /// a point from it.
    fn beside(
        &self,
        far: impl Fn(Vec3) -> f64,
        mut limits: [f64; 2],
        mut take: impl FnMut(&Cell, &mut [f64; 2]),
    ) {
        let mut waiting = [0_usize; WAITING];
        let mut n = usize::from(!self.tree.is_empty());
        while n > 0 {
            n -= 1;
            let ball = &self.tree[waiting[n]];
            if far(ball.center) - ball.radius > limits[0].max(0.0) {
                continue;
            }
            match ball.below {
                Below::Balls(pair) => {
                    let [a, b] = pair.map(|i| far(self.tree[i].center));
                    // The nearer one is looked at first.
                    for i in if a < b { [pair[1], pair[0]] } else { pair } {
                        if n < WAITING {
                            waiting[n] = i;
                            n += 1;
                        }
                    }
                }
                Below::Things(from, to) => {
                    self.cells[from..to].iter().for_each(|cell| take(cell, &mut limits));
                }
            }
        }
    }

    /// Parameters near which the line through `p` along the unit vector `d` may meet the surface go to `put`.
    pub(super) fn met(
        &self,
        p: Vec3,
        d: Vec3,
        jet: impl Fn([usize; 2], f64, f64) -> Jet,
        put: &mut impl FnMut(f64, f64),
    ) {
        let mut balls = if self.tree.is_empty() { Vec::new() } else { vec![0] };
        while let Some(ball) = balls.pop().map(|i: usize| &self.tree[i]) {
            if (ball.center - p).cross(&d).norm() > ball.radius {
                continue;
            }
            match ball.below {
                Below::Balls(pair) => balls.extend(pair),
                Below::Things(from, to) => {
                    let mut cells: Vec<(Cell, u32)> =
                        self.cells[from..to].iter().map(|c| (*c, CUTS)).collect();
                    while let Some((cell, left)) = cells.pop() {
                        if !cell.may_meet(p, d) {
                            continue;
                        }
                        if left == 0 || cell.met_once(d) {
                            put(cell.mid[0], cell.mid[1]);
                        } else {
                            cells.extend(cell.parts(&jet).map(|c| (c, left - 1)));
                        }
                    }
                }
            }
        }
    }

    /// Parameters near which the nearest place may be.
    fn guess(&self, p: Vec3) -> Option<[f64; 2]> {
        let mut ball = self.tree.first()?;
        loop {
            match ball.below {
                Below::Balls(pair) => {
                    let [a, b] = pair.map(|i| &self.tree[i]);
                    ball = if b.nearer(a, p) { b } else { a };
                }
                Below::Things(from, to) => {
                    let all = self.cells[from..to].iter().map(|c| (c, c.toward(p)));
                    let near = |(c, st): &(&Cell, [f64; 2])| (c.at(*st) - p).norm_squared();
                    let best = all.min_by(|a, b| near(a).total_cmp(&near(b)));
                    return best.map(|(c, st)| c.parameters(st));
                }
            }
        }
    }
}

impl Search {
    /// Looks for a nearer place in a cell.
    fn look(
        &mut self,
        cell: &Cell,
        left: u32,
        jet: &impl Fn([usize; 2], f64, f64) -> Jet,
        descend: &impl Fn(Option<[usize; 2]>, [f64; 2], &Domain) -> (f64, Placed),
    ) {
        let mut st = cell.toward(self.p);
        if cell.bound(self.p, st) >= self.least || cell.falls_beyond(self.p) {
            return;
        }
        if !cell.has_one_dip(self.p) {
            if left > 0 {
                for part in cell.parts(jet) {
                    self.look(&part, left - 1, jet, descend);
                }
                return;
            }
        } else {
            // The square of the distance lies above its tangent plane at any place, so at the nearest one known.
            st = cell.holds([self.place.u, self.place.v]).unwrap_or(st);
            let [u, v] = cell.parameters(st);
            let here = jet(cell.patch, u, v);
            let w = here.s - self.p;
            let slope = [w.dot(&here.su) * cell.half[0], w.dot(&here.sv) * cell.half[1]];
            let fall: f64 = [0, 1].map(|k| slope[k].abs() + slope[k] * st[k]).iter().sum();
            let size = cell.side[0].norm() + cell.side[1].norm();
            let over = w.norm_squared() - self.least * self.least;
            if 2.0 * fall <= over + LEVEL * size * w.norm() {
                return;
            }
        }
        let uv = cell.parameters(st);
        let (square, place) = descend(Some(cell.patch), uv, &cell.domain());
        let distance = square.sqrt();
        if distance < self.least - self.noise {
            (self.least, self.place) = (distance, place);
        }
    }
}

impl Cell {
    fn new(
        patch: [usize; 2],
        [mid, half]: [[f64; 2]; 2],
        bend: [(Vec3, f64); 3],
        smooth: Smooth,
        jet: &Jet,
    ) -> Self {
        let side = [jet.su * half[0], jet.sv * half[1]];
        let most = bend.map(|(m, r)| m.norm() + r);
        let stray = 0.5 * (most[0] + most[2]) + most[1];
        let reach = side[0].norm() + side[1].norm() + stray;
        Self { patch, mid, half, c: jet.s, side, bend, most, reach, smooth }
    }

    /// How far along each axis a point may be from the middle.
    fn extent(&self) -> Vec3 {
        let [uu, uv, vv] = self.bend.map(|(m, r)| m.abs().add_scalar(r));
        self.side[0].abs() + self.side[1].abs() + (uu + vv) * 0.5 + uv
    }

    /// The place of the parallelogram, from -1 to 1, nearest to `p` or nearly so.
    fn toward(&self, p: Vec3) -> [f64; 2] {
        let [a, b] = &self.side;
        let w = p - self.c;
        let (e, f, g) = (a.norm_squared(), a.dot(b), b.norm_squared());
        let (x, y) = (w.dot(a), w.dot(b));
        let det = e * g - f * f;
        let kept = |x: f64| if x.is_nan() { 0.0 } else { x.clamp(-1.0, 1.0) };
        let t = kept((e * y - f * x) / det);
        let s = kept((x - t * f) / e);
        [s, kept((y - s * f) / g)]
    }

    /// The point of the parallelogram.
    fn at(&self, [s, t]: [f64; 2]) -> Vec3 {
        self.c + self.side[0] * s + self.side[1] * t
    }

    fn parameters(&self, st: [f64; 2]) -> [f64; 2] {
        [0, 1].map(|k| self.mid[k] + self.half[k] * st[k])
    }

    /// No point is nearer to `p`, which the place `st` of the parallelogram is near to.
    fn bound(&self, p: Vec3, st: [f64; 2]) -> f64 {
        let away = p - self.at(st);
        let Some(n) = away.try_normalize(0.0) else { return 0.0 };
        let over = |k: usize| n.dot(&self.bend[k].0) + self.bend[k].1;
        let twist = n.dot(&self.bend[1].0).abs() + self.bend[1].1;
        let stray = 0.5 * (over(0).max(0.0) + over(2).max(0.0)) + twist;
        let [a, b] = &self.side;
        n.dot(&(p - self.c)) - n.dot(a).abs() - n.dot(b).abs() - stray
    }

    fn domain(&self) -> Domain {
        let ends = |k: usize| [self.mid[k] - self.half[k], self.mid[k] + self.half[k]];
        Domain { u: ends(0), v: ends(1) }
    }

    /// Where the parameters lie in it, if they do.
    fn holds(&self, uv: [f64; 2]) -> Option<[f64; 2]> {
        let st = [0, 1].map(|k| (uv[k] - self.mid[k]) / self.half[k]);
        st.iter().all(|s| s.abs() <= 1.0 + 1e-9).then(|| st.map(|s| s.clamp(-1.0, 1.0)))
    }

    /// How much the derivatives by the two parameters differ from those in the middle at most.
    fn turns(&self) -> [f64; 2] {
        [self.most[0] + self.most[1], self.most[1] + self.most[2]]
    }

    /// Is the square of the distance from `p` convex over the cell?
    fn has_one_dip(&self, p: Vec3) -> bool {
        self.has_one_dip_from((p, 0.0))
    }

    /// The same from each point of a ball.
    fn has_one_dip_from(&self, from: (Vec3, f64)) -> bool {
        self.has_one_dip_of(&self.sizes(), from)
    }

    /// The same by sizes that are known. The second derivatives are `S_i . S_j + (S - p) . S_ij`.
    fn has_one_dip_of(&self, sizes: &Sizes, (p, radius): (Vec3, f64)) -> bool {
        let w = self.c - p;
        let (away, r) = (w.norm() + radius, self.reach);
        let part = |k: usize| {
            let ((m, round), size) = (&self.bend[k], sizes.bend[k]);
            let unsure = away * round + r * (size + round) + radius * size;
            (w.dot(m), unsure)
        };
        let ([la, lb], [ea, eb]) = (sizes.long, sizes.turns);
        let least = |l: f64, e: f64| {
            let l = (l - e).max(0.0);
            l * l
        };
        let [uu, uv, vv] = array::from_fn(part);
        let (h11, h22) = (least(la, ea) + uu.0 - uu.1, least(lb, eb) + vv.0 - vv.1);
        let h12 = (sizes.lean + uv.0).abs() + uv.1 + la * eb + lb * ea + ea * eb;
        h11 > 0.0 && h22 > 0.0 && h11 * h22 > h12 * h12
    }

    /// How long its derivatives are, and by how much they change.
    fn sizes(&self) -> Sizes {
        let [a, b] = &self.side;
        let bend = [0, 1, 2].map(|k: usize| self.bend[k].0.norm());
        Sizes { long: [a.norm(), b.norm()], lean: a.dot(b), turns: self.turns(), bend }
    }

    /// Does the distance from `p` fall all over the cell towards an end at which the surface goes on without an edge? Then no dip
    /// is in it. The slope of half its square differs from that in the middle by no more than its second derivatives.
    fn falls_beyond(&self, p: Vec3) -> bool {
        let w = self.c - p;
        let far = w.norm() + self.reach;
        let turns = self.turns();
        let long = [0, 1].map(|k| self.side[k].norm() + turns[k]);
        (0..2).any(|k| {
            let slope = w.dot(&self.side[k]);
            let change = long[k] * (long[0] + long[1]) + far * turns[k];
            slope.abs() > change && self.smooth[k][usize::from(slope < 0.0)]
        })
    }

    /// Lies the nearest place of the cell at such an end, beyond which the distance from `p` goes on falling?
    fn leads_beyond(&self, p: Vec3, place: &Placed) -> bool {
        let Some(st) = self.holds([place.u, place.v]) else { return false };
        let (w, jet) = (place.jet.s - p, &place.jet);
        (0..2).any(|k| {
            let along = if k == 0 { jet.su } else { jet.sv };
            let slope = w.dot(&along);
            let end = usize::from(slope < 0.0);
            let there = st[k] * (2.0 * end as f64 - 1.0) >= 1.0 - AT_END;
            there && self.smooth[k][end] && slope.abs() > AT_END * w.norm() * along.norm()
        })
    }

    /// May the line through `p` along `d` meet it?
    fn may_meet(&self, p: Vec3, d: Vec3) -> bool {
        let [a, b] = &self.side;
        let stray = 0.5 * (self.most[0] + self.most[2]) + self.most[1];
        let w = self.c - p;
        let beside = |x: &Vec3, y: &Vec3| {
            let n = d.cross(x);
            n.dot(&w).abs() <= n.dot(y).abs() + n.norm() * stray * (1.0 + 1e-9)
        };
        beside(a, b) && beside(b, a) && w.cross(&d).norm() <= self.reach * (1.0 + 1e-9)
    }

    /// Does the surface keep one side towards `d` all over the cell?
    fn met_once(&self, d: Vec3) -> bool {
        let [a, b] = &self.side;
        let [ea, eb] = self.turns();
        a.cross(b).dot(&d).abs() > a.norm() * eb + b.norm() * ea + ea * eb
    }

    /// Its quarters.
    fn parts(&self, jet: impl Fn([usize; 2], f64, f64) -> Jet) -> [Self; 4] {
        let half = self.half.map(|h| 0.5 * h);
        let bend = self.bend.map(|(m, r)| (m * 0.25, r * 0.25));
        [[-1.0, -1.0], [1.0, -1.0], [-1.0, 1.0], [1.0, 1.0]].map(|sign| {
            let mid = [0, 1].map(|k| self.mid[k] + sign[k] * half[k]);
            let smooth = [0, 1].map(|k| match sign[k] < 0.0 {
                true => [self.smooth[k][0], true],
                false => [true, self.smooth[k][1]],
            });
            Self::new(self.patch, [mid, half], bend, smooth, &jet(self.patch, mid[0], mid[1]))
        })
    }
}

#[cfg(test)]
mod tests {
    use super::super::sculptured::Spans;
    use super::*;
    use crate::sculpt::{Patch, Vec4};
    use proptest::prelude::*;

    /// Patches over 3 by 2 cells of 10 with random heights and weights, joined or loose.
    fn surface(z: &[f64], bend: f64, weights: bool) -> Sculptured {
        let patch = |i0: usize, j0: usize| {
            Patch::new(array::from_fn(|j| {
                array::from_fn(|i| {
                    let k = (3 * j0 + j) * 10 + 3 * i0 + i;
                    let h = z[k % z.len()];
                    let w = if weights { 1.0 + 0.4 * z[(7 * k + 3) % z.len()] } else { 1.0 };
                    let (x, y) = ((3 * i0 + i) as f64, (3 * j0 + j) as f64);
                    let p = Vec3::new(x / 0.3, y / 0.3 + bend * x, 4.0 * h + bend * x * x);
                    Vec4::new(p.x * w, p.y * w, p.z * w, w)
                })
            }))
        };
        let patches = (0..6).map(|k| patch(k % 3, k / 3)).collect();
        Sculptured::grid(patches, 3, 2).unwrap()
    }

    /// The nearest place by a grid of samples, the lowest of them searched ever finer.
    fn brute(jet: impl Fn(f64, f64) -> Jet, domain: &Domain, p: Vec3) -> f64 {
        let n = 140;
        let axis = |ends: [f64; 2]| {
            let inner = (0..=n).map(|k| f64::from(k) / f64::from(n));
            let mut all: Vec<f64> = inner.collect();
            for k in 1..=12 {
                let s = f64::from(k) / 12.0;
                all.push(ends[0] * s * s);
                all.push(1.0 + (ends[1] - 1.0) * s * s);
            }
            all
        };
        let mut all = Vec::new();
        for u in axis(domain.u) {
            for v in axis(domain.v) {
                all.push(((jet(u, v).s - p).norm(), u, v));
            }
        }
        all.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut least = f64::INFINITY;
        for &(d, u, v) in all.iter().take(12) {
            let (mut d, mut u, mut v, mut h) = (d, u, v, 0.02);
            while h > 1e-9 {
                let mut moved = false;
                for k in 0..8 {
                    let angle = core::f64::consts::FRAC_PI_4 * f64::from(k);
                    let (s, c) = crate::trig::sin_cos(angle);
                    let (a, b) = (domain.clamp_u(u + h * c), domain.clamp_v(v + h * s));
                    let e = (jet(a, b).s - p).norm();
                    if e < d {
                        (d, u, v, moved) = (e, a, b, true);
                    }
                }
                if !moved {
                    h *= 0.5;
                }
            }
            least = least.min(d);
        }
        least
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(40))]
        #[test]
        fn no_sample_is_nearer(
            z in prop::collection::vec(-1.0_f64..1.0, 70), bend in -0.3_f64..0.3, weights: bool,
            p in prop::array::uniform3(-1.0_f64..1.0),
        ) {
            let spans = Spans::of_surface(surface(&z, bend, weights)).unwrap();
            let p = Vec3::new(15.0 + 25.0 * p[0], 10.0 + 20.0 * p[1], 15.0 * p[2]);
            let jet = |u, v| spans.jet(u, v);
            let truth = brute(jet, &spans.domain(), p);
            let whole = super::super::ParametricSurface::of_spans(spans);
            let found = (whole.nearest(p).unwrap().jet.s - p).norm();
            prop_assert!(found <= truth + 1e-7, "{found} {truth}");
        }

        #[test]
        fn a_cell_holds_its_surface(
            z in prop::collection::vec(-1.0_f64..1.0, 70), bend in -0.3_f64..0.3, weights: bool,
        ) {
            let spans = Spans::of_surface(surface(&z, bend, weights)).unwrap();
            let p = Vec3::new(12.0, 9.0, 5.0);
            let jet = |u, v| spans.jet(u, v);
            for cell in &spans.cells().cells {
                let bound = cell.bound(p, cell.toward(p));
                for s in [-1.0, -0.4, 0.3, 1.0] {
                    for t in [-1.0, -0.2, 0.7, 1.0] {
                        let [u, v] = cell.parameters([s, t]);
                        let here = jet(u, v).s;
                        prop_assert!((here - cell.c).norm() <= cell.reach * (1.0 + 1e-9));
                        prop_assert!((here - p).norm() >= bound - 1e-9);
                    }
                }
            }
        }
    }
}
