//! A CL file of whatever origin brought together with the motions of a program.
//!
//! A CL file says where the tool goes, not which surfaces sent it there. The motions of the program are
//! found in it by statement numbers where it has them, and else by the places where motions end; each
//! then gets the positions of the file in place of its own. TRACUT and COPY are undone: surfaces are held
//! against the path as it was before editing.

mod align;
mod unfold;

use aptc_cldata::{Kind, Motion, MotionKind, Position, Record, Units, flatten};
use aptc_diagnostics::Origin;
use aptc_geometry::{Transform, Vec3};

use align::{common, ends};
use unfold::{Item, unfold};

/// What the file's records say of the statements they come from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Marks {
    /// Statement numbers, as APT-360's binary file has them.
    Statements,
    /// Lines of the program, as the text that aptc writes has them.
    Lines,
    /// Nothing.
    None,
}

/// The program's records with the positions of a file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Matched {
    /// To be judged.
    pub records: Vec<Record>,
    /// Motions of the program that were not found in the file.
    pub missing: Vec<Origin>,
    /// Positions of the file that belong to no motion of the program.
    pub extra: u64,
    /// How many motions end where the program has them, of how many.
    pub at_home: [usize; 2],
    /// The first that does not.
    pub astray: Option<Astray>,
}

/// A motion that the file does not have, or that ends elsewhere there.
#[derive(Clone, Debug, PartialEq)]
pub struct Astray {
    /// Its statement.
    pub origin: Origin,
    /// Where the program has its end, in the program's unit.
    pub here: Vec3,
    /// Where the file has it.
    pub there: Option<Vec3>,
}

impl Matched {
    /// Is the file of another program? One that has gone wrong has most motions where they belong.
    pub fn is_of_another(&self) -> bool {
        let [n, of] = self.at_home;
        2 * n < of
    }
}

/// Chords that stand for an arc of which a file gives only the end lie this near to it, in millimetres.
const ARC_CHORDS: f64 = 1e-5;
/// The end of a motion is looked for within this share of the size of the path.
const NEAR: f64 = 0.01;

/// Brings the file's positions to the program's motions; the reason when that is not possible. Where the
/// file's marks are those of another program, or of this one before lines were put in, the places count.
pub fn matched(program: &[Record], file: &[Record], marks: Marks) -> Result<Matched, String> {
    let found = matched_by(program, file, marks)?;
    if marks == Marks::None || !found.is_of_another() {
        return Ok(found);
    }
    Ok(matched_by(program, file, Marks::None).ok().filter(|f| !f.is_of_another()).unwrap_or(found))
}

fn matched_by(program: &[Record], file: &[Record], marks: Marks) -> Result<Matched, String> {
    let items = unfold(program)?;
    let points = positions(file);
    let motions: Vec<usize> = (0..items.len()).filter(|&i| items[i].motion().is_some()).collect();
    let size = points.iter().map(|p| p.at.te.norm()).fold(0.0, f64::max);
    let mut assigned: Vec<Option<(usize, usize)>> = vec![None; items.len()];
    let runs = runs(&items, &motions, &points, marks)?;
    for (a, b) in runs.pairs {
        let targets: Vec<Vec3> = motions[a.clone()].iter().map(|&i| items[i].end_mm()).collect();
        let mut found = ends(&targets, &points[b.clone()], NEAR * size)?;
        if let (true, Some(last)) = (runs.by_statement, found.last_mut()) {
            // What follows of the statement is of its last motion, wherever it goes.
            *last = b.len().checked_sub(1);
        }
        let mut from = b.start;
        for (&i, end) in motions[a].iter().zip(found) {
            if let Some(end) = end {
                assigned[i] = Some((from, b.start + end + 1));
                from = b.start + end + 1;
            }
        }
    }
    let mut out = put_together(&items, &assigned, &points);
    let mut last = None;
    for &i in &motions {
        let motion = items[i].motion();
        let goes = assigned[i].is_some() || motion.is_some_and(|m| !stays(m, last));
        last = motion.and_then(|m| m.points.last().copied());
        if !goes {
            continue;
        }
        let there = assigned[i].map(|(_, to)| points[to - 1].at.te);
        out.at_home[1] += 1;
        if there.is_some_and(|te| (te - items[i].end_mm()).norm() <= NEAR * size) {
            out.at_home[0] += 1;
        } else if out.astray.is_none() {
            let mm = items[i].units.mm();
            let (here, there) = (items[i].end_mm() / mm, there.map(|te| te / mm));
            out.astray = Some(Astray { origin: items[i].record.origin.clone(), here, there });
        }
    }
    Ok(out)
}

/// How many times as large as the program's path that of the file is.
pub fn times_as_large(program: &[Record], file: &[Record]) -> f64 {
    let size =
        |records: &[Record]| positions(records).iter().map(|p| p.at.te.norm()).fold(0.0, f64::max);
    size(file) / size(program)
}

/// A position of the file, in millimetres.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Point {
    pub(crate) at: Position,
    with_axis: bool,
    /// Is it the last of its record?
    pub(crate) last: bool,
    isn: u32,
    line: u32,
}

fn positions(file: &[Record]) -> Vec<Point> {
    let mut units = Units::default();
    let mut last: Option<Position> = None;
    let mut out = Vec::new();
    for record in file {
        match &record.kind {
            Kind::Units(u) => units = *u,
            Kind::Motion(m) => {
                let mm = units.mm();
                let all = flatten::positions(m, last, ARC_CHORDS / mm);
                let n = all.len();
                out.extend(all.iter().enumerate().map(|(i, p)| Point {
                    at: Position { te: p.te * mm, ta: p.ta },
                    with_axis: m.with_axis,
                    last: i + 1 == n,
                    isn: record.origin.isn,
                    line: record.origin.line,
                }));
                last = all.last().copied().or(last);
            }
            _ => {}
        }
    }
    out
}

type Run = std::ops::Range<usize>;

/// Parts of the motions and of the points that belong together.
struct Runs {
    pairs: Vec<(Run, Run)>,
    /// Are they those of one statement each?
    by_statement: bool,
}

fn runs(items: &[Item], motions: &[usize], points: &[Point], marks: Marks) -> Result<Runs, String> {
    let of_item = |i: &usize| match marks {
        Marks::Statements => items[*i].record.origin.isn,
        _ => items[*i].record.origin.line,
    };
    let of_point = |p: &Point| if marks == Marks::Statements { p.isn } else { p.line };
    if marks == Marks::None || points.iter().all(|p| of_point(p) == 0) {
        let pairs = vec![(0..motions.len(), 0..points.len())];
        return Ok(Runs { pairs, by_statement: false });
    }
    let ours = chunks(motions, of_item);
    let theirs = chunks(points, of_point);
    let keys = |runs: &[(u32, Run)]| runs.iter().map(|r| r.0).collect::<Vec<_>>();
    let pairs = common(&keys(&ours), &keys(&theirs))?;
    let pairs = pairs.into_iter().map(|(i, j)| (ours[i].1.clone(), theirs[j].1.clone())).collect();
    Ok(Runs { pairs, by_statement: true })
}

/// Stretches of equal keys.
fn chunks<T>(all: &[T], key: impl Fn(&T) -> u32) -> Vec<(u32, Run)> {
    let mut out: Vec<(u32, Run)> = Vec::new();
    for (i, x) in all.iter().enumerate() {
        let k = key(x);
        match out.last_mut() {
            Some((last, run)) if *last == k => run.end = i + 1,
            _ => out.push((k, i..i + 1)),
        }
    }
    out
}

fn put_together(items: &[Item], assigned: &[Option<(usize, usize)>], points: &[Point]) -> Matched {
    let mut out = Matched::default();
    let mut used = 0;
    let mut last = None;
    // Behind the motion that came last, in the file or not: what the machine does before the next moves the tool too.
    let mut behind = 0;
    // The motion along surfaces that came last, and where the file has its end.
    let mut before: Option<(&Item, usize)> = None;
    for (item, place) in items.iter().zip(assigned) {
        let Some(motion) = item.motion() else {
            out.records.push(item.record.clone());
            continue;
        };
        let Some((from, to)) = *place else {
            // A motion that goes nowhere need not be in a file.
            if !stays(motion, last) {
                out.missing.push(item.record.origin.clone());
            }
            last = motion.points.last().copied();
            behind = out.records.len();
            continue;
        };
        last = motion.points.last().copied();
        let Some(back) = item.map().map_or(Some(Transform::identity()), |m| m.inverse()) else {
            out.missing.push(item.record.origin.clone());
            behind = out.records.len();
            continue;
        };
        used += to - from;
        let carry = |p: &Point| carried(p, &back, item.units, motion);
        // Where the tool comes from, in the same system: the file may have been somewhere else. What goes on along the same
        // surfaces, as between the passes of a region, is one with what came before.
        let goes_on = before.is_some_and(|(b, end)| end == from && item.goes_on(b));
        before = Some((item, to));
        if let (Some(before), false) = (from.checked_sub(1), goes_on) {
            let start = Motion {
                kind: MotionKind::From,
                points: vec![carry(&points[before])],
                ..Motion::default()
            };
            let kind = Kind::Motion(start);
            let start = Record { origin: item.record.origin.clone(), kind };
            out.records.insert(behind, start);
        }
        let moved = Motion {
            points: points[from..to].iter().map(carry).collect(),
            arc: None,
            ..motion.clone()
        };
        out.records.push(Record { origin: item.record.origin.clone(), kind: Kind::Motion(moved) });
        behind = out.records.len();
    }
    out.extra = (points.len() - used) as u64;
    out
}

/// Does the motion end where it began, without leaving?
fn stays(motion: &Motion, start: Option<Position>) -> bool {
    let far = |p: &Position| p.te.norm() + f64::MIN_POSITIVE;
    start.is_some_and(|s| motion.points.iter().all(|p| (p.te - s.te).norm() <= 1e-9 * far(&s)))
}

/// A position of the file in the system and unit of the program's motion. A file without axes means the
/// axis that the program had.
fn carried(p: &Point, back: &Transform, units: Units, motion: &Motion) -> Position {
    let te = back.point(p.at.te / units.mm());
    let own = motion.points.last().map_or_else(Vec3::z, |q| q.ta);
    let ta = if p.with_axis { back.vector(p.at.ta).try_normalize(0.0).unwrap_or(own) } else { own };
    Position { te, ta }
}

#[cfg(test)]
mod tests;
