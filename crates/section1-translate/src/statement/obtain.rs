//! OBTAIN: canonical elements as scalars.

use aptc_diagnostics::{Diagnostic, Span, codes};
use aptc_syntax::tree::{BinaryOp, Clause, Expr, ExprKind, Name};

use crate::Interpreter;
use crate::eval::{Known, Poisoned};
use crate::memory::Value;

impl Interpreter<'_> {
    /// OBTAIN,TYPE/form,a,,b
    pub(super) fn obtain(&mut self, obtain: &Clause, rest: &[Clause]) {
        let [kind] = rest else {
            let _ = self.bad_obtain(obtain.span, "OBTAIN names no type");
            return;
        };
        let args = kind.args.as_deref().unwrap_or_default();
        if self.obtain_from(&kind.head, args, kind.span).is_err() {
            self.obtained_nothing(args);
        }
    }

    /// OBTAIN/TYPE,form,a,,b, which APT-360 takes as well; or OBTAIN alone.
    pub(super) fn obtain_alone(&mut self, clause: &Clause) -> Known<()> {
        if let Some([kind, args @ ..]) = clause.args.as_deref()
            && let Some(head) = Self::as_name(&kind.kind)
        {
            let span = kind.span.to(clause.span);
            let known = self.obtain_from(&head, args, span);
            if known.is_err() {
                self.obtained_nothing(args);
            }
            return known;
        }
        // OBTAIN/TYPE/form,a: the slash between the two reads as a division.
        if let Some([first, fields @ ..]) = clause.args.as_deref()
            && let Some((head, source)) = typed(first)
        {
            let args: Vec<Expr> =
                std::iter::once(source.clone()).chain(fields.iter().cloned()).collect();
            let known = self.obtain_from(&head, &args, clause.span);
            if known.is_err() {
                self.obtained_nothing(&args);
            }
            return known;
        }
        Err(self.bad_obtain(clause.span, "OBTAIN is followed by a comma and a type"))
    }

    /// The scalars that it would have defined are not missed.
    fn obtained_nothing(&mut self, args: &[Expr]) {
        for expr in args.iter().skip(1) {
            if let Some(name) = Self::as_name(&expr.kind) {
                let place = self.memory.place(name.symbol);
                if matches!(self.memory.slot(place).value, Value::Unset) {
                    self.memory.set(place, Value::Poison, name.span);
                }
            }
        }
    }

    fn obtain_from(&mut self, head: &Name, args: &[Expr], span: Span) -> Known<()> {
        let Some((source, fields)) = args.split_first() else {
            return Err(self.bad_obtain(span, "OBTAIN names no form"));
        };
        let value = self.value(source);
        let targets = self.targets(fields);
        let (value, targets) = (value?, targets?);
        let Value::Form(form) = &value else {
            return Err(self.wrong_kind(source.span, "a geometric name", &value));
        };
        let wanted = self.head_word(head);
        let found = form.kind().word();
        if wanted.is_none_or(|w| w.text() != found) {
            let text = self.interner.text(head.symbol).to_owned();
            self.error(
                Diagnostic::error(
                    codes::BAD_OBTAIN,
                    head.span,
                    format!("OBTAIN,{text} of a {found}"),
                )
                .help(format!("write OBTAIN,{found}/")),
            );
            return Err(Poisoned);
        }
        let elements = self.in_system(form, source.span)?.canonical();
        for (i, target) in targets.into_iter().enumerate() {
            let Some((place, span)) = target else { continue };
            let Some(&element) = elements.get(i) else {
                self.error(
                    Diagnostic::error(
                        codes::BAD_OBTAIN,
                        span,
                        format!("a {found} has {} canonical elements", elements.len()),
                    )
                    .help("an empty field skips an element; count the commas"),
                );
                return Err(Poisoned);
            };
            self.obtained(place, element, span)?;
        }
        Ok(())
    }

    fn obtained(&mut self, place: crate::memory::Place, element: f64, span: Span) -> Known<()> {
        if let Value::Form(old) = &self.memory.slot(place).value {
            let (name, old) = (self.spelled(place), old.kind().word());
            let given = self.memory.slot(place).given;
            self.error(
                Diagnostic::error(
                    codes::KIND_CHANGED,
                    span,
                    format!("{name} is a {old} and cannot become a number"),
                )
                .also(given, format!("it is a {old} since here"))
                .help("use another name"),
            );
            return Err(Poisoned);
        }
        self.memory.set(place, Value::Number(element), span);
        Ok(())
    }

    fn bad_obtain(&mut self, span: Span, message: &str) -> Poisoned {
        self.error(
            Diagnostic::error(codes::BAD_OBTAIN, span, message)
                .help("write OBTAIN,TYPE/form,a,b,c"),
        );
        Poisoned
    }
}

/// `TYPE/form`.
fn typed(expr: &Expr) -> Option<(Name, &Expr)> {
    match &expr.kind {
        ExprKind::Binary(BinaryOp::Div, head, form) => match &head.kind {
            ExprKind::Name(name) => Some((*name, form)),
            _ => None,
        },
        _ => None,
    }
}
