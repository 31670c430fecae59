//! GENCUR: a surface through curves.

use super::curve::SpaceCurve;
use super::patch::Patch;
use super::spline::{SplineFault, SplinePoint, tangents};
use super::surface::{Layout, SculptFault, Sculptured};
use crate::Vec3;

/// Why curves make no surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LoftFault {
    /// Fewer than two curves.
    TooFew,
    /// This curve (counted from 0) has another number of segments, or of arcs without flow, than the first.
    Uneven(usize),
    /// The tangents across cannot be found.
    Across(SplineFault),
    /// Curves across do not meet all curves at the same joints in one order, the first and the last at the ends.
    Cross,
    /// This curve across (counted from 0) has another number of segments than the first.
    UnevenCross(usize),
    /// This curve, and this one across (counted from 0), do not meet at joints of both.
    Apart(usize, usize),
    /// The curves make no surface.
    Surface(SculptFault),
}

/// Patches a span along u where curves are not followed exactly by one.
pub(super) const FINE: usize = 8;

/// The surface through `curves`: u runs along them by their flow, v from one to the next. Two curves make a
/// ruled surface; more are joined at every u by the twice differentiable cubic over the chords, its
/// tangents as long as the mean chord of their span at the joints.
///
/// Curves with flow, and more than two curves, are followed by bicubic patches, eight a span and one
/// more at every joint of an arc. Curves across make a net of them: see `network`.
pub fn loft(curves: &[SpaceCurve], cross: &[SpaceCurve]) -> Result<Sculptured, LoftFault> {
    let Some(first) = curves.first() else { return Err(LoftFault::TooFew) };
    if curves.len() < 2 {
        return Err(LoftFault::TooFew);
    }
    if let Some(i) = curves.iter().position(|c| c.segments() != first.segments()) {
        return Err(LoftFault::Uneven(i));
    }
    if !cross.is_empty() {
        let single = |c: &SpaceCurve| c.segments() == 1;
        let four = curves.len() == 2 && cross.len() == 2;
        return if four && curves.iter().chain(cross).all(single) {
            between_four(curves, cross)
        } else if cross.len() < 2 {
            Err(LoftFault::Cross)
        } else {
            super::network::network(curves, cross)
        };
    }
    if curves.len() == 2 && curves.iter().all(|c| c.flow.is_none()) {
        return super::cross::ruled(&curves[0], &curves[1]).map_err(LoftFault::Surface);
    }
    let knots = knots(curves);
    let lengths = mean_chords(curves);
    let across = |s: f64| -> Result<Vec<Vec3>, LoftFault> {
        let t = unit_tangents(curves, s)?;
        let last = lengths.len() - 1;
        Ok(t.into_iter().enumerate().map(|(j, t)| t * lengths[j.min(last)]).collect())
    };
    let rows = curves.len();
    let mut columns = Vec::with_capacity(knots.len());
    for &s in &knots {
        columns.push((at_knot(curves, s), across(s)?));
    }
    let mut patches = vec![None; (knots.len() - 1) * (rows - 1)];
    for i in 0..knots.len() - 1 {
        let (a, b) = (knots[i], knots[i + 1]);
        let h = b - a;
        let e = h * 1e-4;
        // Tangents across just inside, for the twists.
        let (na, nb) = (across(a + e)?, across(b - e)?);
        let ends = [&columns[i], &columns[i + 1]];
        for j in 0..rows - 1 {
            let p = |k: usize, l: usize| ends[k].0[j + l].0;
            let u = |k: usize, l: usize| ends[k].0[j + l].1[1 - k] * h;
            // The tangent at the end of this span is as long as this span's chords.
            let scaled =
                |t: Vec3, l: usize| t * (lengths[j] / lengths[(j + l).min(lengths.len() - 1)]);
            let v = |k: usize, l: usize| scaled(ends[k].1[j + l], l);
            let twist = |l: usize| {
                let d0 = (scaled(na[j + l], l) - v(0, l)) * (h / e);
                let d1 = (v(1, l) - scaled(nb[j + l], l)) * (h / e);
                [d0, d1]
            };
            let row = |l: usize| [p(0, l), p(1, l), u(0, l), u(1, l)];
            let side = |l: usize| {
                let [t0, t1] = twist(l);
                [v(0, l), v(1, l), t0, t1]
            };
            patches[j * (knots.len() - 1) + i] =
                Some(Patch::hermite([row(0), row(1), side(0), side(1)]));
        }
    }
    let v = (0..rows).map(|j| j as f64).collect();
    let patches = patches.into_iter().flatten().collect();
    Sculptured::checked(patches, Layout::Mesh { u: knots, v }).map_err(LoftFault::Surface)
}

/// Points of the curves at `s` of their flow, with the derivatives before and behind it.
fn at_knot(curves: &[SpaceCurve], s: f64) -> Vec<(Vec3, [Vec3; 2])> {
    const BESIDE: f64 = 1e-9;
    let of = |c: &SpaceCurve| {
        let before = c.at_flow(s - BESIDE).first;
        let behind = c.at_flow(s + BESIDE).first;
        (c.at_flow(s).point, [before, behind])
    };
    curves.iter().map(of).collect()
}

fn unit_tangents(curves: &[SpaceCurve], s: f64) -> Result<Vec<Vec3>, LoftFault> {
    let points: Vec<SplinePoint> = curves
        .iter()
        .map(|c| {
            let f = s / c.flow_span();
            let cross = match c.cross {
                [Some(a), Some(b)] => Some(a.normalize() * (1.0 - f) + b.normalize() * f),
                _ => None,
            };
            SplinePoint { tangent: cross, ..SplinePoint::plain(c.at_flow(s).point) }
        })
        .collect();
    if points.len() == 2 && points.iter().all(|p| p.tangent.is_none()) {
        let d = points[1].point - points[0].point;
        return Ok(vec![d.try_normalize(0.0).unwrap_or_else(Vec3::zeros); 2]);
    }
    tangents(&points).map_err(LoftFault::Across)
}

/// Mean distance from each curve to the next over the joints of the segments.
fn mean_chords(curves: &[SpaceCurve]) -> Vec<f64> {
    let joints = curves[0].segments() + 1;
    let mean = |a: &SpaceCurve, b: &SpaceCurve| {
        let gap = |k: usize| (b.at_flow(k as f64).point - a.at_flow(k as f64).point).norm();
        (0..joints).map(gap).sum::<f64>() / joints as f64
    };
    curves.windows(2).map(|w| mean(&w[0], &w[1])).collect()
}

/// Parameters along u between which one patch follows the curves.
pub(super) fn knots(curves: &[SpaceCurve]) -> Vec<f64> {
    let spans = curves[0].segments();
    let mut all: Vec<f64> = (0..=spans * FINE).map(|k| k as f64 / FINE as f64).collect();
    for c in curves {
        let Some(flow) = &c.flow else { continue };
        for joint in 1..c.arcs.len() {
            if let Some(s) = flow_at(c, flow.segments.len() as f64, joint as f64) {
                all.push(s);
            }
        }
    }
    all.sort_by(f64::total_cmp);
    let mut kept: Vec<f64> = Vec::with_capacity(all.len());
    for s in all {
        match kept.last_mut() {
            Some(last) if s - *last < 1e-6 => {
                // Whole numbers stay as they are.
                if s.fract() == 0.0 {
                    *last = s;
                }
            }
            _ => kept.push(s),
        }
    }
    kept
}

/// Where the flow reaches the parameter `t`, by bisection; the parameter rises with the flow.
fn flow_at(c: &SpaceCurve, span: f64, t: f64) -> Option<f64> {
    let flow = c.flow.as_ref()?;
    let (mut lo, mut hi) = (0.0, span);
    for _ in 0..60 {
        let mid = 0.5 * (lo + hi);
        if flow.parameter(c, mid).0 < t { lo = mid } else { hi = mid }
    }
    Some(0.5 * (lo + hi))
}

/// Two curves along and two across, each pair straight between: Coons' patch, followed by bicubic pieces.
fn between_four(curves: &[SpaceCurve], cross: &[SpaceCurve]) -> Result<Sculptured, LoftFault> {
    let ([c0, c1], [d0, d1]) = (curves, cross) else { return Err(LoftFault::Cross) };
    // Curves across run from the first curve to the second, as their ends say.
    let near = |a: Vec3, b: Vec3, c: Vec3| (a - b).norm() <= (a - c).norm();
    let across = |d: &SpaceCurve, s: f64, corner: Vec3| {
        if near(corner, d.start(), d.end()) {
            let p = d.at_flow(s);
            (p.point, p.first)
        } else {
            let p = d.at_flow(1.0 - s);
            (p.point, -p.first)
        }
    };
    let (k00, k10) = (c0.start(), c0.end());
    let turned = !near(k00, c1.start(), c1.end()) && near(k10, c1.start(), c1.end());
    let second = |s: f64| {
        if turned {
            let p = c1.at_flow(1.0 - s);
            (p.point, -p.first)
        } else {
            let p = c1.at_flow(s);
            (p.point, p.first)
        }
    };
    let (k01, k11) = (second(0.0).0, second(1.0).0);
    let n = FINE;
    let grid = |k: usize| k as f64 / n as f64;
    let at = |u: f64, v: f64| {
        let (a, b) = (c0.at_flow(u), second(u));
        let (c, d) = (across(d0, v, k00), across(d1, v, k10));
        let bilinear = k00 * ((1.0 - u) * (1.0 - v))
            + k10 * (u * (1.0 - v))
            + k01 * ((1.0 - u) * v)
            + k11 * (u * v);
        let point = a.point * (1.0 - v) + b.0 * v + c.0 * (1.0 - u) + d.0 * u - bilinear;
        let bu = (k10 - k00) * (1.0 - v) + (k11 - k01) * v;
        let bv = (k01 - k00) * (1.0 - u) + (k11 - k10) * u;
        let du = a.first * (1.0 - v) + b.1 * v - c.0 + d.0 - bu;
        let dv = b.0 - a.point + c.1 * (1.0 - u) + d.1 * u - bv;
        let uv = b.1 - a.first - c.1 + d.1 - (k11 - k01 - k10 + k00);
        [point, du, dv, uv]
    };
    let h = 1.0 / n as f64;
    let mut patches = Vec::with_capacity(n * n);
    for j in 0..n {
        for i in 0..n {
            let q = [
                at(grid(i), grid(j)),
                at(grid(i + 1), grid(j)),
                at(grid(i), grid(j + 1)),
                at(grid(i + 1), grid(j + 1)),
            ];
            let row = |k: usize| [q[k][0], q[k + 1][0], q[k][1] * h, q[k + 1][1] * h];
            let side =
                |k: usize| [q[k][2] * h, q[k + 1][2] * h, q[k][3] * h * h, q[k + 1][3] * h * h];
            patches.push(Patch::hermite([row(0), row(2), side(0), side(2)]));
        }
    }
    let knots: Vec<f64> = (0..=n).map(grid).collect();
    Sculptured::checked(patches, Layout::Mesh { u: knots.clone(), v: knots })
        .map_err(LoftFault::Surface)
}

#[cfg(test)]
mod tests {
    use super::super::flow::{Flow, FlowKind, FlowSpan, SegmentKind, SegmentSpan};
    use super::super::spline::spline;
    use super::*;

    fn curve(p: &[[f64; 3]], by_chord: bool) -> SpaceCurve {
        let q: Vec<_> = p.iter().map(|p| SplinePoint::plain(Vec3::from(*p))).collect();
        let mut c = SpaceCurve::new(spline(&q).unwrap());
        if by_chord {
            let seg = |from, to| SegmentSpan { kind: SegmentKind::Length, from, to };
            c.flow = Some(Flow {
                spans: vec![FlowSpan { kind: FlowKind::Chord(Vec3::y()), from: 0, to: 5 }],
                segments: vec![seg(0, 2), seg(2, 3), seg(3, 5)],
            });
        }
        c
    }

    /// Surface YACH of TEST36: its corners and normals as printed.
    #[test]
    fn printed_normals_of_a_hull() {
        let hull = [
            [
                [0.0, 0.0, 0.0],
                [0.88, 0.6514, 0.097],
                [3.888, 1.738, 0.071],
                [4.9564, 2.0596, 0.064],
                [7.2742, 3.4, 0.101],
                [9.78, 5.615, 0.107],
            ],
            [
                [3.5418, 0.2264, 1.192],
                [3.477, 0.784, 1.0035],
                [5.19, 1.864, 0.301],
                [5.9186, 2.1442, 0.183],
                [7.901, 3.422, 0.2065],
                [9.992, 5.5044, 0.1875],
            ],
            [
                [8.3472, 0.4436, 1.776],
                [8.5136, 1.059, 1.691],
                [8.8366, 1.959, 0.6035],
                [8.8966, 2.148, 0.454],
                [9.5088, 3.4068, 0.351],
                [10.8694, 5.5146, 0.247],
            ],
        ];
        let curves: Vec<_> = hull.iter().map(|r| curve(r, true)).collect();
        let s = loft(&curves, &[]).unwrap();
        assert_eq!(s.spans().map(super::super::whole), [3, 2]);
        let p = s.at(2.0, 1.0);
        assert!((p.point - Vec3::new(5.9186, 2.1442, 0.183)).norm() < 1e-9);
        // The patches follow the curves, and derivatives are those of the flow.
        for t in [0.3, 1.2, 1.9, 2.6] {
            let c = curves[1].at_flow(t);
            assert!((s.at(t, 1.0).point - c.point).norm() < 2e-3, "{t}");
        }
        // Differentiable across the middle curve.
        let (a, b) = (s.at(1.37, 1.0 - 1e-7), s.at(1.37, 1.0 + 1e-7));
        let angle = a.v.normalize().cross(&b.v.normalize()).norm();
        assert!(angle < 1e-5, "{angle}");
    }

    #[test]
    fn four_sides_are_met() {
        let c0 = curve(&[[0.0, 0.0, 0.0], [2.0, 0.0, 0.5]], false);
        let c1 = curve(&[[0.0, 3.0, 0.2], [2.0, 3.0, 0.1]], false);
        let mut bow = [SplinePoint::plain(Vec3::zeros()), SplinePoint::plain(c1.start())];
        bow[0].tangent = Some(Vec3::new(0.0, 1.0, 1.0));
        let d0 = SpaceCurve::new(spline(&bow).unwrap());
        let d1 = curve(&[[2.0, 3.0, 0.1], [2.0, 0.0, 0.5]], false);
        let s = loft(&[c0.clone(), c1], &[d0.clone(), d1]).unwrap();
        assert!((s.at(0.3, 0.0).point - c0.at(0.3).point).norm() < 1e-12);
        for v in [0.25, 0.5, 0.875] {
            assert!((s.at(0.0, v).point - d0.at(v).point).norm() < 1e-12, "{v}");
        }
        assert_eq!(loft(core::slice::from_ref(&c0), &[]).unwrap_err(), LoftFault::TooFew);
        assert_eq!(loft(&[c0.clone(), c0.clone()], &[d0]).unwrap_err(), LoftFault::Cross);
    }
}
