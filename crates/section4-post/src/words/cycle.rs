//! CYCLE: reading its forms.

use aptc_cldata::{Arg, Units};
use aptc_diagnostics::{Code, codes};
use smol_str::SmolStr;

use super::fedrat::unit;
use crate::args::Statement;
use crate::drill::{DrillCycle, Heights};
use crate::post::{Post, trimmed};
use crate::state::{FeedUnit, Feedrate};
use crate::words::refuse;

/// Kinds of CYCLE that drill, with the name under which machine files have them.
const KINDS: &[(&str, &str)] = &[
    ("BORE", "BORE"),
    ("BORE7", "BORE7"),
    ("BORE8", "BORE8"),
    ("BORE9", "BORE9"),
    ("BRKCHP", "BRKCHP"),
    ("CSINK", "CSINK"),
    ("CBORE", "FACE"),
    ("DEEP", "DEEP"),
    ("DEEP2", "DEEP"),
    ("DRILL", "DRILL"),
    ("FACE", "FACE"),
    ("MILL", "MILL"),
    ("REAM", "REAM"),
    ("REVERS", "REVERS"),
    ("RIGID", "TAP"),
    ("SHIFT", "SHIFT"),
    ("SPOT", "DRILL"),
    ("TAP", "TAP"),
    ("THREAD", "THREAD"),
    ("THRU", "THRU"),
    ("CIRCUL", "CIRCUL"),
];

/// `CYCLE/kind,..`, `CYCLE/ON`, `CYCLE/OFF|NOMORE`, `CYCLE/INIT`.
///
/// Values come in couplets (`DEPTH,d` `FEDTO,d` `CLEAR,c` `RAPTO,c` `STEP,s` ..) or in the order depth, feed,
/// clearance (depth, step, clearance for DEEP), where a unit word before or after a number marks it as the
/// feed. A depth counts from the programmed point downwards, whatever its sign: both signs are in use.
pub(super) fn cycle(post: &mut Post, s: &Statement<'_>) {
    match s.word(0) {
        Some("OFF" | "NOMORE") => {
            post.leave_cycle();
            post.st.cycle = None;
            return;
        }
        Some("ON") => {
            if post.st.last_cycle.is_none() {
                let message = "CYCLE/ON has no earlier cycle to bring back".to_string();
                let help = "write the cycle with its values, CYCLE/DRILL,DEPTH,d,CLEAR,c";
                post.warn(codes::CYCLE_INCOMPLETE, s.origin, message, help);
            }
            let cycle = again(post.st.last_cycle.as_ref(), s);
            match cycle.and_then(|cycle| post.pitched(s, cycle)) {
                Ok(cycle) => {
                    post.st.last_cycle.clone_from(&cycle);
                    post.st.cycle = cycle;
                }
                Err(refusal) => post.refuse_cycle(s, refusal),
            }
            return;
        }
        // CAMWorks announces a cycle before it gives it.
        Some("INIT" | "CLEAR") => return,
        Some("AUTO" | "AVOID") => {
            refuse(post, s, "cycles are not made by themselves here");
            return;
        }
        _ => {}
    }
    match parse(s).and_then(|cycle| post.pitched(s, Some(cycle))) {
        Ok(cycle) => {
            post.doubt_pitch(s, cycle.as_ref());
            post.st.last_cycle.clone_from(&cycle);
            post.st.cycle = cycle;
        }
        Err(refusal) => post.refuse_cycle(s, refusal),
    }
}

impl Post {
    /// Holes under a cycle that is not understood are not drilled as the one before.
    fn refuse_cycle(&mut self, s: &Statement<'_>, refusal: Refusal) {
        let Refusal { code, message, help } = refusal;
        self.error(code, s.origin, message, &help);
        self.leave_cycle();
        (self.st.cycle, self.st.last_cycle) = (None, None);
        // Its feed is missing too, which is no mistake of its own.
        self.st.refused_words.insert("FEDRAT".into());
    }

    /// Tells of a tap whose feed a minute gives a pitch that no thread has: it is a feed a turn, most likely.
    fn doubt_pitch(&mut self, s: &Statement<'_>, cycle: Option<&DrillCycle>) {
        /// Millimetres; the finest threads have .08.
        const LEAST: f64 = 0.05;
        let Some(DrillCycle { kind, feed: Some(feed), pitch: None, .. }) = cycle else { return };
        let mm = match feed.unit {
            FeedUnit::PerMinute => self.st.units.mm(),
            FeedUnit::MmPerMinute => 1.0,
            FeedUnit::InchPerMinute => 25.4,
            _ => return,
        };
        let turns = self.revolutions_here().filter(|n| *n > 0.0);
        let Some(pitch) = turns.map(|n| feed.value * mm / n).filter(|p| *p < LEAST) else { return };
        if kind != "TAP" {
            return;
        }
        let message = format!("{}: a pitch of {pitch:.4} mm comes of this feed", s.written());
        let unit = if self.st.units == Units::Inches { "IPR" } else { "MMPR" };
        let help = format!("write {unit},{} where a feed a turn is meant", trimmed(feed.value, 6));
        self.warn(codes::DOUBTFUL_FEED, s.origin, message, &help);
    }

    /// The cycle, when its pitch can be one and no other feed contradicts it.
    fn pitched(
        &self,
        s: &Statement<'_>,
        cycle: Option<DrillCycle>,
    ) -> Result<Option<DrillCycle>, Refusal> {
        let Some((pitch, other)) =
            cycle.as_ref().and_then(|c| c.pitch.map(|p| (p, c.beside_pitch)))
        else {
            return Ok(cycle);
        };
        // No tap goes an inch in a turn, but threads are named by how many an inch has.
        if self.st.units == Units::Inches && pitch >= 1.0 {
            let n = trimmed(pitch, 6);
            let message = format!("{}: a pitch of {n} inches is none of a tap", s.written());
            let help = format!("write PITCH,1/{n} where {n} threads an inch are meant");
            return Err(Refusal::new(codes::POST_ARGUMENTS, message, &help));
        }
        let Some(other) = other else { return Ok(cycle) };
        let cl = self.st.units.mm();
        let per_minute = || self.revolutions_here().filter(|n| *n > 0.0);
        let (mm, turns) = match other.unit {
            FeedUnit::PerRevolution => (cl, Some(1.0)),
            FeedUnit::InchPerRevolution => (25.4, Some(1.0)),
            FeedUnit::MmPerRevolution => (1.0, Some(1.0)),
            FeedUnit::PerMinute => (cl, per_minute()),
            FeedUnit::InchPerMinute => (25.4, per_minute()),
            FeedUnit::MmPerMinute => (1.0, per_minute()),
        };
        // Feeds are rounded to a few digits: within a thousandth they are the same.
        let same = |a: f64| (a - pitch * cl).abs() <= 1e-3 * pitch * cl;
        if turns.is_some_and(|turns| same(other.value * mm / turns)) {
            return Ok(cycle);
        }
        let message = format!("{}: the feed is not that of the pitch", s.written());
        let help = "leave the feed out: the pitch is the feed of each turn";
        Err(Refusal::new(codes::POST_ARGUMENTS, message, help))
    }
}

/// The cycle that `CYCLE/ON` brings back, with the values that stand behind ON (NX gives a new depth so).
pub(crate) fn again(
    last: Option<&DrillCycle>,
    s: &Statement<'_>,
) -> Result<Option<DrillCycle>, Refusal> {
    let Some(last) = last else { return Ok(None) };
    let v = gather(s, &last.kind, 1)?;
    if !v.plain.is_empty() {
        return Err(Refusal::arguments(s, "CYCLE/ON with a word before each value"));
    }
    let mut said = v.said.or(last.said);
    said.retract = said.retract.filter(|_| !v.auto);
    let (feed, beside_pitch) = v.feeds();
    let cycle = DrillCycle {
        kind: last.kind.clone(),
        depth: v.depth.map_or(last.depth, f64::abs),
        said,
        clear: said.clearance(),
        retract: said.end(),
        retract_auto: v.auto || last.retract_auto && v.said.retract.is_none(),
        feed: feed.or(last.feed),
        beside_pitch,
        pitch: v.pitch,
        first_step: v.first_step.or(v.step).or(last.first_step),
        step: v.step.or(v.first_step).or(last.step),
        dwell: v.dwell.or(last.dwell),
        dwell_rev: v.dwell_rev.or(last.dwell_rev),
        told: false,
    };
    checked(s, cycle).map(Some)
}

/// Why a cycle cannot be understood.
pub(crate) struct Refusal {
    code: Code,
    message: String,
    help: String,
}

impl Refusal {
    fn new(code: Code, message: String, help: &str) -> Self {
        Self { code, message, help: help.to_string() }
    }

    fn arguments(s: &Statement<'_>, forms: &str) -> Self {
        let message = format!("{} has no meaning", s.written());
        Self::new(codes::POST_ARGUMENTS, message, &format!("write {forms}"))
    }
}

/// The cycle that a statement with its kind and values means.
pub(crate) fn parse(s: &Statement<'_>) -> Result<DrillCycle, Refusal> {
    let kind = s.word(0).and_then(|w| KINDS.iter().find(|(k, _)| *k == w));
    let Some(&(_, kind)) = kind else {
        let forms = "CYCLE/DRILL,DEPTH,d,CLEAR,c or another kind, or CYCLE/OFF";
        return Err(Refusal::arguments(s, forms));
    };
    match (kind, s.word(1)) {
        // NX and ISO 4343 say how a hole is drilled behind DRILL.
        ("DRILL", Some(sub @ ("DEEP" | "BRKCHP" | "FACE"))) => values(s, sub, 2),
        ("DRILL", Some("CSINK")) => {
            // The diameter of the sink: its depth is said as well.
            values(s, "CSINK", if s.number(2).is_some() { 3 } else { 2 })
        }
        _ => values(s, kind, 1),
    }
}

#[derive(Default)]
struct Values {
    depth: Option<f64>,
    feed: Option<Feedrate>,
    pitch: Option<f64>,
    said: Heights,
    auto: bool,
    first_step: Option<f64>,
    step: Option<f64>,
    dwell: Option<f64>,
    dwell_rev: Option<f64>,
    plain: Vec<f64>,
}

impl Values {
    /// The feed, and what stands beside it: the pitch of a tap is its feed per revolution.
    fn feeds(&self) -> (Option<Feedrate>, Option<Feedrate>) {
        match self.pitch {
            Some(value) => (Some(Feedrate { value, unit: FeedUnit::PerRevolution }), self.feed),
            None => (self.feed, None),
        }
    }
}

/// The values from the argument `from` on.
fn values(s: &Statement<'_>, kind: &str, from: usize) -> Result<DrillCycle, Refusal> {
    let mut v = gather(s, kind, from)?;
    let list = std::mem::take(&mut v.plain);
    let mut plain = list.into_iter();
    let depth = v.depth.or_else(|| plain.next());
    let mut step = v.step;
    let pecks = matches!(kind, "DEEP" | "BRKCHP");
    if pecks && step.is_none() && v.first_step.is_none() && plain.len() >= 2 {
        step = plain.next();
    }
    let high = v.said.clearance().is_some();
    if !pecks && v.feed.is_none() && plain.len() >= 1 && (plain.len() >= 2 || high) {
        v.feed = plain.next().map(|value| Feedrate { value, unit: FeedUnit::PerMinute });
    }
    if !high {
        v.said.clear = plain.next();
    }
    if v.feed.is_none() && pecks {
        v.feed = plain.next().map(|value| Feedrate { value, unit: FeedUnit::PerMinute });
    }
    let Some(depth) = depth else {
        let message = format!("{} has no depth", s.written());
        let help = format!("write CYCLE/{kind},DEPTH,d,CLEAR,c: d from the point down, c above it");
        return Err(Refusal::new(codes::CYCLE_INCOMPLETE, message, &help));
    };
    v.said.retract = v.said.retract.filter(|_| !v.auto);
    let (feed, beside_pitch) = v.feeds();
    let cycle = DrillCycle {
        kind: SmolStr::new(kind),
        depth: depth.abs(),
        said: v.said,
        clear: v.said.clearance(),
        retract: v.said.end(),
        retract_auto: v.auto,
        feed,
        beside_pitch,
        pitch: v.pitch,
        first_step: v.first_step.or(step),
        step: step.or(v.first_step),
        dwell: v.dwell,
        dwell_rev: v.dwell_rev,
        told: false,
    };
    checked(s, cycle)
}

fn checked(s: &Statement<'_>, cycle: DrillCycle) -> Result<DrillCycle, Refusal> {
    let values = [Some(cycle.depth), cycle.clear, cycle.retract, cycle.step, cycle.first_step];
    let bad = values.into_iter().flatten().any(|n| !n.is_finite() || n.abs() > 1e9);
    if bad || cycle.clear.is_some_and(|c| c < 0.0) {
        let message = format!("{}: the clearance must not lie below the point", s.written());
        let help = "give CLEAR,c upwards from the point";
        return Err(Refusal::new(codes::CYCLE_INCOMPLETE, message, help));
    }
    // Heights of six decimals may be differences of others: what is within them is the same height.
    let low = |(c, r): (f64, f64)| (r < c - 1e-6).then_some((c, r));
    if let Some((c, r)) = cycle.clear.zip(cycle.retract).and_then(low) {
        let (c, r) = (trimmed(c, 6), trimmed(r, 6));
        let message = format!("{}: it ends at {r}, below its clearance of {c}", s.written());
        let help = "give RTRCTO,r at the height of CLEAR,c or above it";
        return Err(Refusal::new(codes::CYCLE_INCOMPLETE, message, help));
    }
    Ok(cycle)
}

fn gather(s: &Statement<'_>, kind: &str, from: usize) -> Result<Values, Refusal> {
    let mut v = Values::default();
    let args = s.args.get(from..).unwrap_or_default();
    let mut i = 0;
    while i < args.len() {
        let number = match args.get(i + 1) {
            Some(Arg::Number(n)) => Some(*n),
            _ => None,
        };
        match &args[i] {
            Arg::Number(n) => {
                // A unit after the second or a later number marks it as the feed; the unit after the first
                // belongs to the next number, for the first is the depth.
                let marked = match args.get(i + 1) {
                    Some(Arg::Word(w)) => unit(w).filter(|_| number_follows(args, i)),
                    _ => None,
                };
                match marked {
                    Some(unit)
                        if !(v.plain.is_empty() && v.depth.is_none()) && v.feed.is_none() =>
                    {
                        v.feed = Some(Feedrate { value: *n, unit });
                        i += 1;
                    }
                    _ => v.plain.push(*n),
                }
                i += 1;
                continue;
            }
            Arg::Word(w) => {
                let w = w.as_str();
                if let Some(unit) = unit(w) {
                    if let Some(value) = number {
                        v.feed = Some(Feedrate { value, unit });
                        i += 1;
                    }
                    i += 1;
                    continue;
                }
                if w == kind || w == s.word(0).unwrap_or_default() {
                    // The kind said twice.
                    i += 1;
                    continue;
                }
                let slot = match w {
                    "DEPTH" | "FEDTO" => &mut v.depth,
                    "PITCH" if kind == "TAP" => &mut v.pitch,
                    "CLEAR" => &mut v.said.clear,
                    "RAPTO" => &mut v.said.rapto,
                    "RTRCTO" | "RETURN" => {
                        if matches!(args.get(i + 1), Some(Arg::Word(a)) if a == "AUTO") {
                            v.auto = true;
                            i += 2;
                            continue;
                        }
                        &mut v.said.retract
                    }
                    "STEP" | "INCR" | "SUBPECK" | "PECK" => &mut v.step,
                    "1STPECK" => &mut v.first_step,
                    "DWELL" => {
                        if matches!(args.get(i + 1), Some(Arg::Word(a)) if a == "REV") {
                            i += 1;
                            match args.get(i + 1) {
                                Some(Arg::Number(n)) => v.dwell_rev = Some(*n),
                                _ => i -= 1,
                            }
                            i += 2;
                            continue;
                        }
                        if matches!(args.get(i + 2), Some(Arg::Word(a)) if a == "REV") {
                            v.dwell_rev = number;
                            i += 3;
                            continue;
                        }
                        &mut v.dwell
                    }
                    _ => {
                        let message = format!("{}: CYCLE has nothing for {w} here", s.written());
                        let help = "remove it, or write the motions of the hole";
                        return Err(Refusal::new(codes::WORD_LACKING, message, help));
                    }
                };
                let Some(n) = number else {
                    return Err(Refusal::arguments(s, &format!("a number after {w}")));
                };
                *slot = Some(n);
                i += 2;
                if w == "STEP" {
                    i += further_steps(s, &mut v, &args[i..])?;
                }
            }
            _ => {
                return Err(Refusal::arguments(s, "CYCLE with numbers and words"));
            }
        }
    }
    Ok(v)
}

/// Further numbers behind STEP, a list of steps as NX gives it: the first peck, and the one of all others; zeros
/// fill the list up. How many arguments they take.
fn further_steps(s: &Statement<'_>, v: &mut Values, rest: &[Arg]) -> Result<usize, Refusal> {
    let number = |a: &Arg| if let Arg::Number(n) = a { Some(*n) } else { None };
    let list: Vec<f64> = rest.iter().map_while(number).collect();
    let after = rest.get(list.len()..).unwrap_or_default();
    // A list ends with a word of its own; else the numbers are those of other places, with or without a unit.
    let ends = match after {
        [Arg::Word(w), Arg::Number(_), ..] => unit(w).is_none() || v.feed.is_none(),
        [Arg::Word(w), ..] => unit(w).is_none(),
        _ => false,
    };
    if !ends || list.is_empty() {
        return Ok(0);
    }
    let first = v.step;
    let others: Vec<f64> = list.iter().copied().filter(|n| *n > 0.0).collect();
    if let Some(other) = others.first() {
        if others.iter().any(|n| (n - other).abs() > 1e-9) {
            let message = format!("{}: more than two lengths of pecks", s.written());
            let help =
                "give the first peck and that of all others, or write the motions of the hole";
            return Err(Refusal::new(codes::WORD_LACKING, message, help));
        }
        (v.first_step, v.step) = (v.first_step.or(first), Some(*other));
    }
    Ok(list.len())
}

/// Is the unit after this number its own? It is when it ends the list or another number with a place of its
/// own follows: `20,IPM,.1` but not `2,IPM,23,.05`, where the list would lack its clearance.
fn number_follows(args: &[Arg], at: usize) -> bool {
    let rest = &args[at + 2..];
    let plain = rest.iter().take_while(|a| matches!(a, Arg::Number(_))).count();
    plain <= 1
}
