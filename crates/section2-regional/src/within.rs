//! Lines that REGION limits: only the stretches of them that the outlines leave are milled.

use std::sync::OnceLock;

use aptc_geometry::Vec3;

use crate::crew::Crew;
use crate::drive::Course;
use crate::failure::Failure;
use crate::goloft::at_line;
use crate::path::{Broken, Path};
use crate::position::Odd;
use crate::put::{Along, Put};
use crate::region::Region;
use crate::report::Note;
use crate::retract::Retract;
use crate::strips::Strip;
use crate::touched::Touched;

/// What is left of a line: the other parameter, and from where to where it is milled.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Stretch {
    /// Number of the line, from the first.
    pub(crate) line: usize,
    pub(crate) fixed: f64,
    pub(crate) from: f64,
    pub(crate) to: f64,
}

/// What came of the stretches.
#[derive(Debug, Default)]
pub(crate) struct Done {
    pub(crate) puts: Vec<Put>,
    pub(crate) notes: Vec<Note>,
    /// Did the tool get out of the way somewhere?
    pub(crate) avoided: bool,
    /// What is odd about its positions.
    pub(crate) odd: Odd,
    /// What each stretch touches of the part surface.
    pub(crate) strips: Vec<Strip>,
    pub(crate) why: Option<Failure>,
}

/// Mills stretches one after the other; from each to the next the tool is led away, over and back.
///
/// # Errors
/// There are several, and nothing says how the tool is led away.
pub(crate) fn mill(
    region: &Region<'_>,
    stretches: &[Stretch],
    retract: Option<Retract>,
    crew: &dyn Crew,
) -> Result<Done, Failure> {
    if stretches.len() > 1 && retract.is_none() {
        return Err(Failure::NotSet { areas: vec!["FEED,plane"] });
    }
    let n = stretches.len();
    let slots: Vec<OnceLock<Result<Path, Box<Broken>>>> = (0..n).map(|_| OnceLock::new()).collect();
    crew.run(n, &|i| {
        let (Some(slot), Some(stretch)) = (slots.get(i), stretches.get(i)) else { return };
        if !crew.is_stopped() {
            // Each job fills its own slot, once.
            let _ = slot.set(along(region, *stretch));
        }
    });
    let mut done = Done::default();
    let mut last: Option<(Vec3, Vec3)> = None;
    for (i, (slot, stretch)) in slots.into_iter().zip(stretches).enumerate() {
        let (path, why) = match slot.into_inner() {
            None => (Path::default(), Some(Failure::Stopped { done: i, all: n })),
            Some(Ok(path)) => (path, None),
            Some(Err(broken)) => {
                let Broken { done, why } = *broken;
                (done, Some(why))
            }
        };
        let contacts = path.points.iter().map(|p| p.part_uv).collect();
        let touched = Touched::of(&path.points, &path.rolls, contacts, stretch.to < stretch.from);
        done.strips.push(Strip { line: stretch.line, touched });
        let Path { points, notes, avoided, .. } = path;
        done.avoided |= avoided;
        done.odd = done.odd.or(Odd::of(&points));
        let points: Vec<Along> = points.iter().map(Along::of).collect();
        if let (Some(from), Some(to), Some(retract)) = (last, points.first(), &retract) {
            let way = retract.over(from, to.at);
            if let Err(blocked) = region.clear(from, &way) {
                done.why = Some(blocked);
                break;
            }
            let [up, across, _] = way;
            done.puts.push(Put::Move(vec![up, across]));
        }
        last = points.last().map(|p| p.at).or(last);
        done.puts.push(Put::Path(points));
        done.notes.extend(notes);
        if why.is_some() {
            done.why = why;
            break;
        }
    }
    Ok(done)
}

fn along(region: &Region<'_>, s: Stretch) -> Result<Path, Box<Broken>> {
    let course: Course = region.course;
    let sense = if s.to > s.from { 1.0 } else { -1.0 };
    region.setup.run(at_line(course, s.fixed, s.from), s.to, course, sense)
}
