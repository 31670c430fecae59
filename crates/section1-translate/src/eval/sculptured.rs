//! PARMF and NUMF of sculptured forms: the parameters of the place found last, and counts of parts.
//!
//! APT: `PARMF`, `NUMF`. Source: APT4 SSV3.

use aptc_diagnostics::{Diagnostic, Span, codes};
use aptc_geometry::Form;
use aptc_geometry::sculpt::{Layout, Sculptured, SpaceCurve};
use aptc_syntax::tree::{Expr, ExprKind};
use aptc_vocabulary::word;

use super::{Known, Poisoned};
use crate::Interpreter;
use crate::define::Found;
use crate::memory::Value;

/// Halvings of the interval in which a parameter of a flow is looked for.
const HALVINGS: usize = 60;

impl Interpreter<'_> {
    /// `NUMF(curve|surface[,what])`; `None` for other forms.
    pub(super) fn parts_of(&mut self, form: &Form, args: &[Expr]) -> Option<Known<f64>> {
        let what = args.get(1).map(|e| (self.spelling(e), e.span));
        let what = what.as_ref().map(|(text, span)| (text.as_deref().unwrap_or(""), *span));
        let span = args[0].span;
        match form.shape() {
            Form::Scurv(c) => Some(match self.fits.curve(c) {
                Ok(c) => match what {
                    None | Some(("ARC", _)) => Ok(count(c.arcs.len())),
                    Some(("SEG", _)) => Ok(count(c.segments())),
                    Some((_, at)) => Err(self.no_part(at, "ARC or SEG")),
                },
                Err(why) => Err(self.not_fitted(span, &why.to_string())),
            }),
            Form::Ssurf(s) => Some(match self.fits.surface(s) {
                Ok(s) => match (what, &s.layout) {
                    (None | Some(("PATCH", _)), _) => Ok(count(s.patches.len())),
                    (Some(("SPLINE", _)), Layout::Mesh { .. }) => Ok(s.spans()[1] + 1.0),
                    (Some(("CRSSPL", _)), Layout::Mesh { .. }) => Ok(s.spans()[0] + 1.0),
                    (Some((_, at)), _) => {
                        Err(self.no_part(at, "PATCH, or SPLINE or CRSSPL of a mesh"))
                    }
                },
                Err(why) => Err(self.not_fitted(span, &why.to_string())),
            }),
            _ => None,
        }
    }

    /// `PARMF(UVAL|VVAL|PVAL|TVAL|SVAL)`, `PARMF(curve[,PARAM|FLOW])`, `PARMF(surface[,PATCH|UPARAM|VPARAM])`:
    /// the parameters of the place that the last POINT or VECTOR found by a plane, a point or a line.
    pub(super) fn parameter(&mut self, args: &[Expr], span: Span) -> Known<f64> {
        let Some(found) = self.state.found.clone() else {
            self.error(
                Diagnostic::error(
                    codes::NO_VALUE,
                    span,
                    "no place was found on a curve or surface yet",
                )
                .help("PARMF follows a POINT or VECTOR by INTOF with a plane, a point or a line"),
            );
            return Err(Poisoned);
        };
        let first = self.spelling(&args[0]);
        let second = args.get(1).and_then(|e| self.spelling(e));
        let value = match (&found, first.as_deref(), args.len()) {
            (Found::Surface { local, .. }, Some("UVAL"), 1) => Some(local[0]),
            (Found::Surface { local, .. }, Some("VVAL"), 1) => Some(local[1]),
            (Found::Surface { number, .. }, Some("PVAL"), 1) => Some(count(*number)),
            (Found::Curve { t, .. }, Some("TVAL"), 1) => Some(t - whole(*t)),
            (Found::Curve { t, .. }, Some("SVAL"), 1) => Some(whole(*t) + 1.0),
            _ => match (self.value(&args[0])?, &found) {
                (Value::Form(form), Found::Curve { t, curve }) if is_curve(&form) => {
                    match second.as_deref() {
                        None if args.len() == 1 => Some(*t),
                        Some("PARAM") => Some(*t),
                        Some("FLOW") => Some(flow(curve, *t)),
                        _ => None,
                    }
                }
                (Value::Form(form), Found::Surface { number, global, .. }) if is_surface(&form) => {
                    match second.as_deref() {
                        None if args.len() == 1 => Some(count(*number)),
                        Some("PATCH") => Some(count(*number)),
                        Some("UPARAM") => Some(global[0]),
                        Some("VPARAM") => Some(global[1]),
                        _ => None,
                    }
                }
                _ => None,
            },
        };
        value.ok_or_else(|| {
            let kind = if matches!(found, Found::Curve { .. }) { "a curve" } else { "a surface" };
            let message = format!("the place found last is on {kind}, which has no such parameter");
            self.error(Diagnostic::error(codes::NO_VALUE, span, message));
            Poisoned
        })
    }

    /// A word or name as written.
    fn spelling(&self, expr: &Expr) -> Option<String> {
        match &expr.kind {
            ExprKind::Name(name) => Some(self.interner.text(name.symbol).to_owned()),
            _ => None,
        }
    }

    fn no_part(&mut self, span: Span, expected: &str) -> Poisoned {
        let message = format!("{} counts {expected}", word::NUMF);
        self.error(Diagnostic::error(codes::NO_VALUE, span, message));
        Poisoned
    }

    fn not_fitted(&mut self, span: Span, why: &str) -> Poisoned {
        self.error(Diagnostic::error(codes::NO_FIT, span, format!("it cannot be fitted: {why}")));
        Poisoned
    }
}

fn is_curve(form: &Form) -> bool {
    matches!(form.shape(), Form::Scurv(_))
}

fn is_surface(form: &Form) -> bool {
    matches!(form.shape(), Form::Ssurf(_))
}

/// The parameter of the flow at `t` of the curve; the flow runs on with it.
fn flow(curve: &SpaceCurve, t: f64) -> f64 {
    let Some(flow) = &curve.flow else { return t };
    let (mut low, mut high) = (0.0, curve.flow_span());
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if flow.parameter(curve, middle).0 < t { low = middle } else { high = middle }
    }
    0.5 * (low + high)
}

/// What is found on a surface at (u, v).
pub(crate) fn found_on(s: &Sculptured, [u, v]: [f64; 2]) -> Found {
    let (number, local) = s.span_of(u, v);
    let global = if matches!(s.layout, Layout::Mesh { .. }) { [u, v] } else { local };
    Found::Surface { number, local, global }
}

fn whole(t: f64) -> f64 {
    t.max(0.0).floor()
}

#[expect(clippy::cast_precision_loss, reason = "a count of parts")]
fn count(n: usize) -> f64 {
    n as f64
}
