//! A part program as tokens that can be changed one at a time.
//!
//! This knows no more of APT than where a token ends: the compiler's own lexer is what is being tried.

use std::ops::Range;

use crate::random::Random;

/// Columns beyond this are a card's identification.
const LAST_COLUMN: usize = 72;
/// Words whose card is text: a change there is no mistake.
const TEXT_WORDS: [&str; 6] = ["PARTNO", "PPRINT", "INSERT", "REMARK", "TITLES", "$$"];

/// A token and the lines (from 1) of the statement that it stands in.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Token {
    bytes: Range<usize>,
    statement: Range<usize>,
}

/// A program ready for changes.
pub(super) struct Program {
    text: String,
    tokens: Vec<Token>,
}

/// A changed program.
pub(super) struct Mutant {
    /// The text after the change.
    pub(super) text: String,
    /// First and one past the last line, from 1, of the changed statement.
    pub(super) statement: Range<usize>,
    /// What was done, for people.
    pub(super) change: String,
}

impl Program {
    /// `None` when there is nothing to change.
    pub(super) fn new(text: String) -> Option<Self> {
        let tokens = tokens(&text);
        (!tokens.is_empty()).then_some(Self { text, tokens })
    }

    /// Changes one token in one of six ways; never into itself.
    pub(super) fn mutate(&self, random: &mut Random) -> Mutant {
        loop {
            let token = random.choose(&self.tokens);
            let old = &self.text[token.bytes.clone()];
            let other = &self.text[random.choose(&self.tokens).bytes.clone()];
            let new = match random.below(6) {
                0 => String::new(),
                1 => format!("{old} {old}"),
                2 => other.to_owned(),
                3 => slip(old, random),
                4 => (*random.choose(&["/", ",", "=", "(", ")", "*", "+", "$", "0", "-1", "1.E9"]))
                    .to_owned(),
                _ => format!("{old},{other}"),
            };
            if new == old {
                continue;
            }
            let mut text = self.text.clone();
            text.replace_range(token.bytes.clone(), &new);
            let change = format!("line {}: `{old}` became `{new}`", token.statement.start);
            return Mutant { text, statement: token.statement.clone(), change };
        }
    }
}

/// The token with two letters exchanged, one dropped or one struck twice.
fn slip(token: &str, random: &mut Random) -> String {
    let mut letters: Vec<char> = token.chars().collect();
    let at = random.below(letters.len());
    match random.below(3) {
        0 if at + 1 < letters.len() => letters.swap(at, at + 1),
        1 if letters.len() > 1 => {
            letters.remove(at);
        }
        _ => letters.insert(at, letters[at]),
    }
    letters.into_iter().collect()
}

fn tokens(text: &str) -> Vec<Token> {
    let mut tokens = Vec::new();
    let mut statement_start = 1;
    let mut first_of_statement = 0;
    let mut offset = 0;
    for (line, number) in text.split_inclusive('\n').zip(1..) {
        let continued = line_tokens(line, offset, &mut tokens);
        offset += line.len();
        if !continued {
            for token in &mut tokens[first_of_statement..] {
                token.statement = statement_start..number + 1;
            }
            first_of_statement = tokens.len();
            statement_start = number + 1;
        }
    }
    for token in &mut tokens[first_of_statement..] {
        token.statement = statement_start..text.lines().count() + 1;
    }
    tokens
}

/// Adds the tokens of a line; true when the statement goes on in the next one.
fn line_tokens(line: &str, offset: usize, tokens: &mut Vec<Token>) -> bool {
    let upper = line.trim_start().to_ascii_uppercase();
    if !line.is_ascii() || TEXT_WORDS.iter().any(|word| upper.starts_with(word)) {
        return false;
    }
    let card = &line[..line.len().min(LAST_COLUMN)];
    let bytes = card.as_bytes();
    let mut at = 0;
    while at < bytes.len() {
        let word = |b: u8| b.is_ascii_alphanumeric() || b == b'.';
        let start = at;
        match bytes[at] {
            b'$' => return bytes.get(at + 1) != Some(&b'$'),
            b'\'' => return false,
            b if b.is_ascii_whitespace() => {
                at += 1;
                continue;
            }
            b if word(b) => at += bytes[at..].iter().take_while(|b| word(**b)).count(),
            _ => at += 1,
        }
        tokens.push(Token { bytes: offset + start..offset + at, statement: 0..0 });
    }
    false
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "PARTNO A/B\nC1=CIRCLE/0,$ remark\n  0,.5 $$ no token\n$$ nor here\nFINI\n";

    #[test]
    fn tokens_know_the_lines_of_their_statement() {
        let tokens = tokens(TEXT);
        let words: Vec<&str> = tokens.iter().map(|t| &TEXT[t.bytes.clone()]).collect();
        assert_eq!(words, ["C1", "=", "CIRCLE", "/", "0", ",", "0", ",", ".5", "FINI"]);
        assert!(tokens[..9].iter().all(|token| token.statement == (2..4)), "{tokens:?}");
        assert_eq!(tokens[9].statement, 5..6);
    }

    #[test]
    fn a_change_is_one_change_and_repeats_with_its_seed() {
        let program = Program::new(TEXT.to_owned()).unwrap();
        for seed in 0..200 {
            let mutant = program.mutate(&mut Random::new(seed));
            assert_ne!(mutant.text, TEXT);
            assert!(mutant.text.starts_with("PARTNO A/B\n"));
            assert_eq!(mutant.text, program.mutate(&mut Random::new(seed)).text);
        }
    }
}
