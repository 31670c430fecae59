//! How statements lie in files: cases of letters, columns, continuations, encodings; and the statements
//! that only one CAM system writes.

#![expect(clippy::unwrap_used, reason = "a test: it fails")]

use aptc_cldata::{Arg, Course, Dialect, Kind, Motion, Reader, Record, RecordReader};
use aptc_geometry::{Vec3, trig};

/// The records, and what was said.
fn read_bytes(bytes: &[u8], dialect: Option<Dialect>) -> (Vec<Record>, Vec<String>) {
    let mut reader = Reader::open(bytes, dialect).unwrap();
    let mut record = Record::default();
    let mut out = Vec::new();
    while reader.read(&mut record).unwrap() {
        out.push(record.clone());
    }
    let said = reader.into_diagnostics();
    assert!(!said.iter().any(aptc_diagnostics::Diagnostic::is_error), "{said:?}");
    (out, said.into_iter().map(|d| format!("{} {}", d.code, d.message)).collect())
}

fn read(text: &str, dialect: Option<Dialect>) -> Vec<Kind> {
    read_bytes(text.as_bytes(), dialect).0.into_iter().map(|r| r.kind).collect()
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

fn places(kinds: &[Kind]) -> Vec<[f64; 3]> {
    let points = motions(kinds).into_iter().flat_map(|m| &m.points);
    points.map(|p| [p.te.x, p.te.y, p.te.z]).collect()
}

fn args<'a>(kinds: &'a [Kind], of: &str) -> Option<&'a [Arg]> {
    kinds.iter().find_map(|k| match k {
        Kind::Post { word, args } if word == of => Some(args.as_slice()),
        _ => None,
    })
}

fn word(w: &str) -> Arg {
    Arg::Word(w.into())
}

fn number(x: f64) -> Arg {
    Arg::Number(x)
}

const PLACES: [[f64; 3]; 3] = [[1.0, 2.0, 3.0], [150.0, -0.25, 3.0], [7.0, 8.0, 9.0]];

/// The same program in every way that lines, letters and numbers can be written.
#[test]
fn the_same_points_in_every_writing() {
    let card = |n: u32, text: &str| format!("{text:<72}PRT{n:05}\n");
    let record = |n: u32, text: &str| format!("{n:8}{text}\n");
    let cards: String = ["UNITS/MM", "GOTO/1,2,3", "GOTO/1.5D2,$", "-.25,3.", "GOTO/7,8,9", "FINI"]
        .iter()
        .zip(1..)
        .map(|(t, n)| card(n, t))
        .collect();
    let records: String =
        ["UNITS/MM", "GOTO/1,2,3", "GOTO/150,$", "  -.25,3.", "GOTO/7,8,9", "FINI"]
            .iter()
            .zip(1..)
            .map(|(t, n)| record(10 * n, t))
            .collect();
    let plain = "UNITS/MM\nGOTO/1,2,3\nGOTO/150,-0.25,3\nGOTO/7,8,9\nFINI\n";
    let wide = |big: bool| -> Vec<u8> {
        let units = std::iter::once(0xfeff).chain(plain.encode_utf16());
        units.flat_map(|u| if big { u.to_be_bytes() } else { u.to_le_bytes() }).collect()
    };
    let texts = [
        plain.to_owned(),
        plain.to_lowercase(),
        plain.replace('\n', "\r\n"),
        plain.replace('\n', "\r"),
        plain.replace("GOTO", "\u{c}GOTO"),
        plain.replace("GOTO/", "\tGOTO\t/\t").replace(',', "\t,\t"),
        plain.replace("GOTO/", "Goto  /    ").replace(',', " , "),
        plain.replace('\n', "\n\n\n"),
        plain.replace("3\n", "3 $$ a note\n"),
        plain.replace("150,-0.25", "1.5E+02,$\n -2.5E-01"),
        plain.replace("150,-0.25", "+150. , $ $$ a note\n - .25").replace("- .25", "-.25"),
        plain.replace("150,-0.25", "0.15d3,-25D-2"),
        plain.replace(",3\nGOTO/7", ",3,\n7"),
        plain.replace("\nGOTO/150", "\n150").replace("\nGOTO/7", "\n7"),
        plain.trim_end().to_owned(),
        format!("\u{feff}{plain}"),
        format!("{plain}\u{1a}"),
        cards.clone(),
        cards.replace('\n', "\r\n"),
        records,
    ];
    let bytes = texts.into_iter().map(String::into_bytes).chain([wide(false), wide(true)]);
    for text in bytes {
        let shown = String::from_utf8_lossy(&text).into_owned();
        let (records, said) = read_bytes(&text, None);
        let kinds: Vec<Kind> = records.into_iter().map(|r| r.kind).collect();
        assert_eq!(places(&kinds), PLACES, "{shown}\n{said:?}");
        assert!(said.is_empty(), "{shown}\n{said:?}");
        assert_eq!(kinds.last(), Some(&Kind::Fini), "{shown}");
    }
}

/// Each holemaking statement keeps all its arguments in order.
#[test]
fn cycles_of_all_systems() {
    let forms: [(&str, &str, usize); 14] = [
        ("CYCLE/DRILL,RAPTO,3.0000,FEDTO,-33.0043,RTRCTO,AUTO,MMPM,250.0000", "DRILL", 9),
        ("CYCLE/DRILL,DEEP,RAPTO,3.,FEDTO,-10.,STEP,1.,2.,3.,MMPM,250.", "DRILL", 12),
        ("CYCLE/BORE,BACK,RAPTO,3.0,FEDTO,-10.0,DWELL,1.5", "BORE", 8),
        ("CYCLE / DRILL, DEPTH, 20.0, MMPM, 200, CLEAR, 2.0, RETURN, 5.0", "DRILL", 9),
        ("CYCLE / DEEP, DEPTH, 20.0, STEP, 4, MMPM, 200, CLEAR, 2.0, RAPTO, 1.0", "DEEP", 11),
        ("CYCLE / BRKCHP, DEPTH, 9, STEP, 1, IPM, 5, CLEAR, .1, DWELL, 2, TIMES, 3", "BRKCHP", 13),
        ("CYCLE / TAP, 20.0, 1.25, MMPR, 24, 2.0", "TAP", 6),
        ("CYCLE/DRILL, 60.206665, 1.000000, 0.400000,MMPR", "DRILL", 5),
        ("CYCLE/DRILL, 10, MMPM, 300, 5, RAPTO, 2, DWELL, 0.5", "DRILL", 9),
        ("CYCLE/ DRILL, DEPTH, 5, PERMIN, 100, CLEAR, 2, RETURN, 2", "DRILL", 9),
        ("CYCLE/DEEP2,FEDTO,9.,MMPM,100.,RAPTO,2.,1STPECK,3.,SUBPECK,1.,DWELL,0", "DEEP2", 13),
        ("CYCLE/INIT", "INIT", 1),
        ("CYCLE/ON", "ON", 1),
        ("CYCLE / OFF", "OFF", 1),
    ];
    for (text, mode, n) in forms {
        let (records, said) = read_bytes(format!("UNITS/MM\n{text}\n").as_bytes(), None);
        let kinds: Vec<Kind> = records.into_iter().map(|r| r.kind).collect();
        let args = args(&kinds, "CYCLE").unwrap();
        assert_eq!((&args[0], args.len()), (&word(mode), n), "{text}");
        assert!(args.iter().all(|a| !matches!(a, Arg::Text(_))), "{text}");
        assert!(said.is_empty(), "{said:?}");
    }
}

#[test]
fn words_without_a_slash() {
    let kinds = read(
        "UNITS/MM\nCHANNEL,1\nNEXTTL, 5\nOPNAME 'first cut'\nSYNC/1,2,1,\nRAPID,STOP\nHe said, 5\n",
        Some(Dialect::Dmg),
    );
    assert_eq!(args(&kinds, "CHANNEL"), Some([number(1.0)].as_slice()));
    assert_eq!(args(&kinds, "NEXTTL"), Some([number(5.0)].as_slice()));
    assert_eq!(args(&kinds, "OPNAME"), Some([Arg::Text("first cut".into())].as_slice()));
    assert_eq!(args(&kinds, "SYNC").unwrap()[..3], [1.0, 2.0, 1.0].map(number));
    assert!(args(&kinds, "STOP").is_some());
    assert_eq!(kinds.last(), Some(&Kind::Unread("He said, 5".into())));
}

#[test]
fn dmg_names_its_frame_by_couplets() {
    let kinds = read(
        "UNITS/ MM\nMCSYS/ NUM, 2, POINT, 1, 2, 3, VECTOR, 0, 1, 0, VECTOR, -1, 0, 0\n\
         LOAD/ TOOL, 4, 'mill'\nARCSLP/ 2\nGOTO/ 0, 0, 0\n",
        Some(Dialect::Dmg),
    );
    assert_eq!(args(&kinds, "MCSYS"), Some([word("NUM"), number(2.0)].as_slice()));
    let frame = kinds.iter().find_map(|k| match k {
        Kind::Csys(m) => Some(m.rows()),
        _ => None,
    });
    let rows = [0.0, -1.0, 0.0, 1.0, 1.0, 0.0, 0.0, 2.0, 0.0, 0.0, 1.0, 3.0];
    assert_eq!(frame, Some(rows));
    let loadtl = [number(4.0), Arg::Text("mill".into())];
    assert_eq!(args(&kinds, "LOADTL"), Some(loadtl.as_slice()));
}

#[test]
fn statement_numbers_of_the_source_are_origins() {
    let (records, _) =
        read_bytes(b"UNITS/MM\nISN/ 7\nGOTO/1,2,3\nISN/12\nGOTO/4,5,6\n", Some(Dialect::Ncl));
    let isn: Vec<u32> = records
        .iter()
        .filter(|r| matches!(r.kind, Kind::Motion(_)))
        .map(|r| r.origin.isn)
        .collect();
    assert_eq!(isn, [7, 12]);
}

#[test]
fn other_words_for_motion() {
    let text = "UNITS/MM\nFROM/0,0,9\nMOVE/1,2,3\nCONT/4,5,6\nGT/7,8,9\nGODLTA/1\nGODLTA/1,1,1\n";
    let expected = [
        [0.0, 0.0, 9.0],
        [1.0, 2.0, 3.0],
        [4.0, 5.0, 6.0],
        [7.0, 8.0, 9.0],
        [7.0, 8.0, 10.0],
        [8.0, 9.0, 11.0],
    ];
    assert_eq!(places(&read(text, None)), expected);
}

#[test]
fn an_axis_from_tlaxis_holds_until_the_next() {
    let kinds = read(
        "UNITS/MM\nGOTO/0,0,0\nTLAXIS/1,0,0\nGOTO/1,0,0\nGOTO/2,0,0\nTLAXIS/0,0,1\nGOTO/3,0,0\nFINI\n\
         UNITS/MM\nGOTO/4,0,0\n",
        Some(Dialect::Iso),
    );
    let axes: Vec<Vec3> = motions(&kinds).iter().map(|m| m.points[0].ta).collect();
    assert_eq!(axes, [Vec3::z(), Vec3::x(), Vec3::x(), Vec3::z(), Vec3::z()]);
}

#[test]
fn creo_splines_are_had_by_their_points() {
    let kinds = read(
        "$$*          Pro/CLfile  Version 11.0\nUNITS / MM\nGOTO / 0, 0, 0\nMOVNRB / M3AXIS\n\
         MOVNRB/ON,4,8,0,4,30.5\nMOVNRB/1,0,0,0,0,1,1,1,1\nMOVNRB/2,0,0,0,1,5,0,$\n 9,5,0,10,0,0\n\
         MOVNRB / NEXT\nGOTO / 5, 3, 0\nGOTO / 10, 0, 0\nMOVNRB/OFF\nDEFSUB / 1\nENDSUB\nCALSUB / 1\n",
        None,
    );
    assert_eq!(places(&kinds), [[0.0; 3], [5.0, 3.0, 0.0], [10.0, 0.0, 0.0]]);
    assert!(args(&kinds, "MOVNRB").is_none() && args(&kinds, "CALSUB").is_some());
}

/// The angles of the arcs, each with the height of its axis.
fn arcs(kinds: &[Kind]) -> Vec<(f64, f64)> {
    let arc = |m: &&Motion| match m.arc.map(|a| (a.course, a.circle.axis.z)) {
        Some((Course::Sweep(s), z)) => Some((s, z)),
        _ => None,
    };
    motions(kinds).iter().filter_map(arc).collect()
}

fn close(a: &[(f64, f64)], b: &[(f64, f64)]) -> bool {
    a.len() == b.len()
        && a.iter().zip(b).all(|(p, q)| (p.0 - q.0).abs() < 1e-6 && (p.1 - q.1).abs() < 1e-9)
}

/// Creo's thread milling: an orbit a statement, the end straight above the start.
#[test]
fn orbits_are_full_turns() {
    let kinds = read(
        "UNITS / INCHES\nGOTO / 8.198, 0, -.625\nCIRCLE / 8.0, 0.0, -0.625, $ $$ 1ST ORBIT\n\
         0.0, 0.0, 1.0, 0.198\nGOTO / 8.198, 0, -0.583333\nFEDRAT / 12.0, IPM\n\
         CIRCLE / 8.0, 0.0, -0.583333, $ $$ 2ND ORBIT\n0.0, 0.0, 1.0, 0.198\nGOTO / 8.198, 0, -0.541667\n",
        Some(Dialect::Creo),
    );
    assert!(close(&arcs(&kinds), &[(360.0, 1.0), (360.0, 1.0)]), "{:?}", arcs(&kinds));
}

/// A few points on an arc are not the ends of chords.
#[test]
fn sparse_points_on_a_circle_are_joined_by_arcs() {
    let text = |axis: &str, points: &str| {
        format!(
            "UNITS/MM\nGOTO / 10, 0, 0\nCIRCLE / 0, 0, 0, {axis}, 10\nGOTO / {points}\nGOTO / 0,0,5\n"
        )
    };
    let half = read(&text("0, 0, 1", "0, 10, 0\n-10, 0, 0"), Some(Dialect::Creo));
    assert!(close(&arcs(&half), &[(90.0, 1.0), (90.0, 1.0)]), "{:?}", arcs(&half));
    let back = read(&text("0, 0, -1", "0, -10, 0\n-10, 0, 0\n0, 10, 0"), Some(Dialect::Creo));
    assert!(close(&arcs(&back), &[(90.0, -1.0); 3]), "{:?}", arcs(&back));
    // Their order decides against the axis.
    let turned = read(&text("0, 0, -1", "0, 10, 0\n-10, 0, 0"), Some(Dialect::Creo));
    assert!(close(&arcs(&turned), &[(90.0, 1.0), (90.0, 1.0)]), "{:?}", arcs(&turned));
    // Close ones are chords.
    let near: String = (1..=90)
        .map(|i| {
            let (sin, cos) = trig::sin_cos(f64::from(i).to_radians());
            format!("{:.6}, {:.6}, 0\n", 10.0 * cos, 10.0 * sin)
        })
        .collect();
    let chords = read(&text("0, 0, 1", near.trim_end()), Some(Dialect::Creo));
    assert_eq!((arcs(&chords).len(), motions(&chords)[1].points.len()), (0, 90));
}

/// A post that states the plane's axis for both senses: the angle tells.
#[test]
fn the_angle_of_movarc_decides_the_sense() {
    let text = |angle: &str, end: &str| {
        format!("UNITS/MM\nGOTO/10,0,2\nMOVARC/0,0,2,0,0,1,10,ANGLE,{angle}\nGOTO/{end},2\n")
    };
    for (angle, end, expected) in [
        ("90", "0,10", (90.0, 1.0)),
        ("90", "0,-10", (90.0, -1.0)),
        ("270", "0,10", (270.0, -1.0)),
        ("180", "-10,0", (180.0, 1.0)),
        ("360", "10,0", (360.0, 1.0)),
        ("450", "0,10", (450.0, 1.0)),
        ("450", "0,-10", (450.0, -1.0)),
    ] {
        let (records, said) = read_bytes(text(angle, end).as_bytes(), None);
        let kinds: Vec<Kind> = records.into_iter().map(|r| r.kind).collect();
        assert!(close(&arcs(&kinds), &[expected]), "{angle} {end}: {:?}", arcs(&kinds));
        assert_eq!(said.len(), usize::from(expected.1 < 0.0), "{said:?}");
    }
}

/// Words that no table has are kept, and told once with count and line.
#[test]
fn unknown_words_are_told_once() {
    let (records, said) = read_bytes(
        b"UNITS/MM\nSTART_OP/A\nGOTO/1,2,3\nTLCOMP,5\nSTART_OP/B\nTOOLPATH_TYPE/3AXIS\nSTART_OP/C\n",
        None,
    );
    assert_eq!(records.len(), 7);
    let told = |w: &str, n: &str| said.iter().filter(|s| s.contains(w) && s.contains(n)).count();
    assert_eq!(told("START_OP", "3 times, first in line 2"), 1, "{said:?}");
    assert_eq!(told("TLCOMP", "line 4"), 1, "{said:?}");
    assert_eq!(said.len(), 3);
}

#[test]
fn bottoms_of_holes_in_fusion() {
    let head = "MODE/MILL\nPARTNO/'1'\nUNITS/MM\n";
    let kinds = read(
        &format!(
            "{head}GOTO/0.,0.,15.\nCYCLE/DEEP, 12., INCR, 3., MMPM, 150., 15., RAPTO, 11., DWELL, .5\n\
             FEDRAT/150., MMPM\nGOTO/5., 6., -12.\nGOTO/7., 6., -14.\nGOTO/8., 6., -14.\nCYCLE/OFF\n\
             GOTO/1., 1., -12.\n"
        ),
        None,
    );
    let mut tops = vec![[0.0, 0.0, 15.0], [5.0, 6.0, 0.0], [7.0, 6.0, -2.0], [8.0, 6.0, -2.0]];
    tops.push([1.0, 1.0, -12.0]);
    assert_eq!(places(&kinds), tops);
    let said: Vec<&[Arg]> = kinds
        .iter()
        .filter_map(|k| match k {
            Kind::Post { word, args } if word == "CYCLE" => Some(args.as_slice()),
            _ => None,
        })
        .collect();
    // Feed begins at z 4 and the tool leaves at z 15, whatever the height of the top.
    let cycle = |clear: f64, retract: f64| {
        let mut list = vec![word("DEEP"), word("DEPTH"), number(12.0), word("STEP"), number(3.0)];
        list.extend([word("MMPM"), number(150.0), word("CLEAR"), number(clear)]);
        list.extend([word("RTRCTO"), number(retract), word("DWELL"), number(0.5)]);
        list
    };
    assert_eq!(said, [cycle(4.0, 15.0).as_slice(), &cycle(6.0, 17.0), &[word("OFF")]]);

    // Along a leaning tool axis, and with the words of other systems the point is the top.
    let kinds = read(
        &format!(
            "{head}MULTAX/ON\nCYCLE/DRILL, 10., MMPM, 90., 40.\nGOTO/30., 0., 20., .6, 0., .8\nCYCLE/OFF\n"
        ),
        None,
    );
    assert_eq!(places(&kinds), [[36.0, 0.0, 28.0]]);
    let cycle = args(&kinds, "CYCLE").unwrap();
    assert_eq!(cycle[5..], [word("CLEAR"), number(-4.0), word("RTRCTO"), number(-4.0)]);
    let words = "CYCLE/DRILL, FEDTO, 8, MMPM, 90, CLEAR, 15, RAPTO, 5\nGOTO/1, 2, 0\nCYCLE/OFF\n";
    assert_eq!(places(&read(&format!("{head}{words}"), None)), [[1.0, 2.0, 0.0]]);
    assert!(
        args(&read(&format!("{head}{words}"), None), "CYCLE").unwrap().contains(&word("FEDTO"))
    );
    let bore =
        "CYCLE/BORE, 5., MMPM, 90., 15., RAPTO, 10., ORIENT, 0\nGOTO/1., 2., -5.\nCYCLE/OFF\n";
    let kinds = read(&format!("{head}{bore}"), None);
    assert!(!args(&kinds, "CYCLE").unwrap().contains(&word("ORIENT")));
}

#[test]
fn what_is_unknown_in_a_cycle_of_fusion_is_an_error() {
    let head = "MODE/TURN\n$$ VERSION 5\n\nPARTNO/'1'\nUNITS/MM\n";
    for unit in ["MMPM", "IPM", "MMPR", "IPR"] {
        let kinds = read(
            &format!("{head}CYCLE/TAP, 12., {unit}, 1.25, 15., RAPTO, 10.\nGOTO/3., 1., -12.\n"),
            None,
        );
        assert_eq!(places(&kinds), [[3.0, 1.0, 0.0]], "{unit}");
        let said = args(&kinds, "CYCLE").unwrap();
        assert_eq!(said[3..5], [word(unit), number(1.25)]);
        assert_eq!(said[6..], [number(5.0), word("RTRCTO"), number(15.0)]);
    }
    for (cycle, what) in [
        ("DRILL, 12., MMPH, 200., 15.", "MMPH"),
        ("DRILL, 12., MMPM, 200., 15., WIDTH, 3.", "WIDTH"),
        ("DRILL, 12., MMPM, 200., 15., RAPTO", "RAPTO"),
        ("DRILL, 12., MMPM, 200., 15., MMPR, .1", "a feed stands twice"),
        ("DRILL, 12., MMPM, 200., 15., 3.", "ORIENT"),
        ("DRILL, 12., MMPM, 200.", "no clearance"),
        ("DRILL, 12., MMPM, 200., 15.\nGOTO/0., 0., -12.\nCYCLE/ON, FEDTO, 9.", "CYCLE/ON"),
    ] {
        let text = format!("{head}CYCLE/{cycle}\nGOTO/3., 1., -12.\nCYCLE/OFF\n");
        let mut reader = Reader::open(text.as_bytes(), None).unwrap();
        let mut record = Record::default();
        while reader.read(&mut record).unwrap() {}
        let said = reader.into_diagnostics();
        assert!(said.iter().any(|d| d.is_error() && d.message.contains(what)), "{cycle}: {said:?}");
    }
}

#[test]
fn a_cycle_of_fusion_comes_back() {
    let text = "MODE/MILL\nPARTNO/'1'\nUNITS/MM\nCYCLE/DRILL, 12., MMPM, 200., 15., RAPTO, 10.\n\
                GOTO/30., 10., -12.\nCYCLE/OFF\nGOTO/40., 10., 15.\nCYCLE/ON\nGOTO/40., 10., -14.\n\
                CYCLE/OFF\nCYCLE/OFF\nCYCLE/ON\nGOTO/50., 10., -12.\nCYCLE/OFF\nGOTO/1., 1., 9.\n";
    let kinds = read(text, None);
    let tops = [[30.0, 10.0, 0.0], [40.0, 10.0, 15.0], [40.0, 10.0, -2.0], [50.0, 10.0, 0.0]];
    assert_eq!(places(&kinds)[..4], tops);
    assert_eq!(places(&kinds)[4..], [[1.0, 1.0, 9.0]]);
    let clear: Vec<Option<&Arg>> = kinds
        .iter()
        .filter_map(|k| match k {
            Kind::Post { word, args } if word == "CYCLE" => Some(args.get(6)),
            _ => None,
        })
        .collect();
    let (low, high) = (number(5.0), number(7.0));
    assert_eq!(clear, [Some(&low), None, Some(&high), None, None, Some(&low), None]);
    // A cycle in the words of other systems comes back as such.
    let words = text.replace("DRILL, 12., MMPM, 200., 15.", "DRILL, FEDTO, 12., CLEAR, 15.");
    assert_eq!(places(&read(&words, None))[2..3], [[40.0, 10.0, -14.0]]);
}
