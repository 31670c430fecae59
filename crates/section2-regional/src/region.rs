//! ZIGZAG and PICKFD: a region path by path.

use aptc_geometry::{Plane, Vec3};

use crate::area::StepoverArea;
use crate::drive::Course;
use crate::failure::Failure;
use crate::path::{Broken, Setup};
use crate::position::Position;
use crate::stepover::parameter_step;

/// What is put out.
#[derive(Clone, Debug)]
pub(crate) enum Put {
    /// FEDRAT, unless it is 0.
    Feed(f64),
    /// Positions.
    Move(Vec<(Vec3, Vec3)>),
}

/// What a region is milled by.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Region<'a> {
    pub(crate) setup: Setup<'a>,
    pub(crate) stepover: StepoverArea,
    /// Feeds of path, side step, plunge, retract.
    pub(crate) feeds: [f64; 4],
    /// The clearance plane of PICKFD; ZIGZAG has none.
    pub(crate) clearance: Option<Plane>,
    pub(crate) course: Course,
    /// PLUS or MINUS along the path and across.
    pub(crate) senses: [f64; 2],
    /// The first point of the first path is not put out.
    pub(crate) skip: bool,
}

/// What came of a region.
#[derive(Debug)]
pub(crate) struct Done {
    pub(crate) puts: Vec<Put>,
    /// Least and greatest u and v of the drive between the first path and the last.
    pub(crate) range: [[f64; 2]; 2],
    pub(crate) why: Option<Failure>,
}

/// A region has at most so many paths.
const PATHS: usize = 1_000_000;

impl Region<'_> {
    /// Mills the region from `from` on.
    ///
    /// APT: `CUTREG`. The number of paths counts the side steps too, as it did.
    pub(crate) fn mill(&self, from: [f64; 2]) -> Done {
        let mut puts = Vec::new();
        let mut range = [[f64::INFINITY, f64::NEG_INFINITY]; 2];
        let why = self.paths(from, &mut puts, &mut range).err();
        Done { puts, range, why }
    }

    fn paths(
        &self,
        from: [f64; 2],
        out: &mut Vec<Put>,
        range: &mut [[f64; 2]; 2],
    ) -> Result<(), Failure> {
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
        let mut calls = 0;
        let mut here = from;
        let mut sense = along;
        let mut skip = self.skip;
        loop {
            let to = if sense * along > 0.0 { ends[1] } else { ends[0] };
            let points = self.run(&self.setup, here, (to, self.course, sense), skip, out)?;
            calls += 1;
            for p in points.first().into_iter().chain(points.last()) {
                for (r, x) in range.iter_mut().zip(p.drive_uv) {
                    *r = [r[0].min(x), r[1].max(x)];
                }
            }
            let Some(last) = points.last() else { break };
            let at = last.drive_uv[across.index()];
            let rest = (border - at) * over;
            if rest <= 1e-9 || calls >= most {
                break;
            }
            let step = self.next(&points);
            let target = if step >= rest * (1.0 - 1e-9) { border } else { at + over * step };
            skip = if self.clearance.is_some() {
                here = self.return_and_step(&points, here, target, out)?;
                false
            } else {
                here = self.side_step(last.drive_uv, target, out)?;
                sense = -sense;
                true
            };
            calls += 1;
            out.push(Put::Feed(self.feeds[0]));
            if calls >= most {
                break;
            }
        }
        Ok(())
    }

    /// One path; what was done of it is put out also when it breaks.
    fn run(
        &self,
        setup: &Setup<'_>,
        from: [f64; 2],
        (to, course, sense): (f64, Course, f64),
        skip: bool,
        out: &mut Vec<Put>,
    ) -> Result<Vec<Position>, Failure> {
        match setup.run(from, to, course, sense, None) {
            Ok(points) => {
                out.push(moves(&points, usize::from(skip)));
                Ok(points)
            }
            Err(broken) => {
                let Broken { done, why } = *broken;
                out.push(moves(&done, usize::from(skip)));
                Err(why)
            }
        }
    }

    /// The step across behind a path, to the next joint at most.
    fn next(&self, points: &[Position]) -> f64 {
        let Setup { drive, profile, .. } = self.setup;
        let step = parameter_step(&self.stepover, drive, profile, points, self.course);
        step.max(1e-6)
    }

    /// To the neighbouring path along the surface, lifted where a lift is asked for.
    fn side_step(
        &self,
        from: [f64; 2],
        target: f64,
        out: &mut Vec<Put>,
    ) -> Result<[f64; 2], Failure> {
        let across = self.course.across();
        let lift = self.stepover.lift;
        let mut setup = self.setup;
        setup.lift = lift;
        setup.fixed = None;
        out.push(Put::Feed(self.feeds[1]));
        self.run(&setup, from, (target, across, self.senses[1]), lift <= 0.0, out)?;
        let mut uv = from;
        uv[across.index()] = target;
        if lift > 0.0 {
            out.push(Put::Feed(self.feeds[2]));
            let (p, _) = self.setup.position(uv, across, self.senses[1], None, false)?;
            out.push(Put::Move(vec![(p.te, p.ta)]));
        }
        Ok(uv)
    }

    /// Up to the clearance plane, back over the first point of the path, down, and to the next one.
    fn return_and_step(
        &self,
        points: &[Position],
        start: [f64; 2],
        target: f64,
        out: &mut Vec<Put>,
    ) -> Result<[f64; 2], Failure> {
        let (Some(first), Some(last), Some(plane)) =
            (points.first(), points.last(), self.clearance)
        else {
            return Ok(start);
        };
        let above = |p: &Position| p.te - plane.n * plane.distance(p.te);
        out.push(Put::Feed(self.feeds[3]));
        out.push(Put::Move(vec![(above(last), last.ta), (above(first), first.ta)]));
        out.push(Put::Feed(self.feeds[2]));
        out.push(Put::Move(vec![(first.te, first.ta)]));
        self.side_step(start, target, out)
    }
}

fn moves(points: &[Position], skip: usize) -> Put {
    Put::Move(points.iter().skip(skip).map(|p| (p.te, p.ta)).collect())
}
