//! The nearest place about an edge: where the way downhill comes to an edge it goes on along that, and into the faces beside it.
//!
//! Across an edge the derivatives jump: a step of Newton's method leads from one face to the other and back, and the way ends beside
//! the edge wherever it first comes to it.

use super::edges::Beside;
use super::sculptured::Spans;
use super::{ParametricSurface, Placed};
use crate::Vec3;

/// Cosine between the way to the point and a derivative below which a place is a nearest one as far as that goes.
const STATIONARY: f64 = 1e-7;
/// Share of the parameters beside an edge up to which a way downhill may have come to it.
const NEAR: f64 = 1e-2;
/// Share of the parameters by which a way begins in the face beside an edge.
const INTO: f64 = 1e-9;
/// Edges and faces that one way leads over.
const TURNS: usize = 8;
/// Steps along an edge, and how often one is halved.
const STEPS: usize = 40;
const HALVINGS: usize = 20;

impl ParametricSurface {
    /// The place next to `p` to which the way leads from one `found` by `run`, which goes downhill on the faces alone; each with the
    /// square of its distance.
    pub(super) fn over_creases(
        &self,
        spans: &Spans,
        p: Vec3,
        mut found: (f64, Placed),
        run: impl Fn([f64; 2]) -> (f64, Placed),
    ) -> (f64, Placed) {
        let noise = |square: f64| 16.0 * f64::EPSILON * (self.extent + p.norm()) * square.sqrt();
        let nearer = |one: f64, other: f64| one < other - noise(other);
        for _ in 0..TURNS {
            if spans.edges().is_empty() || is_stationary(p, &found.1) {
                break;
            }
            let Placed { u, v, .. } = found.1;
            let mut best = found;
            let beside = spans.edges().iter().filter_map(|edge| edge.sides_by([u, v], NEAR));
            for [side, other] in beside {
                let (square, t, place) = along(spans, side, p, [u, v]);
                // On an edge as near as the place beside it the faces are asked again.
                if square > best.0 + noise(best.0) {
                    continue;
                }
                best = if nearer(square, best.0) { (square, place) } else { best };
                for face in [side, other] {
                    let (at, _) = face.jet(spans, t);
                    let next = run([0, 1].map(|k| at[k] + INTO * face.inwards()[k]));
                    best = if nearer(next.0, best.0) { next } else { best };
                }
            }
            if !nearer(best.0, found.0) {
                break;
            }
            found = best;
        }
        found
    }
}

/// Does the way to `p` stand square to the surface at a place?
fn is_stationary(p: Vec3, Placed { jet, .. }: &Placed) -> bool {
    let w = jet.s - p;
    let level = |d: Vec3| w.dot(&d).abs() <= STATIONARY * w.norm() * d.norm();
    level(jet.su) && level(jet.sv)
}

/// The place of an edge next to `p` to which the way leads along it from beside a place with these parameters: the square of its
/// distance and the share of the edge's length before it.
fn along(spans: &Spans, side: &Beside, p: Vec3, uv: [f64; 2]) -> (f64, f64, Placed) {
    let (by, look) = (side.by(), |t: f64| {
        let ([u, v], jet) = side.jet(spans, t);
        ((jet.s - p).norm_squared(), Placed { u, v, jet })
    });
    let mut t = side.share(uv).clamp(0.0, 1.0);
    let mut now = look(t);
    for _ in 0..STEPS {
        let jet = &now.1.jet;
        let d = jet.su * by[0] + jet.sv * by[1];
        let bend =
            jet.suu * (by[0] * by[0]) + jet.suv * (2.0 * by[0] * by[1]) + jet.svv * (by[1] * by[1]);
        let (w, size) = (jet.s - p, d.norm_squared());
        let turn = size + w.dot(&bend);
        let step = -w.dot(&d) / if turn > 0.1 * size { turn } else { size };
        let mut to = (t + step).clamp(0.0, 1.0);
        if !to.is_finite() {
            break;
        }
        let mut next = look(to);
        for _ in 0..HALVINGS {
            if next.0 <= now.0 {
                break;
            }
            to = 0.5 * (t + to);
            next = look(to);
        }
        if next.0 > now.0 {
            break;
        }
        let went = (to - t).abs();
        (t, now) = (to, next);
        if went <= f64::EPSILON {
            break;
        }
    }
    (now.0, t, now.1)
}
