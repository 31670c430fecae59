//! LinuxCNC's interpreter on the machine code of every program of the corpus: it accepts it, and the tool goes
//! where the CL data say.

use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};

use aptc_cldata::{Arg, Kind, MotionKind, Record, Units};
use aptc_control::{Compiled, Disk, Options};
use aptc_golden::{Case, discover};
use aptc_testkit::repository;
use aptc_tests::rs274::{Call, interpret};

/// What the interpreter prints its own numbers with.
const PRINTED: f64 = 0.000_051;

fn compile(case: &Case) -> Compiled {
    let source = Disk::open(&case.program, 1 << 24).expect("the program can be read");
    let mut world = Disk::new(case.include_folders(), 1 << 24);
    aptc_control::compile(source, &mut world, &Options { plot: false, ..Options::default() })
}

/// A place that the tool comes to.
struct Stop {
    line: u32,
    at: [f64; 3],
    /// FROM only says where the tool is.
    must: bool,
}

/// The ends of motions in CL data: all points, of a circle the last one, and of a hole its bottom.
fn stops(records: &[Record]) -> Vec<Stop> {
    let (mut stops, mut depth, mut earlier) = (Vec::new(), None, None);
    for record in records {
        match &record.kind {
            Kind::Post { word, args } if word == "CYCLE" => {
                let on = args.first() == Some(&Arg::Word("ON".into()));
                depth = if on { earlier } else { cycle_depth(args) };
                earlier = depth.or(earlier);
            }
            Kind::Motion(motion) => {
                let skipped =
                    if motion.arc.is_some() { motion.points.len().saturating_sub(1) } else { 0 };
                for point in motion.points.iter().skip(skipped) {
                    let (line, te) = (record.origin.line, point.te);
                    // Across three axes a hole is down along Z.
                    let at = [te.x, te.y, te.z - depth.unwrap_or(0.0)];
                    stops.push(Stop { line, at, must: motion.kind != MotionKind::From });
                }
            }
            _ => {}
        }
    }
    stops
}

fn cycle_depth(args: &[Arg]) -> Option<f64> {
    let at = args.iter().position(|arg| *arg == Arg::Word("DEPTH".into()))?;
    match args.get(at + 1) {
        Some(Arg::Number(depth)) => Some(*depth),
        _ => None,
    }
}

/// Where a canonical motion ends, in the coordinates of the part: a table that turns about X carries it, or one
/// about X that carries one about Z.
fn end(call: &Call) -> Option<[f64; 3]> {
    let n = &call.numbers;
    let (at, a, c) = match (call.name.as_str(), n.len()) {
        ("STRAIGHT_TRAVERSE" | "STRAIGHT_FEED", 6..) => ([n[0], n[1], n[2]], n[3], n[5]),
        // G17: the ends in X and Y, the centre, the turn, the end in Z.
        ("ARC_FEED", 9..) => ([n[0], n[1], n[5]], n[6], n[8]),
        _ => return None,
    };
    let back = |degrees: f64, [u, v]: [f64; 2]| {
        let (s, c) = (libm::sin(-degrees.to_radians()), libm::cos(degrees.to_radians()));
        [c * u - s * v, s * u + c * v]
    };
    let [y, z] = back(a, [at[1], at[2]]);
    let [x, y] = back(c, [at[0], y]);
    Some([x, y, z])
}

/// Runs the machine code and holds its motions against the CL data.
fn hold(rs274: &Path, case: &Case, folder: &Path) -> Result<usize, String> {
    let compiled = compile(case);
    let mut n = 0;
    for (part, number) in compiled.parts.iter().zip(1..) {
        for nc in part.nc.iter().filter(|nc| nc.machine.name.starts_with("linuxcnc")) {
            let file = folder.join(format!("part{number}.ngc"));
            let text = nc.text.to_vec().map_err(|error| error.to_string())?;
            fs::write(&file, text).map_err(|error| error.to_string())?;
            let calls = interpret(rs274, &file)?;
            // A lathe's axes are others: there only that the control accepts it.
            if !nc.machine.name.contains("lathe") {
                let records = part.edited.to_vec().map_err(|error| error.to_string())?;
                n += same_ends(&calls, &records)?;
            }
        }
    }
    Ok(n)
}

fn same_ends(calls: &[Call], records: &[Record]) -> Result<usize, String> {
    let inches = records.iter().find_map(|r| match r.kind {
        Kind::Units(units) => Some(units == Units::Inches),
        _ => None,
    });
    // Half a unit of the last digit of a block, turned by half of one of A and of C at the arm's length.
    let resolution = if inches.unwrap_or(true) { 0.000_005 } else { 0.000_05 };
    let turns = calls.iter().any(|call| call.numbers.get(3).is_some_and(|a| *a != 0.0));
    let arm = if turns { 200.0 * 0.000_05_f64.to_radians() } else { 0.0 };
    let near = resolution + PRINTED + arm;
    let same = |a: &[f64; 3], b: &[f64; 3]| a.iter().zip(b).all(|(a, b)| (a - b).abs() <= near);
    let ends: Vec<[f64; 3]> = calls.iter().filter_map(end).collect();
    let stops = stops(records);
    let mut rest = ends.as_slice();
    for stop in stops.iter().filter(|stop| stop.must) {
        match rest.iter().position(|end| same(end, &stop.at)) {
            // What was reached may be the next stop too: motions of no length are left out of machine code.
            Some(at) => rest = &rest[at..],
            None => return Err(format!("line {}: {:?} is not reached", stop.line, stop.at)),
        }
    }
    // And no cut goes elsewhere: down to a hole it begins at the clearance above it.
    for call in calls.iter().filter(|call| call.name != "STRAIGHT_TRAVERSE") {
        let Some(end) = end(call) else { continue };
        let above = |stop: &Stop| {
            (0..2).all(|i| (end[i] - stop.at[i]).abs() <= near) && end[2] >= stop.at[2] - near
        };
        // Where a table turns, the post-processor sets positions between, on the straight line.
        let mut pairs = stops.windows(2);
        let between = turns && pairs.any(|p| distance(&end, &p[0].at, &p[1].at) <= near);
        if !between && !stops.iter().any(|stop| same(&end, &stop.at) || above(stop)) {
            return Err(format!("{end:?} is no position of the CL data"));
        }
    }
    Ok(stops.len())
}

/// Distance of a point from a straight line between two others.
fn distance(p: &[f64; 3], a: &[f64; 3], b: &[f64; 3]) -> f64 {
    let sum = |f: &dyn Fn(usize) -> f64| (0..3).map(f).sum::<f64>();
    let length = sum(&|i| (b[i] - a[i]) * (b[i] - a[i])).max(1e-12);
    let t = (sum(&|i| (p[i] - a[i]) * (b[i] - a[i])) / length).clamp(0.0, 1.0);
    sum(&|i| (p[i] - a[i] - t * (b[i] - a[i])).powi(2)).sqrt()
}

#[test]
fn the_control_goes_where_the_cl_data_go() {
    let test = "control::the_control_goes_where_the_cl_data_go";
    let Some(rs274) = aptc_testkit::client(test, "rs274") else { return };
    let cases = discover(&repository().join("corpus"), "").expect("the corpus can be read");
    let good: Vec<Case> =
        cases.into_iter().filter(|case| case.goldens.join("program.nc").is_file()).collect();
    let (mut faults, mut n_stops) = (String::new(), 0);
    for case in &good {
        let folder = tempfile::tempdir().expect("a folder");
        match hold(&rs274, case, folder.path()) {
            Ok(n) => n_stops += n,
            Err(fault) => writeln!(faults, "{}: {fault}", case.name).expect("a string takes all"),
        }
    }
    assert!(faults.is_empty(), "{faults}");
    assert!(good.len() >= 15 && n_stops > 500, "{} programs, {n_stops} positions", good.len());
}

#[test]
fn a_wrong_position_is_seen_and_a_broken_file_is_refused() {
    let test = "control::a_wrong_position_is_seen_and_a_broken_file_is_refused";
    let Some(rs274) = aptc_testkit::client(test, "rs274") else { return };
    let cases = discover(&repository().join("corpus"), "mill/wedge").expect("the corpus");
    let compiled = compile(&cases[0]);
    let part = &compiled.parts[0];
    let records = &part.edited.to_vec().expect("they can be read");
    let text = part.nc[0].text.to_vec().expect("it can be read");
    let text = String::from_utf8(text).expect("machine code is text");
    let folder = tempfile::tempdir().expect("a folder");
    let run = |text: &str| -> Result<Vec<Call>, String> {
        let file: PathBuf = folder.path().join("a.ngc");
        fs::write(&file, text).expect("it is written");
        interpret(&rs274, &file)
    };
    assert!(same_ends(&run(&text).expect("it is accepted"), records).is_ok());
    for (right, wrong) in [("X106", "X106.0002"), ("Y66", "Y66 Z3")] {
        assert!(text.contains(right), "{text}");
        let calls = run(&text.replacen(right, wrong, 1)).expect("it is accepted");
        assert!(same_ends(&calls, records).is_err(), "{wrong}");
    }
    for (right, wrong) in [("F300", ""), ("M30", ""), ("X106", "X106 Q"), ("G1 ", "G1 G2 ")] {
        assert!(text.contains(right), "{text}");
        assert!(run(&text.replacen(right, wrong, 1)).is_err(), "{wrong} was accepted");
    }
}
