//! ZIGZAG and PICKFD: a region path by path.
//!
//! First the lines of all passes are laid, from places along each; then the passes are milled, each for
//! itself and on as many threads as there are; at last they are put out in their order.

use std::sync::OnceLock;
use std::sync::atomic::{AtomicUsize, Ordering};

use aptc_cldata::milling::{Extent, Scallop};
use aptc_geometry::{Plane, Vec3};

use crate::area::StepoverArea;
use crate::crew::Crew;
use crate::drive::Course;
use crate::failure::{Deep, Failure};
use crate::guard::Guard;
use crate::jump::Stands;
use crate::path::{Broken, Path};
use crate::position::{Odd, Position};
use crate::report::Note;
use crate::solve::{Memory, Setup, Take};
use crate::stepover::parameter_step;
use crate::touched::{Stand, Touched, links};

/// What is put out.
#[derive(Clone, Debug)]
pub(crate) enum Put {
    /// FEDRAT, unless it is 0.
    Feed(f64),
    /// Positions.
    Move(Vec<(Vec3, Vec3)>),
    /// Positions of a path, with the parameters of the drive.
    Path(Vec<Along>),
    /// The same of one that is lifted off the surface.
    Lifted(Vec<Along>),
    /// The same of one that got out of the way of something.
    Risen(Vec<Along>),
}

impl Put {
    /// A path that got out of the way or did not.
    pub(crate) fn path(along: Vec<Along>, avoided: bool) -> Self {
        if avoided { Self::Risen(along) } else { Self::Path(along) }
    }

    /// The places of the tool.
    fn places(&self) -> Vec<(Vec3, Vec3)> {
        match self {
            Self::Feed(_) => Vec::new(),
            Self::Move(points) => points.clone(),
            Self::Path(along) | Self::Lifted(along) | Self::Risen(along) => {
                along.iter().map(|a| a.at).collect()
            }
        }
    }
}

/// A position that belongs to a place of the drive.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Along {
    pub(crate) at: (Vec3, Vec3),
    /// Parameters of the drive.
    pub(crate) uv: [f64; 2],
}

impl Along {
    pub(crate) fn of(p: &Position) -> Self {
        Self { at: (p.te, p.ta), uv: p.drive_uv }
    }

    /// A path, without its first place if that is to be skipped; where the tool stands still one place.
    pub(crate) fn each(points: &[Position], skip: bool) -> Vec<Self> {
        let mut all: Vec<Self> = points.iter().map(Self::of).collect();
        all.dedup_by(|b, a| a.at == b.at);
        if skip && !all.is_empty() {
            all.remove(0);
        }
        all
    }
}

/// How the tool is led away from the surface between passes.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Retract {
    /// To a plane, along its normal.
    Plane(Plane),
    /// So far along the tool axis.
    Along(f64),
    /// By a vector.
    By(Vec3),
}

impl Retract {
    /// The tool led away.
    pub(crate) fn above(&self, (te, ta): (Vec3, Vec3)) -> (Vec3, Vec3) {
        let te = match self {
            Self::Plane(plane) => te - plane.n * plane.distance(te),
            Self::Along(d) => te + ta * *d,
            Self::By(v) => te + v,
        };
        (te, ta)
    }

    /// From one place of the tool to another by way of those above them.
    pub(crate) fn over(&self, from: (Vec3, Vec3), to: (Vec3, Vec3)) -> [(Vec3, Vec3); 3] {
        [self.above(from), self.above(to), to]
    }
}

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
    pub(crate) fn scallop(&self, height: f64, extent: impl FnOnce() -> Extent) -> Option<Scallop> {
        // Beside a single pass nothing lies between.
        let asked = height > 0.0 && self.why.is_none() && self.touched.len() > 1;
        let (avoided, links) = (self.avoided, links(&self.touched));
        asked.then(|| Scallop { height, extent: extent(), avoided, links })
    }
}

/// A pass before it is milled.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Lane {
    pub(crate) from: [f64; 2],
    pub(crate) to: f64,
    pub(crate) sense: f64,
    /// Is it the first of all?
    leads: bool,
    /// The other parameter of the next pass; none behind the last.
    pub(crate) next: Option<f64>,
}

/// A pass that is milled.
#[derive(Debug, Default)]
struct Pass {
    puts: Vec<Put>,
    notes: Vec<Note>,
    avoided: bool,
    odd: Odd,
    first: Option<(Vec3, Vec3)>,
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
/// A region has at most so many paths.
const PATHS: usize = 1_000_000;
/// Places in a span of the drive at which the width of a step is judged.
const PLACES: f64 = 5.0;
/// Rounds that narrow a step.
const ROUNDS: usize = 8;
/// And along a whole path at most.
const MOST: usize = 20_000;

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
        for (i, slot) in slots.into_iter().enumerate() {
            let Some(pass) = slot.into_inner() else {
                done.why = Some(Failure::Stopped { done: i, all: n });
                break;
            };
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

    /// Where the passes begin.
    pub(crate) fn lines(&self, from: [f64; 2]) -> Vec<[f64; 2]> {
        self.lanes(from).into_iter().map(|l| l.from).collect()
    }

    /// The passes, from the width that the scallop allows along each.
    fn lanes(&self, from: [f64; 2]) -> Vec<Lane> {
        let k = self.course.index();
        let across = self.course.across();
        let [along, over] = self.senses;
        let limits = self.setup.drive.limits(self.course);
        let ends = if self.clearance.is_some() {
            // The quadrant from the start.
            if along > 0.0 { [from[k], limits[1]] } else { [from[k], limits[0]] }
        } else if along > 0.0 {
            [limits[0], limits[1]]
        } else {
            [limits[1], limits[0]]
        };
        let border = self.setup.drive.limits(across)[usize::from(over > 0.0)];
        let most = self.stepover.paths.unwrap_or(PATHS);
        let mut lanes: Vec<Lane> = Vec::new();
        let (mut here, mut sense) = (from, along);
        let mut calls = 1;
        let mut known = None;
        loop {
            let to = if sense * along > 0.0 { ends[1] } else { ends[0] };
            let at = here[across.index()];
            let rest = (border - at) * over;
            let leads = lanes.is_empty();
            let mut lane = Lane { from: here, to, sense, leads, next: None };
            if rest <= 1e-9 || calls >= most {
                lanes.push(lane);
                return lanes;
            }
            let step = self.step(&lane, &mut known);
            let target = if step >= rest * (1.0 - 1e-9) { border } else { at + over * step };
            lane.next = Some(target);
            lanes.push(lane);
            calls += 1;
            if calls >= most {
                return lanes;
            }
            calls += 1;
            here[across.index()] = target;
            if self.clearance.is_none() {
                here[k] = to;
                sense = -sense;
            }
        }
    }

    /// The step across from a pass: as wide as it may be there, half way and at the next, so that neither a
    /// joint of the parameter nor a change of curvature between leaves more than what is asked for.
    fn step(&self, lane: &Lane, known: &mut Option<(f64, f64)>) -> f64 {
        let across = self.course.across().index();
        let over = self.senses[1];
        let limits = self.setup.drive.limits(self.course.across());
        let at = lane.from[across];
        let mut width = |away: f64| {
            let mut line = *lane;
            line.from[across] = (at + over * away).clamp(limits[0], limits[1]);
            match *known {
                Some((v, width)) if (v - line.from[across]).abs() <= 1e-15 => width,
                _ => {
                    let width = self.width(&line);
                    *known = Some((line.from[across], width));
                    width
                }
            }
        };
        let mut step = width(0.0);
        for _ in 0..ROUNDS {
            let narrow = width(0.5 * step).min(width(step));
            if narrow >= step * (1.0 - 1e-3) {
                step = step.min(narrow);
                break;
            }
            // Not below what a change of speed at a joint asks for, in few rounds.
            step = narrow.max(0.25 * step);
        }
        if self.stepover.scallop > 0.0 {
            self.followed(lane, self.closed(lane, step))
        } else {
            step
        }
    }

    /// The step of the parameter that the places along a line allow.
    fn width(&self, lane: &Lane) -> f64 {
        let k = self.course.index();
        let length = lane.to - lane.from[k];
        let mut n = (length.abs() * PLACES).ceil().clamp(PLACES, MOST as f64);
        if self.stepover.scallop <= 0.0 && self.stepover.most <= 0.0 {
            // The step is one of the parameter.
            n = 1.0;
        }
        let mut points = Vec::new();
        let at = |t: f64, memory: Option<Memory>| {
            let mut uv = lane.from;
            uv[k] = t;
            self.setup.position(uv, self.course, lane.sense, memory, Take::Nothing).ok()
        };
        let mut before: Option<(Position, Memory)> = None;
        let mut i = 0.0;
        while i <= n {
            // What cannot be reached the pass will tell.
            if let Some(now) = at(lane.from[k] + length * (i / n), before.map(|b| b.1)) {
                if let Some(last) = before {
                    points.extend(self.abreast([last, now], &at));
                }
                points.push(now.0);
                before = Some(now);
            }
            i += 1.0;
        }
        parameter_step(&self.stepover, &self.setup, &points, self.course).max(1e-6)
    }

    /// The place between two of a pass at which the tool stands square beside its contact: over a crest across the pass the bottom
    /// goes from behind the contact to before it, and reaches least to the side there.
    fn abreast(
        &self,
        [mut a, mut b]: [(Position, Memory); 2],
        at: &impl Fn(f64, Option<Memory>) -> Option<(Position, Memory)>,
    ) -> Option<Position> {
        /// Halvings.
        const TIMES: u32 = 10;
        let k = self.course.index();
        let ahead = |p: &Position| {
            (p.te - p.contact).dot(&self.setup.drive.place(p.drive_uv, self.course).along)
        };
        if self.setup.profile.corner()[0] <= 0.0 || ahead(&a.0) * ahead(&b.0) >= 0.0 {
            return None;
        }
        for _ in 0..TIMES {
            let mid = at(0.5 * (a.0.drive_uv[k] + b.0.drive_uv[k]), Some(a.1))?;
            let same = ahead(&mid.0) * ahead(&a.0) > 0.0;
            *(if same { &mut a } else { &mut b }) = mid;
        }
        Some(a.0)
    }

    /// A pass with the way to the next.
    fn pass(&self, lane: &Lane, out: &mut Pass) -> Result<(), Failure> {
        let first = match (lane.leads, self.skip) {
            (true, true) => First::Left,
            (true, false) => First::Out,
            (false, _) => First::After(self.corner(lane.from)?),
        };
        let setup = Setup { joins: true, ..self.setup };
        let course = (lane.to, self.course, lane.sense);
        let (points, rolls) = self.run(&setup, lane.from, course, first, out)?;
        // Of passes that go to and fro the contacts are kept in one direction.
        let stands = points.first().into_iter().chain(rolls.iter().flatten()).chain(points.last());
        let stands = stands.map(Stand::of).collect();
        out.touched = Touched::by(points.iter().map(|p| p.part_uv), stands, lane.sense < 0.0);
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
        let (Path { points, notes, avoided, rolls }, why) = match setup.run(from, to, course, sense)
        {
            Ok(path) => (path, None),
            Err(broken) => {
                let Broken { done, why } = *broken;
                (done, Some(why))
            }
        };
        let start = points.first().map(|p| (p.te, p.ta));
        let skip = match (first, points.first()) {
            (First::Out, _) | (First::After(_) | First::From(_), None) => false,
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
                way.map_err(|g| Failure::gouge(deepest(g), corner.0, corner.1, avoid.on))?;
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
                Err(Failure::gouge(gouge, start.0, start.1, avoid.on))
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
        let mut here = from;
        for &to in way {
            let found = self.ways.way(self.setup.profile, [here, to]);
            found.map_err(|gouge| {
                let gouge = self.ways.deepest(self.setup.profile, [here, to], gouge);
                let (te, ta) = to;
                Failure::PickFeed(Box::new(Deep { gouge, te, ta, avoids: false }))
            })?;
            here = to;
        }
        Ok(())
    }
}
