//! What programs print.

mod support;

use aptc_protap::{NameRef, Outcome};
use aptc_translate::{EntryKind, Options};
use support::{Shelf, clean, run, run_with};

fn name(name: &str, subscript: u32) -> NameRef {
    NameRef { name: name.into(), subscript }
}

fn printed(text: &str) -> Vec<EntryKind> {
    clean(text).listing.into_iter().map(|e| e.kind).collect()
}

fn scalar(n: &str, subscript: u32, value: f64) -> EntryKind {
    EntryKind::Scalar { name: Some(name(n, subscript)), value }
}

fn form(n: &str, subscript: u32, word: &'static str, elements: &[f64]) -> EntryKind {
    EntryKind::Form { name: Some(name(n, subscript)), word, elements: elements.to_vec() }
}

#[test]
fn print_on_lists_each_definition_nested_ones_too() {
    let text = "P=POINT/1,2\nPRINT/ON\nL=LINE/P,(Q=POINT/1,5)\nA=3\nM=MATRIX/(MATRIX/SCALE,2),(MATRIX/SCALE,3)\nPRINT/OFF\nR=POINT/0,0\nFINI\n";
    let six = [6.0, 0.0, 0.0, 0.0, 0.0, 6.0, 0.0, 0.0, 0.0, 0.0, 6.0, 0.0];
    let entries = printed(text);
    assert_eq!(entries[0], form("Q", 0, "POINT", &[1.0, 5.0, 0.0]));
    assert_eq!(entries[1], form("L", 0, "LINE", &[1.0, 0.0, 0.0, 1.0]));
    assert!(matches!(&entries[2], EntryKind::Form { name: Some(n), .. } if n.name.is_empty()));
    assert_eq!(entries[4], form("M", 0, "MATRIX", &six));
    assert_eq!(entries.len(), 5);
}

#[test]
fn print_3_names_what_it_prints() {
    let text = "RESERV/B,3\nA=2\nB(1)=5\nB(3)=7\nP=POINT/1,2,3\nPRINT/3,A,B,P,(POINT/0,0),4.5,B(1)\n\
        PRINT/2,A,P\nPRINT/1,A\nPRINT/0\nFINI\n";
    assert_eq!(
        printed(text),
        [
            scalar("A", 0, 2.0),
            scalar("B", 1, 5.0),
            scalar("B", 3, 7.0),
            form("P", 0, "POINT", &[1.0, 2.0, 3.0]),
            form("", 0, "POINT", &[0.0, 0.0, 0.0]),
            EntryKind::Scalar { name: Some(NameRef::default()), value: 4.5 },
            scalar("B", 1, 5.0),
            EntryKind::Scalar { name: None, value: 2.0 },
            EntryKind::Form { name: None, word: "POINT", elements: vec![1.0, 2.0, 3.0] },
            EntryKind::Bits { name: name("A", 0), word: "SCALAR", elements: vec![2.0] },
            EntryKind::Page
        ]
    );
}

#[test]
fn print_all_gives_all_there_is() {
    let text = "A=2\nP=POINT/1,2,3\nPRINT/3,ALL\nFINI\n";
    assert_eq!(printed(text), [scalar("A", 0, 2.0), form("P", 0, "POINT", &[1.0, 2.0, 3.0])]);
}

#[test]
fn titles_stand_between() {
    let title = |text: &str, right| EntryKind::Title { text: text.into(), right };
    assert_eq!(
        printed("TITLES  X   Y\nPRINT/2,1\nTITLES RIGHT RADIUS\nFINI\n"),
        [
            title("X   Y", false),
            EntryKind::Scalar { name: None, value: 1.0 },
            title("RADIUS", true)
        ]
    );
}

#[test]
fn a_name_without_value_is_a_warning_and_no_poison() {
    let ran = run("PRINT/3,A\nA=1\nGOTO/A,0,0\nFINI\n");
    assert_eq!(ran.told(), [(1051, 1)]);
    assert!(!ran.diagnostics[0].is_error());
    assert_eq!(ran.listing[0].kind, EntryKind::Undefined { name: name("A", 0) });
    assert_eq!(support::numbers(&ran), [1.0]);
}

#[test]
fn entries_know_their_statement() {
    let ran = clean("A=1\n\nPRINT/3,A\nFINI\n");
    assert_eq!((ran.listing[0].origin.line, ran.listing[0].origin.isn), (3, 3));
}

#[test]
fn what_is_left_out_is_noted_with_the_definition_at_fault() {
    let text = "L1=LINE/0,0,1,0\nL2=LINE/PARLEL,L1,XLARGE,5\nP=POINT/INTOF,L1,L2\nGOTO/P\nGOTO/1,2\n\
                GOFWD/L1,TO,L2\nFINI\n";
    let ran = run(text);
    assert_eq!(ran.told().len(), 1, "{}", ran.messages());
    let remarks: Vec<String> = ran
        .listing
        .iter()
        .filter_map(|e| match &e.kind {
            EntryKind::Remark(text) => Some(text.clone()),
            _ => None,
        })
        .collect();
    assert_eq!(
        remarks,
        [
            "line 3 is left out: L2 has no value since line 2",
            "line 4 is left out: P has no value since line 3",
            "line 6 is left out: L2 has no value since line 2",
        ]
    );
}

/// What PUNCH saves gives another program the same values by READ/1; unit vectors are made so again.
#[test]
fn what_punch_saves_is_read_again() {
    let define = "P1=POINT/1,2,1/3\nL1=LINE/0,0,1,2\nC1=CIRCLE/1,2,3,4\nM1=MATRIX/XYROT,30,TRANSL,1,2,3\n\
        T1=TABCYL/NOZ,SPLINE,0,0,1,1,2,1.5,3,0\nE1=ELLIPS/CENTER,P1,3,2,20\nPA=PATERN/LINEAR,P1,(POINT/7,7),5\n\
        K1=CONE/P1,(VECTOR/1,2,3),25\nRESERV/Q,2,A,2\nQ(2)=POINT/0,0,7\nA(1)=1/7\nS=SQRTF(2)\n";
    let first = clean(&format!("{define}PUNCH/1,ALL\nFINI\n"));
    let cards: Vec<String> = first
        .listing
        .iter()
        .filter_map(|e| match &e.kind {
            EntryKind::Saved(card) => Some(card.clone()),
            _ => None,
        })
        .collect();
    assert!(cards.iter().all(|c| c.len() <= 72), "{cards:#?}");
    let file: &'static str = cards.join("\n").leak();
    let mut shelf = Shelf([("GEO", file)].into());
    let text = "RESERV/Q,2,A,2\nREAD/1,GEO\nFINI\n";
    let second = run_with(text, &mut shelf, Options::default(), |_| Outcome::None);
    assert!(second.diagnostics.is_empty(), "{:?}\n{file}", second.diagnostics);
    let values = |ran: &support::Ran| -> Vec<(NameRef, Vec<f64>)> {
        ran.geometry.iter().map(|(name, q)| (name.clone(), q.elements())).collect()
    };
    let (first, second) = (values(&first), values(&second));
    assert_eq!(first.len(), 11);
    for (name, given) in &first {
        let read = second.iter().find(|(n, _)| n == name).map(|(_, v)| v);
        let read = read.unwrap_or_else(|| panic!("{name:?} was not read"));
        assert_eq!(given.len(), read.len(), "{name:?}");
        let same = |(a, b): (&f64, &f64)| (a - b).abs() <= 1e-15 * a.abs().max(1.0);
        assert!(given.iter().zip(read).all(same), "{name:?} {given:?} {read:?}");
    }
}

#[test]
fn that_gouges_are_always_looked_for_is_said_once_of_each_word() {
    let said = |word: &str| {
        EntryKind::Remark(format!("every cut vector is checked for gouges, with or without {word}"))
    };
    let text = "GOUGCK/ON\nNDTEST\nGOUGCK/OFF\nGOUGCK\nNDTEST\nFINI\n";
    assert_eq!(printed(text), [said("GOUGCK"), said("NDTEST")]);
    assert_eq!(printed("2DCALC\nFINI\n"), []);
}
