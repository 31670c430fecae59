//! Files that are broken: messages with the line, no panic, nothing endless.

#![expect(clippy::unwrap_used, reason = "a test: it fails")]

use aptc_cldata::{
    ClfileWriter, Dialect, Kind, Motion, Position, Reader, Record, RecordReader, RecordWriter,
    TapeWriter,
};
use aptc_geometry::Vec3;

fn read(bytes: &[u8], dialect: Option<Dialect>) -> (Vec<Record>, Vec<String>) {
    let mut reader = Reader::open(bytes, dialect).unwrap();
    let mut record = Record::default();
    let mut out = Vec::new();
    while reader.read(&mut record).unwrap() {
        out.push(record.clone());
    }
    let said = reader.into_diagnostics();
    (out, said.into_iter().map(|d| format!("{} {}", d.code, d.message)).collect())
}

#[test]
fn statements_that_cannot_be_read_are_kept_and_told_with_their_line() {
    for (text, code, line) in [
        ("UNITS/MM\nGOTO/1,NAN,3\n", "APT3001", "line 2"),
        ("UNITS/MM\nGOTO/1,1e999,3\n", "APT3001", "line 2"),
        ("UNITS/MM\nGOTO/inf,2,3\n", "APT3001", "line 2"),
        ("UNITS/MM\nGOTO/1,2,", "APT3001", "line 2"),
        ("UNITS/MM\n\nGOTO/X,Y,Z\n", "APT3001", "line 3"),
        ("UNITS/MM\nGOTO/1,2,3,\nCIRCLE/1,2\nGOTO/4,5,6\n", "APT3001", "line 3"),
        ("UNITS/MM\nCIRCLE/1,2,3,0,0,1,5,1,1,1\n", "APT3001", "line 2"),
        ("UNITS/MM\nGOTO 1,2,3\n", "APT3001", "line 2: a motion without its slash"),
        ("UNITS/MM\nfrom -1,2,3\n", "APT3001", "line 2: a motion without its slash"),
        ("UNITS/FURLONGS\n", "APT3001", "line 1"),
        ("UNITS/MM\nMOVARC/1,2,3\n", "APT3001", "line 2"),
        ("UNITS/MM\nGOTO/0,0,0\nARC/CLW,10,0,20,0\nGOTO/20,0,0\n", "APT3001", "line 3"),
        ("UNITS/MM\nTLON,GOFWD/(CIRCLE/1,2,3,4),ON,(LINE/1\n", "APT3001", "line 2"),
        ("UNITS/MM\nGODLTA/1,2,3\n", "APT3001", "line 2"),
        ("UNITS/MM\nZZTOP/1\nGOTO/1,2,3\nZZTOP/2\n", "APT3002", "ZZTOP is not known, 2 times"),
        ("GOTO/1,2,3\n", "APT3006", "inches"),
    ] {
        let (records, said) = read(text.as_bytes(), None);
        assert!(said.iter().any(|s| s.starts_with(code) && s.contains(line)), "{text}: {said:?}");
        for r in &records {
            if let Kind::Motion(m) = &r.kind {
                assert!(m.points.iter().all(|p| p.te.iter().all(|x| x.is_finite())));
            }
        }
        let kept = records.iter().filter(|r| matches!(r.kind, Kind::Unread(_))).count();
        assert!(code != "APT3001" || kept > 0, "{text}");
    }
}

/// What should have moved the tool, or said how fast, must not be lost with a warning.
#[test]
fn a_motion_in_another_form_is_an_error() {
    for line in [
        "GOTO50,0,-1",
        "GOTO(50,0,-1)",
        "GOTO=50,0,-1",
        "GOTO: 50,0,-1",
        "GOTO\\50,0,-1",
        "GOTO X50 Y0 Z-1",
        "GOTO50/0,-1",
        "10) GOTO/50,0,-1",
        "CIRCLE 1,2,3,4",
        "INDIRV 1,0,0",
        "INDIRV/1,0",
        "RAPID 5",
        "RAPID GOTO/1,2,3",
        "FEDRAT 50",
        "CYCLE DRILL,5",
        "CW 1,2,3",
    ] {
        let (_, said) = read(format!("UNITS/MM\nGOTO/1,2,3\n{line}\n").as_bytes(), None);
        assert!(said.iter().any(|s| s.starts_with("APT3001 line 3: ")), "{line}: {said:?}");
        assert_eq!(said.len(), 1, "{line}: {said:?}");
    }
    for line in ["RAPID", "CW", "CYCLE81/5", "RAPID_RATE/5", "FROMAGE 5", "GOTO,5,0,-1"] {
        let (_, said) = read(format!("UNITS/MM\nGOTO/1,2,3\n{line}\n").as_bytes(), None);
        assert!(said.iter().all(|s| !s.starts_with("APT3001")), "{line}: {said:?}");
    }
}

#[test]
fn a_statement_of_a_part_program_is_an_error() {
    for line in [
        "INCLUDE/GEOM",
        "GO/TO,L1,TO,PL",
        "GORGT/L1,PAST,L3",
        "TLLFT,GOLFT/L1",
        "GOFWD/L1,TO,L2",
        "TLON,GOFWD/L1,TO,L2",
        "GOBACK/L1",
        "GOUP/L1",
        "GODOWN/L1",
        "TLRGT",
        "GO,TO/P",
        "10) L1=LINE/XAXIS",
        "PL = PLANE/0,0,1,5",
    ] {
        let text = format!("UNITS/MM\nGOTO/1,2,3\n{line}\n{line}\n");
        let (_, said) = read(text.as_bytes(), None);
        let told = "APT3001 this is a part program, compile it: a statement that CL data have not, \
                    2 times, first in line 3";
        assert_eq!(said, [told], "{line}");
    }
    // Of text words all is text, also what goes on with them.
    for line in ["PPRINTP1=POINT/HOLE 3", "REMARK surfaces $\nA=PLANE/1,2", "TLON"] {
        let (_, said) = read(format!("UNITS/MM\n{line}\nGOTO/1,2,3\n").as_bytes(), None);
        assert!(said.iter().all(|s| !s.starts_with("APT3001")), "{line}: {said:?}");
    }
    let (_, said) = read(b"UNITS/MM\nREMARK $\nGOTO/1,2,3\nA=PLANE/1,2\n", None);
    assert!(said.iter().any(|s| s.starts_with("APT3001")), "{said:?}");
}

/// No CAM system is known to write 0,0,0 for an axis: which way the tool stands is not known.
#[test]
fn an_axis_of_no_length_is_an_error() {
    for text in ["GOTO/1,2,3,0,0,0\n", "MULTAX/ON\nGOTO/1,2,3,0,0,1\nGODLTA/0,0,5,0,0,-0.\n"] {
        let (_, said) = read(format!("UNITS/MM\n{text}").as_bytes(), None);
        assert_eq!(said.len(), 1, "{text}: {said:?}");
        assert!(said[0].starts_with("APT3001 a tool axis of no length"), "{text}: {said:?}");
    }
}

#[test]
fn an_arc_nowhere_near_its_circle_is_a_line() {
    for (arc, code) in [
        ("CIRCLE/0,0,0,10\nGOTO/0,10,0\n", None),
        ("CIRCLE/0,0,0,10\nGOTO/0,10.5,0\n", Some("APT3004")),
        ("CIRCLE/0,0,0,10\nGOTO/0,20,0\n", Some("APT3001")),
        ("CIRCLE/0,0,0,0\nGOTO/0,10,0\n", Some("APT3001")),
        ("CIRCLE/0,-20,0,30\nGOTO/0,10,0\n", Some("APT3004")),
        ("CIRCLE/0,-20,0,10\nGOTO/0,-10,0\n", Some("APT3001")),
        ("CIRCLE/0,0,0,0,0,1\nGOTO/0,30,0\n", Some("APT3001")),
    ] {
        let (records, said) = read(format!("UNITS/MM\nGOTO/10,0,0\n{arc}").as_bytes(), None);
        let Some(Kind::Motion(Motion { arc: found, .. })) = records.last().map(|r| &r.kind) else {
            panic!("{arc}: no motion");
        };
        assert_eq!(found.is_some(), code != Some("APT3001"), "{arc}: {found:?}");
        assert_eq!(said.first().map(|s| &s[..7]), code, "{arc}: {said:?}");
        assert!(said.len() < 2, "{arc}: {said:?}");
    }
}

#[test]
fn a_line_of_ten_megabytes_is_left_out() {
    let mut text = b"UNITS/MM\nGOTO/1,2,3\n".to_vec();
    text.extend(std::iter::repeat_n(b'7', 10 << 20));
    text.extend_from_slice(b"\nGOTO/4,5,6\n");
    let (records, said) = read(&text, None);
    let n = records.iter().filter(|r| matches!(r.kind, Kind::Motion(_))).count();
    assert_eq!(n, 2);
    assert!(said.iter().any(|s| s.starts_with("APT3005") && s.contains("line 3")), "{said:?}");
}

#[test]
fn rubbish_does_no_harm() {
    let mut seed = 7_u64;
    let mut random = || {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        (seed >> 33).to_le_bytes()[0]
    };
    for length in [0, 1, 15, 16, 17, 100, 5000, 300_000] {
        let bytes: Vec<u8> = (0..length).map(|_| random()).collect();
        for dialect in [None].into_iter().chain(Dialect::ALL.map(Some)) {
            let (_, said) = read(&bytes, dialect);
            assert!(said.len() <= 1100, "{} messages", said.len());
        }
    }
    let text = vec![b'$'; 5_000_000];
    read(&text, Some(Dialect::Iso));
    let many = b"A/1,$\n".repeat(500_000);
    read(&many, Some(Dialect::Iso));
}

/// A tape and a clfile with some records.
fn binaries() -> [(Vec<u8>, Dialect); 2] {
    let goto = |x: f64| {
        let points = vec![Position::upright(Vec3::new(x, 1.0 / 3.0, 0.1)); 200];
        Record { kind: Kind::Motion(Motion { points, ..Motion::default() }), ..Record::default() }
    };
    let records = [goto(1.0), goto(2.0), Record::default()];
    let mut tape = TapeWriter::new(Vec::new(), aptc_vocabulary::Dialect::Apt360);
    let mut clfile = ClfileWriter::new(Vec::new());
    for r in &records {
        tape.write(r).unwrap();
        clfile.write(r).unwrap();
    }
    [(tape.into_inner().unwrap(), Dialect::Tape), (clfile.into_inner().unwrap(), Dialect::Clfile)]
}

#[test]
fn binary_files_that_end_too_early() {
    for (bytes, dialect) in binaries() {
        let (whole, said) = read(&bytes, None);
        assert!(said.is_empty(), "{said:?}");
        for length in (0..bytes.len()).step_by(7) {
            let (part, _) = read(&bytes[..length], Some(dialect));
            assert!(part.len() <= whole.len());
        }
        let (_, said) = read(&bytes[..bytes.len() / 2], Some(dialect));
        assert!(said.iter().any(|s| s.contains("ends within a record")), "{said:?}");
    }
}

#[test]
fn binary_files_with_wrong_counts() {
    for (bytes, dialect) in binaries() {
        for at in 0..400 {
            for value in [0, 0x7f, 0xff] {
                let mut broken = bytes.clone();
                broken[at] = value;
                let (records, _) = read(&broken, Some(dialect));
                for r in &records {
                    if let Kind::Motion(m) = &r.kind {
                        assert!(m.points.iter().all(|p| p.te.iter().all(|x| x.is_finite())));
                    }
                }
            }
        }
    }
}

/// A file whose end is lost in the midst of a statement is not a whole one.
#[test]
fn a_statement_past_the_end_is_told() {
    for (text, told) in [
        ("UNITS/MM\nGOTO/1,2,3,$\n", true),
        ("UNITS/MM\nGOTO/1,2,3,$", true),
        ("UNITS/MM\nGOTO/1,2,3,$\n\n", true),
        ("UNITS/MM\nGOTO/1,2,3,$\r\n  \r\n\x1a", true),
        ("UNITS/MM\nGOTO/1,2,3,$\n\nFINI\n", false),
        ("UNITS/MM\nGOTO/1,2,3,$\n0,0,1\n", false),
        ("UNITS/MM\nFINI $", false),
        ("UNITS/MM\nfini$\n\n", false),
        ("UNITS/MM\n$\n", false),
        ("UNITS/MM\nGOTO/1,2,3", false),
        ("UNITS/MM\nGOTO/1,2,3\n$$ end $", false),
    ] {
        let (_, said) = read(text.as_bytes(), None);
        let found = said.iter().any(|s| s.contains("line 2: the file ends where"));
        assert_eq!(found, told, "{text}: {said:?}");
    }
}
