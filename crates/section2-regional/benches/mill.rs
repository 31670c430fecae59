//! Rates of regional milling on a bumpy surface, by `cargo bench -p aptc-regional`.
//!
//! Times are of the processor. A word after `--` leaves out the figures in whose names it does not stand.

use std::hint::black_box;
use std::sync::Arc;

use aptc_cldata as cl;
use aptc_contact::{PatchTree, Tool};
use aptc_geometry::sculpt::{SplinePoint, mesh};
use aptc_geometry::sculptured::{MeshSpacing, SurfaceDefinition};
use aptc_geometry::{Cutter, Form, Profile, Sculptured, Vec3, trig};
use aptc_protap::{Arg, Kind, NameRef, Record};
use aptc_regional::{Ends, Probe, Regional, Shot};
use aptc_testkit::bench;

/// Heights of hills and hollows over -10 to 110 mm, slopes up to about 35 degrees.
fn height(x: f64, y: f64) -> f64 {
    let hill = |h: f64, a: f64, b: f64, w: f64| {
        let q = ((x - a) * (x - a) + (y - b) * (y - b)) / (2.0 * w * w);
        h / (1.0 + q + 0.5 * q * q + q * q * q / 6.0)
    };
    20.0 + hill(14.0, 32.0, 36.0, 13.0) - hill(10.0, 68.0, 60.0, 9.0)
        + hill(9.0, 74.0, 22.0, 10.0)
        + 4.0 * trig::sin(x * 0.114) * trig::cos(y * 0.09)
}

/// Hills and hollows without end, alike beside the line at `middle` for a surface of any size.
fn waves(x: f64, y: f64, middle: f64) -> f64 {
    20.0 + 5.0 * trig::sin(x * 0.114) * trig::cos((y - middle) * 0.09)
}

/// Rows of points, `n` by `n` spans over `size` mm from -10 on.
fn rows(n: u32, size: f64, z: impl Fn(f64, f64) -> f64) -> Vec<Vec<Vec3>> {
    let at = |k: u32| -10.0 + size * f64::from(k) / f64::from(n);
    (0..=n).map(|j| (0..=n).map(|i| Vec3::new(at(i), at(j), z(at(i), at(j)))).collect()).collect()
}

fn sculptured(rows: &[Vec<Vec3>]) -> Sculptured {
    let rows: Vec<Vec<_>> =
        rows.iter().map(|r| r.iter().map(|p| SplinePoint::plain(*p)).collect()).collect();
    mesh(&rows, MeshSpacing::Xyz).expect("an even mesh")
}

fn form(rows: &[Vec<Vec3>]) -> Arc<Form> {
    let definition = SurfaceDefinition::mesh(MeshSpacing::Xyz, rows.iter().cloned());
    Arc::new(Form::Ssurf(Arc::new(definition)))
}

fn cutters() -> [(&'static str, Cutter); 2] {
    [("ball D10", Cutter::mill(10.0, 5.0, 60.0)), ("bull D12 r2", Cutter::mill(12.0, 2.0, 60.0))]
}

/// Ten lines over a surface, along which a cutter is let down along z.
struct Drops<'a> {
    tree: &'a PatchTree,
    profile: &'a Profile,
    surface: &'a Sculptured,
    extent: f64,
    ends: Ends,
}

impl Drops<'_> {
    fn shot(&self, x: f64, line: u32) -> Shot<'_> {
        let ta = Vec3::z();
        Shot {
            surface: self.surface,
            extent: self.extent,
            ends: self.ends,
            side: 1.0,
            from: Vec3::new(x, 2.0 + 10.0 * f64::from(line), 60.0),
            along: -ta,
            probe: Probe::Cutter { profile: self.profile, ta, thick: 0.0 },
        }
    }

    /// The first position of each line, to which the cutter comes from afar.
    fn first(&self) -> [[f64; 2]; 10] {
        let met = |k: u32| self.shot(0.0, k).touch(self.tree).expect("over the surface").uv;
        core::array::from_fn(|k| met(u32::try_from(k).unwrap_or(0)))
    }

    /// Positions along the lines, each from the last, with a proof that they are clear where `check` says so.
    fn along(&self, first: &[[f64; 2]; 10], step: f64, check: bool) {
        for (k, first) in (0..).zip(first) {
            let mut last = *first;
            let mut x = 0.0;
            while x <= 100.0 + 1e-9 {
                let shot = self.shot(x, k);
                let found = shot.near(last).or_else(|| shot.beside(last, self.tree));
                let found = found.or_else(|| shot.touch(self.tree));
                let met = found.expect("over the surface");
                last = met.uv;
                if check {
                    let (profile, ta) = (self.profile, Vec3::z());
                    let te = shot.from - ta * met.way;
                    black_box(self.tree.clear(&Tool { profile, te, ta }, 0.005));
                }
                black_box(last);
                x += step;
            }
        }
    }
}

fn word(w: &str) -> Arg {
    Arg::Word(w.into())
}
fn of(form: &Arc<Form>) -> Arg {
    Arg::Form { name: NameRef::default(), form: Arc::clone(form) }
}
fn vector(x: f64, y: f64, z: f64) -> Arg {
    of(&Arc::new(Form::Vector(Vec3::new(x, y, z))))
}
fn numbers(all: &[f64]) -> Vec<Arg> {
    all.iter().map(|x| Arg::Number(*x)).collect()
}

/// Carries out statements; positions of the last.
fn mill(regional: &mut Regional, kinds: Vec<Kind>) -> usize {
    let mut out = Vec::new();
    for kind in kinds {
        out.clear();
        let record = Record { origin: aptc_diagnostics::Origin::default(), kind };
        let done = regional.execute(&record, &mut out);
        assert!(done.is_ok(), "{:?}", regional.take_diagnostics());
    }
    out.iter()
        .map(|r| match &r.kind {
            cl::Kind::Motion(m) => m.points.len(),
            _ => 0,
        })
        .sum()
}

fn statement(word: &str, args: Vec<Arg>) -> Kind {
    Kind::Regional { word: word.into(), args }
}

/// Modal words and areas: a flat drive over the part, the tool led over it along z.
fn prepared(part: &Arc<Form>, cutter: Cutter, tol: f64, checked: bool) -> Regional {
    prepared_over(part, 12, cutter, tol, checked)
}

/// The same over a part of `n` by `n` patches of 10 mm, one of which is left out at each border.
fn prepared_over(part: &Arc<Form>, n: u32, cutter: Cutter, tol: f64, checked: bool) -> Regional {
    let flat = form(&rows(n, 10.0 * f64::from(n), |_, _| 60.0));
    let mut regional = Regional::default();
    let mut ds = vec![word("DS"), of(&flat), word("PARAM")];
    let last = f64::from(n) - 1.0;
    ds.extend(numbers(&[1.0, last, 1.0, last]));
    ds.extend([word("ON"), vector(0.0, 0.0, -1.0)]);
    let ps = vec![word("PS"), word("TO"), of(part), word("PLUS"), Arg::Number(0.0)];
    let mut over = vec![word("STEPOV")];
    over.extend(numbers(&[0.0, 2.0, 0.0, 0.0]));
    let mut feed = vec![word("FEED")];
    feed.extend(numbers(&[0.0; 4]));
    let mut kinds = vec![
        Kind::Units(aptc_protap::Units::Mm),
        Kind::Cutter(cutter),
        Kind::Intol([tol; 4]),
        Kind::Outtol([tol; 4]),
        statement("SCON", ds),
        statement("SCON", ps),
        statement("SCON", vec![word("AXIS"), vector(0.0, 0.0, 1.0)]),
        statement("SCON", over),
        statement("SCON", feed),
    ];
    if checked {
        kinds.push(statement("CHKSRF", vec![word("PS"), word("ON")]));
    }
    mill(&mut regional, kinds);
    regional
}

fn line(v: f64) -> Kind {
    let mut args = vec![word("PATH"), word("DS"), word("PARAM")];
    args.extend(numbers(&[1.0, v]));
    args.extend([word("TANSPL"), word("PLUS")]);
    statement("SMIL", args)
}

/// Positions of eleven lines of 100 mm, to each of which the tool comes down.
fn lines(regional: &mut Regional) -> usize {
    (1..12).map(|k| down(regional, f64::from(k))).sum()
}

/// Positions of the line at `v`, from above its beginning.
fn down(regional: &mut Regional, v: f64) -> usize {
    let points = vec![cl::Position { te: Vec3::new(10.0, 10.0 * v, 60.0), ta: Vec3::z() }];
    let from = cl::Motion { kind: cl::MotionKind::From, points, ..cl::Motion::default() };
    let kind = cl::Kind::Motion(from);
    let record = cl::Record { origin: aptc_diagnostics::Origin::default(), kind };
    let stands = regional.watch(&mut vec![record], 0);
    assert!(stands.is_ok(), "{:?}", regional.take_diagnostics());
    mill(regional, vec![line(v)])
}

/// Pages of memory in use.
fn resident() -> f64 {
    let text = std::fs::read_to_string("/proc/self/statm").unwrap_or_default();
    let pages = text.split(' ').nth(1).and_then(|n| n.parse::<f64>().ok());
    pages.unwrap_or(f64::NAN) * 4096.0
}

#[expect(clippy::cast_precision_loss, reason = "some thousands")]
fn main() {
    let bumps = rows(12, 120.0, height);
    let (s, part) = (sculptured(&bumps), form(&bumps));
    let tree = PatchTree::new(&s);
    let (extent, ends) = (s.extent(), Ends::of(&s));
    for (name, cutter) in cutters() {
        let profile = Profile::new(&cutter).expect("a mill");
        let drops = Drops { tree: &tree, profile: &profile, surface: &s, extent, ends };
        let first = drops.first();
        let name_of = format!("first positions, {name}");
        bench::rate(&name_of, 10.0, "positions/s", None, || drops.first());
        for (check, what) in [(false, "positions"), (true, "positions proved clear to .005")] {
            for step in [0.1, 0.9, 2.0] {
                let name = format!("{what}, {name}, step {step}");
                let n = 10.0 * ((100.0_f64 / step + 1e-9).floor() + 1.0);
                bench::rate(&name, n, "positions/s", None, || {
                    drops.along(&first, step, check);
                });
            }
        }
    }
    for (name, cutter) in cutters() {
        for tol in [0.005, 0.01] {
            for (checked, how) in [(false, ""), (true, ", CHKSRF")] {
                let mut regional = prepared(&part, cutter, tol, checked);
                let name = format!("lines of 100 mm, {name}, +-{tol}{how}");
                if bench::rate(&name, 11.0, "lines/s", Some(147.0), || lines(&mut regional)) {
                    let points = lines(&mut regional) as f64 / 11.0;
                    bench::figure(&format!("{name}, positions"), points, "a line", Some(85.0));
                }
            }
        }
    }
    for n in [3_u32, 10, 32, 100] {
        let size = 10.0 * f64::from(n);
        let patches = n * n;
        let name = format!("growth, {patches} patches");
        let bumps = rows(n, size, |x, y| waves(x, y, 0.5 * size - 10.0));
        let s = sculptured(&bumps);
        let mut memory = 0.0;
        let made =
            bench::rate(&format!("{name}, made"), f64::from(patches), "patches/s", None, || {
                let before = resident();
                let tree = PatchTree::new(&s);
                memory = f64::max(memory, resident() - before);
                tree
            });
        if made {
            bench::figure(&format!("{name}, memory"), memory / f64::from(patches), "bytes", None);
        }
        let part = form(&bumps);
        for (cutter_name, cutter) in cutters() {
            let mut regional = prepared_over(&part, n, cutter, 0.005, true);
            let mut work = || down(&mut regional, 0.5 * f64::from(n));
            let points = work() as f64;
            let name = format!("{name}, path, {cutter_name}");
            bench::rate(&name, points, "positions/s", None, work);
        }
    }
}
