//! A statement that moved the tool along surfaces, judged in parts.

use std::sync::{Arc, OnceLock};

use aptc_cldata::milling::Milling;
use aptc_cldata::{Control, Position};
use aptc_diagnostics::Origin;
use aptc_geometry::{Profile, Vec3};

use crate::certificate::{Fault, StatementProof, SurfaceBound};
use crate::coming::Coming;
use crate::curved::Warm;
use crate::judged::Judged;
use crate::limited::Last;
use crate::milled::Region;
use crate::over::goes_over;
use crate::past::{Passed, goes_past};
use crate::scallop::Left;
use crate::sheets::Sheets;
use crate::verifier::Effort;

/// Vectors of a part: few enough that several threads have work in a short statement of slow ones, and so many that what each part
/// begins with is little beside the rest.
const VECTORS: [usize; 2] = [32, 128];
/// Parts of a statement that is not so short.
const PARTS: usize = 4;
/// Parts in which it is looked what is left between the passes of a region.
pub(crate) const PLACES: usize = 32;

/// Why a line limited by REGION can be deep in a surface.
const OVER: &str = "it is the straight way from one stretch of the line to the next, over what REGION leaves out: GCLEAR/AWAY and GCLEAR/BACK lead the tool round";

/// Why a vector that a disk keeps to is refuted.
const OTHER: &str = "the cutter goes over to the other side of the surface there: its disk, CUTTER/OPTION, touches from both";

/// A motion along surfaces with all that its judgement hangs on.
#[derive(Debug)]
pub(crate) struct Statement {
    pub(crate) control: Arc<Control>,
    pub(crate) startup: bool,
    /// Is it a start-up at rapid?
    pub(crate) rapid: bool,
    pub(crate) origin: Origin,
    /// Where the tool was before; `None` where how it came is not judged.
    pub(crate) start: Option<Position>,
    /// Where it was before in any case: from there it comes to surfaces that it keeps to a side of.
    pub(crate) before: Option<Position>,
    /// The way at feed to a statement of regional milling that does not begin there, but for its last place: from where it comes, and
    /// what GCLEAR puts before a line.
    pub(crate) way: Vec<Position>,
    /// Does that begin where a line of the same statement ends?
    pub(crate) again: bool,
    /// What the motion that ended where this one begins was held to.
    pub(crate) earlier: Option<Arc<Control>>,
    pub(crate) points: Vec<Position>,
    /// The vectors that lead over what REGION leaves out, counted from 1.
    pub(crate) over: Vec<u64>,
    pub(crate) profile: Profile,
    /// Allowance for rounding.
    pub(crate) pad: f64,
    pub(crate) effort: Effort,
    pub(crate) sheets: Sheets,
    pub(crate) ready: OnceLock<Ready>,
}

/// A part of the judgement.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Share {
    /// Vectors from this one on, counted from 0, up to the other.
    Vectors(usize, usize),
    /// What is left between the passes, at the places with this number.
    Between(usize),
}

/// What came of a part.
#[derive(Debug, Default)]
pub(crate) struct Answer {
    /// One a vector of the part.
    vectors: Vec<Outcome>,
    /// The worst fault, and that of the cutter behind its disk.
    fault: Option<Fault>,
    real: Option<Fault>,
    /// What a start-up goes through on its way.
    through: Option<Fault>,
    /// What was seen of each surface.
    seen: Vec<Seen>,
    /// The same of the check surfaces before the end.
    never: Vec<Seen>,
    left: Option<Left>,
    /// What the last vector mills of a part surface of which not all is to be milled.
    milled: Option<Last>,
}

/// Of which surfaces all vectors of a part are proved at once.
#[derive(Clone, Debug, Default)]
struct Rows {
    along: [bool; 2],
    never: Vec<bool>,
}

/// What came of a vector.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Outcome {
    Proved,
    Refuted,
    Undecided,
    LeftOut,
}

/// Bounds of the gap to a surface along several vectors.
#[derive(Clone, Debug)]
pub(crate) struct Seen {
    pub(crate) low: f64,
    pub(crate) high: f64,
    /// The tool end where the least was met.
    pub(crate) at: Option<Vec3>,
    /// Where the next vector is best begun.
    pub(crate) warm: Warm,
}

/// What was proved of a statement.
#[derive(Debug)]
pub(crate) struct Judgement {
    pub(crate) proof: StatementProof,
    /// What came of each vector.
    pub(crate) vectors: Vec<Outcome>,
    pub(crate) real: Option<Fault>,
    pub(crate) through: Option<Fault>,
}

/// The surfaces of a statement, prepared.
#[derive(Debug)]
pub(crate) enum Ready {
    Guided(Box<Guided>),
    /// `None` when one of them has no charts. Beside them what the way to the first position is held against.
    Milled(Option<Box<Region>>, Option<Box<Region>>),
}

/// Drive, part and check surface.
#[derive(Debug)]
pub(crate) struct Guided {
    along: Vec<Judged>,
    /// The same for the vector that brings the tool from the wider band of the motion before into that of this one.
    eased: Vec<Option<Judged>>,
    /// Where the cutter goes over to the other side of them, their disks keeping to one.
    over: Vec<Option<(usize, Position)>>,
    check: Option<Judged>,
    /// Where the motion went past the place at which that is tangent.
    past: Option<Passed>,
    /// The check surfaces that are not to be passed.
    never: Vec<Judged>,
    /// What a start-up is not to go through.
    coming: Option<Coming>,
}

impl Answer {
    /// Of a part along so many surfaces, of which so many others are not to be passed, before it is judged.
    fn of(n_surfaces: usize, n_never: usize) -> Self {
        let seen = |n| vec![Seen::default(); n];
        Self { seen: seen(n_surfaces), never: seen(n_never), ..Self::default() }
    }
}

impl Statement {
    /// The parts, in the order in which they are best begun.
    pub(crate) fn shares(&self) -> Vec<Share> {
        let n = self.points.len();
        let size = (n / PARTS).clamp(VECTORS[0], VECTORS[1]);
        let part = |from| Share::Vectors(from, (from + size).min(n));
        let vectors = (0..n).step_by(size).map(part);
        let asked = self.control.milling.as_ref().is_some_and(|m| m.scallop.is_some());
        let n = if asked && self.effort == Effort::Full { PLACES } else { 0 };
        // The first of them prepares what all need; the vectors can be judged meanwhile.
        let first = (n > 0).then_some(Share::Between(0));
        first.into_iter().chain(vectors).chain((1..n).map(Share::Between)).collect()
    }

    pub(crate) fn judge(&self, share: &Share) -> Answer {
        match (self.ready(), share) {
            (Ready::Milled(Some(region), _), Share::Between(i)) => {
                Answer { left: region.between(self, *i), ..Answer::default() }
            }
            (_, Share::Between(_)) => Answer::default(),
            (Ready::Guided(guided), Share::Vectors(from, to)) => {
                let mut answer = Answer::of(guided.surfaces().count(), guided.never.len());
                let rows = guided.rows(self, [*from, *to], &mut answer);
                let judge =
                    |i, a: &_, b: &_, answer: &mut _| guided.vector(self, i, [a, b], &rows, answer);
                self.vectors([*from, *to], answer, judge)
            }
            (Ready::Milled(region, arrival), Share::Vectors(from, to)) => {
                let surfaces = region.as_ref().map_or(&[][..], |r| r.surfaces());
                let judge = |i: usize, a: &_, b: &_, answer: &mut Answer| {
                    if surfaces.is_empty() {
                        return Some(self.unknown());
                    }
                    let mut fault = None;
                    for (s, seen) in surfaces.iter().zip(&mut answer.seen) {
                        keep(
                            &mut fault,
                            s.vector(&self.profile, a, b, self.pad, i as u64 + 1, seen),
                        );
                    }
                    if i == 0 {
                        let at = self.way.last().unwrap_or(a);
                        let held = surfaces.iter().filter_map(|s| s.holds(&self.profile, at));
                        held.for_each(|f| keep(&mut fault, Some(f)));
                    }
                    if let Some(region) = region {
                        let number = i as u64 + 1;
                        let over = (self.over.contains(&number), self.pad);
                        let last = &mut answer.milled;
                        let found = region.outside(&self.profile, [a, b], over, number, last);
                        keep(&mut fault, found);
                    }
                    // What is wrong where it arrives is told alone.
                    let arrives = i == 0 && fault.as_ref().is_none_or(|f| !f.refuted);
                    if let (true, Some(arrival), Some(way)) = (arrives, arrival, self.way.last()) {
                        keep(&mut fault, arrival.arrives(&self.profile, way, b, self.pad));
                    }
                    fault
                };
                self.vectors([*from, *to], Answer::of(surfaces.len(), 0), judge)
            }
        }
    }

    /// Judges the vectors of a part, each from its start to its end.
    fn vectors(
        &self,
        [from, to]: [usize; 2],
        mut answer: Answer,
        judge: impl Fn(usize, &Position, &Position, &mut Answer) -> Option<Fault>,
    ) -> Answer {
        let n = self.points.len();
        answer.vectors.reserve_exact(to - from);
        for i in from..to {
            if !self.effort.takes(i, n) {
                answer.vectors.push(Outcome::LeftOut);
                continue;
            }
            let fault = judge(i, self.start_of(i), &self.points[i], &mut answer);
            answer.vectors.push(match &fault {
                None => Outcome::Proved,
                Some(f) if f.refuted => Outcome::Refuted,
                Some(_) => Outcome::Undecided,
            });
            keep(&mut answer.fault, fault);
        }
        answer
    }

    /// Where the vector begins that ends at the point `i`.
    fn start_of(&self, i: usize) -> &Position {
        match i.checked_sub(1) {
            Some(before) => &self.points[before],
            None => self.start.as_ref().unwrap_or(&self.points[i]),
        }
    }

    /// Puts the answers of all parts together, in their order.
    pub(crate) fn judgement<'a>(
        &self,
        answers: impl Iterator<Item = (&'a Share, &'a Answer)>,
    ) -> Judgement {
        let mut vectors = Vec::with_capacity(self.points.len());
        let (mut fault, mut real, mut through): (Option<Fault>, _, _) = (None, None, None);
        let mut seen: Vec<Seen> = Vec::new();
        let mut left: Option<Left> = None;
        let mut open = false;
        for (share, answer) in answers {
            vectors.extend_from_slice(&answer.vectors);
            keep(&mut fault, answer.fault.clone());
            keep(&mut real, answer.real.clone());
            keep(&mut through, answer.through.clone());
            seen.resize(seen.len().max(answer.seen.len()), Seen::default());
            seen.iter_mut().zip(&answer.seen).for_each(|(s, a)| s.take(a.low, a.high, a.at));
            if let (Share::Between(_), Some(more), false) = (share, answer.left, open) {
                left = Some(left.map_or(more, |left| left.then(more)));
                open = matches!(more, Left::Open(..));
            }
        }
        if let Some(f) = fault.as_mut().filter(|f| f.gouge && self.over.contains(&f.vector)) {
            f.why = Some(OVER.into());
        }
        let mut proof = StatementProof {
            origin: self.origin.clone(),
            vectors: 0,
            proved: 0,
            method: "none",
            surfaces: Vec::new(),
            fault,
        };
        match self.ready() {
            Ready::Guided(guided) => {
                proof.method = guided.surfaces().map(Judged::method).min().unwrap_or("none");
                let bounds = guided.surfaces().zip(&seen).filter_map(|(s, seen)| s.bound(seen));
                proof.surfaces = bounds.collect();
            }
            Ready::Milled(None, _) => {}
            Ready::Milled(Some(region), _) => {
                proof.method = "branch and bound";
                proof.surfaces = region.bounds(&seen);
                if let Some(left) = left {
                    self.between(region, left, &mut proof, &mut vectors);
                }
            }
        }
        let count =
            |wanted: &dyn Fn(&Outcome) -> bool| vectors.iter().filter(|o| wanted(o)).count();
        proof.vectors = count(&|o| *o != Outcome::LeftOut) as u64;
        proof.proved = count(&|o| *o == Outcome::Proved) as u64;
        Judgement { proof, vectors, real, through }
    }

    /// What is left between the passes; the nearest vector answers for it.
    fn between(
        &self,
        region: &Region,
        left: Left,
        proof: &mut StatementProof,
        vectors: &mut [Outcome],
    ) {
        let (name, height) = region.allowed();
        let ends = matches!(left, Left::Ends(..));
        let (way, depth, refuted, why) = match left {
            Left::Proved => {
                let (least, band) = (0.0, [0.0, height]);
                let (role, most) = ("scallop", height);
                proof.surfaces.push(SurfaceBound { name, role, least, most, band, at: None });
                return;
            }
            Left::Ends(stands, way) => (way, stands - height, false, None),
            // Where the tool got out of the way, or does not fit, what it left was not to be cut.
            Left::Higher(stands, way) => {
                let why = region.excused();
                (way, stands - height, why.is_none(), why)
            }
            Left::Open(way, why) => (way, f64::INFINITY, false, why),
        };
        let Some(at) = self.points.get(way) else { return };
        if let Some(outcome @ Outcome::Proved) = vectors.get_mut(way) {
            *outcome = if refuted { Outcome::Refuted } else { Outcome::Undecided };
        }
        let vector = way as u64 + 1;
        let surface = format!("the part surface {name} between the passes");
        let te = at.te.into();
        keep(
            &mut proof.fault,
            Some(Fault {
                refuted,
                surface,
                vector,
                te,
                depth,
                gouge: false,
                breach: None,
                ends,
                why: why.map(Into::into),
            }),
        );
    }

    /// A vector along surfaces without charts.
    fn unknown(&self) -> Fault {
        Fault {
            refuted: false,
            surface: "the surfaces of regional milling".to_owned(),
            vector: 1,
            te: self.points.first().map_or(Vec3::zeros(), |p| p.te).into(),
            depth: f64::INFINITY,
            gouge: false,
            breach: None,
            ends: false,
            why: None,
        }
    }

    fn ready(&self) -> &Ready {
        self.ready.get_or_init(|| match &self.control.milling {
            Some(milling) => {
                let from = self.before.as_ref().or(self.way.last()).or(self.points.first());
                let region = |milling: &Milling| {
                    Region::new(milling, &self.sheets, &self.profile, from?).map(Box::new)
                };
                let arrival = Some(milling.arrival()).filter(|m| !self.way.is_empty() && m.asks());
                Ready::Milled(region(milling), arrival.as_ref().and_then(region))
            }
            None => Ready::Guided(Box::new(Guided::new(self))),
        })
    }
}

impl Guided {
    fn new(s: &Statement) -> Self {
        let control = &s.control;
        let held = || {
            let all = [("drive", &control.drive), ("part", &control.part)].into_iter();
            all.filter_map(|(role, c)| Some((role, c.as_ref()?)))
        };
        let along = held().map(|(role, c)| Judged::new(c, role, &s.sheets)).collect();
        let earlier = s.earlier.as_ref().filter(|_| !s.startup);
        let eased = |(role, c)| Judged::eased(c, role, &s.sheets, earlier?);
        let eased = held().map(eased).collect();
        let goes_over = |c| {
            let (way, ended) = ((s.start.as_ref()?, &s.points[..]), s.earlier.as_deref());
            goes_over(c, way, s.startup, ended, &s.profile, &s.sheets)
        };
        let over = held().map(|(_, c)| goes_over(c)).collect();
        let check = control.checks.first().map(|c| Judged::new(c, "check", &s.sheets));
        let start = s.start.as_ref().filter(|_| !s.startup);
        // It stops at the first; the others it may have been on the other side of when it began.
        let never = |(i, c)| Judged::never_past(c, &s.profile, start?, s.pad, &s.sheets, i > 0);
        let came = s.start.as_ref().filter(|_| s.startup);
        let coming = came.map(|from| Coming::new(control, &s.sheets, &s.profile, from, s.rapid));
        let never = control.checks.iter().enumerate().filter_map(never).collect();
        let past = start.filter(|_| s.effort == Effort::Full);
        let past = past.and_then(|from| goes_past(control, from, &s.points, &s.profile, &s.sheets));
        Self { along, eased, over, check, past, never, coming }
    }

    /// Those of which bounds are told, drive first.
    fn surfaces(&self) -> impl Iterator<Item = &Judged> {
        self.along.iter().chain(&self.check)
    }

    /// What is proved of a part at once; it goes into the answer.
    fn rows(&self, s: &Statement, [from, to]: [usize; 2], answer: &mut Answer) -> Rows {
        let mut rows = Rows::default();
        if s.startup || s.effort != Effort::Full {
            return rows;
        }
        let points = &s.points[from..to];
        let row = |judged: &Judged, seen: &mut Seen| {
            judged.row(&s.profile, s.start_of(from), points, s.pad, seen)
        };
        for ((judged, seen), proved) in self.along.iter().zip(&mut answer.seen).zip(&mut rows.along)
        {
            *proved = row(judged, seen);
        }
        let never = self.never.iter().zip(&mut answer.never);
        rows.never = never.map(|(judged, seen)| row(judged, seen)).collect();
        rows
    }

    fn vector(
        &self,
        s: &Statement,
        i: usize,
        [start, to]: [&Position; 2],
        rows: &Rows,
        answer: &mut Answer,
    ) -> Option<Fault> {
        let Statement { profile, pad, .. } = s;
        let number = i as u64 + 1;
        // A start-up comes through the air: what it promises is where it ends.
        let came = start;
        let start = if s.startup { to } else { start };
        let mut fault: Option<Fault> = None;
        let comes = || -> f64 {
            let eased = self.along.iter().zip(&self.eased).filter(|(_, eased)| eased.is_some());
            eased.map(|(judged, _)| judged.off(profile, start, *pad)).sum()
        };
        for (k, (judged, seen)) in self.along.iter().zip(&mut answer.seen).enumerate() {
            if !rows.along[k] {
                let found = judged.vector(profile, start, to, *pad, number, seen);
                let first = i == 0 && found.is_some() && !s.startup;
                let eased = self.eased[k].as_ref().filter(|_| first);
                let way =
                    |eased| judged.come_to(eased, profile, [start, to], (comes(), *pad), seen);
                let better = eased.and_then(way).or_else(|| {
                    let (earlier, on) = (s.earlier.as_ref()?, s.points.get(1).filter(|_| first)?);
                    let (way, held) = (([start, to], on.te), (profile, *pad));
                    judged.over_ridge(found.as_ref()?, earlier, way, held, &s.sheets)
                });
                keep(&mut fault, better.unwrap_or(found));
            }
            keep(&mut answer.real, judged.real_cutter(profile, start, to, *pad, number));
            if let Some((_, at)) = self.over[k].as_ref().filter(|(vector, _)| *vector == i) {
                let real = judged.real_cutter(profile, at, at, *pad, number);
                keep(&mut fault, real.map(|f| Fault { why: Some(OTHER.into()), ..f }));
            }
        }
        for (k, (judged, seen)) in self.never.iter().zip(&mut answer.never).enumerate() {
            if !rows.never.get(k).is_some_and(|proved| *proved) {
                keep(&mut fault, judged.vector(profile, start, to, *pad, number, seen));
            }
        }
        if let (Some(judged), Some(passed)) = (&self.check, &self.past)
            && passed.vector == i
        {
            keep(&mut fault, Some(judged.past(passed)));
        }
        if i + 1 == s.points.len()
            && let (Some(judged), Some(seen)) = (&self.check, answer.seen.last_mut())
        {
            let found = judged.vector(profile, to, to, *pad, number, seen);
            // What went past the place where it is tangent is away from it for that.
            keep(&mut fault, found.filter(|f| f.gouge || self.past.is_none()));
        }
        if let Some(coming) = self.coming.as_ref().filter(|_| fault.is_none()) {
            keep(&mut answer.through, coming.fault(profile, came, to, *pad));
        }
        fault
    }
}

impl Default for Seen {
    fn default() -> Self {
        Self { low: f64::INFINITY, high: f64::NEG_INFINITY, at: None, warm: Warm::default() }
    }
}

impl Seen {
    /// Takes further bounds to these.
    pub(crate) fn take(&mut self, low: f64, high: f64, at: Option<Vec3>) {
        if low < self.low {
            (self.low, self.at) = (low, at);
        }
        self.high = self.high.max(high);
    }
}

/// Keeps the worse of two faults: a refuted one before one not decided, one of its band before what REGION leaves out, the deeper
/// before the other, the first of equal ones.
pub(crate) fn keep(worst: &mut Option<Fault>, new: Option<Fault>) {
    let Some(new) = new else { return };
    let rank = |f: &Fault| (f.refuted, f.breach.is_none(), f.depth);
    if worst.as_ref().is_none_or(|old| rank(&new) > rank(old)) {
        *worst = Some(new);
    }
}
