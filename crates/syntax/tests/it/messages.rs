//! Messages: one a bad statement, at the right place, with what to do.

use aptc_diagnostics::codes::{self, Code};
use aptc_syntax::{Options, missing_sign};

use crate::show::read_with;

/// Text, code, the text under the span, the message, part of the help.
type Case = (&'static str, Code, &'static str, &'static str, &'static str);

const CASES: &[Case] = &[
    ("P1=POINT/1,*2,3", codes::EXPECTED_OTHERWISE, "*", "expected a value, found `*`", ""),
    ("A=B+*C", codes::EXPECTED_OTHERWISE, "*", "expected a value, found `*`", ""),
    (
        "A=3+",
        codes::EXPECTED_OTHERWISE,
        "",
        "expected a value, found the end of the statement",
        "`$`",
    ),
    (
        "A=",
        codes::EXPECTED_OTHERWISE,
        "",
        "expected a value or a definition, found the end of the statement",
        "",
    ),
    ("=3", codes::EXPECTED_OTHERWISE, "=", "expected a name left of this `=`", ""),
    ("A=(3=B)", codes::EXPECTED_OTHERWISE, "3", "expected a name left of this `=`", ""),
    (
        "A(1,2)=3",
        codes::EXPECTED_OTHERWISE,
        ",",
        "expected `)` or an operator, found `,`",
        "one subscript",
    ),
    (
        "P1=POINT,1,2",
        codes::EXPECTED_OTHERWISE,
        ",",
        "expected an operator or the end of the statement, found `,`",
        "POINT takes its arguments behind a `/`",
    ),
    (
        "GOTO,1,2,3",
        codes::EXPECTED_OTHERWISE,
        "1",
        "expected a name, found `1`",
        "GOTO takes its arguments behind a `/`",
    ),
    (
        "GOTO(1,2)",
        codes::EXPECTED_OTHERWISE,
        "(",
        "expected `,`, `/` or the end of the statement, found `(`",
        "GOTO takes its arguments behind a `/`",
    ),
    (
        "GOTTO(1)",
        codes::EXPECTED_OTHERWISE,
        "(",
        "expected `,`, `/` or the end of the statement, found `(`",
        "did you mean GOTO?",
    ),
    (
        "A=(1+2)(3)",
        codes::EXPECTED_OTHERWISE,
        "(",
        "expected an operator or the end of the statement, found `(`",
        "missing in front of `(`",
    ),
    (
        "A=2.5X",
        codes::EXPECTED_OTHERWISE,
        "X",
        "expected an operator or the end of the statement, found `X`",
        "missing in front of `X`",
    ),
    (
        "PRINT/3,'A' 'B'",
        codes::EXPECTED_OTHERWISE,
        "'B'",
        "expected `,`, an operator or the end of the statement, found `'B'`",
        "missing in front of `'B'`",
    ),
    (
        "IF(A)1,2",
        codes::EXPECTED_OTHERWISE,
        "",
        "expected `,`, found the end of the statement",
        "three labels",
    ),
    (
        "IF(A)1,2,3,4",
        codes::EXPECTED_OTHERWISE,
        ",",
        "expected the end of the statement, found `,`",
        "three labels",
    ),
    (
        "DO/10,I=1",
        codes::EXPECTED_OTHERWISE,
        "",
        "expected `,` or an operator, found the end of the statement",
        "DO/label",
    ),
    (
        "CALL/",
        codes::EXPECTED_OTHERWISE,
        "",
        "expected the name of a macro, found the end of the statement",
        "CALL/name",
    ),
    (
        "GOTO/1,2,",
        codes::EXPECTED_OTHERWISE,
        ",",
        "expected a value after this `,`, found the end of the statement",
        "`$`",
    ),
    (
        "A=F(1,)",
        codes::EXPECTED_OTHERWISE,
        ",",
        "expected a value after this `,`, found `)`",
        "take the `,` away",
    ),
    (
        "P=POINT/(,2)",
        codes::EXPECTED_OTHERWISE,
        ",",
        "expected a value in the brackets, found `,`",
        "",
    ),
    ("A=()", codes::EXPECTED_OTHERWISE, ")", "expected a value in the brackets, found `)`", ""),
    ("(A)=3", codes::EXPECTED_OTHERWISE, "(", "expected a name, found `(`", "begins with a word"),
    ("A=2*(3+4", codes::UNCLOSED_BRACKET, "(", "this `(` is not closed", ""),
    ("A=3)4", codes::UNOPENED_BRACKET, ")", "this `)` closes no bracket", ""),
    (
        "PRINT/3,'ABC",
        codes::UNCLOSED_QUOTE,
        "'",
        "this ' has no closing ' on its card",
        "close the text",
    ),
    ("A=1.E999", codes::NUMBER_TOO_LARGE, "1.E999", "the number 1.E999 is too large", ""),
    ("A=3&4", codes::ILLEGAL_CHARACTER, "&", "the character `&` is not of APT", ""),
    ("A=B^2", codes::ILLEGAL_CHARACTER, "^", "the character `^` is not of APT", "`A**2`"),
    (
        "A=\u{2212}2",
        codes::ILLEGAL_CHARACTER,
        "\u{2212}",
        "the character `\u{2212}` is not of APT",
        "`-`",
    ),
    (
        "A=.X",
        codes::ILLEGAL_CHARACTER,
        ".",
        "this `.` belongs to no number and no operator",
        "`.5`",
    ),
    (
        "A=1\u{0}",
        codes::ILLEGAL_CHARACTER,
        "\u{0}",
        "the control character \\u{0} is not of APT",
        "",
    ),
    (
        "A=1,$",
        codes::CONTINUED_PAST_END,
        "$",
        "the file ends where the statement should go on",
        "`$`",
    ),
    ("$", codes::CONTINUED_PAST_END, "$", "the file ends where the statement should go on", "`$`"),
    (
        "GOTO P1",
        codes::MISSING_SEPARATOR,
        "GOTO P1",
        "blanks have no meaning: this is the one word GOTOP1",
        "GOTO/P1",
    ),
    (
        "GOTO 1,2,3",
        codes::MISSING_SEPARATOR,
        "GOTO 1",
        "blanks have no meaning: this is the one word GOTO1",
        "GOTO/1",
    ),
    (
        "RAPID GOTO/P1",
        codes::MISSING_SEPARATOR,
        "RAPID GOTO",
        "blanks have no meaning: this is the one word RAPIDGOTO",
        "RAPID,GOTO",
    ),
    (
        "P1 POINT/1,2",
        codes::MISSING_SEPARATOR,
        "P1 POINT",
        "blanks have no meaning: this is the one word P1POINT",
        "P1=POINT",
    ),
    (
        "P1=POINT 1,2",
        codes::MISSING_SEPARATOR,
        "POINT 1",
        "blanks have no meaning: this is the one word POINT1",
        "POINT/1",
    ),
    (
        "ID1 GOTO/P",
        codes::MISSING_SEPARATOR,
        "ID1 GOTO",
        "blanks have no meaning: this is the one word ID1GOTO",
        "ID1) GOTO",
    ),
    (
        "CALL GOGO",
        codes::MISSING_SEPARATOR,
        "CALL GOGO",
        "blanks have no meaning: this is the one word CALLGOGO",
        "CALL/GOGO",
    ),
    (
        "FINI X",
        codes::MISSING_SEPARATOR,
        "FINI X",
        "blanks have no meaning: this is the one word FINIX",
        "stands alone",
    ),
    (
        "IF A-B,1,2,3",
        codes::MISSING_SEPARATOR,
        "IF A",
        "blanks have no meaning: this is the one word IFA",
        "in brackets",
    ),
    (
        "M=MACRO A,B",
        codes::MISSING_SEPARATOR,
        "MACRO A",
        "blanks have no meaning: this is the one word MACROA",
        "MACRO/A",
    ),
    ("GOTOP1", codes::MISSING_SEPARATOR, "GOTOP1", "GOTOP1 is no word of APT", "GOTO/P1"),
    ("GOTO1,2,3", codes::MISSING_SEPARATOR, "GOTO1", "GOTO1 is no word of APT", "GOTO/1"),
    ("P1POINT/1,2", codes::MISSING_SEPARATOR, "P1POINT", "P1POINT is no word of APT", "P1=POINT"),
    (
        "TLLFTGOLFT/L1",
        codes::MISSING_SEPARATOR,
        "TLLFTGOLFT",
        "TLLFTGOLFT is no word of APT",
        "TLLFT,GOLFT",
    ),
    ("P1=POINT1,2", codes::MISSING_SEPARATOR, "POINT1", "POINT1 is no word of APT", "POINT/1"),
];

#[test]
fn each_mistake_has_its_message() {
    for &(text, code, under, message, help) in CASES {
        let (_, parsed, _) = read_with(&format!("B=1\n{text}"), &Options::default());
        let [d] = &parsed.diagnostics[..] else { panic!("{text}: {:?}", parsed.diagnostics) };
        let whole = format!("B=1\n{text}");
        let at = &whole[d.span.start as usize..d.span.end as usize];
        assert_eq!((d.code, at, &d.message[..]), (code, under, message), "{text}");
        assert!(d.help.as_deref().unwrap_or("").contains(help), "{text}: {:?}", d.help);
        assert!(d.is_error());
    }
}

#[test]
fn the_context_stands_beside() {
    for (text, label) in [
        ("L=LINE/(POINT/1,*),P", "among the arguments of POINT"),
        ("L=LINE/P,*", "among the arguments of LINE"),
        ("TLLFT,GOLFT/L1,*", "among the arguments of GOLFT"),
        ("A=SINF(*)", "in the brackets behind SINF"),
        ("A=3*(4+*)", "in these brackets"),
    ] {
        let (_, parsed, _) = read_with(text, &Options::default());
        assert_eq!(parsed.diagnostics[0].label, label, "{text}");
    }
}

#[test]
fn ten_mistakes_give_ten_messages() {
    let text: String =
        CASES.iter().take(10).flat_map(|c| [c.0, "\n", "C=1\n"]).collect::<Vec<_>>().concat();
    let (shown, parsed, _) = read_with(&text, &Options::default());
    assert_eq!(parsed.diagnostics.len(), 10);
    assert_eq!(shown.iter().filter(|s| *s == "C=1").count(), 10);
}

#[test]
fn words_of_unknown_post_processors_pass() {
    for text in ["MYWORD/1", "SPINDX/2", "COOLON", "CUTTEX/1", "LINEX/2"] {
        let (_, parsed, _) = read_with(text, &Options::default());
        assert_eq!(parsed.diagnostics, [], "{text}");
    }
}

#[test]
fn a_lost_continuation_gives_one_message() {
    for text in ["GOTO/1,2,\n3\nA=1", "A=1+\n2\nA=1", "P=POINT/(LINE/1,\n,2\n*3\nA=1"] {
        let (shown, parsed, _) = read_with(text, &Options::default());
        assert_eq!(parsed.diagnostics.len(), 1, "{text}");
        assert!(!parsed.diagnostics[0].labels.is_empty(), "{text}");
        assert_eq!(shown.last().map(String::as_str), Some("A=1"), "{text}");
    }
    // But not where the next statement is wrong by itself, or further down.
    for text in ["GOTO/1,2,\nGOTO/*\nA=1", "A=1+\n$$ why\n2"] {
        let (_, parsed, _) = read_with(text, &Options::default());
        assert_eq!(parsed.diagnostics.len(), 2, "{text}");
    }
    let (_, parsed, _) = read_with("TLLFT,GOLFT/L1,TO\n,L2", &Options::default());
    assert!(parsed.diagnostics[0].help.as_deref().unwrap_or("").contains("card before"));
}

#[test]
fn limits_have_messages() {
    let deep = |n: usize| format!("A={}1{}", "(".repeat(n), ")".repeat(n));
    let free = Options { free_form: true, ..Options::default() };
    let code = |text: &str, options: &Options| {
        let (_, parsed, _) = read_with(text, options);
        assert!(parsed.diagnostics.len() <= 1);
        parsed.diagnostics.first().map(|d| d.code)
    };
    assert_eq!(code(&deep(64), &free), None);
    assert_eq!(code(&deep(65), &free), Some(codes::TOO_DEEP));
    assert_eq!(code(&deep(40_000), &free), Some(codes::TOO_DEEP));
    assert_eq!(code(&format!("A=1{}", "+1".repeat(390)), &free), None);
    assert_eq!(code(&format!("A=1{}", "+1".repeat(401)), &free), Some(codes::TOO_DEEP));
    assert_eq!(code(&format!("A={}1", "-".repeat(401)), &free), Some(codes::TOO_DEEP));
    assert_eq!(code(&format!("A={}1", "2**".repeat(401)), &free), Some(codes::TOO_DEEP));
    assert_eq!(code(&format!("A={}1", "B=".repeat(401)), &free), Some(codes::TOO_DEEP));
    let short = Options { max_elements: 10, ..free.clone() };
    assert_eq!(code("GOTO/1,2,3,4", &short), None);
    assert_eq!(code("GOTO/1,2,3,4,5,6", &short), Some(codes::STATEMENT_TOO_LONG));
    assert_eq!(code(&format!("A={}", "1".repeat(401)), &free), Some(codes::NUMBER_TOO_LARGE));
    assert_eq!(code(&format!("GOTO/1{}", ",1".repeat(40_000)), &free), None);
}

#[test]
fn an_unknown_name_may_be_several() {
    assert_eq!(missing_sign("TO L1").as_deref(), None);
    assert_eq!(missing_sign("SINF 30").as_deref(), Some("write SINF(30)"));
    assert_eq!(missing_sign("GO TO P1").as_deref(), Some("put a `/` behind GOTO: GOTO/P1"));
    assert_eq!(missing_sign("GOTOP1"), None);
    assert_eq!(missing_sign("P 1"), None);
}
