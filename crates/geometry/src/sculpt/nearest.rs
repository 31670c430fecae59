//! Places of a surface that are nearest to a point, or on a line.

use super::patch::Derivatives;
use super::surface::Sculptured;
use crate::Vec3;

/// A place found on a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfaceHit {
    /// Parameters of the whole surface.
    pub uv: [f64; 2],
    /// Point and derivatives there, by the surface's parameters.
    pub at: Derivatives,
    /// Distance from the point asked for; along a line the signed distance in its direction.
    pub distance: f64,
}

/// Samples a patch and side from which a search begins.
const STARTS: usize = 6;
/// Newton's steps of a search.
const STEPS: usize = 40;

/// The place of the surface nearest to `p`; of the border where no normal meets `p`.
pub fn nearest_on(s: &Sculptured, p: Vec3) -> SurfaceHit {
    let mut best: Option<SurfaceHit> = None;
    for (index, patch) in s.patches.iter().enumerate() {
        let [lo, hi] = patch.bounds();
        let outside = (p - p.sup(&lo).inf(&hi)).norm();
        if best.is_some_and(|b| b.distance < outside) {
            continue;
        }
        for (u, v) in starts() {
            let start = patch.at(u, v).point;
            // A start much farther than what is known leads there by another patch or start.
            if best.is_some_and(|b| (start - p).norm() > b.distance + (hi - lo).norm() / 3.0) {
                continue;
            }
            let [u, v] = descend(|u, v| patch.at(u, v), p, [u, v], [1.0; 2]);
            let at = patch.at(u, v);
            let distance = (at.point - p).norm();
            if best.is_none_or(|b| distance < b.distance) {
                let uv = s.global(index, u, v);
                best = Some(SurfaceHit { uv, at: s.at(uv[0], uv[1]), distance });
            }
        }
    }
    // A surface has at least one patch, and a patch a first start.
    best.unwrap_or(SurfaceHit { uv: [0.0; 2], at: s.at(0.0, 0.0), distance: f64::INFINITY })
}

fn starts() -> impl Iterator<Item = (f64, f64)> {
    let t = |k: usize| (k as f64 + 0.5) / STARTS as f64;
    (0..STARTS * STARTS).map(move |k| (t(k % STARTS), t(k / STARTS)))
}

/// The place to which the distance from `p` falls from a place of the surface: the nearest about it, which need be no nearest of all.
pub fn nearest_from(s: &Sculptured, p: Vec3, uv: [f64; 2]) -> SurfaceHit {
    let uv = descend(|u, v| s.at(u, v), p, uv, s.spans());
    let at = s.at(uv[0], uv[1]);
    SurfaceHit { uv, at, distance: (at.point - p).norm() }
}

/// Descent to the nearest point with parameters from 0 to these ends: Newton's step where it descends, else the
/// projection on the tangent plane, halved until the distance falls.
fn descend(
    f: impl Fn(f64, f64) -> Derivatives,
    p: Vec3,
    start: [f64; 2],
    ends: [f64; 2],
) -> [f64; 2] {
    let [mut u, mut v] = start;
    let mut d = f(u, v);
    for _ in 0..STEPS {
        let w = d.point - p;
        let value = w.norm_squared();
        let (gu, gv) = (w.dot(&d.u), w.dot(&d.v));
        let (free_u, free_v) = (
            !(u <= 0.0 && gu > 0.0 || u >= ends[0] && gu < 0.0),
            !(v <= 0.0 && gv > 0.0 || v >= ends[1] && gv < 0.0),
        );
        let (auu, auv, avv) = (
            d.u.dot(&d.u) + w.dot(&d.uu),
            d.u.dot(&d.v) + w.dot(&d.uv),
            d.v.dot(&d.v) + w.dot(&d.vv),
        );
        let step = match (free_u, free_v) {
            (true, true) => {
                let det = auu * avv - auv * auv;
                if auu > 0.0 && det > 1e-12 * auu * avv.abs() {
                    Some([(auv * gv - avv * gu) / det, (auv * gu - auu * gv) / det])
                } else {
                    d.components(-w)
                }
            }
            (true, false) => Some([-gu / if auu > 0.0 { auu } else { d.u.dot(&d.u) }, 0.0]),
            (false, true) => Some([0.0, -gv / if avv > 0.0 { avv } else { d.v.dot(&d.v) }]),
            (false, false) => None,
        };
        let Some([mut du, mut dv]) = step else { break };
        if !du.is_finite() || !dv.is_finite() {
            break;
        }
        let mut moved = false;
        for _ in 0..30 {
            let (a, b) = ((u + du).clamp(0.0, ends[0]), (v + dv).clamp(0.0, ends[1]));
            let e = f(a, b);
            if (e.point - p).norm_squared() < value {
                moved = (a - u).abs() + (b - v).abs() > 1e-16;
                (u, v, d) = (a, b, e);
                break;
            }
            du *= 0.5;
            dv *= 0.5;
        }
        if !moved {
            break;
        }
    }
    [u, v]
}

/// All places where the line through `p` along `d` meets the surface, by rising distance along `d`.
pub fn along_line(s: &Sculptured, p: Vec3, d: Vec3) -> Vec<SurfaceHit> {
    let Some(d) = d.try_normalize(0.0) else { return Vec::new() };
    let frame = crate::surface::frame_about(d);
    let mut hits: Vec<SurfaceHit> = Vec::new();
    let size = s.extent() + p.norm();
    for (index, patch) in s.patches.iter().enumerate() {
        let [lo, hi] = patch.bounds();
        let (mid, r) = ((lo + hi) * 0.5, (hi - lo).norm() * 0.5);
        let off = mid - p;
        if (off - d * d.dot(&off)).norm() > r * (1.0 + 1e-9) {
            continue;
        }
        for (u, v) in starts() {
            let Some([u, v]) = meet(|u, v| patch.at(u, v), p, frame, [u, v], size) else {
                continue;
            };
            let uv = s.global(index, u, v);
            let at = s.at(uv[0], uv[1]);
            let known = hits.iter().any(|h| (h.at.point - at.point).norm() <= 1e-7 * size);
            if !known {
                hits.push(SurfaceHit { uv, at, distance: d.dot(&(at.point - p)) });
            }
        }
    }
    hits.sort_by(|a, b| a.distance.total_cmp(&b.distance));
    hits
}

/// Newton's iteration to the line, kept to the neighbourhood of the unit square.
fn meet(
    f: impl Fn(f64, f64) -> Derivatives,
    p: Vec3,
    [a, b]: [Vec3; 2],
    start: [f64; 2],
    size: f64,
) -> Option<[f64; 2]> {
    const OVER: f64 = 1e-9;
    let [mut u, mut v] = start;
    for _ in 0..STEPS {
        let d = f(u, v);
        let w = d.point - p;
        let (e, g) = (w.dot(&a), w.dot(&b));
        let (eu, ev, gu, gv) = (d.u.dot(&a), d.v.dot(&a), d.u.dot(&b), d.v.dot(&b));
        if e.abs().max(g.abs()) <= 1e-13 * size {
            let inside = |t: f64| (-OVER..=1.0 + OVER).contains(&t);
            return (inside(u) && inside(v)).then(|| [u.clamp(0.0, 1.0), v.clamp(0.0, 1.0)]);
        }
        let det = eu * gv - ev * gu;
        if det.abs() <= 1e-14 * (eu.abs() + ev.abs()) * (gu.abs() + gv.abs()) || det == 0.0 {
            return None;
        }
        let (du, dv) = ((ev * g - gv * e) / det, (gu * e - eu * g) / det);
        let cap = (0.4 / du.abs().max(dv.abs())).min(1.0);
        u = (u + du * cap).clamp(-0.1, 1.1);
        v = (v + dv * cap).clamp(-0.1, 1.1);
    }
    None
}

#[cfg(test)]
mod tests {
    use super::super::{mesh, spline::SplinePoint};
    use super::*;

    fn surface() -> Sculptured {
        let at = |x: f64, y: f64| SplinePoint::plain(Vec3::new(x, y, 0.1 * x * x - 0.2 * y * y));
        let row = |j: usize| (0..5).map(|i| at(i as f64 - 2.0, j as f64 - 2.0)).collect::<Vec<_>>();
        mesh(&(0..5).map(row).collect::<Vec<_>>(), crate::sculptured::MeshSpacing::Xyz).unwrap()
    }

    #[test]
    fn the_nearest_point_beats_a_grid() {
        let s = surface();
        for k in 0..20 {
            let f = f64::from(k);
            let p = Vec3::new(
                3.0 * crate::trig::sin(f),
                2.5 * crate::trig::cos(1.7 * f),
                2.0 * crate::trig::sin(0.9 * f),
            );
            let hit = nearest_on(&s, p);
            let mut least = f64::INFINITY;
            for i in 0..=200 {
                for j in 0..=200 {
                    let q = s.at(f64::from(i) * 0.02, f64::from(j) * 0.02).point;
                    least = least.min((q - p).norm());
                }
            }
            assert!(hit.distance <= least + 1e-12, "{k}: {} {least}", hit.distance);
            assert!(least - hit.distance < 0.01);
        }
    }

    #[test]
    fn a_place_near_by_leads_to_the_nearest_one() {
        let s = surface();
        let d = s.at(2.4, 1.7);
        let p = d.point + d.u.cross(&d.v).normalize() * 0.05;
        // Over borders of patches, and from a corner along two sides.
        for start in [[2.4, 1.7], [1.3, 2.9], [3.9, 0.2]] {
            let (near, all) = (nearest_from(&s, p, start), nearest_on(&s, p));
            assert!((near.at.point - all.at.point).norm() < 1e-9, "{near:?} {all:?}");
            assert!((near.distance - 0.05).abs() < 1e-9);
        }
        let corner = nearest_from(&s, s.at(4.0, 4.0).point + Vec3::new(9.0, 9.0, 0.0), [2.0, 2.0]);
        assert!(corner.uv.iter().all(|t| (t - 4.0).abs() < 1e-12), "{corner:?}");
    }

    #[test]
    fn a_line_meets_a_saddle_twice() {
        let s = surface();
        let hits = along_line(&s, Vec3::new(0.1, -5.0, -0.3), Vec3::y());
        assert_eq!(hits.len(), 2);
        for h in &hits {
            assert!((h.at.point.x - 0.1).abs() < 1e-11 && (h.at.point.z + 0.3).abs() < 1e-11);
        }
        assert!(along_line(&s, Vec3::new(50.0, 0.0, 0.0), Vec3::z()).is_empty());
    }
}
