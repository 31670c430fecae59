//! What of a tool is above its corner, held off sculptured surfaces.

use aptc_geometry::{Surface, Tool, Vec3};

/// Shares of a way on which it may be shown to keep off.
const SHARES: [f64; 3] = [1.0, 0.4, 0.1];

/// Share of the shank's radius or height, whichever is less, by which the surface may be in it: the middle of the arc keeps its
/// side, and with it the shank.
const SHALLOW: f64 = 0.25;

/// Is a sculptured surface at least so far from all of a round tool above the lower end of its upper line, which counts as a
/// cylinder? The gap of the tool's arc is no less than that. False also where it is not seen, where the tool is sunk in the
/// surface, and of other surfaces.
pub(crate) fn keeps_off(tool: &Tool<'_>, surface: &Surface, least: f64) -> bool {
    let Surface::Parametric(surface) = surface else { return false };
    let [_, [_, low]] = tool.profile.joints();
    let (wide, top) = (tool.profile.widest(), tool.profile.height());
    if least < -SHALLOW * wide.min(top - low) {
        return false;
    }
    surface.keeps_off(least, |q| {
        let w = q - tool.te;
        let z = w.dot(&tool.ta);
        let across = w - tool.ta * z;
        let far = across.norm();
        let out = far - wide;
        let radial = if far > 0.0 { across / far } else { Vec3::zeros() };
        let (up, along) = if low - z > z - top { (low - z, -tool.ta) } else { (z - top, tool.ta) };
        match (out > 0.0, up > 0.0) {
            (true, true) => {
                let distance = aptc_geometry::trig::hypot(out, up);
                (distance, (radial * out + along * up) / distance)
            }
            (false, true) => (up, along),
            (true, false) => (out, radial),
            (false, false) if out > up => (out, radial),
            (false, false) => (up, along),
        }
    })
}

/// A distance greater than `above` within which nothing of a sculptured surface is beside that part of the tool, when
/// this goes by `way` or some of it; `None` where that is not seen. The gap of the tool's `arc` tells on which side of the
/// surface it is.
pub(crate) fn clear(
    tool: &Tool<'_>,
    surface: &Surface,
    [arc, above]: [f64; 2],
    way: f64,
) -> Option<f64> {
    if arc < -SHALLOW * tool.profile.corner_radius() {
        return None;
    }
    let distances = SHARES.map(|share| above + 2.0 * share * way);
    distances.into_iter().find(|least| keeps_off(tool, surface, *least))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shapes::mesh;
    use aptc_geometry::{Cutter, Profile};
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(300))]
        /// No place of the surface is nearer to the upper part of the tool than is told.
        #[test]
        fn no_place_is_nearer(
            waves in prop::array::uniform2(-4.0_f64..4.0), lift in -8.0_f64..8.0, uneven in -0.5_f64..0.5,
            te in prop::array::uniform3(-1.0_f64..1.0), lean in prop::array::uniform2(-0.6_f64..0.6), high in 8.0_f64..40.0,
            above in -6.0_f64..3.0,
        ) {
            let surface = mesh(waves, lift, uneven);
            let profile = Profile::new(&Cutter::mill(10.0, 5.0, high)).unwrap();
            let ta = Vec3::new(lean[0], lean[1], 1.0).normalize();
            let tool = Tool { profile: &profile, te: Vec3::new(30.0 * te[0], 25.0 * te[1], 8.0 * te[2]), ta };
            let found = clear(&tool, &surface, [0.0, above], 4.0);
            let [_, [_, low]] = profile.joints();
            let mut least = f64::INFINITY;
            for i in 0..=60 {
                for j in 0..=60 {
                    let share = |k: i32| (f64::from(k) - 30.0) / 30.0;
                    let p = Vec3::new(60.0 * share(i), 55.0 * share(j), 0.0);
                    let q = surface.foot(p).point;
                    let z = (q - tool.te).dot(&ta);
                    let out = (q - tool.te - ta * z).norm() - profile.widest();
                    let up = (low - z).max(z - profile.height());
                    let distance = match out > 0.0 && up > 0.0 {
                        true => aptc_geometry::trig::hypot(out, up),
                        false => out.max(up),
                    };
                    least = least.min(distance);
                }
            }
            if above < -0.25 * 5.0 {
                // Sunk in the surface it is on neither side of it.
                prop_assert!(!keeps_off(&tool, &surface, above));
            } else if let Some(told) = found {
                prop_assert!(told > above && least >= told - 1e-9, "{least} {told}");
            } else {
                // It is not for want of looks: some place is about as near.
                prop_assert!(least < above + 0.8 + 1.0, "{least} {above}");
            }
        }
    }
}
