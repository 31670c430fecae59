//! Surfaces by two parameters: RLDSRF, POLCON and SSURF. A grid of cells, each with constant bounds of its
//! derivatives, in a tree of spheres; beyond the borders they go on straight.

mod edged;
mod smooth;

use std::sync::OnceLock;

use aptc_geometry::Vec3;
use aptc_geometry::sculpt::Derivatives;

use super::bend::Bend;
use super::bow::Frame;
use super::polyconic::Sections;
use super::powers::Powers;
use super::ruled::Rulings;
use super::sculpted::{Own, Sculpted};
use super::{Jet, Kept, Patch, Spot, Tile, fall};
use crate::each::{three, two};
pub(crate) use edged::{Edged, Hollow, bare};
pub(crate) use smooth::SMOOTH;

/// A cell that is so much narrower at a corner than long, or whose sides there are so nearly parallel, counts as without normal there.
const NARROW: f64 = 1e-2;

/// Evaluation of the cells of a grid.
pub(crate) trait Cells {
    /// Point and derivatives at a place of the cell in column `i` and row `j`.
    fn at(&self, i: usize, j: usize, u: f64, v: f64) -> Derivatives;
    /// Bounds of the derivatives over the cell.
    fn bend(&self, i: usize, j: usize) -> Bend;
}

/// Where a parameter runs.
#[derive(Clone, Debug)]
pub(crate) struct Side {
    /// Borders of the cells, rising.
    pub(crate) knots: Vec<f64>,
    /// Where the straight continuation ends before the first and behind the last.
    pub(crate) before: Option<f64>,
    pub(crate) behind: Option<f64>,
    /// Of loose patches, how many cells one has: of those of two nothing tells that they touch.
    pub(crate) loose: Option<usize>,
}

/// Both parameters.
#[derive(Clone, Debug)]
pub(crate) struct Grid {
    pub(crate) sides: [Side; 2],
}

/// What is in the cells.
#[derive(Clone, Debug)]
pub(crate) enum Kind {
    Sculpted(Sculpted),
    Ruled(Box<Rulings>),
    Polyconic(Box<Sections>),
}

/// A surface of cells. The positive side is that of the cross product of the derivatives.
#[derive(Clone, Debug)]
pub(crate) struct Patched {
    kind: Kind,
    grid: Grid,
    /// Columns first.
    charts: Vec<Chart>,
    /// What holds each of them.
    tiles: Vec<Tile>,
    nodes: Vec<Node>,
    /// For each chart and parameter: does the surface go on smoothly at its low end?
    smooth: Vec<OnceLock<[bool; 2]>>,
    /// Its edges, once they are asked for.
    edged: OnceLock<Edged>,
}

/// A cell, or the continuation of one.
#[derive(Clone, Debug)]
struct Chart {
    range: [[f64; 2]; 2],
    /// The cell that is evaluated, and its borders.
    cell: [usize; 2],
    within: [[f64; 2]; 2],
    /// Bounds of the second derivatives on the border of the cell or within it.
    second: [f64; 3],
    /// Bounds of the third: of uu by u and v, of uv, of vv.
    third: [[f64; 2]; 3],
    /// By how much `uu` and `vv` may change for each unit beyond the cell.
    beyond: [f64; 2],
    /// For each parameter: is the border of the cell at its low and at its high end one point?
    points: [[bool; 2]; 2],
    /// Has a corner of the cell no normal, or next to none?
    bare: bool,
    /// Would it go on from a border that is one point, or does it close a hole? There is nothing there.
    none: bool,
    /// Of a sculptured surface the patch of the cell.
    own: Own,
    /// The same by powers, where its derivatives nowhere vanish.
    powers: Option<Box<Powers>>,
}

impl Chart {
    /// How much the second derivatives of a piece may differ from those on the border of the cell at most.
    fn more(&self, patch: &Patch) -> [f64; 3] {
        let [u, v] = two([0, 1], |k| {
            let [from, to] = [patch.at[k] - patch.half[k], patch.at[k] + patch.half[k]];
            (self.within[k][0] - from).max(to - self.within[k][1]).max(0.0)
        });
        [self.beyond[0] * v, 0.0, self.beyond[1] * u]
    }

    /// Point and derivatives, straight on beyond the cell, from those in the cell.
    #[inline(always)]
    fn beyond_cell(&self, at: [f64; 2], cell: impl Fn([f64; 2]) -> Derivatives) -> Derivatives {
        let inside = two([0, 1], |k| at[k].clamp(self.within[k][0], self.within[k][1]));
        let mut d = cell(inside);
        let (a, b) = (at[0] - inside[0], at[1] - inside[1]);
        if a != 0.0 || b != 0.0 {
            d.point += d.u * a + d.v * b + d.uv * (a * b);
            (d.u, d.v) = (d.u + d.uv * b, d.v + d.uv * a);
            // Straight there; along the border it bends as the border does, and by what [`Chart::more`] has beside.
            let none = Vec3::zeros();
            (d.uu, d.vv) = (if a != 0.0 { none } else { d.uu }, if b != 0.0 { none } else { d.vv });
        }
        d
    }
}

/// Charts within a sphere, and within a bowed box about its middle: over `s` and `t` from -1 to 1 along its first sides
/// it is moved by `bow[0] s^2 + bow[1] t^2` along its normal.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Node {
    pub(crate) center: Vec3,
    pub(crate) radius: f64,
    /// Half sides of the box, the last along its normal, and by how much it is made thicker all around.
    pub(super) half: [Vec3; 3],
    pub(super) bow: [f64; 2],
    pub(super) thick: f64,
    /// Unit vector about square to the charts.
    pub(super) normal: Vec3,
    below: Below,
}

impl Node {
    /// No point of the charts is farther from the middle against the unit vector.
    pub(crate) fn extent(&self, m: Vec3) -> f64 {
        let rise = 2.0 * m.dot(&self.normal);
        let [a, b, c] = &self.half;
        let bowed = fall(m.dot(a), self.bow[0] * rise) + fall(m.dot(b), self.bow[1] * rise);
        (bowed + m.dot(c).abs() + self.thick).min(self.radius)
    }
}

#[derive(Clone, Copy, Debug)]
enum Below {
    Nodes([usize; 2]),
    Chart(usize),
}

impl Side {
    /// Ranges of the charts along the parameter, each with its cell.
    fn ranges(&self) -> Vec<([f64; 2], usize)> {
        let n = self.knots.len() - 1;
        let before = self.before.map(|end| ([end, self.knots[0]], 0));
        let cells = (0..n).map(|i| ([self.knots[i], self.knots[i + 1]], i));
        let behind = self.behind.map(|end| ([self.knots[n], end], n - 1));
        before.into_iter().chain(cells).chain(behind).collect()
    }
}

impl Patched {
    pub(crate) fn new(kind: Kind, grid: Grid) -> Option<Self> {
        let [us, vs] = two([0, 1], |k| grid.sides[k].ranges());
        let (charts, tiles, nodes, smooth) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
        let mut new = Self { kind, grid, charts, tiles, nodes, smooth, edged: OnceLock::new() };
        for &(v, j) in &vs {
            for &(u, i) in &us {
                new.charts.push(new.chart([u, v], [i, j]));
            }
        }
        new.smooth = vec![OnceLock::new(); new.charts.len()];
        let mut leaves = Vec::with_capacity(new.charts.len());
        for (i, c) in new.charts.iter().enumerate().filter(|(_, c)| !c.none) {
            let leaf = new.leaf(i);
            if !(leaf.radius.is_finite()
                && leaf.center.iter().all(|x| x.is_finite())
                && c.second.iter().chain(&c.beyond).all(|x| x.is_finite()))
            {
                return None;
            }
            leaves.push(leaf);
        }
        new.grow(&mut leaves);
        Some(new)
    }

    fn chart(&self, range: [[f64; 2]; 2], cell: [usize; 2]) -> Chart {
        let within = two([0, 1], |k| {
            let knots = &self.grid.sides[k].knots;
            [knots[cell[k]], knots[cell[k] + 1]]
        });
        let b = self.bend(cell);
        // How far the chart is beyond its cell.
        let over =
            two([0, 1], |k| (within[k][0] - range[k][0]).max(range[k][1] - within[k][1]).max(0.0));
        // Beyond u the place is `b(v) + s b_u(v)`, so that `vv` is that on the border and `s` times `uvv` there at most; by v
        // it changes as that on the border does, the rest counts as a whole.
        let none = [0.0; 2];
        let (second, third, beyond) = match two(over, |o| o > 0.0) {
            [false, false] => {
                let third = [[b.uuu, b.uuv], [b.uuv, b.uvv], [b.uvv, b.vvv]];
                ([b.uu, b.uv, b.vv], third, none)
            }
            [true, false] => ([0.0, b.uv, b.vv], [none, [0.0, b.uvv], [0.0, b.vvv]], [0.0, b.uvv]),
            [false, true] => ([b.uu, b.uv, 0.0], [[b.uuu, 0.0], [b.uuv, 0.0], none], [b.uuv, 0.0]),
            [true, true] => ([0.0, b.uv, 0.0], [none; 3], none),
        };
        let mut chart = Chart {
            range,
            cell,
            within,
            second,
            third,
            beyond,
            points: [[false; 2]; 2],
            bare: false,
            none: false,
            own: match &self.kind {
                Kind::Sculpted(s) => s.own(cell),
                Kind::Ruled(_) | Kind::Polyconic(_) => Own::default(),
            },
            powers: None,
        };
        if over.iter().all(|o| *o <= 0.0) {
            chart.points = two([0, 1], |k| two([0, 1], |end| self.is_point(&chart, k, end)));
        }
        if let Kind::Sculpted(s) = &self.kind {
            let end = |k: usize| usize::from(range[k][0] >= within[k][1]);
            chart.none = s.is_nothing(cell, [0, 1].map(|k| (over[k] > 0.0).then(|| end(k))));
        }
        let [u, v] = within;
        let corners = [[u[0], v[0]], [u[1], v[0]], [u[0], v[1]], [u[1], v[1]]];
        chart.bare = corners.iter().any(|at| {
            let d = self.at(&chart, *at).rated(u[1] - u[0], v[1] - v[0]);
            let most = d.u.norm_squared().max(d.v.norm_squared());
            d.u.cross(&d.v).norm() <= NARROW * most
        });
        if let Kind::Sculpted(s) = &self.kind
            && !chart.bare
        {
            let middle = two(within, |[from, to]| 0.5 * (from + to));
            chart.powers = s.powers(&chart.own, middle).map(Box::new);
        }
        chart
    }

    /// Is the border of a cell at this end of the parameter one point, so that the derivative along it vanishes?
    fn is_point(&self, chart: &Chart, k: usize, end: usize) -> bool {
        // More than the derivative of a rational cubic has roots, and those of a quotient.
        const PLACES: u32 = 8;
        const NONE: f64 = 1e-14;
        let along = 1 - k;
        let [from, to] = chart.within[along];
        (0..=PLACES).all(|i| {
            let mut at = [chart.within[k][end]; 2];
            at[along] = from + (to - from) * f64::from(i) / f64::from(PLACES);
            let d = self.at(chart, at);
            let [a, b] = if along == 0 { [d.u, d.v] } else { [d.v, d.u] };
            a.norm() * (to - from) <= NONE * b.norm() * (chart.within[k][1] - chart.within[k][0])
        })
    }

    /// What holds a chart: its parallelogram, bowed as its middle is.
    ///
    /// By Taylor a place is `c + a s + b t + uu s^2 / 2 + uv s t + vv t^2 / 2` off by what these vary; of `uu` and `vv` the
    /// parts along the normal are the bow, all else makes it thicker.
    fn leaf(&self, chart: usize) -> Node {
        let patch = self.patch(chart);
        let (jet, bend, vary) = self.bent(&patch);
        let [hu, hv] = patch.half;
        let side = [jet.d[0] * hu, jet.d[1] * hv];
        let area = [0.5 * hu * hu, hu * hv, 0.5 * hv * hv];
        let bow = two([0, 2], |i| area[i] * bend[i].dot(&jet.n));
        let beside = two([0, 2], |i| area[i] * (bend[i] - jet.n * bend[i].dot(&jet.n)).norm());
        let rest = (0..3).map(|i| area[i] * vary[i]).sum::<f64>();
        let thick = beside[0] + beside[1] + area[1] * bend[1].norm() + rest;
        let [uu, uv, vv] = self.second(&patch);
        let strays = area[0] * uu + area[1] * uv + area[2] * vv;
        let radius = side[0].norm() + side[1].norm() + strays;
        let half = [side[0], side[1], Vec3::zeros()];
        let below = Below::Chart(chart);
        Node { center: jet.p, radius, half, bow, thick, normal: jet.n, below }
    }

    /// The whole of a chart.
    fn patch(&self, chart: usize) -> Patch {
        let range = &self.charts[chart].range;
        let at = two([0, 1], |k| 0.5 * (range[k][0] + range[k][1]));
        let half = two([0, 1], |k| 0.5 * (range[k][1] - range[k][0]));
        Patch { chart, at, half, kept: Kept::Chart, ..Patch::default() }
    }

    /// All charts.
    pub(super) fn charts(&self) -> impl Iterator<Item = Patch> {
        (0..self.charts.len()).map(|chart| self.patch(chart))
    }

    /// Keeps what holds each of the charts.
    pub(super) fn keep(&mut self, tiles: Vec<Tile>) {
        self.tiles = tiles;
    }

    /// What holds a chart.
    pub(super) fn tile(&self, chart: usize) -> &Tile {
        &self.tiles[chart]
    }

    /// A tree over the leaves, halved along the longest side of their box; its root comes last.
    fn grow(&mut self, leaves: &mut [Node]) -> usize {
        if let [one] = leaves {
            self.nodes.push(*one);
            return self.nodes.len() - 1;
        }
        let far = f64::INFINITY;
        let (lo, hi) = leaves.iter().fold((Vec3::repeat(far), Vec3::repeat(-far)), |b, n| {
            (b.0.inf(&n.center), b.1.sup(&n.center))
        });
        let axis = (hi - lo).imax();
        leaves.sort_by(|a, b| a.center[axis].total_cmp(&b.center[axis]));
        let middle = leaves.len() / 2;
        let reach = |c: Vec3, n: &[Node]| {
            n.iter().map(|n| (n.center - c).norm() + n.radius).fold(0.0, f64::max)
        };
        let mean = leaves.iter().map(|n| n.normal).sum::<Vec3>();
        let across = (leaves[leaves.len() - 1].center - leaves[0].center).cross(&mean);
        let e = [mean, across].map(|x| crate::solid::unit_or(x, Vec3::z()));
        let e = if e[0].dot(&e[1]).abs() > 1e-13 {
            let [x, y] = aptc_geometry::surface::frame_about(e[0]);
            [x, y, e[0]]
        } else {
            [e[0].cross(&e[1]), e[1], e[0]]
        };
        let sides = e.map(|e| {
            leaves.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |b, n| {
                let at = n.center.dot(&e);
                (b.0.min(at - n.extent(e)), b.1.max(at + n.extent(-e)))
            })
        });
        let middle_of = |i: usize| 0.5 * (sides[i].0 + sides[i].1);
        let center = (0..3).map(|i| e[i] * middle_of(i)).sum::<Vec3>();
        let lengths = three([0, 1, 2], |i| 0.5 * (sides[i].1 - sides[i].0));
        let frame = Frame { center, e, lengths };
        let bow = frame.bow(leaves);
        let [low, high] = frame.heights(bow, leaves);
        let bowed = high - low < 2.0 * lengths[2];
        let (bow, [low, high]) =
            if bowed { (bow, [low, high]) } else { ([0.0; 2], [-lengths[2], lengths[2]]) };
        let center = center + e[2] * (0.5 * (low + high));
        let half = [e[0] * lengths[0], e[1] * lengths[1], e[2] * (0.5 * (high - low))];
        let radius = reach(center, leaves);
        // Directions of unit length and square to each other but for rounding.
        let thick = 1e-12 * (radius + center.norm());
        let (a, b) = leaves.split_at_mut(middle);
        let below = Below::Nodes([self.grow(a), self.grow(b)]);
        self.nodes.push(Node { center, radius, half, bow, thick, normal: e[2], below });
        self.nodes.len() - 1
    }

    /// The charts over a range of the parameters.
    pub(crate) fn pieces(&self, range: &[[f64; 2]; 2]) -> Vec<Patch> {
        let mut out = Vec::new();
        for (i, chart) in self.charts.iter().enumerate().filter(|(_, c)| !c.none) {
            let mut patch = Patch { kept: Kept::Nowhere, ..self.patch(i) };
            let mut empty = false;
            for (k, [from, to]) in range.iter().enumerate() {
                let (lo, hi) = (chart.range[k][0].max(*from), chart.range[k][1].min(*to));
                empty |= lo >= hi;
                (patch.at[k], patch.half[k]) = (0.5 * (lo + hi), 0.5 * (hi - lo));
            }
            if !empty {
                out.push(patch);
            }
        }
        out
    }

    /// The root of the tree.
    pub(crate) fn root(&self) -> Patch {
        Patch::group(self.nodes.len() - 1)
    }

    pub(crate) fn node(&self, index: usize) -> &Node {
        &self.nodes[index]
    }

    /// What is in a node: two nodes, the one nearer to `x` last, or a chart.
    pub(crate) fn below(&self, index: usize, x: Vec3) -> [Option<Patch>; 2] {
        let node = |index: usize| Some(Patch::group(index));
        match self.nodes[index].below {
            Below::Chart(chart) => [None, Some(self.patch(chart))],
            Below::Nodes([a, b]) => {
                let far = |i: usize| (self.nodes[i].center - x).norm_squared();
                if far(a) < far(b) { [node(b), node(a)] } else { [node(a), node(b)] }
            }
        }
    }

    pub(crate) fn jet(&self, spot: &Spot) -> Jet {
        self.on_rolled(spot.chart).map_or_else(|| self.look(spot).0, |r| self.rolled_jet(r, spot))
    }

    /// The middle of a piece, the second derivatives there, and how much they differ on it at most: uu, uv, vv.
    pub(crate) fn bent(&self, patch: &Patch) -> (Jet, [Vec3; 3], [f64; 3]) {
        let (jet, bend) = self.look(&patch.spot());
        let (bend, vary) = self.bend_on(patch, bend, 1.0);
        (jet, bend, vary)
    }

    /// The second derivatives of a piece, and how much they differ on it at most, where no place of it is farther from one where they
    /// are known than so many times its half lengths.
    pub(crate) fn bend_on(
        &self,
        patch: &Patch,
        mut bend: [Vec3; 3],
        far: f64,
    ) -> ([Vec3; 3], [f64; 3]) {
        let chart = &self.charts[patch.chart];
        let [hu, hv] = two(patch.half, |h| far * h);
        let mut vary = self.second(patch);
        let beyond = chart.more(patch);
        for i in 0..3 {
            let [by_u, by_v] = chart.third[i];
            let off = by_u * hu + by_v * hv + beyond[i];
            if off < vary[i] {
                vary[i] = off;
            } else {
                bend[i] = Vec3::zeros();
            }
        }
        (bend, vary)
    }

    /// A place with its second derivatives.
    pub(crate) fn look(&self, spot: &Spot) -> (Jet, [Vec3; 3]) {
        let chart = &self.charts[spot.chart];
        let d = match &chart.powers {
            Some(powers) => chart.beyond_cell(spot.at, |at| powers.at(at)),
            None => self.at(chart, spot.at),
        };
        let n = d.u.cross(&d.v);
        let square = n.norm_squared();
        let flat = square <= 1e-18 * d.u.norm_squared() * d.v.norm_squared();
        let n = if flat || square == 0.0 {
            // Where a derivative vanishes the normal of a place beside it.
            let at = two([0, 1], |k| {
                let middle = 0.5 * (chart.range[k][0] + chart.range[k][1]);
                spot.at[k] + (middle - spot.at[k]) * 1e-5
            });
            let d = self.at(chart, at);
            crate::solid::unit_or(d.u.cross(&d.v), Vec3::z())
        } else {
            n * (1.0 / square.sqrt())
        };
        (Jet { p: d.point, d: [d.u, d.v], n }, [d.uu, d.uv, d.vv])
    }

    /// Point and derivatives, straight on beyond the cell.
    #[inline]
    fn at(&self, chart: &Chart, at: [f64; 2]) -> Derivatives {
        let [i, j] = chart.cell;
        chart.beyond_cell(at, |inside| match &self.kind {
            Kind::Sculpted(s) => s.on(&chart.own, inside),
            Kind::Ruled(s) => s.at(i, j, inside[0], inside[1]),
            Kind::Polyconic(s) => s.at(i, j, inside[0], inside[1]),
        })
    }

    fn bend(&self, [i, j]: [usize; 2]) -> Bend {
        match &self.kind {
            Kind::Sculpted(s) => s.bend(i, j),
            Kind::Ruled(s) => s.bend(i, j),
            Kind::Polyconic(s) => s.bend(i, j),
        }
    }

    /// Bounds of the second derivatives over a piece.
    pub(crate) fn second(&self, patch: &Patch) -> [f64; 3] {
        let chart = &self.charts[patch.chart];
        let more = chart.more(patch);
        three([0, 1, 2], |i| chart.second[i] + more[i])
    }

    /// By how much `dU x dV` changes at most from the middle of a piece along either parameter, by bounds of the second derivatives on
    /// it, and its length in the middle.
    fn change(&self, patch: &Patch, jet: &Jet, [uu, uv, vv]: [f64; 3]) -> ([f64; 2], f64) {
        let [hu, hv] = patch.half;
        let (su, sv) = (jet.d[0].norm() + uu * hu + uv * hv, jet.d[1].norm() + uv * hu + vv * hv);
        let change = [(uu * sv + su * uv) * hu, (uv * sv + su * vv) * hv];
        (change, jet.d[0].cross(&jet.d[1]).norm())
    }

    /// Bounds of the change of the unit normal over a piece, by parameter, from those of the second derivatives on it.
    pub(crate) fn turn(&self, patch: &Patch, jet: &Jet, second: [f64; 3]) -> [f64; 2] {
        let (change, n) = self.change(patch, jet, second);
        let rest = n - change[0] - change[1];
        if rest > 0.5 * n {
            return two(change, |c| c / rest);
        }
        if let Some(turned) =
            self.turn_at_pole(patch, jet).or_else(|| self.turn_at_corner(patch, jet))
        {
            return turned;
        }
        two(change, |c| 2.0 * c / (change[0] + change[1]).max(f64::MIN_POSITIVE))
    }

    /// The same of a piece of a cell a border of which is one point, where it turns by less than half of a unit.
    ///
    /// With `dU = 0` all along `v = 0`, `dU = v W`, W being the mean of dUV between the border and the place, and the normal goes along
    /// `W x dV`, which does not vanish there. W changes by dUUV at most along u, and by half of dUVV along v.
    fn turn_at_pole(&self, patch: &Patch, jet: &Jet) -> Option<[f64; 2]> {
        let chart = &self.charts[patch.chart];
        let second = self.second(patch);
        // The parameter that vanishes, the other, and how far the middle is from the border.
        let pole = |a: usize, b: usize| {
            let end = (0..2).find(|end| chart.points[b][*end])?;
            Some((a, b, (patch.at[b] - chart.within[b][end]).abs()))
        };
        let within = (0..2).all(|k| {
            let [from, to] = chart.within[k];
            patch.at[k] - patch.half[k] >= from && patch.at[k] + patch.half[k] <= to
        });
        let (a, b, far) = pole(0, 1).or_else(|| pole(1, 0)).filter(|p| within && p.2 > 0.0)?;
        let (ha, hb) = (patch.half[a], patch.half[b]);
        let (ab, bb) = (second[1], second[2 * b]);
        let [aab, abb] = [chart.third[1][a], 0.5 * chart.third[1][b]];
        let mean = jet.d[a].norm() / far + aab * ha + abb * hb;
        let along = jet.d[b].norm() + ab * ha + bb * hb;
        let of_a = (aab * along + mean * ab) * ha;
        let of_b = (abb * along + mean * bb) * hb;
        let n = jet.d[0].cross(&jet.d[1]).norm() / far;
        let rest = n - of_a - of_b;
        let mut turned = [0.0; 2];
        (turned[a], turned[b]) = (of_a / rest, of_b / rest);
        (rest > 0.5 * n).then_some(turned)
    }

    /// The same of a piece of a cell that has a corner without a normal, or next to; half of it counts for each parameter.
    fn turn_at_corner(&self, patch: &Patch, jet: &Jet) -> Option<[f64; 2]> {
        let chart = &self.charts[patch.chart];
        let range = two([0, 1], |k| [patch.at[k] - patch.half[k], patch.at[k] + patch.half[k]]);
        let [i, j] = chart.cell;
        let far = match &self.kind {
            Kind::Sculpted(s) if chart.bare => s.normals([i, j], range, jet.n),
            _ => None,
        }?;
        Some([0.5 * far; 2])
    }

    /// The same place in the chart next to it when the parameters left theirs; at a border the border.
    pub(crate) fn settle(&self, spot: Spot) -> Spot {
        let chart = &self.charts[spot.chart];
        let [u, v] = &chart.range;
        let within = |x: f64, range: &[f64; 2]| x >= range[0] && x <= range[1];
        if within(spot.at[0], u) && within(spot.at[1], v) {
            return spot;
        }
        let columns = self.columns();
        let rows = self.charts.len() / columns;
        let mut place = [spot.chart % columns, spot.chart / columns];
        let mut at = spot.at;
        for k in 0..2 {
            let n = [columns, rows][k];
            let range = self.charts[place[1] * columns + place[0]].range[k];
            let side = &self.grid.sides[k];
            // No farther than into the neighbour: what lies beyond is looked at from there.
            let from = place[k];
            if at[k] > range[1] && place[k] + 1 < n && side.joins(place[k], 1) {
                place[k] += 1;
            } else if at[k] < range[0] && place[k] > 0 && side.joins(place[k], 0) {
                place[k] -= 1;
            }
            if self.charts[place[1] * columns + place[0]].none {
                place[k] = from;
            }
            let range = self.charts[place[1] * columns + place[0]].range[k];
            at[k] = at[k].clamp(range[0], range[1]);
        }
        Spot { chart: place[1] * columns + place[0], at }
    }

    fn columns(&self) -> usize {
        let side = &self.grid.sides[0];
        side.knots.len() - 1
            + usize::from(side.before.is_some())
            + usize::from(side.behind.is_some())
    }
}
