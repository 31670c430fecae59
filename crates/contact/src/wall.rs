//! All places at which a cutter touches a sculptured wall, of its flank and what is above and below that.
//!
//! Along its height a flank does not bend, so that a wall that waves there comes next to it at several heights. Pieces of the surface
//! that hold no place of contact, or are too far, are left out one by one; from what is left the way leads down to a place of contact.

use aptc_geometry::surface::{Next, ParametricSurface, Touching};
use aptc_geometry::{Spot, Surface, Tool};

use crate::curvature::second;
use crate::disk;
use crate::gap::{Gap, Side, deeper};
use crate::places::Places;

/// Share of the cutter's radius that a piece reaches from which it is not cut any more, where it may hold a deeper place: that is followed
/// from there.
const LEAST: f64 = 0.05;
/// The same of others.
const COARSE: f64 = 0.15;
/// Pieces that are looked at at most.
const LOOKS: u32 = 1500;
/// Places as deep as the known one, by this share of the cutter's reach, from which the wall is taken not to wave.
const EVEN: u32 = 3;
const ALIKE: f64 = 1e-10;
/// Sine by which a flank and a wall differ that lie along each other.
const STRAIGHT: f64 = 1e-9;
/// Share of the cutter's reach by which two places found are one.
const SAME: f64 = 1e-6;
/// Ways down to a place of contact at most, and of those that lead to none, which are long.
const MOST: usize = 24;
const ASTRAY: u32 = 3;
/// Places of contact that are remembered, so that no other piece leads there.
const PLACES: usize = 12;
/// Share of the cutter's radius within which the contact goes over to another place and is followed.
const NEAR: f64 = 0.1;
/// Shares of the cutter's radius by which it may be sunk in the wall and off it: from elsewhere ways down are long. Sine of the angle
/// by which the wall leans at most.
const ROOM: [f64; 2] = [-0.1, 0.5];
const LEANS: f64 = 0.5;

/// The deepest place of contact, one being known, and whether no other is deeper, which is not seen where they are too many; `None`
/// where nothing is seen.
pub(crate) fn deepest(
    tool: &Tool<'_>,
    surface: &Surface,
    side: Side,
    known: &Gap,
) -> Option<(Gap, bool)> {
    let mut all = Wall::new(tool, surface, side, known)?;
    let whole = all.look([known.raw, 0.0], |all, piece| {
        if piece.whole && piece.reach > all.least {
            return Next::Cut;
        }
        all.place(piece);
        Next::Left([all.best.raw, 0.0])
    });
    Some((all.best, whole.is_some()))
}

/// A deeper place than the `known` one, if there is one, and the way no longer than `most` that the tool can go, its axis standing, until
/// another one may be the deepest; `None` where they are too many.
pub(crate) fn elsewhere(
    tool: &Tool<'_>,
    surface: &Surface,
    side: Side,
    known: &Gap,
    most: f64,
) -> Option<(Option<Gap>, f64)> {
    let mut all = Wall::new(tool, surface, side, known)?;
    let near = NEAR * tool.profile.widest();
    let mut room = most;
    let whole = all.look([known.raw + 2.0 * most, most], |all, piece| {
        let left = |room: f64| Next::Left([known.raw + 2.0 * room, room]);
        // Both go by their normals times the way.
        let other = (piece.normal - known.normal).norm() + piece.turn;
        let above = (piece.bound - known.raw).max(0.0);
        let until = piece.until.max(0.5 * above / other);
        // To where none comes to be one can only move that is there already.
        let comes = piece.comes && (piece.point - known.surface_point).norm() > near;
        let (is_there, lower) = (piece.until <= 0.0, piece.bound <= all.best.raw);
        let nothing = !is_there || above > 2.0 * room;
        if nothing && (!comes || until >= room) {
            return left(room);
        }
        if piece.whole && piece.reach > if is_there && lower { all.least } else { all.coarse } {
            return Next::Cut;
        }
        if comes {
            room = room.min(until);
        }
        if is_there
            && (lower || !piece.comes)
            && let Some(gap) = all.place(piece)
        {
            room = room.min(all.until(&gap));
        }
        left(room)
    });
    match deeper(tool, all.best.raw, known.raw).then_some(all.best) {
        Some(best) => Some((Some(best), 0.0)),
        None => whole.map(|()| (None, room)),
    }
}

/// Does a flank lie along a straight line of a wall, but for rounding?
fn lies_along(tool: &Tool<'_>, surface: &Surface, known: &Gap) -> bool {
    let level = known.normal.dot(&tool.ta).abs() <= STRAIGHT;
    level && {
        let bend = surface.place(known.spot()).shape.second(tool.ta);
        bend.abs() * tool.profile.reach() <= STRAIGHT
    }
}

/// A sculptured surface beside a cutter that touches it at a known place.
struct Wall<'a> {
    tool: &'a Tool<'a>,
    whole: &'a Surface,
    surface: &'a ParametricSurface,
    side: Side,
    known: &'a Gap,
    at: [f64; 2],
    /// The deepest place of contact so far.
    best: Gap,
    /// Where the last ones were found.
    places: Places<PLACES>,
    /// How many of them are as deep as the known one, and how many ways led to none.
    even: u32,
    astray: u32,
    /// How far pieces reach that are not cut any more: those that may hold a deeper place, and others.
    least: f64,
    coarse: f64,
}

impl<'a> Wall<'a> {
    fn new(tool: &'a Tool<'a>, whole: &'a Surface, side: Side, known: &'a Gap) -> Option<Self> {
        let (Surface::Parametric(surface), Some(at)) = (whole, known.at) else { return None };
        let [low, high] = ROOM.map(|share| share * tool.profile.widest());
        let beside = known.raw >= low && known.raw <= high;
        let upright = known.normal.dot(&tool.ta).abs() <= LEANS;
        let searched = side != Side::Open && !surface.is_ruled() && upright && beside;
        if !searched || lies_along(tool, whole, known) {
            return None;
        }
        let [least, coarse] = [LEAST, COARSE].map(|share| share * tool.profile.widest());
        let (best, places) = (*known, Places::new(known.surface_point));
        let (even, astray) = (0, 0);
        Some(Self {
            tool,
            whole,
            surface,
            side,
            known,
            at,
            best,
            places,
            even,
            astray,
            least,
            coarse,
        })
    }

    /// Asks `look` of the pieces that may hold a place of contact with a gap below the first of the limits, the tool having gone by less
    /// than the second; `None` where there are too many of them, as along a wall that does not wave.
    fn look(
        &mut self,
        limits: [f64; 2],
        mut look: impl FnMut(&mut Self, &Touching) -> Next,
    ) -> Option<()> {
        let mut looks = 0;
        let (tool, surface, from) = (self.tool, self.surface, (self.at, self.known.normal));
        surface.touching(tool, from, limits, |piece| {
            looks += 1;
            match looks <= LOOKS && self.few() {
                true => look(self, piece),
                false => Next::Left([f64::NEG_INFINITY, -1.0]),
            }
        })?;
        (looks <= LOOKS && self.few()).then_some(())
    }

    /// Are not too many places of contact found, nor too many as deep as the known one?
    fn few(&self) -> bool {
        self.places.found() <= MOST && self.astray <= ASTRAY && self.even < EVEN
    }

    /// The place of contact to which the way leads down from the middle of a piece, unless one was found beside it.
    fn place(&mut self, piece: &Touching) -> Option<Gap> {
        if self.places.beside(piece.point, piece.reach) {
            return None;
        }
        let spot = Spot { point: piece.point, at: Some(piece.mid) };
        let gap = disk::below(self.tool, self.whole, self.side, spot);
        // Where the way leads to none it does so from beside it too.
        self.places.take(gap.as_ref().map_or(piece.point, |g| g.surface_point));
        let Ok(gap) = gap else {
            self.astray += 1;
            return None;
        };
        let away = (gap.surface_point - self.known.surface_point).norm();
        let size = self.tool.profile.reach();
        if (gap.raw - self.known.raw).abs() <= ALIKE * size && away > self.coarse {
            self.even += 1;
        }
        if deeper(self.tool, gap.raw, self.best.raw) {
            self.best = gap;
        }
        Some(gap)
    }

    /// The way until another place of contact may be deeper than the known one: both gaps go by their normals times the way, and these
    /// turn as the gaps bend.
    fn until(&self, other: &Gap) -> f64 {
        let known = self.known;
        if (other.surface_point - known.surface_point).norm() <= SAME * self.tool.profile.reach() {
            return f64::INFINITY;
        }
        let bend = |gap: &Gap| {
            let shape = second(self.tool, self.whole, self.side, gap);
            shape.map_or(f64::INFINITY, |s| s.k.iter().map(|k| k.abs()).sum())
        };
        let (above, bends) = ((other.raw - known.raw).max(0.0), bend(known) + bend(other));
        let turned = (other.normal - known.normal).norm();
        let both = turned + (turned * turned + 4.0 * bends * above).sqrt();
        // No two gaps come nearer than by twice the way.
        (2.0 * above / both.max(f64::MIN_POSITIVE)).max(0.5 * above)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gap::{gap, gap_near};
    use crate::shapes::mesh;
    use aptc_geometry::{Cutter, Profile, Vec3};
    use proptest::prelude::*;
    use proptest::test_runner::{Config, TestRunner};

    /// A ball, bull noses, a flat end and one with sides that lean.
    fn cutter(kind: usize, wide: f64) -> Cutter {
        let mill = |corner: f64| Cutter::mill(wide, 0.5 * wide * corner, 30.0);
        match kind {
            0 => mill(1.0),
            1 => mill(0.4),
            2 => mill(0.1),
            3 => mill(0.0),
            _ => Cutter { beta_deg: 4.0, ..mill(0.0) },
        }
    }

    /// Points of the surface under a lying tool.
    fn points(surface: &Surface) -> Vec<Vec3> {
        const N: u32 = 200;
        let Surface::Parametric(whole) = surface else { panic!("a mesh") };
        let share = |k: u32| (f64::from(k) + 0.5) / f64::from(N);
        let row = |i: u32| (0..N).map(move |j| whole.point([share(i), share(j)]));
        (0..N).flat_map(row).collect()
    }

    proptest! {
        #![proptest_config(ProptestConfig { cases: 200, failure_persistence: None, ..ProptestConfig::default() })]

        /// Beside a wall that waves along the flank no place of it is deeper in a tool that touches it.
        #[test]
        fn nothing_is_deeper_than_the_deepest_place_of_contact(
            waves in prop::array::uniform2(-2.0_f64..2.0), uneven in -0.5_f64..0.5,
            at in prop::array::uniform2(-1.0_f64..1.0), lean in prop::array::uniform2(-0.1_f64..0.1),
            (kind, wide) in (0_usize..5, 3.0_f64..16.0),
        ) {
            let surface = mesh(waves, 0.0, uneven);
            let profile = Profile::new(&cutter(kind, wide)).unwrap();
            let ta = Vec3::new(lean[0], 1.0, lean[1]).normalize();
            let te = Vec3::new(30.0 * at[0], -15.0 + 5.0 * at[1], 25.0);
            let mut tool = Tool { profile: &profile, te, ta };
            let mut last = f64::INFINITY;
            for _ in 0..60 {
                let Ok(gap) = gap(&tool, &surface, Side::Positive, 0.0) else { return Ok(()) };
                last = gap.raw;
                tool = tool.at(tool.te - Vec3::z() * last);
            }
            prop_assume!(last.abs() < 1e-6);
            for p in points(&surface) {
                prop_assert!(tool.distance(p) >= -2e-6, "{} at {p}: {tool:?}", tool.distance(p));
            }
        }
    }

    #[test]
    fn no_other_height_is_deeper_on_the_way() {
        let (shown, one) = (std::cell::Cell::new([0_u32; 2]), || -1.0_f64..1.0);
        let all = (
            ([one(), one()], -0.5_f64..0.5, [one(), one()], [one(), one()]),
            (0_usize..5, 3.0_f64..16.0, [one(), one(), one()], one()),
        );
        let mut runner =
            TestRunner::new(Config { cases: 300, failure_persistence: None, ..Config::default() });
        let check = runner.run(&all, |((waves, uneven, at, lean), (kind, wide, way, above))| {
            let surface = mesh(waves, 0.0, uneven);
            let profile = Profile::new(&cutter(kind, wide)).unwrap();
            let ta = Vec3::new(0.1 * lean[0], 1.0, 0.1 * lean[1]).normalize();
            let te = Vec3::new(30.0 * at[0], -15.0 + 5.0 * at[1], 25.0);
            let high = Tool { profile: &profile, te, ta };
            let Ok(far) = gap(&high, &surface, Side::Positive, 0.0) else { return Ok(()) };
            let tool = high.at(te - far.normal * (far.raw - 0.1 * above));
            let Ok(known) = gap(&tool, &surface, Side::Positive, 0.0) else { return Ok(()) };
            let Some((deeper, room)) =
                elsewhere(&tool, &surface, Side::Positive, &known, 0.2 * wide)
            else {
                return Ok(());
            };
            prop_assert!(deeper.is_none_or(|d| d.raw > known.raw - 1e-7), "{known:?} {deeper:?}");
            let by = Vec3::from(way).normalize() * (0.99 * room);
            let moved = tool.at(tool.te + by);
            let near = gap_near(&moved, &surface, Side::Positive, 0.0, Some(known.spot()));
            let Ok(near) = near else { return Ok(()) };
            let least = points(&surface)
                .into_iter()
                .map(|p| moved.distance(p))
                .fold(f64::INFINITY, f64::min);
            prop_assert!(least >= near.raw - 2e-6, "{least} {room} {known:?} {near:?}");
            let [far, close] = shown.get();
            shown.set(if room > 0.02 * wide { [far + 1, close] } else { [far, close + 1] });
            Ok(())
        });
        check.unwrap();
        let [far, close] = shown.get();
        assert!(far > close, "{far} {close}");
    }
}
