//! A pass over an edge of the part surface, about which the tool rolls.
//!
//! Where two patches meet in an edge the normal jumps, and with it the place of a round cutter, or its axis, however short the
//! step is. Between the two places the edge itself is touched, with the normals between those of its sides.

use aptc_contact::{Tool, axis_between, bulge};
use aptc_geometry::{Vec3, trig};

use crate::area::Guide;
use crate::drive::Course;
use crate::judge::{Judged, Way, Worst};
use crate::position::{Position, tool_end};
use crate::solve::{Memory, Setup, Take};

/// The side before a joint is that of the parameter less so much, which counts as the joint.
const BEFORE: f64 = 5e-10;
/// The far side of an edge is looked for so far on, for parameters of the size of 1.
const BEYOND: f64 = 1e-9;
/// Normals and axes that differ by less do not jump.
const JUMPS: f64 = 1e-6;
/// Part of the band by which the places touched on both sides of an edge may lie apart.
const SAME: f64 = 1e-2;
/// Parts of a way that is longer than MAXDP.
const MOST: f64 = 1000.0;
/// Turns of half the size that are tried.
const FINER: u32 = 8;

impl Setup<'_> {
    /// The parameter at which a pass comes to the joint `t` of the drive: just before it where the drive has an edge there, as
    /// the joint itself belongs to the patch behind it.
    pub(crate) fn joint(&self, uv: [f64; 2], t: f64, (course, sense): (Course, f64)) -> f64 {
        let ends = t.fract() <= 0.0 && sense > 0.0;
        if ends && self.bends(uv, course, [t - BEFORE, t]) { t - BEFORE } else { t }
    }

    /// Does the drive have an edge just ahead?
    pub(crate) fn at_edge(&self, uv: [f64; 2], (course, sense): (Course, f64)) -> bool {
        let t = uv[course.index()];
        let joint = (t - t.round()).abs() <= BEYOND;
        joint && self.bends(uv, course, [t, t + sense * BEYOND * (1.0 + t.abs())])
    }

    /// Does the normal of the drive jump between two parameters?
    fn bends(&self, uv: [f64; 2], course: Course, [a, b]: [f64; 2]) -> bool {
        let k = course.index();
        let Guide::Surface(s) = &self.drive.guide else { return false };
        let last = s.spans()[k];
        let normal = |t: f64| {
            let mut uv = uv;
            uv[k] = t;
            s.normal_at(uv[0], uv[1])
        };
        let inside = |t: f64| t > 0.0 && t < last;
        let jump = || Some((normal(a)? - normal(b)?).norm());
        inside(a) && inside(b) && jump().is_some_and(|jump| jump > JUMPS)
    }

    /// Positions by which the tool rolls over the edge just ahead of `here`, the last one on its far side at most at the
    /// parameter `to`; `None` where there is none, or the tool does not come over it within the band.
    pub(crate) fn roll(
        &self,
        here: &Position,
        to: f64,
        (course, sense): (Course, f64),
        memory: Memory,
    ) -> Option<(Vec<Position>, Memory)> {
        let k = course.index();
        let mut uv = here.drive_uv;
        let ahead = uv[k] + sense * BEYOND * (1.0 + uv[k].abs());
        uv[k] = if (to - ahead) * sense > 0.0 { ahead } else { to };
        let (last, kept) = self.position(uv, course, sense, Some(memory), Take::Band).ok()?;
        let band = self.band.intol + self.band.outtol;
        let jumps = (last.normal - here.normal).norm().max((last.ta - here.ta).norm()) > JUMPS;
        if !jumps || (last.contact - here.contact).norm() > SAME * band {
            return None;
        }
        let forward = self.drive.place(uv, course).along * sense;
        let mut parts = 1.0;
        for _ in 0..FINER {
            let mut all = Vec::new();
            let mut i = 1.0;
            while i < parts {
                all.push(self.on_edge(here, &last, i / parts, forward));
                i += 1.0;
            }
            all.push(last);
            let before = std::iter::once(here).chain(&all);
            if before.zip(&all).all(|(a, b)| self.rolls([a, b])) {
                return Some((self.cut(here, all), kept));
            }
            parts *= 2.0;
        }
        None
    }

    /// Positions of which none is farther from the one before than MAXDP: across a flat bottom the tool goes straight on.
    fn cut(&self, here: &Position, all: Vec<Position>) -> Vec<Position> {
        let mut out = Vec::with_capacity(all.len());
        let mut a = *here;
        for b in all {
            let n = ((b.te - a.te).norm() / self.maxdp).ceil().min(MOST);
            let mut i = 1.0;
            while i < n {
                let (te, ta) = (a.te + (b.te - a.te) * (i / n), axis_between(a.ta, b.ta, i / n));
                out.push(Position { te, ta, ..b });
                i += 1.0;
            }
            out.push(b);
            a = b;
        }
        out
    }

    /// The tool at a share of the turn between two positions that touch the same edge.
    fn on_edge(&self, a: &Position, b: &Position, share: f64, forward: Vec3) -> Position {
        let normal = axis_between(a.normal, b.normal, share);
        let ta = axis_between(a.ta, b.ta, share);
        let (contact, shift) = (a.contact, self.highest());
        let te = if self.part.touches {
            let thick = self.thick() + shift;
            let chosen = self.chosen.tool_end(self.profile, ta, contact, normal, thick, -forward);
            chosen.unwrap_or_else(|| tool_end(self.profile, ta, contact, normal, thick, -forward))
        } else {
            contact + normal * shift
        };
        Position { te, ta, normal, shift, contact, ..*b }
    }

    /// Does the tool keep to the band on its way between two places that touch the same edge?
    fn rolls(&self, [a, b]: [&Position; 2]) -> bool {
        let edge = a.contact;
        if !self.part.touches {
            return (a.te - edge).norm().max((b.te - edge).norm())
                <= self.band.outtol.max(self.band.intol);
        }
        let distance =
            |p: &Position| Tool { profile: self.profile, te: p.te, ta: p.ta }.distance(edge);
        let far = (edge - a.te).norm().max((edge - b.te).norm());
        let turn = trig::angle_between(a.ta, b.ta);
        let most = distance(a).max(distance(b)) + bulge(turn, far, (b.te - a.te).norm());
        if most > self.thick() + self.band.outtol {
            return false;
        }
        let worst = Worst::UNKNOWN;
        let judged = Judged { used: 0.0, worst, part_uv: a.part_uv, way: Way::Unknown };
        self.deep((a, false), b, judged).way != Way::Unknown
    }
}
