//! Arcs and helices in place of runs of short lines: what waits, and what becomes of it.

use std::collections::VecDeque;

use aptc_cldata::{Arc, Course, Kind, MotionKind, Position, Record};
use aptc_diagnostics::{Origin, codes};
use aptc_geometry::{Circle, Vec3};

use crate::fit::{Found, Limits, longest};
use crate::machine::Dialect;
use crate::post::{Post, trimmed};

/// Cut vectors that wait at most: so long can an arc become.
const MOST_WAITING: usize = 2048;

/// Steps of the output by which rounding may move an arc that replaces lines.
pub(crate) const ROUNDING: f64 = 3.0;

/// Cuts that wait for the end of their run.
#[derive(Debug, Default)]
pub(crate) struct Waiting {
    /// Positions in units of the CL data with the record from which each comes.
    cuts: VecDeque<(Position, Origin, MotionKind)>,
    /// Lines that became arcs, and how many arcs.
    pub(crate) lines: u64,
    pub(crate) arcs: u64,
    /// Greatest distance between lines and arcs, in millimetres.
    deviation_mm: f64,
}

impl Waiting {
    pub(crate) fn is_empty(&self) -> bool {
        self.cuts.is_empty()
    }
}

impl Post {
    /// Does the record join the run? Cuts along lines with a fixed tool axis do.
    pub(crate) fn waits(&mut self, record: &Record) -> bool {
        let Kind::Motion(m) = &record.kind else { return false };
        let st = &self.st;
        let plain = m.kind != MotionKind::From
            && m.arc.is_none()
            && !st.rapid
            && st.cycle.is_none()
            && st.thread.is_none()
            && !st.ended
            && st.held.is_empty()
            && self.blocks.with_motion.is_none()
            && m.points.iter().all(|p| (p.ta - st.ta).norm() < 1e-12);
        let ready = st.started && st.pos.is_some() && !(st.away || st.stands_still());
        if !plain || !ready {
            return false;
        }
        let cuts = m.points.iter().map(|p| (*p, record.origin.clone(), m.kind));
        self.waiting.cuts.extend(cuts);
        true
    }

    /// Writes what waits: all of it, or what no later cut can change.
    pub(crate) fn release(&mut self, all: bool) {
        if self.waiting.is_empty() || (!all && self.waiting.cuts.len() < MOST_WAITING) {
            return;
        }
        let Some((limits, arcs)) = self.fit_limits() else { return self.release_lines() };
        let (shift, scale) = (self.st.shift, self.st.scale);
        let mut points: Vec<Vec3> = self.st.pos.map(|p| (p - shift) / scale).into_iter().collect();
        points.extend(self.waiting.cuts.iter().map(|c| c.0.te));
        let mut at = 0;
        while at + 1 < points.len() {
            let found = if arcs { longest(&points[at..], &limits) } else { Found::Lines(1) };
            let f = match found {
                Found::Arc(f) => f,
                Found::Lines(n) => {
                    for _ in 0..n {
                        self.release_line();
                    }
                    at += n;
                    continue;
                }
            };
            if !all && at > 0 && at + f.lines + 1 == points.len() {
                // It may become longer yet.
                return;
            }
            let circle = Circle { center: f.center, axis: f.axis, radius: f.radius };
            let arc = Arc { circle, course: Course::Sweep(f.sweep.to_degrees()) };
            let Some((end, origin, kind)) = self.waiting.cuts.get(f.lines - 1).cloned() else {
                return;
            };
            let before = self.blocks.lines;
            self.annotate(&origin);
            self.st.fitted = true;
            let done = self.arc(&arc, &[end], &origin);
            self.st.fitted = false;
            if !done {
                for _ in 0..f.lines {
                    self.release_line();
                }
                at += f.lines;
                continue;
            }
            self.note_cut(before, &origin, kind);
            self.waiting.cuts.drain(..f.lines);
            at += f.lines;
            let w = &mut self.waiting;
            w.lines += u64::try_from(f.lines).unwrap_or(0);
            w.arcs += 1;
            w.deviation_mm = w.deviation_mm.max(f.deviation * self.st.units.mm());
        }
    }

    fn release_lines(&mut self) {
        while !self.waiting.is_empty() {
            self.release_line();
        }
    }

    /// The first cut that waits, as a line.
    fn release_line(&mut self) {
        let Some((p, origin, kind)) = self.waiting.cuts.pop_front() else { return };
        let before = self.blocks.lines;
        self.annotate(&origin);
        self.go(&p, false, &origin);
        self.note_cut(before, &origin, kind);
    }

    /// What arcs must keep to, in units of the CL data. Rounding takes a part of the tolerance; where it leaves
    /// nothing there are no arcs.
    fn fit_limits(&self) -> Option<(Limits, bool)> {
        let arcs = self.machine.arcs.as_ref()?;
        let mm = self.st.units.mm();
        let resolution_mm = self.blocks.number(b'X').resolution() * self.st.out_mm();
        let tolerance = (self.st.fit_mm? - ROUNDING * resolution_mm) / mm;
        let limits = Limits {
            tolerance,
            flat: 0.01 * resolution_mm / mm,
            radius: [arcs.min_radius / mm, arcs.max_radius / mm],
            planes: arcs.planes.clone(),
            // Heidenhain's helix has an angle and no end: from one to the next rounding would add up.
            helix: arcs.helix && self.machine.dialect != Dialect::Heidenhain,
        };
        Some((limits, tolerance > 0.0))
    }

    /// Tells by how much the path was changed, and what that makes of the tolerance of the cut vectors.
    pub(crate) fn tell_fitted(&mut self) {
        let w = &self.waiting;
        let (lines, arcs, deviation) = (w.lines, w.arcs, w.deviation_mm);
        let Some(fit) = self.st.fit_mm.or(self.st.last_fit_mm) else { return };
        if arcs == 0 {
            return;
        }
        let out = self.st.out_mm();
        let in_all = fit / out + self.st.band();
        let message = format!(
            "{lines} lines became {arcs} arcs, at most {} away from them and {} with rounding; with the \
             tolerance of the cut vectors the path is within {} in all",
            trimmed(deviation / out, 5),
            trimmed(fit / out, 5),
            trimmed(in_all, 5)
        );
        self.summary.notes.push(message.clone());
        self.note(codes::ARCS_FITTED, &Origin::default(), message, "");
    }
}

/// Records between cuts that ask for nothing: a run goes on over them.
pub(crate) fn asks_nothing(kind: &Kind) -> bool {
    matches!(
        kind,
        Kind::Csys(_) | Kind::Output(_) | Kind::Edit(_) | Kind::Clprnt(_) | Kind::Comment(_)
    )
}
