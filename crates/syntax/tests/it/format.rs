//! The formatter: one style, the same meaning, nothing lost.

use aptc_diagnostics::FileId;
use aptc_syntax::tree::Body;
use aptc_syntax::{FormatOptions, Interner, Options, format, parse};
use proptest::prelude::*;

use crate::corpus::files;
use crate::robust::pieces;
use crate::show::read_with;

fn formatted(text: &str) -> String {
    format(text, &FormatOptions::default())
}

#[test]
fn one_style() {
    for (text, wanted) in [
        ("p1=point / 1 , 2", "P1 = POINT/1,2"),
        ("go to/p , 1.e-3", "GOTO/P,1.E-3"),
        ("  rapid ,goto/ (point/1,2)", "  RAPID,GOTO/(POINT/1,2)"),
        ("a (I = i+1)=-b ** 2", "A(I=I+1) = -B**2"),
        ("12)a=1", "12) A = 1"),
        ("lab :   goto/p", "LAB:    GOTO/P"),
        ("12 )", "12)"),
        ("if( a-1 )2 ,3, x", "IF(A-1) 2,3,X"),
        ("if(a .eq .5)b=1", "IF(A.EQ..5) B = 1"),
        ("b=.not a.and..true", "B = .NOT.A.AND..TRUE."),
        ("v=v1 kreuz v2", "V = V1 KREUZ V2"),
        ("m = macro / a, b = 2", "M = MACRO/A,B=2"),
        ("call / m, b = 'x y'", "CALL/M,B='x y'"),
        ("do/5,i = 1 ,3", "DO/5,I=1,3"),
        ("pl=(plane/0,0,1,d)canon", "PL = (PLANE/0,0,1,D)CANON"),
        ("partno  Test  9 ", "PARTNO  Test  9"),
        ("insertG0g49 $$ x", "INSERTG0g49 $$ x"),
        ("if(a) pprint Too big", "IF(A) PPRINT Too big"),
        ("\ta=1\t$$ one", "        A = 1   $$ one"),
        ("a=1      $$ one", "A = 1    $$ one"),
        ("a=1$$one", "A = 1 $$one"),
        ("$$ A  comment ", "$$ A  comment"),
        ("goto/1, $ first\n2", "GOTO/1, $ first\n2"),
        ("goto/1, $\n  2", "GOTO/1,$\n  2"),
        ("go$\n to/p", "GOTO$\n /P"),
        ("", ""),
    ] {
        let wanted = if wanted.is_empty() { String::new() } else { wanted.to_owned() + "\n" };
        assert_eq!(formatted(text), wanted, "{text:?}");
        assert_eq!(formatted(&wanted), wanted, "{text:?} again");
    }
}

#[test]
fn what_cannot_be_read_or_is_doubtful_stays() {
    for text in
        ["p1=point/1,*  2\n", "goto p1\n", "a = 1 2\n", "% ncl\n", "print/3,'abc\n", "a=1,$\n"]
    {
        assert_eq!(formatted(text), text);
    }
    assert_eq!(formatted("a=(1\nb=2\n"), "a=(1\nB = 2\n");
}

#[test]
fn line_ends_and_end_marks_stay() {
    assert_eq!(formatted("a=1\r\nb=2\r\n\u{1a}"), "A = 1\r\nB = 2\r\n\u{1a}");
    assert_eq!(formatted("\u{feff}a=1"), "\u{feff}A = 1\n");
    assert_eq!(formatted("\n\n\na=1\n\n"), "\n\n\nA = 1\n\n");
}

#[test]
fn identification_goes_or_stays() {
    let card = |text: &str, tail: &str| format!("{text:<72}{tail}\n");
    let text = card("a=1", "TEST0010")
        + &card("goto/1,$", "TEST0020")
        + &card("2 $$ two", "TEST0030")
        + &card("partno x", "TEST0040")
        + &card("$$ y", "TEST0050");
    assert_eq!(formatted(&text), "A = 1\nGOTO/1,$\n2 $$ two\nPARTNO x\n$$ y\n");
    let keep = FormatOptions { keep_identification: true, ..FormatOptions::default() };
    let kept = card("A = 1", "TEST0010")
        + &card("GOTO/1,$", "TEST0020")
        + &card("2 $$ two", "TEST0030")
        + &card("PARTNO x", "TEST0040")
        + &card("$$ y", "TEST0050");
    assert_eq!(format(&text, &keep), kept);
    // What is no identification may have been meant to be read.
    let text = card("a=1", "+2");
    assert_eq!(formatted(&text), text);
    // Behind a `$` it is a comment.
    let text = card("goto/1,$", ",2 ") + "2\n";
    assert_eq!(formatted(&text), format!("{:<73},2\n2\n", "GOTO/1, $"));
}

#[test]
fn a_text_that_goes_on_in_the_next_card_stays() {
    let text = "GOTO/'$GOTO\n'$$\n";
    assert_eq!(formatted(text), text);
}

#[test]
fn long_lines_are_divided_behind_commas() {
    let long = format!("tp=tabcyl/noz,spline{}", ",1.25".repeat(10));
    assert_eq!(long.len(), 70);
    let twice = formatted(&format!("l){long}"));
    assert_eq!(
        twice,
        "L) TP = TABCYL/NOZ,SPLINE,1.25,1.25,1.25,1.25,1.25,1.25,1.25,1.25,1.25,$\n      1.25\n"
    );
    assert_eq!(formatted(&twice), twice);
    let free = FormatOptions { free_form: true, ..FormatOptions::default() };
    assert_eq!(
        format(&format!("{long},3"), &free),
        format!("{},3\n", long.to_uppercase().replace('=', " = "))
    );
}

/// Statements apart from their places, numbers included.
fn meaning(text: &str, free_form: bool) -> Vec<(u32, String)> {
    let options = Options { free_form, ..Options::default() };
    let (shown, parsed, _) = read_with(text, &options);
    parsed.program.statements.iter().map(|s| s.isn).zip(shown).collect()
}

fn check(text: &str, options: &FormatOptions) -> Result<(), TestCaseError> {
    let once = format(text, options);
    prop_assert_eq!(
        meaning(text, options.free_form),
        meaning(&once, options.free_form),
        "{}",
        once
    );
    let twice = format(&once, options);
    prop_assert_eq!(&once, &twice, "from {:?}", text);
    // Comments are all there.
    let letters = |text: &str| {
        let comments = text.lines().filter(|l| l.trim_start().starts_with("$$"));
        comments.map(|l| l.trim_end().to_owned()).collect::<Vec<_>>()
    };
    prop_assert!(options.free_form || letters(text).len() <= letters(&once).len());
    Ok(())
}

#[test]
fn real_programs_mean_the_same_and_stay() {
    for folder in ["apt360", "ssv3", "ncl"] {
        for (name, text) in files("real_programs_mean_the_same_and_stay", folder) {
            for keep_identification in [false, true] {
                let options = FormatOptions { keep_identification, ..FormatOptions::default() };
                check(&text, &options).unwrap_or_else(|e| panic!("{name}: {e}"));
            }
        }
    }
}

#[test]
fn most_lines_of_real_programs_are_formatted() {
    for (name, text) in files("most_lines_of_real_programs_are_formatted", "apt360") {
        let once = formatted(&text);
        let mut interner = Interner::default();
        let parsed = parse(FileId(0), &once, &mut interner, &Options::default());
        let read =
            parsed.program.statements.iter().filter(|s| !matches!(s.body, Body::Text { .. }));
        for s in read {
            let line = once.lines().nth(s.line as usize - 1).unwrap_or_default();
            let code = line.split('$').next().unwrap_or_default();
            let word: String = code.chars().take_while(char::is_ascii_alphabetic).collect();
            assert!(
                !word.bytes().any(|b| b.is_ascii_lowercase()) || line.len() > 72,
                "{name}: {line}"
            );
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(1500) })]

    #[test]
    fn any_text_means_the_same_and_stays(text in pieces(), free_form in any::<bool>(), keep_identification in any::<bool>()) {
        check(&text, &FormatOptions { free_form, keep_identification })?;
    }

    #[test]
    fn any_bytes_mean_the_same_and_stay(bytes in prop::collection::vec(any::<u8>(), 0..200)) {
        check(&String::from_utf8_lossy(&bytes), &FormatOptions::default())?;
    }
}
