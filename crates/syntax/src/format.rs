//! A part program in one style: capitals, one blank around the `=` of a statement, none elsewhere.
//!
//! Comments, indentation, blank lines and the division into cards stay. A statement that cannot be read,
//! or that gave a warning, is left as it is; so is one whose new text would not mean the same, which is
//! checked by reading it again.

use std::collections::BTreeMap;

use aptc_diagnostics::FileId;

use crate::cards::{Card, Cards};
use crate::identification::Habits;
use crate::lex::Lexer;
use crate::scan::{End, Flat, Scanner};
use crate::token::{Spanned, Token};
use crate::tree::Body;
use crate::{Interner, Options, parse};

mod layout;
mod spacing;

/// How a program is to look.
#[derive(Clone, Debug, Default)]
pub struct FormatOptions {
    /// Lines of any length are statement text, and none is divided.
    pub free_form: bool,
    /// Columns 73 to 80 stay; else they are dropped where they hold an identification.
    pub keep_identification: bool,
}

/// `text` in the one style. What is formatted already stays as it is.
///
/// ```
/// use aptc_syntax::{FormatOptions, format};
/// let text = "p1=point / 1, 2   $$ first\n";
/// assert_eq!(format(text, &FormatOptions::default()), "P1 = POINT/1,2    $$ first\n");
/// ```
pub fn format(text: &str, options: &FormatOptions) -> String {
    let before = meanings(text, options.free_form);
    let mut kept = vec![false; before.len()];
    // The second round leaves alone what the first would have changed in meaning.
    for _ in 0..2 {
        let formatted = compose(text, options, &before, &kept);
        let after = meanings(&formatted, options.free_form);
        if after.len() != before.len() {
            break;
        }
        let mut same = true;
        for ((was, is), kept) in before.iter().zip(&after).zip(&mut kept) {
            if was.tokens != is.tokens || was.isn != is.isn || was.readable != is.readable {
                (same, *kept) = (false, true);
            }
        }
        if same {
            return formatted;
        }
    }
    text.to_owned()
}

/// What a statement says, apart from places.
struct Meaning {
    isn: u32,
    tokens: Vec<Element>,
    /// It can be read, and nothing about it is doubtful.
    readable: bool,
}

/// A token apart from the interner and the lists it points into.
#[derive(PartialEq)]
enum Element {
    Name(String),
    Text(Box<str>),
    Other(Token),
}

/// The meanings of all statements of `text`.
fn meanings(text: &str, free_form: bool) -> Vec<Meaning> {
    let file = FileId(0);
    let mut interner = Interner::default();
    let options = Options { free_form, ..Options::default() };
    let parsed = parse(file, text, &mut interner, &options);
    let mut scanner = Scanner::new(text, free_form, options.first_isn);
    let mut flat = Flat::default();
    let mut found = Vec::new();
    let mut diagnostics = parsed.diagnostics.iter().peekable();
    for statement in &parsed.program.statements {
        let Some(scanned) = scanner.next(&mut flat) else { break };
        let end = scanner.pieces.last().map_or(0, |(card, _)| card.end);
        let start = scanner.pieces.first().map_or(0, |(card, _)| card.text.start);
        // Diagnostics come in order of their places.
        let mut doubtful = false;
        while let Some(d) = diagnostics.next_if(|d| (d.span.start as usize) <= end) {
            let others = d.labels.iter().map(|l| l.span.start as usize);
            doubtful |= std::iter::once(d.span.start as usize)
                .chain(others)
                .any(|at| (start..=end).contains(&at));
        }
        let mut tokens = Vec::new();
        let mut texts = Vec::new();
        let mut lexer = Lexer {
            file,
            source: text,
            interner: &mut interner,
            tokens: &mut tokens,
            texts: &mut texts,
            max_elements: options.max_elements,
        };
        let label = lexer.statement(&flat).label;
        let label = label.map(|l| Element::Name(interner.text(l.symbol).to_owned()));
        let fixed = scanned.fixed.map(|fixed| {
            let text = &text[fixed.text.start as usize..fixed.text.end as usize];
            [Element::Name(fixed.word_is.text().to_owned()), Element::Text(text.into())]
        });
        let elements = tokens.iter().map(|(token, _)| match *token {
            Token::Name(symbol, _) => Element::Name(interner.text(symbol).to_owned()),
            Token::Text(i) => Element::Text(texts[i as usize].clone()),
            Token::Number(value, _) => Element::Other(Token::Number(value, None)),
            other => Element::Other(other),
        });
        let mut all: Vec<Element> = label.into_iter().chain(elements).collect();
        all.extend(fixed.into_iter().flatten());
        let readable = !doubtful && !matches!(statement.body, Body::Error { .. });
        found.push(Meaning { isn: scanned.isn, tokens: all, readable });
    }
    found
}

/// The text with every statement formatted that is readable and not `kept`.
fn compose(text: &str, options: &FormatOptions, meanings: &[Meaning], kept: &[bool]) -> String {
    let mut flat = Flat::default();
    let mut scanner = Scanner::new(text, options.free_form, 1);
    while scanner.next(&mut flat).is_some() {}
    let habits = Habits::new(text, &scanner.tails);
    let mut scanner = Scanner::new(text, options.free_form, 1);
    let mut interner = Interner::default();
    let mut replaced: BTreeMap<u32, layout::Lines> = BTreeMap::new();
    let mut statements = meanings.iter().zip(kept);
    while let Some(scanned) = scanner.next(&mut flat) {
        let strange = |(card, end): &(Card, End)| {
            let tail = &text[card.text.end..card.end];
            *end == End::Card && !tail.trim().is_empty() && !habits.is_identification(tail)
        };
        let untouched = statements.next().is_none_or(|(m, kept)| *kept || !m.readable)
            || scanner.pieces.iter().any(strange);
        let mut tokens: Vec<Spanned> = Vec::new();
        let mut texts = Vec::new();
        let mut lexer = Lexer {
            file: FileId(0),
            source: text,
            interner: &mut interner,
            tokens: &mut tokens,
            texts: &mut texts,
            max_elements: usize::MAX,
        };
        let label = lexer.statement(&flat).label;
        let pieces = &scanner.pieces;
        // A text that goes on in the next card ends there, and what stands behind it is no comment.
        let divided = tokens.iter().any(|(token, span)| {
            matches!(token, Token::Text(_))
                && text[span.start as usize..span.end as usize].contains('\n')
        });
        if untouched || divided {
            replaced.extend(pieces.iter().map(|(card, _)| (card.line, layout::Lines::Untouched)));
        } else if let (Some(fixed), [(card, _)]) = (scanned.fixed, &pieces[..]) {
            replaced.insert(card.line, layout::Lines::Fixed(fixed.word));
        } else {
            let words = spacing::words(text, &flat, label, &tokens);
            replaced.extend(layout::cards(text, pieces, &words, options.free_form));
        }
    }
    let mut out = String::with_capacity(text.len());
    let mut end = 0;
    for card in Cards::new(text, options.free_form) {
        // A byte order mark in front.
        out.push_str(&text[end..card.text.start]);
        let lines = replaced.remove(&card.line);
        layout::write(&mut out, text, &card, lines, &habits, options);
        let rest = &text[card.end..];
        let mark = rest.len() - rest.trim_start_matches('\r').len();
        end = card.end + mark + usize::from(rest[mark..].starts_with('\n'));
        let mark = &text[card.end..end];
        out.push_str(if mark.is_empty() { "\n" } else { mark });
    }
    // The end mark of DOS, if there is one.
    out.push_str(&text[end..]);
    out
}
