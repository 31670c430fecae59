//! ZIGZAG and PICKFD: a region path by path.
//!
//! First the lines of all passes are laid, from places along each; then the passes are milled, each for
//! itself and on as many threads as there are; at last they are put out in their order.

use std::sync::OnceLock;
use std::sync::atomic::{AtomicUsize, Ordering};

use aptc_cldata::milling::{Extent, Scallop};
use aptc_geometry::Vec3;

use crate::area::{Hold, StepoverArea};
use crate::avoid::Avoid;
use crate::crew::Crew;
use crate::drive::Course;
use crate::failure::{Deep, Failure};
use crate::guard::Guard;
use crate::jump::Stands;
use crate::lanes::Lane;
use crate::path::{Broken, Path};
use crate::position::{Odd, Position};
use crate::put::{Along, Put};
use crate::report::Note;
use crate::retract::Retract;
use crate::solve::Setup;
use crate::touched::{Touched, links};

/// What a region is milled by.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Region<'a> {
    pub(crate) setup: Setup<'a>,
    pub(crate) stepover: StepoverArea,
    /// Feeds of path, side step, plunge, retract.
    pub(crate) feeds: [f64; 4],
    /// How PICKFD comes back; ZIGZAG does not.
    pub(crate) clearance: Option<Retract>,
    /// What the ways over the clearance plane are held against.
    pub(crate) ways: &'a Guard,
    pub(crate) course: Course,
    /// PLUS or MINUS along the path and across.
    pub(crate) senses: [f64; 2],
    /// The first point of the first path is not put out.
    pub(crate) skip: bool,
}

/// Why more may stand somewhere than a scallop allows.
pub(crate) const GOT_OUT: &str = "the tool got out of the way";

/// What came of a region.
#[derive(Debug, Default)]
pub(crate) struct Done {
    pub(crate) puts: Vec<Put>,
    pub(crate) notes: Vec<Note>,
    /// Did the tool get out of the way somewhere?
    pub(crate) avoided: bool,
    pub(crate) odd: Odd,
    /// The first position, put out or not.
    pub(crate) first: Option<(Vec3, Vec3)>,
    /// What each pass touches of the part surface.
    pub(crate) touched: Vec<Touched>,
    /// What is left where the contact jumps, if no scallop is asked for.
    pub(crate) stands: Option<Stands>,
    pub(crate) why: Option<Failure>,
}

impl Done {
    /// What is promised of the places between the passes, where a scallop of this height is asked for.
    ///
    /// `led`: it is the tool that is led, over another surface.
    pub(crate) fn scallop(
        &self,
        height: f64,
        extent: impl FnOnce() -> Extent,
        led: bool,
    ) -> Option<Scallop> {
        // Beside a single pass nothing lies between.
        let asked = height > 0.0 && self.why.is_none() && self.touched.len() > 1;
        let why = self.avoided.then_some(GOT_OUT);
        let excused = why.or(led.then_some("the tool end is led over another surface"));
        let links = links(&self.touched);
        asked.then(|| Scallop { height, extent: extent(), excused, links })
    }
}

/// A pass that is milled.
#[derive(Debug, Default)]
struct Pass {
    puts: Vec<Put>,
    notes: Vec<Note>,
    avoided: bool,
    odd: Odd,
    first: Option<(Vec3, Vec3)>,
    /// The first position, where the tool comes to it from the pass before.
    begin: Option<Position>,
    touched: Touched,
    why: Option<Failure>,
}

/// What becomes of the first point of a path.
#[derive(Clone, Copy, Debug)]
enum First {
    /// It is put out.
    Out,
    /// It is left out.
    Left,
    /// It is put out unless the tool, which stands here, is there already.
    After((Vec3, Vec3)),
    /// It is put out, and the tool comes from here.
    From((Vec3, Vec3)),
    /// It is put out, until it is known where the pass before ends.
    Behind,
}

/// How the tool comes from where it stands to the first place of a path.
enum Joint {
    /// It is there.
    There,
    /// By a cut vector.
    Way,
    /// Over these, as the way there gouges and is avoided.
    Over([(Vec3, Vec3); 2]),
}

/// Places of the tool, and axes, so near to each other for the size of the numbers are the same.
const SAME: f64 = 1e-9;

impl Region<'_> {
    /// Mills the region from `from` on.
    ///
    /// APT: `CUTREG`. The number of paths counts the side steps too, as it did.
    pub(crate) fn mill(&self, from: [f64; 2], crew: &dyn Crew) -> Done {
        // What cannot begin needs no lines.
        let joins = Setup { joins: true, ..self.setup };
        if let Err(why) = joins.settled(from, self.course, self.senses[0], None, joins.at_end()) {
            return Done { why: Some(why), ..Done::default() };
        }
        let lanes = self.lanes(from);
        let n = lanes.len();
        let slots: Vec<OnceLock<Pass>> = (0..n).map(|_| OnceLock::new()).collect();
        // Nothing behind a pass that fails is put out, so it need not be milled.
        let first_failed = AtomicUsize::new(n);
        crew.run(n, &|i| {
            let (Some(slot), Some(lane)) = (slots.get(i), lanes.get(i)) else { return };
            if crew.is_stopped() || i > first_failed.load(Ordering::Relaxed) {
                return;
            }
            let mut pass = Pass::default();
            pass.why = self.pass(lane, &mut pass).err();
            if pass.why.is_some() {
                first_failed.fetch_min(i, Ordering::Relaxed);
            }
            // Each job fills its own slot, once.
            let _ = slot.set(pass);
        });
        let mut done = Done::default();
        let mut touched = Vec::with_capacity(n);
        let asked = self.stepover.scallop > 0.0;
        let mut ways = Vec::new();
        let mut stand = None;
        for (i, slot) in slots.into_iter().enumerate() {
            let Some(mut pass) = slot.into_inner() else {
                done.why = Some(Failure::Stopped { done: i, all: n });
                break;
            };
            if let Some(stand) = stand
                && let Err(why) = self.link(stand, &mut pass)
            {
                done.why = Some(why);
                break;
            }
            stand = pass.puts.iter().rev().find_map(Put::last).or(stand);
            touched.push(pass.touched);
            if !asked {
                // From where the one before ends.
                let before = ways.last().and_then(|way: &Vec<_>| way.last().copied());
                ways.push(
                    before.into_iter().chain(pass.puts.iter().flat_map(Put::places)).collect(),
                );
            }
            done.puts.extend(pass.puts);
            done.notes.extend(pass.notes);
            done.avoided |= pass.avoided;
            done.odd = done.odd.or(pass.odd);
            done.first = done.first.or(pass.first);
            if pass.why.is_some() {
                done.why = pass.why;
                break;
            }
        }
        done.touched = touched;
        if !asked && done.why.is_none() {
            let band = self.setup.band.intol + self.setup.band.outtol;
            done.stands = self.stands(&lanes, &ways).filter(|s| s.height > band);
        }
        done
    }

    /// Is a scallop asked for between passes that another surface leads?
    fn is_outlined(&self) -> bool {
        let at = self.setup.drive.hold == Hold::At;
        self.stepover.scallop > 0.0 && at && !self.setup.same_surface()
    }

    /// A pass with the way to the next.
    fn pass(&self, lane: &Lane, out: &mut Pass) -> Result<(), Failure> {
        let first = match (lane.leads, self.skip) {
            (true, true) => First::Left,
            (true, false) => First::Out,
            (false, _) => First::Behind,
        };
        let setup = Setup { joins: true, ..self.setup };
        let course = (lane.to, self.course, lane.sense);
        let (points, rolls) = self.run(&setup, lane.from, course, first, out)?;
        // The first and the last one are sides of the outline of what is judged between the passes.
        let side = lane.leads || lane.next.is_none();
        let contacts = if side && self.is_outlined() {
            setup.contacts(&points, (self.course, lane.sense))
        } else {
            points.iter().map(|p| p.part_uv).collect()
        };
        // Of passes that go to and fro the contacts are kept in one direction.
        out.touched = Touched::of(&points, &rolls, contacts, lane.sense < 0.0);
        let Some(target) = lane.next else { return Ok(()) };
        let mut from = lane.from;
        let stand = if self.clearance.is_some() {
            self.over(&points, out)?;
            points.first()
        } else {
            from[self.course.index()] = lane.to;
            points.last()
        };
        self.side_step(from, target, stand.map(|p| (p.te, p.ta)), out)?;
        out.puts.push(Put::Feed(self.feeds[0]));
        Ok(())
    }

    /// One path, with its rolls over edges; what was done of it is put out also when it breaks.
    fn run(
        &self,
        setup: &Setup<'_>,
        from: [f64; 2],
        (to, course, sense): (f64, Course, f64),
        first: First,
        out: &mut Pass,
    ) -> Result<(Vec<Position>, Vec<[Position; 2]>), Failure> {
        let (Path { points, notes, avoided, rolls, .. }, why) =
            match setup.run(from, to, course, sense) {
                Ok(path) => (path, None),
                Err(broken) => {
                    let Broken { done, why } = *broken;
                    (done, Some(why))
                }
            };
        let start = points.first().map(|p| (p.te, p.ta));
        let skip = match (first, points.first()) {
            (First::Out, _) | (First::After(_) | First::From(_), None) => false,
            (First::Behind, start) => {
                out.begin = start.copied();
                false
            }
            (First::Left, _) => true,
            (First::After(stand) | First::From(stand), Some(start)) => {
                match self.joined(setup, stand, start)? {
                    Joint::There => matches!(first, First::After(_)),
                    Joint::Way => false,
                    Joint::Over(way) => {
                        out.puts.push(Put::Move(way.to_vec()));
                        out.avoided = true;
                        false
                    }
                }
            }
        };
        let along = Along::each(&points, skip);
        let lifted = setup.lift > 0.0;
        out.puts.push(if lifted { Put::Lifted(along) } else { Put::path(along, avoided) });
        out.notes.extend(notes);
        out.avoided |= avoided;
        out.odd = out.odd.or(Odd::of(&points));
        out.first = out.first.or(start);
        why.map_or(Ok((points, rolls)), Err)
    }

    /// Brings the tool from where it stands at the end of a pass to the beginning of the next. Where it got out of the way on the step
    /// across it stands there as the step has led it, which is not as it would if it began there.
    fn link(&self, stand: (Vec3, Vec3), pass: &mut Pass) -> Result<(), Failure> {
        let Some(begin) = pass.begin else { return Ok(()) };
        let setup = Setup { joins: true, ..self.setup };
        match self.joined(&setup, stand, &begin)? {
            Joint::There => {
                if let Some(first) = pass.puts.first_mut() {
                    first.leave_first();
                }
            }
            Joint::Way => {}
            Joint::Over(way) => {
                pass.puts.insert(0, Put::Move(way.to_vec()));
                pass.avoided = true;
            }
        }
        Ok(())
    }

    /// To the neighbouring path along the surface, lifted where a lift is asked for.
    fn side_step(
        &self,
        from: [f64; 2],
        target: f64,
        stand: Option<(Vec3, Vec3)>,
        out: &mut Pass,
    ) -> Result<(), Failure> {
        let across = self.course.across();
        let lift = self.stepover.lift;
        let setup = Setup { lift, joins: true, ..self.setup };
        out.puts.push(Put::Feed(self.feeds[1]));
        let first = stand.map_or(First::Out, if lift > 0.0 { First::From } else { First::After });
        let (points, _) = self.run(&setup, from, (target, across, self.senses[1]), first, out)?;
        let mut uv = from;
        uv[across.index()] = target;
        if lift > 0.0 {
            let corner = self.corner(uv)?;
            if let (Some(last), Some((guard, avoid))) = (points.last(), setup.guard) {
                let ends = [(last.te, last.ta), corner];
                let deepest = |gouge| guard.deepest(setup.profile, ends, gouge);
                let way = guard.way(setup.profile, ends);
                way.map_err(|g| Failure::gouge(deepest(g), corner.0, corner.1, avoid))?;
            }
            out.puts.push(Put::Feed(self.feeds[2]));
            out.puts.push(Put::Move(vec![corner]));
        }
        Ok(())
    }

    /// Where a side step ends.
    fn corner(&self, uv: [f64; 2]) -> Result<(Vec3, Vec3), Failure> {
        let across = self.course.across();
        let setup = Setup { joins: true, ..self.setup };
        let path = setup.run(uv, uv[across.index()], across, self.senses[1]);
        let points = path.map_err(|broken| broken.why)?.points;
        let last = points.last().ok_or(Failure::NoAxis { uv })?;
        Ok((last.te, last.ta))
    }

    /// Does the tool stand already where a path begins? If not, as the axis turns with the direction of the
    /// path, the way there keeps out of what is checked, over it where that is avoided.
    fn joined(
        &self,
        setup: &Setup<'_>,
        stand: (Vec3, Vec3),
        first: &Position,
    ) -> Result<Joint, Failure> {
        let start = (first.te, first.ta);
        let near = SAME * (setup.part.extent + setup.profile.reach());
        if (stand.0 - start.0).norm() <= near && (stand.1 - start.1).norm() <= SAME {
            return Ok(Joint::There);
        }
        let Some((guard, avoid)) = setup.guard else { return Ok(Joint::Way) };
        let Err(gouge) = guard.way(setup.profile, [stand, start]) else { return Ok(Joint::Way) };
        match avoid.over(setup.profile, guard, [stand, start], first) {
            Some([up, down]) => Ok(Joint::Over([(up, stand.1), (down, start.1)])),
            None => {
                let gouge = guard.deepest(setup.profile, [stand, start], gouge);
                Err(Failure::gouge(gouge, start.0, start.1, avoid))
            }
        }
    }

    /// Up to the clearance plane, back over the first point of the path, and down.
    fn over(&self, points: &[Position], out: &mut Pass) -> Result<(), Failure> {
        let (Some(first), Some(last), Some(retract)) =
            (points.first(), points.last(), self.clearance)
        else {
            return Ok(());
        };
        let way = retract.over((last.te, last.ta), (first.te, first.ta));
        self.clear((last.te, last.ta), &way)?;
        let [up, back, down] = way;
        out.puts.push(Put::Feed(self.feeds[3]));
        out.puts.push(Put::Move(vec![up, back]));
        out.puts.push(Put::Feed(self.feeds[2]));
        out.puts.push(Put::Move(vec![down]));
        Ok(())
    }

    /// A way between passes goes through no surface.
    pub(crate) fn clear(&self, from: (Vec3, Vec3), way: &[(Vec3, Vec3)]) -> Result<(), Failure> {
        let profile = self.setup.profile;
        // What stands in a surface where it is would do so on any way.
        let stands = |at: (Vec3, Vec3), word| {
            let gouge = self.ways.way(profile, [at, at]).err()?;
            let gouge = self.ways.deepest(profile, [at, at], gouge);
            let (te, ta) = at;
            Some(Failure::Stands(Box::new(Deep { gouge, te, ta, avoids: Avoid::default() }), word))
        };
        let mut here = from;
        for &to in way {
            let found = self.ways.way(profile, [here, to]);
            found.map_err(|gouge| {
                let ends = if here == from { stands(from, "ends") } else { None };
                let begins = || if way.last() == Some(&to) { stands(to, "begins") } else { None };
                if let Some(why) = ends.or_else(begins) {
                    return why;
                }
                let gouge = self.ways.deepest(profile, [here, to], gouge);
                let (te, ta) = to;
                Failure::PickFeed(Box::new(Deep { gouge, te, ta, avoids: Avoid::default() }))
            })?;
            here = to;
        }
        Ok(())
    }
}
