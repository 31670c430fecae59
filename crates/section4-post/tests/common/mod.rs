//! Short programs of CL data for tests, and LinuxCNC's stand-alone interpreter as a client.
#![allow(dead_code, unreachable_pub, reason = "each test file uses a part of it")]
#![expect(clippy::unwrap_used, reason = "test code")]

use std::path::Path;
use std::process::Command;
use std::sync::atomic::{AtomicU32, Ordering};

use aptc_cldata::{
    Arc, Arg, Course, Kind, Motion, MotionKind, Position, Reader, Record, RecordReader, Units,
};
use aptc_diagnostics::Origin;
use aptc_geometry::{Circle, Cutter, Vec3};
use aptc_post::{PostOptions, Posted, machine, post_all};

/// Records of lines such as `GOTO/1,2,3`, `SPINDL/3000,CLW`, `PPRINT text`.
///
/// `ARC/x,y,z,i,j,k,r,sweep` makes the next GOTO an arc of that sweep; `CHORDS/x,y,z,i,j,k,r` makes it one
/// of chords (its points may be given as `GOTO/x,y,z;x,y,z;..`).
pub fn records(text: &str) -> Vec<Record> {
    let mut list = Vec::new();
    let mut arc = None;
    for (i, line) in text.lines().enumerate() {
        let line = line.trim();
        if line.is_empty() {
            continue;
        }
        let n = u32::try_from(i + 1).unwrap();
        let origin = Origin { line: n, isn: n, ..Origin::default() };
        let kind = statement(line, &mut arc);
        if let Some(kind) = kind {
            list.push(Record { origin, kind });
        }
    }
    list
}

fn numbers(text: &str) -> Vec<f64> {
    text.split(',').map(|n| n.trim().parse().unwrap_or_else(|_| panic!("number {n}"))).collect()
}

fn statement(line: &str, arc: &mut Option<Arc>) -> Option<Kind> {
    for word in ["PARTNO", "PPRINT", "INSERT"] {
        if let Some(text) = line.strip_prefix(word) {
            return Some(Kind::Text { word: word.into(), text: text.trim().into() });
        }
    }
    let (word, rest) = line.split_once('/').unwrap_or((line, ""));
    Some(match word {
        "UNITS" => Kind::Units(if rest == "MM" { Units::Mm } else { Units::Inches }),
        "CUTTER" => {
            let v = numbers(rest);
            Kind::Cutter(Cutter::mill(v[0], v.get(1).copied().unwrap_or(0.0), 50.0))
        }
        "INTOL" => Kind::Intol([rest.parse().unwrap(); 4]),
        "OUTTOL" => Kind::Outtol([rest.parse().unwrap(); 4]),
        "MULTAX" => Kind::Multax(true),
        "FINI" => Kind::Fini,
        "ARC" | "CHORDS" => {
            let v = numbers(rest);
            let circle = Circle {
                center: Vec3::new(v[0], v[1], v[2]),
                axis: Vec3::new(v[3], v[4], v[5]),
                radius: v[6],
            };
            let course = if word == "ARC" { Course::Sweep(v[7]) } else { Course::Chords };
            *arc = Some(Arc { circle, course });
            return None;
        }
        "GOTO" | "FROM" | "GOFWD" => {
            let points = rest.split(';').map(|p| {
                let v = numbers(p);
                let te = Vec3::new(v[0], v[1], v[2]);
                let ta =
                    if v.len() == 6 { Vec3::new(v[3], v[4], v[5]).normalize() } else { Vec3::z() };
                Position { te, ta }
            });
            let kind = match word {
                "FROM" => MotionKind::From,
                "GOTO" => MotionKind::Goto,
                _ => MotionKind::Continuous,
            };
            Kind::Motion(Motion {
                kind,
                points: points.collect(),
                arc: arc.take(),
                ..Motion::default()
            })
        }
        _ => {
            let args = rest.split(',').map(str::trim).filter(|a| !a.is_empty());
            let arg = |a: &str| a.parse().map_or_else(|_| Arg::Word(a.into()), Arg::Number);
            Kind::Post { word: word.into(), args: args.map(arg).collect() }
        }
    })
}

/// The records of a CL file of any dialect.
pub fn file_records(path: &Path) -> Vec<Record> {
    let mut reader = Reader::open(std::fs::File::open(path).unwrap(), None).unwrap();
    let mut list = Vec::new();
    let mut record = Record::default();
    while reader.read(&mut record).unwrap() {
        list.push(record.clone());
    }
    list
}

/// Points of chords of an arc in a plane across Z, vertices on the circle.
pub fn chords(c: [f64; 3], r: f64, from_deg: f64, sweep_deg: f64, n: u32, rise: f64) -> String {
    let point = |i: u32| {
        let part = f64::from(i) / f64::from(n);
        let a = (from_deg + sweep_deg * part).to_radians();
        let (s, co) = (aptc_geometry::trig::sin(a), aptc_geometry::trig::cos(a));
        format!("{},{},{}", c[0] + r * co, c[1] + r * s, c[2] + rise * part)
    };
    let points: Vec<String> = (1..=n).map(point).collect();
    format!("CHORDS/{},{},{},0,0,1,{r}\nGOFWD/{}\n", c[0], c[1], c[2], points.join(";"))
}

/// The text and findings for a machine.
pub fn post(name: &str, text: &str) -> (String, Posted) {
    let machine = machine(name).unwrap_or_else(|| panic!("machine {name}"));
    post_all(machine, PostOptions::default(), &records(text))
}

/// The text for a machine; no errors allowed.
pub fn good(name: &str, text: &str) -> String {
    let (nc, posted) = post(name, text);
    let errors: Vec<_> = posted.diagnostics.iter().filter(|d| d.is_error()).collect();
    assert!(errors.is_empty(), "{errors:#?}\n{nc}");
    nc
}

/// Codes of the errors.
pub fn errors(name: &str, text: &str) -> Vec<String> {
    let (_, posted) = post(name, text);
    posted.diagnostics.iter().filter(|d| d.is_error()).map(|d| d.code.to_string()).collect()
}

/// One canonical call of the interpreter: its name and numbers.
#[derive(Clone, Debug)]
pub struct Canon {
    pub name: String,
    pub numbers: Vec<f64>,
}

static RUN: AtomicU32 = AtomicU32::new(0);

/// Runs LinuxCNC's interpreter. `None` when it is not installed; then the test says so and is content.
pub fn rs274(nc: &str) -> Option<Result<Vec<Canon>, String>> {
    let thread = std::thread::current();
    aptc_testkit::client(thread.name().unwrap_or("post"), "rs274")?;
    let n = RUN.fetch_add(1, Ordering::Relaxed);
    let dir = std::env::temp_dir().join(format!("aptc-post-{}-{n}", std::process::id()));
    std::fs::create_dir_all(&dir).unwrap();
    let result = run_in(&dir, nc);
    std::fs::remove_dir_all(&dir).unwrap();
    Some(result)
}

fn run_in(dir: &Path, nc: &str) -> Result<Vec<Canon>, String> {
    let file = |name: &str| dir.join(name);
    std::fs::write(file("p.ngc"), nc).unwrap();
    std::fs::write(file("var"), "").unwrap();
    let tools: String = (1..=99).map(|t| format!("T{t} P{t} D0.2 Z+0\n")).collect();
    std::fs::write(file("tool.tbl"), tools).unwrap();
    // The interpreter keeps its tools in a file of the home folder: each run needs a home of its own.
    let out = Command::new("rs274")
        .env("HOME", dir)
        .args(["-g", "-n", "2", "-t"])
        .arg(file("tool.tbl"))
        .arg("-v")
        .arg(file("var"))
        .arg(file("p.ngc"))
        .output()
        .unwrap();
    let text = String::from_utf8_lossy(&out.stdout).into_owned();
    let err = String::from_utf8_lossy(&out.stderr).replace("executing", "");
    let ended = text.contains("PROGRAM_END");
    if !out.status.success() || !err.trim().is_empty() || !ended {
        return Err(format!("{}: {err}", out.status));
    }
    let call = |line: &str| {
        let line = line.trim_start().split_once("N.....")?.1.trim();
        let (name, rest) = line.split_once('(')?;
        let numbers = rest
            .trim_end_matches(')')
            .split([',', ' '])
            .filter_map(|n| n.trim().parse().ok())
            .collect();
        Some(Canon { name: name.trim().to_string(), numbers })
    };
    Ok(text.lines().filter_map(call).collect())
}

/// End points of all motion, in order, with the kind of motion.
pub fn ends(canon: &[Canon]) -> Vec<(String, [f64; 3])> {
    canon
        .iter()
        .filter_map(|c| {
            let v = &c.numbers;
            let p = match c.name.as_str() {
                "STRAIGHT_TRAVERSE" | "STRAIGHT_FEED" => [v[0], v[1], v[2]],
                // Arcs of the XY plane: end, centre, turns, end along the axis.
                "ARC_FEED" => [v[0], v[1], v[5]],
                _ => return None,
            };
            Some((c.name.clone(), p))
        })
        .collect()
}

/// Asserts that the motion reaches all the points in order; other points may lie between.
#[track_caller]
pub fn assert_reaches(ends: &[(String, [f64; 3])], points: &[[f64; 3]], tol: f64) {
    let mut at = 0;
    for p in points {
        let near = |q: &[f64; 3]| (0..3).all(|i| (p[i] - q[i]).abs() <= tol);
        match ends[at..].iter().position(|(_, q)| near(q)) {
            Some(n) => at += n,
            None => panic!("{p:?} is not reached after motion {at}: {:?}", &ends[at..]),
        }
    }
}
