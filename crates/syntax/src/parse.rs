//! From a file to its statements.

use std::collections::BTreeSet;
use std::ops::Range;

use aptc_diagnostics::{Diagnostic, FileId, Span, codes};
use aptc_vocabulary::word;
use chumsky::Parser;
use chumsky::error::{EmptyErr, Rich};
use chumsky::input::Input;
use chumsky::span::SimpleSpan;

use crate::form::{Form, form};
use crate::grammar::{Beside, Grammar};
use crate::lex::Lexer;
use crate::message;
use crate::scan::{Flat, Scanned, Scanner};
use crate::shape::{self, Heads};
use crate::token::{Spanned, Token};
use crate::tree::{Body, Name, Statement};
use crate::{Interner, Options, Parsed, Symbol};

/// Tokens that are kept at a time. The rules are built anew for each batch, which takes microseconds,
/// and memory stays small beside the tree.
const BATCH: usize = 1 << 16;

/// A statement between lexer and grammar.
struct Pending {
    isn: u32,
    line: u32,
    span: Span,
    label: Option<Name>,
    content: Content,
}

enum Content {
    Ready(Body),
    Tokens(Range<usize>, Form),
}

/// Reads `text`. Never fails as a whole: a statement that cannot be read is a [`Body::Error`] with one
/// diagnostic, and the next begins afresh.
pub fn parse(file: FileId, text: &str, interner: &mut Interner, options: &Options) -> Parsed {
    let mut run = Run {
        file,
        source: text,
        options,
        nameless: interner.intern(""),
        interner,
        synonyms: BTreeSet::new(),
        parsed: Parsed::default(),
    };
    let mut scanner = Scanner::new(text, options.free_form, options.first_isn);
    let mut flat = Flat::default();
    let mut open = true;
    while open {
        open = run.batch(&mut scanner, &mut flat);
    }
    let mut parsed = run.parsed;
    parsed.program.n_cards = scanner.n_cards;
    parsed.diagnostics.sort_by_key(|d| d.span.start);
    parsed
}

struct Run<'r> {
    file: FileId,
    source: &'r str,
    options: &'r Options,
    nameless: Symbol,
    interner: &'r mut Interner,
    synonyms: BTreeSet<Symbol>,
    parsed: Parsed,
}

impl Run<'_> {
    /// Reads the next statements; `false` at the end of the file.
    fn batch(&mut self, scanner: &mut Scanner<'_>, flat: &mut Flat) -> bool {
        let mut tokens: Vec<Spanned> = Vec::with_capacity(BATCH.min(self.source.len()));
        let mut texts: Vec<Box<str>> = Vec::new();
        let mut pending: Vec<Pending> = Vec::new();
        let mut open = true;
        while tokens.len() < BATCH {
            let Some(scanned) = scanner.next(flat) else {
                open = false;
                break;
            };
            pending.push(self.prepare(scanned, flat, &mut tokens, &mut texts));
        }
        let beside = Beside { file: self.file, texts: &texts, nameless: self.nameless };
        let quick: Grammar<'_, EmptyErr> = Grammar::new(beside);
        let mut thorough: Option<Grammar<'_, Rich<'_, Token, SimpleSpan<u32>>>> = None;
        self.parsed.program.statements.reserve(pending.len());
        for Pending { isn, line, span, label, content } in pending {
            let body = match content {
                Content::Ready(body) => body,
                Content::Tokens(range, form) => {
                    let end = SimpleSpan::from(span.end..span.end);
                    let slice = &tokens[range];
                    match quick.rule(form).parse(slice.split_token_span(end)).into_result() {
                        Ok(body) => body,
                        Err(_) => {
                            let grammar = thorough.get_or_insert_with(|| Grammar::new(beside));
                            let result = grammar.rule(form).parse(slice.split_token_span(end));
                            let errors = result.into_errors();
                            let message = message::of_grammar(
                                self.file,
                                form,
                                slice,
                                errors.into_iter().next(),
                                self.interner,
                                span,
                            );
                            self.parsed.diagnostics.push(message);
                            Body::Error { defines: defines(self.file, slice) }
                        }
                    }
                }
            };
            self.parsed.program.statements.push(Statement { span, line, isn, label, body });
        }
        open
    }

    /// Lexes a statement and looks over it.
    fn prepare(
        &mut self,
        scanned: Scanned,
        flat: &Flat,
        tokens: &mut Vec<Spanned>,
        texts: &mut Vec<Box<str>>,
    ) -> Pending {
        let Scanned { isn, line, fixed, dangling } = scanned;
        let from = tokens.len();
        let mut lexer = Lexer {
            file: self.file,
            source: self.source,
            interner: self.interner,
            tokens,
            texts,
            max_elements: self.options.max_elements,
        };
        let lexed = lexer.statement(flat);
        let label = lexed.label;
        let start = flat.places.first().copied();
        let end = flat.places.last().map(|p| p + 1);
        let mut span = Span::new(self.file, start.unwrap_or(0), end.unwrap_or(0));
        if let Some(fixed) = fixed {
            let end = fixed.text.end.max(fixed.word.end);
            span = Span::new(self.file, start.unwrap_or(fixed.word.start), end);
            tokens.truncate(from);
            let text = &self.source[fixed.text.start as usize..fixed.text.end as usize];
            let text_span = Span::new(self.file, fixed.text.start, fixed.text.end);
            let body = Body::Text { word: fixed.word_is, text_span, text: text.into() };
            self.parsed.diagnostics.extend(lexed.fault);
            return Pending { isn, line, span, label, content: Content::Ready(body) };
        }
        let mut fault = lexed.fault;
        if let (None, Some(dollar)) = (&fault, dangling) {
            let dollar = Span::new(self.file, dollar.start, dollar.end);
            if flat.text.is_empty() {
                span = dollar;
            }
            fault = Some(
                Diagnostic::error(
                    codes::CONTINUED_PAST_END,
                    dollar,
                    "the file ends where the statement should go on",
                )
                .label("`$` promises a further card")
                .help("take the `$` away, or add the missing cards"),
            );
        }
        let statement = &mut tokens[from..];
        let form = form(statement);
        if fault.is_none() {
            let assignment = form == Form::Assign;
            let heads = Heads { assignment, synonyms: &self.synonyms };
            fault =
                shape::check(self.file, statement, &heads, self.options.max_bracket_depth).err();
        }
        let content = if let Some(fault) = fault {
            self.parsed.diagnostics.push(fault);
            let defines = defines(self.file, statement);
            tokens.truncate(from);
            Content::Ready(Body::Error { defines })
        } else if statement.is_empty() {
            Content::Ready(Body::Empty)
        } else {
            self.note_synonyms(&tokens[from..]);
            Content::Tokens(from..tokens.len(), form)
        };
        Pending { isn, line, span, label, content }
    }

    /// Remembers the new names of words that define, so that `PT/X` is known for a definition.
    fn note_synonyms(&mut self, tokens: &[Spanned]) {
        let [(Token::Name(_, Some(word::SYN)), _), (Token::Slash, _), rest @ ..] = tokens else {
            return;
        };
        let names = rest.iter().filter_map(|t| match t.0 {
            Token::Name(symbol, word) => Some((symbol, word)),
            _ => None,
        });
        let names: Vec<_> = names.collect();
        for pair in names.chunks_exact(2) {
            if pair.iter().any(|(_, word)| word.is_some_and(shape::defines)) {
                self.synonyms.extend(pair.iter().map(|(symbol, _)| *symbol));
            }
        }
    }
}

/// The symbol that a statement in error would have defined.
fn defines(file: FileId, tokens: &[Spanned]) -> Option<Name> {
    let (Token::Name(symbol, word), span) = *tokens.first()? else { return None };
    let name = Name { symbol, word, span: Span::new(file, span.start, span.end) };
    match tokens.get(1)?.0 {
        Token::Equal => Some(name),
        Token::Open => {
            let close = tokens.iter().position(|t| t.0 == Token::Close)?;
            (tokens.get(close + 1)?.0 == Token::Equal).then_some(name)
        }
        _ => None,
    }
}
