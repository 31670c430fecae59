//! Each of the ways in which CL text says "arc", and the arc forms that are written.

#![expect(clippy::unwrap_used, reason = "a test: it fails")]

use aptc_cldata::number::Decimals;
use aptc_cldata::{
    Arc, CatiaWriter, Course, Dialect, Kind, Motion, MotionKind, Reader, Record, RecordReader,
    RecordWriter, TextOptions, TextWriter, Units, diff, flatten,
};
use aptc_geometry::{Circle, Vec3};

fn read(text: &str, dialect: Option<Dialect>) -> Vec<Record> {
    let mut reader = Reader::open(text.as_bytes(), dialect).unwrap();
    let mut record = Record::default();
    let mut out = Vec::new();
    while reader.read(&mut record).unwrap() {
        out.push(record.clone());
    }
    let said = reader.into_diagnostics();
    assert!(!said.iter().any(aptc_diagnostics::Diagnostic::is_error), "{said:?}\n{text}");
    out
}

/// The last motion and the position before it. Arcs on one circle after one another count as one.
fn last_arc(records: &[Record]) -> (Motion, aptc_cldata::Position) {
    let mut motions: Vec<Motion> = records
        .iter()
        .filter_map(|r| match &r.kind {
            Kind::Motion(m) => Some(m.clone()),
            _ => None,
        })
        .collect();
    let sweep = |m: &Motion| match m.arc.map(|a| (a.course, a.circle)) {
        Some((Course::Sweep(s), circle)) => Some((s, circle)),
        _ => None,
    };
    while let [.., a, b] = motions.as_slice()
        && let (Some((s, circle)), Some((t, same))) = (sweep(a), sweep(b))
        && circle == same
    {
        let mut whole = b.clone();
        whole.arc = Some(Arc { circle, course: Course::Sweep(s + t) });
        motions.truncate(motions.len() - 2);
        motions.push(whole);
    }
    let [.., before, last] = motions.as_slice() else { panic!("two motions") };
    (last.clone(), *before.points.last().unwrap())
}

/// From (10, 0, 2) to (0, 10, 2) about (0, 0), anticlockwise: 90 degrees on the radius 10.
fn is_quarter(text: &str, dialect: Option<Dialect>) {
    is_arc(text, dialect, Vec3::z(), 90.0, Vec3::new(0.0, 10.0, 2.0));
}

fn is_arc(text: &str, dialect: Option<Dialect>, axis: Vec3, angle: f64, end: Vec3) {
    let (m, start) = last_arc(&read(text, dialect));
    let arc = m.arc.unwrap_or_else(|| panic!("no arc in\n{text}"));
    let last = m.points.last().unwrap().te;
    assert!((last - end).norm() < 1e-3, "{last}\n{text}");
    let c = arc.circle;
    assert!((c.radius - 10.0).abs() < 1e-3, "{}\n{text}", c.radius);
    for p in [start.te, last] {
        let arm = p - c.center;
        assert!(((arm - c.axis * c.axis.dot(&arm)).norm() - c.radius).abs() < 1e-3, "{text}");
    }
    match arc.course {
        Course::Sweep(s) => {
            assert!((c.axis - axis).norm() < 1e-9, "{}\n{text}", c.axis);
            assert!((s - angle).abs() < 1e-2, "{s}\n{text}");
        }
        Course::Chords => assert!(m.points.len() > 1, "{text}"),
    }
}

#[test]
fn circle_in_a_part_surface_to_a_plane() {
    // IBM's APT and NCL.
    is_quarter(
        "GOTO/10,0,2\nPSIS/(PLANE/0,0,1,2)\nINDIRV/0,1,0\n\
         TLON,GOFWD/(CIRCLE/CANON,0,0,0,0,0,1,10),ON,(PLANE/1,0,0,0)\n",
        None,
    );
    is_quarter(
        "GOTO/10,0,2\nINDIRP/10,5,2\nTLON,GOFWD/(CIRCLE/CANON,0,0,0,0,0,-1,10),ON,1,INTOF,$\n\
         (PLANE/1,0,0,0)\n",
        None,
    );
    // The second crossing is on the other side.
    is_arc(
        "GOTO/10,0,2\nINDIRV/0,1,0\n\
         TLON,GOFWD/(CIRCLE/CANON,0,0,0,0,0,1,10),ON,2,INTOF,(PLANE/1,0,0,0)\n",
        None,
        Vec3::z(),
        270.0,
        Vec3::new(0.0, -10.0, 2.0),
    );
}

#[test]
fn cylinder_to_a_plane() {
    // CATIA V4, in the zx plane: from x to z about -y.
    is_arc(
        "GOTO/10,0,0\nPSIS/(PLANE/0,1,0,0)\nINDIRV/0,0,1\n\
         TLON,GOFWD/(CYLNDR/0,0,0,0,1,0,10),ON,$\n\
         (PLANE/PERPTO,(PLANE/0,1,0,0),(POINT/0,0,0),(POINT/0,0,10))\n",
        None,
        -Vec3::y(),
        90.0,
        Vec3::new(0.0, 0.0, 10.0),
    );
}

#[test]
fn circle_to_a_line() {
    // CATIA V5, with its blanks and continuations.
    is_quarter(
        "GOTO  /   10.00000,    0.00000,    2.00000\nAUTOPS\nINDIRV/   0.00000,   1.00000,   0.00000\n\
         TLON,GOFWD/      (CIRCLE/      0.00000,      0.00000,      2.00000,$\n     10.00000),ON,\
         (LINE/      0.00000,      0.00000,      2.00000,$\n      0.00000,     10.00000,      2.00000)\n",
        Some(Dialect::Catia),
    );
    // A lathe: the circle lies in the zx plane though its start is as high as its centre.
    is_arc(
        "GOTO/20,0,-10\nINDIRV/0,0,-1\nTLON,GOFWD/(CIRCLE/30,0,-10,$\n10),ON,(LINE/30,0,-10,30,0,-20)\n",
        Some(Dialect::Catia),
        -Vec3::y(),
        90.0,
        Vec3::new(30.0, 0.0, -20.0),
    );
    // More than half a turn: the second crossing; the other sense.
    is_arc(
        "GOTO/10,0,2\nINDIRV/0,-1,0\nTLON,GOFWD/(CIRCLE/0,0,2,10),ON,2,INTOF,$\n\
         (LINE/0,0,2,0,10,2)\n",
        Some(Dialect::Catia),
        -Vec3::z(),
        270.0,
        Vec3::new(0.0, 10.0, 2.0),
    );
    // A full circle ends where it began.
    is_arc(
        "GOTO/10,0,2\nINDIRV/0,1,0\nTLON,GOFWD/(CIRCLE/0,0,2,10),ON,2,INTOF,(LINE/0,0,2,10,0,2)\n",
        Some(Dialect::Catia),
        Vec3::z(),
        360.0,
        Vec3::new(10.0, 0.0, 2.0),
    );
    // Creo's APT format has the motion word on a line of its own.
    is_quarter(
        "GOTO / 10, 0, 2\nINDIRV / 0, 1, 0\nTLON\nGOFWD / (CIRCLE / 0, 0, 2, 10), ON, \
         (LINE / 0, 0, 2, 0, 10, 2)\n",
        Some(Dialect::Creo),
    );
    // ComputerVision: tangent to a plane through the end.
    is_quarter(
        "GOTO/10,0,2\nINDIRV/0,1,0\nTLON,GOFWD/(CIRCLE/CANON,0,0,2,0,0,1,10),TANTO,(PLANE/0,1,0,10)\n",
        None,
    );
}

#[test]
fn circle_before_points() {
    // Creo and PTED: the points without GOTO belong to it, the next GOTO does not.
    let text = "GOTO / 10, 0, 2\nCIRCLE / 0, 0, 2, 0, 0, 1, 10\nGOTO / 7.0710678, 7.0710678, 2\n\
                0, 10, 2\n";
    is_quarter(text, Some(Dialect::Creo));
    let more = format!("{text}GOTO / 0, 30, 2\n");
    let records = read(&more, Some(Dialect::Creo));
    let Kind::Motion(m) = &records.last().unwrap().kind else { panic!("motion") };
    assert!(m.arc.is_none() && m.points.len() == 1);
    // Also one that goes straight across the circle.
    let across = read(&format!("{text}GOTO / -10, 0, 2\n"), Some(Dialect::Creo));
    let Kind::Motion(m) = &across.last().unwrap().kind else { panic!("motion") };
    assert!(m.arc.is_none() && m.points.len() == 1);
    let across = read("GOTO/10,0,2\nCIRCLE/0,0,2,0,0,1,10\nGOTO/0,10,2\nGOTO/-10,0,2\n", None);
    let Kind::Motion(m) = &across.last().unwrap().kind else { panic!("motion") };
    assert!(m.arc.is_none() && m.points.len() == 1);
    // The end alone: right-handed about the plane vector.
    is_quarter("GOTO/10,0,2\nCIRCLE/0,0,2,0,0,1,10\nGOTO/0,10,2\n", None);
    is_arc(
        "GOTO/10,0,2\nCIRCLE/0,0,2,0,0,-1,10\nGOTO/0,10,2\n",
        None,
        -Vec3::z(),
        270.0,
        Vec3::new(0.0, 10.0, 2.0),
    );
    is_quarter("GOTO/10,0,2\nCIRCLE/0,0,2,10\nGOTO/0,10,2\n", None);
}

#[test]
fn arcdat_and_its_move() {
    let arcdat = "GOTO/10,0,2\nARCDAT/0,0,2,0,0,1,10\n";
    is_quarter(&format!("{arcdat}ARCMOV/CCLW,0,10,2,90\n"), None);
    is_arc(
        &format!("{arcdat}ARCMOV/CLW,0,10,2,270\n"),
        None,
        -Vec3::z(),
        270.0,
        Vec3::new(0.0, 10.0, 2.0),
    );
    is_quarter(&format!("{arcdat}CONT/0,10,2\n"), None);
}

#[test]
fn cw_and_ccw() {
    is_quarter("GOTO/10,0,2\nCCW/0,0,1,10,0,2,0,0,2,0,10,2,10\n", None);
    is_arc(
        "GOTO/10,0,2\nCW/0,0,1,10,0,2,0,0,2,0,10,2,10\n",
        None,
        -Vec3::z(),
        270.0,
        Vec3::new(0.0, 10.0, 2.0),
    );
}

#[test]
fn circle_in_a_comment() {
    is_quarter(
        "OUTTOL/.5\nGOTO/10,0,2\n$$ CIRCLE/ 0, 0, 2, 0, 0, 1, 10\nGOTO/7.0710678,7.0710678,2\n\
         GOTO/0,10,2\n",
        None,
    );
    let marked = "$$ LINE 1\nGOTO/10,0,2\n$$ LINE 2\n$$ CIRCLE 0,0,2,0,0,1,10\n\
                  GOTO/7.08,7.08,2\nGOTO/0,10,2\n";
    is_quarter(marked, None);
}

#[test]
fn nx_circle_is_clockwise_about_its_axis() {
    let nx = |axis: &str, more: &str| {
        format!("GOTO/10,0,2\nCIRCLE/0,0,2,{axis},10,0.06,0.5,40,1{more}\nGOTO/0,10,2\n")
    };
    is_quarter(&nx("0,0,-1", ""), Some(Dialect::Nx));
    let end = Vec3::new(0.0, 10.0, 2.0);
    is_arc(&nx("0,0,1", ""), Some(Dialect::Nx), -Vec3::z(), 270.0, end);
    is_arc(&nx("0,0,-1", ",TIMES,2"), Some(Dialect::Nx), Vec3::z(), 450.0, end);
}

#[test]
fn camworks_circle_has_no_radius() {
    is_quarter("GOTO/10.,0,2.\nCIRCLE/0,0,2.,0,0,1.\nGOTO/0,10.,2.\n", Some(Dialect::Camworks));
    is_arc(
        "GOTO/10.,0,2.\nCIRCLE/0,0,2.,0,0,-1.\nGOTO/0,10.,2.\n",
        Some(Dialect::Camworks),
        -Vec3::z(),
        270.0,
        Vec3::new(0.0, 10.0, 2.0),
    );
}

#[test]
fn movarc() {
    is_quarter("GOTO/10,0,2\nMOVARC/0, 0, 2, 0, 0, 1, 10, ANGLE, 90\nGOTO/0,10,2\n", None);
    is_arc(
        "GOTO/10,0,2\nMOVARC/0,0,2,0,0,1,10,ANGLE,-270\nGOTO/0,10,2\n",
        None,
        -Vec3::z(),
        270.0,
        Vec3::new(0.0, 10.0, 2.0),
    );
    is_quarter(
        "GOTO/ 10, 0, 2\nMOVARC/ CENTER, 0, 0, 2, AXIS, 0, 0, 1, RADIUS, 10\nGOTO/ 0, 10, 2\n",
        Some(Dialect::Dmg),
    );
    // A helix: the end is at another height.
    is_arc(
        "GOTO/10,0,2\nMOVARC/0,0,2,0,0,1,10,ANGLE,810\nGOTO/0,10,-7\n",
        None,
        Vec3::z(),
        810.0,
        Vec3::new(0.0, 10.0, -7.0),
    );
}

#[test]
fn goclw_and_helical() {
    is_quarter("GOTO/10,0,2\nGOCCLW/0,0,2,0,0,1,10,0,10,2\n", None);
    is_arc(
        "GOTO/10,0,2\nGOCLW/0,0,2,0,0,1,10,0,10,2\n",
        None,
        -Vec3::z(),
        270.0,
        Vec3::new(0.0, 10.0, 2.0),
    );
    is_arc(
        "GOTO/10,0,2\nHELICAL/0,0,2,0,1,0,0,0,1,450,10,0,10,-4\n",
        Some(Dialect::Catia),
        Vec3::z(),
        450.0,
        Vec3::new(0.0, 10.0, -4.0),
    );
}

/// Arcs of all kinds, as records.
fn arcs() -> Vec<Record> {
    let mut out = vec![Kind::Units(Units::Mm)];
    let p = |x, y, z| aptc_cldata::Position::upright(Vec3::new(x, y, z));
    let goto = |q| Motion { points: vec![q], ..Motion::default() };
    let arc = |axis: Vec3, sweep: f64, end| {
        let circle = Circle { center: Vec3::new(1.0, 2.0, 3.0), axis, radius: 5.0 };
        let arc = Some(Arc { circle, course: Course::Sweep(sweep) });
        Motion { arc, points: vec![end], ..Motion::default() }
    };
    let start = p(6.0, 2.0, 3.0);
    for (axis, sweep, end) in [
        (Vec3::z(), 90.0, p(1.0, 7.0, 3.0)),
        (Vec3::z(), 180.0, p(-4.0, 2.0, 3.0)),
        (-Vec3::z(), 270.0, p(1.0, 7.0, 3.0)),
        (Vec3::z(), 360.0, p(6.0, 2.0, 3.0)),
        (Vec3::z(), 450.0, p(1.0, 7.0, -1.0)),
        (-Vec3::y(), 90.0, p(1.0, 2.0, 8.0)),
        (Vec3::y(), 270.0, p(1.0, 2.0, 8.0)),
    ] {
        out.push(Kind::Motion(Motion { kind: MotionKind::From, ..goto(start) }));
        out.push(Kind::Motion(arc(axis, sweep, end)));
    }
    out.into_iter().map(|kind| Record { kind, ..Record::default() }).collect()
}

#[test]
fn written_arcs_are_the_same_ways() {
    let text = |records: &[Record]| {
        let mut w = TextWriter::new(Vec::new(), TextOptions::default());
        records.iter().for_each(|r| w.write(r).unwrap());
        w.into_inner().unwrap()
    };
    let original = arcs();
    let expected = text(&original);
    let mut catia = CatiaWriter::new(Vec::new(), Decimals::Shortest);
    original.iter().for_each(|r| catia.write(r).unwrap());
    let catia = catia.into_inner().unwrap();
    let shown = String::from_utf8(catia.clone()).unwrap();
    assert!(shown.lines().all(|l| l.len() <= 72), "{shown}");
    assert!(shown.contains("TLON,GOFWD/") && shown.contains("HELICAL/"), "{shown}");
    for bytes in [expected.clone(), catia] {
        let mut a = Reader::open(expected.as_slice(), Some(Dialect::Iso)).unwrap();
        let mut b = Reader::open(bytes.as_slice(), None).unwrap();
        let d = diff::diff(&mut a, &mut b, 1e-6).unwrap();
        assert!(d.is_same(), "{}\n{}", d.text(), String::from_utf8_lossy(&bytes));
        let same = d.lengths[0] - d.lengths[1];
        assert!(same.abs() < 1e-6, "{}", d.text());
    }
    let back = read(&shown, None);
    let n = |list: &[Record]| {
        let arc = |r: &&Record| matches!(&r.kind, Kind::Motion(m) if m.arc.is_some());
        list.iter().filter(arc).count()
    };
    assert_eq!(n(&back), n(&original));
    let length = |list: &[Record]| {
        let mut last = None;
        let mut sum = 0.0;
        for r in list {
            let Kind::Motion(m) = &r.kind else { continue };
            for p in flatten::positions(m, last, 1e-4) {
                sum += last.map_or(0.0, |l: aptc_cldata::Position| (p.te - l.te).norm());
                last = Some(p);
            }
        }
        sum
    };
    assert!((length(&back) - length(&original)).abs() < 1e-6);
}
