//! What APT-360's CL editor makes of INDEX, COPY and TRACUT, and pictures of real files.

#![expect(
    clippy::unwrap_used,
    clippy::print_stdout,
    reason = "a test: it fails, and says what it skips"
)]

use std::fs;
use std::path::{Path, PathBuf};

use aptc_cldata::{Edit, Kind, Reader, Record, RecordReader};
use aptc_edit::{Editor, plot_svg};

fn shared(path: &str) -> PathBuf {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../../../shared")).join(path)
}

fn read(path: &Path) -> Option<Vec<Record>> {
    let Ok(file) = fs::File::open(path) else {
        println!("skipped: {} is not there", path.display());
        return None;
    };
    let mut reader = Reader::open(file, None).unwrap();
    let mut record = Record::default();
    let mut out = Vec::new();
    while reader.read(&mut record).unwrap() {
        out.push(record.clone());
    }
    Some(out)
}

/// The oracle's tape holds the original motion, after TRACUT, and the copies. The originals before it are
/// had back by the inverse of TRACUT and by leaving the copies out; editing them must give the tape again.
#[test]
fn editing_agrees_with_apt_360() {
    for name in ["square", "race_4th", "test"] {
        let Some(tape) = read(&shared(&format!("oracle/apt360/{name}.cl.tap"))) else { continue };
        let mut original: Vec<Record> = Vec::new();
        let mut tracut = None;
        let mut closed: Vec<f64> = Vec::new();
        let mut in_copy = false;
        for record in &tape {
            match &record.kind {
                Kind::Edit(Edit::Index { n, close: false }) => {
                    in_copy = closed.iter().any(|c| (c - n).abs() < 0.5);
                }
                Kind::Edit(Edit::Index { n, close: true }) if !in_copy => closed.push(*n),
                Kind::Edit(Edit::Copy { .. }) => in_copy = false,
                Kind::Edit(Edit::Tracut(m)) => tracut = *m,
                _ => {}
            }
            if in_copy {
                continue;
            }
            let mut record = record.clone();
            if let (Kind::Motion(m), Some(map)) = (&mut record.kind, &tracut) {
                let back = map.inverse().unwrap();
                for p in &mut m.points {
                    p.te = back.point(p.te);
                    if m.with_axis {
                        p.ta = back.vector(p.ta).normalize();
                    }
                }
                m.arc = None;
            }
            original.push(record);
        }
        let mut editor = Editor::new();
        let mut edited: Vec<Record> = Vec::new();
        for r in &original {
            editor.push(r, &mut edited).unwrap();
        }
        editor.finish(&mut edited).unwrap();
        let said = editor.take_diagnostics();
        assert!(said.iter().all(|d| !d.is_error()), "{said:?}");
        assert_eq!(edited.len(), tape.len(), "{name}");
        let mut n = 0;
        for (a, b) in edited.iter().zip(&tape) {
            // The tape gives the last statement's number to what stands between two copies.
            if matches!(a.kind, Kind::Motion(_)) {
                assert_eq!(a.origin.isn, b.origin.isn, "{name}");
            }
            let (Kind::Motion(x), Kind::Motion(y)) = (&a.kind, &b.kind) else {
                let kind = std::mem::discriminant;
                assert_eq!(kind(&a.kind), kind(&b.kind), "{name}");
                continue;
            };
            assert_eq!(x.points.len(), y.points.len());
            for (p, q) in x.points.iter().zip(&y.points) {
                n += 1;
                // APT-360 turns degrees to radians with a constant that is good to 1e-8.
                assert!((p.te - q.te).norm() < 2e-6, "{name} {:?}: {p:?} {q:?}", a.origin.isn);
                assert!((p.ta - q.ta).norm() < 2e-6, "{name}");
            }
        }
        println!("{name}: {n} points agree");
    }
}

#[test]
fn real_files_can_be_drawn() {
    for path in [
        "oracle/apt360/race_4th.cl.tap",
        "oracle/apt360/square.cl.tap",
        "corpus/nx/_1_KONTUR_NAR_40_N2.cls",
        "corpus/solidworks/parts-tools-wall-holes.apt",
        "corpus/creo/finition.head.ncl",
    ] {
        let Some(records) = read(&shared(path)) else { continue };
        let svg = plot_svg(&records);
        assert!(svg.len() < 4 << 20 && svg.ends_with("</svg>\n"));
        assert!(!svg.contains("NaN") && !svg.contains("inf "));
        if let Some(folder) = std::env::var_os("PLOT_FOLDER") {
            let name = Path::new(path).file_name().unwrap();
            fs::write(Path::new(&folder).join(name).with_extension("svg"), svg).unwrap();
        }
    }
}
