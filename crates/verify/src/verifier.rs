//! Judges a stream of CL records.

mod milling;

use std::sync::Arc;

use aptc_cldata::{Arg, Control, Kind, Motion, MotionKind, Position, Record};
use aptc_diagnostics::{Diagnostic, Origin, codes};
use aptc_geometry::{Cutter, Form, Plane, Profile, Sculptured};

use crate::certificate::{Certificate, Fault, StatementProof, length};
use crate::free::{Free, Rapid};
use crate::judged::Judged;
use crate::sheet::Sheet;

pub(crate) use milling::ways;

/// Allowance for rounding as a share of the size of the scene: what is proved is proved of a band wider by
/// this. Positions are solved to 1e-12 of the scene.
const ROUNDING: f64 = 1e-11;
/// The same for files of others, which were calculated with fewer digits or written with fewer.
const FOREIGN_ROUNDING: f64 = 1e-7;

/// How many vectors are judged.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Effort {
    /// Every vector.
    Full,
    /// Every n-th vector of a statement, its first and its last.
    Every(u64),
}

/// Judges CL records one after the other.
#[derive(Debug)]
pub struct Verifier {
    effort: Effort,
    profile: Option<Profile>,
    last: Option<Position>,
    /// The motion along surfaces that came last; the next record may go on with it.
    open: Option<Open>,
    /// RAPID was said for the next motion.
    rapid: bool,
    free: Free,
    /// Sculptured surfaces that are prepared.
    sheets: Vec<(Arc<Sculptured>, Arc<Sheet>)>,
    certificate: Certificate,
    diagnostics: Vec<Diagnostic>,
}

/// A motion along surfaces before it is judged.
#[derive(Debug)]
struct Open {
    control: Arc<Control>,
    startup: bool,
    origin: Origin,
    start: Option<Position>,
    points: Vec<Position>,
    profile: Profile,
}

impl Verifier {
    /// A verifier at the beginning of a part program.
    pub fn new(effort: Effort) -> Self {
        Self::rounded(effort, ROUNDING)
    }

    /// The same for positions of others, which have fewer digits.
    pub fn foreign(effort: Effort) -> Self {
        Self::rounded(effort, FOREIGN_ROUNDING)
    }

    fn rounded(effort: Effort, rounding: f64) -> Self {
        let certificate = Certificate { rounding, ..Certificate::default() };
        Self {
            effort,
            profile: None,
            last: None,
            open: None,
            rapid: false,
            free: Free::default(),
            sheets: Vec::new(),
            certificate,
            diagnostics: Vec::new(),
        }
    }

    /// Takes the next record of Section 2, before editing: TRACUT and COPY move the path off the surfaces.
    pub fn push(&mut self, record: &Record) {
        match &record.kind {
            Kind::Cutter(cutter) => {
                self.close();
                self.profile = profile(cutter);
            }
            Kind::Post { word, args } => match word.as_str() {
                "RAPID" => self.rapid = true,
                "CLRSRF" if now(args) => self.last = self.last.map(|p| self.free.cleared(&p)),
                "CLRSRF" => self.free.set_clearance(clearance(args)),
                // The machine takes the tool away, or a cycle leaves it above the hole.
                "RETRCT" | "GOHOME" | "LOADTL" | "LOAD" | "TURRET" | "CYCLE" => self.last = None,
                _ => {}
            },
            Kind::Motion(motion) => {
                self.motion(motion, &record.origin);
                self.last = motion.points.last().copied().or(self.last);
            }
            _ => {}
        }
    }

    /// The certificate, and a message for each statement that is not proved.
    pub fn finish(mut self) -> (Certificate, Vec<Diagnostic>) {
        self.close();
        (self.certificate, self.diagnostics)
    }

    fn motion(&mut self, motion: &Motion, origin: &Origin) {
        if motion.kind == MotionKind::From {
            // The tool is there already: RAPID before FROM moves nothing.
            self.rapid = false;
            self.close_unless(None);
            return;
        }
        let rapid = std::mem::take(&mut self.rapid);
        let Some(profile) = self.profile.or_else(|| profile(&Cutter::mill(0.0, 0.0, 0.0))) else {
            return;
        };
        let startup = motion.kind == MotionKind::Startup;
        let control = match (&motion.control, motion.kind) {
            (Some(control), MotionKind::Startup | MotionKind::Continuous) => Some(control),
            _ => None,
        };
        self.close_unless(control);
        if control.is_none() && motion.kind == MotionKind::Continuous {
            self.without_proof(motion, origin);
        } else if control.is_none() {
            self.certificate.free += motion.points.len() as u64;
        }
        if rapid && (control.is_none() || startup) {
            let points = self.last.iter().chain(&motion.points).copied().collect();
            let pad = self.pad(&motion.points, &profile);
            let rapid = Rapid { origin: origin.clone(), points, profile, pad };
            self.free.rapid(rapid, &mut self.diagnostics);
        }
        let Some(control) = control else { return };
        match &mut self.open {
            Some(open) => open.points.extend_from_slice(&motion.points),
            None => {
                // How the tool comes to a region is not its promise.
                let joined = control.milling.as_ref().is_none_or(|m| m.joined && !rapid);
                let start = self.last.filter(|_| joined);
                self.open = Some(Open {
                    control: Arc::clone(control),
                    startup,
                    origin: origin.clone(),
                    start,
                    points: motion.points.clone(),
                    profile,
                });
            }
        }
    }

    /// Cut vectors along surfaces that the records do not tell, as those of regional milling: nothing is known
    /// of them, and that is said once a statement.
    fn without_proof(&mut self, motion: &Motion, origin: &Origin) {
        let n = motion.points.len() as u64;
        self.certificate.undecided += n;
        if let Some(last) = self.certificate.statements.last_mut()
            && last.origin == *origin
            && last.method == NO_METHOD
        {
            last.vectors += n;
            return;
        }
        let fault = motion.points.first().map(|p| Fault {
            refuted: false,
            surface: "the surfaces of regional milling".to_owned(),
            vector: 1,
            te: p.te.into(),
            depth: f64::INFINITY,
            gouge: false,
        });
        let (origin, surfaces) = (origin.clone(), Vec::new());
        let proof =
            StatementProof { origin, vectors: n, proved: 0, method: NO_METHOD, surfaces, fault };
        self.report(&proof, None);
        self.certificate.statements.push(proof);
    }

    /// Judges the open motion unless it goes on under that control: a slow-down before the check surface
    /// parts it.
    fn close_unless(&mut self, control: Option<&Arc<Control>>) {
        let same = |o: &Open| control.is_some_and(|c| Arc::ptr_eq(c, &o.control));
        if self.open.as_ref().is_some_and(|o| !same(o)) {
            self.close();
        }
    }

    fn close(&mut self) {
        let Some(open) = self.open.take() else { return };
        self.statement(&open);
        if let (Some(part), Some(at)) = (&open.control.part, open.points.last()) {
            self.free.along(part, at, &open.profile, &mut self.diagnostics);
        }
    }

    fn statement(&mut self, open: &Open) {
        if let Some(milling) = &open.control.milling {
            return self.milled(open, milling);
        }
        let Open { control, startup, start, points, profile, .. } = open;
        let pad = self.pad(points, profile);
        let n = points.len() as u64;
        let mut along: Vec<Judged> = [("drive", &control.drive), ("part", &control.part)]
            .into_iter()
            .filter_map(|(role, c)| c.as_ref().map(|c| Judged::new(c, role)))
            .collect();
        let mut check = control.checks.first().map(|c| Judged::new(c, "check"));
        let mut never = match (&control.checks.first(), start) {
            (Some(c), Some(start)) if !startup => Judged::never_past(c, profile, start, pad),
            _ => None,
        };
        let mut proof = StatementProof {
            origin: open.origin.clone(),
            vectors: 0,
            proved: 0,
            method: along.iter().chain(&check).map(Judged::method).min().unwrap_or("none"),
            surfaces: Vec::new(),
            fault: None,
        };
        let mut real: Option<Fault> = None;
        let mut from = *start;
        for (i, to) in (1..).zip(points) {
            let start = from.unwrap_or(*to);
            from = Some(*to);
            let wanted = match self.effort {
                Effort::Full => true,
                Effort::Every(k) => i == 1 || i == n || i % k.max(1) == 0,
            };
            if !wanted {
                self.certificate.left_out += 1;
                continue;
            }
            proof.vectors += 1;
            // A start-up comes through the air: what it promises is where it ends.
            let start = if *startup { *to } else { start };
            let mut fault: Option<Fault> = None;
            for judged in &mut along {
                keep(&mut fault, judged.vector(profile, &start, to, pad, i));
                if let Some(f) = judged.real_cutter(profile, &start, to, pad, i) {
                    keep(&mut real, Some(f));
                }
            }
            if let Some(judged) = &mut never {
                keep(&mut fault, judged.vector(profile, &start, to, pad, i));
            }
            if i == n
                && let Some(judged) = &mut check
            {
                keep(&mut fault, judged.vector(profile, to, to, pad, i));
            }
            match &fault {
                None => {
                    proof.proved += 1;
                    self.certificate.proved += 1;
                }
                Some(f) if f.refuted => self.certificate.refuted += 1,
                Some(_) => self.certificate.undecided += 1,
            }
            keep(&mut proof.fault, fault);
        }
        proof.surfaces = along.iter().chain(&check).filter_map(Judged::bound).collect();
        self.report(&proof, real);
        self.certificate.statements.push(proof);
    }

    fn pad(&self, points: &[Position], profile: &Profile) -> f64 {
        let size = points.iter().chain(&self.last).map(|p| p.te.norm()).fold(0.0, f64::max);
        self.certificate.rounding * size.max(profile.reach()).max(f64::MIN_POSITIVE)
    }

    fn report(&mut self, proof: &StatementProof, real: Option<Fault>) {
        let trace = &proof.origin.trace;
        if let Some(f) = real {
            let message = format!(
                "the real cutter cuts into {} by {} beyond tolerance {}; its disk does not",
                f.surface,
                length(f.depth),
                f.place()
            );
            let d = Diagnostic::warning(codes::REAL_CUTTER, proof.origin.span, message);
            self.diagnostics.push(d.within(trace.clone()));
        }
        let Some(f) = &proof.fault else { return };
        let d = if f.refuted {
            let what = if f.gouge { "cuts into" } else { "leaves material on" };
            let message = format!(
                "cut vector {} {what} {} by {} beyond tolerance {}",
                f.vector,
                f.surface,
                length(f.depth),
                f.place()
            );
            Diagnostic::error(codes::REFUTED, proof.origin.span, message)
        } else {
            let message =
                format!("cut vector {} against {} could not be proved", f.vector, f.surface);
            let d = Diagnostic::warning(codes::UNPROVED, proof.origin.span, message);
            if f.depth.is_finite() {
                d.note(format!("it leaves the band by {} at most, {}", length(f.depth), f.place()))
            } else {
                d
            }
        };
        self.diagnostics.push(d.within(trace.clone()));
    }
}

/// How a motion is proved of which the surfaces are not known.
const NO_METHOD: &str = "none";

/// Keeps the worse of two faults: a refuted one before one not decided, the deeper before the other.
fn keep(worst: &mut Option<Fault>, new: Option<Fault>) {
    let Some(new) = new else { return };
    let rank = |f: &Fault| (f.refuted, f.depth);
    if worst.as_ref().is_none_or(|old| rank(&new) > rank(old)) {
        *worst = Some(new);
    }
}

/// Is it CLRSRF/NOW?
fn now(args: &[Arg]) -> bool {
    matches!(args.first(), Some(Arg::Word(w)) if w == "NOW" || w == "START")
}

/// The plane of CLRSRF/plane.
fn clearance(args: &[Arg]) -> Option<Plane> {
    let form = args.iter().find_map(|a| match a {
        Arg::Form { form, .. } => Some(form),
        _ => None,
    })?;
    match form.shape() {
        Form::Plane(p) => Some(*p),
        _ => None,
    }
}

fn profile(cutter: &Cutter) -> Option<Profile> {
    Profile::new(cutter).ok()
}
