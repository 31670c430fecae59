//! The gap by brute force: the least signed distance of points all over the cutter, refined about the best.
//!
//! It shares with `contact` what surfaces and cutters are, and nothing of how the gap is found.
#![allow(dead_code, reason = "each test program uses a part of it")]

use aptc_geometry::{Profile, Surface, Vec3, trig};

/// Samples of each piece of the profile and around the axis.
const ALONG: u32 = 6;
const AROUND: u32 = 24;

/// Least signed distance of the cutter's points from the surface, `sign` +1 or -1 for the side.
pub(crate) fn least(profile: &Profile, te: Vec3, ta: Vec3, surface: &Surface, sign: f64) -> f64 {
    lowest(profile, te, ta, |p| sign * surface.distance(p))
}

/// The least value of a function that is smooth but for a few edges at the cutter's points.
pub(crate) fn lowest(profile: &Profile, te: Vec3, ta: Vec3, of: impl Fn(Vec3) -> f64) -> f64 {
    let [u, v] = aptc_geometry::surface::frame_about(ta);
    let outline = Outline::new(profile);
    let top = f64::from(outline.length());
    let value = |s: f64, angle: f64| {
        // Through the axis to the other side.
        let (s, angle) = if s < 0.0 { (-s, angle + std::f64::consts::PI) } else { (s, angle) };
        let [rho, z] = outline.at(s.min(top));
        let (sin, cos) = trig::sin_cos(angle);
        of(te + (u * cos + v * sin) * rho + ta * z)
    };
    let turn = std::f64::consts::TAU / f64::from(AROUND);
    let mut found: Vec<(f64, f64, f64)> = Vec::new();
    for i in 0..=outline.length() * ALONG {
        let s = f64::from(i) / f64::from(ALONG);
        for k in 0..AROUND {
            let angle = turn * f64::from(k);
            found.push((value(s, angle), s, angle));
        }
    }
    found.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut starts: Vec<(f64, f64, f64)> = Vec::new();
    for f in found {
        let far = |o: &(f64, f64, f64)| {
            let apart = (o.2 - f.2).abs();
            (o.1 - f.1).abs() > 0.35 || apart.min(std::f64::consts::TAU - apart) > 2.1 * turn
        };
        if starts.iter().all(far) {
            starts.push(f);
        }
        if starts.len() == 3 {
            break;
        }
    }
    starts
        .into_iter()
        .map(|(g, s, angle)| compass(&value, g, s, angle, turn))
        .fold(f64::INFINITY, f64::min)
}

/// Downhill by shrinking steps in eight directions.
fn compass(value: &impl Fn(f64, f64) -> f64, g: f64, s: f64, angle: f64, turn: f64) -> f64 {
    let (mut g, mut s, mut angle) = (g, s, angle);
    let (mut ds, mut da) = (1.0 / f64::from(ALONG), turn);
    while ds > 1e-9 {
        let mut best = (g, s, angle);
        for (i, k) in [(1, 0), (-1, 0), (0, 1), (0, -1), (1, 1), (1, -1), (-1, 1), (-1, -1)] {
            let (s, a) = (s + f64::from(i) * ds, angle + f64::from(k) * da);
            let g = value(s, a);
            if g < best.0 {
                best = (g, s, a);
            }
        }
        if best.0 < g {
            (g, s, angle) = best;
        } else {
            (ds, da) = (0.5 * ds, 0.5 * da);
        }
    }
    g
}

/// The outline of the cutter: lower line, arc, upper line and top, one unit of `s` each; those of no length
/// are left out.
struct Outline {
    pieces: Vec<Piece>,
}

enum Piece {
    Line([f64; 2], [f64; 2]),
    Arc { center: [f64; 2], radius: f64, from: f64, to: f64 },
}

impl Outline {
    fn new(p: &Profile) -> Self {
        let [lower, upper] = p.joints();
        let rim = [p.top_radius(), p.height()];
        let c = p.corner();
        let angle = |q: [f64; 2]| trig::atan2(q[1] - c[1], q[0] - c[0]);
        let mut pieces = Vec::new();
        let line = |pieces: &mut Vec<Piece>, a: [f64; 2], b: [f64; 2]| {
            if (a[0] - b[0]).abs() + (a[1] - b[1]).abs() > 1e-9 * p.reach() {
                pieces.push(Piece::Line(a, b));
            }
        };
        line(&mut pieces, [0.0, p.bottom()], lower);
        if p.corner_radius() > 0.0 {
            let (from, to) = (angle(lower), angle(upper));
            pieces.push(Piece::Arc { center: c, radius: p.corner_radius(), from, to });
        }
        line(&mut pieces, upper, rim);
        line(&mut pieces, rim, [0.0, p.height()]);
        Self { pieces }
    }

    fn length(&self) -> u32 {
        u32::try_from(self.pieces.len()).unwrap_or(1)
    }

    fn at(&self, s: f64) -> [f64; 2] {
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "0 to 4")]
        let i = (s as usize).min(self.pieces.len() - 1);
        #[expect(clippy::cast_precision_loss, reason = "0 to 4")]
        let t = s - i as f64;
        match &self.pieces[i] {
            Piece::Line(a, b) => [a[0] + (b[0] - a[0]) * t, a[1] + (b[1] - a[1]) * t],
            Piece::Arc { center, radius, from, to } => {
                let (sin, cos) = trig::sin_cos(from + (to - from) * t);
                [center[0] + radius * cos, center[1] + radius * sin]
            }
        }
    }
}
