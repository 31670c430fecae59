//! A tool that turns in place on the ridge between the surface it comes from and the one it goes on along.
//!
//! All of an APT cutter lies on the upper side of the plane through its end, square to its axis. Where the material is what lies below
//! both surfaces, and the axis is between their normals, that plane holds the tool off it: of the surface alone that comes next it may
//! stand in what goes on beyond the ridge, which is not there.

use aptc_cldata::{Control, Position};
use aptc_geometry::{Profile, Vec3};

use crate::demand::Demand;
use crate::sheets::Sheets;
use crate::tool::Pose;

/// Widths of its band that the tool end moves at most while it turns in place.
const LONG: f64 = 2.0;

/// What is known of a tool that turns on a ridge.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Ridge {
    /// Nothing of it is deeper in both surfaces than they allow.
    Clear,
    /// So it is by the planes that are tangent there, below which not all of the material may lie; where the turn begins it is so much
    /// deeper in that of the surface next in turn than that allows.
    Likely(f64),
}

/// The ridge on which the tool turns in place from `from` to `to`, its end moving no more than to come into the band, between the surface
/// next in turn and one that the motion `earlier` touched; `None` where it does not, or cuts in. `on` is the way's next tool end.
pub(crate) fn turns_over(
    next: &Demand,
    earlier: &Control,
    [from, to]: [&Position; 2],
    on: Vec3,
    (profile, pad): (&Profile, f64),
    sheets: &Sheets,
) -> Option<Ridge> {
    let by = from.te - to.te;
    let near = LONG * (next.most - next.least) + pad;
    if by.norm() > near {
        return None;
    }
    let after = next.half_space(profile, to)?;
    let surfaces = [&earlier.part, &earlier.drive].into_iter().flatten();
    surfaces.map(|c| Demand::new(c, sheets)).find_map(|earlier| {
        let before = earlier.half_space(profile, from)?;
        let [m, n] = [before.away, after.away];
        // The lesser at both ends, as it is between them.
        let up = before.off - m.dot(&by).max(0.0) - earlier.least;
        let high = after.off + n.dot(&by).min(0.0) - next.least;
        // On both of them it is on their ridge. Beyond that the way leads into what is below the surface before it; from a valley it
        // leaves that.
        let on_both = before.off <= earlier.most + near;
        let below = on_both && m.dot(&(on - to.te)) < -pad;
        let clear = |at: &Position| {
            let Some([a, b]) = between(at.ta, m, n) else { return false };
            let aside = (at.ta - m * a - n * b).norm() * profile.reach();
            a * up + b * high - aside >= -pad
        };
        if !(below && clear(from) && clear(to)) {
            return None;
        }
        if before.holds && after.holds {
            return Some(Ridge::Clear);
        }
        let lowest = -next.tool(profile).height(&Pose::of(from), -n);
        Some(Ridge::Likely(next.least - (lowest - n.dot(&to.te) + after.off)))
    })
}

/// The shares of two directions in the one between them that is nearest to an axis; `None` where that is not between them.
fn between(axis: Vec3, m: Vec3, n: Vec3) -> Option<[f64; 2]> {
    /// Sine of the angle to the one or the other that is none.
    const NONE: f64 = 1e-9;
    let (cos, p, q) = (m.dot(&n), axis.dot(&m), axis.dot(&n));
    let sin_squared = m.cross(&n).norm_squared();
    if sin_squared <= NONE * NONE {
        return None;
    }
    let [a, b] = [(p - cos * q) / sin_squared, (q - cos * p) / sin_squared];
    (a >= -NONE && b >= -NONE).then(|| [a.max(0.0), b.max(0.0)])
}

#[cfg(test)]
mod tests {
    use super::*;

    use std::sync::Arc;

    use aptc_cldata::{Controlled, NameRef, Relation};
    use aptc_geometry::{Cutter, Form, Plane, trig};

    /// The plane through the y axis that rises by an angle along x, touched from above.
    fn slope(deg: f64) -> Controlled {
        let n = Vec3::new(-trig::sin_deg(deg), 0.0, trig::cos_deg(deg));
        Controlled {
            name: NameRef::default(),
            form: Arc::new(Form::Plane(Plane { n, d: 0.0 })),
            relation: Relation::To,
            side: 1,
            open: false,
            nth: 1,
            thick: 0.0,
            disk: None,
            intol: 0.01,
            outtol: 0.01,
        }
    }

    fn after(slope: Controlled) -> Control {
        Control { drive: None, part: Some(slope), checks: Vec::new(), milling: None }
    }

    fn axis(deg: f64, aside: f64) -> Vec3 {
        Vec3::new(-trig::sin_deg(deg), aside, trig::cos_deg(deg)).normalize()
    }

    /// From one slope to the next about a place at some height, the axis leaning along the ridge by so much at the end.
    fn turns(from: f64, to: f64, high: f64, aside: f64) -> bool {
        let profile = Profile::new(&Cutter::mill(10.0, 1.0, 30.0)).unwrap();
        let te = Vec3::new(0.0, 3.0, high);
        let way =
            [(from, 0.0), (to, aside)].map(|(deg, aside)| Position { te, ta: axis(deg, aside) });
        let next = Demand::new(&slope(to), &Sheets::default());
        let on = te + Vec3::new(trig::cos_deg(to), 0.0, trig::sin_deg(to)) * 5.0;
        let held = (&profile, 1e-9);
        let sheets = Sheets::default();
        turns_over(&next, &after(slope(from)), [&way[0], &way[1]], on, held, &sheets)
            == Some(Ridge::Clear)
    }

    #[test]
    fn it_turns_over_ridges_and_not_in_valleys() {
        for (from, to) in [(20.0, -5.0), (1.0, 0.0), (30.0, 25.0), (-10.0, -60.0)] {
            assert!(turns(from, to, 0.0, 0.0), "{from} {to}");
            assert!(turns(from, to, -0.005, 0.0), "{from} {to}");
            assert!(!turns(to, from, 0.0, 0.0), "{to} {from}");
            // Deeper than the band, and off it.
            assert!(!turns(from, to, -0.02, 0.0), "{from} {to}");
            assert!(!turns(from, to, 0.1, 0.0), "{from} {to}");
            assert!(!turns(from, to, 0.0, 0.01), "{from} {to}");
        }
    }

    /// Where it is told to do so no place of the tool is below both slopes by more than the band, wherever between them its axis is.
    #[test]
    fn what_turns_over_is_below_no_ridge() {
        let profile = Profile::new(&Cutter::mill(10.0, 1.0, 30.0)).unwrap();
        for (from, to) in [(20.0, -5.0), (-10.0, -60.0)] {
            let high = -0.009;
            assert!(turns(from, to, high, 0.0));
            for k in 0..=20 {
                let deg = from + (to - from) * f64::from(k) / 20.0;
                let (ta, u) = (axis(deg, 0.0), Vec3::y().cross(&axis(deg, 0.0)));
                for i in 0..360 {
                    let (s, c) = trig::sin_cos(f64::from(i).to_radians());
                    let [r, z] = profile.support(c, -s).point;
                    for r in [0.0, 0.5 * r, r, -r] {
                        let x = Vec3::z() * high + ta * z + u * r;
                        let off = |deg: f64| axis(deg, 0.0).dot(&x);
                        assert!(off(from).max(off(to)) >= -0.01, "{from} {to} {deg} {i}");
                    }
                }
            }
        }
    }
}
