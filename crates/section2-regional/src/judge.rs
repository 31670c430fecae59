//! A chord between two positions held against the part surface.

use aptc_contact::{Clear, Swept, Tool};
use aptc_geometry::{Vec3, trig};

use crate::drive::Course;
use crate::position::Position;
use crate::settings::Band;
use crate::solve::{Memory, Setup};

/// Places between the ends at which a chord is judged first.
const JUDGED: usize = 5;
/// Halvings of the stretch that one contact answers for.
const HALVINGS: u32 = 6;

/// What a chord does to the tolerance.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Judged {
    /// Part of the tolerance that is used; above 1 too much.
    pub(crate) used: f64,
    /// Deviation at the worst place.
    pub(crate) deviation: f64,
    /// The place on the part surface.
    pub(crate) part_uv: [f64; 2],
}

/// A contact with the share of the chord beside it.
#[derive(Clone, Copy)]
struct Beside {
    /// Share of the drive's parameter.
    f: f64,
    /// Share of the chord.
    s: f64,
    contact: Vec3,
}

/// The chord that is judged.
struct Chord<'a> {
    ends: [&'a Position; 2],
    course: Course,
    sense: f64,
}

impl Chord<'_> {
    fn uv(&self, f: f64) -> [f64; 2] {
        let k = self.course.index();
        let mut uv = self.ends[0].drive_uv;
        uv[k] += (self.ends[1].drive_uv[k] - uv[k]) * f;
        uv
    }

    fn by(&self) -> Vec3 {
        self.ends[1].te - self.ends[0].te
    }

    /// The share of the chord beside a tool end.
    fn beside(&self, te: Vec3) -> f64 {
        let v = self.by();
        let square = v.norm_squared();
        if square > 0.0 { ((te - self.ends[0].te).dot(&v) / square).clamp(0.0, 1.0) } else { 0.0 }
    }
}

impl Setup<'_> {
    /// How much of the tolerance the chord between two positions uses.
    ///
    /// At places between its ends it is compared with the exact positions there, sideways also. Then bounds
    /// for the whole of it: how far the cutter stands off the places that it touches between, and how deep
    /// it is in the part surface, which is proved.
    ///
    /// APT: `GCHK` with `MIDPNT`, `MIDKUR`, `DEVCAL` and `XTPCAL`, which judged the middle of the parameter.
    pub(crate) fn judge(
        &self,
        ends: [&Position; 2],
        (course, sense): (Course, f64),
        [first, last]: [Memory; 2],
    ) -> Option<Judged> {
        let chord = Chord { ends, course, sense };
        let [a, b] = ends;
        let Band { intol, outtol } = self.band;
        let mut memory = first;
        let mut worst = Judged { used: 0.0, deviation: 0.0, part_uv: a.part_uv };
        let mut touched = [Beside { f: 0.0, s: 0.0, contact: a.contact }; JUDGED + 2];
        let v = chord.by();
        for (i, touch) in (1..=JUDGED).zip(touched.iter_mut().skip(1)) {
            let f = i as f64 / (JUDGED + 1) as f64;
            let (p, kept) = self.between(&chord, f, [memory, last])?;
            memory = kept;
            let s = chord.beside(p.te);
            *touch = Beside { f, s, contact: p.contact };
            let apart = a.te + v * s - p.te;
            let off = apart.dot(&p.normal);
            let shift = a.shift * (1.0 - s) + b.shift * s;
            let sag = off - shift;
            let room = if sag < 0.0 { shift + intol } else { outtol - shift };
            let lateral = (apart - p.normal * off).norm() / self.lateral;
            let used = (sag.abs() / room).max(lateral);
            if used > worst.used {
                worst = Judged { used, deviation: off.abs(), part_uv: p.part_uv };
            }
        }
        touched[JUDGED + 1] = Beside { f: 1.0, s: 1.0, contact: b.contact };
        if worst.used > 1.0 || !self.part.touches {
            return Some(worst);
        }
        if let Some(over) = self.off(&chord, &touched, [first, last]) {
            return Some(Judged { used: 1.0 + over / (intol + outtol), ..worst });
        }
        Some(self.deep(a, b).unwrap_or(worst))
    }

    /// The exact position at a share of the parameter: of the two that are found from the contacts of both
    /// sides the one that the tool meets first.
    fn between(
        &self,
        chord: &Chord<'_>,
        f: f64,
        [near, far]: [Memory; 2],
    ) -> Option<(Position, Memory)> {
        let uv = chord.uv(f);
        let at = |m| self.position(uv, chord.course, chord.sense, Some(m), true).ok();
        let here = at(near);
        let jumps =
            (near.part_uv[0] - far.part_uv[0]).abs().max((near.part_uv[1] - far.part_uv[1]).abs());
        if jumps <= 0.05 && here.is_some() {
            return here;
        }
        let (Some((p, _)), Some((q, m))) = (&here, at(far)) else {
            return here.or_else(|| at(far));
        };
        let along = self.drive.place(uv, chord.course).direction?;
        if (q.te - p.te).dot(&along) < 0.0 { Some((q, m)) } else { here }
    }

    /// How much farther than allowed the tool may stand off the surface somewhere on the chord; `None` where
    /// it is proved not to.
    ///
    /// The distance of a tool that moves straight from a point is convex: over a stretch of the chord it is
    /// greatest at an end. So one contact answers for the stretch around it, and where it does not suffice a
    /// further one between is looked for.
    fn off(&self, chord: &Chord<'_>, touched: &[Beside], memories: [Memory; 2]) -> Option<f64> {
        let [a, b] = chord.ends;
        let most = self.thick() + self.band.outtol;
        let turn = trig::acos_clamped(a.ta.dot(&b.ta));
        let v = chord.by();
        let distance = |s: f64, q: Vec3, share: f64| {
            let te = a.te + v * s;
            let ta = (a.ta * (1.0 - s) + b.ta * s).try_normalize(1e-9).unwrap_or(a.ta);
            let tool = Tool { profile: self.profile, te, ta };
            tool.distance(q) + turn * share * (q - te).norm()
        };
        let mut stack: Vec<(Beside, Beside, u32)> =
            touched.windows(2).map(|w| (w[0], w[1], 0)).collect();
        while let Some((p, q, halvings)) = stack.pop() {
            let mid = 0.5 * (p.s + q.s);
            let share = 0.5 * (q.s - p.s).abs();
            let over = [(p.s, p), (mid, p), (mid, q), (q.s, q)]
                .into_iter()
                .map(|(s, at)| distance(s, at.contact, share) - most)
                .fold(f64::NEG_INFINITY, f64::max);
            if over <= 0.0 {
                continue;
            }
            if halvings >= HALVINGS {
                return Some(over);
            }
            let f = 0.5 * (p.f + q.f);
            let Some((m, _)) = self.between(chord, f, memories) else { return Some(over) };
            let m = Beside { f, s: chord.beside(m.te), contact: m.contact };
            stack.push((p, m, halvings + 1));
            stack.push((m, q, halvings + 1));
        }
        None
    }

    /// The place of the part surface that is deeper in the tool on the chord than allowed, while both ends
    /// are clear: a shorter chord mends it. What gouges already at an end is not the chord's.
    fn deep(&self, a: &Position, b: &Position) -> Option<Judged> {
        let allowed = self.band.intol - self.part.thick;
        let tree = &self.part.tree;
        let tool = |p: &Position| Tool { profile: self.profile, te: p.te, ta: p.ta };
        let found = if a.ta == b.ta {
            tree.clear(&Swept { tool: tool(a), by: b.te - a.te }, allowed)
        } else {
            tree.clear_turning((self.profile, 0.0), [(a.te, a.ta), (b.te, b.ta)], allowed)
        };
        let (Clear::No(place) | Clear::Unknown(place)) = found else { return None };
        let clear = |p: &Position| tree.clear(&tool(p), allowed) == Clear::Yes;
        let deep = -place.distance + self.part.thick;
        let part_uv = self.part.surface.global(place.patch, place.uv[0], place.uv[1]);
        let used = 1.0 + (deep / self.band.intol.max(1e-9) - 1.0).clamp(0.05, 1.0);
        (clear(a) && clear(b)).then_some(Judged { used, deviation: deep, part_uv })
    }
}
