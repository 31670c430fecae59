//! Words of the post-processor: handed on as they stand.

use aptc_diagnostics::{Diagnostic, codes};
use aptc_protap::{self as protap, Kind};
use aptc_syntax::tree::{BinaryOp, Clause, Expr, ExprKind};
use aptc_vocabulary::{Word, word};

use crate::eval::{Arg, ArgKind, Known, Names, Poisoned};
use crate::{Interpreter, UnknownWords};

/// Words whose arguments are names of the user's own: of machines, tools, operations.
const NAMING: &[Word] = &[word::MACHIN, word::TPRINT, word::OPNAME, word::PPWORD];

impl Interpreter<'_> {
    /// A word of the table.
    pub(super) fn post(&mut self, word: Word, clause: &Clause) -> Known<()> {
        let names = if NAMING.contains(&word) { Names::Free } else { Names::Defined };
        let hyphened = self.hyphened(word, clause);
        let clause = hyphened.as_ref().unwrap_or(clause);
        self.state.arguments_of = Some(word);
        let args = self.args(clause, names);
        self.state.arguments_of = None;
        let mut args = args?;
        if word == word::MACHIN
            && let (Some(first), Some(expr)) =
                (args.first_mut(), clause.args.as_deref().and_then(<[_]>::first))
            && let ExprKind::Name(name) = &expr.kind
        {
            // The machine is called as it is written, whatever else the name may stand for.
            first.kind = ArgKind::Name(name.symbol);
        }
        let args = self.handed_on(args)?;
        self.doubt_units(&args, clause);
        self.emit(Kind::Post { word: word.text().into(), args });
        Ok(())
    }

    /// Says once that lengths are inches where feeds or speeds are metric and UNITS is not there.
    fn doubt_units(&mut self, args: &[protap::Arg], clause: &Clause) {
        const METRIC: [&str; 3] = ["MMPM", "MMPR", "SMM"];
        let metric = args.iter().find_map(|arg| match arg {
            protap::Arg::Word(w) => METRIC.into_iter().find(|m| w == m),
            _ => None,
        });
        let Some(metric) = metric.filter(|_| self.state.lacks_units && self.failed_at.is_none())
        else {
            return;
        };
        // Once is enough: it is the unit of the whole program.
        self.state.lacks_units = false;
        let message = format!("{metric}, but lengths are inches: the program has no UNITS");
        let help = "write UNITS/MM at its head, or UNITS/INCHES when this is meant";
        self.error(Diagnostic::warning(codes::UNITS_DOUBTFUL, clause.span, message).help(help));
    }

    /// MACHIN with a name that holds hyphens, `MACHIN/HAAS-VF`, which would be read as a subtraction.
    fn hyphened(&self, word: Word, clause: &Clause) -> Option<Clause> {
        fn names(expr: &Expr) -> bool {
            match &expr.kind {
                ExprKind::Name(_) | ExprKind::Number(_) => true,
                ExprKind::Binary(BinaryOp::Sub, a, b) => names(a) && names(b),
                _ => false,
            }
        }
        let first = clause.args.as_deref()?.first()?;
        if word != word::MACHIN || !matches!(first.kind, ExprKind::Binary(..)) || !names(first) {
            return None;
        }
        let text = &self.levels.last()?.unit.text;
        let written = text.get(first.span.start as usize..first.span.end as usize)?;
        let name: String = written.split_whitespace().collect();
        let mut clause = clause.clone();
        clause.args.as_mut()?.first_mut()?.kind = ExprKind::Text(name.into());
        Some(clause)
    }

    /// A word that no table has. One that is like a word of the tables is that word misspelt: without it the part
    /// would be cut without coolant, or a rapid at feed. Others may be words of an installation.
    pub(super) fn unknown_post(&mut self, text: &str, near: Option<Word>, clause: &Clause) {
        let refuse = near.is_some() || self.options.unknown_words == UnknownWords::Refuse;
        let message = format!("{text} is in no table of words");
        let mut message = if refuse {
            Diagnostic::error(codes::UNKNOWN_POST_WORD, clause.head.span, message)
        } else {
            Diagnostic::warning(codes::UNKNOWN_POST_WORD, clause.head.span, message)
                .label("handed on to the post-processor as it stands")
        };
        if let Some(near) = near {
            message = message.help(format!("did you mean {near}?"));
        }
        self.error(message);
        if refuse {
            return;
        }
        let args = self.args(clause, Names::Free).and_then(|args| self.handed_on(args));
        if let Ok(args) = args {
            self.emit(Kind::Post { word: text.into(), args });
        }
    }

    /// The arguments as records have them.
    pub(super) fn handed_on(&mut self, args: Vec<Arg>) -> Known<Vec<protap::Arg>> {
        let mut handed = Vec::with_capacity(args.len());
        for arg in args {
            handed.push(match arg.kind {
                ArgKind::Number(n) | ArgKind::Digits(n) => protap::Arg::Number(n),
                ArgKind::Word(word) => protap::Arg::Word(word.text().into()),
                ArgKind::Name(symbol) => protap::Arg::Word(self.interner.text(symbol).into()),
                ArgKind::Text(text) => protap::Arg::Text(text),
                ArgKind::Form { form, name } => protap::Arg::Form { name, form },
                ArgKind::Empty => {
                    self.error(
                        Diagnostic::error(
                            codes::BAD_ARGUMENTS,
                            arg.span,
                            "an empty field means nothing here",
                        )
                        .help("take the extra comma away"),
                    );
                    return Err(Poisoned);
                }
            });
        }
        Ok(handed)
    }
}
