//! Subprograms of Creo and of ISO couplets.

#![expect(clippy::unwrap_used, reason = "a test: it fails")]

use aptc_cldata::{Dialect, Kind, Reader, Record, RecordReader};
use aptc_diagnostics::Diagnostic;
use aptc_edit::Subprograms;

/// The x coordinates of the expanded text, and what was said.
fn expand(text: &str) -> (Vec<f64>, Vec<Diagnostic>) {
    let mut reader = Reader::open(text.as_bytes(), Some(Dialect::Creo)).unwrap();
    let (mut subs, mut record, mut out) =
        (Subprograms::default(), Record::default(), Vec::<Record>::new());
    while reader.read(&mut record).unwrap() {
        subs.push(&record, &mut out).unwrap();
    }
    subs.finish(&mut out).unwrap();
    // Once more changes nothing.
    let (mut again, mut twice) = (Subprograms::default(), Vec::<Record>::new());
    for r in &out {
        again.push(r, &mut twice).unwrap();
    }
    assert_eq!(out, twice);
    let mut x = Vec::new();
    for r in &out {
        if let Kind::Motion(m) = &r.kind {
            x.extend(m.points.iter().map(|p| p.te.x));
        }
    }
    (x, subs.take_diagnostics())
}

#[test]
fn a_body_goes_out_where_it_is_called() {
    let text = "UNITS / MM\nDEFSUB / 1\nGOTO / 1, 0, 0\nGOTO / 2, 0, 0\nENDSUB\nGOTO / 10, 0, 0\nCALSUB / 1\n\
                GOTO / 20, 0, 0\nCALSUB/ID,1\nFINI\n";
    let (x, said) = expand(text);
    assert!(said.is_empty(), "{said:?}");
    assert_eq!(x, [10.0, 1.0, 2.0, 20.0, 1.0, 2.0]);
}

#[test]
fn calls_within_bodies() {
    let text = "UNITS/MM\nDEFSUB/A\nGOTO/1,0,0\nENDSUB\nDEFSUB/B\nCALSUB/A\nGOTO/2,0,0\nCALSUB/A\nENDSUB\n\
                CALSUB/B\n";
    assert_eq!(expand(text).0, [1.0, 2.0, 1.0]);
}

#[test]
fn mistakes_are_told_and_lose_no_motion() {
    let open = "UNITS/MM\nDEFSUB/1\nGOTO/1,0,0\nFINI\n";
    let itself = "UNITS/MM\nDEFSUB/1\nGOTO/1,0,0\nCALSUB/1\nENDSUB\nCALSUB/1\nFINI\n";
    let within =
        "UNITS/MM\nDEFSUB/1\nGOTO/1,0,0\nDEFSUB/2\nGOTO/2,0,0\nENDSUB\nCALSUB/1\nCALSUB/2\nFINI\n";
    for (text, x) in [(open, vec![1.0]), (itself, vec![1.0]), (within, vec![1.0, 2.0])] {
        let (got, said) = expand(text);
        assert_eq!(got, x, "{text}");
        assert_eq!(said.len(), 1, "{text} {said:?}");
        assert_eq!(said[0].code.number(), 3108);
    }
    // One that is not defined here is left to the post-processor.
    assert_eq!(expand("UNITS/MM\nCALSUB/9\nGOTO/1,0,0\n").0, [1.0]);
}

/// The same steps from each place; what follows a call goes on from its end.
#[test]
fn deltas_start_where_the_call_does() {
    let text = "UNITS/MM\nGOTO/1,0,0\nDEFSUB/1\nGODLTA/1,0,0\nGODLTA/2,0,0\nENDSUB\nGODLTA/9,0,0\n\
                CALSUB/1\nGODLTA/100,0,0\nGOTO/50,0,0\nGODLTA/1,0,0\nCALSUB/1\nFINI\n";
    let (x, said) = expand(text);
    assert!(said.is_empty(), "{said:?}");
    assert_eq!(x, [1.0, 10.0, 11.0, 13.0, 113.0, 50.0, 51.0, 52.0, 54.0]);
    assert_eq!(expand("UNITS/MM\nDEFSUB/1\nGODLTA/1\nENDSUB\nCALSUB/1\n").1.len(), 1);
}
