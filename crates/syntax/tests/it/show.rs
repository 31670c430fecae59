//! Statement trees as short text: operators in front, names as spelled.

use aptc_diagnostics::FileId;
use aptc_syntax::tree::{Body, Expr, ExprKind, Name, Param, Statement, Target};
use aptc_syntax::{Interner, Options, Parsed, parse};

/// Statements of `text`, one string each, and what was parsed.
pub(crate) fn read_with(text: &str, options: &Options) -> (Vec<String>, Parsed, Interner) {
    let mut interner = Interner::default();
    let parsed = parse(FileId(0), text, &mut interner, options);
    let shown = parsed.program.statements.iter().map(|s| statement(s, &interner)).collect();
    (shown, parsed, interner)
}

/// The statements of `text`, which must give no message.
pub(crate) fn read(text: &str) -> Vec<String> {
    let (shown, parsed, _) = read_with(text, &Options::default());
    assert_eq!(parsed.diagnostics, [], "{text}");
    shown
}

/// The only statement of `text`, which must give no message.
pub(crate) fn one(text: &str) -> String {
    let mut all = read(text);
    assert_eq!(all.len(), 1, "{all:?}");
    all.remove(0)
}

pub(crate) fn statement(s: &Statement, i: &Interner) -> String {
    let label = s.label.map(|l| format!("{}) ", name(l, i))).unwrap_or_default();
    label + &body(&s.body, i)
}

fn name(n: Name, i: &Interner) -> String {
    i.text(n.symbol).to_owned()
}

fn body(body: &Body, i: &Interner) -> String {
    match body {
        Body::Empty => String::new(),
        Body::Text { word, text, .. } => format!("{word}[{text}]"),
        Body::Assign { target: t, value } => format!("{}={}", target(t, i), expr(value, i)),
        Body::Clauses(clauses) => {
            let shown = clauses.iter().map(|c| match &c.args {
                None => name(c.head, i),
                Some(args) => format!("{}/{}", name(c.head, i), list(args, i)),
            });
            shown.collect::<Vec<_>>().join(" ")
        }
        Body::Macro { name: n, params: p } => format!("{}=macro {}", name(*n, i), params(p, i)),
        Body::Call { name: n, args } => format!("call {} {}", name(*n, i), params(args, i)),
        Body::If { value, targets } => {
            let targets = targets.map(|t| name(t, i));
            format!("if {} {}", expr(value, i), targets.join(" "))
        }
        Body::IfThen { condition, then } => {
            format!("if {} then {}", expr(condition, i), self::body(then, i))
        }
        Body::Do { label, variable, first, last, step } => {
            let step = step.as_ref().map(|s| format!(" by {}", expr(s, i))).unwrap_or_default();
            let (label, variable) = (name(*label, i), name(*variable, i));
            format!("do {label} {variable}={}..{}{step}", expr(first, i), expr(last, i))
        }
        Body::Error { defines, .. } => {
            format!("error {}", defines.map(|n| name(n, i)).unwrap_or_default())
        }
    }
}

fn params(params: &[Param], i: &Interner) -> String {
    let shown = params.iter().map(|p| match &p.value {
        None => name(p.name, i),
        Some(value) => format!("{}:{}", name(p.name, i), expr(value, i)),
    });
    shown.collect::<Vec<_>>().join(" ")
}

fn target(t: &Target, i: &Interner) -> String {
    match &t.subscript {
        None => name(t.name, i),
        Some(s) => format!("{}({})", name(t.name, i), expr(s, i)),
    }
}

fn list(list: &[Expr], i: &Interner) -> String {
    list.iter().map(|e| expr(e, i)).collect::<Vec<_>>().join(",")
}

pub(crate) fn expr(e: &Expr, i: &Interner) -> String {
    match &e.kind {
        ExprKind::Empty => "_".to_owned(),
        ExprKind::Number(n) => n.to_string(),
        ExprKind::Text(t) => format!("'{t}'"),
        ExprKind::Truth(t) => t.to_string(),
        ExprKind::Name(n) => name(*n, i),
        ExprKind::Indexed(x) => format!("{}({})", name(x.name, i), list(&x.list, i)),
        ExprKind::Unary(op, a) => format!("({op:?} {})", expr(a, i)),
        ExprKind::Binary(op, a, b) => format!("({op:?} {} {})", expr(a, i), expr(b, i)),
        ExprKind::Define(d) => {
            let target = d.target.as_ref().map(|t| target(t, i) + "=").unwrap_or_default();
            let juxtaposed: String =
                d.juxtaposed.iter().map(|j| format!(" {}", expr(j, i))).collect();
            format!("{{{target}{}/{}}}{juxtaposed}", name(d.head, i), list(&d.args, i))
        }
        ExprKind::Tuple(all) => format!("<{}>", list(all, i)),
        ExprKind::Assign(t, value) => format!("[{}={}]", target(t, i), expr(value, i)),
    }
}
