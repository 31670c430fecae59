//! What kind of change a golden has undergone.

use serde_json::Value;

use crate::run::Stage;

/// How a text differs from its golden.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Change {
    /// Not at all.
    None,
    /// Digits of CL data or of a numeric part program that say nothing: less than `SAME` apart.
    Digits {
        /// First line, from 1, that differs.
        line: usize,
    },
    /// Comments, blanks, line breaks, lines and columns of the program: the part is the same.
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
pub fn change(stage: Stage, golden: &str, new: &str) -> Change {
    let first = golden.lines().zip(new.lines()).take_while(|(a, b)| a == b).count() + 1;
    if golden == new {
        return Change::None;
    }
    let rounded = matches!(stage, Stage::Protap | Stage::Cl | Stage::EditedCl);
    let all = |text| tokens(text, Comments::Kept);
    if rounded && real_change(&all(golden), &all(new), golden, new).is_none() {
        return Change::Digits { line: first };
    }
    let (old, young) = (without_places(stage, golden), without_places(stage, new));
    let meaning = |text| tokens(text, Comments::LeftOut);
    real_change(&meaning(&old), &meaning(&young), &old, &young)
        .unwrap_or(Change::Cosmetic { line: first })
}

/// The first token that differs in meaning, if there is one.
fn real_change(old: &[Token<'_>], young: &[Token<'_>], golden: &str, new: &str) -> Option<Change> {
    let numbers = old.iter().filter_map(|token| token.value);
    let scale = numbers.fold(1.0, |most: f64, value| most.max(value.abs()));
    let same = |(a, b): &(&Token<'_>, &Token<'_>)| match (a.value, b.value) {
        (Some(a), Some(b)) => (a - b).abs() <= SAME * scale,
        _ => a.text == b.text,
    };
    let equal = old.iter().zip(young).take_while(same).count();
    if equal == old.len() && equal == young.len() {
        return None;
    }
    let line_of = |tokens: &[Token<'_>]| tokens.get(equal).map(|token| token.line);
    let line_at = |text: &str, n: Option<usize>| {
        n.and_then(|n| text.lines().nth(n - 1)).unwrap_or_default().trim().to_owned()
    };
    let (in_golden, in_new) = (line_of(old), line_of(young));
    Some(Change::Real {
        line: in_golden.or(in_new).unwrap_or(1),
        golden: line_at(golden, in_golden),
        new: line_at(new, in_new),
    })
}

/// The text, line for line, without what only says where in the program something stands.
fn without_places(stage: Stage, text: &str) -> String {
    let lines = text.lines();
    match stage {
        Stage::Protap => lines.map(record_without_places).collect(),
        Stage::Diag => lines.map(|line| message_without_places(line) + "\n").collect(),
        _ => text.to_owned(),
    }
}

/// A record in JSON without its spans, lines and statement numbers; a line that is no JSON as it is.
fn record_without_places(line: &str) -> String {
    fn strip(value: &mut Value) {
        match value {
            Value::Object(fields) => {
                for place in ["origin", "span", "line", "isn"] {
                    fields.remove(place);
                }
                fields.values_mut().for_each(strip);
            }
            Value::Array(items) => items.iter_mut().for_each(strip),
            _ => {}
        }
    }
    let Ok(mut record) = serde_json::from_str::<Value>(line) else { return format!("{line}\n") };
    strip(&mut record);
    format!("{record}\n")
}

/// A message without the numbers after `line` and `column` and without its columns.
fn message_without_places(line: &str) -> String {
    let mut words: Vec<&str> = Vec::new();
    let is_place = |word: &str| {
        word.starts_with(|c: char| c.is_ascii_digit())
            && word.bytes().all(|b| b.is_ascii_digit() || b"-:".contains(&b))
    };
    for word in line.split(' ') {
        let after = words.last().copied().unwrap_or_default();
        let code = after.len() == 7 && after.starts_with("APT");
        if !(is_place(word) && (code || matches!(after, "line" | "column"))) {
            words.push(word);
        }
    }
    words.join(" ")
}

/// What to do about comments.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Comments {
    Kept,
    LeftOut,
}

struct Token<'a> {
    text: &'a str,
    value: Option<f64>,
    line: usize,
}

/// Words, numbers and signs, without the `$` that continues a line and, if they are to be left out, without
/// comments (`$$`, `;`, `(...)` at the start of a line). A `$$ CIRCLE` is no comment but the circle of a motion.
fn tokens(text: &str, comments: Comments) -> Vec<Token<'_>> {
    let mut tokens = Vec::new();
    for (whole, line) in text.lines().zip(1..) {
        let mut rest = whole;
        if comments == Comments::LeftOut && !whole.starts_with("$$ CIRCLE") {
            rest = whole.split("$$").next().unwrap_or_default();
            if rest.starts_with([';', '(', '%']) {
                continue;
            }
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

    fn cl(golden: &str, new: &str) -> Change {
        change(Stage::Cl, golden, new)
    }

    #[test]
    fn blanks_comments_and_places_are_cosmetic() {
        let golden = "$$ LINE 3\nGOTO/1,2.5,-3E-4\n";
        assert_eq!(cl(golden, golden), Change::None);
        for new in ["$$ LINE 4\nGOTO/1,2.5,-3E-4\n", "$$ here\nGOTO/1,2.5,-3E-4\n"] {
            assert!(matches!(cl(golden, new), Change::Cosmetic { line: 1 }), "{new}");
        }
        let nc = |golden, new| change(Stage::Nc, golden, new);
        assert_eq!(nc("N10 G1 X1.0\n", "N10 G01 X1.\n"), Change::Cosmetic { line: 1 });
        assert_eq!(nc("(old)\nG1 X1\n", "(new)\nG1 X1\n"), Change::Cosmetic { line: 1 });
        let protap = |golden, new| change(Stage::Protap, golden, new);
        let record = r#"{"origin":{"span":{"start":4,"end":9},"isn":3},"goto":[1.0,2.0]}"#;
        let moved = record.replace("\"start\":4", "\"start\":40");
        assert_eq!(protap(record, &moved), Change::Cosmetic { line: 1 });
        let other = record.replace("2.0", "2.5");
        assert!(matches!(protap(record, &other), Change::Real { line: 1, .. }));
        let diag = |golden, new| change(Stage::Diag, golden, new);
        let message = "line 3: error APT1050 1-7 Q3 at line 5 column 2 is 7\n";
        let moved = "line 4: error APT1050 2-8 Q3 at line 6 column 1 is 7\n";
        assert_eq!(diag(message, moved), Change::Cosmetic { line: 1 });
        assert!(matches!(diag(message, &message.replace("is 7", "is 8")), Change::Real { .. }));
    }

    #[test]
    fn digits_below_any_tolerance_say_nothing() {
        let golden = "$$ LINE 3\nGOTO/1,2.5,-3E-4\n";
        for new in
            ["$$ LINE 3\nGOTO/1.00000001,2.5,-3E-4\n", "$$ LINE 3\nGOTO / 1.0, 2.50,$\n -.0003\n"]
        {
            assert_eq!(cl(golden, new), Change::Digits { line: 2 }, "{new}");
        }
    }

    #[test]
    fn a_changed_position_or_circle_is_real() {
        let golden = "FROM/0,0,0\n$$ CIRCLE 0,0,0,0,0,1,5\nGOTO/1,2,3\n";
        for (from, to) in
            [("2,3", "2,4"), ("GOTO/1,2,3\n", ""), ("2,3\n", "2,3\nFINI\n"), ("1,5", "1,6")]
        {
            let new = golden.replace(from, to);
            assert!(matches!(cl(golden, &new), Change::Real { .. }), "{new}");
        }
        let Change::Real { line, golden, new } = cl(golden, &golden.replace("2,3", "2,4")) else {
            panic!("a real change");
        };
        assert_eq!((line, golden.as_str(), new.as_str()), (3, "GOTO/1,2,3", "GOTO/1,2,4"));
    }
}
