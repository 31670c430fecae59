//! Operators of numbers.

use aptc_diagnostics::{Diagnostic, Span, codes};
use aptc_geometry::trig;
use aptc_syntax::tree::BinaryOp;

use super::{Known, Poisoned};
use crate::Interpreter;

/// Does it make a number of two numbers?
pub(super) fn is_arithmetic(op: BinaryOp) -> bool {
    matches!(op, BinaryOp::Add | BinaryOp::Sub | BinaryOp::Mul | BinaryOp::Div | BinaryOp::Pow)
}

/// Does the comparison hold?
#[expect(clippy::float_cmp, reason = "the program asks for equality, and gets it")]
pub(super) fn holds(op: BinaryOp, x: f64, y: f64) -> bool {
    match op {
        BinaryOp::Eq => x == y,
        BinaryOp::Ne => x != y,
        BinaryOp::Lt => x < y,
        BinaryOp::Le => x <= y,
        BinaryOp::Gt => x > y,
        BinaryOp::Ge => x >= y,
        _ => false,
    }
}

impl Interpreter<'_> {
    /// `x op y`; the result is finite.
    #[inline]
    pub(super) fn arithmetic(
        &mut self,
        op: BinaryOp,
        x: f64,
        y: f64,
        span: Span,
        right: Span,
    ) -> Known<f64> {
        let z = match op {
            BinaryOp::Add => x + y,
            BinaryOp::Sub => x - y,
            BinaryOp::Mul => x * y,
            BinaryOp::Div => {
                if y == 0.0 {
                    self.error(
                        Diagnostic::error(codes::DIVISION_BY_ZERO, span, "division by zero")
                            .also(right, "this is zero"),
                    );
                    return Err(Poisoned);
                }
                x / y
            }
            _ => power(x, y),
        };
        // A zero has no sign in APT.
        if z.is_finite() { Ok(z + 0.0) } else { Err(self.not_finite(op, x, y, span)) }
    }

    fn not_finite(&mut self, op: BinaryOp, x: f64, y: f64, span: Span) -> Poisoned {
        let message = if op == BinaryOp::Pow && x < 0.0 {
            Diagnostic::error(
                codes::NO_VALUE,
                span,
                format!("{x} has no power {y}: a negative number has whole powers only"),
            )
        } else if op == BinaryOp::Pow && x == 0.0 {
            Diagnostic::error(codes::NO_VALUE, span, format!("zero has no power {y}"))
        } else {
            Diagnostic::error(codes::NO_VALUE, span, "the result is too large for a number")
        };
        self.error(message);
        Poisoned
    }
}

/// Squares exactly, all else by libm.
#[expect(clippy::float_cmp, reason = "the exact exponent 2 has an exact product")]
fn power(x: f64, y: f64) -> f64 {
    if y == 2.0 { x * x } else { trig::pow(x, y) }
}
