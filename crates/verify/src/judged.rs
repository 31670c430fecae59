//! A surface with what is known of it over a statement.

use aptc_cldata::{Control, Controlled, Position, Relation};
use aptc_geometry::{Profile, Vec3};

use crate::certificate::{Breach, Fault, SurfaceBound};
use crate::curved::Warm;
use crate::demand::{Demand, Verdict};
use crate::past::Passed;
use crate::ridge::{Ridge, turns_over};
use crate::sheets::Sheets;
use crate::statement::Seen;

/// Widths of its band by which a tangent check surface may be missed where a motion ends.
const MISSED: f64 = 2.0;

/// Why a turn in place on a ridge is not proved.
const ON_RIDGE: &str = "the tool turns on the ridge to this surface and stands there in what goes on beyond it; of surfaces that are not flat or round outwards it is not proved that nothing of them is in its way";

#[derive(Clone, Debug)]
pub(crate) struct Judged {
    demand: Demand,
    /// The disk of CUTTER/OPTION, which is proved as programmed.
    disk: Option<Profile>,
    name: String,
    /// The same with its role, as messages call it.
    called: String,
    role: &'static str,
}

impl Judged {
    /// Drive, part or check surface as it was asked for.
    pub(crate) fn new(c: &Controlled, role: &'static str, sheets: &Sheets) -> Self {
        let mut demand = Demand::new(c, sheets);
        // Where it counts as tangent a check surface may be missed by some of its band, and the other surface's band takes that up.
        if matches!(c.relation, Relation::Tanto | Relation::Pstan) {
            demand.most += MISSED * (c.intol + c.outtol);
        }
        Self::with(demand, c, role)
    }

    /// The same with the band that the motion before was held to beside it, where that is wider; `None` where it is not.
    pub(crate) fn eased(
        c: &Controlled,
        role: &'static str,
        sheets: &Sheets,
        earlier: &Control,
    ) -> Option<Self> {
        let [intol, outtol] = earlier.band_of(c)?;
        let [intol, outtol] = [intol.max(c.intol), outtol.max(c.outtol)];
        (intol > c.intol || outtol > c.outtol)
            .then(|| Self::new(&Controlled { intol, outtol, ..c.clone() }, role, sheets))
    }

    /// What is wrong with the first vector where it brings the tool into this band from where the motion before left it, in its band
    /// `eased`, and goes no farther out of this one on its way; `None` where it does not. It is short beside how far it comes.
    pub(crate) fn come_to(
        &self,
        eased: &Self,
        profile: &Profile,
        [from, to]: [&Position; 2],
        (comes, pad): (f64, f64),
        seen: &mut Seen,
    ) -> Option<Option<Fault>> {
        /// Share of how far off it begins that all the same counts as no farther.
        const ALIKE: f64 = 1e-3;
        /// Its length at most, in widths of the band and how far the tool comes to all surfaces.
        const LONG: f64 = 3.0;
        let (mut wide, mut off) = self.reaching(profile, from, pad);
        // A place alone may be hard to decide, where a way from it shows how far off it is.
        let begins = |f: &Fault| f.refuted && (Vec3::from(f.te) - from.te).norm() <= pad;
        let look = |wide: &Self| {
            wide.vector(profile, from, to, pad, 1, &mut Seen::default()).filter(begins)
        };
        off += Fault::in_all(&mut wide, look, |wide, f| wide.widen(f.depth, f.gouge)).0;
        let band = self.demand.most - self.demand.least;
        if off <= 0.0 || (to.te - from.te).norm() > LONG * (comes + band) {
            return None;
        }
        let gouges = wide.demand.least < self.demand.least;
        wide.widen(ALIKE * off, gouges);
        // The motion before may have left it there.
        let slack = ALIKE * (off + band);
        let left = wide.demand.least >= eased.demand.least - slack
            && wide.demand.most <= eased.demand.most + slack;
        match wide.vector(profile, from, to, pad, 1, seen) {
            _ if !left => None,
            Some(fault) if fault.refuted => None,
            Some(fault) => Some(Some(fault)),
            None => Some(self.vector(profile, to, to, pad, 1, seen)),
        }
    }

    /// What is wrong with the first vector, found to be so, where it turns the tool in place over the ridge between a surface of the
    /// motion before and this one, going on to `on`; `None` where it does not.
    pub(crate) fn over_ridge(
        &self,
        found: &Fault,
        earlier: &Control,
        (way, on): ([&Position; 2], Vec3),
        (profile, pad): (&Profile, f64),
        sheets: &Sheets,
    ) -> Option<Option<Fault>> {
        /// How much deeper than in the plane that is tangent there it may be.
        const ALIKE: f64 = 1.25;
        let held = (self.disk.as_ref().unwrap_or(profile), pad);
        let ridge = turns_over(&self.demand, earlier, way, on, held, sheets)?;
        let end = self.vector(profile, way[1], way[1], pad, 1, &mut Seen::default());
        match ridge {
            _ if end.is_some() => Some(end),
            Ridge::Clear => Some(None),
            // What is deeper than that is not beyond the ridge.
            Ridge::Likely(deep) => {
                let beyond = found.depth <= ALIKE * deep + self.demand.most - self.demand.least;
                let why = Some(ON_RIDGE.into());
                beyond.then(|| Some(Fault { refuted: false, why, ..found.clone() }))
            }
        }
    }

    /// How far out of the band a tool is at least that stands there.
    pub(crate) fn off(&self, profile: &Profile, at: &Position, pad: f64) -> f64 {
        self.reaching(profile, at, pad).1
    }

    /// The same with the band that reaches so far. What is left then is too little to be decided: that it is no more is for a band a
    /// little wider to show.
    fn reaching(&self, profile: &Profile, at: &Position, pad: f64) -> (Self, f64) {
        let mut wide = self.clone();
        let look = |wide: &Self| wide.vector(profile, at, at, pad, 0, &mut Seen::default());
        let (off, _) = Fault::in_all(&mut wide, look, |wide, f| wide.widen(f.depth, f.gouge));
        (wide, off)
    }

    /// Allows the tool to be deeper by so much, or farther off.
    fn widen(&mut self, by: f64, deeper: bool) {
        if deeper {
            self.demand.least -= by;
        } else {
            self.demand.most += by;
        }
    }

    /// That the tool does not pass a check surface before it stops there, or at another. `None` where it may: it stops
    /// at a later meeting, runs in tangentially, or has passed it when the motion begins. With `either` its side is not known.
    pub(crate) fn never_past(
        c: &Controlled,
        profile: &Profile,
        start: &Position,
        pad: f64,
        sheets: &Sheets,
        either: bool,
    ) -> Option<Self> {
        if either && c.relation != Relation::On {
            let sides = [c.side, -c.side].map(|side| Controlled { side, ..c.clone() });
            let never = |c| Self::never_past(c, profile, start, pad, sheets, false);
            return sides.iter().find_map(never);
        }
        if c.nth > 1 {
            return None;
        }
        let mut demand = Demand::new(c, sheets);
        let band = c.intol.max(c.outtol);
        match c.relation {
            Relation::To => demand.most = f64::INFINITY,
            Relation::Past => demand.least = f64::NEG_INFINITY,
            Relation::On => {
                let gap = demand.gap_at(profile, start)? - demand.moved;
                if gap.abs() <= 2.0 * band {
                    return None;
                }
                (demand.least, demand.most) = if gap > 0.0 {
                    (demand.moved - band, f64::INFINITY)
                } else {
                    (f64::NEG_INFINITY, demand.moved + band)
                };
            }
            Relation::Tanto | Relation::Pstan => return None,
        }
        let gap = demand.gap_at(profile, start);
        if c.relation == Relation::To && gap.is_none_or(|gap| gap <= demand.moved) {
            return Self::never_through(c, profile, start, pad, sheets);
        }
        let gap = gap?;
        // What begins at the surface may have to leave it first.
        let beside = gap >= demand.least + 2.0 * band && gap <= demand.most - 2.0 * band;
        (beside && pad.is_finite()).then(|| Self::with(demand, c, "check"))
    }

    /// That a tool which stops TO a check surface on the other side of it than that on which it begins comes round its end, and not
    /// through it. `None` where it begins at the surface or in it.
    fn never_through(
        c: &Controlled,
        profile: &Profile,
        start: &Position,
        pad: f64,
        sheets: &Sheets,
    ) -> Option<Self> {
        let band = 2.0 * c.intol.max(c.outtol);
        let other = Controlled { side: -c.side, ..c.clone() };
        let mut demand = Demand::new(&other, sheets);
        let gap = demand.gap_at(profile, start)?;
        let begins = gap >= demand.moved.max(0.0) + band;
        // Where it stops it touches the surface from behind, by no more than its band.
        (demand.least, demand.most) = (band, f64::INFINITY);
        (begins && pad.is_finite()).then(|| Self::with(demand, c, "check"))
    }

    /// That the tool does not cut into a surface along which it moved before or will move: the cutter is on
    /// the side of it where it was at `at`.
    pub(crate) fn clear(
        c: &Controlled,
        at: &Position,
        profile: &Profile,
        sheets: &Sheets,
    ) -> Option<Self> {
        let mut c = c.clone();
        c.disk = None;
        c.outtol = f64::INFINITY;
        if c.side == 0 {
            // The tool end is on it, the cutter above.
            let above = Position { te: at.te + 1e-3 * profile.reach() * at.ta, ta: at.ta };
            let demand = Demand::new(&c, sheets);
            let gap = demand.gap_at(profile, &above)?;
            c.side = if gap < demand.moved { -1 } else { 1 };
        }
        c.relation = Relation::To;
        Some(Self::with(Demand::new(&c, sheets), &c, "part"))
    }

    fn with(demand: Demand, c: &Controlled, role: &'static str) -> Self {
        Self { demand, disk: disk(c), name: name(c), called: called(c, role), role }
    }

    /// Allows the tool to be deeper by so much.
    pub(crate) fn allow(&mut self, deeper: f64) {
        self.widen(deeper, true);
    }

    /// Judges a cut vector; the fault, if there is one, else `seen` takes its bounds.
    pub(crate) fn vector(
        &self,
        profile: &Profile,
        from: &Position,
        to: &Position,
        pad: f64,
        vector: u64,
        seen: &mut Seen,
    ) -> Option<Fault> {
        let profile = self.disk.as_ref().unwrap_or(profile);
        seen.warm.told = (seen.low <= seen.high).then_some(seen.low);
        let verdict = self.demand.judge_next(profile, from, to, pad, &mut seen.warm);
        if let Verdict::Proved { low, high } = verdict {
            seen.take(low, high, Some(to.te));
        }
        self.fault(verdict, vector)
    }

    /// Judges all vectors from `start` through the points at once. Is all proved, and `seen` has its bounds? Else nothing is
    /// known.
    pub(crate) fn row(
        &self,
        profile: &Profile,
        start: &Position,
        points: &[Position],
        pad: f64,
        seen: &mut Seen,
    ) -> bool {
        let profile = self.disk.as_ref().unwrap_or(profile);
        let run = self.demand.row(profile, start, points, pad);
        if let Some(run) = run {
            seen.take(run.low, run.high, run.at);
        }
        run.is_some()
    }

    /// Where a disk stands for the cutter: how the cutter itself cuts in.
    pub(crate) fn real_cutter(
        &self,
        profile: &Profile,
        from: &Position,
        to: &Position,
        pad: f64,
        vector: u64,
    ) -> Option<Fault> {
        self.disk?;
        let mut demand = self.demand.clone();
        demand.most = f64::INFINITY;
        // Of what is proved nothing is told.
        let verdict = demand.judge_next(profile, from, to, pad, &mut Warm::silent());
        self.fault(verdict, vector).filter(|f| f.refuted)
    }

    fn fault(&self, verdict: Verdict, vector: u64) -> Option<Fault> {
        match verdict {
            Verdict::Proved { .. } => None,
            Verdict::Refuted { gap, te } => {
                let gouge = gap < self.demand.least;
                let depth = if gouge { self.demand.least - gap } else { gap - self.demand.most };
                Some(Fault {
                    refuted: true,
                    surface: self.called.clone(),
                    vector,
                    te: te.into(),
                    depth,
                    gouge,
                    breach: None,
                    ends: false,
                    why: None,
                })
            }
            Verdict::Undecided { at_most, te } => Some(Fault {
                refuted: false,
                surface: self.called.clone(),
                vector,
                te: te.into(),
                depth: at_most,
                gouge: false,
                breach: None,
                ends: false,
                why: None,
            }),
        }
    }

    /// That the motion went past where this check surface is tangent.
    pub(crate) fn past(&self, passed: &Passed) -> Fault {
        Fault {
            refuted: true,
            surface: self.called.clone(),
            vector: passed.vector as u64 + 1,
            te: passed.te.into(),
            depth: passed.by,
            gouge: false,
            breach: Some(Breach::Past),
            ends: false,
            why: None,
        }
    }

    /// How the surface is proved against; of several ways the first by name is the slowest.
    pub(crate) fn method(&self) -> &'static str {
        self.demand.method()
    }

    /// What is known of the gap; nothing before a vector was proved.
    pub(crate) fn bound(&self, seen: &Seen) -> Option<SurfaceBound> {
        (seen.low <= seen.high).then(|| SurfaceBound {
            name: self.name.clone(),
            role: self.role,
            least: seen.low,
            most: seen.high,
            band: [self.demand.least, self.demand.most],
            at: seen.at.map(Into::into),
        })
    }
}

/// The disk of CUTTER/OPTION that stands for the cutter against a surface.
pub(crate) fn disk(c: &Controlled) -> Option<Profile> {
    c.disk.and_then(|[radius, height]| Profile::disk(radius, height).ok())
}

fn name(c: &Controlled) -> String {
    match (c.name.name.as_str(), c.name.subscript) {
        ("", _) => c.form.kind().word().to_owned(),
        (n, 0) => n.to_owned(),
        (n, i) => format!("{n}({i})"),
    }
}

/// A surface with its role, as messages call it.
pub(crate) fn called(c: &Controlled, role: &str) -> String {
    if c.name.is_in_words() { name(c) } else { format!("{role} surface {}", name(c)) }
}
