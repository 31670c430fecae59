//! Any input at all: no panic, bounded trees, spans inside the text.

use aptc_syntax::Options;
use proptest::prelude::*;

use crate::show::read_with;

/// Pieces from which statements are made that look like APT, right or wrong.
pub(crate) fn pieces() -> impl Strategy<Value = String> {
    let piece = prop::sample::select(vec![
        "GOTO",
        "P1",
        "POINT",
        "LINE",
        "A",
        "IF",
        "DO",
        "CALL",
        "MACRO",
        "SYN",
        "/",
        ",",
        "=",
        "(",
        ")",
        "+",
        "-",
        "*",
        "**",
        ".",
        "5",
        "1.5",
        ".EQ.",
        ".NOT.",
        "KREUZ",
        "DOT",
        "$",
        "$$",
        "\n",
        "\r\n",
        " ",
        "\t",
        ":",
        "'",
        "\"",
        "PARTNO",
        "INSERT",
        "REMARK=",
        "%",
        "é",
        "1E5",
        "2DCALC",
        "\u{1a}",
        "CANON",
        "((((",
        "))))",
        "TEST0010",
        "                                        ",
    ]);
    prop::collection::vec(piece, 0..80).prop_map(|v| v.concat())
}

fn check(text: &str, free_form: bool) {
    let options = Options { free_form, ..Options::default() };
    let (shown, parsed, _) = read_with(text, &options);
    let end = u32::try_from(text.len()).expect("a short text");
    let errors = shown.iter().filter(|s| s.contains("error ")).count();
    // A statement that broke off for want of a `$` shares its message with what should follow.
    let messages: usize =
        parsed.diagnostics.iter().filter(|d| d.is_error()).map(|d| 1 + d.labels.len()).sum();
    assert!(messages >= errors, "{text:?} {shown:?} {:?}", parsed.diagnostics);
    let mut last = 0;
    for s in &parsed.program.statements {
        assert!(s.span.start <= s.span.end && s.span.end <= end, "{text:?}");
        assert!(s.span.start >= last, "{text:?}");
        last = s.span.start;
        assert!(text.get(s.span.start as usize..s.span.end as usize).is_some(), "{text:?}");
    }
    for d in &parsed.diagnostics {
        assert!(text.get(d.span.start as usize..d.span.end as usize).is_some(), "{text:?} {d:?}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(2000) })]

    #[test]
    fn bytes_never_panic(bytes in prop::collection::vec(any::<u8>(), 0..400), free in any::<bool>()) {
        check(&String::from_utf8_lossy(&bytes), free);
    }

    #[test]
    fn pieces_of_statements_never_panic(text in pieces(), free in any::<bool>()) {
        check(&text, free);
    }

    /// Blanks between the tokens change nothing but the places.
    #[test]
    fn blanks_change_nothing(
        values in prop::collection::vec((0_u32..2000, -3_i32..3), 1..8),
        gaps in prop::collection::vec(0_usize..3, 40),
    ) {
        let mut tokens = vec!["GOTO".to_owned(), "/".to_owned()];
        for (i, (a, e)) in values.iter().enumerate() {
            if i > 0 {
                tokens.push(",".to_owned());
            }
            tokens.extend(["(".to_owned(), format!("{a}.5E{e}"), "+".to_owned(), format!("S{a}"), ")".to_owned()]);
        }
        let tight = tokens.concat();
        let mut gaps = gaps.into_iter().cycle();
        let loose: String =
            tokens.iter().map(|t| t.clone() + &" ".repeat(gaps.next().unwrap_or(0))).collect();
        let free = Options { free_form: true, ..Options::default() };
        prop_assert_eq!(read_with(&tight, &free).0, read_with(&loose, &free).0);
    }
}

#[test]
fn long_chains_are_read_and_dropped() {
    let free = Options { free_form: true, max_bracket_depth: 100_000, ..Options::default() };
    for text in [
        format!("A={}1{}", "(".repeat(390), ")".repeat(390)),
        format!("A={}1{}", "F(".repeat(390), ")".repeat(390)),
        format!("A={}1,2{}", "(POINT/".repeat(390), ")".repeat(390)),
        format!("A={}1{}", "(B=".repeat(190), ")".repeat(190)),
        format!("A={}1", "-".repeat(390)),
        format!("A={}1", "2**".repeat(390)),
        format!("IF(A){}", "IF(A)".repeat(1000) + "B=1"),
    ] {
        let (shown, _, _) = read_with(&text, &free);
        assert_eq!(shown.len(), 1);
        check(&text, true);
    }
}
