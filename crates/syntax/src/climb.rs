//! From a flat row of values and operators to a tree, by how closely the operators bind.

use aptc_diagnostics::Span;
use chumsky::span::SimpleSpan;

use crate::tree::{BinaryOp, Expr, ExprKind, UnaryOp};

/// A value with the signs in front of it.
pub(crate) type Operand = (Vec<(UnaryOp, SimpleSpan<u32>)>, Expr);

/// The tree of `first` and the operators and operands behind it. Recursion is bounded by
/// [`MAX_DEPTH`](crate::shape::MAX_DEPTH), which the row was checked against.
pub(crate) fn tree(first: Operand, rest: impl Iterator<Item = (BinaryOp, Operand)>) -> Expr {
    let mut row = Row { rest: rest.peekable() };
    row.expression(first, 0)
}

/// How closely an operator binds; a sign binds closer than a power, as in APT-360.
fn power(op: BinaryOp) -> u8 {
    match op {
        BinaryOp::Pow => 7,
        BinaryOp::Mul | BinaryOp::Div | BinaryOp::Cross | BinaryOp::Dot => 6,
        BinaryOp::Add | BinaryOp::Sub => 5,
        BinaryOp::Eq | BinaryOp::Ne | BinaryOp::Lt | BinaryOp::Le | BinaryOp::Gt | BinaryOp::Ge => {
            4
        }
        BinaryOp::And => 2,
        BinaryOp::Or => 1,
    }
}

/// `.NOT.` binds less than a relation: `.NOT. A .EQ. B` denies the relation.
const NOT: u8 = 3;

struct Row<I: Iterator<Item = (BinaryOp, Operand)>> {
    rest: std::iter::Peekable<I>,
}

impl<I: Iterator<Item = (BinaryOp, Operand)>> Row<I> {
    /// What begins with `first`, as far as operators bind closer than `least`.
    fn expression(&mut self, first: Operand, least: u8) -> Expr {
        let mut left = self.signed(first);
        while let Some((op, second)) = self.rest.next_if(|(op, _)| power(*op) > least) {
            // A power goes on to the right before it is taken.
            let own = if op == BinaryOp::Pow { power(op) - 1 } else { power(op) };
            let right = self.expression(second, own);
            let span = left.span.to(right.span);
            left = Expr { kind: ExprKind::Binary(op, Box::new(left), Box::new(right)), span };
        }
        left
    }

    /// A value with its signs; what a `.NOT.` stands before goes on as far as relations do.
    fn signed(&mut self, (mut signs, atom): Operand) -> Expr {
        let Some(n) = signs.iter().position(|(op, _)| *op == UnaryOp::Not) else {
            return with_signs(signs, atom);
        };
        let inner = signs.split_off(n + 1);
        let denied = self.expression((inner, atom), NOT);
        with_signs(signs, denied)
    }
}

fn with_signs(signs: Vec<(UnaryOp, SimpleSpan<u32>)>, mut value: Expr) -> Expr {
    for (op, at) in signs.into_iter().rev() {
        let span = Span::new(value.span.file, at.start, at.end).to(value.span);
        value = Expr { kind: ExprKind::Unary(op, Box::new(value)), span };
    }
    value
}
