//! Files of the optional folder of test data beside the repository: nothing of a motion is lost.

#![expect(
    clippy::unwrap_used,
    clippy::print_stdout,
    reason = "a test: it fails, and says what it skips"
)]

use std::fs;
use std::path::{Path, PathBuf};

use aptc_cldata::{Course, Dialect, Kind, MotionKind, Reader, Record, RecordReader, Units};
use aptc_geometry::Vec3;

fn shared(path: &str) -> PathBuf {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../../../shared")).join(path)
}

/// Files of a folder with one of the endings, in order of their names.
fn files(folder: &str, endings: &[&str]) -> Vec<PathBuf> {
    let Ok(list) = fs::read_dir(shared(folder)) else {
        println!("skipped: {folder} is not there");
        return Vec::new();
    };
    let mut list: Vec<_> = list.map(|f| f.unwrap().path()).collect();
    list.retain(|p| endings.iter().any(|e| p.to_string_lossy().ends_with(e)));
    list.sort();
    list
}

fn read(path: &Path) -> (Dialect, Vec<Record>, Vec<String>) {
    let mut reader = Reader::open(fs::File::open(path).unwrap(), None).unwrap();
    let dialect = reader.dialect();
    let mut record = Record::default();
    let mut out = Vec::new();
    while reader.read(&mut record).unwrap() {
        out.push(record.clone());
    }
    let said = reader.into_diagnostics().into_iter();
    (dialect, out, said.map(|d| format!("{}: {}", d.code, d.message)).collect())
}

/// Motion points by another way than the readers go: lines are joined at `$`, a point is a GOTO or FROM
/// with numbers, or a line of numbers after one; NURBS and circular moves to a line count one each.
fn count(text: &str) -> usize {
    let mut statements = Vec::new();
    let mut pending = String::new();
    for line in text.lines() {
        // Creo's comments with data go on like statements.
        let line = if line.starts_with("$$->") { line } else { line.split("$$").next().unwrap() };
        let line = line.trim();
        if let Some(body) = line.strip_suffix('$') {
            pending.push_str(body);
            continue;
        }
        pending.push_str(line);
        statements.push(std::mem::take(&mut pending));
    }
    let number = |s: &str| s.trim().parse::<f64>().is_ok();
    let (mut n, mut after_goto) = (0, false);
    for s in statements.iter().map(|s| s.trim()).filter(|s| !s.is_empty()) {
        let (head, rest) = s.split_once('/').unwrap_or((s, ""));
        let head: String = head.split_whitespace().collect::<String>().to_uppercase();
        let is_goto = matches!(head.as_str(), "GOTO" | "FROM");
        let bare = after_goto && s.split(',').filter(|f| !f.trim().is_empty()).all(number);
        if (is_goto && rest.split(',').take(3).all(number)) || bare || head == "NURBS" {
            n += 1;
        }
        after_goto = is_goto || bare;
    }
    n
}

#[test]
fn no_motion_of_the_corpora_is_lost() {
    let mut n_files = 0;
    for (folder, endings, dialect) in [
        ("corpus/catia", &["DEMO1.txt", "DEMO2.txt", "DEMO3.txt"][..], Dialect::Catia),
        ("corpus/nx", &[".cls", ".clsf"], Dialect::Nx),
        ("corpus/creo", &[".ncl", ".ncl.1"], Dialect::Creo),
        ("corpus/solidworks", &[".apt"], Dialect::Camworks),
        ("corpus/ncl", &[".as"], Dialect::Ncl),
    ] {
        for path in files(folder, endings) {
            n_files += 1;
            let name = path.file_name().unwrap().to_string_lossy().into_owned();
            let bytes = fs::read(&path).unwrap();
            let (found, records, said) = read(&path);
            assert_eq!(found, dialect, "{name}");
            let motions = || {
                records.iter().filter_map(|r| match &r.kind {
                    Kind::Motion(m) => Some(m),
                    _ => None,
                })
            };
            let n: usize = motions().map(|m| if is_spline(m) { 1 } else { m.points.len() }).sum();
            assert_eq!(n, count(&String::from_utf8_lossy(&bytes)), "{name}");
            assert!(!said.iter().any(|s| s.contains("APT3001")), "{name}: {said:?}");
            println!("{name}: {n} points; {said:?}");
            let units = records.iter().find_map(|r| match r.kind {
                Kind::Units(u) => Some(u),
                _ => None,
            });
            check_arcs(&name, &records, units.unwrap_or_default());
        }
    }
    println!("{n_files} files");
}

/// Chords that were not in the file as points: those of a spline.
fn is_spline(m: &aptc_cldata::Motion) -> bool {
    m.points.len() > 1 && m.arc.is_none()
}

/// Start and end of each arc lie on its circle within 1e-3 mm, or within the decimals of the file.
fn check_arcs(name: &str, records: &[Record], units: Units) {
    let mut last: Option<Vec3> = None;
    let mut n = 0;
    for r in records {
        let Kind::Motion(m) = &r.kind else { continue };
        if let Some(arc) = &m.arc {
            n += 1;
            let c = arc.circle;
            let off = |p: Vec3| {
                let arm = p - c.center;
                ((arm - c.axis * c.axis.dot(&arm)).norm() - c.radius).abs() * units.mm()
            };
            let end = m.points.last().unwrap().te;
            let worst = off(last.unwrap()).max(off(end));
            assert!(worst <= 1.1e-3, "{name} line {}: off by {worst}", r.origin.line);
            if let Course::Sweep(s) = arc.course {
                assert!(s > 0.0 && s <= 1080.0);
            }
        }
        last = m.points.last().map(|p| p.te);
    }
    println!("{name}: {n} arcs");
}

#[test]
fn tapes_of_apt_360_read_to_the_points_of_their_json() {
    for path in files("oracle/apt360", &[".cl.tap"]) {
        let name = path.file_name().unwrap().to_string_lossy().into_owned();
        let json = path.with_file_name(name.replace(".cl.tap", ".json"));
        let json: serde_json::Value =
            serde_json::from_str(&fs::read_to_string(json).unwrap()).unwrap();
        let (dialect, records, said) = read(&path);
        assert_eq!(dialect, Dialect::Tape, "{name}");
        assert!(said.is_empty(), "{name}: {said:?}");
        let ours: Vec<_> = records
            .iter()
            .filter_map(|r| match &r.kind {
                Kind::Motion(m) => Some((r.origin.isn, m)),
                _ => None,
            })
            .collect();
        let theirs: Vec<_> = json
            .as_array()
            .unwrap()
            .iter()
            .filter(|r| matches!(r["kind"].as_str(), Some("from" | "goto")))
            .collect();
        assert_eq!(ours.len(), theirs.len(), "{name}");
        for ((isn, m), r) in ours.iter().zip(theirs) {
            // Their numbers of statements read from unnumbered cards may be negative.
            assert_eq!(i64::from(*isn), r["isn"].as_i64().unwrap().abs(), "{name}");
            assert_eq!(m.kind == MotionKind::From, r["kind"] == "from");
            let points = r["points"].as_array().unwrap();
            assert_eq!(m.points.len(), points.len(), "{name} statement {isn}");
            for (p, q) in m.points.iter().zip(points) {
                let x = |i: usize| q[i].as_f64().unwrap();
                // The oracle's decoder takes a double whose bytes are characters for a text and says 0.
                let zero = |own: f64, theirs: f64| {
                    let text = own.to_le_bytes().iter().all(|b| (32..127).contains(b));
                    if text && theirs == 0.0 { own } else { theirs }
                };
                let q_te = Vec3::new(zero(p.te.x, x(0)), zero(p.te.y, x(1)), zero(p.te.z, x(2)));
                let far = (p.te - q_te).norm();
                assert!(far < 1e-9, "{name} statement {isn}: {p:?} {q}");
                assert_eq!(m.with_axis, q.as_array().unwrap().len() == 6);
                if m.with_axis {
                    assert!((p.ta - Vec3::new(x(3), x(4), x(5))).norm() < 1e-9, "{name}");
                }
            }
        }
        let posts = records
            .iter()
            .filter(|r| matches!(r.kind, Kind::Post { .. } | Kind::Text { .. } | Kind::Edit(_)));
        let theirs = json.as_array().unwrap().iter().filter(|r| r["kind"] == "post").count();
        // CUTTER/OPTION has no record of its own kind.
        let posts =
            posts.filter(|r| !matches!(&r.kind, Kind::Post { word, .. } if word == "CUTTER"));
        assert_eq!(posts.count(), theirs, "{name}");
    }
}
