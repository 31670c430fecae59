//! Every limit is a setting and is told when it is reached.

mod support;

use std::collections::BTreeMap;

use aptc_protap::{Kind, Outcome};
use aptc_translate::{Limits, NoFiles, Options, UnknownWords};
use support::{Ran, Shelf, run_with};

fn limited(text: &str, limits: Limits) -> Ran {
    let options = Options { limits, ..Options::default() };
    run_with(text, &mut NoFiles, options, |_| Outcome::None)
}

#[test]
fn executed_statements() {
    let limits = || Limits { statements: 1_000, ..Limits::default() };
    let ran = limited("I=0\n1) I=I+1\nJUMPTO/1\nFINI\n", limits());
    assert_eq!(ran.told(), [(1100, 3)]);
    assert_eq!(ran.executed, 1_000);
    assert_eq!(ran.records.last().map(|r| &r.kind), Some(&Kind::Fini));
    let fits = "DO/1,I=1,998\n1) CONTIN\nFINI\n";
    assert_eq!(limited(fits, limits()).told(), []);
}

#[test]
fn a_loop_whose_end_an_error_has_taken_away() {
    let ran = limited("I=0\nA=B+1\n1) I=I+1\nJUMPTO/1\nFINI\n", Limits::default());
    assert_eq!(ran.told().len(), 1, "{:?}", ran.told());
    assert!(ran.executed < 100_000, "{}", ran.executed);
    let further = "A=B+1\nDO/1,I=1,500\n1) CONTIN\nC=D+1\nFINI\n";
    let codes = |n| limited(further, Limits { after_error: n, ..Limits::default() }).told().len();
    assert_eq!((codes(2_000), codes(100)), (2, 1));
    assert_eq!(ran.records.last().map(|r| &r.kind), Some(&Kind::Fini));
}

#[test]
fn macro_calls() {
    let text = "M=MACRO/A\nIF(A-1)2,2,1\n1) CALL/M,A=(A-1)\n2) TERMAC\nCALL/M,A=5\nFINI\n";
    let limits = |macro_depth| Limits { macro_depth, ..Limits::default() };
    assert_eq!(limited(text, limits(5)).told(), []);
    assert_eq!(limited(text, limits(4)).told(), [(1101, 3)]);
    let endless = "M=MACRO/\nCALL/M\nTERMAC\nCALL/M\nFINI\n";
    assert_eq!(limited(endless, Limits::default()).told(), [(1101, 2)]);
    let deep = limited(endless, limits(100_000));
    assert_eq!(deep.told(), [(1101, 2)]);
}

#[test]
fn files_within_files() {
    let mut shelf = Shelf(BTreeMap::from([("A", "INCLUD/A\n")]));
    let ran = run_with("INCLUD/A\nFINI\n", &mut shelf, Options::default(), |_| Outcome::None);
    assert_eq!(ran.told(), [(1102, 1)]);
}

#[test]
fn elements_of_arrays() {
    let limits = Limits { array_elements: 10, ..Limits::default() };
    let ran = limited("RESERV/A,6\nRESERV/B,5\nRESERV/C,4\nB(1)=3\nFINI\n", limits);
    assert_eq!(ran.told(), [(1103, 2)]);
}

#[test]
fn printed_lines() {
    let limits = Limits { printed: 3, ..Limits::default() };
    let ran = limited("DO/1,I=1,9\n1) PRINT/3,I\nGOTO/I,0,0\nFINI\n", limits);
    assert_eq!(ran.told(), [(1104, 2)]);
    assert!(!ran.diagnostics[0].is_error());
    assert_eq!(ran.listing.len(), 3);
    assert_eq!(support::numbers(&ran), [9.0]);
}

#[test]
fn points_of_a_pattern() {
    let limits = Limits { points: 10, ..Limits::default() };
    let ran = limited("Q=PATERN/LINEAR,(POINT/0,0),(POINT/1,0),11\nFINI\n", limits);
    assert_eq!(ran.told(), [(1215, 1)]);
}

#[test]
fn brackets_and_elements() {
    let limits = Limits { bracket_depth: 3, ..Limits::default() };
    assert_eq!(limited("A=((((1))))\nFINI\n", limits).told(), [(1008, 1)]);
    let limits = Limits { elements: 10, ..Limits::default() };
    assert_eq!(limited("A=1+1+1+1+1+1+1\nFINI\n", limits).told(), [(1009, 1)]);
}

#[test]
fn messages() {
    let text: String = (0..20).map(|i| format!("A{i}=B{i}\n")).collect::<String>() + "FINI\n";
    let limits = Limits { messages: 5, ..Limits::default() };
    let options = Options { limits, ..Options::default() };
    let mut files = NoFiles;
    let mut program = aptc_translate::Interpreter::new("x", &text, &mut files, options);
    while program.step() != aptc_translate::Step::End {}
    assert_eq!(program.take_diagnostics().len(), 5);
    assert_eq!((program.n_errors(), program.n_dropped()), (20, 15));
}

#[test]
fn unknown_words_may_be_refused() {
    let options = Options { unknown_words: UnknownWords::Refuse, ..Options::default() };
    let ran = run_with("HYDRAU/ON\nFINI\n", &mut NoFiles, options, |_| Outcome::None);
    assert_eq!(ran.told(), [(1301, 1)]);
    assert!(ran.diagnostics[0].is_error());
    assert!(ran.kinds().is_empty());
}

#[test]
fn unused_names_are_told_when_asked_for() {
    let text = "A=1\nB=2\nP=POINT/B,0\nL=LINE/P,(POINT/3,4)\nI=0\nDO/1,K=1,2\n1) CONTIN\nFINI\n";
    let options = Options { unused: true, ..Options::default() };
    let ran = run_with(text, &mut NoFiles, options, |_| Outcome::None);
    assert_eq!(ran.told(), [(1068, 1), (1068, 4), (1068, 5)]);
    assert!(ran.diagnostics.iter().all(|d| !d.is_error()));
    assert_eq!(support::run(text).told(), []);
}

#[test]
fn a_million_statements_are_a_matter_of_seconds() {
    // A loop that defines points, as fast as a debug build with some optimisation may be expected to be.
    let text = "RESERV/P,250000\nI=0\n1) I=I+1\nP(I)=POINT/I,(I*2),0\nIF(I-250000)1,2,2\n2) FINI\n";
    let start = std::time::Instant::now();
    let ran = support::clean(text);
    assert_eq!(ran.executed, 750_003);
    assert!(start.elapsed().as_secs() < 60, "{:?}", start.elapsed());
}
