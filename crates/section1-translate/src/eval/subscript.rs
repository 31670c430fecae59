//! Subscripts: one element, or several by THRU, ALL, INCR and DECR.

use aptc_diagnostics::{Diagnostic, Span, codes};
use aptc_syntax::tree::{Expr, ExprKind, Name};
use aptc_vocabulary::word;

use super::{Known, Poisoned};
use crate::Interpreter;
use crate::memory::{Place, Value};

impl Interpreter<'_> {
    /// `P(3)`, or a function of that name.
    pub(super) fn indexed(&mut self, name: &Name, args: &[Expr], span: Span) -> Known<Value> {
        let place = self.memory.place(name.symbol);
        let array = match self.memory.slot(place).value {
            Value::Array(array) => array,
            Value::Poison => return Err(Poisoned),
            Value::Unset => match self.synonyms.word(name) {
                Some(word) => return self.function(word, args, span),
                None => return Err(self.not_reserved(name)),
            },
            _ => match self.synonyms.word(name).filter(|w| super::functions::is_function(*w)) {
                Some(word) => return self.function(word, args, span),
                None => return Err(self.not_reserved(name)),
            },
        };
        let element = self.indexed_element(array, place, args, span)?;
        self.element_value(element, span)
    }

    /// The element that a single subscript names.
    pub(crate) fn indexed_element(
        &mut self,
        array: u32,
        place: Place,
        args: &[Expr],
        span: Span,
    ) -> Known<Place> {
        self.memory.slot_mut(place).read = true;
        let [subscript] = args else {
            self.error(
                Diagnostic::error(
                    codes::BAD_SUBSCRIPT,
                    span,
                    format!("{} subscripts where one is expected", args.len()),
                )
                .help("several elements stand in lists of a definition, PRINT or PUNCH only"),
            );
            return Err(Poisoned);
        };
        let n = self.number(subscript)?;
        self.element(array, n, subscript.span)
    }

    /// The value of an element.
    pub(super) fn element_value(&mut self, element: Place, span: Span) -> Known<Value> {
        let slot = self.memory.slot_mut(element);
        match &slot.value {
            Value::Unset => Err(self.unset_element(element, span)),
            Value::Poison => {
                self.blamed = Some((element, slot.given));
                Err(Poisoned)
            }
            value => {
                let value = value.clone();
                slot.read = true;
                Ok(value)
            }
        }
    }

    /// The element with subscript `n`, which is truncated.
    pub(crate) fn element(&mut self, array: u32, n: f64, span: Span) -> Known<Place> {
        let len = self.memory.array(array).slots.len();
        if n >= 1.0 && n < usize_to_f64(len) + 1.0 {
            #[expect(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                reason = "between 1 and the length of an array"
            )]
            return Ok(Place::Element(array, n as u32 - 1));
        }
        let name = self.interner.text(self.memory.array(array).symbol).to_owned();
        self.error(
            Diagnostic::error(
                codes::SUBSCRIPT_OUT_OF_RANGE,
                span,
                format!("subscript {n} is outside 1 to {len} of {name}"),
            )
            .help(format!("reserve more: RESERV/{name},n, or check the subscript")),
        );
        Err(Poisoned)
    }

    /// Says that an element has no value.
    pub(super) fn unset_element(&mut self, element: Place, span: Span) -> Poisoned {
        let doubtful = match element {
            Place::Element(array, _) => self.memory.array(array).doubtful,
            _ => false,
        };
        if !doubtful && !self.is_doubtful(self.memory.name(element).0) {
            let name = self.spelled(element);
            self.error(
                Diagnostic::error(codes::UNDEFINED_NAME, span, format!("{name} has no value here"))
                    .help(format!("give {name} a value in a statement before this one")),
            );
        }
        self.memory.set(element, Value::Poison, span);
        Poisoned
    }

    /// Do the subscripts name several elements, as in `P(1,THRU,5)`?
    pub(crate) fn several(&self, args: &[Expr]) -> bool {
        args.len() > 1 || args.iter().any(|a| self.inclusive_word(a).is_some())
    }

    fn inclusive_word(&self, expr: &Expr) -> Option<aptc_vocabulary::Word> {
        match &expr.kind {
            ExprKind::Name(name) => self
                .synonyms
                .word(name)
                .filter(|w| matches!(*w, word::THRU | word::ALL | word::INCR | word::DECR)),
            _ => None,
        }
    }

    /// The elements that `a,THRU,b,INCR,c` and its shorter forms name, in order.
    ///
    /// The list runs from a to b by c, or from b to a when c is negative or follows DECR (a negative c
    /// with DECR runs up again). When b lies before a, the first of the list stands alone.
    pub(crate) fn elements(&mut self, array: u32, args: &[Expr], span: Span) -> Known<Vec<Place>> {
        let len = self.memory.array(array).slots.len();
        let words: Vec<_> = args.iter().map(|a| self.inclusive_word(a)).collect();
        let (range, rest) = match words.as_slice() {
            [Some(word::ALL), ..] => ((None, None), 1),
            [Some(word::THRU), Some(word::ALL), ..] => ((None, None), 2),
            [Some(word::THRU), None, ..] => ((None, Some(&args[1])), 2),
            [None, Some(word::THRU), Some(word::ALL), ..] => ((Some(&args[0]), None), 3),
            [None, Some(word::THRU), None, ..] => ((Some(&args[0]), Some(&args[2])), 3),
            _ => return Err(self.bad_inclusive(span)),
        };
        let step = match (&words[rest..], &args[rest..]) {
            ([], _) => Ok(1.0),
            ([Some(word::INCR), None], [_, by]) => self.number(by),
            ([Some(word::DECR), None], [_, by]) => self.number(by).map(|n| -n),
            _ => return Err(self.bad_inclusive(span)),
        };
        let first = range.0.map_or(Ok(1.0), |e| self.number(e));
        let last = range.1.map_or(Ok(usize_to_f64(len)), |e| self.number(e));
        let (first, last, step) = (first?.trunc(), last?.trunc(), step?.trunc());
        if step == 0.0 {
            return Err(self.bad_inclusive(span));
        }
        let ends = if step > 0.0 { (first, last) } else { (last, first) };
        let (from, to) = (self.element(array, ends.0, span), self.element(array, ends.1, span));
        let (from, to) = (from?, to?);
        let (Place::Element(_, from), Place::Element(_, to)) = (from, to) else {
            unreachable!("elements of an array");
        };
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "a step longer than the array ends after its first element"
        )]
        let stride = step.abs().min(4e9) as usize;
        let places = if step > 0.0 {
            (from..=to.max(from)).step_by(stride).map(|i| Place::Element(array, i)).collect()
        } else {
            (to.min(from)..=from).rev().step_by(stride).map(|i| Place::Element(array, i)).collect()
        };
        Ok(places)
    }

    fn bad_inclusive(&mut self, span: Span) -> Poisoned {
        self.error(
            Diagnostic::error(codes::BAD_SUBSCRIPT, span, "these subscripts name no elements")
                .help(
                    "write (a,THRU,b), (a,THRU,ALL), (ALL), each perhaps with ,INCR,n or ,DECR,n",
                ),
        );
        Poisoned
    }
}

#[expect(clippy::cast_precision_loss, reason = "arrays are far shorter than 2**52")]
fn usize_to_f64(n: usize) -> f64 {
    n as f64
}
