//! Text of an input made harmless for a terminal.

use std::borrow::Cow;

/// The text without control characters: each but the line end and the tab is replaced by a mark of as many
/// bytes, so that spans stay right. An input could otherwise move the cursor or set colours.
pub(crate) fn plain(text: &str) -> Cow<'_, str> {
    let harmful = |c: char| c.is_control() && !matches!(c, '\n' | '\r' | '\t');
    if !text.contains(harmful) {
        return Cow::Borrowed(text);
    }
    let mark = |c: char| match c.len_utf8() {
        _ if !harmful(c) => c,
        1 => '?',
        _ => '\u{bf}',
    };
    Cow::Owned(text.chars().map(mark).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn control_characters_go_and_lengths_stay() {
        assert_eq!(plain("A=1\t$$ \u{e9}\r\n"), "A=1\t$$ \u{e9}\r\n");
        let wild = "P\u{1b}[2J \u{9b}31m\u{7f}\u{0}\n";
        let tame = plain(wild);
        assert_eq!(tame, "P?[2J \u{bf}31m??\n");
        assert_eq!(tame.len(), wild.len());
    }
}
