//! Comments and templates.

use std::sync::Arc;

use super::{Blocks, FeedMode};
use crate::machine::{ArcPlane, Dialect};

impl Blocks {
    /// A comment of the control; long ones go on in further lines.
    pub(crate) fn comment(&mut self, text: &str) {
        let program = &self.machine.program;
        let (open, close) = (program.comment_open.clone(), program.comment_close.clone());
        let room = program.max_line.saturating_sub(open.len() + close.len() + 12).max(8);
        let mut clean = String::with_capacity(text.len());
        for c in text.trim().chars() {
            let c = if program.comment_capitals { c.to_ascii_uppercase() } else { c };
            match c {
                c if program.comment_forbidden.contains(c) => {}
                ' '..='~' => clean.push(c),
                '\t' => clean.push(' '),
                'ä' | 'Ä' => clean.push_str("AE"),
                'ö' | 'Ö' => clean.push_str("OE"),
                'ü' | 'Ü' => clean.push_str("UE"),
                'ß' => clean.push_str("SS"),
                _ => clean.push('?'),
            }
        }
        // Some controls act on comments that begin with a word and a comma: (MSG, ..), (LOGOPEN, ..).
        if let Some((head, tail)) = clean.split_once(',')
            && !head.is_empty()
            && head.bytes().all(|b| b.is_ascii_alphabetic())
        {
            clean = format!("{head} {}", tail.trim_start());
        }
        let clean = clean.trim();
        // All characters are ASCII now, so bytes are characters.
        for piece in clean.as_bytes().chunks(room) {
            let piece = std::str::from_utf8(piece).unwrap_or("");
            self.unnumbered(&format!("{open}{piece}{close}"));
        }
    }

    /// A line that is no block: never skipped, and without a number, but where block numbers have no letter every line
    /// has one.
    fn unnumbered(&mut self, line: &str) {
        let all = self.machine.program.block_numbers.letter.is_empty();
        let numbered = self.numbered;
        self.numbered &= all;
        let skip = std::mem::replace(&mut self.skip, false);
        self.begin();
        if self.numbered {
            self.separate();
        }
        self.out.extend_from_slice(line.as_bytes());
        self.end();
        self.numbered = numbered;
        self.skip = skip;
    }

    /// The plane and the kind of feed that a line selects.
    pub(super) fn take_modes(&mut self, line: &str) {
        if self.machine.dialect == Dialect::Heidenhain {
            return;
        }
        let machine = Arc::clone(&self.machine);
        let feed = &machine.feed;
        let words = line.split(['(', ';', '"']).next().unwrap_or_default();
        for code in codes(words) {
            match code {
                "G17" => self.plane = Some(ArcPlane::Xy),
                "G18" => self.plane = Some(ArcPlane::Zx),
                "G19" => self.plane = Some(ArcPlane::Yz),
                code if code == feed.per_minute => self.feed_mode = Some(FeedMode::PerMinute),
                code if code == feed.per_revolution => {
                    self.feed_mode = Some(FeedMode::PerRevolution);
                }
                code if code == feed.inverse_time => self.feed_mode = Some(FeedMode::InverseTime),
                _ => {}
            }
        }
    }

    /// Lines of the machine file.
    pub(crate) fn template(&mut self, lines: &[String], vars: &[(&str, &str)]) {
        for line in lines {
            let Some(text) = render(line, vars) else { continue };
            match text.strip_prefix(';') {
                Some(comment) => self.comment(comment),
                None if is_mark(&text) => self.unnumbered(&text),
                None => self.line(&text),
            }
        }
    }
}

/// Is it the mark of a tape's begin and end, or a program's number: `%`, `O0001`?
fn is_mark(line: &str) -> bool {
    line.strip_prefix(['%', 'O']).is_some_and(|rest| rest.bytes().all(|b| b.is_ascii_digit()))
}

/// The G words of a block, also where no blank stands between them: `G17G40`.
fn codes(block: &str) -> impl Iterator<Item = &str> {
    block.match_indices('G').filter_map(|(at, _)| {
        let rest = &block[at..];
        let digits = |c: char| c.is_ascii_digit() || c == '.';
        let end = rest[1..].find(|c| !digits(c)).map_or(rest.len(), |n| n + 1);
        let alone = !block[..at].ends_with(|c: char| c.is_ascii_alphabetic());
        (end > 1 && alone).then_some(&rest[..end])
    })
}

/// The template with its `{names}` replaced; `None` when one of them is empty or unknown.
pub(crate) fn render(template: &str, vars: &[(&str, &str)]) -> Option<String> {
    let mut text = String::with_capacity(template.len());
    let mut rest = template;
    while let Some((before, after)) = rest.split_once('{') {
        text.push_str(before);
        let (name, tail) = after.split_once('}')?;
        let value = vars.iter().find(|(n, _)| *n == name).map(|(_, v)| *v)?;
        if value.is_empty() {
            return None;
        }
        text.push_str(value);
        rest = tail;
    }
    text.push_str(rest);
    Some(text)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_of_a_block_are_found_without_blanks() {
        let list = |b| codes(b).collect::<Vec<_>>();
        assert_eq!(list("N10 G0 G17G40 G91.1 X1 M5"), ["G0", "G17", "G40", "G91.1"]);
        assert!(list("MSG G X").is_empty() && list("PGM94").is_empty());
    }

    #[test]
    fn a_line_without_its_value_is_left_out() {
        let vars = [("tool", "5"), ("next", "")];
        assert_eq!(render("T{tool} M6", &vars).as_deref(), Some("T5 M6"));
        assert_eq!(render("T{next}", &vars), None);
        assert_eq!(render("G43 H{offset}", &vars), None);
    }
}
