//! AVCTRL: a gouging position tilted or lifted until it is clear.

use std::cell::RefCell;

use aptc_geometry::{Profile, Transform, Vec3};

use crate::guard::{Guard, Seen};
use crate::position::{Position, tool_end};
use crate::retract::Retract;

/// How a gouge is avoided.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Avoid {
    pub(crate) on: bool,
    /// CUTANG: technological angle and range of the tilt, degrees.
    pub(crate) tilt: Option<[f64; 3]>,
    /// NORMPS: lift along the part normal; AXIS, along the tool axis, when false.
    pub(crate) along_normal: bool,
    /// LIMIT of the lift; none when omitted.
    pub(crate) limit: Option<f64>,
}

/// Degrees, positive towards forward (pitch) or the step-over (roll), and whether it is a roll.
pub(crate) type Tilt = (f64, bool);

/// Which tilts the positions of a path may have.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Tilts {
    /// The least each.
    #[default]
    Least,
    /// The least, but for one like that of the position before where the way to it is blocked.
    Alike,
    /// The least roll (else pitch), the same way.
    Alone { rolls: bool },
}

/// The kind of a tilt that is asked for, its sense, and the most that it may be.
#[derive(Clone, Copy)]
struct Like {
    rolls: bool,
    /// Back, or away from the step-over; either way where it is not said.
    back: Option<bool>,
    most: f64,
}

/// A tool that is clear, and what was done for it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Avoided {
    pub(crate) te: Vec3,
    pub(crate) ta: Vec3,
    pub(crate) tilt: Option<Tilt>,
    /// How far, and whether along the part normal; along the tool axis when false.
    pub(crate) lift: Option<(f64, bool)>,
}

/// Times as much as the least that a tilt may be for the axis not to jump.
const ALIKE: f64 = 1.5;
/// Tilts that are tried on each side.
const TILTS: u32 = 90;
/// Halvings towards the least tilt and the least lift that clear, until the tool is moved by no more than this part of the
/// room that it is given: nearer to the place where it is just clear each answer takes a longer proof.
const HALVINGS: u32 = 24;
const FINE: f64 = 0.1;
/// Looks by which a tilt or a lift is to be seen to clear. Beside the least that does each answer takes ever more, and a little
/// more of it few.
pub(crate) const AVOIDING: usize = 4000;
/// Places that are kept of those seen in the tool.
const SEEN: usize = 8;

/// Doublings of a way up that is looked for.
const DOUBLINGS: u32 = 20;
/// Share of the band by which a tilted tool is clearer than it has to be.
const ROOM: f64 = 0.25;

/// What a position is judged with.
pub(crate) struct Case<'a> {
    pub(crate) profile: &'a Profile,
    pub(crate) guard: &'a Guard,
    /// Thickness and what the position takes of the tolerance.
    pub(crate) clearance: f64,
    /// The same in the middle of the band.
    pub(crate) middle: f64,
    pub(crate) outtol: f64,
    /// Is the tool end on the part surface? There it stays when the tool is tilted.
    pub(crate) on: bool,
    /// Unit direction of the motion.
    pub(crate) forward: Vec3,
    /// Unit direction of the step-over, or across the path.
    pub(crate) over: Vec3,
    /// How the tool is led from where it touches to where it is put out; there it is to be clear.
    pub(crate) away: Option<Retract>,
    /// Places that were in the tool where it was tried before: most tilts that are not enough are told by one of them,
    /// without a search.
    pub(crate) seen: RefCell<Vec<Seen>>,
}

impl Case<'_> {
    fn room(&self) -> f64 {
        ROOM * (self.guard.intol + self.outtol)
    }

    /// The clearance in the middle of the band, with room beside it.
    fn roomy(&self) -> (f64, f64) {
        (self.clearance.max(self.middle), self.room())
    }

    /// So far from the least that clears a tilt or a lift may move the tool.
    fn fine(&self) -> f64 {
        FINE * self.room()
    }

    /// Is a tool that touches with this end and axis clear where it is put out, by so much more than it has to be?
    fn is_clear(&self, te: Vec3, ta: Vec3, room: f64) -> bool {
        let at = self.away.map_or((te, ta), |r| r.above((te, ta)));
        let intol = self.guard.intol - room;
        let mut seen = self.seen.borrow_mut();
        // The one that told last stands first.
        if let Some(i) = seen.iter().position(|s| self.guard.holds(self.profile, at, s, intol)) {
            seen[..=i].rotate_right(1);
            return false;
        }
        let Err(gouge) = self.guard.stands(self.profile, at, intol, AVOIDING) else { return true };
        if let Some(place) = gouge.seen {
            seen.truncate(SEEN - 1);
            seen.insert(0, *place);
        }
        false
    }
}

impl Avoid {
    /// A clear tool end and axis for the contact of `p`; `None` when tilt and lift within their limits
    /// give none. The lift starts from the tool as it was.
    ///
    /// APT: `AVOID`, with the tilt and the lift searched for, and each answer checked again.
    pub(crate) fn around(&self, p: &Position, case: &Case<'_>, tilts: Tilts) -> Option<Avoided> {
        if !self.on {
            return None;
        }
        // Two neighbours that are just clear have a way between them that is not: with room where there is any.
        let like = match tilts {
            Tilts::Alone { rolls } => Some(Like { rolls, back: None, most: f64::INFINITY }),
            Tilts::Least | Tilts::Alike => None,
        };
        let tilted = self.tilted(p, case, case.roomy(), like);
        tilted
            .or_else(|| self.tilted(p, case, (case.clearance, 0.0), like))
            .or_else(|| self.lifted(p, case))
    }

    /// The same by a tilt of the kind and sense of `before` alone, as a place beside it has, with room and not by much more than the
    /// `least`, that of another kind: the axis does not jump where both do nearly as well.
    pub(crate) fn alike(
        &self,
        p: &Position,
        case: &Case<'_>,
        [before, least]: [Tilt; 2],
    ) -> Option<Avoided> {
        let (back, most) = (Some(before.0 < 0.0), ALIKE * least.0.abs());
        let like = Like { rolls: before.1, back, most };
        if self.on { self.tilted(p, case, case.roomy(), Some(like)) } else { None }
    }

    /// The least tilt that clears, by pitch or roll, with the technological angle added in its direction
    /// and held within the range. Where that does not hold 0 the least is at one of its ends. The tool touches with that
    /// clearance, and nothing else of it comes nearer than `room` to what is allowed.
    fn tilted(
        &self,
        p: &Position,
        case: &Case<'_>,
        (clearance, room): (f64, f64),
        like: Option<Like>,
    ) -> Option<Avoided> {
        let [constant, a, b] = self.tilt?;
        let (low, high) = (a.min(b), a.max(b));
        // The tilt of the range next to none, from which the others are tried.
        let start = 0.0_f64.clamp(low, high);
        let lever = (p.te - p.contact).norm() + case.profile.reach();
        let place = |axis: Vec3, deg: f64| {
            let ta = Transform::rotation(axis, deg).vector(p.ta).normalize();
            let te = if case.on {
                p.te
            } else {
                tool_end(case.profile, ta, p.contact, p.normal, clearance, -case.forward)
            };
            // About the contact, not over to the other side of a flat bottom.
            let turn = deg.to_radians().abs();
            let reach = (p.te - p.contact).norm() + case.profile.widest();
            let turns = (te - p.te).norm() <= 2.0 * reach * turn + 1e-9 * reach;
            (turns && case.is_clear(te, ta, room)).then_some((te, ta))
        };
        // Turning about these moves the axis towards forward and towards the step-over.
        let axes = [p.ta.cross(&case.forward), p.ta.cross(&case.over)];
        let mut best: Option<(f64, Vec3, bool)> = None;
        for (rolls, axis) in [false, true].into_iter().zip(axes) {
            let Some(axis) = axis.try_normalize(1e-9) else { continue };
            let asked = |end: &f64| {
                let sense = |l: Like| l.back.is_none_or(|back| back == (*end < 0.0));
                like.is_none_or(|l| l.rolls == rolls && sense(l))
            };
            let most = like.map_or(f64::INFINITY, |l| l.most);
            for end in [low, high].into_iter().filter(asked) {
                let (mut clear, mut failed) = (None, start);
                // No tilt is known to gouge; any other that the range begins with is looked at too.
                for k in u32::from(start == 0.0)..=TILTS {
                    let deg = start + (end - start) * f64::from(k) / f64::from(TILTS);
                    if best.is_some_and(|(b, ..)| deg.abs() >= b.abs()) || deg.abs() > most {
                        break;
                    }
                    if place(axis, deg).is_some() {
                        clear = Some(deg);
                        break;
                    }
                    failed = deg;
                }
                let Some(mut found) = clear else { continue };
                for _ in 0..HALVINGS {
                    if (found - failed).abs().to_radians() * lever <= case.fine() {
                        break;
                    }
                    let mid = 0.5 * (found + failed);
                    if place(axis, mid).is_some() { found = mid } else { failed = mid }
                }
                best = Some((found, axis, rolls));
            }
        }
        let (deg, axis, rolls) = best?;
        let more = (deg + constant.abs().copysign(deg)).clamp(low, high);
        let tilted = |deg: f64| {
            let (te, ta) = place(axis, deg)?;
            Some(Avoided { te, ta, tilt: Some((deg, rolls)), lift: None })
        };
        tilted(more).or_else(|| tilted(deg))
    }

    /// Tool ends above two places close to each other between whose axes the answers jump, as from a tilt forward to one
    /// across, or that a lift leads to while the axis turns: straight up from the one, over, and down to the other, `to`, all
    /// clear and within LIMIT. Where a lift is along the normal, which may lead through a wall beside which the tool is clear, up and
    /// down are along the axis if they cannot be along the normal.
    pub(crate) fn over(
        &self,
        profile: &Profile,
        guard: &Guard,
        [a, b]: [(Vec3, Vec3); 2],
        to: &Position,
    ) -> Option<[Vec3; 2]> {
        if !self.on {
            return None;
        }
        let normal = self.along_normal.then_some(to.normal);
        let clear = |p, q| guard.lets_by(profile, [p, q]);
        let most = self.limit.map_or(1e3 * profile.reach(), |limit| limit - to.lift.norm());
        let over = |normal: Option<Vec3>| {
            let along = |axis: Vec3| normal.unwrap_or(axis);
            let mut high = 1e-3 * profile.reach();
            for _ in 0..DOUBLINGS {
                if high > most {
                    break;
                }
                let (up, down) = (a.0 + along(a.1) * high, b.0 + along(b.1) * high);
                let [above, below] = [(up, a.1), (down, b.1)];
                if clear(a, above) && clear(above, below) && clear(below, b) {
                    return Some([up, down]);
                }
                high *= 2.0;
            }
            None
        };
        over(normal).or_else(|| normal.and_then(|_| over(None)))
    }

    /// The least lift that clears.
    fn lifted(&self, p: &Position, case: &Case<'_>) -> Option<Avoided> {
        let along = if self.along_normal { p.normal } else { p.ta };
        let reach = case.profile.reach();
        let most = self.limit.unwrap_or(f64::INFINITY).min(1e3 * reach);
        let clear = |d: f64| case.is_clear(p.te + along * d, p.ta, 0.0);
        let (mut low, mut high) = (0.0, (1e-3 * reach).min(most));
        while !clear(high) {
            if high >= most {
                return None;
            }
            low = high;
            high = (2.0 * high).min(most);
        }
        for _ in 0..HALVINGS {
            if high - low <= case.fine() {
                break;
            }
            let mid = 0.5 * (low + high);
            if clear(mid) { high = mid } else { low = mid }
        }
        let lift = (high + case.outtol).min(most);
        let te = p.te + along * lift;
        let done = Some((lift, self.along_normal));
        clear(lift).then_some(Avoided { te, ta: p.ta, tilt: None, lift: done })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::guard::Checked;
    use crate::plain::Plain;
    use aptc_contact::PatchTree;
    use aptc_geometry::sculpt::{SplinePoint, mesh};
    use aptc_geometry::{Cutter, Form, Profile, Sphere, Surface};
    use std::sync::Arc;

    /// A flat wall beside the contact: the plane x = 2.5 from z = 2 to z = 12.
    fn wall() -> Guard {
        let row = |z: f64| {
            let at = |i| SplinePoint::plain(Vec3::new(2.5, f64::from(i) * 10.0 - 10.0, z));
            (0..3).map(at).collect()
        };
        let s = Arc::new(
            mesh(&[row(2.0), row(12.0)], aptc_geometry::sculptured::MeshSpacing::Ruled).unwrap(),
        );
        let tree = Arc::new(PatchTree::new(&s));
        let checked = Checked {
            name: "WALL".into(),
            surface: s,
            tree,
            part: false,
            thick: 0.0,
            own: None,
            facets: false,
            body: None,
        };
        Guard { surfaces: vec![checked], intol: 1e-3, thick: 0.0, ..Guard::default() }
    }

    /// A ball on the plane z = 0 at the origin, leaning to the wall.
    fn position(profile: &Profile) -> Position {
        let ta = Transform::rotation(Vec3::y(), 20.0).vector(Vec3::z());
        let te = tool_end(profile, ta, Vec3::zeros(), Vec3::z(), 0.0, Vec3::x());
        Position {
            te,
            ta,
            part_uv: [0.0; 2],
            contact: Vec3::zeros(),
            normal: Vec3::z(),
            shift: 0.0,
            drive_uv: [0.0; 2],
            segment: aptc_geometry::Segment::Arc,
            lift: Vec3::zeros(),
        }
    }

    /// Along x, with the step across along y.
    fn case<'a>(profile: &'a Profile, guard: &'a Guard) -> Case<'a> {
        Case {
            profile,
            guard,
            clearance: 0.0,
            middle: 0.0,
            outtol: 1e-3,
            on: false,
            forward: Vec3::x(),
            over: Vec3::y(),
            away: None,
            seen: RefCell::default(),
        }
    }

    #[test]
    fn tilt_succeeds_stays_in_range_or_gives_way_to_lift() {
        let profile = Profile::new(&Cutter::mill(4.0, 2.0, 30.0)).unwrap();
        let guard = wall();
        let p = position(&profile);
        assert!(guard.way(&profile, [(p.te, p.ta); 2]).is_err());
        let case = case(&profile, &guard);
        let tilt = |range: [f64; 3], limit| Avoid {
            on: true,
            tilt: Some(range),
            along_normal: true,
            limit,
        };
        // Away from the wall, which stands ahead: a negative pitch.
        let Avoided { te, ta, tilt: by, lift } =
            tilt([1.5, -60.0, 60.0], None).around(&p, &case, Tilts::Least).unwrap();
        assert!(by.is_some_and(|(deg, rolls)| deg < 0.0 && !rolls) && lift.is_none());
        assert!(ta.x < p.ta.x && ta.y.abs() < 1e-12);
        assert!(guard.way(&profile, [(te, ta); 2]).is_ok());
        // The ball still touches the same contact.
        assert!((te + ta * 2.0 - Vec3::z() * 2.0).norm() < 1e-12);
        let least = tilt([0.0, -60.0, 60.0], None).around(&p, &case, Tilts::Least).unwrap().ta;
        let between = aptc_geometry::trig::acos_clamped(least.dot(&ta)).to_degrees();
        assert!((between - 1.5).abs() < 1e-6, "{between}");
        // A range that does not suffice, then a lift along the normal, or none within its limit.
        let Avoided { te, ta, lift, .. } =
            tilt([0.0, -2.0, 2.0], None).around(&p, &case, Tilts::Least).unwrap();
        assert!(lift.is_some_and(|(_, normal)| normal));
        assert!(ta == p.ta && te.z > 5.0, "{te}");
        assert!(guard.way(&profile, [(te, ta); 2]).is_ok());
        assert!(tilt([0.0, -2.0, 2.0], Some(1.0)).around(&p, &case, Tilts::Least).is_none());
        // A range that does not hold 0: no tilt outside of it, and its nearest end where that suffices.
        let by =
            |range| tilt(range, Some(1.0)).around(&p, &case, Tilts::Least).and_then(|a| a.tilt);
        let (least, _) = by([0.0, -60.0, 60.0]).unwrap();
        for range in [[0.0, -60.0, least - 5.0], [0.0, least - 5.0, -60.0]] {
            let (deg, _) = by(range).unwrap();
            assert!((deg - (least - 5.0)).abs() < 1e-9, "{deg}");
        }
        let (deg, _) = by([0.0, -60.0, least + 5.0]).unwrap();
        assert!((deg - least).abs() < 1e-4, "{deg}");
        assert!(by([0.0, 3.0, 20.0]).is_none_or(|(deg, _)| (3.0..=20.0).contains(&deg)));
        // A tool end that lies on the surface stays there.
        let on = tilt([0.0, -60.0, 60.0], None)
            .around(&p, &Case { on: true, seen: RefCell::default(), ..case }, Tilts::Least)
            .unwrap();
        assert!(on.te == p.te && on.lift.is_none());
        assert!(Avoid::default().around(&p, &case, Tilts::Least).is_none());
    }

    /// A place that was in the tool tells only of tilts that a search tells of too.
    #[test]
    fn a_place_seen_before_tells_the_truth() {
        let profile = Profile::new(&Cutter::mill(4.0, 2.0, 30.0)).unwrap();
        let guard = wall();
        let p = position(&profile);
        let case = || case(&profile, &guard);
        let known = case();
        let mut told = 0;
        for k in -60..=60 {
            let ta = Transform::rotation(Vec3::y(), f64::from(k)).vector(p.ta);
            let te = tool_end(&profile, ta, p.contact, p.normal, 0.0, -Vec3::x());
            let before = known.seen.borrow().len();
            let clear = known.is_clear(te, ta, 0.0);
            assert_eq!(clear, case().is_clear(te, ta, 0.0), "{k}");
            told += usize::from(!clear && known.seen.borrow().len() == before);
        }
        assert!(told > 5 && known.seen.borrow().len() <= SEEN, "{told}");
    }

    /// Beside a sphere that is in the tool the part surface, which the tool touches, is not looked at.
    #[test]
    fn what_is_told_soonest_is_asked_first() {
        let profile = Profile::new(&Cutter::mill(4.0, 2.0, 30.0)).unwrap();
        let ball = Sphere { center: Vec3::new(0.0, 3.0, 5.0), radius: 4.0 };
        let plain = vec![Plain {
            name: "BALL".into(),
            form: Arc::new(Form::Point(ball.center)),
            surface: Arc::new(Surface::Sphere(ball)),
            from: None,
            thick: 0.0,
        }];
        let guard = Guard { plain, ..wall() };
        let p = position(&profile);
        let case = case(&profile, &guard);
        assert!(guard.way(&profile, [(p.te, p.ta); 2]).is_err_and(|g| g.surface == "WALL"));
        assert!(!case.is_clear(p.te, p.ta, 0.0) && case.seen.borrow().is_empty());
        let told = guard.stands(&profile, (p.te, p.ta), guard.intol, AVOIDING);
        assert!(told.is_err_and(|g| g.surface == "BALL"));
        // Without it the wall tells.
        let bare = wall();
        let case = Case { guard: &bare, ..case };
        assert!(!case.is_clear(p.te, p.ta, 0.0) && case.seen.borrow().len() == 1);
    }
}
