//! Outputs of other posts beside the CL data from which they were made, compared with ours by motion.

#![expect(clippy::unwrap_used, reason = "test code")]

mod common;

use std::fs;

use aptc_cldata::{Arg, Kind, Motion, MotionKind, Record, RecordReader};
use aptc_geometry::{Vec3, trig};
use aptc_post::{NcReader, PostOptions, machine, post_all};
use common::file_records as read;
use nalgebra::Rotation3;

/// A cut: its end, and the centre when it is an arc.
type Cut = (Vec3, Option<Vec3>);

/// The cuts of a text in order; of several at one place across the tool, as in a hole, the deepest.
fn cuts(text: &str, name: &str) -> Vec<Cut> {
    let mut reader = NcReader::new(machine(name).unwrap(), text.as_bytes());
    let (mut list, mut record, mut rapid) = (Vec::<Cut>::new(), Record::default(), false);
    while reader.read(&mut record).unwrap() {
        match &record.kind {
            Kind::Post { word, .. } if word == "RAPID" => rapid = true,
            Kind::Motion(_) if std::mem::take(&mut rapid) => {}
            Kind::Motion(m) => {
                let (te, center) = (m.points[0].te, m.arc.as_ref().map(|a| a.circle.center));
                match list.last_mut() {
                    Some((last, _)) if center.is_none() && (last.xy() - te.xy()).norm() < 2e-3 => {
                        last.z = last.z.min(te.z);
                    }
                    _ => list.push((te, center)),
                }
            }
            _ => {}
        }
    }
    let faults = reader.into_diagnostics();
    assert!(faults.is_empty(), "{faults:?}");
    list
}

/// The part of a program that one setup cuts: the motions with its tool axis, turned about Z and then tilted about Y
/// so that it is Z.
fn setup(records: &[Record], axis: Vec3) -> Vec<Record> {
    let (rot, tilt) = (trig::atan2(axis.y, axis.x), trig::atan2(axis.xy().norm(), axis.z));
    let turn = Rotation3::new(Vec3::y() * -tilt) * Rotation3::new(Vec3::z() * -rot);
    let here = |m: &Motion| m.points.iter().all(|p| (p.ta - axis).norm() < 1e-3);
    let mut list = Vec::new();
    for record in records {
        let mut record = record.clone();
        if let Kind::Motion(m) = &mut record.kind {
            if !here(m) {
                continue;
            }
            for p in &mut m.points {
                (p.te, p.ta) = (turn * p.te, Vec3::z());
            }
            if let Some(a) = &mut m.arc {
                (a.circle.center, a.circle.axis) = (turn * a.circle.center, turn * a.circle.axis);
            }
        }
        list.push(record);
    }
    list
}

/// The tool axes of a program in the order in which they come.
fn axes(records: &[Record]) -> Vec<Vec3> {
    let mut list: Vec<Vec3> = Vec::new();
    for r in records {
        let Kind::Motion(m) = &r.kind else { continue };
        for p in m.points.iter().filter(|_| m.kind != MotionKind::From) {
            if list.iter().all(|a| (a - p.ta).norm() > 1e-3) {
                list.push(p.ta);
            }
        }
    }
    list
}

/// What no control takes and what their post meant by it.
fn spelled(text: &str) -> String {
    text.replace("CYCLE DEF", "CYCL DEF").replace("L Z ", "L Z")
}

/// The same cuts to the last decimal of their post, three of a millimetre, and of its own input.
#[track_caller]
fn assert_same(name: &str, ours: &[Cut], theirs: &[Cut]) {
    assert_eq!(ours.len(), theirs.len(), "{name}");
    for (i, (a, b)) in ours.iter().zip(theirs).enumerate() {
        let far = match (a.1, b.1) {
            (Some(c), Some(d)) => (c.xy() - d.xy()).norm(),
            (None, None) => 0.0,
            // An arc that bulges by less than the last decimal is a line with us.
            (c, d) => {
                let (from, r) = (ours[i.saturating_sub(1)].0, (c.or(d).unwrap() - a.0).xy().norm());
                let bulge = (a.0 - from).norm_squared() / (8.0 * r);
                if bulge < 5e-4 { 0.0 } else { f64::MAX }
            }
        };
        assert!((a.0 - b.0).norm() < 2e-3 && far < 2e-3, "{name}, cut {i}: {a:?} and {b:?}");
    }
}

#[test]
fn heidenhain_programs_of_another_post() {
    let Some(corpus) = aptc_testkit::shared("post::heidenhain", "corpus/solidworks") else {
        return;
    };
    let folder = fs::read_dir(corpus.join("heidenhain-output")).unwrap();
    let mut files: Vec<_> = folder.map(|f| f.unwrap().path()).collect();
    files.sort();
    let (mut n, mut n_cuts) = (0, 0);
    for file in &files {
        let stem = file.file_stem().unwrap().to_string_lossy().into_owned();
        let (part, number) = stem.rsplit_once('-').unwrap();
        let source = corpus.join(format!("{part}.apt"));
        if !source.exists() {
            continue;
        }
        let records = read(&source);
        // Programs 11 are those of the first setup, 12 and 912 of the second.
        let axis = axes(&records)[usize::from(number.ends_with('2'))];
        let heidenhain = machine("heidenhain-tnc").unwrap();
        let (ours, posted) = post_all(heidenhain, PostOptions::default(), &setup(&records, axis));
        let bad: Vec<_> = posted.diagnostics.iter().filter(|d| d.is_error()).collect();
        assert!(bad.is_empty(), "{stem}: {bad:#?}");
        let theirs = spelled(&String::from_utf8_lossy(&fs::read(file).unwrap()));
        n += 1;
        if theirs.contains("Xnan") {
            // Their post fails where the part lies upside down; no control takes such words, and we do not.
            assert_eq!(stem, "parts-2021-Sacrifice-Board-912");
            let mut reader = NcReader::new(heidenhain, theirs.as_bytes());
            while reader.read(&mut Record::default()).unwrap() {}
            assert!(reader.into_diagnostics().iter().any(|d| d.message.contains("Xnan")));
            continue;
        }
        let ours = cuts(&ours, "heidenhain-tnc");
        assert_same(&stem, &ours, &cuts(&theirs, "heidenhain-tnc"));
        n_cuts += ours.len();
    }
    assert_eq!(n, 15);
    assert!(n_cuts > 13_000, "{n_cuts}");
}

/// A radius and a place along the spindle, with the feed of the cut to it.
type Turned = [f64; 3];

#[test]
fn a_turning_program_of_another_post() {
    let Some(corpus) = aptc_testkit::shared("post::catia", "corpus/catia") else { return };
    // Theirs is a working copy with remarks of all kinds between its blocks, in radii.
    let text = fs::read_to_string(corpus.join("demooutput1.txt")).unwrap();
    let (mut theirs, mut at) = (Vec::<Turned>::new(), [f64::NAN; 3]);
    for line in text.lines() {
        let words: Vec<_> = line.split_whitespace().collect();
        let value = |w: &str| w.get(1..).and_then(|n| n.parse::<f64>().ok());
        if words.is_empty() || words.iter().any(|w| value(w).is_none()) {
            continue;
        }
        let before = at;
        for w in words {
            let i = b"XZF".iter().position(|l| *l == w.as_bytes()[0]);
            if let (Some(i), Some(v)) = (i, value(w)) {
                at[i] = v;
            }
        }
        if before[0].to_bits() != at[0].to_bits() || before[1].to_bits() != at[1].to_bits() {
            theirs.push(at);
        }
    }
    let lathe = machine("linuxcnc-lathe").unwrap();
    let (ours, posted) = post_all(lathe, PostOptions::default(), &read(&corpus.join("DEMO1.txt")));
    assert!(!posted.diagnostics.iter().any(|d| d.is_error()), "{:?}", posted.diagnostics);
    let mut reader = NcReader::new(lathe, ours.as_bytes());
    let (mut list, mut record, mut feed) = (Vec::<Turned>::new(), Record::default(), 0.0);
    while reader.read(&mut record).unwrap() {
        match &record.kind {
            Kind::Post { word, args } if word == "FEDRAT" => {
                if let [Arg::Number(f)] = args.as_slice() {
                    feed = *f;
                }
            }
            Kind::Motion(m) => list.push([m.points[0].te.x, m.points[0].te.z, feed]),
            _ => {}
        }
    }
    // Ours comes from its retracted place across before it goes along; then every block is the same.
    let from = list.len() - theirs.len();
    assert!(from <= 1, "{list:?} {theirs:?}");
    for (a, b) in list[from..].iter().zip(&theirs) {
        assert!((0..3).all(|i| (a[i] - b[i]).abs() < 1e-4), "{a:?} {b:?}");
    }
    assert!(theirs.len() >= 11);
}
