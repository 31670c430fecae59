//! All places at which the flat end and the corner of a cutter touch a sculptured surface, where nothing else of it can.
//!
//! Their points are no farther than the corner's radius from the disk of the corner's middles: each place of contact is one at which
//! the distance of that disk dips. Pieces of the surface that hold none, or are too far, are left out one by one; from what is left
//! the way leads down to a place of contact.

use aptc_geometry::profile::Segment;
use aptc_geometry::surface::{Disk, Facing, Next, ParametricSurface};
use aptc_geometry::{Spot, Surface, Tool};

use crate::alone::around;
use crate::disk;
use crate::gap::{Gap, Side, deeper};
use crate::places::Places;
use crate::search::rival;
use crate::stations::FAR;

/// Share of the cutter's radius that a piece reaches from which it is not cut any more: a place of contact is followed from there.
const LEAST: f64 = 0.05;
/// The same of a piece that may hold one after some way.
const COARSE: f64 = 0.15;
/// Places of contact that are remembered, so that no other piece leads there.
const PLACES: usize = 8;

/// The deepest place of contact, one being known, where only flat end and corner can touch; `None` where that is not seen.
pub(crate) fn deepest(tool: &Tool<'_>, surface: &Surface, side: Side, known: &Gap) -> Option<Gap> {
    let all = Beneath::new(tool, surface, side, known, 0.0)?;
    let (mut best, mut places) = (*known, Places::new(known.surface_point));
    let radius = tool.profile.corner_radius();
    all.look(known.raw, 0.0, |piece| {
        if piece.whole && piece.reach > all.least {
            return Next::Cut;
        }
        if let Some(gap) = all.place(piece, &mut places)
            && deeper(tool, gap.raw, best.raw)
        {
            best = gap;
        }
        Next::Left([best.raw + radius, 0.0])
    });
    Some(best)
}

/// A deeper place than the `known` one, if there is one, and the way no longer than `most` that the tool can go, its axis standing, until
/// one far from the known one may be the deepest; `None` where it is not seen that only flat end and corner can touch on it.
pub(crate) fn elsewhere(
    tool: &Tool<'_>,
    surface: &Surface,
    side: Side,
    known: &Gap,
    most: f64,
) -> Option<(Option<Gap>, f64)> {
    let all = Beneath::new(tool, surface, side, known, most)?;
    let far = FAR * tool.profile.half_width(known.segment);
    let radius = tool.profile.corner_radius();
    let (mut best, mut room, mut places) = (*known, most, Places::new(known.surface_point));
    all.look(known.raw + 2.0 * most, most, |piece| {
        let left = |room: f64| Next::Left([known.raw + radius + 2.0 * room, room]);
        let away = (piece.point - known.surface_point).norm();
        // Both go by their normals times the way.
        let other = (piece.normal - known.normal).norm() + piece.turn;
        let above = (piece.bound - radius - known.raw).max(0.0);
        let until = if away > far { piece.until.max(0.5 * above / other) } else { room };
        let nothing = piece.until > 0.0 || above > 2.0 * room;
        // A place that is there already counts wherever it is, and one that comes to be there where it is far.
        if nothing && (until >= room || away + piece.reach <= far) {
            return left(room);
        }
        let least = if piece.until > 0.0 { all.coarse } else { all.least };
        if piece.whole && piece.reach > least {
            return Next::Cut;
        }
        room = room.min(until);
        if piece.until <= 0.0
            && let Some(gap) = all.place(piece, &mut places)
        {
            rival(tool, known, &gap, &mut best, &mut room);
        }
        left(room)
    });
    Some((deeper(tool, best.raw, known.raw).then_some(best), room))
}

/// A surface beneath the flat end and the corner of a cutter.
struct Beneath<'a> {
    tool: &'a Tool<'a>,
    whole: &'a Surface,
    surface: &'a ParametricSurface,
    side: Side,
    disk: Disk,
    /// How far pieces reach that are not cut any more: those that may hold a place of contact, and others.
    least: f64,
    coarse: f64,
}

impl<'a> Beneath<'a> {
    fn new(
        tool: &'a Tool<'a>,
        whole: &'a Surface,
        side: Side,
        known: &Gap,
        most: f64,
    ) -> Option<Self> {
        let (Surface::Parametric(surface), Some(at)) = (whole, known.at) else { return None };
        let (balls, count) = around(tool, known.raw.max(0.0) + 2.0 * most);
        let up = surface.upright(&balls[..count], tool.ta, (at, known.normal))?;
        let leans = (1.0 - up * up).max(0.0).sqrt();
        let lower = tool.profile.support(leans, -up).segment;
        let disk = disk::middles(tool, side)?;
        let below = matches!(lower, Segment::Arc | Segment::LowerLine);
        let [least, coarse] = [LEAST, COARSE].map(|share| share * tool.profile.widest());
        below.then_some(Self { tool, whole, surface, side, disk, least, coarse })
    }

    /// Asks `look` of the pieces that may hold a place of contact with a gap below `limit`, the tool having gone by less than `way`.
    fn look(&self, limit: f64, way: f64, look: impl FnMut(&Facing) -> Next) {
        let limit = limit + self.tool.profile.corner_radius();
        self.surface.beneath(&self.disk, [limit, way], look);
    }

    /// The place of contact to which the way leads down from the middle of a piece, unless one was found beside it.
    fn place(&self, piece: &Facing, places: &mut Places<PLACES>) -> Option<Gap> {
        if places.beside(piece.point, piece.reach) {
            return None;
        }
        let spot = Spot { point: piece.point, at: Some(piece.mid) };
        let gap = disk::below(self.tool, self.whole, self.side, spot).ok()?;
        places.take(gap.surface_point);
        Some(gap)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gap::gap;
    use crate::shapes::mesh;
    use aptc_geometry::{Cutter, Profile, Vec3};
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(ProptestConfig { cases: 300, failure_persistence: None, ..ProptestConfig::default() })]

        /// In hollows and over crests narrower than the cutter no place of the surface is deeper in a tool that touches it.
        #[test]
        fn nothing_is_deeper_than_the_deepest_place_of_contact(
            waves in prop::array::uniform2(-6.0_f64..6.0), uneven in -0.5_f64..0.5,
            at in prop::array::uniform2(-0.7_f64..0.7), lean in prop::array::uniform2(-0.3_f64..0.3),
            (wide, corner) in (3.0_f64..16.0, 0.0_f64..1.0),
        ) {
            let surface = mesh(waves, 0.0, uneven);
            let Surface::Parametric(whole) = &surface else { panic!("a mesh") };
            let cutter = Cutter::mill(wide, 0.45 * wide * corner, 30.0);
            let profile = Profile::new(&cutter).unwrap();
            let ta = Vec3::new(lean[0], lean[1], 1.0).normalize();
            let above = Tool { profile: &profile, te: Vec3::new(45.0 * at[0], 40.0 * at[1], 25.0), ta };
            let Ok(far) = gap(&above, &surface, Side::Positive, 0.0) else { return Ok(()) };
            // Down along the axis until it touches.
            let mut tool = above;
            let mut last = far;
            for _ in 0..60 {
                tool = tool.at(tool.te - ta * last.raw);
                match gap(&tool, &surface, Side::Positive, 0.0) {
                    Ok(gap) => last = gap,
                    Err(_) => return Ok(()),
                }
            }
            prop_assume!(last.raw.abs() < 1e-6);
            for i in 0..240 {
                for j in 0..240 {
                    let share = |k: i32| (f64::from(k) + 0.5) / 240.0;
                    let p = whole.point([share(i), share(j)]);
                    prop_assert!(tool.distance(p) >= -2e-6, "{} at {p}: {tool:?} {last:?}", tool.distance(p));
                }
            }
        }
    }
}
