//! Whether a program is written in NCL, which shares its looks with APT.

use std::collections::HashSet;

use aptc_diagnostics::{Diagnostic, Span, codes};
use aptc_syntax::Symbol;
use aptc_syntax::tree::{Body, Clause, Expr, ExprKind, Name, Program};
use aptc_vocabulary::{Word, word};

use super::synonyms::of_ncl_alone;
use super::targets::targets;

/// Words of NCL that must head statements before the whole program is taken for one of NCL. One alone may
/// be a misspelt word of APT.
const ENOUGH: usize = 2;

/// Words of NCL that a message names.
const SHOWN: usize = 4;

/// The one message about a program of NCL; `None` when it is one of APT.
pub(crate) fn foreign(program: &Program) -> Option<Diagnostic> {
    let mut own: HashSet<Symbol> = HashSet::new();
    for statement in &program.statements {
        targets(&statement.body, &mut |symbol| {
            own.insert(symbol);
        });
        if let Body::Macro { name, params } = &statement.body {
            own.insert(name.symbol);
            own.extend(params.iter().map(|p| p.name.symbol));
        }
        synonyms(&statement.body, &mut own);
    }
    let mut found: Vec<(Word, Span)> = Vec::new();
    for statement in &program.statements {
        heads(&statement.body, &mut |name| {
            let Some(word) = name.word else { return };
            let new = found.iter().all(|(w, _)| *w != word);
            if new && of_ncl_alone(word) && !own.contains(&name.symbol) {
                found.push((word, name.span));
            }
        });
    }
    if found.len() < ENOUGH {
        return None;
    }
    let shown: Vec<&str> = found.iter().take(SHOWN).map(|(w, _)| w.text()).collect();
    let more = match found.len().saturating_sub(SHOWN) {
        0 => String::new(),
        n => format!(" and {n} more"),
    };
    Some(
        Diagnostic::error(
            codes::OTHER_DIALECT,
            found[0].1,
            format!(
                "this program is written in the dialect NCL: {}{more} are its words",
                shown.join(", ")
            ),
        )
        .label("the first of them")
        .note("NCL has statements, shapes and motions of its own that APT does not have")
        .help("--dialect ncl translates what the two have in common and names the rest"),
    )
}

/// A statement or definition by a word that NCL alone has, in a program that is translated as one of NCL.
pub(crate) fn untranslated(word: Word, span: Span) -> Option<Diagnostic> {
    let message = || format!("{word} is a word of NCL for which APT has nothing");
    of_ncl_alone(word).then(|| Diagnostic::error(codes::OTHER_DIALECT, span, message()))
}

/// Does the program define or mill sculptured forms? Then it is one of APT4.
pub(crate) fn sculptured(program: &Program) -> bool {
    has(program, &[word::SSURF, word::SCURV, word::SCON, word::SMIL, word::GOLOFT])
}

/// Does one of the words head a statement or a definition of the program?
pub(crate) fn has(program: &Program, words: &[Word]) -> bool {
    let mut found = false;
    for statement in &program.statements {
        heads(&statement.body, &mut |name| found |= name.word.is_some_and(|w| words.contains(&w)));
    }
    found
}

/// Names that SYN gives a meaning.
fn synonyms(body: &Body, own: &mut HashSet<Symbol>) {
    let Body::Clauses(clauses) = body else { return };
    let Some(first) = clauses.first().filter(|c| c.head.word == Some(word::SYN)) else { return };
    for arg in first.args.iter().flatten() {
        if let ExprKind::Name(name) = &arg.kind {
            own.insert(name.symbol);
        }
    }
}

/// Names that head a statement or a definition.
fn heads(body: &Body, take: &mut impl FnMut(&Name)) {
    match body {
        Body::Clauses(clauses) => {
            for Clause { head, args, .. } in clauses {
                take(head);
                args.iter().flatten().for_each(|e| definitions(e, take));
            }
        }
        Body::Assign { value, .. } => definitions(value, take),
        Body::IfThen { then, .. } => heads(then, take),
        _ => {}
    }
}

fn definitions(expr: &Expr, take: &mut impl FnMut(&Name)) {
    if let ExprKind::Define(definition) = &expr.kind {
        take(&definition.head);
        definition.args.iter().for_each(|e| definitions(e, take));
    }
}
