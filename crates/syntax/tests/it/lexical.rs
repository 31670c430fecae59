//! Cards, comments, continuation, blanks, numbers, names.

use aptc_diagnostics::codes;
use aptc_syntax::Options;

use crate::show::{one, read, read_with};

#[test]
fn blanks_and_case_have_no_meaning() {
    assert_eq!(one("  go TO/ p 1,- 1.5 , a b C"), "GOTO/P1,(Neg 1.5),ABC");
}

#[test]
fn tabs_are_blanks_and_one_column_each() {
    assert_eq!(one("\tGO\tTO/\tP1\t$$ there"), "GOTO/P1");
    let text = format!("{}GOTO/1{}", "\t".repeat(66), ",2");
    let (shown, parsed, _) = read_with(&text, &Options::default());
    assert_eq!(shown, ["error "]);
    assert_eq!(parsed.diagnostics[0].code, codes::TEXT_BEHIND_CARD);
    assert_eq!(parsed.diagnostics[0].span.start, 72);
}

#[test]
fn two_dollars_end_the_text_and_one_goes_on() {
    assert_eq!(one("A=3$$ three"), "A=3");
    assert_eq!(read("$$ nothing\n\n   \n A=1"), ["A=1"]);
    assert_eq!(one("GOTO/1,  $ the rest is no text: 7,8\n  2,$\n3"), "GOTO/1,2,3");
    assert_eq!(one("GO$\nTO/P$\n1"), "GOTO/P1");
    assert_eq!(read("d3=.25$$corner rad\nd4=12 $$ holes"), ["D3=0.25", "D4=12"]);
    assert_eq!(read("$$$$$$$$$$ a line"), [""; 0]);
}

#[test]
fn line_ends_and_the_end_mark_of_dos() {
    assert_eq!(read("A=1\r\nB=2\r\n\u{1a}"), ["A=1", "B=2"]);
    assert_eq!(read("A=1\r\nB=2\u{1a}\0\0\0"), ["A=1", "B=2"]);
    assert_eq!(read("\u{feff}A=1"), ["A=1"]);
    assert_eq!(read("\u{c}A=B+$\r\n2"), ["A=(Add B 2)"]);
}

#[test]
fn text_that_is_not_ascii_stays_in_comments_and_literals() {
    assert_eq!(one("PRINT/3,'Größe  µ' $$ Füße"), "PRINT/3,'Größe  µ'");
    assert_eq!(one("PPRINT  Maß 5 µm — fertig "), "PPRINT[Maß 5 µm — fertig]");
}

#[test]
fn statement_numbers_count_all_cards_but_continuations() {
    let text = "A=1\n$$ comment\n\nB=$\n2\nC=3";
    let (_, parsed, _) = read_with(text, &Options { first_isn: 10, ..Options::default() });
    let numbers: Vec<_> = parsed.program.statements.iter().map(|s| (s.isn, s.line)).collect();
    assert_eq!(numbers, [(10, 1), (13, 4), (14, 6)]);
    assert_eq!(parsed.program.n_cards, 5);
}

#[test]
fn spans_are_bytes_of_the_file() {
    let text = "A = 1\n  L1) GO TO / $ on\n P , 2 $$ there\n";
    let (_, parsed, _) = read_with(text, &Options::default());
    let spans: Vec<_> = parsed.program.statements.iter().map(|s| s.span).collect();
    let piece = |i: usize| &text[spans[i].start as usize..spans[i].end as usize];
    assert_eq!(piece(0), "A = 1");
    assert_eq!(piece(1), "L1) GO TO / $ on\n P , 2");
}

#[test]
fn numbers() {
    for (text, value) in [
        (".5", 0.5),
        ("5.", 5.0),
        ("0.5", 0.5),
        ("1.E-3", 0.001),
        ("1.D5", 1e5),
        (".5D+1", 5.0),
        ("12.5E2", 1250.0),
        ("1.e36", 1e36),
        ("0001234567890123456", 1_234_567_890_123_456.0),
        ("439F400000000000000.", f64::NAN),
    ] {
        if value.is_nan() {
            continue;
        }
        assert_eq!(one(&format!("A={text}")), format!("A={value}"), "{text}");
    }
}

#[test]
fn digits_with_letters_are_symbols() {
    assert_eq!(one("CTAN=(7X-3X)/(7Y-2Y)"), "CTAN=(Div (Sub 7X 3X) (Sub 7Y 2Y))");
    assert_eq!(one("A=1E5"), "A=1E5");
    assert_eq!(one("2DCALC"), "2DCALC");
    assert_eq!(one("C=LCONIC/5PT,P1"), "C={LCONIC/5PT,P1}");
    assert_eq!(one("1C9(2)=3PT2SL"), "1C9(2)=3PT2SL");
}

#[test]
fn relations_in_both_spellings() {
    assert_eq!(one("B=A.EQ.C"), "B=(Eq A C)");
    assert_eq!(one("B=A .EQ C"), "B=(Eq A C)");
    assert_eq!(one("B=1.EQ.2"), "B=(Eq 1 2)");
    assert_eq!(one("B=1..EQ.2"), "B=(Eq 1 2)");
    assert_eq!(one("B=1.5.GE.2.5"), "B=(Ge 1.5 2.5)");
    assert_eq!(one("B=V1.LT.1.2"), "B=(Lt V1 1.2)");
    assert_eq!(one("B=A.EQ..5"), "B=(Eq A 0.5)");
    assert_eq!(one("B=A .EQ .5"), "B=(Eq A 0.5)");
    assert_eq!(one("B=3 .EQ .5"), "B=(Eq 3 0.5)");
    assert_eq!(one("B=A.EQ.5"), "B=(Eq A 5)");
    assert_eq!(one("B=A.AND.NOT.C"), "B=(And A (Not C))");
    assert_eq!(one("B=.NOT.A.AND..TRUE.OR.FALSE"), "B=(Or (And (Not A) true) false)");
}

#[test]
fn vector_products() {
    assert_eq!(one("V=V1 KREUZ V2"), "V=(Cross V1 V2)");
    assert_eq!(one("V=V1 dot v2 kreuz V3"), "V=(Cross (Dot V1 V2) V3)");
    assert_eq!(one("V=(V1)KREUZ(V2)"), "V=(Cross V1 V2)");
    assert_eq!(one("V=V1 KREUZ (VECTOR/1,0,0)"), "V=(Cross V1 {VECTOR/1,0,0})");
    assert_eq!(one("V=V1.KREUZ.V2"), "V=(Cross V1 V2)");
    assert_eq!(one("KREUZ=3"), "KREUZ=3");
    assert_eq!(one("A=DOT"), "A=DOT");
}

#[test]
fn fixed_field_words_take_the_rest_of_the_card() {
    for (text, shown) in [
        ("PARTNO  TEST PROGRAM", "PARTNO[TEST PROGRAM]"),
        ("PARTNO TEST      $$ PROGRAM", "PARTNO[TEST      $$ PROGRAM]"),
        ("remarkin APT\" by Kral", "REMARK[in APT\" by Kral]"),
        ("pprint**7/32 em** ", "PPRINT[**7/32 em**]"),
        ("INSERTG0G49G80Z0", "INSERT[G0G49G80Z0]"),
        ("INSERT(7/32 2FL)$$*TOOL*", "INSERT[(7/32 2FL)$$*TOOL*]"),
        ("INSERT/N5 G0", "INSERT[/N5 G0]"),
        ("INSERTX=3", "INSERT[X=3]"),
        ("TITLES      XN     ZN  $ ", "TITLES[XN     ZN  $]"),
        ("TITLES", "TITLES[]"),
        ("   5B) PPRINT HERE", "5B) PPRINT[HERE]"),
        ("LAB: REMARK HERE", "LAB) REMARK[HERE]"),
        ("\tPART NO 17", "PARTNO[17]"),
        ("PARTNO/'FURTHER TESTS'", "PARTNO[FURTHER TESTS]"),
        ("PARTNO / 'A  B' $$ C", "PARTNO[A  B]"),
        ("partno/ a sine profile ", "PARTNO[a sine profile]"),
        ("REMARK = EVERYTHING ELSE", "REMARK[= EVERYTHING ELSE]"),
        ("REMARK ==== A ====", "REMARK[==== A ====]"),
        ("PPRINT 'A' 'B'", "PPRINT['A' 'B']"),
        ("IF(A.GT.(B))PPRINT TOO  BIG", "if (Gt A B) then PPRINT[TOO  BIG]"),
        ("9) IF (A) INSERT G4", "9) if A then INSERT[G4]"),
    ] {
        assert_eq!(one(text), shown, "{text}");
    }
}

#[test]
fn what_follows_decides_whether_a_fixed_field_word_is_a_symbol() {
    assert_eq!(one("INSERT=3"), "INSERT=3");
    assert_eq!(one("remark = 3*(A+B) $$ not text"), "REMARK=(Mul 3 (Add A B))");
    assert_eq!(one("7) TITLES=-A"), "7) TITLES=(Neg A)");
}

#[test]
fn only_columns_1_to_72_count() {
    let card = |text: &str, tail: &str| format!("{text:<72}{tail}\n");
    // Identification is dropped without a word.
    let text = card("A=1", "TEST0010") + &card("B=2+$", "TEST0020") + &card("X", "TEST0030");
    let (shown, parsed, _) = read_with(&text, &Options::default());
    assert_eq!(shown, ["A=1", "B=(Add 2 X)"]);
    assert_eq!(parsed.diagnostics, []);
    assert_eq!(read(&card("GOTO/1", "     010")), ["GOTO/1"]);
    assert_eq!(read(&card("GOTO/1", "    a011")), ["GOTO/1"]);
    // A `$` in column 73 is lost.
    let (shown, parsed, _) = read_with(&(card("A=1+2", "$") + "B=3"), &Options::default());
    assert_eq!(shown, ["A=(Add 1 2)", "B=3"]);
    assert_eq!(parsed.diagnostics.len(), 1);
    assert_eq!(parsed.diagnostics[0].code, codes::TEXT_BEHIND_CARD);
    assert!(!parsed.diagnostics[0].is_error());
    assert_eq!(parsed.diagnostics[0].span.start, 72);
    // In free form nothing is.
    let free = Options { free_form: true, ..Options::default() };
    let (shown, parsed, _) = read_with(&(card("A=1+2", "+4") + "B=3"), &free);
    assert_eq!(shown, ["A=(Add (Add 1 2) 4)", "B=3"]);
    assert_eq!(parsed.diagnostics, []);
}

#[test]
fn text_behind_the_card_gives_one_warning_a_file() {
    let card = |text: &str, tail: &str| format!("{text:<72}{tail}\n");
    let count = |text: &str| {
        let (_, parsed, _) = read_with(text, &Options::default());
        let warnings: Vec<_> =
            parsed.diagnostics.iter().filter(|d| d.code == codes::TEXT_BEHIND_CARD).collect();
        assert!(warnings.len() <= 1);
        warnings.first().map_or(String::new(), |d| d.message.clone())
    };
    assert_eq!(count(&card("A=1", ",L2")), "text behind column 72 is not read");
    assert_eq!(count(&card("A=1", "L2")), "text behind column 72 is not read");
    assert_eq!(count(&card("A=1", "TEST0010 MORE")), "text behind column 72 is not read");
    let several = card("A=1", "+3") + &card("B=1", "+4") + &card("C=1", "TEST0030");
    assert_eq!(count(&several), "text behind column 72 of 2 cards is not read");
    // Comments may be of any length, and so may remarks.
    assert_eq!(count(&card("$$ A", "+3")), "");
    assert_eq!(count(&card("A=1 $$ B", "+3")), "");
    assert_eq!(count(&card("REMARK", "AND SO ON")), "");
    // A habit of the file: the same letters in the same columns.
    let habit: String = (10..14).map(|n| card("A=1", &format!("AB{n}"))).collect();
    assert_eq!(count(&habit), "");
}

#[test]
fn a_statement_that_goes_on_behind_column_72_gives_one_error() {
    // Cut off in a bracket, in a name, behind a comma, before a `$`, and where a comma is left to the next card.
    let card = |text: &str, tail: &str| format!("{text:>72}{tail}\n");
    let cut = [
        card("L1=LINE/(POINT/0,0),(POINT/100,", "0)"),
        card("L1=LINE/PONE,P", "TWO"),
        card("L1=LINE/PONE", " ,PTWO"),
        card("L1=LINE/PONE,", "(POINT/100,0)"),
        card("L1=LINE/P1,LEFT,TANTO,C1,", "$") + "RIGHT,TANTO,C2\n",
        card("L1=LINE/P1,LEFT,TANTO,C1", "$") + ",RIGHT,TANTO,C2\n",
    ];
    let words = "text behind column 72 is not read, and a statement is cut off there";
    for text in &cut {
        let text = text.clone() + "GOTO/1,2\n";
        let (shown, parsed, _) = read_with(&text, &Options::default());
        let found: Vec<_> = parsed.diagnostics.iter().map(|d| (d.code, d.is_error())).collect();
        assert_eq!(found, [(codes::TEXT_BEHIND_CARD, true)], "{text}{:?}", parsed.diagnostics);
        assert_eq!(parsed.diagnostics[0].message, words);
        // The name that the statement would have given is known as such.
        assert_eq!(shown.first().map(String::as_str), Some("error L1"), "{text}");
        assert_eq!(shown.last().map(String::as_str), Some("GOTO/1,2"), "{text}");
    }
    // A remark with room before it changes nothing.
    let remark = format!("{:<70}{:>8}", "GOTO/1,2", "REV A");
    let (shown, parsed, _) = read_with(&remark, &Options::default());
    assert_eq!(shown, ["GOTO/1,2"]);
    assert!(!parsed.diagnostics[0].is_error());
    // Two cards, one of them cut off.
    let text = card("L1=LINE/PONE,P", "TWO") + &remark;
    let (_, parsed, _) = read_with(&text, &Options::default());
    let found: Vec<_> = parsed.diagnostics.iter().map(|d| d.message.as_str()).collect();
    assert_eq!(
        found,
        ["text behind column 72 of 2 cards is not read, and a statement is cut off there"]
    );
}

#[test]
fn a_blank_inside_a_number_is_doubtful() {
    // A symbol, `3 B`, is told where it has no value.
    assert!(read_with("A=3 B", &Options::default()).1.diagnostics.is_empty());
    for text in ["GOTO/1 2,3", "A=1. 5", "GOTO/1,2$\n3,4"] {
        let (_, parsed, _) = read_with(text, &Options::default());
        let found: Vec<_> = parsed.diagnostics.iter().map(|d| (d.code, d.is_error())).collect();
        assert_eq!(found, [(codes::BLANK_IN_NUMBER, false)], "{text}");
    }
}

#[test]
fn ncl_comments_give_one_message() {
    let (shown, parsed, _) = read_with("% one\nA=1\n  % two\n%\n", &Options::default());
    assert_eq!(shown, ["A=1"]);
    assert_eq!(parsed.diagnostics.len(), 1);
    assert_eq!(parsed.diagnostics[0].code, codes::NCL_COMMENT);
    let ncl = Options { percent_comments: true, ..Options::default() };
    let (shown, parsed, _) = read_with("% one\nA=1\n  % two\n%\n", &ncl);
    assert_eq!((shown.as_slice(), parsed.diagnostics.len()), (["A=1".to_owned()].as_slice(), 0));
}
