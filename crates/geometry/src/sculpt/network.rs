//! GENCUR with CROSS: a surface through a net of curves.

use super::curve::SpaceCurve;
use super::loft::{LoftFault, knots};
use super::patch::Patch;
use super::surface::{Layout, Sculptured};
use crate::Vec3;

/// Curves meet when they come as near as this part of the size of the net.
const MEET: f64 = 1e-5;
/// Derivatives are taken so far within a piece, for they may jump at joints.
const BESIDE: f64 = 1e-9;

/// A curve in the sense of the net.
struct Thread<'c> {
    curve: &'c SpaceCurve,
    /// From its end to its beginning.
    turned: bool,
    /// The joint where each curve of the other family meets it.
    at: Vec<usize>,
}

impl Thread<'_> {
    /// Point and derivative by the flow.
    fn at(&self, s: f64) -> (Vec3, Vec3) {
        if self.turned {
            let p = self.curve.at_flow(self.curve.flow_span() - s);
            (p.point, -p.first)
        } else {
            let p = self.curve.at_flow(s);
            (p.point, p.first)
        }
    }
}

/// The surface through curves along u and curves across that meet all of them at joints, first and last at their ends.
///
/// With L and M the cubic splines that are 1 at one curve and 0 at the others (straight lines between two, with the slope
/// of a parabola at the ends of more), it is Gordon's: sum L(v) C(u) + sum M(u) D(v) - sum L(v) M(u) P. All curves lie in
/// it: at a curve D its M alone is not 0, and there the first and the third sum are the same. It is followed by
/// bicubic patches, eight a span and one more at every joint of an arc. Where the flow of the curves goes on
/// with another speed behind a joint, in another way on each, there is a crease.
pub(crate) fn network(
    curves: &[SpaceCurve],
    cross: &[SpaceCurve],
) -> Result<Sculptured, LoftFault> {
    if let Some(i) = cross.iter().position(|c| c.segments() != cross[0].segments()) {
        return Err(LoftFault::UnevenCross(i));
    }
    let (along, across) = woven(curves, cross)?;
    let [lie_v, lie_u] = [&across[0].at, &along[0].at].map(|at| blending(at));
    // P, the place of curve i at curve j.
    let places: Vec<Vec<Vec3>> =
        along.iter().map(|c| lie_u.knots.iter().map(|s| c.at(*s).0).collect()).collect();
    let (ku, kv) = (knots(curves), knots(cross));
    let of = |threads: &[Thread<'_>], s: f64, inside: f64| -> Vec<(Vec3, Vec3)> {
        threads.iter().map(|c| (c.at(s).0, c.at(s + inside * BESIDE).1)).collect()
    };
    // Curves and splines at both borders of each strip, with the derivatives within it.
    let ends = |threads: &[Thread<'_>], blend: &Blending, knots: &[f64]| -> Vec<[Side; 2]> {
        let side =
            |s: f64, inside: f64| Side { curves: of(threads, s, inside), blend: blend.at(s) };
        knots.windows(2).map(|w| [side(w[0], 1.0), side(w[1], -1.0)]).collect()
    };
    let (us, vs) = (ends(&along, &lie_u, &ku), ends(&across, &lie_v, &kv));
    let mut patches = Vec::with_capacity(us.len() * vs.len());
    for (j, vs) in vs.iter().enumerate() {
        for (i, us) in us.iter().enumerate() {
            let (du, dv) = (ku[i + 1] - ku[i], kv[j + 1] - kv[j]);
            let q = |a: usize, b: usize| corner(&us[a], &vs[b], &places);
            let [c00, c10, c01, c11] = [q(0, 0), q(1, 0), q(0, 1), q(1, 1)];
            let row = |a: &[Vec3; 4], b: &[Vec3; 4]| [a[0], b[0], a[1] * du, b[1] * du];
            let side = |a: &[Vec3; 4], b: &[Vec3; 4]| {
                [a[2] * dv, b[2] * dv, a[3] * (du * dv), b[3] * (du * dv)]
            };
            let rows = [row(&c00, &c10), row(&c01, &c11), side(&c00, &c10), side(&c01, &c11)];
            patches.push(Patch::hermite(rows));
        }
    }
    Sculptured::checked(patches, Layout::Mesh { u: ku, v: kv }).map_err(LoftFault::Surface)
}

/// The curves of one family and the splines of the other at a parameter.
struct Side {
    /// Points and derivatives.
    curves: Vec<(Vec3, Vec3)>,
    /// Values and derivatives.
    blend: Vec<[f64; 2]>,
}

/// Point, derivatives by u and by v, and the mixed one.
fn corner(u: &Side, v: &Side, places: &[Vec<Vec3>]) -> [Vec3; 4] {
    let mut all = [Vec3::zeros(); 4];
    for ((p, d), [l, dl]) in u.curves.iter().zip(&v.blend) {
        add(&mut all, [p * *l, d * *l, p * *dl, d * *dl]);
    }
    for ((p, d), [m, dm]) in v.curves.iter().zip(&u.blend) {
        add(&mut all, [p * *m, p * *dm, d * *m, d * *dm]);
    }
    for (row, [l, dl]) in places.iter().zip(&v.blend) {
        for (p, [m, dm]) in row.iter().zip(&u.blend) {
            add(&mut all, [-p * (l * m), -p * (l * dm), -p * (dl * m), -p * (dl * dm)]);
        }
    }
    all
}

fn add(all: &mut [Vec3; 4], more: [Vec3; 4]) {
    for (a, b) in all.iter_mut().zip(more) {
        *a += b;
    }
}

/// Both families in the sense of the net, those across in the order in which they meet the first curve.
fn woven<'c>(
    curves: &'c [SpaceCurve],
    cross: &'c [SpaceCurve],
) -> Result<(Vec<Thread<'c>>, Vec<Thread<'c>>), LoftFault> {
    let joints = |c: &SpaceCurve| -> Vec<Vec3> {
        (0..=c.segments()).map(|k| c.at_flow(k as f64).point).collect()
    };
    let own: Vec<Vec<Vec3>> = curves.iter().map(joints).collect();
    let other: Vec<Vec<Vec3>> = cross.iter().map(joints).collect();
    let first = own[0][0];
    let far = own.iter().chain(&other).flatten().map(|p| (p - first).norm());
    let size = far.fold(0.0, f64::max);
    // The joints of curve i and curve j across that lie together.
    let meet = |i: usize, j: usize| {
        let pairs = own[i].iter().enumerate().flat_map(|(s, p)| {
            other[j].iter().enumerate().map(move |(t, q)| ((p - q).norm(), s, t))
        });
        let (gap, s, t) = pairs.min_by(|a, b| a.0.total_cmp(&b.0)).unwrap_or((f64::INFINITY, 0, 0));
        if gap <= MEET * size { Ok((s, t)) } else { Err(LoftFault::Apart(i, j)) }
    };
    let mut order: Vec<(usize, usize)> = Vec::with_capacity(cross.len());
    for j in 0..cross.len() {
        order.push((meet(0, j)?.0, j));
    }
    order.sort_unstable();
    let thread = |curve: &'c SpaceCurve, mut at: Vec<usize>| {
        let turned = at[0] > at[at.len() - 1];
        if turned {
            at.iter_mut().for_each(|k| *k = curve.segments() - *k);
        }
        Thread { curve, turned, at }
    };
    let mut along = Vec::with_capacity(curves.len());
    for (i, curve) in curves.iter().enumerate() {
        let at = order.iter().map(|(_, j)| Ok(meet(i, *j)?.0)).collect::<Result<_, _>>()?;
        along.push(thread(curve, at));
    }
    let mut across = Vec::with_capacity(cross.len());
    for (_, j) in &order {
        let at = (0..curves.len()).map(|i| Ok(meet(i, *j)?.1)).collect::<Result<_, _>>()?;
        across.push(thread(&cross[*j], at));
    }
    // One parameter for all: each meets the others at the same joints, which rise from the first to the last.
    for family in [&along, &across] {
        let last = family[0].curve.segments();
        let at = &family[0].at;
        let rises = at.windows(2).all(|w| w[0] < w[1]);
        if !rises || at[0] != 0 || at[at.len() - 1] != last || family.iter().any(|c| c.at != *at) {
            return Err(LoftFault::Cross);
        }
    }
    Ok((along, across))
}

/// Splines that are 1 at one of the knots and 0 at the others.
struct Blending {
    knots: Vec<f64>,
    /// Slopes of each at each knot.
    slopes: Vec<Vec<f64>>,
}

fn blending(at: &[usize]) -> Blending {
    let knots: Vec<f64> = at.iter().map(|k| *k as f64).collect();
    let n = knots.len();
    let slopes = (0..n)
        .map(|one| {
            slopes(&knots, &(0..n).map(|k| if k == one { 1.0 } else { 0.0 }).collect::<Vec<_>>())
        })
        .collect();
    Blending { knots, slopes }
}

/// Slopes at the knots of the twice differentiable cubic through values, with those of the parabola through three
/// values at both ends; of a straight line through two.
fn slopes(x: &[f64], y: &[f64]) -> Vec<f64> {
    let n = x.len();
    let h: Vec<f64> = x.windows(2).map(|w| w[1] - w[0]).collect();
    let rise: Vec<f64> = (0..n - 1).map(|k| (y[k + 1] - y[k]) / h[k]).collect();
    if n == 2 {
        return vec![rise[0]; 2];
    }
    let end = |a: usize, b: usize| rise[a] + (rise[a] - rise[b]) * h[a] / (h[a] + h[b]);
    let (mut m, mut upper) = (vec![end(0, 1); n], vec![0.0; n]);
    m[n - 1] = end(n - 2, n - 3);
    for k in 1..n - 1 {
        let (l, r) = (1.0 / h[k - 1], 1.0 / h[k]);
        let pivot = 2.0 * (l + r) - l * upper[k - 1];
        upper[k] = r / pivot;
        m[k] = (3.0 * (rise[k - 1] * l + rise[k] * r) - l * m[k - 1]) / pivot;
    }
    for k in (1..n - 1).rev() {
        m[k] -= upper[k] * m[k + 1];
    }
    m
}

impl Blending {
    /// Value and derivative of each at `s`, which lies between the first and the last knot.
    fn at(&self, s: f64) -> Vec<[f64; 2]> {
        let last = self.knots.len() - 2;
        let k = self.knots[1..=last].iter().filter(|x| **x <= s).count();
        let h = self.knots[k + 1] - self.knots[k];
        let t = (s - self.knots[k]) / h;
        let (value, slope) = (t * t * (3.0 - 2.0 * t), 6.0 * t * (1.0 - t) / h);
        let of = |(one, m): (usize, &Vec<f64>)| {
            let [y0, y1] = [k, k + 1].map(|i| if i == one { 1.0 } else { 0.0 });
            let (a, b) = (t * (1.0 - t) * (1.0 - t) * h, t * t * (t - 1.0) * h);
            let (da, db) = ((1.0 - t) * (1.0 - 3.0 * t), t * (3.0 * t - 2.0));
            [
                y0 + (y1 - y0) * value + m[k] * a + m[k + 1] * b,
                (y1 - y0) * slope + m[k] * da + m[k + 1] * db,
            ]
        };
        self.slopes.iter().enumerate().map(of).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::super::arc::CubicArc;
    use super::*;

    /// z over x and y, quadratic in each.
    fn z(x: f64, y: f64) -> f64 {
        0.3 * x * x - 0.2 * y * y * x + 0.1 * x * y + 0.05 * x * x * y * y
    }

    fn curve(at: impl Fn(f64) -> Vec3, joints: &[f64]) -> SpaceCurve {
        let slope = |t: f64| (at(t + 0.5) - at(t - 0.5)) * 1.0;
        let arc = |w: &[f64]| {
            let h = w[1] - w[0];
            CubicArc::hermite(at(w[0]), at(w[1]), slope(w[0]) * h, slope(w[1]) * h)
        };
        SpaceCurve::new(joints.windows(2).map(arc).collect())
    }

    /// Curves of a surface that is quadratic along each parameter give it back, in whatever sense and order they come.
    #[test]
    fn a_net_of_a_quadratic_surface_is_that_surface() {
        let (xs, ys) = ([0.0, 1.0, 2.0, 3.0, 4.0], [0.0, 1.0, 2.0, 3.0]);
        let along = |y: f64| curve(move |x| Vec3::new(x, y, z(x, y)), &xs);
        let across = |x: f64| curve(move |y| Vec3::new(x, y, z(x, y)), &ys);
        let turned = |x: f64| {
            let back: Vec<f64> = ys.iter().map(|y| 3.0 - y).rev().collect();
            curve(move |t| Vec3::new(x, 3.0 - t, z(x, 3.0 - t)), &back)
        };
        let rows = [0.0, 1.0, 3.0].map(along);
        for columns in [
            vec![across(0.0), across(2.0), across(3.0), across(4.0)],
            vec![across(4.0), turned(2.0), across(0.0)],
        ] {
            let s = network(&rows, &columns).unwrap();
            assert_eq!(s.spans().map(super::super::whole), [4, 3]);
            for k in 0..=40 {
                let (u, v) = (0.1 * f64::from(k), 3.0 - 0.075 * f64::from(k));
                let d = s.at(u, v);
                assert!((d.point - Vec3::new(u, v, z(u, v))).norm() < 1e-7, "{u} {v} {}", d.point);
            }
        }
    }

    /// All curves lie in the surface, whatever their course between the joints, and it bends without a crease.
    #[test]
    fn all_curves_of_a_net_lie_in_it() {
        let f = |x: f64, y: f64| crate::trig::sin(1.3 * x) + 0.5 * crate::trig::cos(x - 1.7 * y);
        let joints = [0.0, 1.0, 2.0];
        let smooth = |g: &dyn Fn(f64) -> Vec3| {
            let slope = |t: f64| (g(t + 1e-5) - g(t - 1e-5)) / 2e-5;
            let arc = |w: &[f64]| CubicArc::hermite(g(w[0]), g(w[1]), slope(w[0]), slope(w[1]));
            SpaceCurve::new(joints.windows(2).map(arc).collect())
        };
        let rows = joints.map(|y| smooth(&|x| Vec3::new(x, y, f(x, y))));
        let columns = joints.map(|x| smooth(&|y| Vec3::new(x, y, f(x, y))));
        let s = network(&rows, &columns).unwrap();
        for k in 0..=50 {
            let t = 0.04 * f64::from(k);
            for (j, at) in joints.iter().enumerate() {
                assert!((s.at(t, *at).point - rows[j].at_flow(t).point).norm() < 1e-5);
                assert!((s.at(*at, t).point - columns[j].at_flow(t).point).norm() < 1e-5);
            }
            let (a, b) = (s.at(1.0 - 1e-7, t), s.at(1.0 + 1e-7, t));
            assert!(a.normal().unwrap().cross(&b.normal().unwrap()).norm() < 1e-5, "{t}");
        }
    }

    #[test]
    fn what_is_no_net_is_refused() {
        let line = |a: [f64; 3], b: [f64; 3]| {
            let (a, b) = (Vec3::from(a), Vec3::from(b));
            let m = (a + b) * 0.5;
            SpaceCurve::new(vec![CubicArc::line(a, m), CubicArc::line(m, b)])
        };
        let rows = [0.0, 1.0, 2.0].map(|y| line([0.0, y, 0.0], [2.0, y, 0.0]));
        let column = |x: f64, z: f64| line([x, 0.0, z], [x, 2.0, z]);
        let net = |all: &[SpaceCurve]| network(&rows, all).map(|s| s.spans());
        assert_eq!(net(&[0.0, 1.0, 2.0].map(|x| column(x, 0.0))), Ok([2.0, 2.0]));
        // Aside, not at the ends, between joints, of another number of segments.
        let aside = [column(0.0, 0.0), column(1.0, 0.1), column(2.0, 0.0)];
        assert_eq!(net(&aside), Err(LoftFault::Apart(0, 1)));
        let open = [column(0.0, 0.0), column(1.0, 0.0)];
        assert_eq!(net(&open), Err(LoftFault::Cross));
        let between = [column(0.0, 0.0), column(0.6, 0.0), column(2.0, 0.0)];
        assert_eq!(net(&between), Err(LoftFault::Apart(0, 1)));
        let mut short = [0.0, 1.0, 2.0].map(|x| column(x, 0.0));
        short[2].arcs.pop();
        assert_eq!(net(&short), Err(LoftFault::UnevenCross(2)));
    }
}
