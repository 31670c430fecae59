//! A look over a statement's tokens before the grammar reads it: brackets, depth, and which slashes
//! begin a list.

use aptc_diagnostics::{Diagnostic, FileId, Span, codes};
use aptc_vocabulary::{Class, Dialect, Word, word};

use crate::token::{Spanned, Token};

/// Greatest depth of an expression tree, brackets and operators together. Trees are walked and dropped by
/// recursion: 400 levels stay far below the smallest stack a thread is given.
pub(crate) const MAX_DEPTH: usize = 400;

/// An open bracket, or the statement itself.
#[derive(Default)]
pub(crate) struct Level {
    /// Place of the bracket among the tokens.
    open: Option<usize>,
    /// A name before a slash that is a head if a comma follows. A comma behind `P=XYZ/1` leaves no other
    /// meaning; in brackets, `(D/2,0)` is a point and only a word that defines in some dialect is a head.
    head: Option<usize>,
    /// May the next name be the head?
    at_head: bool,
    /// Operators in the present element of the list, and the deepest bracket in it.
    operators: usize,
    inner: usize,
    /// Depth of the deepest element so far.
    deepest: usize,
}

impl Level {
    fn end_element(&mut self) {
        self.deepest = self.deepest.max(self.operators + self.inner);
        self.operators = 0;
        self.inner = 0;
    }
}

/// What decides whether a name before a slash begins a definition.
pub(crate) struct Heads {
    /// Is the statement an assignment, so that a comma makes its value a definition?
    pub(crate) assignment: bool,
}

/// Checks the brackets and turns names before a list into heads; gives what is wrong. `levels` is only
/// lent, to be used again.
pub(crate) fn check(
    file: FileId,
    tokens: &mut [Spanned],
    heads: &Heads,
    max_bracket_depth: usize,
    levels: &mut Vec<Level>,
) -> Option<Diagnostic> {
    let at = |tokens: &[Spanned], i: usize| Span::new(file, tokens[i].1.start, tokens[i].1.end);
    levels.clear();
    levels.push(Level::default());
    for i in 0..tokens.len() {
        let Some(level) = levels.last_mut() else { break };
        let was_at_head = std::mem::take(&mut level.at_head);
        match tokens[i].0 {
            Token::Open => {
                if levels.len() > max_bracket_depth {
                    return Some(
                        Diagnostic::error(
                            codes::TOO_DEEP,
                            at(tokens, i),
                            format!("more than {max_bracket_depth} brackets within each other"),
                        )
                        .help("give the inner parts names in statements of their own"),
                    );
                }
                let fault = nothing_in(file, tokens, i);
                if fault.is_some() {
                    return fault;
                }
                levels.push(Level { open: Some(i), at_head: true, ..Level::default() });
            }
            Token::Close => {
                let Some(mut closed) = levels.pop().filter(|_| !levels.is_empty()) else {
                    return Some(
                        Diagnostic::error(
                            codes::UNOPENED_BRACKET,
                            at(tokens, i),
                            "this `)` closes no bracket",
                        )
                        .help("put the `(` in front, or take the `)` away"),
                    );
                };
                closed.end_element();
                if let Some(level) = levels.last_mut() {
                    level.inner = level.inner.max(closed.deepest + 1);
                }
            }
            Token::Comma => {
                level.end_element();
                if let Some(head) = level.head.take() {
                    promote(&mut tokens[head].0);
                }
                let fault = nothing_behind(file, tokens, i);
                if fault.is_some() {
                    return fault;
                }
            }
            Token::Equal => {
                let fault = no_target(file, tokens, i);
                if fault.is_some() {
                    return fault;
                }
                level.operators += 1;
                level.at_head = level.open.is_some() || heads.assignment;
            }
            Token::Name(_, word) if was_at_head => {
                if matches!(tokens.get(i + 1), Some((Token::Slash, _))) {
                    if word.is_some_and(defines) {
                        promote(&mut tokens[i].0);
                    } else if level.open.is_none()
                        || word.is_some_and(|w| w.class() == Class::Geometry)
                    {
                        level.head = Some(i);
                    }
                }
            }
            Token::Operator(_) | Token::Slash | Token::Not => level.operators += 1,
            _ => {}
        }
        let n_open = levels.len();
        if levels.last().is_some_and(|l| l.operators + l.inner + n_open > MAX_DEPTH) {
            return Some(
                Diagnostic::error(
                    codes::TOO_DEEP,
                    at(tokens, i),
                    format!("an expression of more than {MAX_DEPTH} operators and brackets"),
                )
                .help("give parts of it names in statements of their own"),
            );
        }
    }
    if levels.len() > 1 {
        let open = levels.last().and_then(|l| l.open).unwrap_or(0);
        let last = tokens.len() - 1;
        let end = tokens[last].1.end;
        return Some(
            Diagnostic::error(codes::UNCLOSED_BRACKET, at(tokens, open), "this `(` is not closed")
                .also(Span::new(file, end, end), "expected `)` up to here"),
        );
    }
    None
}

/// The message for a comma that nothing follows. OBTAIN may skip the last elements.
fn nothing_behind(file: FileId, tokens: &[Spanned], comma: usize) -> Option<Diagnostic> {
    let at = tokens[comma].1;
    let fault = |what| {
        let span = Span::new(file, at.start, at.end);
        Diagnostic::error(codes::EXPECTED_OTHERWISE, span, what)
    };
    match tokens.get(comma + 1) {
        None if matches!(tokens[0].0, Token::Name(_, Some(word::OBTAIN))) => None,
        None => Some(
            fault("expected a value after this `,`, found the end of the statement")
                .help("take the `,` away; or end the card with `$` if the statement goes on"),
        ),
        Some((Token::Close, _)) => {
            Some(fault("expected a value after this `,`, found `)`").help("take the `,` away"))
        }
        Some(_) => None,
    }
}

/// The message for a bracket that does not begin with a value.
fn nothing_in(file: FileId, tokens: &[Spanned], open: usize) -> Option<Diagnostic> {
    let (token, at) = tokens.get(open + 1)?;
    let found = match token {
        Token::Comma => ",",
        Token::Close => ")",
        _ => return None,
    };
    let message = format!("expected a value in the brackets, found `{found}`");
    Some(Diagnostic::error(codes::EXPECTED_OTHERWISE, Span::new(file, at.start, at.end), message))
}

/// The message for an `=` with no name left of it.
fn no_target(file: FileId, tokens: &[Spanned], equal: usize) -> Option<Diagnostic> {
    let before = equal.checked_sub(1).map(|i| tokens[i]);
    if matches!(before, Some((Token::Name(..) | Token::Close, _))) {
        return None;
    }
    let at = before.map_or(tokens[equal].1, |(_, span)| span);
    let span = Span::new(file, at.start, at.end);
    let message = "expected a name left of this `=`";
    Some(Diagnostic::error(codes::EXPECTED_OTHERWISE, span, message))
}

/// Does the word begin a definition even before a single argument? `LINE/XAXIS` is one, `A/B` is not.
pub(crate) fn defines(word: Word) -> bool {
    word.class() == Class::Geometry
        && (word.is_major(Dialect::Apt360) || word.is_major(Dialect::Apt4))
        // APT4 saved forms so, in hexadecimal.
        || word == word::HEX
}

fn promote(token: &mut Token) {
    if let Token::Name(symbol, word) = *token {
        *token = Token::Head(symbol, word);
    }
}
