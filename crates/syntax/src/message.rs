//! Words for a statement that the grammar does not take.

use aptc_diagnostics::{Diagnostic, FileId, Span, codes};
use aptc_vocabulary::{Class, Dialect, Word, closest, word};
use chumsky::error::{Rich, RichPattern, RichReason};
use chumsky::span::SimpleSpan;

use crate::Interner;
use crate::form::Form;
use crate::separator;
use crate::token::{Spanned, Token, sign};
use crate::tree::Name;

/// Longest piece of source that a message repeats.
const LONGEST: usize = 32;

/// A statement that failed.
pub(crate) struct Failed<'f> {
    pub(crate) file: FileId,
    pub(crate) source: &'f str,
    pub(crate) interner: &'f Interner,
    pub(crate) form: Form,
    pub(crate) tokens: &'f [Spanned],
    pub(crate) statement: Span,
}

impl Failed<'_> {
    /// What was expected where, what was found, and what to do.
    pub(crate) fn explain(&self, error: Option<Rich<'_, Token, SimpleSpan<u32>>>) -> Diagnostic {
        let head = self.name(0).and_then(|name| separator::check_head(name, self.source));
        if let Some(diagnostic) = head.filter(|_| self.form == Form::Clauses) {
            return diagnostic;
        }
        let Some(error) = error else {
            let message = "this statement cannot be read";
            return Diagnostic::error(codes::EXPECTED_OTHERWISE, self.statement, message);
        };
        let at = error.span();
        let i = self.tokens.iter().position(|t| t.1.start >= at.start).unwrap_or(self.tokens.len());
        // In `P=POINT1,2` only a definition makes sense of the comma.
        let defines = self.form == Form::Assign && self.token(i) == Some(Token::Comma);
        let before = i.checked_sub(1).and_then(|n| self.name(n));
        let run_together = before.and_then(|name| match self.token(i.wrapping_sub(2)) {
            Some(Token::Equal) if defines => separator::check_head(name, self.source),
            _ => separator::check(name, self.source),
        });
        if let Some(diagnostic) = run_together {
            return diagnostic;
        }
        let mut expected: Vec<String> = match error.reason() {
            RichReason::ExpectedFound { expected, .. } => expected.iter().map(pattern).collect(),
            RichReason::Custom(text) => vec![text.clone()],
        };
        expected.sort_by_key(|e| (rank(e), e.clone()));
        expected.dedup();
        // Where a value must stand, that says it all; elsewhere rare signs only distract.
        if expected.iter().any(|e| rank(e) <= VALUE) {
            expected.retain(|e| rank(e) <= VALUE);
        } else if expected.iter().any(|e| rank(e) < RARE) {
            expected.retain(|e| rank(e) < RARE);
        }
        let found = self.found(i);
        let message = match &expected[..] {
            [] => format!("{found} is not expected here"),
            [one] => format!("expected {one}, found {found}"),
            [most @ .., last] => {
                format!("expected {} or {last}, found {found}", most.join(", "))
            }
        };
        let span = match self.tokens.get(i) {
            Some((_, span)) => Span::new(self.file, span.start, span.end),
            None => Span::new(self.file, self.statement.end, self.statement.end),
        };
        let mut diagnostic = Diagnostic::error(codes::EXPECTED_OTHERWISE, span, message);
        if let Some(context) = self.context(i) {
            diagnostic = diagnostic.label(context);
        }
        match self.help(i) {
            Some(help) => diagnostic.help(help),
            None => diagnostic,
        }
    }

    fn token(&self, i: usize) -> Option<Token> {
        self.tokens.get(i).map(|t| t.0)
    }

    fn name(&self, i: usize) -> Option<Name> {
        let (token, span) = self.tokens.get(i)?;
        let (Token::Name(symbol, word) | Token::Head(symbol, word)) = *token else { return None };
        Some(Name { symbol, word, span: Span::new(self.file, span.start, span.end) })
    }

    fn spelling(&self, i: usize) -> &str {
        self.name(i).map_or("", |name| self.interner.text(name.symbol))
    }

    /// What stands at token `i`, as the user wrote it.
    fn found(&self, i: usize) -> String {
        let Some((token, span)) = self.tokens.get(i) else {
            return "the end of the statement".to_owned();
        };
        if let Token::Name(symbol, _) | Token::Head(symbol, _) = token {
            return format!("`{}`", self.interner.text(*symbol));
        }
        let text = self.source.get(span.start as usize..span.end as usize).unwrap_or("");
        match token {
            _ if text.len() <= LONGEST && !text.contains(['\n', '`']) => format!("`{text}`"),
            Token::Number(..) => "a number".to_owned(),
            Token::Text(_) => "a quoted text".to_owned(),
            Token::Fixed(_) => "a text".to_owned(),
            Token::Operator(op) => format!("`{}`", sign(*op)),
            _ => "a sign".to_owned(),
        }
    }

    /// Inside of what token `i` stands.
    fn context(&self, i: usize) -> Option<String> {
        let mut depth = 0_usize;
        let mut open = None;
        for (n, (token, _)) in self.tokens[..i.min(self.tokens.len())].iter().enumerate().rev() {
            match token {
                Token::Close => depth += 1,
                Token::Open if depth == 0 => {
                    open = Some(n);
                    break;
                }
                Token::Open => depth -= 1,
                _ => {}
            }
        }
        let from = open.map_or(0, |n| n + 1);
        let head = self.tokens[from..i.min(self.tokens.len())]
            .iter()
            .position(|(token, _)| matches!(token, Token::Head(..)));
        if let Some(head) = head {
            return Some(format!("among the arguments of {}", self.spelling(from + head)));
        }
        match open {
            Some(n) if n > 0 && self.name(n - 1).is_some() => {
                Some(format!("in the brackets behind {}", self.spelling(n - 1)))
            }
            Some(_) => Some("in these brackets".to_owned()),
            None => match self.form {
                Form::Clauses | Form::Call | Form::Do => {
                    let slash = self.tokens[..i.min(self.tokens.len())]
                        .iter()
                        .position(|(token, _)| *token == Token::Slash)?;
                    let head = slash.checked_sub(1)?;
                    Some(format!("among the arguments of {}", self.spelling(head)))
                }
                _ => None,
            },
        }
    }

    /// What to do about it, where that is clear.
    fn help(&self, i: usize) -> Option<String> {
        let before = i.checked_sub(1).and_then(|n| self.token(n));
        let at = self.token(i);
        match self.form {
            Form::Assign
                if at == Some(Token::Comma) && self.subscript_ends().is_some_and(|end| i < end) =>
            {
                return Some("a symbol has one subscript".to_owned());
            }
            Form::If
                if at.is_none() || at == Some(Token::Comma) || before == Some(Token::Comma) =>
            {
                return Some(
                    "IF(value)l1,l2,l3 needs three labels: for negative, zero, positive".to_owned(),
                );
            }
            Form::Do if i <= 8 => {
                return Some("a loop begins DO/label,variable=first,last".to_owned());
            }
            Form::Call if i <= 2 => {
                return Some("a macro is called CALL/name,parameter=value".to_owned());
            }
            Form::Macro => return Some("a macro begins name=MACRO/parameter,parameter".to_owned()),
            _ => {}
        }
        if i.checked_sub(1).is_some_and(|n| self.is_slash(n) && self.is_slash(i)) {
            return Some("a comment begins with `$$`".to_owned());
        }
        let goes_on =
            matches!(at, Some(Token::Comma | Token::Slash | Token::Close | Token::Operator(_)));
        if i == 0 && goes_on {
            return Some("end the card before with `$` if its statement goes on here".to_owned());
        }
        if i == 0 {
            return Some("a statement begins with a word, a symbol or a label".to_owned());
        }
        if at.is_none() && before != Some(Token::Equal) {
            return Some("end the card with `$` if the statement goes on".to_owned());
        }
        if let Some(help) = self.help_with_head(i) {
            return Some(help);
        }
        let defining = |name: Name| name.word.is_some_and(|w| w.class() == Class::Geometry);
        if matches!(at, Some(Token::Comma | Token::Equal)) && self.name(i - 1).is_some_and(defining)
        {
            let name = self.spelling(i - 1);
            return Some(format!("{name} takes its arguments behind a `/`"));
        }
        let ends_value = matches!(
            before,
            Some(
                Token::Name(..)
                    | Token::Number(..)
                    | Token::Text(_)
                    | Token::Truth(_)
                    | Token::Close
            )
        );
        let begins_value = matches!(
            at,
            Some(
                Token::Name(..)
                    | Token::Head(..)
                    | Token::Number(..)
                    | Token::Text(_)
                    | Token::Open
            )
        );
        if ends_value && begins_value {
            let found = self.found(i);
            return Some(format!("a `,` or an operator is missing in front of {found}"));
        }
        None
    }

    /// Where the subscript of the symbol that is assigned to ends.
    fn subscript_ends(&self) -> Option<usize> {
        self.tokens.iter().position(|t| t.0 == Token::Equal)
    }

    /// Is token `i` written `/`?
    fn is_slash(&self, i: usize) -> bool {
        self.tokens.get(i).is_some_and(|(_, span)| {
            self.source.get(span.start as usize..span.end as usize) == Some("/")
        })
    }

    /// Help for a mistake at or right behind the word at the head.
    fn help_with_head(&self, i: usize) -> Option<String> {
        if self.form != Form::Clauses {
            return None;
        }
        let heads_only = !self.tokens[..i].iter().any(|t| t.0 == Token::Slash);
        let head = self.name(0)?;
        let Some(word) = head.word else {
            let mut letters = self.spelling(0).chars();
            if matches!(letters.next(), Some('G' | 'M'))
                && letters.next().is_some_and(|c| c.is_ascii_digit())
            {
                return Some("this is machine code; APT moves the tool by GOTO/x,y,z".to_owned());
            }
            let meant = closest(self.spelling(0), is_head)?;
            return Some(format!("did you mean {meant}?"));
        };
        if word == word::IF {
            return Some(separator::IF_HELP.to_owned());
        }
        let argument = self.token(i).is_some_and(|t| {
            matches!(t, Token::Number(..) | Token::Open | Token::Text(_) | Token::Operator(_))
        });
        (heads_only && argument).then(|| {
            let last = (0..i).rev().find(|&n| self.name(n).is_some()).unwrap_or(0);
            format!("{} takes its arguments behind a `/`", self.spelling(last))
        })
    }
}

fn is_head(word: Word) -> bool {
    word.is_major(Dialect::Apt360) || word.is_major(Dialect::Apt4)
}

fn pattern(pattern: &RichPattern<'_, Token>) -> String {
    match pattern {
        RichPattern::Token(token) => match **token {
            Token::Slash => "`/`",
            Token::Comma => "`,`",
            Token::Equal => "`=`",
            Token::Open => "`(`",
            Token::Close => "`)`",
            Token::Colon => "`:`",
            _ => "a sign",
        }
        .to_owned(),
        RichPattern::Label(label) => label.to_string(),
        RichPattern::EndOfInput => "the end of the statement".to_owned(),
        _ => "something else".to_owned(),
    }
}

/// Ranks up to this are kinds of values, those from [`RARE`] on are seldom what is meant.
const VALUE: u8 = 1;
const RARE: u8 = 8;

/// Order in which expected things are named.
fn rank(expected: &str) -> u8 {
    match expected {
        "a value" => 0,
        "`=`" | "`(`" | "something else" => RARE,
        "an operator" => 6,
        "the end of the statement" => 7,
        e if e.starts_with('`') => 5,
        _ => VALUE,
    }
}
