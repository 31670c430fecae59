//! From the characters of a statement to its tokens.

use std::ops::Range;

use aptc_diagnostics::{Diagnostic, FileId, Span, codes};
use aptc_vocabulary::{find, word};
use chumsky::span::SimpleSpan;
use logos::Logos;

use crate::scan::{Flat, place};
use crate::token::{Raw, Spanned, Token};
use crate::tree::{BinaryOp, Name};
use crate::{Interner, Symbol};

/// Longest number that is read; a longer one is no number anybody wrote.
const LONGEST_NUMBER: usize = 400;

/// What the lexer works with and fills.
pub(crate) struct Lexer<'l> {
    pub(crate) file: FileId,
    pub(crate) source: &'l str,
    pub(crate) interner: &'l mut Interner,
    pub(crate) tokens: &'l mut Vec<Spanned>,
    pub(crate) texts: &'l mut Vec<Box<str>>,
    pub(crate) max_elements: usize,
}

/// A statement's label and the message about its characters, if something is wrong with them.
#[derive(Default)]
pub(crate) struct Lexed {
    pub(crate) label: Option<Name>,
    pub(crate) fault: Option<Diagnostic>,
}

impl Lexer<'_> {
    /// Appends the tokens of `flat` to the list, without the label.
    pub(crate) fn statement(&mut self, flat: &Flat) -> Lexed {
        let mut lexed = Lexed::default();
        let from = self.tokens.len();
        let mut with_labels = false;
        let mut first: Option<Range<usize>> = None;
        let mut raws = Raw::lexer(&flat.text).spanned();
        while let Some((raw, range)) = raws.next() {
            let span = span(flat, range.clone());
            let Ok(raw) = raw else {
                lexed.fault.get_or_insert_with(|| self.bad_character(flat, range));
                continue;
            };
            let n = self.tokens.len() - from;
            if n > self.max_elements {
                lexed.fault = Some(self.too_long(flat));
                break;
            }
            // A label is the first thing and a `)` or `:` follows it.
            if n == 1 && lexed.label.is_none() && matches!(raw, Raw::Close | Raw::Colon) {
                if let Some(label) = first.take() {
                    lexed.label = Some(self.name(flat, label));
                    self.tokens.truncate(from);
                    continue;
                }
            }
            if n == 0 && matches!(raw, Raw::Name | Raw::Integer) {
                first = Some(range.clone());
            }
            let token = match raw {
                Raw::Name => {
                    let Name { symbol, word, .. } = self.name(flat, range);
                    with_labels |= n == 0 && matches!(word, Some(word::IF | word::DO));
                    Token::Name(symbol, word)
                }
                Raw::Integer | Raw::Real => {
                    let text = &flat.text[range];
                    let label =
                        (with_labels && raw == Raw::Integer).then(|| self.interner.intern(text));
                    self.number(text, label, span, &mut lexed)
                }
                Raw::IntegerThenOperator => {
                    let text = &flat.text[range.clone()];
                    let digits = text.find('.').unwrap_or(text.len());
                    let number = self.number(&text[..digits], None, span, &mut lexed);
                    let middle = range.start + digits;
                    self.tokens.push((number, self::span(flat, range.start..middle)));
                    self.dotted(flat, middle..range.end);
                    continue;
                }
                Raw::Dotted => {
                    self.dotted(flat, range);
                    continue;
                }
                Raw::Text => {
                    let text = &self.source[span.start as usize + 1..span.end as usize - 1];
                    self.texts.push(text.into());
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
        let text = &flat.text[range.clone()];
        let span = span(flat, range);
        Name {
            symbol: self.interner.intern(text),
            word: find(text),
            span: Span::new(self.file, span.start, span.end),
        }
    }

    fn number(
        &self,
        text: &str,
        label: Option<Symbol>,
        span: SimpleSpan<u32>,
        lexed: &mut Lexed,
    ) -> Token {
        let value = match text.find('D') {
            _ if text.len() > LONGEST_NUMBER => f64::INFINITY,
            Some(_) => text.replace('D', "E").parse().unwrap_or(f64::INFINITY),
            None => text.parse().unwrap_or(f64::INFINITY),
        };
        if !value.is_finite() {
            let span = Span::new(self.file, span.start, span.end);
            lexed.fault.get_or_insert_with(|| {
                let shown: String = text.chars().take(24).collect();
                let dots = if text.len() > 24 { "..." } else { "" };
                Diagnostic::error(
                    codes::NUMBER_TOO_LARGE,
                    span,
                    format!("the number {shown}{dots} is too large"),
                )
                .label("numbers go up to about 1.8E308")
            });
            return Token::Number(0.0, label);
        }
        Token::Number(value, label)
    }

    /// `.EQ.`, `.EQ`, `.TRUE.` and so on.
    fn dotted(&mut self, flat: &Flat, range: Range<usize>) {
        let text = &flat.text[range.clone()];
        let token = match text.trim_matches('.') {
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
        let place = span(flat, range.clone());
        let c = flat.text[range].chars().next().unwrap_or(' ');
        let span = Span::new(self.file, place.start, place.start + place_of(c));
        let message = match c {
            '\'' | '"' => {
                return Diagnostic::error(
                    codes::UNCLOSED_QUOTE,
                    span,
                    format!("no closing {c} on this card"),
                )
                .label("the text begins here")
                .help(format!("close the text with {c}"));
            }
            c if c.is_control() => {
                format!("the control character {} is not of APT", c.escape_unicode())
            }
            c => format!("the character `{c}` is not of APT"),
        };
        Diagnostic::error(codes::ILLEGAL_CHARACTER, span, message)
    }

    fn too_long(&self, flat: &Flat) -> Diagnostic {
        let start = flat.places.first().copied().unwrap_or(0);
        let last = flat.places.last().map_or(start, |p| p + 1);
        Diagnostic::error(
            codes::STATEMENT_TOO_LONG,
            Span::new(self.file, start, last),
            format!("a statement of more than {} words, numbers and signs", self.max_elements),
        )
        .help("divide it, or end the cards that should not go on without a `$`")
    }
}

fn place_of(c: char) -> u32 {
    place(c.len_utf8())
}

/// Bytes of the file under a range of the statement's characters.
fn span(flat: &Flat, range: Range<usize>) -> SimpleSpan<u32> {
    let start = flat.places.get(range.start).copied().unwrap_or(0);
    let end = flat.places.get(range.end.wrapping_sub(1)).map_or(start, |p| p + 1);
    SimpleSpan::from(start..end)
}
