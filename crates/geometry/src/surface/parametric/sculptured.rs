//! SSURF as a surface that controls the tool.
//!
//! Both parameters run from 0 to 1 over the whole surface. Beyond its borders the surface goes on straight
//! for a few times its own length, but where it closes on itself or shrinks to a point.

use std::sync::{Arc, OnceLock};

use crate::Vec3;
use crate::sculpt::{Border, Patch, Sculptured};
use crate::sculptured::SurfaceDefinition;

use super::cells::Cells;
use super::edges::{Edge, edges};
use super::{Domain, Jet, ParametricSurface};

/// How far the continuation goes, in lengths of the surface.
const BEYOND: f64 = 12.0;
/// The same along rulings, which are long lines as they are: a flank beside a low wall is as tall as many of its heights.
const BEYOND_RULINGS: f64 = 32.0;

/// Places along a border from which its continuation is followed.
const RAYS: usize = 16;
/// Lengths of the surface after which it is first looked whether it meets the surface again, and least step, which grows with the way.
const FIRST: f64 = 0.12;
const STEP: f64 = 0.04;
/// Then it is to be this share of its way away from its border.
const LEAVES: f64 = 0.5;
/// It meets it where it is nearer to the surface than this share of its way.
const MEETS: f64 = 0.1;
/// There it ends at this share of its way.
const CLEAR: f64 = 0.9;

/// Places round a pole, so much of the way across from it, from which a way that comes over it goes on.
const PLACES: u8 = 16;
const ROUND: f64 = 0.04;

/// A sculptured surface prepared for evaluation.
#[derive(Clone, Debug)]
pub(super) struct Spans {
    surface: Sculptured,
    domain: Domain,
    borders: [[Border; 2]; 2],
    /// Of borders that are one point without one normal, as the tip of a cone, the mean of those there.
    tips: [[Option<Vec3>; 2]; 2],
    /// Is it straight along u, and bent along v?
    ruled_along: bool,
    cells: Cells,
    /// Its edges, once they are asked for.
    edges: OnceLock<Vec<Edge>>,
    /// The same without its continuation, where there is one.
    itself: Option<Arc<ParametricSurface>>,
}

/// A sculptured surface with how far it goes straight on, in shares of itself: 0 to 1 is the surface.
#[derive(Clone, Debug)]
pub struct Continued {
    /// The surface; loose patches that fit together are one grid.
    pub surface: Sculptured,
    /// The range along u.
    pub u: [f64; 2],
    /// The range along v.
    pub v: [f64; 2],
}

/// The surface of a definition as it guides the tool; `None` when it cannot be fitted.
pub fn continued(definition: &SurfaceDefinition) -> Option<Continued> {
    continued_itself(Spans::fitted(definition)?)
}

/// The same of a surface that is fitted; `None` where a point of it is not finite.
pub fn continued_of(surface: &Sculptured) -> Option<Continued> {
    continued_itself(surface.clone())
}

fn continued_itself(surface: Sculptured) -> Option<Continued> {
    let (Spans { surface, .. }, _, domain) = Spans::extended(surface)?;
    Some(Continued { surface, u: domain.u, v: domain.v })
}

impl Spans {
    /// `None` when the definition cannot be fitted.
    pub(super) fn new(definition: &SurfaceDefinition) -> Option<Self> {
        Self::of_surface(Self::fitted(definition)?)
    }

    /// The surface of a definition; loose patches that fit together are one grid.
    fn fitted(definition: &SurfaceDefinition) -> Option<Sculptured> {
        // Triangles are for checking: they have no common parameters and no smooth normals.
        if definition.only_checks() {
            return None;
        }
        let fitted = crate::sculpt::fit_surface(definition).ok()?;
        Some(fitted.together().unwrap_or(fitted))
    }

    /// `None` where a point of the surface is not finite.
    pub(super) fn of_surface(surface: Sculptured) -> Option<Self> {
        let (bare, own, domain) = Self::extended(surface)?;
        let cells = Cells::new(&bare.surface, &domain)?;
        let new = Self { domain, cells, edges: OnceLock::new(), ..bare };
        let itself = new.goes_on().then(|| Arc::new(own));
        Some(Self { itself, ..new })
    }

    /// The surface alone, twice, and how far it goes straight on.
    fn extended(surface: Sculptured) -> Option<(Self, ParametricSurface, Domain)> {
        let size = surface.extent();
        let rulings = [true, false].map(|along| straight(&surface, size, along));
        let ruled_along = rulings == [true, false];
        let borders = surface.borders();
        let whole = Domain { u: [0.0, 1.0], v: [0.0, 1.0] };
        let cells = Cells::new(&surface, &whole)?;
        let tips = [0, 1].map(|k| [0, 1].map(|end| tip(&surface, &borders, k, end)));
        let bare = Self {
            surface,
            domain: whole,
            borders,
            tips,
            ruled_along,
            cells,
            edges: OnceLock::new(),
            itself: None,
        };
        let own = ParametricSurface::of_spans(bare.clone());
        let domain = shortened(&bare, &own, &unfolded(&bare, domain(&borders, rulings)));
        Some((bare, own, domain))
    }

    /// How many patches lie along both parameters.
    pub(super) fn spans(&self) -> [f64; 2] {
        self.surface.spans()
    }

    /// How large its numbers are.
    pub(super) fn size(&self) -> f64 {
        self.surface.extent()
    }

    /// The surface without its continuation; `None` where it has none.
    pub(super) fn without_continuation(&self) -> Option<&Arc<ParametricSurface>> {
        self.itself.as_ref()
    }

    /// Does it go on straight anywhere, or over holes?
    fn goes_on(&self) -> bool {
        let out = |[low, high]: [f64; 2]| low < 0.0 || high > 1.0;
        out(self.domain.u) || out(self.domain.v) || self.surface.has_holes()
    }

    /// The mean of its normals.
    pub(super) fn mean_normal(&self) -> Vec3 {
        const SIDE: u32 = 5;
        let share = |i: u32| (f64::from(i) + 0.5) / f64::from(SIDE);
        let all =
            (0..SIDE * SIDE).filter_map(|k| self.own_normal([share(k % SIDE), share(k / SIDE)]));
        all.sum::<Vec3>() / f64::from(SIDE * SIDE)
    }

    /// Has it a border beyond which it could go on straight?
    pub(super) fn is_open(&self) -> bool {
        self.borders.iter().flatten().any(|border| *border == Border::Free)
    }

    /// Its unit normal at parameters from 0 to 1.
    pub(super) fn own_normal(&self, [u, v]: [f64; 2]) -> Option<Vec3> {
        let [nu, nv] = self.surface.spans();
        self.surface.normal_at(u * nu, v * nv)
    }

    /// Its edges and tips.
    pub(super) fn edges(&self) -> &[Edge] {
        self.edges.get_or_init(|| edges(&self.surface, self))
    }

    /// Where it may be nearest to a point, or be met by a line.
    pub(super) fn cells(&self) -> &Cells {
        &self.cells
    }

    /// The place on a patch, also on its borders.
    pub(super) fn jet_of(&self, patch: [usize; 2], u: f64, v: f64) -> Jet {
        jet(&self.surface, Some(patch), u, v)
    }

    /// Do its rulings run along u? Else along v.
    pub(super) fn ruled_along(&self) -> bool {
        self.ruled_along
    }

    pub(super) fn domain(&self) -> Domain {
        self.domain
    }

    /// Does the surface end at the place with these parameters? At a seam and a pole it does not.
    pub(super) fn ends_at(&self, u: f64, v: f64) -> bool {
        let goes_on = |border| matches!(border, Border::Seam | Border::Pole);
        let ends = |t: f64, [low, high]: [f64; 2], [first, last]: [Border; 2]| {
            t <= low && !goes_on(first) || t >= high && !goes_on(last)
        };
        ends(u, self.domain.u, self.borders[0]) || ends(v, self.domain.v, self.borders[1])
    }

    /// The mean of the normals of a tip in which the place lies.
    pub(super) fn tip(&self, uv: [f64; 2]) -> Option<Vec3> {
        (0..2).find_map(|k| {
            self.tips[k][0].filter(|_| uv[k] <= 0.0).or(self.tips[k][1].filter(|_| uv[k] >= 1.0))
        })
    }

    /// The mean of the normals of an edge on which the place lies.
    pub(super) fn edge(&self, uv: [f64; 2]) -> Option<Vec3> {
        self.edges().iter().find_map(|edge| edge.mean_at(self, uv))
    }

    /// Where the way towards `p` goes on across a seam, or round a pole, at which it is held fast along the parameters `fixed`.
    pub(super) fn beyond(&self, uv: [f64; 2], fixed: [bool; 2], p: Vec3) -> Option<[f64; 2]> {
        let border = |axis: usize| self.borders[axis][usize::from(uv[axis] > 0.5)];
        let held = |axis: usize, kind| fixed[axis] && border(axis) == kind;
        let mut over = uv;
        if let Some(axis) = (0..2).find(|a| held(*a, Border::Seam)) {
            over[axis] = 1.0 - uv[axis];
            return Some(over);
        }
        let axis = (0..2).find(|a| held(*a, Border::Pole))?;
        over[axis] += (1.0 - 2.0 * uv[axis]) * ROUND;
        let round = (0..PLACES).map(|k| {
            let mut around = over;
            around[1 - axis] = f64::from(k) / f64::from(PLACES);
            around
        });
        let away = |[u, v]: [f64; 2]| (self.jet(u, v).s - p).norm_squared();
        round.min_by(|a, b| away(*a).total_cmp(&away(*b)))
    }

    /// Is the first or last border of u (0) or v (1) at least so far from a convex body, as [`ParametricSurface::keeps_off`] is asked?
    /// Each of its curves lies among its control points, and these beyond a plane.
    pub(super) fn border_keeps_off(
        &self,
        border: [usize; 2],
        least: f64,
        near: impl Fn(Vec3) -> (f64, Vec3),
    ) -> bool {
        self.surface.border_curves(border).all(|points| {
            let middle = (points[1] + points[2]) * 0.5;
            let (distance, gradient) = near(middle);
            points.iter().all(|p| distance + gradient.dot(&(p - middle)) >= least)
        })
    }

    /// Is the surface smooth between two places?
    #[inline]
    pub(super) fn is_smooth_between(&self, from: [f64; 2], to: [f64; 2]) -> bool {
        let [nu, nv] = self.surface.spans();
        let of = |[u, v]: [f64; 2]| [u * nu, v * nv];
        self.surface.is_one_patch(of(from), of(to))
    }

    #[inline]
    pub(super) fn jet(&self, u: f64, v: f64) -> Jet {
        jet(&self.surface, None, u, v)
    }
}

/// The place by parameters from 0 to 1, straight on beyond; of the patch that is named, also on its borders.
#[inline]
pub(super) fn jet(surface: &Sculptured, patch: Option<[usize; 2]>, u: f64, v: f64) -> Jet {
    let [nu, nv] = surface.spans();
    match patch {
        Some(patch) => surface.at_patch(patch, u * nu, v * nv).rated(nu, nv).into(),
        None => surface.at_rated(u * nu, v * nv, [nu, nv]).into(),
    }
}

/// The mean of the normals round a border that is a point and no pole.
fn tip(surface: &Sculptured, borders: &[[Border; 2]; 2], k: usize, end: usize) -> Option<Vec3> {
    if borders[k][end] != Border::Edge || !surface.is_point(k, end == 1) {
        return None;
    }
    let spans = surface.spans();
    let normal = |i: u8| {
        let mut at = [end as f64 * spans[k]; 2];
        at[1 - k] = spans[1 - k] * (f64::from(i) + 0.5) / f64::from(PLACES);
        surface.normal_at(at[0], at[1])
    };
    (0..PLACES).filter_map(normal).sum::<Vec3>().try_normalize(1e-9)
}

/// How far the surface goes, beyond 0 to 1 straight on.
fn domain(borders: &[[Border; 2]; 2], rulings: [bool; 2]) -> Domain {
    let range = |k: usize| {
        let far = if rulings[k] { BEYOND_RULINGS } else { BEYOND };
        let beyond = |end: usize| if borders[k][end] == Border::Free { far } else { 0.0 };
        [-beyond(0), 1.0 + beyond(1)]
    };
    Domain { u: range(0), v: range(1) }
}

/// The domain, its continuation cut off before it folds back: where the lines that go on from a border come together anywhere, and
/// where twisted ones do beyond a corner. The whole border ends there; what is lost of it lies off the surface, and what folds back
/// would stand over it.
fn unfolded(bare: &Spans, mut domain: Domain) -> Domain {
    /// Share of the size of the normal, before it is made a unit vector, that is to be left of it.
    const LEAST: f64 = 0.2;
    /// Sine between both derivatives at a place below which it tells nothing.
    const FLAT: f64 = 1e-9;
    // By how much of itself the normal shrinks with the way beyond a border by u and by v: evenly.
    let shrinks = |u: f64, v: f64| {
        let jet = bare.jet(u, v);
        let n = jet.su.cross(&jet.sv);
        let square = n.norm_squared();
        let tells = n.norm() > FLAT * jet.su.norm() * jet.sv.norm();
        let shrink = |by: Vec3, end: f64| (-by.dot(&n) / square * (2.0 * end - 1.0)).max(0.0);
        let both = [shrink(jet.su.cross(&jet.suv), u), shrink(jet.suv.cross(&jet.sv), v)];
        if tells { both } else { [0.0; 2] }
    };
    let room = 1.0 - LEAST;
    for (axis, end) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
        let border = end as f64;
        let most = (0..=RAYS).map(|k| k as f64 / RAYS as f64).map(|along| {
            let [u, v] = if axis == 0 { [border, along] } else { [along, border] };
            shrinks(u, v)[axis]
        });
        let most = most.fold(0.0, f64::max);
        let range = if axis == 0 { &mut domain.u } else { &mut domain.v };
        let far = range[end] - border;
        if most * far.abs() > room {
            range[end] = border + room / most * far.signum();
        }
    }
    for [i, j] in [[0, 0], [0, 1], [1, 0], [1, 1]] {
        let (u, v) = (i as f64, j as f64);
        let [a, b] = [domain.u[i] - u, domain.v[j] - v];
        let [by_u, by_v] = shrinks(u, v);
        let share = room / (a.abs() * by_u + b.abs() * by_v);
        if a != 0.0 && b != 0.0 && share < 1.0 {
            domain.u[i] = u + a * share;
            domain.v[j] = v + b * share;
        }
    }
    domain
}

/// The domain, its continuation cut off before it meets the surface again: what sticks out beyond it there is no
/// part of it.
fn shortened(bare: &Spans, whole: &ParametricSurface, free: &Domain) -> Domain {
    let mut domain = *free;
    for (axis, end) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
        let range = if axis == 0 { &mut domain.u } else { &mut domain.v };
        let border = end as f64;
        let far = (range[end] - border).abs();
        if far == 0.0 {
            continue;
        }
        let mut reach = far.min(bare.surface.runs_on(axis, end == 1));
        for k in 0..RAYS {
            let along = (k as f64 + 0.5) / RAYS as f64;
            let [u, v] = if axis == 0 { [border, along] } else { [along, border] };
            let jet = bare.jet(u, v);
            let way = if axis == 0 { jet.su } else { jet.sv } * (2.0 * border - 1.0);
            let length = way.norm();
            let away = |t: f64| whole.foot(jet.s + way * t).distance.abs() / length;
            let first = FIRST.min(STEP * far);
            // From so far on it is beyond all of the surface by more than what it meets.
            let last = ahead(&bare.surface, jet.s, way / length) / (length * (1.0 - MEETS));
            if first >= last {
                continue;
            }
            let mut t = first;
            let mut there = away(t);
            // Beside its own border it does not come off it, and tells nothing.
            if there < LEAVES * t {
                continue;
            }
            while t < reach.min(last) {
                if there < MEETS * t {
                    reach = CLEAR * t;
                }
                t += there.max(first).max(STEP * t);
                there = if t < reach.min(last) { away(t) } else { there };
            }
        }
        if reach < far {
            range[end] = border + (range[end] - border).signum() * reach;
        }
    }
    domain
}

/// How far along the unit vector `d` the surface reaches from a place at most; infinite where its control points do not hold it.
fn ahead(surface: &Sculptured, from: Vec3, d: Vec3) -> f64 {
    let points = surface.patches.iter().flat_map(|p| p.net.iter().flatten());
    let along =
        points.map(|h| if h.w > 0.0 { (h.xyz() / h.w - from).dot(&d) } else { f64::INFINITY });
    along.fold(f64::NEG_INFINITY, f64::max)
}

/// Do the control points of each row along u (or across, along v) lie on a straight line?
fn straight(surface: &Sculptured, size: f64, along: bool) -> bool {
    let row = |p: &Patch, k: usize| {
        [0, 1, 2, 3].map(|i| {
            let h = if along { p.net[k][i] } else { p.net[i][k] };
            h.xyz() / h.w
        })
    };
    let line = |q: [Vec3; 4]| {
        let w = q[3] - q[0];
        [q[1], q[2]].iter().all(|r| (r - q[0]).cross(&w).norm() <= 1e-9 * size * w.norm())
    };
    surface.patches.iter().all(|p| (0..4).all(|k| line(row(p, k))))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sculpt::from_vectors;

    /// The rounded foot of a wall round three sides of a yard: at the bottom, z = 0, it goes on level, and would come
    /// out on the other side.
    fn foot() -> Sculptured {
        use crate::trig::{cos, sin};
        let right = core::f64::consts::FRAC_PI_2;
        // From along one side over a corner and the back to the other side; the way out and where it begins.
        let place = |k: usize, a: f64| match k {
            0 => (Vec3::new(1.0, 10.0 * a, 0.0), Vec3::x()),
            1 => (Vec3::new(1.0, 10.0, 0.0), Vec3::new(cos(right * a), sin(right * a), 0.0)),
            2 => (Vec3::new(1.0 - 2.0 * a, 10.0, 0.0), Vec3::y()),
            3 => (Vec3::new(-1.0, 10.0, 0.0), Vec3::new(-sin(right * a), cos(right * a), 0.0)),
            _ => (Vec3::new(-1.0, 10.0 - 10.0 * a, 0.0), -Vec3::x()),
        };
        let at = |k: usize, a: f64, b: f64| {
            let (from, out) = place(k, a);
            from + out * cos(right * b) + Vec3::z() * (1.0 - sin(right * b))
        };
        // Along u and v the derivatives at the corners, by differences.
        let patch = |k: usize| {
            const H: f64 = 1e-4;
            let slope = |f: &dyn Fn(f64) -> Vec3, t: f64| (f(t + H) - f(t - H)) / (2.0 * H);
            let u = |a: f64, b: f64| slope(&|a| at(k, a, b), a);
            let v = |a: f64, b: f64| slope(&|b| at(k, a, b), b);
            let uv = |a: f64, b: f64| slope(&|a| v(a, b), a);
            let row = |b: f64| [at(k, 0.0, b), at(k, 1.0, b), u(0.0, b), u(1.0, b)];
            let side = |b: f64| [v(0.0, b), v(1.0, b), uv(0.0, b), uv(1.0, b)];
            let rows = [row(0.0), row(1.0), side(0.0), side(1.0)];
            from_vectors(core::array::from_fn(|i| rows[i / 4][i % 4]))
        };
        Sculptured::grid((0..5).map(patch).collect(), 5, 1).unwrap()
    }

    #[test]
    fn a_border_keeps_off_what_is_beside_its_middle() {
        let spans = Spans::of_surface(foot()).unwrap();
        let jet = |[axis, end]: [usize; 2]| {
            let end = end as f64;
            if axis == 0 { spans.jet(end, 0.5).s } else { spans.jet(0.5, end).s }
        };
        for border in [[0, 0], [0, 1], [1, 0], [1, 1]] {
            let near = |center: Vec3| {
                move |q: Vec3| {
                    let away = q - center;
                    let far = away.norm();
                    (far, if far > 0.0 { away / far } else { Vec3::zeros() })
                }
            };
            let (on, beside) = (jet(border), Vec3::new(0.0, 5.0, 30.0));
            assert!(!spans.border_keeps_off(border, 1e-6, near(on)), "{border:?}");
            assert!(spans.border_keeps_off(border, 20.0, near(beside)), "{border:?}");
        }
    }

    #[test]
    fn a_continuation_ends_before_it_meets_the_surface_again() {
        let spans = Spans::of_surface(foot()).unwrap();
        let Domain { u, v } = spans.domain();
        assert!(v[1] > 2.0 && v[1] < 2.3, "{v:?}");
        for w in [0.1, 0.9] {
            let s = spans.jet(w, v[1]).s;
            assert!(s.x.abs() < 1.0 && s.z.abs() < 0.1, "{s}");
        }
        // Up the wall and off the ends nothing is met.
        assert_eq!((u, v[0]), ([-BEYOND, 1.0 + BEYOND], -BEYOND));
    }
}
