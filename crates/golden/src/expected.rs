//! Messages that a program says it expects.
//!
//! A comment `$$ ERROR APT1050 12-15 words of the message` stands above the line that it speaks of; several
//! may stand above one line. `WARNING` and `NOTE` are told from `ERROR`. The columns (first and last, from 1)
//! and the words (any part of the message) may be left out.

use std::fmt;

use crate::run::Message;

/// One expected message.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Expected {
    severity: &'static str,
    code: String,
    line: u32,
    columns: Option<(u32, u32)>,
    words: String,
}

impl Expected {
    fn matches(&self, message: &Message) -> bool {
        self.severity == message.severity
            && self.code == message.code
            && self.line == message.line
            && self.columns.is_none_or(|columns| columns == message.columns)
            && message.text.contains(&self.words)
    }
}

impl fmt::Display for Expected {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "line {}: {} {}", self.line, self.severity, self.code)?;
        if let Some((first, last)) = self.columns {
            write!(f, " {first}-{last}")?;
        }
        if self.words.is_empty() { Ok(()) } else { write!(f, " {}", self.words) }
    }
}

/// The expectations of a program, in order.
pub fn parse(program: &str) -> Vec<Expected> {
    let mut found = Vec::new();
    let mut waiting: Vec<Expected> = Vec::new();
    for (line, number) in program.lines().zip(1..) {
        if let Some(mut expected) = annotation(line) {
            expected.line = 0;
            waiting.push(expected);
        } else {
            found.extend(waiting.drain(..).map(|expected| Expected { line: number, ..expected }));
        }
    }
    // Below the last line there is nothing to speak of; kept, so that it fails.
    found.extend(waiting);
    found
}

fn annotation(line: &str) -> Option<Expected> {
    let (kind, rest) = line.trim().strip_prefix("$$ ")?.split_once(' ')?;
    let severity = match kind {
        "ERROR" => "error",
        "WARNING" => "warning",
        "NOTE" => "note",
        _ => return None,
    };
    let (code, rest) = rest.split_once(' ').unwrap_or((rest, ""));
    let digits = code.strip_prefix("APT")?;
    if digits.len() != 4 || !digits.bytes().all(|b| b.is_ascii_digit()) {
        return None;
    }
    let (first, after) = rest.trim().split_once(' ').unwrap_or((rest.trim(), ""));
    let columns = first.split_once('-').and_then(|(a, b)| Some((a.parse().ok()?, b.parse().ok()?)));
    let words = if columns.is_some() { after.trim() } else { rest.trim() };
    Some(Expected { severity, code: code.to_owned(), line: 0, columns, words: words.to_owned() })
}

/// What was expected and did not come, and what came and was not expected. Each message answers one
/// expectation.
pub fn differences(expected: &[Expected], messages: &[Message]) -> (Vec<String>, Vec<String>) {
    let mut left: Vec<&Message> = messages.iter().collect();
    let mut missing = Vec::new();
    for expectation in expected {
        match left.iter().position(|message| expectation.matches(message)) {
            Some(at) => {
                left.remove(at);
            }
            None => missing.push(expectation.to_string()),
        }
    }
    (missing, left.into_iter().map(ToString::to_string).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn message(code: &str, line: u32, columns: (u32, u32), text: &str) -> Message {
        let (code, text) = (code.to_owned(), text.to_owned());
        Message { severity: "error", code, line, columns, text, more: String::new() }
    }

    #[test]
    fn expectations_speak_of_the_next_line() {
        let program = "A=1\n$$ ERROR APT1042 3-5 no such word\n$$ WARNING APT1050\nB=2\n$$ ERROR of mine\nC=3\n";
        let expected = parse(program);
        assert_eq!(expected.len(), 2);
        assert_eq!(expected[0].to_string(), "line 4: error APT1042 3-5 no such word");
        assert_eq!(expected[1].to_string(), "line 4: warning APT1050");
    }

    #[test]
    fn missing_and_unexpected_both_show() {
        let expected = parse("$$ ERROR APT1042 3-5 such\nB=2\n$$ ERROR APT1043\nC\n");
        let good = message("APT1042", 2, (3, 5), "no such word");
        let also_good = message("APT1043", 4, (1, 1), "what");
        let all = [good.clone(), also_good.clone()];
        assert_eq!(differences(&expected, &all), (vec![], vec![]));
        let (missing, surplus) = differences(&expected, &[good.clone(), good.clone()]);
        assert_eq!((missing.len(), surplus.len()), (1, 1));
        let elsewhere = message("APT1042", 2, (3, 6), "no such word");
        let (missing, surplus) = differences(&expected, &[elsewhere, also_good]);
        assert_eq!((missing.len(), surplus.len()), (1, 1));
    }
}
