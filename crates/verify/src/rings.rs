//! How far a tool reaches from an axis: its hull is spanned by circles about its own axis, that of its corner made thicker.
//!
//! Seen along the axis t a circle of radius r is an ellipse with the half axes `D = (r, r |ta.t|)` about c. For no unit vector
//! u and no `l >= r^2` is the square of the distance greater than
//!
//! ```text
//!   |c + D u|^2 <= |c|^2 + l + (r c1)^2 / (l - r^2) + (D2 c2)^2 / (l - D2^2),
//! ```
//!
//! as `u' (l - D^2) u` is no less than its tangent: each l proves a bound, and that where u is a unit vector the least one,
//! which is met.

use aptc_geometry::{Profile, Vec3, trig};

use crate::tool::{Pose, Tool, radial};

/// Rounds of Newton's method; three to five are usual. Reaching them costs tightness, not truth.
const ROUNDS: usize = 30;
/// Share by which the last step may change l.
const LAST: f64 = 1e-9;

/// The circles: radius, height above the lower end, by how much they are thicker.
fn circles(profile: &Profile) -> [[f64; 3]; 5] {
    let [[rl, zl], [ru, zu]] = profile.joints();
    let [e, f] = profile.corner();
    [
        [profile.top_radius(), profile.height(), 0.0],
        [e, f, profile.corner_radius()],
        [rl, zl, 0.0],
        [ru, zu, 0.0],
        [0.0, profile.bottom(), 0.0],
    ]
}

/// No point of the tool is farther from the axis through `q` along `t` than this, and the direction across it in which some
/// point is so far, about; `None` of the tool end alone.
pub(crate) fn reach(tool: &Tool<'_>, pose: &Pose, q: Vec3, t: Vec3) -> Option<(f64, Vec3)> {
    let (profile, lift) = tool.solid()?;
    let cos = pose.ta.dot(&t).abs().min(1.0);
    let across = pose.ta.cross(&t);
    let wide = radial(across, across.norm(), t);
    let narrow = t.cross(&wide);
    let all = circles(profile);
    let mut best = (f64::NEG_INFINITY, wide);
    for (i, circle) in all.iter().enumerate() {
        if all[..i].contains(circle) {
            continue;
        }
        let [radius, up, thicker] = *circle;
        let c = pose.te + pose.ta * (up + lift) - q;
        let (square, at) = farthest([c.dot(&wide), c.dot(&narrow)], [radius, radius * cos]);
        let far = square.max(0.0).sqrt() + thicker;
        if far > best.0 {
            best = (far, wide * at[0] + narrow * at[1]);
        }
    }
    let out = best.1.norm();
    (out > 0.0).then(|| (best.0, best.1 / out))
}

/// The greatest square of the distance of an ellipse about `c` from the origin, bounded from above, and the place, about. The
/// first half axis is the greater.
fn farthest([a, b]: [f64; 2], [r, s]: [f64; 2]) -> (f64, [f64; 2]) {
    if r <= 0.0 {
        return (a * a + b * b, [a, b]);
    }
    let (p, q) = (r * a, s * b);
    // No l of a unit vector is less.
    let least = r * r * (1.0 + f64::EPSILON);
    let mut l = (r * r + p.abs()).max(s * s + q.abs()).max(least);
    for _ in 0..ROUNDS {
        let (u, v) = (p / (l - r * r), q / (l - s * s));
        let square = u * u + v * v;
        // Newton's method for one over the length, which is nearly straight.
        let slope = u * u / (l - r * r) + v * v / (l - s * s);
        let step = square / slope * (square.sqrt() - 1.0);
        if !step.is_finite() {
            break;
        }
        l = (l + step).max(least);
        if step.abs() <= LAST * l {
            break;
        }
    }
    let (u, v) = (p / (l - r * r), q / (l - s * s));
    let v = v.clamp(-1.0, 1.0);
    // Where the middle lies on the lesser axis both sides are as far.
    let u = if u * u + v * v < 0.5 { ((1.0 - v) * (1.0 + v)).sqrt().copysign(p) } else { u };
    let length = trig::hypot(u, v);
    let bound = a * a + b * b + l + p * p / (l - r * r) + q * q / (l - s * s);
    (bound, [a + r * u / length, b + s * v / length])
}

#[cfg(test)]
mod tests {
    use super::*;
    use aptc_geometry::Cutter;
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(2000))]
        #[test]
        fn nothing_of_a_tool_is_farther_from_an_axis(
            [te, ta, q, t] in prop::array::uniform4(prop::array::uniform3(-1.0..1.0_f64)),
            (corner, kind, near) in (0.0..5.0_f64, 0_usize..4, prop::sample::select(vec![0.0, 1e-16, 1e-15, 1e-12, 1e-8])),
        ) {
            let unit = |x: [f64; 3]| (Vec3::from(x) + Vec3::z() * 1e-3).normalize();
            // Parallel, also but for rounding.
            let beside = unit(ta) + Vec3::from(t) * near;
            let (ta, t) = (unit(ta), if kind == 3 { beside.normalize() } else { unit(t) });
            let profile = match kind {
                0 => Profile::disk(4.0, 3.0),
                1 => Profile::new(&Cutter::mill(10.0, corner, 30.0)),
                _ => Profile::new(&Cutter::mill(10.0, 0.0, 30.0)),
            }
            .unwrap();
            let (tool, pose) = (Tool::Solid(&profile), Pose { te: Vec3::from(te) * 20.0, ta });
            let q = Vec3::from(q) * 20.0;
            let (far, m) = reach(&tool, &pose, q, t).unwrap();
            let height = |m: Vec3| tool.height(&pose, m) - m.dot(&q);
            let [a, b] = aptc_geometry::surface::frame_about(t);
            for i in 0..360 {
                let (s, c) = trig::sin_cos(f64::from(i).to_radians());
                prop_assert!(height(a * c + b * s) <= far + 1e-9, "{i} {far}");
            }
            prop_assert!(m.dot(&t).abs() < 1e-9 && height(m) <= far + 1e-9);
            // Of a tool without a corner the bound is met.
            if kind != 1 {
                prop_assert!(height(m) >= far - 1e-9, "{far} {}", height(m));
            }
        }
    }
}
