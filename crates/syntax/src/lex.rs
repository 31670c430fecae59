//! From the characters of a statement to its tokens.

use std::ops::Range;

use aptc_diagnostics::{Diagnostic, FileId, Span, codes};
use chumsky::span::SimpleSpan;
use logos::Logos;

use crate::Interner;
use crate::characters;
use crate::fixed::printable;
use crate::scan::{Flat, place};
use crate::token::{Raw, Spanned, Token};
use crate::tree::{BinaryOp, Name};

/// Longest number that is read; a longer one is no number anybody wrote.
const LONGEST_NUMBER: usize = 400;
/// Characters of a long number that a message shows.
const SHOWN_DIGITS: usize = 24;

/// What the lexer works with and fills.
pub(crate) struct Lexer<'l> {
    pub(crate) file: FileId,
    pub(crate) source: &'l str,
    pub(crate) interner: &'l mut Interner,
    pub(crate) tokens: &'l mut Vec<Spanned>,
    pub(crate) texts: &'l mut Vec<Box<str>>,
    pub(crate) max_elements: usize,
}

/// A statement's label and the messages about its characters.
#[derive(Default)]
pub(crate) struct Lexed {
    pub(crate) label: Option<Name>,
    /// Why it cannot be read.
    pub(crate) fault: Option<Diagnostic>,
    pub(crate) warning: Option<Diagnostic>,
}

impl Lexer<'_> {
    /// Appends the tokens of `flat` to the list, without the label.
    pub(crate) fn statement(&mut self, flat: &Flat) -> Lexed {
        let mut lexed = Lexed::default();
        let from = self.tokens.len();
        let mut first: Option<Range<usize>> = None;
        let mut with_labels = false;
        let mut base = 0;
        let mut raws = Raw::lexer(&flat.text);
        while let Some(raw) = raws.next() {
            let range = raws.span().start + base..raws.span().end + base;
            let Ok(raw) = raw else {
                let flat_range = range;
                lexed.fault.get_or_insert_with(|| self.bad_character(flat, flat_range));
                continue;
            };
            let n = self.tokens.len() - from;
            if n > self.max_elements {
                lexed.fault = Some(self.too_long(flat));
                break;
            }
            match raw {
                // A label is the first thing and a `)` or `:` follows it.
                Raw::Close | Raw::Colon if n == 1 && first.is_some() => {
                    if let Some(label) = first.take() {
                        lexed.label = Some(self.name(flat, label));
                    }
                    self.tokens.truncate(from);
                    lexed.warning = None;
                    continue;
                }
                Raw::Name | Raw::Integer if n == 0 && lexed.label.is_none() => {
                    first = Some(range.clone());
                }
                _ => {}
            }
            let span = span(flat, range.clone());
            let token = match raw {
                Raw::Name => {
                    if n == 0 {
                        with_labels = matches!(&flat.text[range.clone()], "IF" | "DO");
                    }
                    self.names(flat, range, &mut lexed);
                    continue;
                }
                Raw::Integer => {
                    let text = &flat.text[range.clone()];
                    let label = with_labels.then(|| self.interner.intern(text));
                    self.warn_if_parted(flat, range, &mut lexed);
                    Token::Number(self.value(text, span, &mut lexed), label)
                }
                Raw::Real => {
                    self.warn_if_parted(flat, range.clone(), &mut lexed);
                    Token::Number(self.value(&flat.text[range], span, &mut lexed), None)
                }
                Raw::IntegerThenOperator => {
                    let text = &flat.text[range.clone()];
                    let point = text.find('.').unwrap_or(text.len());
                    let value = self.value(&text[..point], span, &mut lexed);
                    let middle = range.start + point;
                    let digits = self::span(flat, range.start..middle);
                    self.tokens.push((Token::Number(value, None), digits));
                    let end = operator_end(flat, middle..range.end);
                    if end < range.end {
                        (base, raws) = (end, Raw::lexer(&flat.text[end..]));
                    }
                    self.dotted(flat, middle..end);
                    continue;
                }
                Raw::Dotted => {
                    let end = operator_end(flat, range.clone());
                    if end < range.end {
                        (base, raws) = (end, Raw::lexer(&flat.text[end..]));
                    }
                    self.dotted(flat, range.start..end);
                    continue;
                }
                Raw::Text => {
                    let text = &self.source[span.start as usize + 1..span.end as usize - 1];
                    self.texts.push(printable(text));
                    Token::Text(place(self.texts.len() - 1))
                }
                Raw::Power => Token::Operator(BinaryOp::Pow),
                Raw::Star => Token::Operator(BinaryOp::Mul),
                Raw::Plus => Token::Operator(BinaryOp::Add),
                Raw::Minus => Token::Operator(BinaryOp::Sub),
                Raw::Slash => Token::Slash,
                Raw::Comma => Token::Comma,
                Raw::Equal => Token::Equal,
                Raw::Open => Token::Open,
                Raw::Close => Token::Close,
                Raw::Colon => Token::Colon,
            };
            self.tokens.push((token, span));
        }
        lexed
    }

    fn name(&mut self, flat: &Flat, range: Range<usize>) -> Name {
        let symbol = self.interner.intern(&flat.text[range.clone()]);
        let at = span(flat, range);
        let span = Span::new(self.file, at.start, at.end);
        Name { symbol, word: self.interner.word(symbol), span }
    }

    /// A name; or several with KREUZ or DOT between, which only blanks part from their neighbours:
    /// `V1 KREUZ V2`.
    fn names(&mut self, flat: &Flat, range: Range<usize>, lexed: &mut Lexed) {
        let text = &flat.text[range.clone()];
        let product = |text: &str| match text {
            "KREUZ" => Some(BinaryOp::Cross),
            "DOT" => Some(BinaryOp::Dot),
            _ => None,
        };
        let after_value = matches!(
            self.tokens.last(),
            Some((Token::Close | Token::Number(..) | Token::Text(_), _))
        );
        if let (true, Some(op)) = (after_value, product(text)) {
            self.tokens.push((Token::Operator(op), span(flat, range)));
            return;
        }
        if !flat.is_parted(&range) {
            self.push_name(flat, range);
            return;
        }
        let pieces = flat.pieces(range.clone());
        // Pieces between two operators make one name, as blanks have no meaning.
        let mut start = range.start;
        for (i, piece) in pieces.iter().enumerate() {
            let Some(op) = product(&flat.text[piece.clone()]) else { continue };
            let between =
                (i > 0 || after_value) && (i + 1 < pieces.len() || value_follows(flat, &range));
            if !between {
                continue;
            }
            if start < piece.start {
                self.push_name(flat, start..piece.start);
            }
            self.tokens.push((Token::Operator(op), span(flat, piece.clone())));
            start = piece.end;
        }
        if start == range.start && flat.text[pieces[0].clone()].bytes().all(|b| b.is_ascii_digit())
        {
            self.warn_if_parted(flat, range.clone(), lexed);
        }
        if start < range.end {
            self.push_name(flat, start..range.end);
        }
    }

    fn push_name(&mut self, flat: &Flat, range: Range<usize>) {
        let at = span(flat, range.clone());
        let Name { symbol, word, .. } = self.name(flat, range);
        self.tokens.push((Token::Name(symbol, word), at));
    }

    /// Warns of blanks, or the end of a card, amid digits.
    fn warn_if_parted(&self, flat: &Flat, range: Range<usize>, lexed: &mut Lexed) {
        if lexed.warning.is_some() || !flat.is_parted(&range) {
            return;
        }
        let text = &flat.text[range.clone()];
        let shown: String = text.chars().take(SHOWN_DIGITS).collect();
        if text.bytes().any(|b| b.is_ascii_alphabetic()) && !text.contains('.') {
            // `10 MM` is a symbol: where it has no value, that is told with its parts.
            return;
        }
        let at = span(flat, range);
        let span = Span::new(self.file, at.start, at.end);
        let message = format!("blanks have no meaning: this is the one number {shown}");
        lexed.warning = Some(
            Diagnostic::warning(codes::BLANK_IN_NUMBER, span, message)
                .help("put a `,` between two values, or write the number without a blank"),
        );
    }

    /// The value of a number's digits.
    fn value(&self, text: &str, at: SimpleSpan<u32>, lexed: &mut Lexed) -> f64 {
        let value = match text.find('D') {
            _ if text.len() > LONGEST_NUMBER => f64::INFINITY,
            Some(_) => text.replace('D', "E").parse().unwrap_or(f64::INFINITY),
            None => text.parse().unwrap_or(f64::INFINITY),
        };
        if value.is_finite() {
            return value;
        }
        lexed.fault.get_or_insert_with(|| {
            let mut shown: String = text.chars().take(SHOWN_DIGITS).collect();
            if shown.len() < text.len() {
                shown.push_str("...");
            }
            let span = Span::new(self.file, at.start, at.end);
            let message = format!("the number {shown} is too large");
            Diagnostic::error(codes::NUMBER_TOO_LARGE, span, message)
                .label("numbers go up to about 1.8E308 and 400 digits")
        });
        0.0
    }

    /// `.EQ.`, `.EQ`, `.TRUE.` and so on.
    fn dotted(&mut self, flat: &Flat, range: Range<usize>) {
        let token = match flat.text[range.clone()].trim_matches('.') {
            "EQ" => Token::Operator(BinaryOp::Eq),
            "NE" => Token::Operator(BinaryOp::Ne),
            "LT" => Token::Operator(BinaryOp::Lt),
            "LE" => Token::Operator(BinaryOp::Le),
            "GT" => Token::Operator(BinaryOp::Gt),
            "GE" => Token::Operator(BinaryOp::Ge),
            "AND" => Token::Operator(BinaryOp::And),
            "OR" => Token::Operator(BinaryOp::Or),
            "KREUZ" => Token::Operator(BinaryOp::Cross),
            "DOT" => Token::Operator(BinaryOp::Dot),
            "TRUE" => Token::Truth(true),
            "FALSE" => Token::Truth(false),
            _ => Token::Not,
        };
        self.tokens.push((token, span(flat, range)));
    }

    fn bad_character(&self, flat: &Flat, range: Range<usize>) -> Diagnostic {
        let start = flat.places.get(range.start).copied().unwrap_or(0);
        let c = flat.text[range].chars().next().unwrap_or(' ');
        let span = Span::new(self.file, start, start + place(c.len_utf8()));
        characters::not_of_apt(c, span)
    }

    fn too_long(&self, flat: &Flat) -> Diagnostic {
        let all = span(flat, 0..flat.text.len());
        let span = Span::new(self.file, all.start, all.end);
        let max = self.max_elements;
        let message = format!("a statement of more than {max} words, numbers and signs");
        Diagnostic::error(codes::STATEMENT_TOO_LONG, span, message)
            .help("divide it, or take the `$` from cards that should not go on")
    }
}

/// The end of an operator such as `.EQ.`: the second point may belong to what follows, as it does where
/// the user wrote `.EQ .5`.
fn operator_end(flat: &Flat, range: Range<usize>) -> usize {
    let last = range.end - 1;
    let rest = &flat.text[range.end..];
    let word = rest.find(|c: char| !c.is_ascii_alphanumeric()).map_or(rest, |n| &rest[..n]);
    // No name may stand behind a truth value, and these words are no names behind a point:
    // `.TRUE.OR.NOT.A` is `.TRUE` `.OR` `.NOT.` `A`.
    let truth = matches!(flat.text[range.clone()].trim_matches('.'), "TRUE" | "FALSE");
    if (truth && !word.is_empty()) || matches!(word, "TRUE" | "FALSE" | "NOT") {
        return if flat.text.as_bytes()[last] == b'.' { last } else { range.end };
    }
    let number_follows = flat.text.as_bytes().get(range.end).is_some_and(u8::is_ascii_digit);
    let mine = last == range.start
        || flat.text.as_bytes()[last] != b'.'
        || !number_follows
        || !flat.is_parted(&(last - 1..range.end))
        || flat.is_parted(&(last..range.end + 1));
    if mine { range.end } else { last }
}

/// Could what stands behind the name be the second operand?
fn value_follows(flat: &Flat, name: &Range<usize>) -> bool {
    flat.text.as_bytes().get(name.end).is_some_and(|b| matches!(b, b'(' | b'.' | b'-' | b'+'))
}

/// Bytes of the file under a range of the statement's characters.
fn span(flat: &Flat, range: Range<usize>) -> SimpleSpan<u32> {
    let start = flat.places.get(range.start).copied().unwrap_or(0);
    let end = flat.places.get(range.end.wrapping_sub(1)).map_or(start, |p| p + 1);
    SimpleSpan::from(start..end)
}
