//! The checker checked: paths that were spoiled at random places are refuted where they are wrong, by as much
//! as they are, and brute force never contradicts a proof.
//!
//! The judge is a search over the skin of the tool with the distances of `geometry`; it shares no bound with the proof.
//! `APTC_CHECKER=n` sets the number of cut vectors that are held against it, and of spoiled places to a fiftieth.

use std::path::Path;
use std::sync::Arc;

use aptc_cldata::{Control, Controlled, Kind, Motion, MotionKind, Position, Record, Relation};
use aptc_control::{Disk, Options, Verify, compile};
use aptc_diagnostics::Origin;
use aptc_geometry::{Cutter, Profile, Surface, Vec3, trig};
use aptc_verify::{Certificate, Effort, Verifier};

/// Cut vectors held against brute force in the normal tests.
const VECTORS: usize = 400;

/// A motion along surfaces that is proved.
struct Case {
    program: String,
    cutter: Cutter,
    start: Position,
    points: Vec<Position>,
    control: Arc<Control>,
}

/// Numbers at random, the same each time.
struct Random(u64);

impl Random {
    fn below(&mut self, n: usize) -> usize {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        usize::try_from((self.0 >> 33) % n as u64).expect("less than n")
    }
}

fn asked() -> usize {
    std::env::var("APTC_CHECKER").ok().and_then(|n| n.parse().ok()).unwrap_or(VECTORS)
}

fn cases() -> Vec<Case> {
    let corpus = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../corpus");
    let mut out = Vec::new();
    for topic in ["mill", "motion", "multiaxis"] {
        let mut programs: Vec<_> = std::fs::read_dir(corpus.join(topic))
            .expect("the corpus")
            .map(|e| e.expect("a folder").path())
            .collect();
        programs.sort();
        for folder in programs {
            let name = folder.file_name().expect("a name").to_string_lossy().into_owned();
            let Ok(source) = Disk::open(&folder.join("program.apt"), 1 << 20) else { continue };
            let options = Options { verify: Verify::Off, post: false, ..Options::default() };
            let mut world = Disk::new(vec![folder], 1 << 20);
            let compiled = compile(source, &mut world, &options);
            for part in &compiled.parts {
                let records = part.computed.to_vec().expect("they can be read");
                collect(&name, &records, &mut out);
            }
        }
    }
    out
}

fn collect(program: &str, records: &[Record], out: &mut Vec<Case>) {
    let (mut cutter, mut last) = (None, None);
    for record in records {
        match &record.kind {
            Kind::Cutter(c) => cutter = Some(*c),
            Kind::Motion(m) => {
                if let (MotionKind::Continuous, Some(control), Some(cutter), Some(start)) =
                    (m.kind, &m.control, cutter, last)
                    && control.drive.is_some()
                    && controlled(control).all(|c| c.disk.is_none() && !c.open)
                {
                    let case = Case {
                        program: program.to_owned(),
                        cutter,
                        start,
                        points: m.points.clone(),
                        control: Arc::clone(control),
                    };
                    if judge(&case.cutter, &case.start, &case.points, control).is_proved() {
                        out.push(case);
                    }
                }
                last = m.points.last().copied().or(last);
            }
            _ => {}
        }
    }
}

fn controlled(control: &Control) -> impl Iterator<Item = &Controlled> {
    control.drive.iter().chain(&control.part).chain(control.checks.first())
}

fn judge(
    cutter: &Cutter,
    start: &Position,
    points: &[Position],
    control: &Arc<Control>,
) -> Certificate {
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

/// A surface that is asked for, with its band.
struct Asked {
    surface: Surface,
    sign: f64,
    on: bool,
    band: [f64; 2],
}

impl Asked {
    fn new(c: &Controlled, check: bool) -> Option<Self> {
        let on = c.side == 0 || c.relation == Relation::On;
        let surface = Surface::from_form(&c.form)?;
        // Those by two parameters are held against samples where their bounds are made, in the room of the proof.
        if matches!(surface, Surface::Parametric(_)) {
            return None;
        }
        let flat = matches!(surface, Surface::Plane(_));
        let widest = c.intol.max(c.outtol);
        let mut band = match (on, flat) {
            (true, true) => [-widest, widest],
            (true, false) => [-c.intol, c.outtol],
            _ => [c.thick - c.intol, c.thick + c.outtol],
        };
        if check && matches!(c.relation, Relation::Tanto | Relation::Pstan) {
            band[1] = f64::INFINITY;
        }
        let sign = if c.side < 0 && !on { -1.0 } else { 1.0 };
        Some(Self { surface, sign, on, band })
    }

    /// By how much the band is left, negative within it.
    fn excess(&self, profile: &Profile, at: &Position) -> f64 {
        let gap = if self.on { self.surface.distance(at.te) } else { self.least(profile, at) };
        (self.band[0] - gap).max(gap - self.band[1])
    }

    /// The least distance of a point of the tool's skin: a grid, its best places searched on.
    fn least(&self, profile: &Profile, at: &Position) -> f64 {
        let [x, y] = aptc_geometry::surface::frame_about(at.ta);
        // The skin from the tip to the rim by a number 0 to 2: below 1 the bottom's inside, above it the profile.
        let skin = |p: f64, angle: f64| {
            let [rho, z] = if p <= 1.0 {
                let [rho, z] = profile.support(0.0, -1.0).point;
                let flat = profile.joints()[0];
                if flat[0] > 0.0 {
                    [flat[0] * p, flat[1] * p + z * (1.0 - p)]
                } else {
                    [rho * p, z]
                }
            } else {
                let (s, c) = trig::sin_cos((p - 1.0) * 0.999 * std::f64::consts::PI);
                profile.support(s, -c).point
            };
            let (s, c) = trig::sin_cos(angle);
            self.sign * self.surface.distance(at.te + at.ta * z + (x * c + y * s) * rho)
        };
        let tall = profile.height();
        let wall = |h: f64, angle: f64| {
            let (s, c) = trig::sin_cos(angle);
            let rim = profile.support(1.0, 0.0).point;
            let z = rim[1] + (tall - rim[1]).max(0.0) * h;
            self.sign * self.surface.distance(at.te + at.ta * z + (x * c + y * s) * rim[0])
        };
        // Around the axis the least over the profile, each by samples and the best of them searched on.
        let search = |f: &dyn Fn(f64, f64) -> f64, range: [f64; 2]| {
            let over = |angle: f64| lowest(&|p| f(p, angle), range, 16, 2);
            lowest(&over, [0.0, std::f64::consts::TAU], 36, 3)
        };
        // A ball's bottom is its tip alone.
        let bottom = if profile.joints()[0][0] > 0.0 { 0.0 } else { 1.0 };
        search(&skin, [bottom, 2.0]).min(search(&wall, [0.0, 1.0]))
    }
}

/// The least of a function: the lowest of `n` samples, `best` of them narrowed down.
fn lowest(f: &dyn Fn(f64) -> f64, [from, to]: [f64; 2], n: u32, best: usize) -> f64 {
    let step = (to - from) / f64::from(n);
    let mut all: Vec<(f64, f64)> = (0..=n)
        .map(|i| {
            let x = from + step * f64::from(i);
            (f(x), x)
        })
        .collect();
    all.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut least = all[0].0;
    for &(_, x) in all.iter().take(best) {
        // Golden section over both neighbours.
        const SHARE: f64 = 0.618_033_988_749_894_9;
        let (mut a, mut b) = ((x - step).max(from), (x + step).min(to));
        let (mut c, mut d) = (b - SHARE * (b - a), a + SHARE * (b - a));
        let (mut fc, mut fd) = (f(c), f(d));
        for _ in 0..34 {
            if fc < fd {
                (b, d, fd) = (d, c, fc);
                c = b - SHARE * (b - a);
                fc = f(c);
            } else {
                (a, c, fc) = (c, d, fd);
                d = a + SHARE * (b - a);
                fd = f(d);
            }
        }
        least = least.min(fc).min(fd);
    }
    least
}

/// Everything that a motion is asked for.
struct Brute {
    profile: Profile,
    along: Vec<Asked>,
    check: Option<Asked>,
}

impl Brute {
    fn new(cutter: &Cutter, control: &Control) -> Option<Self> {
        let along = control.drive.iter().chain(&control.part);
        Some(Self {
            profile: Profile::new(cutter).ok()?,
            along: along.map(|c| Asked::new(c, false)).collect::<Option<_>>()?,
            check: match control.checks.first() {
                Some(c) => Some(Asked::new(c, true)?),
                None => None,
            },
        })
    }

    fn at(&self, pose: &Position, last: bool) -> f64 {
        let along = self.along.iter().map(|a| a.excess(&self.profile, pose));
        let check = self.check.iter().filter(|_| last).map(|a| a.excess(&self.profile, pose));
        along.chain(check).fold(f64::NEG_INFINITY, f64::max)
    }

    /// The greatest excess along a motion at `n` places of each vector.
    fn worst(&self, start: &Position, points: &[Position], n: u32) -> f64 {
        let mut worst = f64::NEG_INFINITY;
        let mut from = *start;
        for (i, to) in points.iter().enumerate() {
            for k in 0..=n {
                let last = i + 1 == points.len() && k == n;
                worst = worst.max(self.at(&between(&from, to, f64::from(k) / f64::from(n)), last));
            }
            from = *to;
        }
        worst
    }
}

/// Tool end straight on, tool axis turning evenly.
fn between(a: &Position, b: &Position, t: f64) -> Position {
    let te = a.te + (b.te - a.te) * t;
    let turn = trig::atan2(a.ta.cross(&b.ta).norm(), a.ta.dot(&b.ta));
    let s = trig::sin(turn);
    let ta = if s > 1e-12 {
        a.ta * (trig::sin((1.0 - t) * turn) / s) + b.ta * (trig::sin(t * turn) / s)
    } else {
        a.ta
    };
    Position { te, ta: ta.normalize() }
}

#[test]
fn brute_force_never_contradicts_a_proof() {
    let cases = cases();
    let mut random = Random(1990);
    let (mut looked, mut nearest) = (0, f64::INFINITY);
    while looked < asked() {
        let case = &cases[random.below(cases.len())];
        let Some(brute) = Brute::new(&case.cutter, &case.control) else { continue };
        let i = random.below(case.points.len());
        let from = if i == 0 { &case.start } else { &case.points[i - 1] };
        let last = i + 1 == case.points.len();
        let size = case.points[i].te.norm() + brute.profile.reach();
        for k in 0..=4 {
            let t = if k == 4 {
                1.0
            } else {
                0.25 * (f64::from(k) + random.below(1000) as f64 / 1000.0)
            };
            let excess = brute.at(&between(from, &case.points[i], t), last && k == 4);
            assert!(excess <= 1e-9 * size, "{} vector {i} at {t}: {excess}", case.program);
            nearest = nearest.min(-excess);
        }
        looked += 1;
    }
    println!(
        "{looked} cut vectors of {} motions at 5 places each, none beyond its band",
        cases.len()
    );
}

#[test]
fn what_was_spoiled_is_refuted_in_the_right_place() {
    let cases = cases();
    let mut random = Random(360);
    let (mut spoiled, mut harmless) = ([0_u32; 4], 0_u32);
    let wanted = u32::try_from(asked() / 50).expect("few");
    while spoiled.iter().sum::<u32>() < wanted {
        let case = &cases[random.below(cases.len())];
        let (mut points, mut cutter) = (case.points.clone(), case.cutter);
        let n = points.len();
        let kind = random.below(4);
        let Some(c) = controlled(&case.control).nth(random.below(2)) else { continue };
        let band = c.intol + c.outtol;
        match kind {
            0 => {
                let i = random.below(n);
                let Some(surface) = Surface::from_form(&c.form) else { continue };
                let Ok(normal) = surface.normal(points[i].te) else { continue };
                let sign = if random.below(2) == 0 { 1.5 } else { -1.5 };
                points[i].te += normal * (sign * band);
            }
            1 if n > 2 => {
                points.remove(random.below(n - 1));
            }
            2 if cutter.alpha_deg == 0.0 && cutter.beta_deg == 0.0 && cutter.diameter > 0.0 => {
                let corner =
                    if cutter.corner_radius >= 0.5 * cutter.diameter { 2.0 * band } else { 0.0 };
                cutter = Cutter::mill(
                    cutter.diameter + 4.0 * band,
                    cutter.corner_radius + corner,
                    cutter.height,
                );
            }
            3 if !case.control.checks.is_empty() => {
                let from = if n > 1 { points[n - 2].te } else { case.start.te };
                let Some(way) = (points[n - 1].te - from).try_normalize(0.0) else { continue };
                let check = &case.control.checks[0];
                points[n - 1].te += way * (2.0 * (check.intol + check.outtol));
            }
            _ => continue,
        }
        let Some(brute) = Brute::new(&cutter, &case.control) else { continue };
        let worst = brute.worst(&case.start, &points, 16);
        let found = judge(&cutter, &case.start, &points, &case.control);
        let fault = found.statements[0].fault.clone();
        let what = format!("{} kind {kind} of {n}: {worst} {fault:?}", case.program);
        if worst < 0.02 * band {
            // A vertex on a straight line, a wider tool that is ON: nothing was spoiled.
            let wrong = fault.is_some_and(|f| {
                f.refuted && f.depth > 0.05 * band && !f.surface.starts_with("check")
            });
            assert!(!wrong, "{what}");
            harmless += 1;
            continue;
        }
        let fault = fault.unwrap_or_else(|| panic!("not found: {what}"));
        assert!(fault.refuted, "{what}");
        spoiled[kind] += 1;
        let vector = usize::try_from(fault.vector).expect("a number") - 1;
        if fault.surface.starts_with("check") && vector + 1 < points.len() {
            // It passes its check surface on the way, which the judge does not ask.
            continue;
        }
        assert!(
            fault.depth >= 0.8 * worst - 0.02 * band && fault.depth <= 1.2 * worst + 0.02 * band,
            "{what}"
        );
        // At the place that is told the judge finds that depth.
        let from = if vector == 0 { case.start } else { points[vector - 1] };
        let to = points[vector];
        let way = to.te - from.te;
        let te = Vec3::from(fault.te);
        let t = if way.norm() > 0.0 { (te - from.te).dot(&way) / way.norm_squared() } else { 1.0 };
        let place = between(&from, &to, t.clamp(0.0, 1.0));
        assert!((place.te - te).norm() <= 1e-6 * (1.0 + te.norm()), "beside the vector: {what}");
        let there = brute.at(&place, vector + 1 == points.len() && t > 1.0 - 1e-9);
        assert!((there - fault.depth).abs() <= 0.02 * band + 0.05 * worst, "{there} there: {what}");
    }
    println!(
        "moved, removed, larger tool, overrun: {spoiled:?} refuted; {harmless} changes left the path right"
    );
}
