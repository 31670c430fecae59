//! The gap along a chord on which the flat end of a cutter comes onto a crest, leaves it or passes it, while its axis stands.
//!
//! While the crest is below the flat end the gap is linear, and where it comes there and leaves is a closed form. There the gap
//! goes on as steeply and bends otherwise: cut there, it is one smooth dip or bump on each part.

use aptc_geometry::{Reason, Spot, Surface, Vec3};

use crate::dips::{Sample, single};
use crate::guide::End;
use crate::ring::Ring;

/// Share of the resolution by which places of one ridge may lie higher than others.
const EVEN: f64 = 0.1;
/// Share of a chord so short that nothing happens on it.
const ONCE: f64 = 1e-9;
/// Shares of a chord at which a crest is looked for that both ends are beside.
const SHARES: [f64; 3] = [0.5, 0.25, 0.75];

/// What is known of a place of a chord.
type Known = (Sample, Spot);

/// The way `v` of the tool end from `te`.
struct Way<'a> {
    ring: &'a Ring,
    surface: &'a Surface,
    te: Vec3,
    v: Vec3,
}

/// Least and greatest gap while the tool end moves by `v` from `te`; `None` where no one crest is seen to be below the flat end
/// on the way, and where the gap turns more than once.
pub(crate) fn over_crest(
    ring: &Ring,
    surface: &Surface,
    (te, v): (Vec3, Vec3),
    [a, b]: [&End<Spot>; 2],
    resolution: f64,
) -> Option<[f64; 2]> {
    let way = Way { ring, surface, te, v };
    let [on_a, on_b] = [a, b].map(|end| ring.is_level(end.normal));
    let ends = [a.g.min(b.g), a.g.max(b.g)];
    if on_a && on_b {
        // Of a ridge it may be another place; one of both is below the flat end all the way.
        let [_, leaves] = ring.passes(surface, a.at, te, v)?;
        let [comes, _] = ring.passes(surface, b.at, te, v)?;
        let off = (ring.above(a.at.point, te + v) - b.g).abs();
        return (comes <= leaves && off <= EVEN * resolution).then_some(ends);
    }
    let crest = match (on_a, on_b) {
        (true, _) => *a,
        (_, true) => *b,
        _ => way.crest([a.at, b.at])?,
    };
    let [comes, leaves] = ring.passes(surface, crest.at, te, v)?;
    let mut all = ends;
    let mut take = |range: [f64; 2], ends: [&End<Spot>; 2]| -> Option<()> {
        let [low, high] = way.part(range, ends, resolution)?;
        all = [all[0].min(low), all[1].max(high)];
        Some(())
    };
    if !on_a {
        take([0.0, comes], [a, &way.level(&crest, comes)])?;
    }
    if !on_b {
        take([leaves, 1.0], [&way.level(&crest, leaves), b])?;
    }
    Some(all)
}

impl Way<'_> {
    fn read(&self, t: f64, near: Spot) -> Option<End<Spot>> {
        Some(self.ring.read(self.surface, self.te + self.v * t, near)?.end)
    }

    /// A crest that is below the flat end somewhere on the way, beside places of contact at its ends.
    fn crest(&self, [a, b]: [Spot; 2]) -> Option<End<Spot>> {
        let seen = |t: &f64| {
            let near = if *t <= 0.5 { a } else { b };
            self.read(*t, near).filter(|end| self.ring.is_level(end.normal))
        };
        SHARES.iter().find_map(seen)
    }

    /// What is read of a crest at a place of the way at which the flat end is above it.
    fn level(&self, crest: &End<Spot>, t: f64) -> End<Spot> {
        let g = self.ring.above(crest.at.point, self.te + self.v * t);
        End { g, normal: crest.normal, at: crest.at }
    }

    /// Least and greatest gap on a part of the way on which it is smooth; `None` where it turns more than once.
    fn part(&self, range: [f64; 2], ends: [&End<Spot>; 2], resolution: f64) -> Option<[f64; 2]> {
        let both = [ends[0].g.min(ends[1].g), ends[0].g.max(ends[1].g)];
        let [from, to] = range;
        if to - from <= ONCE {
            return (from - to <= ONCE).then_some(both);
        }
        if from < 0.0 || to > 1.0 {
            return None;
        }
        let known = |t: f64, end: &End<Spot>| -> Known {
            (Sample { t, g: end.g, slope: end.normal.dot(&self.v) }, end.at)
        };
        let look = |a: &Known, b: &Known, t: f64| -> Result<Known, Reason> {
            let near = if t - a.0.t <= b.0.t - t { a.1 } else { b.1 };
            Ok(known(t, &self.read(t, near).ok_or(Reason::NoHit)?))
        };
        let (a, b) = (known(from, ends[0]), known(to, ends[1]));
        let (rises, falls) = (a.0.slope.max(b.0.slope), a.0.slope.min(b.0.slope));
        let found = if rises > 0.0 && falls < 0.0 {
            single(a, b, resolution, |known| known.0, look).ok()??.g
        } else {
            // It rises or falls all along where its slope in the middle says so too.
            let (middle, _) = look(&a, &b, 0.5 * (from + to)).ok()?;
            (middle.slope >= falls && middle.slope <= rises).then_some(middle.g)?
        };
        Some([both[0].min(found), both[1].max(found)])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gap::{Condition, Side, distance, gap};
    use crate::guide::{Guide, Passed};
    use crate::point::PointGuide;
    use crate::shapes::{mesh, rulings};
    use aptc_geometry::profile::Segment;
    use aptc_geometry::{Cutter, Profile, Tool};
    use proptest::prelude::*;
    use proptest::test_runner::TestRunner;
    use std::cell::Cell;

    /// Looks along a chord, each from the place before.
    const LOOKS: u32 = 400;

    /// What is told of chords onto, off and over crests is what looks all along them see, and most of them are told.
    #[test]
    fn chords_over_crests_are_as_looks_along_them_see() {
        let surfaces = [
            rulings([60.0, 90.0], 0.0),
            rulings([70.0, 50.0], 3.0),
            mesh([1.5, 0.8], 0.0, 0.0),
            mesh([2.0, 1.5], 2.0, 0.3),
        ];
        let told = Cell::new([0_u32; 3]);
        let vectors = prop::array::uniform3(prop::array::uniform2(-1.0_f64..1.0));
        let input = (0_usize..4, 0_usize..3, any::<bool>(), vectors);
        let mut runner = TestRunner::new(ProptestConfig::with_cases(1500));
        let check = runner.run(&input, |(kind, corner, leans, [at, way, rise])| {
            let surface = &surfaces[kind];
            let corner = [0.0, 0.5, 2.0][corner];
            let profile = Profile::new(&Cutter::mill(10.0, corner, 40.0)).unwrap();
            let ta = if leans { Vec3::new(0.06, -0.04, 1.0).normalize() } else { Vec3::z() };
            let (side, touch) = (Side::Positive, Condition::Touch);
            let place = |x: f64, y: f64, up: f64| {
                let tool = Tool { profile: &profile, te: Vec3::new(x, y, 0.0), ta };
                let gap = gap(&tool, surface, side, 0.0).ok()?;
                Some(tool.te + ta * ((up - gap.g) / gap.normal.dot(&ta)))
            };
            let (x, y) = (12.0 * at[0], 12.0 * at[1]);
            let from = place(x, y, 0.02 * rise[0]);
            let to = place(x + 8.0 * way[0], y + 8.0 * way[1], 0.02 * rise[1]);
            let (Some(te), Some(to)) = (from, to) else { return Ok(()) };
            let tool = Tool { profile: &profile, te, ta };
            let guide = PointGuide::new(&tool, surface, touch, side, 0.0);
            let Some(PointGuide::Ring(ring)) = guide else { return Ok(()) };
            let Ok(start) = gap(&tool, surface, side, 0.0) else { return Ok(()) };
            let v = to - te;
            let (mut near, mut seen, mut flat) = (start, [start.g; 2], false);
            for k in 1..=LOOKS {
                let there = tool.at(te + v * (f64::from(k) / f64::from(LOOKS)));
                let Ok(gap) = distance(&there, surface, touch, side, 0.0, Some(near.spot())) else {
                    return Ok(());
                };
                flat |= gap.segment == Some(Segment::LowerLine);
                (near, seen) = (gap, [seen[0].min(gap.g), seen[1].max(gap.g)]);
            }
            let a = ring.read(surface, te, start.spot());
            let b = ring.read(surface, to, near.spot());
            let (Some(a), Some(b)) = (a, b) else { return Ok(()) };
            prop_assert!((a.end.g - start.g).abs() < 1e-9 && (b.end.g - near.g).abs() < 1e-9);
            let ends = [&a.end, &b.end];
            let [crest, found, not] = told.get();
            if !flat || !ring.crosses(ends) {
                return Ok(());
            }
            let chord = PointGuide::Ring(ring).chord(surface, te, v, ends, None, 1e-10);
            let Some(Passed { gaps: [low, high], .. }) = chord else {
                told.set([crest, found, not + 1]);
                return Ok(());
            };
            let on = [a, b].iter().any(|read| ring.is_level(read.end.normal));
            told.set([crest + u32::from(on), found + 1, not]);
            // Between two looks it bends by this much at most.
            let little = 1e-9 + 0.125 * v.norm_squared() / f64::from(LOOKS * LOOKS) / 5.0;
            prop_assert!((low - seen[0]).abs() <= little, "{low} {seen:?} {a:?} {b:?}");
            prop_assert!((high - seen[1]).abs() <= little, "{high} {seen:?} {a:?} {b:?}");
            Ok(())
        });
        check.unwrap();
        let [crest, found, not] = told.get();
        assert!(crest > 50 && found > 2 * not, "{crest} {found} {not}");
    }
}
