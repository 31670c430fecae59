//! Rates of regional milling on a bumpy surface of 120 x 120 mm, by `cargo bench -p aptc-regional`.
//!
//! Times are the best of many runs and of the processor; those of threads are of the clock.

use std::hint::black_box;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Instant;

use aptc_cldata as cl;
use aptc_contact::{PatchTree, Tool};
use aptc_geometry::sculpt::{SplinePoint, mesh};
use aptc_geometry::sculptured::{
    Knot, MeshKind, MeshSpacing, MeshSpline, Smoothing, SurfaceDefinition, SurfaceShape,
};
use aptc_geometry::{Cutter, Form, Profile, Sculptured, Vec3, trig};
use aptc_protap::{Arg, Kind, NameRef, Record};
use aptc_regional::{Alone, Crew, Probe, Regional, Shot};

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

/// Rows of points, `n` by `n` spans over `size` mm from -10 on.
fn rows(n: u32, size: f64, z: impl Fn(f64, f64) -> f64) -> Vec<Vec<Vec3>> {
    let at = |k: u32| -10.0 + size * f64::from(k) / f64::from(n);
    (0..=n).map(|j| (0..=n).map(|i| Vec3::new(at(i), at(j), z(at(i), at(j)))).collect()).collect()
}

fn sculptured(rows: &[Vec<Vec3>]) -> Sculptured {
    let rows: Vec<Vec<_>> =
        rows.iter().map(|r| r.iter().map(|p| SplinePoint::plain(*p)).collect()).collect();
    mesh(&rows, false).expect("an even mesh")
}

fn form(rows: &[Vec<Vec3>]) -> Arc<Form> {
    let spline = |row: &Vec<Vec3>| MeshSpline {
        smoothing: Smoothing::default(),
        knots: row.iter().map(|p| Knot { point: *p, ..Knot::default() }).collect(),
    };
    Arc::new(Form::Ssurf(Arc::new(SurfaceDefinition::plain(SurfaceShape::Mesh {
        kind: MeshKind::Smesh,
        spacing: MeshSpacing::Xyz,
        splines: rows.iter().map(spline).collect(),
    }))))
}

/// Seconds that this thread has had of a processor; of the clock where the system does not tell.
fn cpu() -> f64 {
    let text = std::fs::read_to_string("/proc/thread-self/schedstat").unwrap_or_default();
    let nanos = text.split(' ').next().and_then(|n| n.parse::<f64>().ok());
    nanos.map_or_else(|| clock().elapsed().as_secs_f64(), |n| n * 1e-9)
}

/// When the bench began.
fn clock() -> Instant {
    static START: std::sync::OnceLock<Instant> = std::sync::OnceLock::new();
    *START.get_or_init(Instant::now)
}

/// Processor seconds: the best of several runs.
fn best(runs: usize, mut work: impl FnMut()) -> f64 {
    (0..runs).fold(f64::INFINITY, |least, _| {
        let start = cpu();
        work();
        least.min(cpu() - start)
    })
}

fn cutters() -> [(&'static str, Cutter); 2] {
    [("ball D10", Cutter::mill(10.0, 5.0, 60.0)), ("bull D12 r2", Cutter::mill(12.0, 2.0, 60.0))]
}

/// Positions a second along a line, each from the last, and with a proof that they are clear.
fn drops(s: &Sculptured, tree: &PatchTree, cutter: &Cutter, step: f64, to: f64) -> [f64; 2] {
    let profile = Profile::new(cutter).expect("a mill");
    let extent = s.extent();
    let run = |y: f64, check: bool| {
        let ta = Vec3::z();
        let shot = |x: f64| Shot {
            surface: s,
            extent,
            side: 1.0,
            from: Vec3::new(x, y, 60.0),
            along: -ta,
            probe: Probe::Cutter { profile: &profile, ta, thick: 0.0 },
        };
        let mut last = shot(0.0).fall(tree).expect("over the surface").uv;
        let mut n = 0_u32;
        let start = cpu();
        let mut x = 0.0;
        while x <= to {
            let shot = shot(x);
            let found = shot.near(last).or_else(|| shot.fall(tree));
            let met = found.expect("over the surface");
            last = met.uv;
            if check {
                let te = shot.from - ta * met.way;
                black_box(tree.clear(&Tool { profile: &profile, te, ta }, 0.005));
            }
            n += 1;
            x += step;
        }
        (f64::from(n), cpu() - start)
    };
    [false, true].map(|check| {
        let mut rate = 0.0_f64;
        for round in 0..8 {
            for k in 0..10 {
                let (n, t) = run(2.0 + 10.0 * f64::from(k) + 0.1 * f64::from(round), check);
                rate = rate.max(n / t);
            }
        }
        rate
    })
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
fn mill(regional: &mut Regional, crew: &dyn Crew, kinds: Vec<Kind>) -> usize {
    let mut out = Vec::new();
    for kind in kinds {
        out.clear();
        let record = Record { origin: aptc_diagnostics::Origin::default(), kind };
        let done = regional.execute_by(&record, crew, &mut out);
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
    let flat = form(&rows(12, 120.0, |_, _| 60.0));
    let mut regional = Regional::default();
    let mut ds = vec![word("DS"), of(&flat), word("PARAM")];
    ds.extend(numbers(&[1.0, 11.0, 1.0, 11.0]));
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
    mill(&mut regional, &Alone, kinds);
    regional
}

fn line(v: f64) -> Kind {
    let mut args = vec![word("PATH"), word("DS"), word("PARAM")];
    args.extend(numbers(&[1.0, v]));
    args.extend([word("TANSPL"), word("PLUS")]);
    statement("SMIL", args)
}

fn region() -> Kind {
    let mut args = vec![word("ZIGZAG"), word("DS"), word("PARAM")];
    args.extend(numbers(&[1.0, 1.0]));
    args.extend([word("TANSPL"), word("PLUS"), word("STEPOV"), word("PLUS")]);
    statement("SMIL", args)
}

/// So many threads.
struct Threads(usize);

impl Crew for Threads {
    fn run(&self, n: usize, work: &(dyn Fn(usize) + Sync)) {
        let next = AtomicUsize::new(0);
        let one = || {
            loop {
                let i = next.fetch_add(1, Ordering::Relaxed);
                if i >= n {
                    break;
                }
                work(i);
            }
        };
        std::thread::scope(|s| {
            for _ in 1..self.0 {
                s.spawn(one);
            }
            one();
        });
    }
}

/// Pages of memory in use.
fn resident() -> f64 {
    let text = std::fs::read_to_string("/proc/self/statm").unwrap_or_default();
    let pages = text.split(' ').nth(1).and_then(|n| n.parse::<f64>().ok());
    pages.unwrap_or(f64::NAN) * 4096.0
}

#[expect(clippy::print_stdout, reason = "a bench prints its figures")]
fn main() {
    let bumps = rows(12, 120.0, height);
    let (s, part) = (sculptured(&bumps), form(&bumps));
    let tree = PatchTree::new(&s);
    println!("positions a second from the last one: alone, and proved clear to .005");
    for (name, cutter) in cutters() {
        for step in [0.1, 0.9, 2.0] {
            let [a, b] = drops(&s, &tree, &cutter, step, 100.0);
            println!("  {name}, step {step}: {a:9.0} {b:9.0}");
        }
    }
    println!("lines of 100 mm: positions and milliseconds a line");
    for (name, cutter) in cutters() {
        for tol in [0.005, 0.01] {
            for checked in [false, true] {
                let mut regional = prepared(&part, cutter, tol, checked);
                let mut points = 0;
                let time = best(7, || {
                    points = (0..11)
                        .map(|k| {
                            let v = 1.0 + f64::from(k);
                            mill(&mut regional, &Alone, vec![line(v)])
                        })
                        .sum();
                });
                let check = if checked { "CHKSRF" } else { "      " };
                let (n, ms) = (points as f64 / 11.0, 1e3 * time / 11.0);
                println!("  {name}, +-{tol} {check}: {n:6.1} {ms:8.3}");
            }
        }
    }
    println!("a region of 51 passes: seconds with one thread and with two");
    for (name, cutter) in cutters() {
        let time = |n: usize| {
            let mut regional = prepared(&part, cutter, 0.005, true);
            (0..3).fold(f64::INFINITY, |least: f64, _| {
                let start = Instant::now();
                black_box(mill(&mut regional, &Threads(n), vec![region()]));
                least.min(start.elapsed().as_secs_f64())
            })
        };
        let (one, two) = (time(1), time(2));
        println!("  {name}: {one:.3} {two:.3}, {:.2} times", one / two);
    }
    println!(
        "growth: patches, positions a second alone and proved clear, bytes and microseconds a patch"
    );
    for n in [3_u32, 10, 32, 100] {
        let size = 10.0 * f64::from(n);
        let s = sculptured(&rows(n, size, |x, y| height(x % 97.0, y % 97.0)));
        let before = resident();
        let start = Instant::now();
        let tree = PatchTree::new(&s);
        let (made, after) = (start.elapsed().as_secs_f64(), resident());
        let patches = f64::from(n * n);
        let [a, b] = drops(&s, &tree, &cutters()[0].1, 0.9, (size - 12.0).clamp(5.0, 100.0));
        println!(
            "  {patches:6}: {a:9.0} {b:9.0} {:8.0} {:7.2}",
            (after - before) / patches,
            1e6 * made / patches
        );
    }
}
