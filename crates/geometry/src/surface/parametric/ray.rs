//! Where a straight line pierces a surface (APT: `ADDSTR`).

use super::{MAX_STEPS, ParametricSurface, Patch, Placed};
use crate::surface::{EPS_LEN, frame_about};
use crate::{Reason, Vec2, Vec3};

impl ParametricSurface {
    /// Directed distances along the unit direction `d`, rising.
    ///
    /// APT: `ADDSTR`.
    pub fn ray(&self, p: Vec3, d: Vec3) -> Result<Vec<f64>, Reason> {
        let [a, b] = frame_about(d);
        let mut all: Vec<f64> = Vec::new();
        if let Patch::Sculptured(spans) = &self.patch {
            let mut put = |u: f64, v: f64| {
                all.extend(self.pierce(u, v, [a, b], p).map(|s| (s - p).dot(&d)));
            };
            spans.cells().met(p, d, |patch, u, v| spans.jet_of(patch, u, v), &mut put);
        }
        let flat = |s: Vec3| Vec2::new((s - p).dot(&a), (s - p).dot(&b));
        let points: Vec<Vec2> = self.working_grid().map(flat).collect();
        let (us, vs) = (&self.samples.us, &self.samples.vs);
        let n = vs.len();
        for i in 0..us.len().saturating_sub(1) {
            for j in 0..n - 1 {
                let corners = [(i, j), (i, j + 1), (i + 1, j), (i + 1, j + 1)];
                let around = |axis: usize| {
                    let x = corners.map(|(i, j)| points[i * n + j][axis]);
                    let (low, high) = x.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |m, x| {
                        (m.0.min(*x), m.1.max(*x))
                    });
                    let slack = 0.5 * (high - low);
                    low - slack <= 0.0 && high + slack >= 0.0
                };
                if !(around(0) && around(1)) {
                    continue;
                }
                let (u, v) = (0.5 * (us[i] + us[i + 1]), 0.5 * (vs[j] + vs[j + 1]));
                if let Some(s) = self.pierce(u, v, [a, b], p) {
                    all.push((s - p).dot(&d));
                }
            }
        }
        all.sort_by(f64::total_cmp);
        let same = 1e-7 * (self.extent + p.norm());
        all.dedup_by(|x, y| (*x - *y).abs() <= same);
        if !all.is_empty() {
            return Ok(all);
        }
        let on = self.foot(p).distance.abs() <= EPS_LEN * (self.extent + p.norm());
        Err(if on { Reason::AllHit } else { Reason::NoHit })
    }

    /// The place where the line through `p` across the frame pierces, from a place near it.
    fn pierce(&self, u: f64, v: f64, [a, b]: [Vec3; 2], p: Vec3) -> Option<Vec3> {
        let domain = self.patch.domain();
        let (mut u, mut v) = (u, v);
        let enough = 1e-13 * (self.extent + p.norm());
        for _ in 0..MAX_STEPS {
            let (s, [su, sv]) = self.working(&Placed::new(&self.patch, u, v));
            let w = s - p;
            let (x, y) = (w.dot(&a), w.dot(&b));
            if x.abs().max(y.abs()) <= enough {
                return Some(s);
            }
            let (xu, xv, yu, yv) = (su.dot(&a), sv.dot(&a), su.dot(&b), sv.dot(&b));
            let det = xu * yv - xv * yu;
            let (du, dv) = ((xv * y - yv * x) / det, (yu * x - xu * y) / det);
            if !(du.is_finite() && dv.is_finite()) {
                return None;
            }
            let shorter = 0.5 / du.abs().max(0.2 * dv.abs()).max(0.5);
            let (nu, nv) = (domain.clamp_u(u + du * shorter), domain.clamp_v(v + dv * shorter));
            if (nu - u).abs() <= 1e-16 && (nv - v).abs() <= 1e-16 * (1.0 + v.abs()) {
                return (x.abs().max(y.abs()) <= 1e3 * enough).then_some(s);
            }
            (u, v) = (nu, nv);
        }
        None
    }
}
