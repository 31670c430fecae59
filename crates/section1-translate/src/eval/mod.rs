//! Expressions: from the tree to values.
//!
//! A mistake is told once, where it is made; then the value is [`Poisoned`], and whoever needs it stays
//! silent.

mod argument;
mod arithmetic;
mod cut_vectors;
mod definition;
mod functions;
mod geometric;
mod names;
mod ruled_ends;
mod sculptured;
mod smoothing;
mod subscript;
mod unfit;

use std::sync::Arc;

use aptc_diagnostics::{Diagnostic, Span, codes};
use aptc_geometry::{Form, Vec3};
use aptc_syntax::tree::{BinaryOp, Expr, ExprKind, Target, UnaryOp};

use crate::Interpreter;
use crate::memory::{Place, Value};

pub(crate) use unfit::Unfit;

pub(crate) use argument::{Arg, ArgKind, Names};
pub(crate) use definition::{describe, reason_of};
pub(crate) use sculptured::found_on;

/// A value that could not be had; a message was given where the mistake is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Poisoned;

/// A value, unless a mistake spoilt it.
pub(crate) type Known<T> = Result<T, Poisoned>;

/// The whole number that `n` is, but for the last digits of a computation.
pub(crate) fn whole(n: f64) -> Option<f64> {
    let near = n.round();
    ((n - near).abs() <= 1e-9 * near.abs().max(1.0)).then_some(near)
}

impl Interpreter<'_> {
    /// The number that `expr` gives.
    pub(crate) fn number(&mut self, expr: &Expr) -> Known<f64> {
        match &expr.kind {
            ExprKind::Number(n) => Ok(*n),
            ExprKind::Name(name) => {
                let place = self.memory.place(name.symbol);
                let slot = self.memory.slot_mut(place);
                if let Value::Number(n) = slot.value {
                    slot.read = true;
                    return Ok(n);
                }
                let value = self.named(name)?;
                self.as_number(value, expr.span)
            }
            ExprKind::Binary(op, a, b) if arithmetic::is_arithmetic(*op) => {
                let x = self.number(a);
                // `LIEN/XAXIS` and `RAPID/GOTO/P` were no quotients: what stands right is not wrong.
                let is_word =
                    |e: &Expr| matches!(&e.kind, ExprKind::Name(name) if name.word.is_some());
                if x.is_err() && (is_word(a) || is_word(b)) {
                    return Err(Poisoned);
                }
                let y = self.number(b);
                self.arithmetic(*op, x?, y?, expr.span, b.span)
            }
            ExprKind::Unary(UnaryOp::Neg, a) => Ok(0.0 - self.number(a)?),
            ExprKind::Unary(UnaryOp::Pos, a) => self.number(a),
            _ => {
                let value = self.value(expr)?;
                self.as_number(value, expr.span)
            }
        }
    }

    /// The truth that `expr` gives.
    pub(crate) fn logical(&mut self, expr: &Expr) -> Known<bool> {
        match self.value(expr)? {
            Value::Logical(b) => Ok(b),
            value => Err(self.wrong_kind(expr.span, "a comparison or a logical value", &value)),
        }
    }

    /// What `expr` gives: a number, a logical value, a form, or a word that stands alone.
    pub(crate) fn value(&mut self, expr: &Expr) -> Known<Value> {
        match &expr.kind {
            ExprKind::Number(n) => Ok(Value::Number(*n)),
            ExprKind::Truth(b) => Ok(Value::Logical(*b)),
            ExprKind::Name(name) => self.named(name),
            ExprKind::Indexed(indexed) => self.indexed(&indexed.name, &indexed.list, expr.span),
            ExprKind::Unary(UnaryOp::Not, a) => Ok(Value::Logical(!self.logical(a)?)),
            ExprKind::Unary(..) => self.number(expr).map(Value::Number),
            ExprKind::Binary(op, a, b) => self.binary(*op, a, b, expr),
            ExprKind::Define(definition) => {
                Ok(Value::Form(self.definition(definition, expr.span)?.0))
            }
            ExprKind::Tuple(items) => {
                let point = self.tuple(items, expr.span)?;
                Ok(Value::Form(Arc::new(Form::Point(point))))
            }
            ExprKind::Assign(target, value) => {
                let value = self.value(value);
                let place = self.target(target)?;
                match value {
                    Ok(value) => {
                        self.assign(place, value.clone(), target)?;
                        Ok(value)
                    }
                    Err(Poisoned) => {
                        self.memory.set(place, Value::Poison, target.span);
                        Err(Poisoned)
                    }
                }
            }
            ExprKind::Empty => {
                self.error(Diagnostic::error(
                    codes::WRONG_KIND,
                    expr.span,
                    "a value is missing here",
                ));
                Err(Poisoned)
            }
            ExprKind::Text(_) => {
                self.error(Diagnostic::error(
                    codes::WRONG_KIND,
                    expr.span,
                    "a text stands where a value is expected",
                ));
                Err(Poisoned)
            }
        }
    }

    fn binary(&mut self, op: BinaryOp, a: &Expr, b: &Expr, all: &Expr) -> Known<Value> {
        match op {
            _ if arithmetic::is_arithmetic(op) => self.number(all).map(Value::Number),
            BinaryOp::And | BinaryOp::Or => {
                let (x, y) = (self.logical(a), self.logical(b));
                let (x, y) = (x?, y?);
                Ok(Value::Logical(if op == BinaryOp::And { x && y } else { x || y }))
            }
            BinaryOp::Cross | BinaryOp::Dot => {
                let (x, y) = (self.vector(a), self.vector(b));
                let (x, y) = (x?, y?);
                Ok(if op == BinaryOp::Dot {
                    Value::Number(x.dot(&y))
                } else {
                    Value::Form(Arc::new(Form::Vector(x.cross(&y))))
                })
            }
            _ => {
                let (x, y) = (self.value(a), self.value(b));
                self.compare(op, (x?, a.span), (y?, b.span))
            }
        }
    }

    /// Numbers by size; words and logical values by likeness.
    fn compare(
        &mut self,
        op: BinaryOp,
        (x, x_at): (Value, Span),
        (y, y_at): (Value, Span),
    ) -> Known<Value> {
        let same = match (&x, &y) {
            (Value::Word(a), Value::Word(b)) => Some(a == b),
            (Value::Logical(a), Value::Logical(b)) => Some(a == b),
            _ => None,
        };
        if let (Some(same), BinaryOp::Eq | BinaryOp::Ne) = (same, op) {
            return Ok(Value::Logical(same == (op == BinaryOp::Eq)));
        }
        let (x, y) = (self.as_number(x, x_at), self.as_number(y, y_at));
        Ok(Value::Logical(arithmetic::holds(op, x?, y?)))
    }

    /// The vector that `expr` gives; a point is the vector from the origin to it.
    fn vector(&mut self, expr: &Expr) -> Known<Vec3> {
        let value = self.value(expr)?;
        if let Value::Form(form) = &value
            && matches!(form.shape(), Form::Vector(_) | Form::Point(_))
            && let Form::Vector(v) | Form::Point(v) = *self.in_system(form, expr.span)?
        {
            return Ok(v);
        }
        Err(self.wrong_kind(expr.span, "a vector", &value))
    }

    /// `(x,y)` or `(x,y,z)`: a point in the base system.
    fn tuple(&mut self, items: &[Expr], span: Span) -> Known<Vec3> {
        let numbers: Vec<_> = items.iter().map(|e| self.number(e)).collect();
        let numbers: Vec<f64> = numbers.into_iter().collect::<Known<_>>()?;
        let point = match *numbers {
            [x, y] => self.on_zsurf(x, y),
            [x, y, z] => Vec3::new(x, y, z),
            _ => {
                self.error(
                    Diagnostic::error(
                        codes::WRONG_KIND,
                        span,
                        format!("{} numbers in brackets are no point", numbers.len()),
                    )
                    .help("a point in brackets has two or three coordinates"),
                );
                return Err(Poisoned);
            }
        };
        Ok(self.state.refsys.map_or(point, |m| m.point(point)))
    }

    /// A number, or a message that it is none.
    pub(crate) fn as_number(&mut self, value: Value, span: Span) -> Known<f64> {
        match value {
            Value::Number(n) => Ok(n),
            value => Err(self.wrong_kind(span, "a number", &value)),
        }
    }

    /// Says that `value` is not what is wanted.
    pub(crate) fn wrong_kind(&mut self, span: Span, wanted: &str, value: &Value) -> Poisoned {
        let found = match value {
            Value::Poison => return Poisoned,
            Value::Unset => "nothing".to_owned(),
            Value::Number(n) => format!("the number {n}"),
            Value::Logical(_) => "a logical value".to_owned(),
            Value::Form(form) => format!("a {}", form.kind().word()),
            Value::Word(word) => format!("the word {word}"),
            Value::Array(_) => "a whole array".to_owned(),
        };
        let message = format!("{wanted} is expected, but this is {found}");
        let mut error = Diagnostic::error(codes::WRONG_KIND, span, message);
        if let Value::Word(word) = value
            && word.is(aptc_vocabulary::Class::Motion)
        {
            error = error.help(format!(
                "{word} begins a statement: give it a card of its own, or put it behind a `,` as in RAPID,GOTO/.."
            ));
        }
        self.error(error);
        Poisoned
    }

    /// The place that a target names.
    pub(crate) fn target(&mut self, target: &Target) -> Known<Place> {
        let place = self.memory.place(target.name.symbol);
        let Some(subscript) = &target.subscript else {
            if let Value::Array(_) = self.memory.slot(place).value {
                return Err(self.subscript_missing(place, target.name.span));
            }
            return Ok(place);
        };
        match self.memory.slot(place).value {
            Value::Array(array) => {
                let n = self.number(subscript);
                let element = n.and_then(|n| self.element(array, n, subscript.span));
                if element.is_err() {
                    self.memory.doubt(array);
                }
                element
            }
            Value::Poison => Err(Poisoned),
            _ => Err(self.not_reserved(&target.name)),
        }
    }
}
