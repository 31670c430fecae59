//! The nearest point of a surface: Newton's method from the lowest of the samples, of a sculptured surface over its cells.

use super::sculptured::Spans;
use super::{Domain, Jet, MAX_STEPS, ParametricSurface, Patch, Placed};
use crate::Vec3;

/// Share of the surface's size that rounding may change of a distance.
const NOISE: f64 = 1e-14;
/// Share of the surface's size below which the square of a step of Newton's method is rounding.
const NEAR: f64 = 1e-9;
/// The same of a step at whose end a smooth surface is as its derivatives at the start tell.
const BESIDE: f64 = 3e-7;
/// Seams and poles that a way downhill may cross.
const CROSSINGS: usize = 4;
/// Share of the surface's size by which two places lie apart.
const SAME: f64 = 1e-6;

impl ParametricSurface {
    /// Distance of the second nearest of the places into which the samples run downhill, of a sculptured surface of
    /// all dips; at most `limit`.
    pub fn rival(&self, p: Vec3, limit: f64) -> f64 {
        let Some(nearest) = self.nearest(p) else { return limit };
        let apart = SAME * self.extent;
        let other = |place: &Placed| (place.jet.s - nearest.jet.s).norm() > apart;
        if let Patch::Sculptured(spans) = &self.patch {
            let jet = |patch, u, v| spans.jet_of(patch, u, v);
            let dip =
                |u, v| Some(self.descend_free(p, [u, v])).filter(|(_, d)| other(d)).map(|(d, _)| d);
            return spans.cells().rival(p, limit, jet, self.descending(spans, p), dip);
        }
        let places = self.samples.seeds(&self.patch, p).into_iter().flatten();
        let places = places.map(|s| self.descend_free(p, [s.u, s.v]));
        let others = places.filter(|(_, place)| other(place));
        let distance = |square: f64| (square.sqrt() - self.rise.abs()).max(0.0);
        others.map(|(square, _)| distance(square)).fold(limit, f64::min)
    }

    /// The nearest point: Newton's method from the lowest samples, or over the cells.
    pub(super) fn nearest(&self, p: Vec3) -> Option<Placed> {
        if let Patch::Sculptured(spans) = &self.patch {
            return self.over_cells(spans, p);
        }
        let mut best: Option<(f64, Placed)> = None;
        for seed in self.samples.seeds(&self.patch, p).into_iter().flatten() {
            // No place is nearer than its sample by more than the samples are apart.
            if best.as_ref().is_some_and(|b| self.samples.least(&seed) > b.0.sqrt()) {
                continue;
            }
            let (square, place) = self.descend_free(p, [seed.u, seed.v]);
            if best.as_ref().is_none_or(|b| square < b.0) {
                best = Some((square, place));
            }
        }
        best.map(|b| b.1)
    }

    /// Of a sculptured surface the nearest point over its cells.
    fn over_cells(&self, spans: &Spans, p: Vec3) -> Option<Placed> {
        let jet = |patch, u, v| spans.jet_of(patch, u, v);
        let noise = NOISE * (self.extent + p.norm());
        spans.cells().nearest((p, noise), &spans.domain(), jet, self.descending(spans, p))
    }

    /// Of a sculptured surface the way downhill within a rectangle of the parameters, on one patch or all of them.
    fn descending<'a>(
        &'a self,
        spans: &'a Spans,
        p: Vec3,
    ) -> impl Fn(Option<[usize; 2]>, [f64; 2], &Domain) -> (f64, Placed) + 'a {
        move |patch, uv, within| match patch {
            Some(patch) => self.descend(p, uv, within, |u, v| spans.jet_of(patch, u, v)),
            None => self.descend(p, uv, within, |u, v| spans.jet(u, v)),
        }
    }

    /// Downhill over the whole surface, over its seams, poles and edges too.
    pub(super) fn descend_free(&self, p: Vec3, uv: [f64; 2]) -> (f64, Placed) {
        let domain = self.patch.domain();
        let run = |uv| self.descend(p, uv, &domain, |u, v| self.patch.jet(u, v));
        let mut found = run(uv);
        let Patch::Sculptured(spans) = &self.patch else { return found };
        // A way downhill crosses each seam and each pole once.
        for _ in 0..CROSSINGS {
            let Placed { u, v, jet } = found.1;
            let beyond = domain.fixed(u, v, &jet, p);
            let Some(over) = spans.beyond([u, v], beyond, p) else { break };
            let next = run(over);
            if next.0 >= found.0 {
                break;
            }
            found = next;
        }
        self.over_creases(spans, p, found, run)
    }

    /// Newton's method for the nearest point, kept in the rectangle; steps that do not lower the distance are
    /// halved.
    fn descend(
        &self,
        p: Vec3,
        [u, v]: [f64; 2],
        domain: &Domain,
        jet_at: impl Fn(f64, f64) -> Jet,
    ) -> (f64, Placed) {
        let (mut u, mut v) = (u, v);
        let mut jet = jet_at(u, v);
        let mut square = (jet.s - p).norm_squared();
        let tiny = 1e-15 * (self.extent + p.norm());
        for _ in 0..MAX_STEPS {
            let (du, dv) = step(&jet, p, domain.fixed(u, v, &jet, p));
            let moved = (jet.su * du + jet.sv * dv).norm();
            if moved <= tiny {
                break;
            }
            let to = [u + du, v + dv];
            if moved <= BESIDE * self.extent
                && !domain.border(to[0], to[1])
                && self.is_smooth_between([u, v], to)
            {
                ([u, v], jet) = (to, jet.beside(du, dv));
                square = (jet.s - p).norm_squared();
                break;
            }
            let mut factor = (0.5 / du.abs().max(1e-300)).min(1.0);
            let mut better = None;
            for _ in 0..30 {
                let (nu, nv) = (domain.clamp_u(u + factor * du), domain.clamp_v(v + factor * dv));
                let next = jet_at(nu, nv);
                let value = (next.s - p).norm_squared();
                // Near the end the distances agree to rounding, that of the coordinates, and the step tells.
                let size = self.extent + p.norm();
                let noise = 16.0 * f64::EPSILON * size * square.sqrt();
                if value < square || moved <= 1e-6 * size && value <= square + noise {
                    better = Some((nu, nv, next, value));
                    break;
                }
                factor *= 0.5;
            }
            let Some((nu, nv, next, value)) = better else { break };
            let stays = (nu - u).abs() <= 1e-16 && (nv - v).abs() <= 1e-16;
            (u, v, jet, square) = (nu, nv, next, value);
            // The method converges quadratically: after a step this small rounding alone is left.
            if stays || factor >= 1.0 && moved <= NEAR * self.extent {
                break;
            }
        }
        (square, Placed { u, v, jet })
    }
}

/// Newton's step towards the nearest point; parameters that are `fixed` stay.
fn step(jet: &Jet, p: Vec3, fixed: [bool; 2]) -> (f64, f64) {
    let w = jet.s - p;
    let (gu, gv) = (w.dot(&jet.su), w.dot(&jet.sv));
    let (e, f, g) = (jet.su.norm_squared(), jet.su.dot(&jet.sv), jet.sv.norm_squared());
    let (huu, huv, hvv) = (e + w.dot(&jet.suu), f + w.dot(&jet.suv), g + w.dot(&jet.svv));
    let alone = |grad: f64, h: f64, size: f64| {
        if size > 0.0 { -grad / if h > 1e-3 * size { h } else { size } } else { 0.0 }
    };
    match fixed {
        [true, true] => (0.0, 0.0),
        [true, false] => (0.0, alone(gv, hvv, g)),
        [false, true] => (alone(gu, huu, e), 0.0),
        [false, false] => {
            let det = huu * hvv - huv * huv;
            if huu > 0.0 && det > 1e-6 * e * g {
                ((huv * gv - hvv * gu) / det, (huv * gu - huu * gv) / det)
            } else {
                let det = e * g - f * f;
                if det > 1e-12 * e * g {
                    ((f * gv - g * gu) / det, (f * gu - e * gv) / det)
                } else {
                    (alone(gu, huu, e), alone(gv, hvv, g))
                }
            }
        }
    }
}
