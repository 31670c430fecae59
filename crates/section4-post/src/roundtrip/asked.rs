//! What the CL data asks for, put in the queue record by record.

use aptc_cldata::{Arg, Course, Kind, Motion, MotionKind, Position, Record};
use aptc_geometry::{Circle, Plane, Vec3, trig};

use super::{Checker, Expect, Hole};
use crate::args::Statement;
use crate::drill::DrillCycle;
use crate::index::{Index, wanted};
use crate::threading::{passes, stops};
use crate::words::arcslp;

impl Checker {
    /// Takes what a record asks for.
    pub(crate) fn record(&mut self, record: &Record, clearance_mm: Option<Plane>) {
        self.clearance = clearance_mm.map(|p| {
            let moved = Plane { n: p.n, d: p.d + p.n.dot(&self.shift) };
            self.index.as_ref().map_or(moved, |i| i.plane(&moved))
        });
        match &record.kind {
            Kind::Units(u) => self.units = *u,
            Kind::Multax(on) => self.multax = *on,
            Kind::Motion(m) => self.motion(m),
            Kind::Intol(t) => {
                self.intol = t.iter().fold(0.0, |a: f64, b| a.max(b.abs())) * self.units.mm();
            }
            Kind::Outtol(t) => {
                self.band = Some(t.iter().fold(0.0, |a: f64, b| a.max(b.abs())) * self.units.mm());
            }
            Kind::Text { word, .. } if word == "INSERT" => self.queue.push_back(Expect::Free),
            Kind::Post { word, args } => {
                let s = Statement { word, args, origin: &record.origin };
                self.word(&s);
            }
            _ => {}
        }
    }

    fn word(&mut self, s: &Statement<'_>) {
        match s.word {
            "RAPID" => self.rapid = true,
            "INSERT" | "PREFUN" => self.queue.push_back(Expect::Free),
            "CYCLE" => match s.word(0) {
                Some("OFF" | "NOMORE") => self.cycle = None,
                Some("ON") => {
                    self.cycle =
                        crate::words::cycle::again(self.last_cycle.as_ref(), s).ok().flatten();
                    self.last_cycle.clone_from(&self.cycle);
                }
                Some("INIT" | "CLEAR") => {}
                _ => {
                    self.cycle = crate::words::cycle::parse(s).ok();
                    self.last_cycle.clone_from(&self.cycle);
                }
            },
            "CLRSRF" if matches!(s.word(0), Some("NOW" | "START")) => self.clear_to_plane(),
            "RETRCT" if self.machine.program.retract.is_empty() => self.clear_to_plane(),
            "RETRCT" => self.clear(),
            "GOHOME" => {
                self.rapid = false;
                self.planned = None;
                self.queue.push_back(Expect::Home);
            }
            "ARCSLP" => {
                if let Some(fit) = arcslp::asked(s, &self.machine, self.units.mm()) {
                    self.fit = fit;
                }
            }
            "ROTABL" | "ROTHED" => self.turn(s),
            "MODE" if self.lathe.milling.is_some() => {
                self.planned = None;
                self.queue.push_back(Expect::Mill(s.word(0) == Some("MILL")));
            }
            "LINTOL" => {
                if let Some(Arg::Number(t)) = s.args.first() {
                    self.lintol = t * self.units.mm();
                } else if s.word(0) == Some("ON") {
                    self.lintol = self.machine.multiaxis.lintol;
                }
            }
            "TRANS" | "ORIGIN" => {
                let mut v = [0.0; 3];
                for (slot, i) in v.iter_mut().zip(0..) {
                    *slot = s.number(i).unwrap_or(0.0);
                }
                let sign = if s.word == "TRANS" { 1.0 } else { -1.0 };
                self.shift = Vec3::from(v) * (sign * self.units.mm());
            }
            "LOADTL" | "LOAD" | "TOOLNO" => {
                let said = match s.word {
                    "TOOLNO" => s.after(&["LENGTH"]),
                    word => crate::words::loaded(s, usize::from(word == "LOAD")).length,
                };
                if let Some(l) = said {
                    self.tool_length = Some(l * self.units.mm());
                }
                if s.word != "TOOLNO" {
                    self.queue.push_back(Expect::Tool { length: self.tool_length });
                }
            }
            _ => {}
        }
    }

    /// The table or head turns while the tool is away.
    fn turn(&mut self, s: &Statement<'_>) {
        if self.multax || self.machine.rotary.is_empty() {
            return;
        }
        let Ok(wanted) = wanted(s, &self.machine, self.indexed) else { return };
        self.indexed[wanted.axis] = wanted.angle;
        let turned = self.indexed.iter().any(|a| (a / 360.0 - (a / 360.0).round()).abs() > 1e-12);
        self.index = turned.then(|| Index::new(&self.machine, self.indexed));
        self.rapid = false;
        self.planned = None;
        self.queue.push_back(Expect::Home);
    }

    /// The passes of a thread.
    fn thread(&mut self, cycle: &DrillCycle, p: &Position) {
        let mm = self.units.mm();
        let (end, ta) = self.seen(p.te, p.ta);
        let depths = passes(cycle.depth * mm, cycle.step.unwrap_or(0.0) * mm);
        let clear = cycle.clear.unwrap_or(0.0) * mm;
        let Some((depths, (from, _))) = depths.zip(self.planned) else { return };
        for (te, i) in stops(from, end, clear, &depths).unwrap_or_default().into_iter().zip(0_u32..)
        {
            let rapid = i % 4 != 1;
            self.queue.push_back(Expect::Point { te, ta, rapid, via: false, round: false });
            self.planned = Some((te, ta));
        }
    }

    fn seen_circle(&self, circle: &Circle, ta: Vec3) -> (Vec3, Vec3) {
        let (center, _) = self.seen(circle.center, ta);
        let (tip, _) = self.seen(circle.center + circle.axis, ta);
        (center, (tip - center).normalize())
    }

    /// CLRSRF/NOW: a rapid motion to the plane, when the tool is not beyond it.
    fn clear_to_plane(&mut self) {
        let Some((plane, (te, ta))) = self.clearance.zip(self.planned) else { return };
        let slope = plane.n.dot(&ta);
        if slope.abs() < 1e-6 {
            return;
        }
        self.rapid = false;
        let way = (plane.d - plane.n.dot(&te)) / slope;
        if way > 0.0 {
            let te = te + ta * way;
            self.queue.push_back(Expect::Point { te, ta, rapid: true, via: false, round: false });
            self.planned = Some((te, ta));
        }
    }

    fn clear(&mut self) {
        self.rapid = false;
        self.queue.push_back(Expect::Clear);
    }

    fn motion(&mut self, m: &Motion) {
        let Some(last) = m.points.last() else { return };
        if m.kind == MotionKind::From {
            self.rapid = false;
            let (te, ta) = self.seen(last.te, last.ta);
            self.planned = Some((te, ta));
            self.queue.push_back(Expect::From { te, ta });
            return;
        }
        let rapid = std::mem::take(&mut self.rapid);
        if let Some(cycle) = &self.cycle
            && m.kind == MotionKind::Goto
            && !rapid
            && m.arc.is_none()
        {
            let cycle = cycle.clone();
            if cycle.kind == "THREAD" && !self.machine.turning.thread.is_empty() {
                m.points.iter().for_each(|p| self.thread(&cycle, p));
                return;
            }
            for p in &m.points {
                let (te, ta) = self.seen(p.te, p.ta);
                if let Some(hole) = self.hole(&cycle, te, ta) {
                    self.planned = Some((hole.at + hole.ta * hole.retract, hole.ta));
                    self.queue.push_back(Expect::Hole(hole));
                }
            }
            return;
        }
        if let Some(arc) = &m.arc
            && let Course::Sweep(degrees) = arc.course
            && let Some((start, _)) = self.planned
        {
            // Points of the arc, none farther than 15 degrees from the next, and the lines between them within half
            // the band of it: so that lines in its place are held against it too.
            let (c, axis) = self.seen_circle(&arc.circle, last.ta);
            let spoke = start - c;
            let (along, radial) = (spoke.dot(&axis), spoke - axis * spoke.dot(&axis));
            let side = axis.cross(&radial);
            let (end, ta) = self.seen(last.te, last.ta);
            let rise = (end - start).dot(&axis);
            let part = (1.0 - 0.5 * self.band() / radial.norm()).max(-1.0);
            let apart = (2.0 * trig::acos_clamped(part)).to_degrees().clamp(1e-3, 15.0);
            #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "bounded")]
            let n = (degrees.abs() / apart).ceil().clamp(1.0, 100_000.0) as u32;
            let round = |part: f64| {
                let (s, co) = trig::sin_cos(degrees.to_radians() * part);
                c + axis * (along + rise * part) + radial * co + side * s
            };
            // An end beside the circle is come to gradually.
            let off = end - round(1.0);
            for i in 1..n {
                let part = f64::from(i) / f64::from(n);
                let te = round(part) + off * part;
                self.queue.push_back(Expect::Point { te, ta, rapid, via: true, round: true });
            }
        }
        for p in &m.points {
            let ((te, ta), round) = (self.seen(p.te, p.ta), m.arc.is_some());
            self.queue.push_back(Expect::Point { te, ta, rapid, via: false, round });
        }
        self.planned = Some(self.seen(last.te, last.ta));
    }

    fn hole(&self, cycle: &DrillCycle, at: Vec3, ta: Vec3) -> Option<Hole> {
        let mm = self.units.mm();
        let plane = self.clearance.and_then(|p| {
            let slope = p.n.dot(&ta);
            (slope.abs() > 1e-6).then(|| (p.d - p.n.dot(&at)) / slope)
        });
        let clearance = cycle.clear.map(|c| c * mm).or(plane.filter(|h| *h > 0.0))?;
        let mut retract = cycle.retract.map_or(clearance, |r| r * mm);
        if cycle.retract_auto
            && let Some((p, _)) = self.planned
        {
            retract = retract.max((p - at).dot(&ta));
        }
        let bottom = -cycle.depth * mm;
        let (retract, plane) = (retract.max(clearance), self.clearance);
        Some(Hole { at, ta, bottom, clearance, retract, deepest: f64::MAX, plane })
    }
}
