//! Reading the arguments of a statement one after the other.

use aptc_diagnostics::{Diagnostic, Span, codes};
use aptc_geometry::{Form, Vec3};
use aptc_protap::{NameRef, SurfaceRef};
use aptc_syntax::tree::Clause;
use aptc_vocabulary::Word;

use crate::Interpreter;
use crate::eval::{Arg, ArgKind, Known, Names, Poisoned, describe};

/// The arguments of a clause and how far they are read.
pub(super) struct Reader<'a> {
    args: &'a [Arg],
    at: usize,
    /// The head, for messages.
    head: Word,
    /// All of the clause, for messages.
    span: Span,
}

impl<'a> Reader<'a> {
    /// Before the first argument.
    pub(super) fn new(head: Word, clause: &Clause, args: &'a [Arg]) -> Self {
        Self { args, at: 0, head, span: clause.span }
    }

    /// The next argument, if there is one.
    pub(super) fn peek(&self) -> Option<&'a Arg> {
        self.args.get(self.at)
    }

    /// The argument `n` places on.
    pub(super) fn ahead(&self, n: usize) -> Option<&'a Arg> {
        self.args.get(self.at + n)
    }

    /// Takes the next argument.
    pub(super) fn next(&mut self) -> Option<&'a Arg> {
        let arg = self.args.get(self.at)?;
        self.at += 1;
        Some(arg)
    }

    /// Passes `n` arguments.
    pub(super) fn skip(&mut self, n: usize) {
        self.at = (self.at + n).min(self.args.len());
    }

    /// Are all read?
    pub(super) fn is_empty(&self) -> bool {
        self.at >= self.args.len()
    }

    /// How many are left.
    pub(super) fn left(&self) -> usize {
        self.args.len() - self.at
    }

    /// The next word, if the next is one of `words`; takes it.
    pub(super) fn word_of(&mut self, words: &[Word]) -> Option<Word> {
        let word = self.peek()?.word().filter(|w| words.contains(w))?;
        self.at += 1;
        Some(word)
    }

    /// Is the next one this word? Takes it.
    pub(super) fn is_word(&mut self, word: Word) -> bool {
        self.word_of(&[word]).is_some()
    }

    /// Takes the next when it is a number.
    pub(super) fn number(&mut self) -> Option<f64> {
        let n = self.peek()?.number()?;
        self.at += 1;
        Some(n)
    }

    /// Takes the next when it is a vector.
    pub(super) fn vector(&mut self) -> Option<Vec3> {
        let Form::Vector(v) = self.peek()?.form()? else { return None };
        self.at += 1;
        Some(*v)
    }

    /// Takes the next when it is a point.
    pub(super) fn point(&mut self) -> Option<(Vec3, NameRef)> {
        let arg = self.peek()?;
        let (Form::Point(p), ArgKind::Form { name, .. }) = (arg.form()?, &arg.kind) else {
            return None;
        };
        self.at += 1;
        Some((*p, name.clone()))
    }

    /// Takes the next three when they are numbers.
    pub(super) fn triple(&mut self) -> Option<Vec3> {
        let three = self.args.get(self.at..self.at + 3)?;
        let (x, y, z) = (three[0].number()?, three[1].number()?, three[2].number()?);
        self.at += 3;
        Some(Vec3::new(x, y, z))
    }

    /// How many numbers come next.
    pub(super) fn numbers_ahead(&self) -> usize {
        self.args[self.at..].iter().take_while(|a| a.number().is_some()).count()
    }

    /// Where the argument that was just read stands.
    pub(super) fn before(&self) -> Span {
        self.args.get(self.at.wrapping_sub(1)).map_or(self.span, |a| a.span)
    }

    /// The message that something else is expected at the next argument.
    pub(super) fn expected(&self, what: &str) -> Diagnostic {
        match self.peek() {
            Some(arg) => Diagnostic::error(
                codes::BAD_ARGUMENTS,
                arg.span,
                format!("{} expects {what} here, found {}", self.head, describe(arg)),
            ),
            None => {
                let end = match self.args.last() {
                    Some(last) => Span::new(last.span.file, last.span.end, last.span.end),
                    None => self.span,
                };
                Diagnostic::error(
                    codes::BAD_ARGUMENTS,
                    end,
                    format!("{} ends where {what} is expected", self.head),
                )
            }
        }
    }
}

impl Interpreter<'_> {
    /// The arguments of a clause, as the present reference system sees them; none without a slash.
    ///
    /// Within REFSYS the tool moves in the system of the matrix, in which numbers are given too. APT-360: a form is carried
    /// over where it is used in another system than that of its definition, and nowhere else.
    pub(super) fn args(&mut self, clause: &Clause, names: Names) -> Known<Vec<Arg>> {
        let mut args = self.args_in_base(clause, names)?;
        for arg in &mut args {
            if let ArgKind::Form { form, .. } = &mut arg.kind {
                *form = self.in_system(form, arg.span)?;
            }
        }
        Ok(args)
    }

    /// The arguments of a clause with all forms in the base system.
    pub(super) fn args_in_base(&mut self, clause: &Clause, names: Names) -> Known<Vec<Arg>> {
        self.arguments(clause.args.as_deref().unwrap_or_default(), names)
    }

    /// Tells that something else is expected.
    pub(super) fn expect(&mut self, reader: &Reader<'_>, what: &str) -> Poisoned {
        self.error(reader.expected(what));
        Poisoned
    }

    /// Tells it with what to write.
    pub(super) fn expect_as(&mut self, reader: &Reader<'_>, what: &str, help: &str) -> Poisoned {
        self.error(reader.expected(what).help(help));
        Poisoned
    }

    /// Nothing may be left.
    pub(super) fn at_end(&mut self, reader: &Reader<'_>) -> Known<()> {
        if reader.is_empty() { Ok(()) } else { Err(self.expect(reader, "nothing more")) }
    }

    /// The next argument, which must be a surface.
    pub(super) fn surface(&mut self, reader: &mut Reader<'_>, what: &str) -> Known<SurfaceRef> {
        let Some(Arg { kind: ArgKind::Form { form, name }, .. }) = reader.peek() else {
            if let Some(Arg { kind: ArgKind::Name(symbol), span }) = reader.peek() {
                return Err(self.undefined_argument(*symbol, *span));
            }
            return Err(self.expect(reader, what));
        };
        if !form.is_surface() {
            return Err(self.expect(reader, what));
        }
        reader.skip(1);
        Ok(SurfaceRef { name: name.clone(), form: form.clone() })
    }

    /// A free name stands where a value is needed.
    pub(super) fn undefined_argument(
        &mut self,
        symbol: aptc_syntax::Symbol,
        span: Span,
    ) -> Poisoned {
        self.undefined(&aptc_syntax::tree::Name { symbol, word: None, span })
    }

    /// A clause that takes no arguments has none.
    pub(super) fn bare(&mut self, word: Word, clause: &Clause) -> Known<()> {
        match clause.args.as_deref() {
            None | Some([]) => Ok(()),
            Some([first, ..]) => {
                self.error(
                    Diagnostic::error(
                        codes::BAD_ARGUMENTS,
                        first.span,
                        format!("{word} takes no arguments"),
                    )
                    .help(format!("write {word} alone")),
                );
                Err(Poisoned)
            }
        }
    }
}
