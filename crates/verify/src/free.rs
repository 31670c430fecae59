//! Rapid motion, which has no surface to hold to and shall cut none.

use aptc_cldata::Position;
use aptc_diagnostics::{Diagnostic, Origin, codes};
use aptc_geometry::{Plane, Profile, Vec3};

use crate::around::{Around, Wall, Which};
use crate::behind;
use crate::beyond::Beyond;
use crate::certificate::{Fault, RapidCut, at_tool_end, length};
use crate::chain::Chain;
use crate::statement::Statement;

/// A motion after RAPID, or a way at feed, with the place where it begins.
#[derive(Clone, Debug)]
pub(crate) struct Rapid {
    pub(crate) origin: Origin,
    pub(crate) points: Vec<Position>,
    pub(crate) profile: Profile,
    pub(crate) pad: f64,
    /// The clearance plane that holds.
    pub(crate) clearance: Option<Plane>,
    /// Does a cycle of the machine work where it ends?
    pub(crate) cycle: bool,
    /// Is it the way to the first place of regional milling, which that holds against what it checks?
    pub(crate) arrives: bool,
}

impl Rapid {
    /// A way at feed of regional milling.
    pub(crate) fn at_feed(
        origin: &Origin,
        points: Vec<Position>,
        profile: Profile,
        pad: f64,
    ) -> Self {
        let (origin, clearance, cycle, arrives) = (origin.clone(), None, false, true);
        Self { origin, points, profile, pad, clearance, cycle, arrives }
    }
}

/// A sideways share of a motion below this is rounding.
const SIDEWAYS: f64 = 1e-9;

/// Holds rapid motions against the surfaces of the motions before and after them, and against their
/// clearance plane.
#[derive(Debug, Default)]
pub(crate) struct Free {
    before: Option<Around>,
    beyond: Beyond,
    /// What leads to the next motion along surfaces at feed, and went through nothing before it.
    chain: Option<Box<Chain>>,
    /// Those since the last motion along surfaces.
    waiting: Vec<Waiting>,
    /// Cuts, for the certificate.
    pub(crate) cuts: Vec<RapidCut>,
    pub(crate) said: Vec<Diagnostic>,
}

/// A rapid motion of which is not known yet what comes after it.
#[derive(Debug)]
struct Waiting {
    rapid: Box<Rapid>,
    /// Where it ends below the part surface before it.
    plunge: Option<Fault>,
    /// Is a word due when nothing along surfaces follows? The motion next to it tells.
    due: Due,
}

/// Does the next motion say what a rapid motion was to do below the part surface?
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Due {
    /// It has not come.
    Open,
    /// It ends no higher: the tool works there, beside the part.
    No,
    /// It leads up again.
    Yes,
}

impl Free {
    /// A rapid motion.
    pub(crate) fn rapid(&mut self, rapid: &Rapid) {
        if let Some(end) = rapid.points.last() {
            self.next(end);
        }
        let judge = |end: End| self.before.as_ref().and_then(|b| cut(rapid, b, end, false));
        if let Some(fault) = judge(End::Excused) {
            // One mistake, one message.
            return self.told(rapid, fault);
        }
        let plunge = judge(End::Judged);
        let low = rapid.clearance.as_ref().and_then(|plane| low(rapid, plane));
        let due =
            if low.is_some() || rapid.cycle || !self.upright(rapid) { Due::No } else { Due::Open };
        self.said.extend(low);
        self.waiting.push(Waiting { rapid: Box::new(rapid.clone()), plunge, due });
    }

    /// The motion from point to point next to a rapid one, by where it ends.
    pub(crate) fn next(&mut self, end: &Position) {
        let Some(around) = &self.before else { return };
        for waiting in self.waiting.iter_mut().filter(|w| w.due == Due::Open) {
            let Some(plunge) = &waiting.plunge else { continue };
            let there = deep(&waiting.rapid, end, around);
            let works = there >= plunge.depth - waiting.rapid.pad;
            waiting.due = if works { Due::No } else { Due::Yes };
        }
    }

    /// A motion along surfaces.
    pub(crate) fn along(&mut self, statement: &Statement) {
        let Some(around) = Around::of(statement, self.before.as_ref()) else { return };
        let arrives = arrives(statement, &around);
        let chain = self.chain.take().filter(|_| arrives.is_none());
        self.said.extend(chain.and_then(|chain| chain.through(&around)));
        self.said.extend(arrives);
        self.said.extend(self.beyond.before(statement, &around));
        for Waiting { rapid, plunge, .. } in std::mem::take(&mut self.waiting) {
            // A motion that ends below the surface before and the surface after it went into the part.
            let judge = |end: End| cut(&rapid, &around, end, rapid.arrives);
            let into = plunge.filter(|_| judge(End::Judged).is_some());
            if let Some(fault) = judge(End::Excused).or(into) {
                self.told(&rapid, fault);
            }
        }
        self.before = Some(around);
    }

    /// Motion at feed from point to point.
    pub(crate) fn chain(&mut self, chain: &Chain) {
        let told = self.before.as_ref().and_then(|before| chain.leaves(before));
        let goes_on = told.is_none() && chain.leads;
        self.chain = goes_on.then(|| Box::new(chain.clone()));
        self.said.extend(told);
    }

    /// What GCLEAR puts behind a line; where it ends the tool is to be clear too.
    pub(crate) fn behind(&mut self, way: &Rapid) {
        let Some(around) = &self.before else { return };
        let fault = cut(way, around, End::Judged, true);
        self.said.extend(fault.map(|fault| behind::into(way, &fault)));
        self.said.extend(self.beyond.along(way, around));
    }

    /// No motion follows.
    pub(crate) fn finish(&mut self) {
        for Waiting { rapid, plunge, due } in std::mem::take(&mut self.waiting) {
            if let Some(fault) = plunge.filter(|_| due != Due::No) {
                self.said.push(ends_low(&rapid, &fault));
            }
        }
    }

    /// Does the tool axis stand as where the last motion along surfaces ended? With another one the work goes on at another
    /// side of the part, which its surface says nothing of.
    fn upright(&self, rapid: &Rapid) -> bool {
        let same = |at: &Position, end: &Position| (at.ta - end.ta).norm() <= SIDEWAYS;
        self.before.as_ref().zip(rapid.points.last()).is_some_and(|(b, end)| same(&b.at, end))
    }

    fn told(&mut self, rapid: &Rapid, fault: Fault) {
        self.said.push(told(rapid, &fault));
        let Fault { surface, vector, te, depth, .. } = fault;
        self.cuts.push(RapidCut {
            origin: rapid.origin.clone(),
            surface,
            point: vector,
            te,
            depth,
        });
    }
}

/// May a rapid motion end deeper than the surface?
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum End {
    Excused,
    Judged,
}

/// The deepest cut of the rapid motion into what is around it.
fn cut(rapid: &Rapid, around: &Around, end: End, arrives: bool) -> Option<Fault> {
    let which = if arrives { Which::Unchecked } else { Which::All };
    let cuts = around.walls(which).into_iter().filter_map(|wall| {
        let excused = |p: &&Position| end == End::Excused || wall.leads_the_end(rapid, p);
        let last = rapid.points.last().filter(excused);
        let ends: Vec<&Position> = rapid.points.first().into_iter().chain(last).collect();
        cut_into(rapid, wall, &ends)
    });
    cuts.reduce(|a, b| if b.depth > a.depth { b } else { a })
}

/// The deepest cut into one surface.
///
/// A tool that goes straight up leaves the way it came. Where it begins deeper than the surface, for
/// another cut reached deeper there, only what is deeper still is a cut of the rapid motion; the same where it
/// ends, unless that is judged: at the `ends` it may be so deep. A tool that a surface with ends goes through there is nowhere deeper in it: deeper still is
/// then where the surface goes through it higher up.
pub(crate) fn cut_into(rapid: &Rapid, mut wall: Wall, ends: &[&Position]) -> Option<Fault> {
    /// Share of the depth at the ends that all the same counts as no deeper.
    const ALIKE: f64 = 1e-3;
    let fresh = wall.clone();
    let mut depth = 0.0;
    for p in ends {
        let look = |wall: &Wall| wall.cut(rapid, p, p, 0);
        depth += Fault::in_all(&mut wall, look, |wall, f| wall.allow(f.depth)).0;
    }
    let through = fresh.is_through(&rapid.profile, depth);
    if through {
        wall = fresh.raised(rapid, ends)?;
    } else {
        wall.allow(ALIKE * depth);
    }
    let mut worst: Option<Fault> = None;
    for (i, pair) in (1..).zip(rapid.points.windows(2)).filter(|(_, w)| !goes_up(w)) {
        let fault = wall.cut(rapid, &pair[0], &pair[1], i);
        if let Some(f) = fault.filter(|f| worst.as_ref().is_none_or(|w| f.depth > w.depth)) {
            worst = Some(f);
        }
    }
    worst.map(|f| {
        // What goes through the tool is as deep in it as it can be.
        let deep = if through { f.depth.max(depth) } else { f.depth + depth * (1.0 + ALIKE) };
        Fault { depth: deep, surface: fresh.called(f.surface), ..f }
    })
}

/// Does the tool go along its axis, away from its end?
pub(crate) fn goes_up(pair: &[Position]) -> bool {
    along_axis(pair).is_some_and(|up| up >= 0.0)
}

/// The same towards its end.
pub(crate) fn goes_down(pair: &[Position]) -> bool {
    along_axis(pair).is_some_and(|up| up < 0.0)
}

/// How far it goes along its axis, if it goes nowhere else.
fn along_axis(pair: &[Position]) -> Option<f64> {
    let way = pair[1].te - pair[0].te;
    let up = way.dot(&pair[0].ta);
    let aside = (way - up * pair[0].ta).norm();
    (aside <= SIDEWAYS * (pair[0].te.norm() + up.abs())).then_some(up)
}

/// How deep beyond its tolerance a tool that stands at `p` is in what is around it.
fn deep(rapid: &Rapid, p: &Position, around: &Around) -> f64 {
    let deep = around.walls(Which::All).into_iter().filter_map(|wall| wall.cut(rapid, p, p, 0));
    deep.fold(0.0, |deepest, f| f.depth.max(deepest))
}

fn told(rapid: &Rapid, fault: &Fault) -> Diagnostic {
    let message = format!(
        "rapid motion cuts into {} by {} beyond tolerance {}",
        fault.surface,
        length(fault.depth),
        fault.place()
    );
    let d = Diagnostic::error(codes::RAPID_CUT, rapid.origin.span, message);
    d.help("go up before going aside, or leave RAPID out").within(rapid.origin.trace.clone())
}

/// The way at feed to the first place of regional milling, held against the part surface where nothing is checked beside it: what
/// the tool cuts off there is missing.
fn arrives(statement: &Statement, around: &Around) -> Option<Diagnostic> {
    if statement.way.is_empty() || statement.rapid {
        return None;
    }
    let points = statement.way.iter().chain(statement.points.first()).copied().collect();
    let way = Rapid::at_feed(&statement.origin, points, statement.profile, statement.pad);
    let help = "lead the tool over it before, with GOTO or GODLTA; CHKSRF/PS,ON refuses such a way";
    let fault = cut(&way, around, End::Excused, true)?;
    let who = "on the way to its first position the tool goes";
    Some(fault.through(&statement.origin, who, help))
}

/// Ending below the part surface before it, where nothing says what the tool does there.
fn ends_low(rapid: &Rapid, fault: &Fault) -> Diagnostic {
    let message = format!(
        "rapid motion ends {} below {} beyond tolerance, {}, and nothing goes as deep after it",
        length(fault.depth),
        fault.surface,
        fault.place()
    );
    let d = Diagnostic::warning(codes::RAPID_ENDS_LOW, rapid.origin.span, message);
    d.help("end it above the part, and go on from there at feed").within(rapid.origin.trace.clone())
}

/// Going aside below the clearance plane.
fn low(rapid: &Rapid, plane: &Plane) -> Option<Diagnostic> {
    let up = |p: &Position| if plane.n.dot(&p.ta) < 0.0 { -1.0 } else { 1.0 };
    let height = |p: &Position| up(p) * plane.distance(p.te);
    let aside = |a: Vec3| (a - plane.n * plane.n.dot(&a)).norm();
    let deepest = rapid
        .points
        .windows(2)
        .filter(|w| aside(w[1].te - w[0].te) > SIDEWAYS * (w[1].te.norm() + w[0].te.norm()))
        .flat_map(|w| [w[0], w[1]])
        .min_by(|a, b| height(a).total_cmp(&height(b)))?;
    let depth = -height(&deepest);
    if depth <= rapid.pad {
        return None;
    }
    let place = at_tool_end(deepest.te.into());
    let message = format!("rapid motion goes aside {depth:.5} below the clearance plane, {place}");
    let d = Diagnostic::warning(codes::RAPID_LOW, rapid.origin.span, message);
    Some(d.help("write CLRSRF/NOW before it").within(rapid.origin.trace.clone()))
}
