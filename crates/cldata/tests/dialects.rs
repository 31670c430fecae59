//! What only one CAM system says, read for what it means.

#![expect(clippy::unwrap_used, reason = "a test: it fails")]

use aptc_cldata::{Arg, Dialect, Kind, Motion, Reader, Record, RecordReader, Units};
use aptc_geometry::Vec3;

fn read(text: &str, dialect: Dialect) -> Vec<Kind> {
    let mut reader = Reader::open(text.as_bytes(), Some(dialect)).unwrap();
    let mut record = Record::default();
    let mut out = Vec::new();
    while reader.read(&mut record).unwrap() {
        out.push(record.kind.clone());
    }
    let said = reader.into_diagnostics();
    assert!(!said.iter().any(aptc_diagnostics::Diagnostic::is_error), "{said:?}");
    out
}

fn motions(kinds: &[Kind]) -> Vec<&Motion> {
    kinds
        .iter()
        .filter_map(|k| match k {
            Kind::Motion(m) => Some(m),
            _ => None,
        })
        .collect()
}

fn post(word: &str, args: Vec<Arg>) -> Kind {
    Kind::Post { word: word.into(), args }
}

fn word(w: &str) -> Arg {
    Arg::Word(w.into())
}

#[test]
fn nx_keeps_the_axis_until_it_changes() {
    let kinds = read(
        "TOOL PATH/A_1,TOOL,MILL\nTLDATA/MILL,20.0000,2.0000,75.0000,0.0000,0.0000\n\
         MSYS/1,2,3,1,0,0,0,1,0\nPAINT/PATH\nLOAD/TOOL,3,ADJUST,2\nSELECT/TOOL,4\n\
         GOTO/0,0,10,0,1,0\nGOTO/0,0,0\nGOTO/0,0,5,0,0,1\n1,2,3\nFEDRAT/MMPM,600.\nEND-OF-PATH\n",
        Dialect::Nx,
    );
    assert!(matches!(kinds[0], Kind::Comment(_)));
    assert!(kinds.contains(&Kind::Units(Units::Mm)));
    let axes: Vec<Vec3> = motions(&kinds).iter().map(|m| m.points[0].ta).collect();
    assert_eq!(axes, [Vec3::y(), Vec3::y(), Vec3::z(), Vec3::z()]);
    assert_eq!(motions(&kinds)[3].points[0].te, Vec3::new(1.0, 2.0, 3.0));
    let cutter = kinds.iter().find_map(|k| match k {
        Kind::Cutter(c) => Some(c.values()),
        _ => None,
    });
    assert_eq!(cutter, Some([20.0, 2.0, 8.0, 2.0, 0.0, 0.0, 75.0]));
    assert!(
        kinds.iter().any(|k| matches!(k, Kind::Csys(m) if m.shift == Vec3::new(1.0, 2.0, 3.0)))
    );
    let loadtl = post("LOADTL", vec![Arg::Number(3.0), word("ADJUST"), Arg::Number(2.0)]);
    assert!(kinds.contains(&loadtl) && kinds.contains(&post("SELCTL", vec![Arg::Number(4.0)])));
}

#[test]
fn nx_splines_end_at_their_last_control_point() {
    let kinds = read(
        "FEDRAT/MMPM,1.\nGOTO/0,0,0\nNURBS/\nKNOT/1.0000000\nCNTRL/0,4,0\nCNTRL/4,4,0\nCNTRL/4,0,0\n\
         PAINT/COLOR,31\nGOTO/9,9,9\n",
        Dialect::Nx,
    );
    let m = motions(&kinds);
    assert_eq!(m.len(), 3);
    assert_eq!(m[1].points.last().unwrap().te, Vec3::new(4.0, 0.0, 0.0));
    // Chords within 5 micrometres of the curve: through its middle at (2, 3).
    let near = m[1].points.iter().map(|p| (p.te - Vec3::new(2.0, 3.0, 0.0)).norm());
    assert!(near.fold(f64::INFINITY, f64::min) < 0.1 && m[1].points.len() > 20);
}

/// A point without its word is a point, whatever stands between it and the last one.
#[test]
fn nx_points_without_goto_behind_other_words() {
    let text = "TOOL PATH/A,TOOL,B\nTLDATA/MILL,10.0,0.0,75.0,0.0,0.0\nRAPID\nGOTO/0.0,0.0,50.0,0.0,0.0,1.0\n\
                RAPID\n0.0,0.0,3.0\nFEDRAT/MMPM,250.0\n0.0,0.0,-1.0\n-5.0,0.0,-1.0\nEND-OF-PATH\n";
    let mut reader = Reader::open(text.as_bytes(), Some(Dialect::Nx)).unwrap();
    let (mut record, mut points) = (Record::default(), Vec::new());
    while reader.read(&mut record).unwrap() {
        if let Kind::Motion(m) = &record.kind {
            points.extend(m.points.iter().map(|p| (p.te.x, p.te.z)));
        }
    }
    assert_eq!(points, [(0.0, 50.0), (0.0, 3.0), (0.0, -1.0), (-5.0, -1.0)]);
    assert!(reader.into_diagnostics().iter().all(|d| !d.message.contains("not known")));
}

#[test]
fn catia_matrix_and_tool_axis() {
    let kinds = read(
        "$$     CATIA APT VERSION 1.0\n$$*CATIA0\n$$ Part Operation.1\n\
         $$     1.00000     0.00000     0.00000     5.00000\n\
         $$     0.00000    -1.00000     0.00000     0.00000\n\
         $$     0.00000     0.00000    -1.00000    60.00000\nPARTNO Part\nMULTAX\n\
         CUTTER/ 16.000000,  0.000000,  8.000000,  0.000000,  0.000000,$\n         0.000000, 80.000000\n\
         TLAXIS/ 0.000000, 0.000000, 1.000000\nFEDRAT/  100.0000,MMPM\nGOTO  /    1.0,  2.0,  3.0\n\
         TLAXIS/ 1.000000, 0.000000, 0.000000\nGOTO  /    1.0,  2.0,  4.0\n",
        Dialect::Catia,
    );
    let frame = kinds.iter().find_map(|k| match k {
        Kind::Csys(m) => Some(m.rows()),
        _ => None,
    });
    assert_eq!(frame, Some([1.0, 0.0, 0.0, 5.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, -1.0, 60.0]));
    let cutter = kinds.iter().find_map(|k| match k {
        Kind::Cutter(c) => Some((c.diameter, c.height)),
        _ => None,
    });
    assert_eq!(cutter, Some((16.0, 80.0)));
    let m = motions(&kinds);
    assert_eq!((m[0].points[0].ta, m[1].points[0].ta), (Vec3::z(), Vec3::x()));
    assert!(m[1].with_axis && kinds.contains(&Kind::Multax(true)));
}

#[test]
fn creo_says_tool_and_frame_in_comments() {
    let comments = "$$*          Pro/CLfile  Version 11.0\n$$-> CUTTER / 0.500000\n\
                    $$-> CSYS / 1.0, 0.0, 0.0, 7.0,  $\n            0.0, 1.0, 0.0, 0.0,  $\n     \
                    0.0, 0.0, 1.0, 0.0\n";
    let remarks = "REMARK -> CUTTER / 0.5\nREMARK -> CSYS / 1,0,0,7,0,1,0,0,0,0,1,0\n";
    for head in [comments, remarks] {
        let text = format!("UNITS / INCHES\n{head}PPWORD/STEP,66\nGOTO / 1, 2, $\n 3\n");
        let kinds = read(&text, Dialect::Creo);
        assert!(
            kinds.iter().any(|k| matches!(k, Kind::Cutter(c) if (c.diameter - 0.5).abs() < 1e-12)),
            "{head}"
        );
        assert!(
            kinds.iter().any(|k| matches!(k, Kind::Csys(m) if (m.shift.x - 7.0).abs() < 1e-12)),
            "{head}"
        );
        assert!(!kinds.iter().any(|k| matches!(k, Kind::Post { word, .. } if word == "PPWORD")));
        assert_eq!(motions(&kinds)[0].points[0].te, Vec3::new(1.0, 2.0, 3.0));
    }
}

#[test]
fn creo_gives_an_axis_only_where_it_is_not_z() {
    let kinds =
        read("UNITS/MM\nMULTAX / ON\nGOTO / 0, 0, 0, 1, 0, 0\nGOTO / 1, 0, 0\n", Dialect::Creo);
    let m = motions(&kinds);
    assert_eq!(m[1].points[0].ta, Vec3::z());
    assert!(m[1].with_axis);
}

#[test]
fn camworks_words_have_slashes_and_inserts_are_remarks() {
    let kinds = read(
        "PARTNO/1\nUNIT/MM\nINSERT/12.0mm JOBBER DRILL\nLOAD/TOOL,11\nRAPID/\nGOTO/26.,24.,25.\n\
         GOTO/1,2,3,0,0,-1.\nGOTO/4,5,6\n",
        Dialect::Camworks,
    );
    assert!(
        kinds.contains(&Kind::Text { word: "PPRINT".into(), text: "12.0mm JOBBER DRILL".into() })
    );
    assert!(kinds.contains(&post("RAPID", vec![])));
    assert!(kinds.contains(&post("LOADTL", vec![Arg::Number(11.0)])));
    let axes: Vec<Vec3> = motions(&kinds).iter().map(|m| m.points[0].ta).collect();
    assert_eq!(axes, [Vec3::z(), -Vec3::z(), Vec3::z()]);
}

#[test]
fn joined_words_and_text_statements() {
    let kinds = read(
        "PARTNO/ 'A B'\nunits/mm\nINSERTG0G49\nPPRINT cost $5 $$ all of it\nRAPID,GOTO/1,2,3\n\
         SPINDL/ 1000., RPM, clw $$ fast\n",
        Dialect::Iso,
    );
    let text = |w: &str, t: &str| Kind::Text { word: w.into(), text: t.into() };
    assert_eq!(kinds[0], text("PARTNO", "A B"));
    assert_eq!(kinds[2], text("INSERT", "G0G49"));
    assert_eq!(kinds[3], text("PPRINT", "cost $5 $$ all of it"));
    assert_eq!(kinds[4], post("RAPID", vec![]));
    assert_eq!(motions(&kinds)[0].points[0].te, Vec3::new(1.0, 2.0, 3.0));
    let spindl = post("SPINDL", vec![Arg::Number(1000.0), word("RPM"), word("CLW")]);
    assert_eq!(kinds[6..], [spindl, Kind::Comment(" fast".into())]);
}

#[test]
fn positions_under_multax_keep_their_axis_and_lose_it_after() {
    let kinds = read(
        "UNITS/MM\nMULTAX/ON\nGOTO/0,0,0,0,1,0\nGODLTA/2\nGODLTA/1,0,0\nMULTAX/OFF\nGOTO/5,5,5\n",
        Dialect::Iso,
    );
    let m = motions(&kinds);
    assert_eq!(m[1].points[0].te, Vec3::new(0.0, 2.0, 0.0));
    assert_eq!((m[2].points[0].te, m[2].points[0].ta), (Vec3::new(1.0, 2.0, 0.0), Vec3::y()));
    assert!(!m[3].with_axis && m[3].points[0].ta == Vec3::z());
}
