//! The checker checked: paths that were spoiled at random places are refuted where they are wrong, by as much
//! as they are, and brute force never contradicts a proof.
//!
//! The judge is a search over the skin of the tool with the distances of `geometry`; it shares no bound with the proof.
//! `APTC_CHECKER=n` sets the number of cut vectors that are held against it, and of spoiled places to a fiftieth. Each
//! kind of surface comes as often as the others, and so does each way to spoil a path.

#[path = "../../section2-arelem/tests/support/mod.rs"]
mod support;

#[path = "support/milled.rs"]
mod milled;

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::Arc;

use aptc_cldata::milling::{Milled, Milling, Plain, Raised};
use aptc_cldata::{Control, Controlled, Kind, Motion, MotionKind, Position, Record, Relation};
use aptc_control::{Disk, Options, Source, Verify, compile};
use aptc_diagnostics::{Diagnostic, Origin};
use aptc_geometry::surface::{continued, kept};
use aptc_geometry::{Cutter, Form, Profile, Sculptured, Surface, Vec3, trig};
use aptc_verify::{Certificate, Effort, Verifier};
use support::{brute, scene};

/// Cut vectors held against brute force in the normal tests.
const VECTORS: usize = 400;
/// The first random scene that is looked through for surfaces that are rare in the corpus; so many are, more where more
/// is asked for.
const SCENE: u64 = 50_000;
const SCENES: usize = 150;
/// Random programs of regional milling beside planes, spheres, cylinders and cones.
const MILLED: usize = 24;
/// The kind of their motions.
const HELD: &str = "HOLDER beside plain surfaces";
/// Vectors of a motion of which one place is spoiled.
const WINDOW: usize = 8;
/// Places of a vector of a spoiled motion at which the judge looks.
const PLACES: u32 = 8;

/// A motion along surfaces that is proved.
#[derive(Clone)]
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

fn cases() -> Cases {
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
            compiled(&name, source, &mut Disk::new(vec![folder], 1 << 20), &mut out);
        }
    }
    // None of its regional milling has a holder beside surfaces that are not sculptured.
    for seed in 0..MILLED.max(asked() / 40) as u64 {
        let (name, text) = (format!("milled {seed}"), milled::program(seed));
        let source = Source { name: name.as_str().into(), text: text.into() };
        let messages = compiled(&name, source, &mut Disk::new(Vec::new(), 0), &mut out);
        // The tool gets into something where it does not get out of the way, and passes leave what they leave. A statement that
        // is not understood would leave the rest without what is to be looked at.
        let strange =
            messages.iter().find(|d| !["APT2046", "APT2053"].contains(&&*d.code.to_string()));
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

/// Takes what is proved of a program; its messages.
fn compiled(name: &str, source: Source, world: &mut Disk, out: &mut Vec<Case>) -> Vec<Diagnostic> {
    let options = Options { verify: Verify::Off, post: false, ..Options::default() };
    let compiled = compile(source, world, &options);
    for part in &compiled.parts {
        collect(name, &part.computed.to_vec().expect("they can be read"), out);
    }
    compiled.diagnostics
}

/// Proved motions.
struct Cases {
    all: Vec<Case>,
    /// Those with a surface of a kind.
    kinds: Vec<(&'static str, Vec<usize>)>,
}

impl Cases {
    /// A motion with a surface of a kind at random, and that kind.
    fn draw(&self, random: &mut Random) -> (&Case, &'static str) {
        let (kind, of) = &self.kinds[random.below(self.kinds.len())];
        (&self.all[of[random.below(of.len())]], kind)
    }
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
                    if judge(&case.cutter, &case.start, &case.points, &case.control).is_proved() {
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
    fn around(&self, i: usize) -> Self {
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
    fn kinds(&self) -> Vec<&'static str> {
        let milling = self.control.milling.iter();
        let held = |m: &&Milling| !m.plain.is_empty() && !m.holder.is_empty();
        let held = milling.clone().filter(held).map(|_| HELD);
        let milled = milling.map(|_| "regional milling").chain(held);
        controlled(&self.control).map(|c| c.form.kind().word()).chain(milled).collect()
    }

    /// The band of its surface of a kind, and the direction away from it at a place of the tool end.
    fn leaving(&self, kind: &str, at: &Position) -> Option<(f64, Vec3)> {
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
    /// Its points, where the distance from it is not to be had far away.
    net: Option<Net>,
}

impl Asked {
    fn new(c: &Controlled, check: bool) -> Option<Self> {
        let on = c.side == 0 || c.relation == Relation::On;
        let surface = Surface::from_form(&c.form)?;
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
        let net = Net::guiding(c, band, on);
        Some(Self { surface, sign, on, band, net })
    }

    /// By how much the band is left, negative within it.
    fn excess(&self, profile: &Profile, at: &Position) -> f64 {
        if let Some(net) = &self.net {
            return net.excess(profile, at);
        }
        let gap = if self.on {
            self.surface.distance(at.te)
        } else {
            brute::least(profile, at.te, at.ta, &self.surface, self.sign)
        };
        (self.band[0] - gap).max(gap - self.band[1])
    }
}

/// A sculptured surface by its points.
struct Net {
    surface: Arc<Sculptured>,
    /// Least u and v, steps along them, and the points, those of the first v first.
    from: [f64; 2],
    step: [f64; 2],
    points: Vec<Vec3>,
    on: bool,
    band: [f64; 2],
}

/// Points of a net on a side.
const SIDE: usize = 120;

impl Net {
    fn milled(of: &Milled, on: bool, milling: &Milling) -> Self {
        let widest = milling.intol.max(milling.outtol);
        let band = if on { [-widest, widest] } else { [of.thick - milling.intol, f64::INFINITY] };
        let range = of.surface.spans().map(|n| [0.0, n]);
        Self::new(Arc::new(Sculptured::clone(&of.surface)), range, on, band)
    }

    /// A surface that guides the tool, with its continuation; on which side the tool is it does not tell.
    fn guiding(c: &Controlled, band: [f64; 2], on: bool) -> Option<Self> {
        let Form::Ssurf(definition) = c.form.shape() else { return None };
        let whole = continued(definition)?;
        let spans = whole.surface.spans();
        let range = [(whole.u, spans[0]), (whole.v, spans[1])].map(|(r, n)| r.map(|x| x * n));
        Some(Self::new(Arc::new(whole.surface), range, on, band))
    }

    fn new(surface: Arc<Sculptured>, range: [[f64; 2]; 2], on: bool, band: [f64; 2]) -> Self {
        let from = range.map(|r| r[0]);
        let step = range.map(|r| (r[1] - r[0]) / (SIDE - 1) as f64);
        let at = |k: usize| {
            let (i, j) = (k % SIDE, k / SIDE);
            surface.at(from[0] + i as f64 * step[0], from[1] + j as f64 * step[1]).point
        };
        let points = (0..SIDE * SIDE).map(at).collect();
        Self { surface, from, step, points, on, band }
    }

    /// The least distance of the surface from the tool, or from its end: the best points, searched on.
    fn excess(&self, profile: &Profile, at: &Position) -> f64 {
        let far = |p: Vec3| {
            let w = p - at.te;
            let z = w.dot(&at.ta);
            if self.on { w.norm() } else { profile.near((w - at.ta * z).norm(), z).distance }
        };
        let all: Vec<f64> = self.points.iter().map(|p| far(*p)).collect();
        let lowest = |k: &usize| {
            let (i, j) = (k % SIDE, k / SIDE);
            let beside = [(i > 0, k.wrapping_sub(1)), (i + 1 < SIDE, k + 1)];
            let across = [(j > 0, k.wrapping_sub(SIDE)), (j + 1 < SIDE, k + SIDE)];
            beside.into_iter().chain(across).all(|(is, n)| !is || all[n] >= all[*k])
        };
        let mut places: Vec<usize> = (0..all.len()).filter(lowest).collect();
        places.sort_by(|a, b| all[*a].total_cmp(&all[*b]));
        let top = [0, 1].map(|i| self.from[i] + self.step[i] * (SIDE - 1) as f64);
        let down = |k: usize| {
            let steps = [k % SIDE, k / SIDE];
            let mut place = [0, 1].map(|i| self.from[i] + steps[i] as f64 * self.step[i]);
            let (mut least, mut share) = (all[k], 1.0);
            while share > 1e-7 {
                let mut moved = false;
                for way in
                    [[1.0, 0.0], [-1.0, 0.0], [0.0, 1.0], [0.0, -1.0], [1.0, 1.0], [-1.0, -1.0]]
                {
                    let next = [0, 1].map(|i| {
                        (place[i] + way[i] * share * self.step[i]).clamp(self.from[i], top[i])
                    });
                    let d = far(self.surface.at(next[0], next[1]).point);
                    if d < least {
                        (least, place, moved) = (d, next, true);
                    }
                }
                share *= if moved { 1.0 } else { 0.5 };
            }
            least
        };
        let gap = places.into_iter().take(6).map(down).fold(f64::INFINITY, f64::min);
        (self.band[0] - gap).max(gap - self.band[1])
    }
}

/// A checked plane, sphere, cylinder or cone: cutter and holder on one side of it.
struct Beside {
    surface: Surface,
    sign: f64,
    /// Is its hollow open along the tool axis?
    open: bool,
    intol: f64,
}

impl Beside {
    /// The side is that of the cutter's lower end at `from`, before the motion. `None` of other surfaces.
    fn new(of: &Plain, intol: f64, solids: &[Raised], from: &Position) -> Option<Self> {
        use Surface::{Cone, Cylinder, Plane, Sphere};
        let surface = Surface::from_form(&of.form)?;
        let (round, flat) =
            (matches!(surface, Sphere(_) | Cylinder(_)), matches!(surface, Plane(_) | Cone(_)));
        if !round && !flat {
            return None;
        }
        let cutter = solids.first()?.profile;
        let up = cutter.widest().min(0.5 * cutter.height());
        let sign = 1.0_f64.copysign(surface.distance(from.te + from.ta * up));
        let mut new = Self { surface, sign, open: false, intol };
        if sign > 0.0 || matches!(new.surface, Plane(_)) {
            return Some(new);
        }
        // A bowl or a trough is open above. The inside of a cone, and of a cylinder that may open or not as the tool leans,
        // is left to the tests of the proof.
        let stands = match &new.surface {
            Cylinder(s) => s.axis.dot(&from.ta).abs(),
            Cone(_) => return None,
            _ => 0.0,
        };
        new.open = stands < 0.6;
        (new.open || stands > 0.8).then_some(new)
    }

    /// How far a point is from it, positive on the side of the tool.
    fn distance(&self, p: Vec3, ta: Vec3) -> f64 {
        let closed = self.sign * self.surface.distance(p);
        if !self.open {
            return closed;
        }
        // Above the widest place the wall goes straight up.
        match &self.surface {
            Surface::Sphere(s) => {
                let w = p - s.center;
                let up = w.dot(&ta);
                if up > 0.0 { s.radius - (w - ta * up).norm() } else { closed }
            }
            Surface::Cylinder(s) => {
                let w = p - s.point;
                let w = w - s.axis * w.dot(&s.axis);
                let side = s.axis.cross(&ta).normalize();
                if w.dot(&ta) > 0.0 { s.radius - w.dot(&side).abs() } else { closed }
            }
            _ => closed,
        }
    }

    /// How far the cutter or what is above it reaches over to the other side, beyond what is allowed.
    fn excess(&self, solids: &[Raised], at: &Position) -> f64 {
        let least = |s: &Raised| {
            let te = at.te + at.ta * s.up;
            brute::lowest(&s.profile, te, at.ta, |p| self.distance(p, at.ta))
        };
        -self.intol - solids.iter().map(least).fold(f64::INFINITY, f64::min)
    }
}

/// Everything that a motion is asked for.
struct Brute {
    profile: Profile,
    along: Vec<Asked>,
    nets: Vec<Net>,
    check: Option<Asked>,
    /// Cutter, holder and the axis between them, and the surfaces that all keep off.
    solids: Vec<Raised>,
    beside: Vec<Beside>,
    /// The nets that the holder keeps off too.
    held: Vec<bool>,
}

impl Brute {
    /// The tool comes from `from`.
    fn new(cutter: &Cutter, control: &Control, from: &Position) -> Option<Self> {
        let along = control.drive.iter().chain(&control.part);
        let milling = control.milling.iter();
        let nets = milling.flat_map(|m| {
            let part = m.part.iter().map(|p| Net::milled(p, m.on, m));
            part.chain(m.checked.iter().map(|c| Net::milled(c, false, m)))
        });
        let profile = Profile::new(cutter).ok()?;
        let milling = || control.milling.iter();
        let holder = milling().flat_map(|m| m.holder.iter().copied());
        let mut solids: Vec<_> =
            std::iter::once(Raised { profile, up: 0.0 }).chain(holder).collect();
        let above: Vec<_> = solids[1..].iter().map(|s| (s.profile, s.up)).collect();
        let allowed = milling().map(|m| m.intol).next().unwrap_or(0.0);
        let rod = kept::between(&profile, &above, allowed);
        solids.extend(rod.map(|(profile, up)| Raised { profile, up }));
        let beside = milling()
            .flat_map(|m| m.plain.iter().map(|p| Beside::new(p, m.intol, &solids, from)))
            .collect::<Option<_>>()?;
        Some(Self {
            profile,
            solids,
            beside,
            held: milling()
                .flat_map(|m| {
                    let part = m.part.iter().map(|_| m.guarded);
                    part.chain(m.checked.iter().map(|_| true))
                })
                .collect(),
            along: along.map(|c| Asked::new(c, false)).collect::<Option<_>>()?,
            nets: nets.collect(),
            check: match control.checks.first() {
                Some(c) => Some(Asked::new(c, true)?),
                None => None,
            },
        })
    }

    fn at(&self, pose: &Position, last: bool) -> f64 {
        let beside = self.beside.iter().map(|b| b.excess(&self.solids, pose));
        let held = self.nets.iter().zip(&self.held).filter(|(_, held)| **held);
        let above = held.flat_map(|(net, _)| {
            self.solids[1..].iter().map(|s| {
                let raised = Position { te: pose.te + pose.ta * s.up, ..*pose };
                net.excess(&s.profile, &raised)
            })
        });

        let along = self.along.iter().map(|a| a.excess(&self.profile, pose));
        let check = self.check.iter().filter(|_| last).map(|a| a.excess(&self.profile, pose));
        let nets = self.nets.iter().map(|n| n.excess(&self.profile, pose));
        along.chain(check).chain(nets).chain(beside).chain(above).fold(f64::NEG_INFINITY, f64::max)
    }

    /// The room at a place between shank and holder and the surfaces beside them; negative in one.
    fn room(&self, at: &Position) -> f64 {
        let beside = self.beside.iter().map(|b| -b.intol - b.excess(&self.solids[1..], at));
        beside.fold(f64::INFINITY, f64::min)
    }

    /// The greatest excess along a motion at `n` places of each vector.
    fn worst(&self, start: &Position, points: &[Position], n: u32) -> f64 {
        let mut worst = f64::NEG_INFINITY;
        let mut from = *start;
        for (i, to) in points.iter().enumerate() {
            for k in 0..=n {
                let last = i + 1 == points.len() && k == n;
                let place = between(&from, to, f64::from(k) / f64::from(n));
                worst = worst.max(self.at(&place, last));
            }
            from = *to;
        }
        worst
    }
}

/// Tool end straight on, tool axis turning evenly.
fn between(a: &Position, b: &Position, t: f64) -> Position {
    let te = a.te + (b.te - a.te) * t;
    let turn = trig::angle_between(a.ta, b.ta);
    let s = trig::sin(turn);
    let ta = if s > 1e-12 {
        a.ta * (trig::sin((1.0 - t) * turn) / s) + b.ta * (trig::sin(t * turn) / s)
    } else {
        a.ta
    };
    Position { te, ta: ta.normalize() }
}

/// With a shank and a holder of straight cylinders, wider by `more` than what is there is at most.
fn wider(control: &Control, more: f64) -> Arc<Control> {
    let mut control = Control::clone(control);
    for raised in control.milling.iter_mut().flat_map(|m| m.holder.iter_mut()) {
        let height = raised.profile.height();
        let cutter = Cutter::mill(2.0 * (raised.profile.widest() + more), 0.0, height);
        raised.profile = Profile::new(&cutter).expect("a cylinder");
    }
    Arc::new(control)
}

#[test]
fn brute_force_never_contradicts_a_proof() {
    let cases = cases();
    let mut random = Random(1990);
    let mut kinds: BTreeMap<&str, u32> = BTreeMap::new();
    let (mut looked, mut nearest) = (0, f64::INFINITY);
    while looked < asked() {
        let (case, _) = cases.draw(&mut random);
        let Some(brute) = Brute::new(&case.cutter, &case.control, &case.start) else { continue };
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
        case.kinds().into_iter().for_each(|k| *kinds.entry(k).or_default() += 1);
    }
    println!(
        "{looked} cut vectors of {} motions at 5 places each, none beyond its band: {kinds:?}",
        cases.all.len()
    );
}

#[test]
fn what_was_spoiled_is_refuted_in_the_right_place() {
    let cases = cases();
    let mut random = Random(360);
    let mut kinds: BTreeMap<&str, u32> = BTreeMap::new();
    let (mut spoiled, mut harmless) = ([0_u32; 5], 0_u32);
    let wanted = u32::try_from(asked() / 50).expect("few");
    while spoiled.iter().sum::<u32>() < wanted {
        let (whole, surface) = cases.draw(&mut random);
        let kind = spoiled.iter().sum::<u32>() % 5;
        let last = whole.points.len() - 1;
        let mut case = whole.around(if kind == 3 { last } else { random.below(last + 1) });
        let (mut points, mut cutter) = (case.points.clone(), case.cutter);
        let n = points.len();
        let i = random.below(n);
        let Some((band, normal)) = case.leaving(surface, &points[i]) else { continue };
        match kind {
            0 => {
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
            4 if surface == HELD => {
                let Some(brute) = Brute::new(&cutter, &case.control, &case.start) else { continue };
                case.control = wider(&case.control, brute.room(&points[i]) + 1.5 * band);
            }
            _ => continue,
        }
        let Some(brute) = Brute::new(&cutter, &case.control, &case.start) else { continue };
        let worst = brute.worst(&case.start, &points, PLACES);
        let found = judge(&cutter, &case.start, &points, &case.control);
        let fault = found.statements[0].fault.clone();
        let what = format!("{} {surface} kind {kind} of {n}: {worst} {fault:?}", case.program);
        if worst < 0.02 * band {
            // A vertex on a straight line, a wider tool that is ON: nothing was spoiled.
            let wrong = fault.is_some_and(|f| {
                f.refuted && f.depth > 0.05 * band && !f.surface.starts_with("check surface")
            });
            assert!(!wrong, "{what}");
            harmless += 1;
            continue;
        }
        let fault = fault.unwrap_or_else(|| panic!("not found: {what}"));
        assert!(fault.refuted, "{what}");
        spoiled[kind as usize] += 1;
        case.kinds().into_iter().for_each(|k| *kinds.entry(k).or_default() += 1);
        let vector = usize::try_from(fault.vector).expect("a number") - 1;
        if fault.surface.starts_with("check surface") && vector + 1 < points.len() {
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
        "moved, removed, larger tool, overrun, wider holder: {spoiled:?} refuted: {kinds:?}; {harmless} changes left the path right"
    );
}
