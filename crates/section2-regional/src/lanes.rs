//! The passes of a region before they are milled: where they lie, from the width of step that is allowed along each.

use crate::position::Position;
use crate::region::Region;
use crate::solve::{Memory, Take};
use crate::stepover::parameter_step;

/// A pass before it is milled.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Lane {
    pub(crate) from: [f64; 2],
    pub(crate) to: f64,
    pub(crate) sense: f64,
    /// Is it the first of all?
    pub(crate) leads: bool,
    /// The other parameter of the next pass; none behind the last.
    pub(crate) next: Option<f64>,
}

/// A region has at most so many paths.
const PATHS: usize = 1_000_000;
/// Places in a span of the drive at which the width of a step is judged.
const PLACES: f64 = 5.0;
/// Rounds that narrow a step.
const ROUNDS: usize = 8;
/// And along a whole path at most.
const MOST: usize = 20_000;

impl Region<'_> {
    /// Where the passes begin.
    pub(crate) fn lines(&self, from: [f64; 2]) -> Vec<[f64; 2]> {
        self.lanes(from).into_iter().map(|l| l.from).collect()
    }

    /// The passes, from the width that the scallop allows along each.
    pub(crate) fn lanes(&self, from: [f64; 2]) -> Vec<Lane> {
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
}
