//! Regional milling: no point of a surface deeper in the cutter than allowed, along each cut vector.

use std::sync::{Arc, OnceLock};

use aptc_cldata::milling::{Milled, Milling};
use aptc_cldata::{NameRef, Position};
use aptc_geometry::Profile;

use crate::certificate::{Fault, SurfaceBound};
use crate::curved::{Curved, Half, Warm, worst};
use crate::demand::{Verdict, angle, between_poses};
use crate::pile::Pile;
use crate::scallop::{Cusps, Left};
use crate::search::{Aim, FOLD, Moved, clearance_from};
use crate::sheet::Sheet;
use crate::sheets::Sheets;
use crate::statement::{PLACES, Seen, Statement};
use crate::swath::Swath;
use crate::sweep::Sweep;
use crate::tool::{Pose, Tool};
use crate::witness::descend;

/// Halvings of a vector, and stretches of it that are looked at.
const DEPTH: u32 = 22;
const MOST: u32 = 2000;
/// As for a surface that guides the tool.
const TURNED: f64 = 20.0;
const LONG: u32 = 5;

/// The surfaces of a statement of regional milling.
#[derive(Debug)]
pub(crate) struct Region {
    /// The part surface first, if there is one, then those that are checked.
    surfaces: Vec<MilledSurface>,
    cusps: Option<Cusps>,
    swath: OnceLock<Swath>,
}

/// One of them.
#[derive(Debug)]
pub(crate) struct MilledSurface {
    sheet: Arc<Sheet>,
    name: String,
    role: &'static str,
    /// Is the tool end held to it? Else the cutter stays away from it.
    on: bool,
    side: f64,
    /// Least and greatest distance asked for.
    band: [f64; 2],
}

impl Region {
    /// `None` when a surface has no charts.
    pub(crate) fn new(milling: &Milling, sheets: &Sheets) -> Option<Self> {
        let part = milling.part.iter().map(|p| (p, "part"));
        let all = part.chain(milling.checked.iter().map(|c| (c, "checked")));
        let new = |(of, role): (&Milled, _)| {
            Some(MilledSurface::new(of, role, milling, sheets.of(&of.surface)?))
        };
        let surfaces = all.map(new).collect::<Option<Vec<_>>>()?;
        let cusps = milling.scallop.zip(milling.part.as_ref()).map(|(scallop, part)| {
            let height = part.thick + scallop.height + milling.outtol;
            Cusps::new(&surfaces[0].sheet, part.side, height, (scallop.range, scallop.avoided))
        });
        Some(Self { surfaces, cusps, swath: OnceLock::new() })
    }

    pub(crate) fn surfaces(&self) -> &[MilledSurface] {
        &self.surfaces
    }

    /// The part surface by its name, and how much may stand on it between the passes.
    pub(crate) fn allowed(&self) -> (String, f64) {
        let name = self.surfaces.first().map_or_else(String::new, |s| s.name.clone());
        (name, self.cusps.as_ref().map_or(0.0, |c| c.height))
    }

    /// May more stand between the passes, for the tool got out of the way there?
    pub(crate) fn avoided(&self) -> bool {
        self.cusps.as_ref().is_some_and(|c| c.avoided)
    }

    /// What is left at one of [`PLACES`] parts of the region; `None` where nothing is asked.
    pub(crate) fn between(&self, s: &Statement, part: usize) -> Option<Left> {
        let cusps = self.cusps.as_ref()?;
        let swath =
            self.swath.get_or_init(|| Swath::new(&s.profile, false, ways(&s.start, &s.points)));
        Some(cusps.judge(swath, s.pad, part, PLACES))
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
            sheet,
            name: name_of(&of.name),
            role,
            on,
            side: of.side,
            band: [least, if on { most } else { f64::INFINITY }],
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
        let (verdict, from) = if self.on {
            let [least, most] = self.band;
            let curved = Curved { sheet: &self.sheet, side: self.side, on: true, least, most };
            (curved.judge(&Tool::End, a, b, pad, &mut seen.warm), least)
        } else {
            (self.clear(&Tool::Solid(profile), a, b, pad, &mut seen.warm), self.band[0])
        };
        let surface = || format!("{} surface {}", self.role, self.name);
        match verdict {
            Verdict::Proved { low, high } => {
                seen.take(low, high, Some(b.te));
                None
            }
            Verdict::Refuted { gap, te } => {
                let gouge = gap < from;
                let depth = if gouge { from - gap } else { gap - self.band[1] };
                let te = te.into();
                Some(Fault { refuted: true, surface: surface(), vector, te, depth, gouge })
            }
            Verdict::Undecided { at_most, te } => Some(Fault {
                refuted: false,
                surface: surface(),
                vector,
                te: te.into(),
                depth: at_most,
                gouge: true,
            }),
        }
    }

    /// That no point of the surface is nearer to the cutter than the least.
    fn clear(
        &self,
        tool: &Tool<'_>,
        a: &Position,
        b: &Position,
        pad: f64,
        warm: &mut Warm,
    ) -> Verdict {
        let ends = [Pose { te: a.te, ta: a.ta }, Pose { te: b.te, ta: b.ta }];
        let pose = |t: f64| between_poses(&ends[0], &ends[1], t);
        let turn = angle(a.ta, b.ta);
        let least = self.band[0] - pad;
        let first = keeps_off(tool, &self.sheet, &pose, turn, least, warm);
        let deeper =
            |least: f64| keeps_off(tool, &self.sheet, &pose, turn, least, &mut Warm::default());
        match worst(first, least, deeper) {
            Half::Holds(low) => Verdict::Proved { low, high: f64::INFINITY },
            Half::Broken(t, gap) => Verdict::Refuted { gap, te: pose(t).te },
            Half::Open(t, at_most) => Verdict::Undecided { at_most, te: pose(t).te },
        }
    }

    /// What is known of the gap; nothing before a vector was proved.
    pub(crate) fn bound(&self, seen: &Seen) -> Option<SurfaceBound> {
        (seen.low < f64::INFINITY).then(|| SurfaceBound {
            name: self.name.clone(),
            role: self.role,
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

/// That no point of the surface is nearer to the tool than `least`, negative in the tool.
fn keeps_off(
    tool: &Tool<'_>,
    sheet: &Sheet,
    pose: &dyn Fn(f64) -> Pose,
    turn: f64,
    least: f64,
    warm: &mut Warm,
) -> Half {
    let moved = Moved { sheet, side: 1.0, shift: 0.0, fold: FOLD };
    let mut low = f64::INFINITY;
    let mut open = (0.0, 0.0);
    let mut stack = Pile::<(f64, f64, u32), 32>::new();
    stack.push((0.0, 1.0, 0));
    let mut seen = 0;
    while let Some((t0, t1, depth)) = stack.pop() {
        seen += 1;
        let sweep = Sweep::new(tool, pose(t0), pose(t1), turn * (t1 - t0));
        let found = clearance_from(&sweep, &moved, least, Aim::Clear, &mut warm.direction);
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
        let turned = sweep.pad + 0.25 * sweep.turn * (sweep.b.te - sweep.a.te).norm();
        let helps = if short == f64::INFINITY {
            depth < LONG
        } else {
            sweep.turn > 0.0 && short <= TURNED * turned && depth < DEPTH
        };
        if helps && seen < MOST {
            let m = 0.5 * (t0 + t1);
            stack.push((m, t1, depth + 1));
            stack.push((t0, m, depth + 1));
        } else if short > open.1 {
            open = (t0, short);
        }
    }
    if open.1 > 0.0 { Half::Open(open.0, open.1) } else { Half::Holds(low) }
}
