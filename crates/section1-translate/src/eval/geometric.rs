//! Functions of geometric forms.

use std::sync::Arc;

use aptc_diagnostics::{Diagnostic, Span, codes};
use aptc_geometry::{Form, Vec3, trig};
use aptc_syntax::tree::Expr;
use aptc_vocabulary::{Word, word};

use super::{Known, Poisoned};
use crate::Interpreter;
use crate::memory::Value;

/// Sine of the angle up to which two planes count as parallel.
const PARALLEL: f64 = 1e-9;

impl Interpreter<'_> {
    /// The value of a function of forms; `None` when `word` is no such function.
    pub(super) fn geometric(
        &mut self,
        word: Word,
        args: &[Expr],
        span: Span,
    ) -> Option<Known<Value>> {
        let n = match word {
            word::DOTF | word::ANGLF | word::ANGLB | word::DISTF | word::CANF => 2,
            word::LNTHF | word::NUMF | word::PARMF => 1,
            word::SPATF | word::CLDATF => 3,
            _ => return None,
        };
        let most = if matches!(word, word::NUMF | word::PARMF) { 2 } else { n };
        let number = self.count_arguments(word, args, (n, most), span).and_then(|()| match word {
            word::DOTF => self.vectors(args).map(|v| v[0].dot(&v[1])),
            word::SPATF => self.vectors(args).map(|v| v[0].cross(&v[1]).dot(&v[2])),
            word::LNTHF => self.vectors(args).map(|v| v[0].norm()),
            word::ANGLF => self.angle_about(args, span).map(f64::to_degrees),
            word::ANGLB => self.angle_about(args, span),
            word::DISTF => self.distance(args, span),
            word::NUMF => self.points_of(args),
            word::PARMF => self.parameter(args, span),
            word::CLDATF => self.saved_parameter(args),
            _ => self.canonical_element(args),
        });
        Some(number.map(Value::Number))
    }

    fn vectors(&mut self, args: &[Expr]) -> Known<Vec<Vec3>> {
        let vectors: Vec<_> = args.iter().map(|a| self.vector(a)).collect();
        vectors.into_iter().collect()
    }

    fn form(&mut self, expr: &Expr, wanted: &str) -> Known<Arc<Form>> {
        match self.value(expr)? {
            Value::Form(form) => self.in_system(&form, expr.span),
            value => Err(self.wrong_kind(expr.span, wanted, &value)),
        }
    }

    /// Angle of a point about a circle's centre from the x axis, 0 to 360 degrees, in radians.
    fn angle_about(&mut self, args: &[Expr], span: Span) -> Known<f64> {
        let circle = self.form(&args[0], "a circle");
        let point = self.form(&args[1], "a point");
        let (circle, point) = (circle?, point?);
        let center = match circle.shape() {
            Form::Circle(c) => c.center,
            Form::Cylinder(c) => c.point,
            _ => return Err(self.wrong_kind(args[0].span, "a circle", &Value::Form(circle))),
        };
        let Form::Point(p) = point.shape() else {
            return Err(self.wrong_kind(args[1].span, "a point", &Value::Form(point)));
        };
        let (x, y) = (p.x - center.x, p.y - center.y);
        if x == 0.0 && y == 0.0 {
            self.error(Diagnostic::error(
                codes::NO_VALUE,
                span,
                "the point is the centre of the circle and has no angle",
            ));
            return Err(Poisoned);
        }
        let angle = trig::atan2(y, x);
        Ok(if angle < 0.0 { angle + 2.0 * std::f64::consts::PI } else { angle })
    }

    /// Distance of two parallel lines or planes, of a point from one, or of two points.
    fn distance(&mut self, args: &[Expr], span: Span) -> Known<f64> {
        let wanted = "a line, a plane or a point";
        let (a, b) = (self.form(&args[0], wanted), self.form(&args[1], wanted));
        let (a, b) = (a?, b?);
        let plane = |form: &Form| match form.shape() {
            Form::Line(l) => Some(l.plane()),
            Form::Plane(p) => Some(*p),
            _ => None,
        };
        if let (Form::Point(p), Form::Point(q)) = (a.shape(), b.shape()) {
            return Ok((p - q).norm());
        }
        if let (Form::Point(p), Some(q)) = (a.shape(), plane(&b)) {
            return Ok((q.n.dot(p) - q.d).abs());
        }
        if let (Some(p), Form::Point(q)) = (plane(&a), b.shape()) {
            return Ok((p.n.dot(q) - p.d).abs());
        }
        let Some(p) = plane(&a) else {
            return Err(self.wrong_kind(args[0].span, wanted, &Value::Form(a)));
        };
        let Some(q) = plane(&b) else {
            return Err(self.wrong_kind(args[1].span, wanted, &Value::Form(b)));
        };
        let sine = p.n.cross(&q.n).norm();
        if sine > PARALLEL {
            let angle = trig::atan2(sine, p.n.dot(&q.n).abs()).to_degrees();
            self.error(Diagnostic::error(
                codes::NO_VALUE,
                span,
                format!("the two are not parallel but {angle:.6} degrees apart"),
            ));
            return Err(Poisoned);
        }
        let same = if p.n.dot(&q.n) < 0.0 { -1.0 } else { 1.0 };
        Ok((p.d - same * q.d).abs())
    }

    /// Number of points of a pattern.
    fn points_of(&mut self, args: &[Expr]) -> Known<f64> {
        let expr = &args[0];
        if let Some(count) = self.count_of_saved(args) {
            return count;
        }
        let form = self.form(expr, "a pattern")?;
        if let Some(parts) = self.parts_of(&form, args) {
            return parts;
        }
        match form.shape() {
            #[expect(clippy::cast_precision_loss, reason = "a count of points")]
            Form::Pattern(p) => Ok(p.points.len() as f64),
            _ => Err(self.wrong_kind(expr.span, "a pattern", &Value::Form(form))),
        }
    }

    /// CANF(form,n): the n-th canonical element.
    fn canonical_element(&mut self, args: &[Expr]) -> Known<f64> {
        let form = self.form(&args[0], "a geometric name");
        let n = self.number(&args[1]);
        let (form, n) = (form?, n?);
        let elements = form.canonical();
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "saturates, and is looked up"
        )]
        let found = (n >= 1.0).then(|| elements.get(n as usize - 1)).flatten();
        if let Some(element) = found {
            return Ok(*element);
        }
        self.error(Diagnostic::error(
            codes::NO_VALUE,
            args[1].span,
            format!("a {} has {} canonical elements, not {n}", form.kind().word(), elements.len()),
        ));
        Err(Poisoned)
    }
}
