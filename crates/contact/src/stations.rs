//! Stations around a tool, from which its places of contact are looked for.

use aptc_geometry::{Spot, Surface, Tool, Vec3};

use crate::crests;
use crate::gap::{Gap, Side, deeper};

/// Stations around the tool from which a search without a start sets out.
const AROUND: usize = 12;
/// Greatest number of seeds that are searched from.
pub(crate) const SEEDS: usize = 4;

/// Share of the half width of what touches from which a station is far from a place of contact: nearer ones the contact goes over to, and
/// is followed.
pub(crate) const FAR: f64 = 0.6;

/// Which stations around the tool are looked at.
#[derive(Clone, Copy)]
pub(crate) struct Stations {
    /// Those of the lower line and the arc: not where the place of the arc is known.
    pub(crate) lower: bool,
    /// Those of the upper line beyond its lower end: at this share of it and half of that, at none where it is 0.
    pub(crate) flank: f64,
    /// Instead of all of them those of the disk of the corner's middles, each point of which has one nearest place: those
    /// are followed from this one.
    pub(crate) disk: Option<Spot>,
}

/// Values and places below the stations of one ring.
type Row = [(f64, Spot); AROUND];

/// What the stations around a tool tell.
#[derive(Clone, Copy)]
pub(crate) struct Seeds {
    /// Surface points below the lowest: the local minima over the stations, the lowest of them, and the nearest crests.
    pub(crate) found: [Option<Spot>; 2 * SEEDS],
    /// The deepest station, and by how much.
    pub(crate) deepest: (f64, Vec3),
    /// The least way after which a station far from the known place of contact may be as deep: its normal and the known one
    /// differ by so much of the way as both go along them.
    pub(crate) way: f64,
}

/// The surface below the stations around the tool, one place of contact being known or none.
pub(crate) fn seeds(
    tool: &Tool<'_>,
    surface: &Surface,
    side: Side,
    of: Stations,
    known: Option<&Gap>,
) -> Seeds {
    let crests = crests::seeds(tool, surface, side, known);
    let whole = match surface {
        Surface::Tabcyl(_) => true,
        Surface::Parametric(s) => s.has_sections(),
        _ => false,
    };
    if let Some(all) = crests.filter(|_| known.is_some() && whole) {
        return all;
    }
    let profile = tool.profile;
    let [[rl, zl], [ru, zu]] = profile.joints();
    let mid = |a: [f64; 2], b: [f64; 2]| [0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])];
    let (lower, upper) = ([rl, zl], [ru, zu]);
    let rim = [profile.top_radius(), profile.height()];
    let on = |share: f64| [0, 1].map(|i| upper[i] + (rim[i] - upper[i]) * share);
    let above = if of.flank < 1.0 { on(of.flank) } else { rim };
    let (whole, half) = (lower, mid(lower, [0.0, profile.bottom()]));
    let (mut stations, mut range) = ([above, mid(upper, above), upper, whole, half], 0..5);
    if of.flank <= 0.0 {
        range.start = 2;
    }
    if !of.lower {
        range.end = 2;
    }
    let [rho, high] = profile.corner();
    // The corner of the disk is nearer by its radius.
    let (mut end, mut radius) = (profile.bottom(), 0.0);
    if of.disk.is_some() {
        (stations[3], stations[4], range) = ([rho, high], [0.5 * rho, high], 3..5);
        (end, radius) = (high, profile.corner_radius());
    }
    let stations = &stations[range];
    let [a, b] = aptc_geometry::surface::frame_about(tool.ta);
    let (mut deepest, mut way) =
        ((f64::INFINITY, tool.te), crests.map_or(f64::INFINITY, |c| c.way));
    let far = FAR * profile.half_width(known.and_then(|k| k.segment));
    let mut last = of.disk;
    let mut at = |rho: f64, z: f64, turn: usize| {
        let out = a * COS12[turn] + b * COS12[(turn + 9) % AROUND];
        let p = tool.te + out * rho + tool.ta * z;
        let foot = match last {
            Some(near) => surface.foot_from(p, near),
            None => surface.foot(p),
        };
        last = last.map(|_| foot.spot());
        let value = side.sign() * foot.distance - radius;
        if value < deepest.0 {
            deepest = (value, p);
        }
        if let Some(known) = known.filter(|k| (k.tool_point - p).norm() > far) {
            let turned = (foot.normal * side.sign() - known.normal).norm();
            way = way.min((value - known.raw) / turned.max(1e-9));
        }
        (value, foot.spot())
    };
    let mut found: [Option<(bool, f64, Spot)>; SEEDS] = [None; SEEDS];
    let mut offer = |beside: bool, value: f64, q: Spot| {
        let before =
            |s: &(bool, f64, Spot)| !beside && s.0 || beside == s.0 && deeper(tool, value, s.1);
        if let Some(i) = found.iter().position(|s| s.as_ref().is_none_or(before)) {
            found[i..].rotate_right(1);
            found[i] = Some((beside, value, q));
        }
    };
    if of.lower {
        let (value, q) = at(0.0, end, 0);
        offer(false, value, q);
    }
    // On the axis all of them are one.
    let mut ring = |[rho, z]: [f64; 2]| -> Row {
        let first = at(rho, z, 0);
        std::array::from_fn(|turn| if turn == 0 || rho == 0.0 { first } else { at(rho, z, turn) })
    };
    let mut rings = [None; 5];
    for (i, station) in stations.iter().enumerate() {
        if !stations[..i].contains(station) {
            rings[i] = Some(ring(*station));
        }
    }
    let rings: [Option<Row>; 5] = rings;
    let rings = || rings.iter().flatten();
    for (i, ring) in rings().enumerate() {
        let next = [i.checked_sub(1), Some(i + 1)].map(|k| k.and_then(|k| rings().nth(k)));
        for turn in 0..AROUND {
            let (value, q) = ring[turn];
            let about = [(turn + 1) % AROUND, (turn + AROUND - 1) % AROUND];
            if about.iter().all(|t| value <= ring[*t].0) {
                // Where the ring above or below is lower it leads to the same place, most likely: one such place must not
                // take the seeds of another.
                let lower = |r: &Row| about.iter().chain([&turn]).any(|t| r[*t].0 < value);
                offer(next.into_iter().flatten().any(lower), value, q);
            }
        }
    }
    let crests = crests.map_or([None; 2 * SEEDS], |c| c.found);
    let both = |i: usize| if i < SEEDS { found[i].map(|f| f.2) } else { crests[i - SEEDS] };
    Seeds { found: std::array::from_fn(both), deepest, way: way.max(0.0) }
}

/// Cosines of the multiples of 30 degrees.
const COS12: [f64; AROUND] = {
    let c = 0.866_025_403_784_438_6;
    [1.0, c, 0.5, 0.0, -0.5, -c, -1.0, -c, -0.5, 0.0, 0.5, c]
};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::disk::below;
    use crate::gap::{elsewhere, gap, gap_near};
    use crate::shapes::{mesh, rulings};
    use aptc_geometry::{Cutter, Profile, trig};
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(ProptestConfig {
            cases: 400, failure_persistence: None, ..ProptestConfig::default()
        })]

        /// A flat end below sides that lean outwards touches a ridge with its one end or with the other: what is far from a place
        /// of contact is so by the width of the end, not by that of the top.
        #[test]
        fn below_sides_that_lean_no_other_end_of_a_ridge_comes_down_on_the_way(
            radii in prop::array::uniform2(50.0_f64..150.0), lift in -4.0_f64..4.0,
            (radius, beta) in (0.5_f64..3.0, 0.0_f64..40.0),
            te in prop::array::uniform2(-15.0_f64..15.0), lean in prop::array::uniform2(-4e-4_f64..4e-4),
            turn in 0.0_f64..360.0,
        ) {
            let surface = rulings(radii, lift);
            let cutter = Cutter { beta_deg: beta, ..Cutter::mill(2.0 * radius, 0.0, 20.0) };
            let profile = Profile::new(&cutter).unwrap();
            // Nearly along the normal below: both ends of the ridge are about as deep, and moving across it makes the other so.
            let up = surface.foot(Vec3::new(te[0], te[1], 0.0)).normal;
            let ta = (up + Vec3::new(lean[0], lean[1], 0.0)).normalize();
            let high = Tool { profile: &profile, te: Vec3::new(te[0], te[1], 10.0), ta };
            let Ok(above) = gap(&high, &surface, Side::Positive, 0.0) else { return Ok(()) };
            let tool = high.at(high.te - above.normal * above.raw);
            let Ok(known) = gap(&tool, &surface, Side::Positive, 0.0) else { return Ok(()) };
            let (deeper, room) = elsewhere(&tool, &surface, Side::Positive, &known, (true, f64::INFINITY));
            prop_assert!(deeper.is_none_or(|d| d.g > known.g - 1e-7), "{known:?} {deeper:?}");
            let way = Vec3::new(trig::cos_deg(turn), trig::sin_deg(turn), 0.0);
            let moved = tool.at(tool.te + way * (0.99 * room.min(5.0)));
            let near = gap_near(&moved, &surface, Side::Positive, 0.0, Some(known.spot()));
            let (Ok(near), Ok(all)) = (near, gap(&moved, &surface, Side::Positive, 0.0)) else { return Ok(()) };
            prop_assert!(all.g > near.g - 1e-6, "{room} {known:?} {near:?} {all:?}");
        }

        /// Where most of a long shank is seen to be far, no place that stations all along it lead to is deeper than what is found.
        #[test]
        fn stations_beside_the_lower_part_of_a_shank_suffice(
            waves in prop::array::uniform2(-6.0_f64..6.0), lift in -6.0_f64..6.0, uneven in -0.5_f64..0.5,
            at in prop::array::uniform2(-1.0_f64..1.0), lean in prop::array::uniform2(-0.3_f64..0.3),
            (wide, high, beta) in (4.0_f64..14.0, 20.0_f64..70.0, 0.0_f64..15.0),
        ) {
            let surface = mesh(waves, lift, uneven);
            let cutter = Cutter { beta_deg: beta, ..Cutter::mill(wide, 0.0, high) };
            let profile = Profile::new(&cutter).unwrap();
            let ta = Vec3::new(lean[0], lean[1], 1.0).normalize();
            let above = Tool { profile: &profile, te: Vec3::new(30.0 * at[0], 25.0 * at[1], 20.0), ta };
            let Ok(far) = gap(&above, &surface, Side::Positive, 0.0) else { return Ok(()) };
            let tool = above.at(above.te - ta * (far.raw / far.normal.dot(&ta).max(0.3)));
            let all = Stations { lower: true, flank: 1.0, disk: None };
            let Seeds { found, .. } = seeds(&tool, &surface, Side::Positive, all, None);
            let gaps = found.into_iter().flatten().filter_map(|q| below(&tool, &surface, Side::Positive, q).ok());
            let least = gaps.map(|g| g.raw).fold(f64::INFINITY, f64::min);
            let found = gap(&tool, &surface, Side::Positive, 0.0).map_or(f64::INFINITY, |g| g.raw);
            prop_assert!(found <= least + 1e-9 * high, "{found} {least}");
        }
    }
}
