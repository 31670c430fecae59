//! A chord between two positions held against the part surface.

use aptc_contact::{Clear, Swept, Tool, axis_between, bulge};
use aptc_geometry::{Vec3, trig};

use crate::drive::Course;
use crate::position::Position;
use crate::settings::Band;
use crate::solve::{LOOKS, Memory, Setup, Take};

/// Places between the ends at which a chord is judged first, the most telling before the others.
const JUDGED: [usize; 3] = [2, 1, 3];
/// The same where the tool end is led on the part surface, and how much of the room the sag may take at them: between them it is
/// no more by a parabola.
const LED: [usize; 7] = [4, 2, 6, 1, 3, 5, 7];
const KEEPS: f64 = 0.97;
/// Halvings of the stretch that one contact answers for: of a sharp edge that touches but little in the band very short ones.
const HALVINGS: u32 = 11;

/// What a chord does to the tolerance.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Judged {
    /// Part of the tolerance that is used; above 1 too much.
    pub(crate) used: f64,
    /// What uses most of it, at the worst place.
    pub(crate) worst: Worst,
    /// The place on the part surface.
    pub(crate) part_uv: [f64; 2],
    /// Does the tool keep out of the part surface on the way?
    pub(crate) way: Way,
}

/// A length of a chord with what is allowed of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Worst {
    pub(crate) what: Limit,
    pub(crate) much: f64,
    pub(crate) allowed: f64,
}

/// What limits a chord.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Limit {
    /// How deep the cutter is in the part surface: INTOL.
    Deep,
    /// How far it stands off it: OUTTOL.
    Off,
    /// How far it leaves its path sideways.
    Beside,
    /// How far the chord of a tool end that is led leaves its path towards the surface or away from it.
    Sags,
    /// Nothing is known of it: between its ends no place of the tool is found.
    Unknown,
}

impl Worst {
    pub(crate) const UNKNOWN: Self = Self { what: Limit::Unknown, much: 0.0, allowed: 0.0 };
}

/// What is known of a tool that goes along a chord.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Way {
    /// Not looked for.
    Unknown,
    /// Proved to be nowhere deeper in the part surface than INTOL.
    Clear,
    /// One of the ends is deeper.
    End,
}

/// A contact with the share of the chord beside it.
#[derive(Clone, Copy)]
struct Beside {
    /// Share of the drive's parameter.
    f: f64,
    /// Share of the chord.
    s: f64,
    contact: Vec3,
    part_uv: [f64; 2],
}

/// The chord that is judged.
struct Chord<'a> {
    ends: [&'a Position; 2],
    memories: [Memory; 2],
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
        self.share(te, self.by())
    }

    /// The same seen along the normal there: where the ends stand at different heights in the band a short chord is far
    /// steeper than its path, and what is square to the one is ahead or behind on the other.
    fn under(&self, te: Vec3, normal: Vec3) -> f64 {
        let v = self.by();
        self.share(te, v - normal * v.dot(&normal))
    }

    /// The share of the chord at which it has come as far in a direction as a tool end.
    fn share(&self, te: Vec3, along: Vec3) -> f64 {
        let whole = self.by().dot(&along);
        if whole > 0.0 { ((te - self.ends[0].te).dot(&along) / whole).clamp(0.0, 1.0) } else { 0.0 }
    }
}

impl Setup<'_> {
    /// How much of the tolerance the chord between two positions uses.
    ///
    /// At places between its ends it is compared with the exact positions there, sideways also. Then bounds
    /// for the whole of it: how far the cutter stands off places of the surface, and how deep it is in the
    /// part surface, which is proved. `clear` says that the first position is proved to be.
    ///
    /// APT: `GCHK` with `MIDPNT`, `MIDKUR`, `DEVCAL` and `XTPCAL`, which judged the middle of the parameter.
    pub(crate) fn judge(
        &self,
        ends: [&Position; 2],
        (course, sense): (Course, f64),
        memories: [Memory; 2],
        clear: bool,
    ) -> Option<Judged> {
        let chord = Chord { ends, memories, course, sense };
        let [a, b] = ends;
        let Band { intol, outtol } = self.band;
        let mut worst =
            Judged { used: 0.0, worst: Worst::UNKNOWN, part_uv: a.part_uv, way: Way::Unknown };
        let start = Beside { f: 0.0, s: 0.0, contact: a.contact, part_uv: a.part_uv };
        let end = Beside { f: 1.0, s: 1.0, contact: b.contact, part_uv: b.part_uv };
        let mut touched = [start; JUDGED.len() + 2];
        touched[JUDGED.len() + 1] = end;
        let v = chord.by();
        // Where the tool end is led nothing else bounds the chord.
        let (judged, parts, keeps): (&[usize], _, _) = if self.part.touches {
            (&JUDGED, JUDGED.len() + 1, 1.0)
        } else {
            (&LED, LED.len() + 1, KEEPS)
        };
        for &i in judged {
            let f = i as f64 / parts as f64;
            let p = self.between(&chord, f)?;
            let at = |s: f64| {
                let apart = a.te + v * s - p.te;
                let off = apart.dot(&p.normal);
                let shift = a.shift * (1.0 - s) + b.shift * s;
                let sag = off - shift;
                let room = if sag < 0.0 { shift + intol } else { outtol - shift };
                let beside = (apart - p.normal * off).norm();
                let lateral = beside / self.lateral;
                let used = (sag.abs() / (keeps * room)).max(lateral);
                (used, (s, off, sag, room, beside, lateral))
            };
            let mut near = at(chord.beside(p.te));
            if near.0 > 1.0 {
                let under = at(chord.under(p.te, p.normal));
                near = if under.0 <= 1.0 { under } else { near };
            }
            let (used, (s, off, sag, room, beside, lateral)) = near;
            if self.part.touches {
                touched[i] = Beside { f, s, contact: p.contact, part_uv: p.part_uv };
            }
            if used > worst.used {
                let (what, much, allowed) = if lateral >= used {
                    (Limit::Beside, beside, self.lateral)
                } else if !self.part.touches {
                    (Limit::Sags, sag.abs(), keeps * room)
                } else if sag < 0.0 {
                    (Limit::Deep, -off, intol)
                } else {
                    (Limit::Off, off, outtol)
                };
                let most = Worst { what, much, allowed };
                worst = Judged { used, worst: most, part_uv: p.part_uv, ..worst };
            }
            if used > 1.0 {
                return Some(worst);
            }
        }
        if !self.part.touches {
            return Some(worst);
        }
        if let Some(over) = self.off(&chord, &touched) {
            let most = Worst { what: Limit::Off, much: outtol + over, allowed: outtol };
            return Some(Judged { used: 1.0 + over / (intol + outtol), worst: most, ..worst });
        }
        Some(self.deep((a, clear), b, worst))
    }

    /// The exact position at a share of the parameter. Where the contact jumps from one end to the other, it is
    /// the one that the tool meets first of those that are found from the contacts of both.
    fn between(&self, chord: &Chord<'_>, f: f64) -> Option<Position> {
        let uv = chord.uv(f);
        let at = |m| {
            let found = self.position(uv, chord.course, chord.sense, Some(m), Take::Nothing);
            found.ok().map(|(p, _)| p)
        };
        let [a, b] = chord.ends;
        let [near, far] = chord.memories;
        let part_uv = mixed(near.part_uv, far.part_uv, f);
        // A contact beside a tool that goes on steadily goes on with it.
        let most = 2.0 * chord.by().norm();
        if (b.contact - a.contact).norm() <= most
            && let Some(p) = at(near.at(part_uv))
            && (p.contact - a.contact).norm() <= most
        {
            return Some(p);
        }
        let (Some(p), Some(q)) = (at(near), at(far)) else { return at(near).or_else(|| at(far)) };
        let along = self.drive.place(uv, chord.course).direction?;
        Some(if (q.te - p.te).dot(&along) < 0.0 { q } else { p })
    }

    /// How much farther than allowed the tool may stand off the surface somewhere on the chord; `None` where
    /// it is proved not to.
    ///
    /// The distance of a tool that moves straight from a point is convex: over a stretch of the chord it is
    /// greatest at an end, but for what a turn adds. So one place of the surface answers for the stretch around it, and where it does not
    /// suffice a further one is taken between: the place between two contacts, which is as good as a contact
    /// unless the contact jumps there.
    fn off(&self, chord: &Chord<'_>, touched: &[Beside]) -> Option<f64> {
        let [a, b] = chord.ends;
        let most = self.thick() + self.band.outtol;
        let turn = trig::angle_between(a.ta, b.ta);
        let v = chord.by();
        let distance = |s: f64, q: Vec3| {
            let (te, ta) = (a.te + v * s, axis_between(a.ta, b.ta, s));
            Tool { profile: self.profile, te, ta }.distance(q)
        };
        let over = |from: f64, to: f64, q: Vec3| {
            let far = [from, to].map(|s| (q - a.te - v * s).norm());
            let share = (to - from).abs();
            let more = bulge(turn * share, far[0].max(far[1]), v.norm() * share);
            distance(from, q).max(distance(to, q)) + more - most
        };
        let mut stack: Vec<(Beside, Beside, u32)> =
            touched.windows(2).map(|w| (w[0], w[1], 0)).collect();
        while let Some((p, q, halvings)) = stack.pop() {
            let mid = 0.5 * (p.s + q.s);
            let share = 0.5 * (q.s - p.s).abs();
            let both = over(p.s, mid, p.contact).max(over(mid, q.s, q.contact));
            // Beside a sharp edge that leaves a place on one side at once, that on the other side answers for all of it.
            let over = both.min(over(p.s, q.s, p.contact)).min(over(p.s, q.s, q.contact));
            if over <= 0.0 {
                continue;
            }
            if halvings >= HALVINGS {
                return Some(over);
            }
            let f = 0.5 * (p.f + q.f);
            let m = if (q.contact - p.contact).norm() <= 4.0 * share * v.norm() {
                let part_uv = mixed(p.part_uv, q.part_uv, 0.5);
                let contact = self.part.surface.at(part_uv[0], part_uv[1]).point;
                Beside { f, s: mid, contact, part_uv }
            } else {
                let Some(m) = self.between(chord, f) else { return Some(over) };
                let s = chord.beside(m.te).clamp(p.s.min(q.s), p.s.max(q.s));
                Beside { f, s, contact: m.contact, part_uv: m.part_uv }
            };
            stack.push((p, m, halvings + 1));
            stack.push((m, q, halvings + 1));
        }
        None
    }

    /// What is judged, with what is known of the way: deeper in the part surface than allowed it is too long, unless
    /// the tool is so at one of its ends already; the first may be known not to be.
    pub(crate) fn deep(
        &self,
        (a, known): (&Position, bool),
        b: &Position,
        judged: Judged,
    ) -> Judged {
        let allowed = self.band.intol - self.part.thick;
        let tree = &self.part.tree;
        let tool = |p: &Position| Tool { profile: self.profile, te: p.te, ta: p.ta };
        let found = if a.ta == b.ta {
            tree.clear_by(&Swept { tool: tool(a), by: b.te - a.te }, allowed, LOOKS)
        } else {
            tree.clear_turning((self.profile, 0.0), [(a.te, a.ta), (b.te, b.ta)], allowed)
        };
        let (Clear::No(place) | Clear::Unknown(place)) = found else {
            return Judged { way: Way::Clear, ..judged };
        };
        let clear = |p: &Position| tree.clear_by(&tool(p), allowed, LOOKS) == Clear::Yes;
        if !clear(b) || !known && !clear(a) {
            return Judged { way: Way::End, ..judged };
        }
        let deep = -place.distance + self.part.thick;
        let part_uv = self.part.surface.global(place.patch, place.uv[0], place.uv[1]);
        let used = 1.0 + (deep / self.band.intol.max(1e-9) - 1.0).clamp(0.05, 1.0);
        let worst = Worst { what: Limit::Deep, much: deep, allowed: self.band.intol };
        Judged { used, worst, part_uv, way: Way::Unknown }
    }
}

/// Parameters at a share of the way from one place to another.
fn mixed(a: [f64; 2], b: [f64; 2], f: f64) -> [f64; 2] {
    [0, 1].map(|k| a[k] + (b[k] - a[k]) * f)
}
