//! SSURF: patches with a common parameter.

use serde::{Deserialize, Serialize};

use super::patch::{Derivatives, Patch};
use super::together::Origins;
use super::whole;
use crate::{Transform, Vec3};

/// How the patches lie.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Layout {
    /// A grid: patch (i, j), stored at `j * columns + i`, covers `u[i]..u[i + 1]` and `v[j]..v[j + 1]`.
    /// Spans of the surface lie between whole numbers; a span may be several patches.
    Mesh {
        /// Rising parameters of the columns' borders, from 0 to the number of spans.
        u: Vec<f64>,
        /// The same across.
        v: Vec<f64>,
    },
    /// Patches in any arrangement; they are parametrised one after the other along u.
    Patches,
}

/// Why patches make no surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SculptFault {
    /// No patch at all.
    Empty,
    /// The number of patches is not that of the grid's cells.
    WrongCount,
    /// A number is not finite, or a weight is not positive.
    NotFinite,
}

/// A sculptured surface.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Sculptured {
    /// The patches.
    pub patches: Vec<Patch>,
    /// How they lie.
    pub layout: Layout,
    /// Of loose patches that were put together, what each was.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(super) origins: Option<Origins>,
}

impl Sculptured {
    /// A grid of `columns` by `rows` patches with a span each.
    pub fn grid(patches: Vec<Patch>, columns: usize, rows: usize) -> Result<Self, SculptFault> {
        let knots = |n: usize| (0..=n).map(|k| k as f64).collect();
        Self::checked(patches, Layout::Mesh { u: knots(columns), v: knots(rows) })
    }

    /// Patches without a common grid.
    pub fn loose(patches: Vec<Patch>) -> Result<Self, SculptFault> {
        Self::checked(patches, Layout::Patches)
    }

    /// From patches and layout.
    pub fn checked(patches: Vec<Patch>, layout: Layout) -> Result<Self, SculptFault> {
        if patches.is_empty() {
            return Err(SculptFault::Empty);
        }
        if let Layout::Mesh { u, v } = &layout {
            let rising = |k: &[f64]| k.len() > 1 && k.windows(2).all(|w| w[0] < w[1]);
            if !rising(u) || !rising(v) || (u.len() - 1) * (v.len() - 1) != patches.len() {
                return Err(SculptFault::WrongCount);
            }
        }
        let sound = patches
            .iter()
            .flat_map(|p| p.net.iter().flatten())
            .all(|h| h.iter().all(|x| x.is_finite()) && h.w > 0.0);
        if sound {
            Ok(Self { patches, layout, origins: None })
        } else {
            Err(SculptFault::NotFinite)
        }
    }

    /// Does it extend both ways anywhere? Curves laid upon each other give one that does not.
    pub fn has_area(&self) -> bool {
        /// Below this share of the square of the size a parallelogram of both derivatives is rounding.
        const NONE: f64 = 1e-12;
        let [low, high] = self.bounds();
        let least = NONE * (high - low).norm_squared();
        let places = [[0.5, 0.5], [0.25, 0.25], [0.75, 0.25], [0.25, 0.75], [0.75, 0.75]];
        self.patches.iter().any(|p| {
            places.iter().any(|[u, v]| {
                let d = p.at(*u, *v);
                d.u.cross(&d.v).norm() > least
            })
        })
    }

    /// How far u and v go; both begin at 0.
    pub fn spans(&self) -> [f64; 2] {
        match &self.layout {
            Layout::Mesh { u, v } => [u[u.len() - 1], v[v.len() - 1]],
            Layout::Patches => [self.patches.len() as f64, 1.0],
        }
    }

    /// Index of the patch over (u, v) with its own parameters and how fast they run.
    #[inline(always)]
    fn cell(&self, u: f64, v: f64) -> (usize, [f64; 2], [f64; 2]) {
        match &self.layout {
            Layout::Mesh { u: ku, v: kv } => {
                let (i, a, da) = interval(ku, u);
                let (j, b, db) = interval(kv, v);
                (j * (ku.len() - 1) + i, [a, b], [da, db])
            }
            Layout::Patches => {
                let i = whole(u).min(self.patches.len() - 1);
                (i, [u - i as f64, v], [1.0, 1.0])
            }
        }
    }

    /// The number of the patch over (u, v) with its own parameters.
    pub(super) fn local(&self, [u, v]: [f64; 2]) -> (usize, [f64; 2]) {
        let (index, own, _) = self.cell(u, v);
        (index, own)
    }

    /// Does the second place lie inside of the patch that the first lies in or on the border of? Between the two the surface is smooth.
    #[inline]
    pub(crate) fn is_one_patch(&self, from: [f64; 2], to: [f64; 2]) -> bool {
        let one = |knots: &[f64], from: f64, to: f64| {
            let i = before(knots, from);
            let (low, high) = (knots[i], knots[i + 1]);
            from >= low && from <= high && to > low && to < high
        };
        match &self.layout {
            Layout::Mesh { u, v } => one(u, from[0], to[0]) && one(v, from[1], to[1]),
            Layout::Patches => {
                let (first, start, _) = self.cell(from[0], from[1]);
                let (second, end, _) = self.cell(to[0], to[1]);
                let inside = start.iter().all(|x| (0.0..=1.0).contains(x));
                first == second && inside && end.iter().all(|x| *x > 0.0 && *x < 1.0)
            }
        }
    }

    /// Point and derivatives at (u, v); beyond the borders the outermost patches go on in a straight line.
    #[inline]
    pub fn at(&self, u: f64, v: f64) -> Derivatives {
        self.at_rated(u, v, [1.0, 1.0])
    }

    /// The same when u and v run so many times as fast.
    #[inline]
    pub(crate) fn at_rated(&self, u: f64, v: f64, rate: [f64; 2]) -> Derivatives {
        let (i, [a, b], [da, db]) = self.cell(u, v);
        prolonged(&self.patches[i], a, b).rated(da * rate[0], db * rate[1])
    }

    /// The derivatives dU and dV at (u, v). Where a border runs together in a point, as in a three-sided patch, that along it
    /// has the direction to which it comes along the other parameter: with `dU = 0` all along `v = 0` it is near by
    /// `dU = v dUV`, along `dUV` on the side of rising v and against it on the other. Where one vanishes across a border that is none, as
    /// where two rows of points are one, it has that of the second derivative: with `dV = 0` all along `v = 0` it is near by `v dVV`.
    pub fn tangents(&self, u: f64, v: f64) -> [Vec3; 2] {
        /// Part of one derivative that the other may be and still count as none; and how near to a border is on it.
        const NONE: f64 = 1e-9;
        let d = self.at(u, v);
        let [nu, nv] = self.spans();
        let inwards = |x: f64, end: f64| match x {
            x if x <= NONE => 1.0,
            x if x >= end - NONE => -1.0,
            _ => 0.0,
        };
        let (a, b, twist) = (d.u.norm(), d.v.norm(), d.uv.norm());
        let (to_u, to_v) = (inwards(u, nu), inwards(v, nv));
        if a <= NONE * b && to_v != 0.0 && twist > NONE * b {
            [d.uv * to_v, d.v]
        } else if b <= NONE * a && to_u != 0.0 && twist > NONE * a {
            [d.u, d.uv * to_u]
        } else if a <= NONE * b && to_u != 0.0 {
            [d.uu * to_u, d.v]
        } else if b <= NONE * a && to_v != 0.0 {
            [d.u, d.vv * to_v]
        } else {
            [d.u, d.v]
        }
    }

    /// Unit normal at (u, v) along u x v, at a border that runs together in a point the one to which the normals come.
    pub fn normal_at(&self, u: f64, v: f64) -> Option<Vec3> {
        let [a, b] = self.tangents(u, v);
        let n = a.cross(&b);
        let size = n.norm();
        (size > 1e-12 * a.norm() * b.norm() && size > 0.0).then(|| n / size)
    }

    /// Point and derivatives at (u, v), kept to the patch of column `i` and row `j`, also on its borders; beyond those of the
    /// surface it goes on in a straight line.
    #[inline]
    pub(crate) fn at_patch(&self, [i, j]: [usize; 2], u: f64, v: f64) -> Derivatives {
        let kept = |t: f64, i: usize, n: usize| {
            let low = if i == 0 { f64::NEG_INFINITY } else { 0.0 };
            t.clamp(low, if i + 1 == n { f64::INFINITY } else { 1.0 })
        };
        let own = |knots: &[f64], i: usize, t: f64| {
            let rate = 1.0 / (knots[i + 1] - knots[i]);
            (kept((t - knots[i]) * rate, i, knots.len() - 1), rate)
        };
        let ((a, da), (b, db)) = match &self.layout {
            Layout::Mesh { u: ku, v: kv } => (own(ku, i, u), own(kv, j, v)),
            Layout::Patches => ((kept(u - i as f64, i, self.patches.len()), 1.0), (v, 1.0)),
        };
        prolonged(&self.patches[self.index_of([i, j])], a, b).rated(da, db)
    }

    /// Which patch stands in a column and a row; loose ones are columns.
    pub(crate) fn index_of(&self, [i, j]: [usize; 2]) -> usize {
        match &self.layout {
            Layout::Mesh { u, .. } => j * (u.len() - 1) + i,
            Layout::Patches => i,
        }
    }

    /// Point and derivatives at (u, v) of the n-th span of the grid, counted from 1 along u first, by the
    /// surface's parameters; `None` when there is none.
    pub fn at_span(&self, n: usize, u: f64, v: f64) -> Option<Derivatives> {
        let k = n.checked_sub(1)?;
        let [nu, nv] = self.spans().map(whole);
        let (i, j) = match self.layout {
            Layout::Mesh { .. } => (k % nu, k / nu),
            Layout::Patches => (k, 0),
        };
        if i >= nu || j >= nv {
            return None;
        }
        let Layout::Mesh { u: ku, v: kv } = &self.layout else {
            return Some(prolonged(&self.patches[i], u, v));
        };
        let (a, s, ds) = within(ku, i, u);
        let (b, t, dt) = within(kv, j, v);
        Some(prolonged(&self.patches[b * (ku.len() - 1) + a], s, t).rated(ds, dt))
    }

    /// Parameters of the whole surface for those of the patch of the given index.
    pub fn global(&self, index: usize, u: f64, v: f64) -> [f64; 2] {
        match &self.layout {
            Layout::Mesh { u: ku, v: kv } => {
                let columns = ku.len() - 1;
                let along = |k: &[f64], i: usize, t: f64| k[i] + (k[i + 1] - k[i]) * t;
                [along(ku, index % columns, u), along(kv, index / columns, v)]
            }
            // Its end is the beginning of the next patch, which may be anywhere.
            Layout::Patches if index + 1 < self.patches.len() => {
                let next = (index + 1) as f64;
                [(index as f64 + u).min(next.next_down()), v]
            }
            Layout::Patches => [index as f64 + u, v],
        }
    }

    /// The number of the span, counted from 1, with the parameters in it; of a grid that was put together those of the loose patches.
    pub fn span_of(&self, u: f64, v: f64) -> (usize, [f64; 2]) {
        if let Some(origins) = &self.origins {
            let [u, v] = self.told([u, v]);
            let patch = whole(u).min(origins.iter().flatten().count().max(1) - 1);
            return (patch + 1, [u - patch as f64, v]);
        }
        let [nu, nv] = self.spans();
        let cut = |t: f64, n: f64| t.max(0.0).floor().min(n - 1.0);
        let (i, j) = (cut(u, nu), cut(v, nv));
        (whole(j * nu + i) + 1, [u - i, v - j])
    }

    /// The surface carried by `m`.
    #[must_use]
    pub fn transformed(&self, m: &Transform) -> Self {
        Self {
            patches: self.patches.iter().map(|p| p.transformed(m)).collect(),
            layout: self.layout.clone(),
            origins: self.origins.clone(),
        }
    }

    /// Several surfaces as one. Two grids of equal height that share the border of the first's end and the
    /// second's beginning are not joined: the patches keep no common grid.
    pub fn combined(surfaces: &[Self]) -> Result<Self, SculptFault> {
        match surfaces {
            [one] => Ok(one.clone()),
            many => Self::loose(many.iter().flat_map(|s| s.patches.iter().cloned()).collect()),
        }
    }

    /// Columns and rows of patches (0 0 without a grid), their number, then for each its sixteen control
    /// points (w x, w y, w z, w), along u first.
    pub fn canonical(&self) -> Vec<f64> {
        let grid = match &self.layout {
            Layout::Mesh { u, v } => [u.len() as f64 - 1.0, v.len() as f64 - 1.0],
            Layout::Patches => [0.0, 0.0],
        };
        let mut e = vec![grid[0], grid[1], self.patches.len() as f64];
        for p in &self.patches {
            e.extend(p.net.iter().flatten().flat_map(|h| h.iter().copied()));
        }
        e
    }

    /// Least and greatest coordinates of the control points.
    pub fn bounds(&self) -> [Vec3; 2] {
        let start = [Vec3::repeat(f64::INFINITY), Vec3::repeat(f64::NEG_INFINITY)];
        self.patches
            .iter()
            .map(Patch::bounds)
            .fold(start, |a, b| [a[0].inf(&b[0]), a[1].sup(&b[1])])
    }

    /// A length that says how large the numbers of the surface are.
    pub fn extent(&self) -> f64 {
        let [lo, hi] = self.bounds();
        lo.norm().max(hi.norm())
    }
}

/// The interval of rising knots in which `t` lies, the place in it and the rate.
#[inline(always)]
fn interval(knots: &[f64], t: f64) -> (usize, f64, f64) {
    let i = before(knots, t);
    let rate = 1.0 / (knots[i + 1] - knots[i]);
    (i, (t - knots[i]) * rate, rate)
}

/// Which of the intervals it is.
#[inline(always)]
fn before(knots: &[f64], t: f64) -> usize {
    // Most often they are the whole numbers.
    let guess = whole(t).min(knots.len() - 2);
    if knots[guess] <= t && t < knots[guess + 1] {
        return guess;
    }
    let i = match knots.len() {
        // Of few it is told sooner by all of them.
        0..=FEW => knots.iter().map(|k| usize::from(*k <= t)).sum(),
        _ => knots.partition_point(|k| *k <= t),
    };
    usize::saturating_sub(i, 1).min(knots.len() - 2)
}

/// Knots that are looked at one by one.
const FEW: usize = 12;

/// The same within the span that begins at the whole number `span`: its end belongs to it.
fn within(knots: &[f64], span: usize, t: f64) -> (usize, f64, f64) {
    let from = span as f64;
    let first = knots.partition_point(|k| *k < from);
    let last = knots.partition_point(|k| *k < from + 1.0).saturating_sub(1).max(first);
    let x = from + t;
    let i = knots.partition_point(|k| *k <= x).saturating_sub(1).clamp(first, last);
    let rate = 1.0 / (knots[i + 1] - knots[i]);
    (i, (x - knots[i]) * rate, rate)
}

/// Within the unit square the patch, outside its linear continuation over the border.
#[inline(always)]
fn prolonged(p: &Patch, u: f64, v: f64) -> Derivatives {
    let (a, b) = (u.clamp(0.0, 1.0), v.clamp(0.0, 1.0));
    let d = p.at(a, b);
    let (s, t) = (u - a, v - b);
    if s == 0.0 && t == 0.0 {
        return d;
    }
    let along = s == 0.0 || t == 0.0;
    d.beyond(s, t, if along { p.thirds(&d, a, b) } else { [Vec3::zeros(); 2] })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sculpt::Vec4;
    use proptest::prelude::*;

    fn bilinear(x: f64, y: f64) -> Patch {
        let p = |a: f64, b: f64| Vec3::new(x + a, y + b, (x + a) * (y + b));
        let (c, d, e, f) = (p(0.0, 0.0), p(1.0, 0.0), p(0.0, 1.0), p(1.0, 1.0));
        let twist = Vec3::z();
        Patch::hermite([
            [c, d, d - c, d - c],
            [e, f, f - e, f - e],
            [e - c, f - d, twist, twist],
            [e - c, f - d, twist, twist],
        ])
    }

    #[test]
    fn a_border_whose_rows_are_one_has_the_directions_near_it() {
        // Rows of points at v = 0, 0, 27 and 40 over a floor, bent a little.
        let row = |y: f64, lift: f64| {
            [0.0, 13.0, 27.0, 40.0].map(|x| Vec4::new(x, y, lift + 0.01 * x * x, 1.0))
        };
        let net = [row(0.0, 0.0), row(0.0, 0.0), row(27.0, 1.0), row(40.0, 4.0)];
        let mut turned = net;
        turned.reverse();
        let columns = core::array::from_fn(|j| core::array::from_fn(|i| net[i][j]));
        for (net, k, end) in [(net, 1, 0.0), (turned, 1, 1.0), (columns, 0, 0.0)] {
            let s = Sculptured::grid(vec![Patch::new(net)], 1, 1).unwrap();
            for t in [0.0, 0.3, 1.0] {
                let at = |x: f64| if k == 0 { [x, t] } else { [t, x] };
                let [u, v] = at(end);
                let [nu, nv] = at((end - 1e-5).abs());
                assert!(s.at(nu, nv).normal().is_some());
                let (n, near) = (s.normal_at(u, v).unwrap(), s.normal_at(nu, nv).unwrap());
                assert!((n - near).norm() < 1e-4, "{k} {end} {t}: {n:?} {near:?}");
            }
        }
    }

    #[test]
    fn a_border_that_is_a_point_has_the_directions_near_it() {
        // A fan from the point P to the parabola C, each ruling bent a little: the corner at each of the four borders in turn.
        let (p, c, bend) =
            (Vec3::new(1.0, 2.0, 3.0), Vec3::new(6.0, 0.0, 1.0), Vec3::new(0.0, 0.0, 0.5));
        let rows = |turned: bool, last: bool| {
            let far = |u: f64| c + Vec3::new(0.0, 4.0 * u, u * u);
            let (slope, step) =
                (|u: f64| Vec3::new(0.0, 4.0, 2.0 * u), if last { 1.0 } else { 0.0 });
            let at = |u: f64, v: f64| {
                let w = if last { 1.0 - v } else { v };
                let sign = 1.0 - 2.0 * step;
                let chord = far(u) - p;
                let point = p + chord * w + bend * (w * w);
                (point, slope(u) * w, (chord + bend * (2.0 * w)) * sign, slope(u) * sign)
            };
            let k = |u: f64, v: f64| if turned { at(v, u) } else { at(u, v) };
            let swap = |t: (Vec3, Vec3, Vec3, Vec3)| if turned { (t.0, t.2, t.1, t.3) } else { t };
            let corner = |u: f64, v: f64| swap(k(u, v));
            let [a, b, d, e] =
                [corner(0.0, 0.0), corner(1.0, 0.0), corner(0.0, 1.0), corner(1.0, 1.0)];
            Patch::hermite([
                [a.0, b.0, a.1, b.1],
                [d.0, e.0, d.1, e.1],
                [a.2, b.2, a.3, b.3],
                [d.2, e.2, d.3, e.3],
            ])
        };
        for (turned, last) in [(false, false), (false, true), (true, false), (true, true)] {
            let s = Sculptured::grid(vec![rows(turned, last)], 1, 1).unwrap();
            let edge = if last { 1.0 } else { 0.0 };
            let near = edge + if last { -1e-5 } else { 1e-5 };
            for share in [0.0, 0.3, 1.0] {
                let uv = |x: f64| if turned { [x, share] } else { [share, x] };
                let ([u, v], [nu, nv]) = (uv(edge), uv(near));
                assert!((s.at(u, v).point - p).norm() < 1e-12, "{turned} {last}");
                let (n, beside) = (s.normal_at(u, v).unwrap(), s.at(nu, nv).normal().unwrap());
                assert!((n - beside).norm() < 1e-4, "{turned} {last} {share}: {n} {beside}");
                let (t, d) = (s.tangents(u, v), s.at(nu, nv));
                for (t, d) in t.into_iter().zip([d.u, d.v]) {
                    assert!((t.normalize() - d.normalize()).norm() < 1e-4, "{turned} {last}");
                }
            }
            // Elsewhere nothing is other than it was.
            let d = s.at(0.4, 0.6);
            assert_eq!((s.normal_at(0.4, 0.6), s.tangents(0.4, 0.6)), (d.normal(), [d.u, d.v]));
        }
    }

    #[test]
    fn the_end_of_a_loose_patch_is_not_the_next_one() {
        let patches = vec![bilinear(0.0, 0.0), bilinear(70.0, 50.0), bilinear(-9.0, 3.0)];
        let s = Sculptured::loose(patches).unwrap();
        for (k, corner) in [(0, [0.0, 0.0]), (1, [70.0, 50.0]), (2, [-9.0, 3.0])] {
            let [u, v] = s.global(k, 1.0, 0.25);
            let p = s.at(u, v).point;
            assert!((p.x - corner[0] - 1.0).abs() + (p.y - corner[1] - 0.25).abs() < 1e-12, "{p}");
            let (n, [a, b]) = s.span_of(u, v);
            assert!(n == k + 1 && (a - 1.0).abs() < 1e-12 && (b - 0.25).abs() < 1e-15);
        }
    }

    #[test]
    fn a_grid_counts_spans_and_goes_on_straight() {
        let patches = vec![bilinear(0.0, 0.0), bilinear(1.0, 0.0)];
        let s = Sculptured::grid(patches, 2, 1).unwrap();
        let d = s.at(1.5, 0.5);
        assert!((d.point - Vec3::new(1.5, 0.5, 0.75)).norm() < 1e-15);
        assert_eq!(s.span_of(1.5, 0.5), (2, [0.5, 0.5]));
        assert_eq!(s.at_span(2, 0.5, 0.5), Some(d));
        assert_eq!(s.at_span(3, 0.5, 0.5), None);
        let far = s.at(3.0, 2.0);
        assert!((far.point - Vec3::new(3.0, 2.0, 6.0)).norm() < 1e-14);
        let [u, v] = s.global(1, 0.25, 0.5);
        assert!((u - 1.25).abs() < 1e-15 && (v - 0.5).abs() < 1e-15);
        assert_eq!(Sculptured::grid(s.patches.clone(), 3, 1).unwrap_err(), SculptFault::WrongCount);
    }

    proptest! {
        /// Within and beyond the borders each derivative is how the one before it changes.
        #[test]
        fn derivatives_are_those_of_the_point(
            z in prop::collection::vec(-1.0_f64..1.0, 32), weights: bool,
            u in -1.5_f64..2.5, v in -1.5_f64..2.5,
        ) {
            let patch = Patch::new(core::array::from_fn(|j| core::array::from_fn(|i| {
                let k = 4 * j + i;
                let w = if weights { 1.0 + 0.4 * z[16 + k] } else { 1.0 };
                Vec4::new(i as f64 * w, j as f64 * w, z[k] * w, w)
            })));
            let at = |du: f64, dv: f64| prolonged(&patch, u + du, v + dv);
            // Not across a border.
            let h = 1e-4;
            prop_assume!([u, v].iter().all(|t| t.abs() > h && (t - 1.0).abs() > h));
            let d = at(0.0, 0.0);
            let [by_u, by_v] = [(at(h, 0.0), at(-h, 0.0)), (at(0.0, h), at(0.0, -h))];
            let slope = |a: Vec3, b: Vec3| (a - b) / (2.0 * h);
            let pairs = [
                (d.u, slope(by_u.0.point, by_u.1.point)), (d.v, slope(by_v.0.point, by_v.1.point)),
                (d.uu, slope(by_u.0.u, by_u.1.u)), (d.uv, slope(by_v.0.u, by_v.1.u)),
                (d.uv, slope(by_u.0.v, by_u.1.v)), (d.vv, slope(by_v.0.v, by_v.1.v)),
            ];
            for (n, (told, seen)) in pairs.into_iter().enumerate() {
                let far = (told - seen).norm();
                prop_assert!(far <= 1e-4 * (1.0 + told.norm()), "{n}: {told} {seen}");
            }
        }
    }
}
