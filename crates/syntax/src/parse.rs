//! From a file to its statements.

use std::collections::BTreeMap;
use std::ops::Range;

use aptc_diagnostics::{Diagnostic, FileId, Label, Span, codes};
use aptc_vocabulary::{Dialect, Word, word};
use chumsky::Parser;
use chumsky::error::{EmptyErr, Rich};
use chumsky::input::Input;
use chumsky::span::SimpleSpan;

use crate::fixed::{FixedText, printable};
use crate::form::{Form, form, is_assignment};
use crate::grammar::{Beside, Grammar};
use crate::identification::{Behind, Tail};
use crate::lex::{Lexed, Lexer};
use crate::message::Failed;
use crate::scan::{Flat, Scanned, Scanner, place};
use crate::shape::{self, Heads, Level};
use crate::shelf::Shelves;
use crate::token::{Spanned, Token};
use crate::tree::{Body, Name, Statement};
use crate::{Interner, Options, Parsed, Symbol, separator};

/// Tokens that are kept at a time. The rules are built anew for each batch, which takes microseconds,
/// and the tokens stay in the cache.
const BATCH: usize = 1 << 13;

/// A statement between lexer and grammar.
struct Pending {
    isn: u32,
    line: u32,
    span: Span,
    label: Option<Name>,
    content: Content,
    warning: Option<Diagnostic>,
    /// Does text that is no identification stand behind column 72 of its cards?
    tail: Option<Tail>,
}

enum Content {
    Ready(Box<Body>),
    Tokens(Range<usize>, Form),
    Fault(Box<Diagnostic>, Names),
    /// It goes on behind column 72.
    CutOff(Names),
}

/// A statement that ended before it was complete, most likely for want of a `$`.
struct Broken {
    isn: u32,
    /// Its message.
    message: usize,
    /// Did it end with a comma?
    comma: bool,
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
        synonyms: BTreeMap::new(),
        levels: Vec::new(),
        broken: None,
        behind: Behind::new(text, options.free_form),
        parsed: Parsed::default(),
    };
    // The first message, whose place is known to `tell`.
    run.parsed.diagnostics.extend(run.behind.message(file, text));
    let mut scanner = Scanner::new(text, options.free_form, options.first_isn);
    let mut flat = Flat::default();
    let (mut lists, mut pending) = (Lists::default(), Vec::new());
    let mut open = true;
    while open {
        open = run.batch(&mut scanner, &mut flat, &mut lists, &mut pending);
    }
    let mut parsed = run.parsed;
    parsed.program.n_cards = scanner.n_numbered;
    if !options.percent_comments {
        parsed.diagnostics.extend(other_dialect(file, &scanner.percents));
    }
    parsed.diagnostics.sort_by_key(|d| d.span.start);
    parsed
}

/// What the statements of a batch have in common.
#[derive(Default)]
struct Lists {
    tokens: Vec<Spanned>,
    texts: Vec<Box<str>>,
    fixed: Vec<Body>,
    shelves: Shelves,
}

impl Lists {
    fn clear(&mut self) {
        self.tokens.clear();
        self.texts.clear();
        self.fixed.clear();
    }
}

/// The grammar that knows what it expected.
type Thorough<'t> = Grammar<'t, Rich<'t, Token, SimpleSpan<u32>>>;

struct Run<'r> {
    file: FileId,
    source: &'r str,
    options: &'r Options,
    nameless: Symbol,
    interner: &'r mut Interner,
    /// New names of words, by SYN.
    synonyms: BTreeMap<Symbol, Word>,
    levels: Vec<Level>,
    broken: Option<Broken>,
    behind: Behind,
    parsed: Parsed,
}

impl Run<'_> {
    /// Reads the next statements; `false` at the end of the file.
    fn batch(
        &mut self,
        scanner: &mut Scanner<'_>,
        flat: &mut Flat,
        lists: &mut Lists,
        pending: &mut Vec<Pending>,
    ) -> bool {
        lists.clear();
        let mut open = true;
        while lists.tokens.len() < BATCH {
            let Some(scanned) = scanner.next(flat) else {
                open = false;
                break;
            };
            let tail =
                self.behind.of(self.source, &scanner.pieces).filter(|_| scanned.fixed.is_none());
            pending.push(self.prepare(scanned, tail, flat, lists));
        }
        let Lists { tokens, texts, fixed, shelves } = &*lists;
        let nameless = self.nameless;
        let beside = Beside { file: self.file, texts, fixed, nameless, shelves, quick: true };
        let quick: Grammar<'_, EmptyErr> = Grammar::new(beside);
        let mut thorough: Option<Thorough<'_>> = None;
        self.parsed.program.statements.reserve(pending.len());
        for Pending { isn, line, span, label, content, warning, tail } in pending.drain(..) {
            let read = match content {
                Content::Ready(body) => Ok(*body),
                Content::Fault(fault, names) => Err((Some(*fault), names)),
                Content::CutOff(names) => Err((None, names)),
                Content::Tokens(range, form) => {
                    let tokens = &tokens[range];
                    let end = SimpleSpan::from(span.end..span.end);
                    shelves.clear();
                    let result = quick.rule(form).parse(tokens.split_token_span(end));
                    let fault = match result.output() {
                        Some(body) => separator::in_heads(body, self.source),
                        None => {
                            let grammar = thorough.get_or_insert_with(|| {
                                Grammar::new(Beside { quick: false, ..beside })
                            });
                            Some(self.explain(grammar, form, tokens, span))
                        }
                    };
                    match (fault, result.into_output()) {
                        (Some(fault), _) => Err((Some(fault), names(self.file, tokens))),
                        (None, body) => Ok(body.unwrap_or(Body::Empty)),
                    }
                }
            };
            let body = match read {
                Ok(body) => {
                    self.parsed.diagnostics.extend(warning);
                    body
                }
                Err((fault, (defines, within))) => {
                    match fault.filter(|_| tail.is_none()) {
                        Some(fault) => self.tell(fault, isn, span),
                        None => self.cut_off(isn),
                    }
                    Body::Error { defines, within }
                }
            };
            self.parsed.program.statements.push(Statement { span, line, isn, label, body });
        }
        open
    }

    /// The message about text behind column 72 tells of this statement too, and of what follows from it.
    fn cut_off(&mut self, isn: u32) {
        if let Some(message) = self.parsed.diagnostics.first_mut() {
            self.behind.cut_off(message);
            self.broken = Some(Broken { isn, message: 0, comma: false });
        }
    }

    /// Gives the message of a statement in error; but not where the card before broke off, whose message
    /// then shows this one too: one mistake, one message.
    fn tell(&mut self, fault: Diagnostic, isn: u32, span: Span) {
        let breaks_off = match fault.code {
            codes::UNCLOSED_BRACKET => true,
            codes::EXPECTED_OTHERWISE => fault.span.end >= span.end,
            _ => false,
        };
        let starts = fault.span.start == span.start;
        // A card that ends with a comma goes on in the next one, unless that is a statement of its own.
        let text = self.source.get(span.start as usize..span.end as usize).unwrap_or_default();
        let sign = text.find(['/', ',', '=', '(', ')']).and_then(|i| text.as_bytes().get(i));
        let own = matches!(sign, Some(b'/' | b'='));
        let lost = |b: &Broken| b.isn + 1 == isn && (starts || b.comma && !own);
        let before = self.broken.take().filter(lost);
        let at = fault.span.start as usize..fault.span.end as usize;
        let comma = breaks_off && self.source.get(at) == Some(",");
        let goes_on = before.is_some();
        let message = match before {
            Some(Broken { message, .. }) => {
                let earlier = &mut self.parsed.diagnostics[message];
                earlier
                    .labels
                    .push(Label { span, text: "does the statement go on here?".to_owned() });
                message
            }
            None => {
                self.parsed.diagnostics.push(fault);
                self.parsed.diagnostics.len() - 1
            }
        };
        self.broken = (breaks_off || goes_on).then_some(Broken { isn, message, comma });
    }

    /// The message for a statement that the grammar does not take.
    fn explain<'t>(
        &self,
        grammar: &Thorough<'t>,
        form: Form,
        tokens: &'t [Spanned],
        statement: Span,
    ) -> Diagnostic {
        let end = SimpleSpan::from(statement.end..statement.end);
        let errors = grammar.rule(form).parse(tokens.split_token_span(end)).into_errors();
        let failed = Failed {
            file: self.file,
            source: self.source,
            interner: self.interner,
            form,
            tokens,
            statement,
        };
        failed.explain(errors.into_iter().next())
    }

    /// Lexes a statement and looks over it.
    fn prepare(
        &mut self,
        scanned: Scanned,
        tail: Option<Tail>,
        flat: &Flat,
        lists: &mut Lists,
    ) -> Pending {
        let Scanned { isn, line, fixed, dangling } = scanned;
        let from = lists.tokens.len();
        let mut lexer = Lexer {
            file: self.file,
            source: self.source,
            interner: self.interner,
            tokens: &mut lists.tokens,
            texts: &mut lists.texts,
            max_elements: self.options.max_elements,
        };
        let Lexed { label, mut fault, warning } = lexer.statement(flat);
        let start = flat.places.first().copied();
        let end = flat.places.last().map_or(0, |p| p + 1);
        let mut span = Span::new(self.file, start.unwrap_or(0), end);
        if let Some(text) = fixed {
            span = Span::new(
                self.file,
                start.unwrap_or(text.word.start),
                text.text.end.max(text.word.end),
            );
            let body = self.text(&text);
            if fault.is_none() && lists.tokens.len() == from {
                let content = Content::Ready(Box::new(body));
                return Pending { isn, line, span, label, content, warning: None, tail };
            }
            lists.fixed.push(body);
            let at = SimpleSpan::from(text.word.start..span.end);
            lists.tokens.push((Token::Fixed(place(lists.fixed.len() - 1)), at));
        }
        if let (None, Some(dollar)) = (&fault, dangling) {
            let dollar = Span::new(self.file, dollar.start, dollar.end);
            span = if flat.text.is_empty() { dollar } else { span };
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
        self.apply_synonyms(&mut lists.tokens[from..]);
        let statement = &mut lists.tokens[from..];
        let form = form(statement);
        if fault.is_none() {
            let heads = Heads { assignment: is_assignment(statement, form) };
            let depth = self.options.max_bracket_depth;
            fault = shape::check(self.file, statement, &heads, depth, &mut self.levels);
        }
        let content = if tail == Some(Tail::Adjoining) {
            let names = names(self.file, statement);
            lists.tokens.truncate(from);
            Content::CutOff(names)
        } else if let Some(fault) = fault {
            let names = names(self.file, statement);
            lists.tokens.truncate(from);
            Content::Fault(Box::new(fault), names)
        } else if statement.is_empty() {
            Content::Ready(Box::new(Body::Empty))
        } else {
            self.note_synonyms(&lists.tokens[from..]);
            Content::Tokens(from..lists.tokens.len(), form)
        };
        Pending { isn, line, span, label, content, warning, tail }
    }

    /// The body of a fixed-field statement.
    fn text(&self, fixed: &FixedText) -> Body {
        let text = &self.source[fixed.text.start as usize..fixed.text.end as usize];
        let text_span = Span::new(self.file, fixed.text.start, fixed.text.end);
        Body::Text { word: fixed.word_is, text_span, text: printable(text) }
    }

    /// Names that SYN gave to words mean those words from then on, up to FINI.
    fn apply_synonyms(&mut self, tokens: &mut [Spanned]) {
        if self.synonyms.is_empty() {
            return;
        }
        match tokens.first() {
            Some((Token::Name(_, Some(word::SYN)), _)) => return,
            Some((Token::Name(_, Some(word::FINI)), _)) => self.synonyms.clear(),
            _ => {}
        }
        for (token, _) in tokens {
            if let Token::Name(symbol, word) = token
                && let Some(meant) = self.synonyms.get(symbol)
            {
                *word = Some(*meant);
            }
        }
    }

    /// Remembers the new names of words. The first pair decides the order: the new name stands first,
    /// unless its second is no word of APT.
    fn note_synonyms(&mut self, tokens: &[Spanned]) {
        let [(Token::Name(_, Some(word::SYN)), _), (Token::Slash, _), rest @ ..] = tokens else {
            return;
        };
        let names = rest.iter().filter_map(|t| match t.0 {
            Token::Name(symbol, word) => Some((symbol, word)),
            _ => None,
        });
        let names: Vec<_> = names.collect();
        let of_apt = |word: Option<Word>| {
            word.filter(|w| Dialect::ALL.iter().any(|d| *d != Dialect::Ncl && w.is_in(*d)))
        };
        let mut word_first = None;
        for pair in names.chunks_exact(2) {
            let (a, b) = (pair[0], pair[1]);
            let (new, old) =
                if *word_first.get_or_insert(of_apt(b.1).is_none()) { (b, a) } else { (a, b) };
            if let Some(word) = of_apt(old.1).or_else(|| self.synonyms.get(&old.0).copied()) {
                self.synonyms.insert(new.0, word);
            }
        }
    }
}

/// The one message for all cards that begin with `%`.
fn other_dialect(file: FileId, percents: &[Range<u32>]) -> Option<Diagnostic> {
    let first = percents.first()?;
    let cards = match percents.len() {
        1 => "this card begins".to_owned(),
        n => format!("{n} cards begin"),
    };
    let span = Span::new(file, first.start, first.end);
    let message = format!("{cards} with `%`, which is a comment in the dialect NCL but not in APT");
    Some(
        Diagnostic::error(codes::NCL_COMMENT, span, message)
            .help("begin comments with `$$`; this file may have been written for NCL"),
    )
}

/// The names that a statement in error would have defined: the one left of its `=`, and those within.
type Names = (Option<Name>, Box<[Name]>);

fn names(file: FileId, tokens: &[Spanned]) -> Names {
    (defines(file, tokens), within(file, tokens))
}

/// Names of definitions in brackets, `(P1=POINT/..`, and of the variable of a DO whose slash is missing.
fn within(file: FileId, tokens: &[Spanned]) -> Box<[Name]> {
    let name = |i: usize| match *tokens.get(i)? {
        (Token::Name(symbol, word), span) => {
            Some(Name { symbol, word, span: Span::new(file, span.start, span.end) })
        }
        _ => None,
    };
    let is = |i: usize, token: Token| tokens.get(i).is_some_and(|t| t.0 == token);
    let bracketed = (1..tokens.len())
        .filter(|i| is(i - 1, Token::Open) && is(i + 1, Token::Equal))
        .filter_map(name);
    // `DO 20, I=1,6`: blanks mean nothing, so it begins with the name DO20.
    let counted =
        (name(0).is_some() && is(1, Token::Comma) && is(3, Token::Equal)).then(|| name(2));
    // What OBTAIN and RESERV give values to.
    let gives = matches!(name(0).and_then(|n| n.word), Some(word::OBTAIN | word::RESERV));
    let given = (1..tokens.len()).filter(|_| gives).filter_map(name).filter(|n| n.word.is_none());
    bracketed.chain(counted.flatten()).chain(given).collect()
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
        Token::Slash => None,
        // `P1,POINT/..`: the sign between is another one.
        _ => {
            let geometry =
                |t: &Spanned| matches!(t.0, Token::Name(_, Some(w)) if shape::defines(w));
            let meant = tokens[1..3.min(tokens.len())].iter().any(geometry);
            (word.is_none() && meant).then_some(name)
        }
    }
}
