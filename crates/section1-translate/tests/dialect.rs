//! Programs of NCL get one message that names the dialect; programs of APT do not.

mod support;

use aptc_protap::Outcome;
use aptc_translate::{Language, NoFiles, Options};
use support::{run, run_with};

const NCL: &str = "CU/.35,.175\nPL1=PL/0,0,1,2\nGF/LN1,TO,LN2\n# note\nX=SPLINE/PSF1,3,.45\nFINI\n";

#[test]
fn a_program_of_ncl_gets_one_message() {
    let ran = run(NCL);
    assert_eq!(ran.told(), [(1302, 1)], "{}", ran.messages());
    assert!(ran.messages().contains("CU, PL, GF"), "{}", ran.messages());
    assert!(ran.records.is_empty());
}

#[test]
fn it_can_be_translated_as_far_as_it_is_apt() {
    let options = || Options { language: Language::Ncl, ..Options::default() };
    let ran = run_with(NCL, &mut NoFiles, options(), |_| Outcome::None);
    assert!(ran.told().iter().all(|(code, _)| *code != 1302) && ran.told().len() > 1);
    let ran =
        run_with("PT1=POINT/1,2,3\nGOTO/PT1\nFINI\n", &mut NoFiles, options(), |_| Outcome::None);
    assert!(ran.diagnostics.is_empty(), "{}", ran.messages());
}

#[test]
fn one_word_of_ncl_is_a_word_of_another_dialect() {
    assert_eq!(run("CU/.35\nGOTO/1,2,3\nFINI\n").told(), [(1302, 1)]);
}

#[test]
fn names_of_the_program_are_its_own() {
    let text = "SYN/GF,GOFWD,PL,PLANE\nPL1=PL/0,0,1,2\nCU=3\nCA=MACRO/\nGOTO/CU,0,0\nTERMAC\nCALL/CA\nFINI\n";
    let ran = run(text);
    assert!(ran.diagnostics.is_empty(), "{}", ran.messages());
}
