//! Which names a statement may give a value.

use aptc_syntax::Symbol;
use aptc_syntax::tree::{Body, Expr, ExprKind};
use aptc_vocabulary::word;

/// Hands every name to `take` that `body` gives a value when it is executed.
pub(super) fn targets(body: &Body, take: &mut impl FnMut(Symbol)) {
    match body {
        Body::Assign { target, value } => {
            take(target.name.symbol);
            in_expr(value, take);
        }
        Body::Clauses(clauses) => {
            let head = clauses.first().and_then(|c| c.head.word);
            let names = matches!(head, Some(word::OBTAIN | word::RESERV | word::READ));
            for expr in clauses.iter().filter_map(|c| c.args.as_deref()).flatten() {
                match &expr.kind {
                    ExprKind::Name(name) if names => take(name.symbol),
                    ExprKind::Indexed(indexed) if names => take(indexed.name.symbol),
                    _ => {}
                }
                in_expr(expr, take);
            }
        }
        Body::Call { args, .. } => {
            for arg in args {
                // Where its MACRO is not there, the parameters are names of the program.
                take(arg.name.symbol);
                if let Some(value) = &arg.value {
                    if let ExprKind::Name(name) = &value.kind {
                        take(name.symbol);
                    }
                    in_expr(value, take);
                }
            }
        }
        Body::IfThen { condition, then } => {
            in_expr(condition, take);
            targets(then, take);
        }
        Body::Do { variable, .. } => take(variable.symbol),
        Body::Error { defines, within } => {
            defines.iter().chain(within).for_each(|name| take(name.symbol));
        }
        Body::If { value, .. } => in_expr(value, take),
        Body::Empty | Body::Text { .. } | Body::Macro { .. } => {}
    }
}

fn in_expr(expr: &Expr, take: &mut impl FnMut(Symbol)) {
    match &expr.kind {
        ExprKind::Define(definition) => {
            if let Some(target) = &definition.target {
                take(target.name.symbol);
            }
            definition.args.iter().for_each(|a| in_expr(a, take));
        }
        ExprKind::Assign(target, value) => {
            take(target.name.symbol);
            in_expr(value, take);
        }
        ExprKind::Indexed(indexed) => indexed.list.iter().for_each(|a| in_expr(a, take)),
        ExprKind::Tuple(args) => args.iter().for_each(|a| in_expr(a, take)),
        ExprKind::Unary(_, a) => in_expr(a, take),
        ExprKind::Binary(_, a, b) => {
            in_expr(a, take);
            in_expr(b, take);
        }
        ExprKind::Empty
        | ExprKind::Number(_)
        | ExprKind::Text(_)
        | ExprKind::Truth(_)
        | ExprKind::Name(_) => {}
    }
}
