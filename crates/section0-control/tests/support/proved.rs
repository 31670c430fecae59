//! Motions along surfaces that are proved: of the corpus, of random programs and of random scenes.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use crate::milled;
use crate::support::{self, scene};
use aptc_cldata::milling::Milling;
use aptc_cldata::{Control, Controlled, Kind, Motion, MotionKind, Position, Record};
use aptc_control::{Disk, Options, Source, Verify, compile};
use aptc_diagnostics::{Diagnostic, Origin};
use aptc_geometry::{Cutter, Form, Surface, Vec3};
use aptc_verify::{Certificate, Effort, Verifier};

const CORPUS: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../corpus");
/// Cut vectors held against brute force in the normal tests.
const VECTORS: usize = 400;
/// The first random scene that is looked through for surfaces that are rare in the corpus; so many are, more where more
/// is asked for.
const SCENE: u64 = 50_000;
const SCENES: usize = 150;
/// Random programs of regional milling beside planes, spheres, cylinders and cones.
const MILLED: usize = 24;
/// The kind of their motions.
pub(crate) const HELD: &str = "HOLDER beside plain surfaces";
/// Vectors of a motion of which one place is spoiled.
const WINDOW: usize = 8;

/// A motion along surfaces that is proved.
#[derive(Clone)]
pub(crate) struct Case {
    pub(crate) program: String,
    pub(crate) cutter: Cutter,
    pub(crate) start: Position,
    pub(crate) points: Vec<Position>,
    pub(crate) control: Arc<Control>,
}

/// Proved motions.
pub(crate) struct Cases {
    pub(crate) all: Vec<Case>,
    /// Those with a surface of a kind.
    kinds: Vec<(&'static str, Vec<usize>)>,
}

impl Cases {
    /// A motion with a surface of a kind at random, and that kind.
    pub(crate) fn draw(&self, random: &mut Random) -> (&Case, &'static str) {
        let (kind, of) = &self.kinds[random.below(self.kinds.len())];
        (&self.all[of[random.below(of.len())]], kind)
    }
}

pub(crate) fn cases() -> Cases {
    let mut out = Vec::new();
    for topic in ["mill", "motion", "multiaxis"] {
        let mut programs: Vec<_> = std::fs::read_dir(Path::new(CORPUS).join(topic))
            .expect("the corpus")
            .map(|e| e.expect("a folder").path())
            .collect();
        programs.sort();
        for folder in programs {
            from_folder(folder, &mut out);
        }
    }
    // None of its regional milling has a holder beside surfaces that are not sculptured.
    for seed in 0..MILLED.max(asked() / 40) as u64 {
        let (name, text) = (format!("milled {seed}"), milled::program(seed));
        let source = Source { name: name.as_str().into(), text: text.into() };
        let messages = compiled(&name, source, &mut Disk::new(Vec::new(), 0), &mut out);
        // The tool gets into something where it does not get out of the way, on the way to a region too, and passes leave what
        // they leave. A statement that is not understood would leave the rest without what is to be looked at.
        let strange = messages
            .iter()
            .find(|d| !["APT2046", "APT2049", "APT2053"].contains(&&*d.code.to_string()));
        assert!(strange.is_none(), "{name}: {strange:?}");
    }
    // The corpus has few paths along RLDSRF, cones and quadrics, and none along POLCON.
    for seed in SCENE..SCENE + SCENES.max(asked() / 20) as u64 {
        let Some(scene) = scene::wide(seed, 1.0) else { continue };
        let rare = |f: &Form| {
            matches!(f, Form::Ruled(_) | Form::Polyconic(_) | Form::Quadric(_) | Form::Cone(_))
        };
        if scene.forms.values().any(rare) {
            let ran = support::run(&scene.forms, &scene.setup);
            collect(&format!("scene {seed}"), &ran.cl, &mut out);
        }
    }
    let mut kinds: BTreeMap<&str, Vec<usize>> = BTreeMap::new();
    for (i, case) in out.iter().enumerate() {
        case.kinds().into_iter().for_each(|kind| kinds.entry(kind).or_default().push(i));
    }
    assert!(kinds.contains_key(HELD), "none of the random programs");
    Cases { all: out, kinds: kinds.into_iter().collect() }
}

/// Those of one program of the corpus.
pub(crate) fn cases_of(program: &str) -> Vec<Case> {
    let mut out = Vec::new();
    from_folder(Path::new(CORPUS).join(program), &mut out);
    out
}

fn from_folder(folder: PathBuf, out: &mut Vec<Case>) {
    let name = folder.file_name().expect("a name").to_string_lossy().into_owned();
    if let Ok(source) = Disk::open(&folder.join("program.apt"), 1 << 20) {
        compiled(&name, source, &mut Disk::new(vec![folder], 1 << 20), out);
    }
}

/// Takes what is proved of a program; its messages.
fn compiled(name: &str, source: Source, world: &mut Disk, out: &mut Vec<Case>) -> Vec<Diagnostic> {
    let options = Options { verify: Verify::Off, post: false, ..Options::default() };
    let compiled = compile(source, world, &options);
    for part in &compiled.parts {
        collect(name, &part.computed.to_vec().expect("they can be read"), out);
    }
    compiled.diagnostics
}

fn collect(program: &str, records: &[Record], out: &mut Vec<Case>) {
    let (mut cutter, mut last) = (None, None);
    for record in records {
        match &record.kind {
            Kind::Cutter(c) => cutter = Some(*c),
            Kind::Motion(m) => {
                if let (MotionKind::Continuous, Some(control), Some(cutter), Some(start)) =
                    (m.kind, &m.control, cutter, last)
                    && (control.drive.is_some() || control.milling.is_some())
                    && controlled(control).all(|c| c.disk.is_none() && !c.open)
                {
                    // How the tool comes to a region is not its promise.
                    let free = control.milling.as_ref().is_some_and(|m| !m.joined);
                    let (start, points) = match m.points.split_first() {
                        Some((first, rest)) if free => (*first, rest),
                        _ => (start, &m.points[..]),
                    };
                    if points.is_empty() {
                        last = m.points.last().copied().or(last);
                        continue;
                    }
                    let case = Case {
                        program: program.to_owned(),
                        cutter,
                        start,
                        points: points.to_vec(),
                        control: alone(control),
                    };
                    if judge(&case).is_proved() {
                        out.push(case);
                    }
                }
                last = m.points.last().copied().or(last);
            }
            _ => {}
        }
    }
}

/// Without what is asked of a whole region: the judge looks at single vectors, the first one too.
fn alone(control: &Arc<Control>) -> Arc<Control> {
    let Some(milling) = &control.milling else { return Arc::clone(control) };
    let milling = Milling { scallop: None, joined: true, ..milling.clone() };
    Arc::new(Control { milling: Some(milling), ..Control::clone(control) })
}

impl Case {
    /// Some vectors of it with the i-th among them.
    pub(crate) fn around(&self, i: usize) -> Self {
        let n = self.points.len();
        let from = i.saturating_sub(WINDOW / 2).min(n.saturating_sub(WINDOW));
        let to = (from + WINDOW).min(n);
        let mut control = Control::clone(&self.control);
        if to < n {
            control.checks.clear();
        }
        let start = if from == 0 { self.start } else { self.points[from - 1] };
        let points = self.points[from..to].to_vec();
        Self { start, points, control: Arc::new(control), ..self.clone() }
    }

    /// The kinds of its surfaces.
    pub(crate) fn kinds(&self) -> Vec<&'static str> {
        let milling = self.control.milling.iter();
        let held = |m: &&Milling| !m.plain.is_empty() && !m.holder.is_empty();
        let held = milling.clone().filter(held).map(|_| HELD);
        let milled = milling.map(|_| "regional milling").chain(held);
        controlled(&self.control).map(|c| c.form.kind().word()).chain(milled).collect()
    }

    /// The band of its surface of a kind, and the direction away from it at a place of the tool end.
    pub(crate) fn leaving(&self, kind: &str, at: &Position) -> Option<(f64, Vec3)> {
        if let Some(milling) = &self.control.milling {
            return Some((milling.intol + milling.outtol, at.ta));
        }
        let c = controlled(&self.control).find(|c| c.form.kind().word() == kind)?;
        let normal = Surface::from_form(&c.form)?.normal(at.te).ok()?;
        Some((c.intol + c.outtol, normal))
    }
}

fn controlled(control: &Control) -> impl Iterator<Item = &Controlled> {
    control.drive.iter().chain(&control.part).chain(control.checks.first())
}

pub(crate) fn judge(case: &Case) -> Certificate {
    let Case { cutter, start, points, control, .. } = case;
    let record = |kind| Record { origin: Origin::default(), kind };
    let motion = |kind, points: &[Position], control: Option<&Arc<Control>>| {
        record(Kind::Motion(Motion {
            kind,
            points: points.to_vec(),
            control: control.map(Arc::clone),
            ..Motion::default()
        }))
    };
    let mut verifier = Verifier::new(Effort::Full);
    verifier.push(&record(Kind::Cutter(*cutter)));
    verifier.push(&motion(MotionKind::From, &[*start], None));
    verifier.push(&motion(MotionKind::Continuous, points, Some(control)));
    verifier.finish().0
}

/// Numbers at random, the same each time.
pub(crate) struct Random(pub(crate) u64);

impl Random {
    pub(crate) fn below(&mut self, n: usize) -> usize {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        usize::try_from((self.0 >> 33) % n as u64).expect("less than n")
    }
}

pub(crate) fn asked() -> usize {
    std::env::var("APTC_CHECKER").ok().and_then(|n| n.parse().ok()).unwrap_or(VECTORS)
}
