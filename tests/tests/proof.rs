//! The checker checked: paths of the corpus with one mistake each, in two hundred places.

use std::fs;
use std::path::{Path, PathBuf};

use aptc_cldata::{Control, Controlled, Kind, Motion, MotionKind, Record, Relation};
use aptc_control::{Disk, Options, compile};
use aptc_geometry::{Surface, Vec3};
use aptc_verify::{Certificate, Effort, Verifier};

/// Places in which a mistake is made.
const PLACES: usize = 200;

fn programs(folder: &Path, out: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).expect("the corpus is there").flatten() {
        let path = entry.path();
        if path.is_dir() {
            programs(&path, out);
        } else if path.extension().is_some_and(|e| e == "apt") {
            out.push(path);
        }
    }
}

/// Records of Section 2 of each program whose path is proved.
fn paths() -> Vec<Vec<Record>> {
    let corpus = Path::new(env!("CARGO_MANIFEST_DIR")).join("../corpus");
    let mut files = Vec::new();
    for folder in ["mill", "motion", "multiaxis"] {
        programs(&corpus.join(folder), &mut files);
    }
    files.sort();
    let mut out = Vec::new();
    for file in files {
        let source = Disk::open(&file, 1 << 24).expect("it can be read");
        let own = file.parent().expect("it lies in a folder").to_owned();
        let mut world = Disk::new(vec![own], 1 << 24);
        let options = Options { post: false, plot: false, ..Options::default() };
        for part in compile(source, &mut world, &options).parts {
            if part.certificate.is_some_and(|c| c.is_proved() && c.proved > 0) {
                out.push(part.computed.to_vec().expect("they can be read"));
            }
        }
    }
    assert!(out.len() > 5, "the corpus has paths: {}", out.len());
    out
}

fn judge(records: &[Record]) -> Certificate {
    let mut verifier = Verifier::new(Effort::Full);
    for r in records {
        verifier.push(r);
    }
    verifier.finish().0
}

/// Numbers that look random.
struct Dice(u64);

impl Dice {
    fn roll(&mut self, n: usize) -> usize {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        usize::try_from(self.0 >> 33).expect("31 bits") % n
    }
}

fn along(record: &Record) -> Option<(&Motion, &Control)> {
    match &record.kind {
        Kind::Motion(m) if m.kind == MotionKind::Continuous => Some((m, m.control.as_deref()?)),
        _ => None,
    }
}

fn motion(record: &mut Record) -> &mut Motion {
    match &mut record.kind {
        Kind::Motion(m) => m,
        _ => unreachable!("it was one"),
    }
}

fn band(c: &Controlled) -> f64 {
    c.intol + c.outtol
}

/// Normal of the surface near the tool, no longer than its distance would have it.
fn normal(c: &Controlled, te: Vec3) -> Option<Vec3> {
    let surface = Surface::from_form(&c.form)?;
    let foot = surface.foot(te);
    Some(foot.normal)
}

/// What was done wrong, and how deep it must be found.
struct Mistake {
    what: &'static str,
    /// Where, with the farthest that the fault may be from it.
    place: Vec3,
    near: f64,
    /// The least and the greatest depth.
    depth: [f64; 2],
}

/// Makes one of four mistakes in a motion along surfaces; `None` where it would be none.
fn spoil(records: &mut [Record], at: usize, dice: &mut Dice) -> Option<Mistake> {
    let (m, control) = along(&records[at])?;
    let drive = control.drive.clone()?;
    let n = m.points.len();
    let before = records[..at].iter().rev().find_map(|r| match &r.kind {
        Kind::Motion(m) => m.points.last().copied(),
        _ => None,
    })?;
    let step = |i: usize| if i == 0 { before } else { m.points[i - 1] };
    match dice.roll(4) {
        0 => {
            let i = dice.roll(n);
            let te = m.points[i].te;
            let by = 1.5 * band(&drive);
            let away = normal(&drive, te)? * if dice.roll(2) == 0 { by } else { -by };
            let next = m.points.get(i + 1).map_or(te, |p| p.te);
            let near = (te - step(i).te).norm().max((next - te).norm()) + by;
            motion(&mut records[at]).points[i].te += away;
            let depth = [0.4 * by / 1.5, 1.6 * by];
            Some(Mistake { what: "a vertex moved", place: te, near, depth })
        }
        1 => {
            // Inside of a curve whose chords use the band.
            if n < 6 {
                return None;
            }
            let i = 1 + dice.roll(n - 3);
            let (p, q, r) = (step(i).te, m.points[i].te, m.points[i + 1].te);
            let chord = (r - p).normalize();
            let sagitta = ((q - p) - chord * chord.dot(&(q - p))).norm();
            if sagitta < 2.5 * band(&drive)
                || Surface::from_form(&drive.form)?.generator().is_none()
            {
                return None;
            }
            motion(&mut records[at]).points.remove(i);
            let near = (r - p).norm();
            let depth = [0.5 * band(&drive), 2.0 * sagitta];
            Some(Mistake { what: "a vector removed", place: q, near, depth })
        }
        2 => {
            if drive.side == 0 || drive.disk.is_some() {
                return None;
            }
            let by = 4.0 * band(&drive);
            let cutter = records[..at].iter_mut().rev().find_map(|r| match &mut r.kind {
                Kind::Cutter(c) => Some(c),
                _ => None,
            })?;
            cutter.diameter += 2.0 * by;
            cutter.e += by;
            let place = motion(&mut records[at]).points[0].te;
            Some(Mistake {
                what: "a larger tool",
                place,
                near: f64::INFINITY,
                depth: [0.1 * by, f64::INFINITY],
            })
        }
        _ => {
            let check = control.checks.first()?.clone();
            if matches!(check.relation, Relation::Tanto | Relation::Pstan) {
                return None;
            }
            let te = m.points[n - 1].te;
            let way = (te - step(n - 1).te).try_normalize(0.0)?;
            let slope = normal(&check, te)?.dot(&way).abs();
            if slope < 0.5 {
                return None;
            }
            let by = 2.0 * band(&check);
            motion(&mut records[at]).points[n - 1].te += way * (by / slope);
            let depth = [0.4 * by, 3.0 * by];
            Some(Mistake { what: "a check surface overrun", place: te, near: 4.0 * by, depth })
        }
    }
}

#[test]
fn mistakes_in_two_hundred_places_are_refuted() {
    let paths = paths();
    let mut dice = Dice(2026);
    let mut made = [0; 4];
    let names = ["a vertex moved", "a vector removed", "a larger tool", "a check surface overrun"];
    let mut tries = 0;
    while made.iter().sum::<usize>() < PLACES {
        tries += 1;
        assert!(tries < 200_000, "places are found: {made:?}");
        let path = &paths[dice.roll(paths.len())];
        let at = dice.roll(path.len());
        let mut records = path.clone();
        let Some(mistake) = spoil(&mut records, at, &mut dice) else { continue };
        let kind = names.iter().position(|n| *n == mistake.what).expect("a kind");
        if made[kind] >= PLACES / 2 {
            continue;
        }
        made[kind] += 1;
        let c = judge(&records);
        let origin = &path[at].origin;
        assert!(c.refuted > 0, "{}: {origin:?}", mistake.what);
        // Of the faults one lies there and is as deep.
        let [least, most] = mistake.depth;
        let found = c.statements.iter().filter_map(|s| s.fault.as_ref()).any(|f| {
            let away = (Vec3::from(f.te) - mistake.place).norm();
            f.refuted && away <= mistake.near && (least..=most).contains(&f.depth)
        });
        let faults: Vec<_> = c.statements.iter().filter_map(|s| s.fault.as_ref()).collect();
        assert!(
            found,
            "{} at {:?} within {}, depth {least} to {most}: {faults:?}",
            mistake.what, mistake.place, mistake.near
        );
    }
    assert!(made.iter().all(|n| *n >= 5), "every kind: {made:?}");
}
