//! Regional milling: no point of a surface deeper in the cutter than allowed, along each cut vector.

use std::borrow::Cow;
use std::sync::{Arc, OnceLock};

use aptc_cldata::milling::{Milled, Milling, Plain, Raised};
use aptc_cldata::{NameRef, Position};
use aptc_geometry::surface::kept::between;
use aptc_geometry::{Form, Profile, Shell, Vec3};

use crate::between::{angle, between_poses};
use crate::certificate::{Breach, Fault, SurfaceBound};
use crate::curved::{Curved, Half, Warm, worst};
use crate::demand::Verdict;
use crate::kept::Kept;
use crate::limited::{Last, Limited};
use crate::pile::Pile;
use crate::scallop::{Cusps, Left};
use crate::search::{Aim, Moved, TURNED, clearance_from};
use crate::sheet::Sheet;
use crate::sheets::Sheets;
use crate::statement::{PLACES, Seen, Statement, keep};
use crate::swath::Swath;
use crate::sweep::Sweep;
use crate::tool::{Pose, Tool};
use crate::witness::descend;

/// Halvings of a vector, and stretches of it that are looked at.
const DEPTH: u32 = 22;
const MOST: u32 = 2000;
/// As for a surface that guides the tool.
const LONG: u32 = 5;
/// Halvings that a vector begins with at most, as the ones before it needed; what may be allowed for the turn on a stretch
/// falls to this part of one that was too long, and rises by that after a vector of which none was.
const AHEAD: u32 = 5;
const FALLS: f64 = 0.6;
const RISES: f64 = 1.4;
/// Share of what may be left by which points seen from a tool that turns may leave their chords.
const FINE: f64 = 0.3;

/// Why a cutter that is led along a surface can be deep in it.
const LED: &str = "it is held to the one place that the path leads along; CHKSRF/PS,ON holds it to all of the surface, and AVCTRL takes it out \
    where it does not fit";

/// What there is to say of a tool all in a body.
const HELD: &str = "the tool stands inside of the body that the triangles bound; so deep it is where it touches none";

/// Why it is not known what REGION leaves of loose patches.
const NO_OUTLINE: &str = "the outline of REGION does not go on from patch to patch of it";

/// The surfaces of a statement of regional milling.
#[derive(Debug)]
pub(crate) struct Region {
    /// The part surface first, if there is one, then those that are checked.
    surfaces: Vec<MilledSurface>,
    cusps: Option<Cusps>,
    /// What of the part surface is to be milled, where that is not all.
    limited: Option<Limited>,
    swath: OnceLock<Swath>,
    /// The same with ways from the ends of passes to those of the next.
    linked: OnceLock<Swath>,
}

/// One of them, with what is held against it.
#[derive(Clone, Debug)]
pub(crate) struct MilledSurface {
    body: Body,
    /// What its triangles bound, if they close.
    shell: Option<Arc<Shell>>,
    name: String,
    role: &'static str,
    /// What keeps clear of it beside the cutter itself: of shank and holder one solid, or the axis below them.
    holder: Option<Raised>,
    /// Is that the axis between cutter and holder?
    between: bool,
    /// Is the tool end held to it? Else the cutter stays away from it.
    on: bool,
    side: f64,
    /// Is it led along without being checked?
    led: bool,
    /// Least and greatest distance asked for.
    band: [f64; 2],
}

/// What is known of a surface.
#[derive(Clone, Debug)]
enum Body {
    /// It has charts.
    Sheet(Arc<Sheet>),
    /// It has sides: what is asked on the one from which the tool comes.
    Sided(Box<Kept>),
    /// Nothing that could be proved against.
    Unknown,
}

impl Region {
    /// The tool is at `from` before the statement. `None` when a surface has no charts.
    pub(crate) fn new(
        milling: &Milling,
        sheets: &Sheets,
        profile: &Profile,
        from: &Position,
    ) -> Option<Self> {
        let mut surfaces = Vec::new();
        for (of, role) in milling
            .part
            .iter()
            .map(|p| (p, "part"))
            .chain(milling.checked.iter().map(|c| (c, "checked")))
        {
            // A tool end goes over a border straight on, as the surface is followed.
            let on = role == "part" && milling.on;
            let sheet = if on { sheets.on(&of.surface) } else { sheets.of(&of.surface) };
            surfaces.push(MilledSurface::new(of, role, milling, sheet?));
        }
        let cusps = milling.scallop.as_ref().zip(milling.part.as_ref());
        let cusps = cusps.and_then(|(scallop, part)| {
            let thick = if milling.on { 0.0 } else { part.thick };
            Some(Cusps::new(&sheets.of(&part.surface)?, part.side, thick, milling.outtol, scallop))
        });
        let sheet = milling.part.as_ref().and_then(|p| sheets.of(&p.surface));
        let limited = Limited::new(milling, sheet, profile);
        let plain = |p| MilledSurface::plain(p, milling.intol, sheets, (profile, from));
        surfaces.extend(milling.plain.iter().map(plain));
        // Shank and holder keep clear of what is checked, the part surface only where it is.
        let kept = |s: &&MilledSurface| s.role != "part" || milling.guarded;
        let above: Vec<_> = milling.holder.iter().map(|h| (h.profile, h.up)).collect();
        let rod = between(profile, &above, milling.intol);
        let rod = rod.map(|(profile, up)| (Raised { profile, up }, true));
        let held =
            milling.holder.iter().map(|h| (*h, false)).chain(rod).flat_map(|(h, between)| {
                let held = move |s: &MilledSurface| MilledSurface {
                    holder: Some(h),
                    between,
                    ..s.clone()
                };
                surfaces.iter().filter(kept).map(held)
            });
        let held: Vec<_> = held.collect();
        surfaces.extend(held);
        let (swath, linked) = (OnceLock::new(), OnceLock::new());
        Some(Self { surfaces, cusps, limited, swath, linked })
    }

    pub(crate) fn surfaces(&self) -> &[MilledSurface] {
        &self.surfaces
    }

    /// The worst fault on the way of the tool to its first position.
    pub(crate) fn arrives(
        &self,
        profile: &Profile,
        from: &Position,
        to: &Position,
        pad: f64,
    ) -> Option<Fault> {
        let mut fault = None;
        for s in &self.surfaces {
            let found = s.vector(profile, from, to, pad, 1, &mut Seen::default());
            keep(&mut fault, found);
        }
        fault.map(|f| Fault {
            surface: format!("{} on the way to its first position", f.surface),
            ..f
        })
    }

    /// What a vector mills where nothing is to be milled; one that leads `over` it is told elsewhere.
    pub(crate) fn outside(
        &self,
        profile: &Profile,
        ends: [&Position; 2],
        (over, pad): (bool, f64),
        vector: u64,
        last: &mut Option<Last>,
    ) -> Option<Fault> {
        let limited = self.limited.as_ref()?;
        let whole = limited.is_whole();
        let (te, depth) = if whole {
            limited.vector(profile, ends, (over, pad), last)?
        } else {
            (ends[1].te, f64::INFINITY)
        };
        Some(Fault {
            refuted: whole,
            surface: self.surfaces.first().map_or_else(String::new, MilledSurface::told),
            vector,
            te: te.into(),
            depth,
            gouge: false,
            breach: whole.then_some(Breach::Outside),
            ends: false,
            why: (!whole).then_some(NO_OUTLINE.into()),
        })
    }

    /// What is known of the gaps, shank and holder as one.
    pub(crate) fn bounds(&self, seen: &[Seen]) -> Vec<SurfaceBound> {
        let mut all: Vec<SurfaceBound> = Vec::with_capacity(self.surfaces.len());
        for bound in self.surfaces.iter().zip(seen).filter_map(|(s, seen)| s.bound(seen)) {
            match all.iter_mut().find(|b| (&b.name, b.role) == (&bound.name, bound.role)) {
                Some(b) if bound.least < b.least => *b = bound,
                Some(_) => {}
                None => all.push(bound),
            }
        }
        all
    }

    /// The part surface by its name, and how much may stand on it between the passes.
    pub(crate) fn allowed(&self) -> (String, f64) {
        let name = self.surfaces.first().map_or_else(String::new, |s| s.name.clone());
        (name, self.cusps.as_ref().map_or(0.0, |c| c.height))
    }

    /// May more stand between the passes, for the tool got out of the way there? The reason.
    pub(crate) fn excused(&self) -> Option<&'static str> {
        self.cusps.as_ref()?.excused
    }

    /// What is left at one of [`PLACES`] parts of the region; `None` where nothing is asked.
    pub(crate) fn between(&self, s: &Statement, part: usize) -> Option<Left> {
        // What has put out nothing has nothing between its passes.
        let cusps = self.cusps.as_ref().filter(|_| !s.points.is_empty())?;
        let new = |links: &[[Pose; 2]]| {
            let ways = [&ways(&s.start, &s.points), links].concat();
            Swath::new(&s.profile, false, &ways, FINE * cusps.room)
        };
        let swath = self.swath.get_or_init(|| new(&[]));
        let linked = || self.linked.get_or_init(|| new(&cusps.links));
        Some(cusps.judge(swath, linked, s.pad, part, PLACES))
    }
}

/// The vectors to the points.
pub(crate) fn ways(start: &Option<Position>, points: &[Position]) -> Vec<[Pose; 2]> {
    let pose = |p: &Position| Pose { te: p.te, ta: p.ta };
    let first = start.as_ref().or(points.first());
    first.into_iter().chain(points).zip(points).map(|(a, b)| [pose(a), pose(b)]).collect()
}

impl MilledSurface {
    fn new(of: &Milled, role: &'static str, milling: &Milling, sheet: Arc<Sheet>) -> Self {
        let on = role == "part" && milling.on;
        // A thickness is left by a cutter that touches, not where the tool end is led.
        let thick = if on { 0.0 } else { of.thick };
        let (least, most) = (thick - milling.intol, thick + milling.outtol);
        Self {
            body: Body::Sheet(sheet),
            shell: of.body.clone(),
            name: name_of(&of.name),
            role,
            holder: None,
            between: false,
            on,
            side: of.side,
            led: role == "part" && !on && !milling.guarded,
            band: [least, if on && !milling.risen { most } else { f64::INFINITY }],
        }
    }

    /// A surface beside motion that does not run along it, which may touch it; `None` where it has no charts.
    pub(crate) fn passed(
        of: &Milled,
        role: &'static str,
        milling: &Milling,
        sheets: &Sheets,
    ) -> Option<Self> {
        let new = Self::new(of, role, milling, sheets.of(&of.surface)?);
        let deep = Milling::touching(milling.intol, milling.outtol) - milling.intol;
        let band = [new.band[0] - deep, f64::INFINITY];
        Some(Self { on: false, led: false, band, ..new })
    }

    /// The part surface that the tool end is led on; `None` where it has no charts.
    pub(crate) fn led_on(of: &Milled, milling: &Milling, sheets: &Sheets) -> Option<Self> {
        Some(Self::new(of, "part", milling, sheets.of(&of.surface)?))
    }

    /// A surface of another kind beside such motion of a tool that came to the milling from a place of the cutter; `None` of what
    /// cannot be told, and around a tool that works inside of a round surface: leaving it is no cut.
    pub(crate) fn passed_plain(
        of: &Plain,
        milling: &Milling,
        sheets: &Sheets,
        from: (&Profile, &Position),
    ) -> Option<Self> {
        let touching = Milling::touching(milling.intol, milling.outtol);
        let new = Self::plain(of, touching, sheets, from);
        let told = match &new.body {
            Body::Sided(kept) => !kept.is_round_about(),
            Body::Sheet(_) => true,
            Body::Unknown => false,
        };
        told.then_some(new)
    }

    /// Allows the tool to be deeper by so much.
    pub(crate) fn allow(&mut self, deeper: f64) {
        self.band[0] -= deeper;
        if let Body::Sided(kept) = &mut self.body {
            kept.allow(deeper);
        }
    }

    /// Is nothing known of it but where its points are? How deep a tool is that it goes through is not told then.
    pub(crate) fn has_no_sides(&self) -> bool {
        !matches!(self.body, Body::Sided(_))
    }

    /// Does it end above, as seen along the axis, whatever stands for the rest of it?
    pub(crate) fn ends_along(&self, ta: Vec3) -> bool {
        matches!(&self.body, Body::Sided(kept) if kept.ends_along(ta))
    }

    /// The least distance that is asked for.
    pub(crate) fn least(&self) -> f64 {
        self.band[0]
    }

    /// The same for a tool that is raised along its axis.
    pub(crate) fn raised(&self, profile: &Profile, up: f64) -> Self {
        Self { holder: Some(Raised { profile: *profile, up }), ..self.clone() }
    }

    /// A surface that is not sculptured. Its straight continuations belong to it.
    fn plain(of: &Plain, intol: f64, sheets: &Sheets, from: (&Profile, &Position)) -> Self {
        let depth = intol - of.thick;
        let deep = [intol, depth];
        let sided = || Some(Body::Sided(Box::new(Kept::new(&of.form, deep, sheets, from)?)));
        // The working surface of a POLCON with a thickness is another one.
        let thick = matches!(of.form.shape(), Form::Polyconic(p) if p.thickness != 0.0);
        let sheet = || sheets.of_form(&of.form).filter(|_| !thick).map(Body::Sheet);
        Self {
            body: sided().or_else(sheet).unwrap_or(Body::Unknown),
            shell: None,
            name: name_of(&of.name),
            role: "checked",
            holder: None,
            between: false,
            on: false,
            side: 1.0,
            led: false,
            band: [-depth, f64::INFINITY],
        }
    }

    /// Any surface that may be in the tool by `depth`; `None` of those that have neither charts nor sides, and of a POLCON with a
    /// thickness, whose working surface is another one.
    pub(crate) fn beside(
        form: &Arc<Form>,
        depth: f64,
        sheets: &Sheets,
        from: (&Profile, &Position),
    ) -> Option<Self> {
        let sheet = || sheets.of_form(form).map(Body::Sheet);
        let sided = || Some(Body::Sided(Box::new(Kept::new(form, [depth; 2], sheets, from)?)));
        let body = match form.shape() {
            Form::Ssurf(_) => sheets.alone(form).map(Body::Sheet),
            Form::Polyconic(p) if p.thickness != 0.0 => None,
            Form::Tabcyl(_) | Form::Ruled(_) | Form::Polyconic(_) => sheet(),
            _ => sided().or_else(sheet),
        };
        Some(Self {
            body: body?,
            shell: None,
            name: String::new(),
            role: "",
            holder: None,
            between: false,
            on: false,
            side: 1.0,
            led: false,
            band: [-depth, f64::INFINITY],
        })
    }

    /// Is it a round surface in which the tool is before a way and after it? A straight one stays inside.
    pub(crate) fn encloses(&self, profile: &Profile, to: &Position) -> bool {
        match &self.body {
            Body::Sided(kept) => kept.encloses(self.tool(profile).inner(&Pose::of(to))),
            _ => false,
        }
    }

    /// Judges a cut vector; the fault, if there is one, else `seen` takes its bounds.
    pub(crate) fn vector(
        &self,
        profile: &Profile,
        a: &Position,
        b: &Position,
        pad: f64,
        vector: u64,
        seen: &mut Seen,
    ) -> Option<Fault> {
        let tool = self.tool(profile);
        let [from, most] = self.band;
        let warm = &mut seen.warm;
        let verdict = match &self.body {
            Body::Sheet(sheet) if self.on && self.holder.is_none() => {
                let curved =
                    Curved { sheet, side: self.side, on: true, moved: 0.0, least: from, most };
                curved.judge(&Tool::End, a, b, pad, warm)
            }
            Body::Sheet(sheet) => clear(sheet, &tool, [a, b], from - pad, warm),
            Body::Sided(kept) => kept.judge(&tool, a, b, pad, warm),
            Body::Unknown => Verdict::Undecided { at_most: f64::INFINITY, te: a.te },
        };
        let surface = || self.told();
        match verdict {
            Verdict::Proved { low, high } => {
                seen.take(low, high, Some(b.te));
                None
            }
            Verdict::Refuted { gap, te } => {
                let gouge = gap < from;
                let depth = if gouge { from - gap } else { gap - self.band[1] };
                let why = match &self.body {
                    Body::Sided(kept) => kept.entered(profile, te, [a, b]).map(Cow::Owned),
                    _ => (gouge && self.led).then_some(Cow::Borrowed(LED)),
                };
                let te = te.into();
                Some(Fault {
                    refuted: true,
                    surface: surface(),
                    vector,
                    te,
                    depth,
                    gouge,
                    breach: None,
                    ends: false,
                    why,
                })
            }
            Verdict::Undecided { at_most, te } => Some(Fault {
                refuted: false,
                surface: surface(),
                vector,
                te: te.into(),
                depth: at_most,
                gouge: true,
                breach: None,
                ends: false,
                why: None,
            }),
        }
    }

    /// The solid that is held against it.
    fn tool<'a>(&'a self, cutter: &'a Profile) -> Tool<'a> {
        match &self.holder {
            Some(Raised { profile, up }) => Tool::Raised(profile, *up),
            None => Tool::Solid(cutter),
        }
    }

    pub(crate) fn told(&self) -> String {
        let with = match (&self.holder, self.between) {
            (None, _) => "",
            (Some(_), false) => " with the holder",
            (Some(_), true) => " with the axis between cutter and holder",
        };
        format!("{} surface {}{with}", self.role, self.name)
    }

    /// A tool that stands in a body whose triangles it does not touch, wherever it goes on to without touching them.
    pub(crate) fn holds(&self, cutter: &Profile, at: &Position) -> Option<Fault> {
        let inner = self.tool(cutter).inner(&Pose { te: at.te, ta: at.ta });
        let depth = self.shell.as_ref()?.holds(inner)?;
        Some(Fault {
            refuted: true,
            surface: self.told(),
            vector: 1,
            te: at.te.into(),
            depth,
            gouge: true,
            breach: None,
            ends: false,
            why: Some(Cow::Borrowed(HELD)),
        })
    }

    /// What is known of the gap; nothing before a vector was proved.
    fn bound(&self, seen: &Seen) -> Option<SurfaceBound> {
        (seen.low < f64::INFINITY).then(|| SurfaceBound {
            name: self.name.clone(),
            role: if self.holder.is_some() { "holder" } else { self.role },
            least: seen.low,
            most: seen.high,
            band: self.band,
            at: seen.at.map(Into::into),
        })
    }
}

pub(crate) fn name_of(n: &NameRef) -> String {
    if n.subscript > 0 { format!("{}({})", n.name, n.subscript) } else { n.name.to_string() }
}

/// The same along a vector, at its deepest place where it is not so.
pub(crate) fn clear(
    sheet: &Sheet,
    tool: &Tool<'_>,
    [a, b]: [&Position; 2],
    least: f64,
    warm: &mut Warm,
) -> Verdict {
    let ends = [Pose { te: a.te, ta: a.ta }, Pose { te: b.te, ta: b.ta }];
    let pose = |t: f64| between_poses(&ends[0], &ends[1], t);
    let own = |t: f64| sheet.local(&pose(t));
    let turn = angle(a.ta, b.ta);
    let first = keeps_off(tool, sheet, &own, turn, least, warm);
    // How deep it is is told as it is found; that all the rest is less deep need not be shown.
    let deeper = |least: f64| {
        let mut warm = Warm::default();
        warm.lead.known = true;
        keeps_off(tool, sheet, &own, turn, least, &mut warm)
    };
    match worst(first, least, deeper) {
        Half::Holds(low) => Verdict::Proved { low, high: f64::INFINITY },
        Half::Broken(t, gap) => Verdict::Refuted { gap, te: pose(t).te },
        Half::Open(t, at_most) => Verdict::Undecided { at_most, te: pose(t).te },
    }
}

/// That no point of the surface is nearer to the tool than `least`, negative in the tool.
fn keeps_off(
    tool: &Tool<'_>,
    sheet: &Sheet,
    pose: &dyn Fn(f64) -> Pose,
    turn: f64,
    least: f64,
    warm: &mut Warm,
) -> Half {
    let moved = Moved::whole(sheet, 1.0, 0.0);
    let mut low = f64::INFINITY;
    let mut open = (0.0, 0.0);
    // Room for those stretches and for one more at each halving.
    let mut stack = Pile::<(f64, f64, u32), 64>::new();
    // Stretches as long as those that served along the vector before: what is allowed for the turn falls by four with
    // their length.
    let whole = Sweep::new(tool, pose(0.0), pose(1.0), turn).turned();
    let longest = warm.stretch.unwrap_or(f64::INFINITY);
    let (mut ahead, mut allowed) = (0, whole);
    while ahead < AHEAD && allowed > longest {
        (ahead, allowed) = (ahead + 1, 0.25 * allowed);
    }
    let parts = 1_u32 << ahead;
    for i in (0..parts).rev() {
        let [t0, t1] = [i, i + 1].map(|i| f64::from(i) / f64::from(parts));
        stack.push((t0, t1, ahead));
    }
    let mut halved = false;
    let mut seen = 0;
    while let Some((t0, t1, depth)) = stack.pop() {
        seen += 1;
        let sweep = Sweep::new(tool, pose(t0), pose(t1), turn * (t1 - t0));
        let found = clearance_from(&sweep, &moved, least, Aim::Clear, &mut warm.lead);
        if found.least >= least {
            low = low.min(found.least);
            continue;
        }
        if let Some((_, t, spot)) = found.nearest {
            let t = t0 + t * (t1 - t0);
            let (distance, ..) = descend(tool, &pose(t), sheet, spot);
            if distance < least {
                return Half::Broken(t, distance);
            }
        }
        let short = least - found.least;
        let turned = sweep.turned();
        let helps = if short == f64::INFINITY {
            depth < LONG
        } else {
            sweep.turn > 0.0 && short <= TURNED * turned && depth < DEPTH
        };
        if helps && seen < MOST {
            if turned > 0.0 && short < f64::INFINITY {
                halved = true;
                warm.stretch = Some(warm.stretch.unwrap_or(f64::INFINITY).min(FALLS * turned));
            }
            let m = 0.5 * (t0 + t1);
            stack.push((m, t1, depth + 1));
            stack.push((t0, m, depth + 1));
        } else if short > open.1 {
            open = (t0, short);
        }
    }
    if !halved {
        warm.stretch = warm.stretch.map(|s| s * RISES);
    }
    if open.1 > 0.0 { Half::Open(open.0, open.1) } else { Half::Holds(low) }
}

#[cfg(test)]
#[path = "milled_tests.rs"]
mod tests;
