//! What kind of change a golden has undergone.

/// How a text differs from its golden.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Change {
    /// Not at all.
    None,
    /// Comments, blanks, line breaks or digits below `SAME`: the part is the same.
    Cosmetic {
        /// First line, from 1, that differs.
        line: usize,
    },
    /// In words or numbers.
    Real {
        /// First line, from 1, that differs in meaning.
        line: usize,
        /// That line of the golden; empty past its end.
        golden: String,
        /// That line of the new text.
        new: String,
    },
}

/// Numbers that differ by less than this part of the greatest number in the golden are the same. Coarser
/// than the last digit that is written, finer than any tolerance a program asks for.
const SAME: f64 = 1e-7;

/// Compares a text with its golden.
pub fn change(golden: &str, new: &str) -> Change {
    let first = golden.lines().zip(new.lines()).take_while(|(a, b)| a == b).count() + 1;
    if golden == new {
        return Change::None;
    }
    let (old, young) = (tokens(golden), tokens(new));
    let numbers = old.iter().filter_map(|token| token.value);
    let scale = numbers.fold(1.0, |most: f64, value| most.max(value.abs()));
    let same = |(a, b): &(&Token<'_>, &Token<'_>)| match (a.value, b.value) {
        (Some(a), Some(b)) => (a - b).abs() <= SAME * scale,
        _ => a.text == b.text,
    };
    let equal = old.iter().zip(&young).take_while(same).count();
    if equal == old.len() && equal == young.len() {
        return Change::Cosmetic { line: first };
    }
    let line_of = |tokens: &[Token<'_>]| tokens.get(equal).map(|token| token.line);
    let line_at = |text: &str, n: Option<usize>| {
        n.and_then(|n| text.lines().nth(n - 1)).unwrap_or_default().trim().to_owned()
    };
    let (in_golden, in_new) = (line_of(&old), line_of(&young));
    Change::Real {
        line: in_golden.or(in_new).unwrap_or(first),
        golden: line_at(golden, in_golden),
        new: line_at(new, in_new),
    }
}

struct Token<'a> {
    text: &'a str,
    value: Option<f64>,
    line: usize,
}

/// Words, numbers and signs, without comments (`$$`, `;`, `(...)` at the start of a line) and without the `$`
/// that continues a line.
fn tokens(text: &str) -> Vec<Token<'_>> {
    let mut tokens = Vec::new();
    for (whole, line) in text.lines().zip(1..) {
        let mut rest = whole.split("$$").next().unwrap_or_default();
        if rest.starts_with([';', '(', '%']) {
            continue;
        }
        loop {
            rest = rest.trim_start_matches(|c: char| c.is_whitespace() || c == '$');
            if rest.is_empty() {
                break;
            }
            let length = token_length(rest);
            let (token, after) = rest.split_at(length);
            tokens.push(Token { text: token, value: token.parse().ok(), line });
            rest = after;
        }
    }
    tokens
}

/// Length of the token that `rest` begins with: a number, a run of letters, or one other character. In
/// machine code `X12.5` is a letter and a number.
fn token_length(rest: &str) -> usize {
    let bytes = rest.as_bytes();
    let numeric = |b: u8| b.is_ascii_digit() || b == b'.';
    let signed = matches!(bytes[0], b'-' | b'+') && bytes.get(1).is_some_and(|b| numeric(*b));
    if numeric(bytes[0]) || signed {
        let mut end = 1 + bytes[1..].iter().take_while(|b| numeric(**b)).count();
        if bytes.get(end).is_some_and(|b| matches!(b, b'e' | b'E')) {
            let sign = usize::from(matches!(bytes.get(end + 1), Some(b'-' | b'+')));
            let digits = bytes[end + 1 + sign..].iter().take_while(|b| b.is_ascii_digit()).count();
            end += if digits > 0 { 1 + sign + digits } else { 0 };
        }
        return end;
    }
    let letters = bytes.iter().take_while(|b| b.is_ascii_alphabetic()).count();
    if letters > 0 { letters } else { rest.chars().next().map_or(1, char::len_utf8) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn blanks_comments_and_last_digits_are_cosmetic() {
        let golden = "$$ LINE 3\nGOTO/1,2.5,-3E-4\n";
        assert_eq!(change(golden, golden), Change::None);
        for new in [
            "$$ LINE 4\nGOTO/1,2.5,-3E-4\n",
            "$$ LINE 3\nGOTO / 1.0, 2.50,$\n -.0003\n",
            "$$ LINE 3\nGOTO/1.00000001,2.5,-3E-4\n",
        ] {
            assert!(matches!(change(golden, new), Change::Cosmetic { .. }), "{new}");
        }
        assert!(matches!(change("N10 G1 X1.0\n", "N10 G01 X1.\n"), Change::Cosmetic { line: 1 }));
    }

    #[test]
    fn a_changed_position_is_real() {
        let golden = "FROM/0,0,0\nGOTO/1,2,3\n";
        for new in ["FROM/0,0,0\nGOTO/1,2,4\n", "FROM/0,0,0\n", "FROM/0,0,0\nGOTO/1,2,3\nFINI\n"] {
            assert!(matches!(change(golden, new), Change::Real { .. }), "{new}");
        }
        let Change::Real { line, golden, new } = change(golden, "FROM/0,0,0\nGOTO/1,2,4\n") else {
            panic!("a real change");
        };
        assert_eq!((line, golden.as_str(), new.as_str()), (2, "GOTO/1,2,3", "GOTO/1,2,4"));
    }
}
