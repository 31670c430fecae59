//! Judges a stream of CL records.

use aptc_cldata::{Control, Controlled, Kind, Motion, MotionKind, Position, Record, Relation};
use aptc_diagnostics::{Diagnostic, Origin, codes};
use aptc_geometry::{Cutter, Profile};

use crate::certificate::{Certificate, Fault, StatementProof, SurfaceBound};
use crate::segment::{Demand, Verdict};

/// Allowance for rounding as a share of the size of the scene: what is proved is proved of a band wider by
/// this. Positions are solved to 1e-12 of the scene.
const ROUNDING: f64 = 1e-11;

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
    certificate: Certificate,
    diagnostics: Vec<Diagnostic>,
}

impl Verifier {
    /// A verifier at the beginning of a part program.
    pub fn new(effort: Effort) -> Self {
        let certificate = Certificate { rounding: ROUNDING, ..Certificate::default() };
        Self { effort, profile: None, last: None, certificate, diagnostics: Vec::new() }
    }

    /// Takes the next record of Section 2, before editing: TRACUT and COPY move the path off the surfaces.
    pub fn push(&mut self, record: &Record) {
        match &record.kind {
            Kind::Cutter(cutter) => self.profile = profile(cutter),
            Kind::Motion(motion) => {
                match (&motion.control, motion.kind) {
                    (Some(control), MotionKind::Startup | MotionKind::Continuous) => {
                        self.statement(motion, control, &record.origin);
                    }
                    (_, MotionKind::From) => {}
                    _ => self.certificate.free += motion.points.len() as u64,
                }
                self.last = motion.points.last().copied().or(self.last);
            }
            _ => {}
        }
    }

    /// The certificate, and a message for each statement that is not proved.
    pub fn finish(self) -> (Certificate, Vec<Diagnostic>) {
        (self.certificate, self.diagnostics)
    }

    fn statement(&mut self, motion: &Motion, control: &Control, origin: &Origin) {
        let profile = match self.profile.or_else(|| profile(&Cutter::mill(0.0, 0.0, 0.0))) {
            Some(p) => p,
            None => return,
        };
        let pad = self.pad(motion, &profile);
        let mut proof = StatementProof {
            origin: origin.clone(),
            vectors: 0,
            proved: 0,
            method: "bounds by support functions",
            surfaces: Vec::new(),
            fault: None,
        };
        let startup = motion.kind == MotionKind::Startup;
        let along: Vec<Judged> = [("drive", &control.drive), ("part", &control.part)]
            .into_iter()
            .filter_map(|(role, c)| c.as_ref().map(|c| Judged::new(c, role)))
            .collect();
        let mut along = along;
        let mut checks: Vec<Judged> =
            control.checks.iter().take(1).map(|c| Judged::new(c, "check")).collect();
        let n = motion.points.len() as u64;
        let mut from = self.last;
        for (i, to) in (1..).zip(&motion.points) {
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
            let mut verdicts = Vec::with_capacity(3);
            for judged in &mut along {
                let shape = judged.disk.unwrap_or(profile);
                // A start-up comes through the air: what it promises is where it ends.
                let verdict = if startup {
                    judged.demand.judge_position(&shape, to, pad)
                } else {
                    judged.demand.judge(&shape, &start, to, pad)
                };
                verdicts.push(judged.take(verdict, i));
            }
            if i == n {
                for judged in &mut checks {
                    let verdict = judged.demand.judge_position(&profile, to, pad);
                    verdicts.push(judged.take(verdict, i));
                }
            }
            let fault = verdicts.into_iter().flatten().max_by_key(|f| f.refuted);
            match &fault {
                None => {
                    proof.proved += 1;
                    self.certificate.proved += 1;
                }
                Some(f) if f.refuted => self.certificate.refuted += 1,
                Some(_) => self.certificate.undecided += 1,
            }
            let worse = |new: &Fault, old: &Fault| {
                (new.refuted, new.depth).partial_cmp(&(old.refuted, old.depth))
                    == Some(std::cmp::Ordering::Greater)
            };
            if let Some(f) = fault
                && proof.fault.as_ref().is_none_or(|old| worse(&f, old))
            {
                proof.fault = Some(f);
            }
        }
        proof.surfaces = along.iter().chain(&checks).filter_map(Judged::bound).collect();
        self.report(&proof);
        self.certificate.statements.push(proof);
    }

    fn pad(&self, motion: &Motion, profile: &Profile) -> f64 {
        let size = motion.points.iter().chain(&self.last).map(|p| p.te.norm()).fold(0.0, f64::max);
        ROUNDING * size.max(profile.reach()).max(f64::MIN_POSITIVE)
    }

    fn report(&mut self, proof: &StatementProof) {
        let Some(f) = &proof.fault else { return };
        let [x, y, z] = f.te;
        let place = format!("at tool end {x:.5}, {y:.5}, {z:.5}");
        let d = if f.refuted {
            let what = if f.gouge { "cuts into" } else { "leaves material on" };
            let message = format!(
                "cut vector {} {what} {} by {:.6} beyond tolerance {place}",
                f.vector, f.surface, f.depth
            );
            Diagnostic::error(codes::REFUTED, proof.origin.span, message)
        } else {
            let message =
                format!("cut vector {} against {} could not be proved", f.vector, f.surface);
            Diagnostic::warning(codes::UNPROVED, proof.origin.span, message)
        };
        self.diagnostics.push(d.within(proof.origin.trace.clone()));
    }
}

/// A surface with what is known of it over a statement.
struct Judged {
    demand: Demand,
    /// The disk of CUTTER/OPTION, which is proved as programmed.
    disk: Option<Profile>,
    name: String,
    role: &'static str,
    low: f64,
    high: f64,
}

impl Judged {
    fn new(c: &Controlled, role: &'static str) -> Self {
        let name = match (c.name.name.as_str(), c.name.subscript) {
            ("", _) => c.form.kind().word().to_owned(),
            (n, 0) => n.to_owned(),
            (n, i) => format!("{n}({i})"),
        };
        // A tangent check is met where the drive surface leaves it, not at a distance.
        let mut demand = Demand::new(c);
        if matches!(c.relation, Relation::Tanto | Relation::Pstan) {
            demand.most = f64::INFINITY;
        }
        let disk = c.disk.and_then(|[radius, height]| Profile::disk(radius, height).ok());
        Self { demand, disk, name, role, low: f64::INFINITY, high: f64::NEG_INFINITY }
    }

    /// Notes a verdict; the fault, if it is one.
    fn take(&mut self, verdict: Verdict, vector: u64) -> Option<Fault> {
        let surface = format!("{} surface {}", self.role, self.name);
        match verdict {
            Verdict::Proved { low, high } => {
                (self.low, self.high) = (self.low.min(low), self.high.max(high));
                None
            }
            Verdict::Refuted { gap, te } => {
                let gouge = gap < self.demand.least;
                let depth = if gouge { self.demand.least - gap } else { gap - self.demand.most };
                Some(Fault { refuted: true, surface, vector, te: te.into(), depth, gouge })
            }
            Verdict::Undecided { at_most } => Some(Fault {
                refuted: false,
                surface,
                vector,
                te: [0.0; 3],
                depth: at_most,
                gouge: false,
            }),
        }
    }

    fn bound(&self) -> Option<SurfaceBound> {
        (self.low <= self.high).then(|| SurfaceBound {
            name: self.name.clone(),
            role: self.role,
            least: self.low,
            most: self.high,
            band: [self.demand.least, self.demand.most],
        })
    }
}

fn profile(cutter: &Cutter) -> Option<Profile> {
    Profile::new(cutter).ok()
}
