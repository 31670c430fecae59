//! Arguments of statements and definitions.

use std::sync::Arc;

use aptc_diagnostics::{Diagnostic, Span, codes};
use aptc_geometry::Form;
use aptc_protap::NameRef;
use aptc_syntax::Symbol;
use aptc_syntax::tree::{Expr, ExprKind, Indexed, Name};
use aptc_vocabulary::Word;

use super::{Known, Poisoned};
use crate::Interpreter;
use crate::memory::{Place, Value};

/// An argument with its place in the text.
#[derive(Clone, Debug)]
pub(crate) struct Arg {
    /// What it is.
    pub(crate) kind: ArgKind,
    /// Where it stands.
    pub(crate) span: Span,
}

/// What an argument is once names are looked up and expressions computed.
#[derive(Clone, Debug)]
pub(crate) enum ArgKind {
    /// An empty field.
    Empty,
    /// A number.
    Number(f64),
    /// The digits of a number, which may be a label where labels can stand.
    Digits(f64),
    /// A vocabulary word.
    Word(Word),
    /// A name without a value, where such may stand.
    Name(Symbol),
    /// A geometric name or a nested definition, in the base system.
    Form {
        /// Its form.
        form: Arc<Form>,
        /// Its name, empty for an unnamed one.
        name: NameRef,
    },
    /// Quoted text.
    Text(Box<str>),
}

/// What to do with names that have no value and are no words.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Names {
    /// They are mistakes.
    Defined,
    /// They are given out as they are.
    Free,
}

impl Arg {
    /// The number, when it is one.
    pub(crate) fn number(&self) -> Option<f64> {
        match self.kind {
            ArgKind::Number(n) | ArgKind::Digits(n) => Some(n),
            _ => None,
        }
    }

    /// The word, when it is one.
    pub(crate) fn word(&self) -> Option<Word> {
        match self.kind {
            ArgKind::Word(word) => Some(word),
            _ => None,
        }
    }

    /// The form in its normal shape, when it is one.
    pub(crate) fn form(&self) -> Option<&Form> {
        match &self.kind {
            ArgKind::Form { form, .. } => Some(form.shape()),
            _ => None,
        }
    }
}

impl Interpreter<'_> {
    /// All arguments, inclusive subscripts written out. Every mistake among them is told.
    pub(crate) fn arguments(&mut self, exprs: &[Expr], names: Names) -> Known<Vec<Arg>> {
        let mut args = Vec::with_capacity(exprs.len());
        let mut known = Ok(());
        for expr in exprs {
            if self.argument(expr, names, &mut args).is_err() {
                known = Err(Poisoned);
            }
        }
        known.map(|()| args)
    }

    fn argument(&mut self, expr: &Expr, names: Names, args: &mut Vec<Arg>) -> Known<()> {
        let span = expr.span;
        let kind = match &expr.kind {
            ExprKind::Empty => ArgKind::Empty,
            ExprKind::Number(n) => ArgKind::Digits(*n),
            ExprKind::Text(text) => ArgKind::Text(text.clone()),
            ExprKind::Name(name) => self.name_argument(name, names)?,
            ExprKind::Indexed(indexed) => {
                let Indexed { name, list: subscripts } = &**indexed;
                let place = self.memory.place(name.symbol);
                let Value::Array(array) = self.memory.slot(place).value else {
                    let value = self.indexed(name, subscripts, span)?;
                    args.push(Arg { kind: self.argument_of(value, None, span)?, span });
                    return Ok(());
                };
                if self.several(subscripts) {
                    self.memory.slot_mut(place).read = true;
                    return self.elements_as_arguments(array, subscripts, span, args);
                }
                let element = self.indexed_element(array, place, subscripts, span)?;
                let value = self.element_value(element, span)?;
                self.argument_of(value, Some(element), span)?
            }
            ExprKind::Define(definition) => {
                let (form, name) = self.definition(definition, span)?;
                let juxtaposed = self.arguments(&definition.juxtaposed, names)?;
                args.push(Arg { kind: ArgKind::Form { form, name }, span });
                args.extend(juxtaposed);
                return Ok(());
            }
            _ => {
                let value = self.value(expr)?;
                self.argument_of(value, None, span)?
            }
        };
        args.push(Arg { kind, span });
        Ok(())
    }

    fn name_argument(&mut self, name: &Name, names: Names) -> Known<ArgKind> {
        let place = self.memory.place(name.symbol);
        if names == Names::Free
            && matches!(self.memory.slot(place).value, Value::Unset)
            && self.synonyms.word(name).is_none()
        {
            return Ok(ArgKind::Name(name.symbol));
        }
        let value = self.named(name)?;
        self.argument_of(value, Some(place), name.span)
    }

    fn argument_of(&mut self, value: Value, place: Option<Place>, span: Span) -> Known<ArgKind> {
        Ok(match value {
            Value::Number(n) => ArgKind::Number(n),
            Value::Word(word) => ArgKind::Word(word),
            Value::Form(form) => {
                let name = place.map(|p| self.name_ref(p)).unwrap_or_default();
                ArgKind::Form { form, name }
            }
            value => {
                return Err(self.wrong_kind(span, "a number, a word or a geometric name", &value));
            }
        })
    }

    fn elements_as_arguments(
        &mut self,
        array: u32,
        subscripts: &[Expr],
        span: Span,
        args: &mut Vec<Arg>,
    ) -> Known<()> {
        let mut known = Ok(());
        for place in self.elements(array, subscripts, span)? {
            let slot = self.memory.slot_mut(place);
            slot.read = true;
            let kind = match slot.value.clone() {
                Value::Unset => {
                    known = Err(self.unset_element(place, span));
                    continue;
                }
                value => self.argument_of(value, Some(place), span),
            };
            match kind {
                Ok(kind) => args.push(Arg { kind, span }),
                Err(Poisoned) => known = Err(Poisoned),
            }
        }
        known
    }

    /// The scalar variables that OBTAIN gives values to: a place for each field, `None` where it is empty.
    pub(crate) fn targets(&mut self, exprs: &[Expr]) -> Known<Vec<Option<(Place, Span)>>> {
        let mut places = Vec::with_capacity(exprs.len());
        let mut known = Ok(());
        for expr in exprs {
            let place = match &expr.kind {
                ExprKind::Empty => Ok(None),
                ExprKind::Name(name) => {
                    let place = self.memory.place(name.symbol);
                    match self.memory.slot(place).value {
                        Value::Array(_) => Err(self.subscript_missing(place, name.span)),
                        _ => Ok(Some((place, expr.span))),
                    }
                }
                ExprKind::Indexed(indexed) => {
                    self.indexed_target(&indexed.name, &indexed.list, expr)
                }
                _ => {
                    self.error(
                        Diagnostic::error(
                            codes::WRONG_KIND,
                            expr.span,
                            "a name is expected that gets a value",
                        )
                        .help("leave the field empty to skip an element"),
                    );
                    Err(Poisoned)
                }
            };
            match place {
                Ok(place) => places.push(place),
                Err(Poisoned) => known = Err(Poisoned),
            }
        }
        known.map(|()| places)
    }

    fn indexed_target(
        &mut self,
        name: &Name,
        subscripts: &[Expr],
        expr: &Expr,
    ) -> Known<Option<(Place, Span)>> {
        let place = self.memory.place(name.symbol);
        let (Value::Array(array), [subscript]) = (&self.memory.slot(place).value, subscripts)
        else {
            return Err(self.not_reserved(name));
        };
        let array = *array;
        let n = self.number(subscript)?;
        Ok(Some((self.element(array, n, subscript.span)?, expr.span)))
    }
}
