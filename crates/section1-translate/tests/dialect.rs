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

/// Records without where they come from.
fn kinds(text: &str, language: Language) -> Vec<String> {
    let options = Options { language, ..Options::default() };
    let ran = run_with(text, &mut NoFiles, options, |_| Outcome::None);
    assert!(ran.diagnostics.is_empty(), "{}", ran.messages());
    ran.records.iter().map(|r| format!("{:?}", r.kind)).collect()
}

#[test]
fn short_words_of_ncl_are_those_of_apt_in_full() {
    let short = "CA/ON\nCU/10,1\nTH/.2\nTA/0,0,1\nPT1=PT/1,2,3\nLN1=LN/PT1,AA,30\nLN2=LI/PT1,PE,LN1\n\
                 C1=CI/CE,PT1,RA,5\nPL1=PL/0,0,1,2\nMX1=MX/XYROT,SQRT(900)\nPN1=PN/LINEAR,PT1,(PT/9,2,3),4\n\
                 LN3=LN/PA,LN1,YL,(2*SIN(30))\nPT2=PT/IO,LN1,LN2\nOB,PT/PT1,A,B,C\nFR/100\nSP/1000,CLW\n\
                 CO/ON\nRP\nGT/A,B,20\nGD/0,0,-5\nIV/1,0,0\nTN,GF/LN1,TO,LN2\nCY/OFF\nFINI\n";
    let full = "CANON/ON\nCUTTER/10,1\nTHICK/.2\nTLAXIS/0,0,1\nPT1=POINT/1,2,3\nLN1=LINE/PT1,ATANGL,30\n\
                LN2=LINE/PT1,PERPTO,LN1\nC1=CIRCLE/CENTER,PT1,RADIUS,5\nPL1=PLANE/0,0,1,2\n\
                MX1=MATRIX/XYROT,SQRTF(900)\nPN1=PATERN/LINEAR,PT1,(POINT/9,2,3),4\n\
                LN3=LINE/PARLEL,LN1,YLARGE,(2*SINF(30))\nPT2=POINT/INTOF,LN1,LN2\nOBTAIN,POINT/PT1,A,B,C\n\
                FEDRAT/100\nSPINDL/1000,CLW\nCOOLNT/ON\nRAPID\nGOTO/A,B,20\nGODLTA/0,0,-5\n\
                INDIRV/1,0,0\nTLON,GOFWD/LN1,TO,LN2\nCYCLE/OFF\nFINI\n";
    assert_eq!(kinds(short, Language::Ncl), kinds(full, Language::Apt));
}

#[test]
fn a_cutter_of_ncl_has_its_height_third() {
    assert_eq!(
        kinds("CU/10,1,40\nFINI\n", Language::Ncl),
        kinds("CUTTER/10,1,4,1,0,0,40\nFINI\n", Language::Apt)
    );
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

#[test]
fn what_ncl_alone_has_is_named_where_it_stands() {
    let text = "PT1=PT/1,2,3\nRMILL/PT1\nS1=NSURF/PT1,PT1\nGOTO/PT1\nFINI\n";
    let options = Options { language: Language::Ncl, ..Options::default() };
    let ran = run_with(text, &mut NoFiles, options, |_| Outcome::None);
    assert_eq!(ran.told(), [(1302, 2), (1302, 3)], "{}", ran.messages());
    assert!(ran.messages().contains("NSURF is a word of NCL for which APT has nothing"));
}
