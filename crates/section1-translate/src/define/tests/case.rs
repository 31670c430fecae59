//! What the relations read: arguments and result, without the solvers' own helpers.

use aptc_geometry::{Circle, Form, Plane, Quadric, Tabcyl, Transform, Vec2, Vec3};
use aptc_vocabulary::{Word, word};

use crate::define::Value;

/// Arguments and the form made of them.
pub(super) struct Case<'a> {
    pub(super) args: &'a [Value],
    pub(super) form: &'a Form,
}

/// Residuals, each a length; all must be small against the size.
pub(super) type Residuals = Vec<f64>;

impl Case<'_> {
    pub(super) fn n(&self, i: usize) -> f64 {
        match self.args[i] {
            Value::Number(n) => n,
            ref other => panic!("{other:?} is no number"),
        }
    }

    pub(super) fn is(&self, i: usize, word: Word) -> bool {
        self.args.get(i) == Some(&Value::Word(word))
    }

    fn form_at(&self, i: usize) -> &Form {
        match &self.args[i] {
            Value::Form { form, .. } => form,
            other => panic!("{other:?} is no form"),
        }
    }

    pub(super) fn p(&self, i: usize) -> Vec3 {
        match &self.args[i] {
            Value::Tuple { x, y, z } => Vec3::new(*x, *y, z.unwrap_or(0.0)),
            _ => match self.form_at(i) {
                Form::Point(p) | Form::Vector(p) => *p,
                other => panic!("{other:?} is no point"),
            },
        }
    }

    pub(super) fn pl(&self, i: usize) -> Plane {
        match self.form_at(i) {
            Form::Plane(p) => *p,
            Form::Line(l) => l.plane(),
            other => panic!("{other:?} is no plane"),
        }
    }

    pub(super) fn c(&self, i: usize) -> Circle {
        circle(self.form_at(i))
    }

    pub(super) fn k(&self, i: usize) -> Quadric {
        match self.form_at(i) {
            Form::Quadric(q) => *q,
            other => panic!("{other:?} is no conic"),
        }
    }

    pub(super) fn m(&self, i: usize) -> Transform {
        match self.form_at(i) {
            Form::Matrix(m) => *m,
            other => panic!("{other:?} is no matrix"),
        }
    }

    pub(super) fn tabcyl(&self, i: usize) -> &Tabcyl {
        match self.form_at(i) {
            Form::Tabcyl(t) => t,
            other => panic!("{other:?} is no TABCYL"),
        }
    }

    pub(super) fn points(&self, i: usize) -> &[Vec3] {
        match self.form_at(i) {
            Form::Pattern(p) => &p.points,
            other => panic!("{other:?} is no pattern"),
        }
    }

    /// The result as a point or vector.
    pub(super) fn point(&self) -> Vec3 {
        match self.form {
            Form::Point(p) | Form::Vector(p) => *p,
            other => panic!("{other:?} is no point"),
        }
    }

    /// The result as a plane.
    pub(super) fn plane(&self) -> Plane {
        match self.form {
            Form::Plane(p) => *p,
            Form::Line(l) => l.plane(),
            other => panic!("{other:?} is no plane"),
        }
    }

    /// The result as a circle.
    pub(super) fn circle(&self) -> Circle {
        circle(self.form)
    }

    /// The result as a map.
    pub(super) fn matrix(&self) -> Transform {
        match self.form {
            Form::Matrix(m) => *m,
            other => panic!("{other:?} is no matrix"),
        }
    }

    /// The points of the result.
    pub(super) fn pattern(&self) -> &[Vec3] {
        match self.form {
            Form::Pattern(p) => &p.points,
            other => panic!("{other:?} is no pattern"),
        }
    }

    /// The direction of a modifier.
    pub(super) fn toward(&self, i: usize) -> Vec3 {
        match self.args[i] {
            Value::Word(word::XLARGE | word::POSX) => Vec3::x(),
            Value::Word(word::XSMALL | word::NEGX) => -Vec3::x(),
            Value::Word(word::YLARGE | word::POSY) => Vec3::y(),
            Value::Word(word::YSMALL | word::NEGY) => -Vec3::y(),
            Value::Word(word::ZLARGE | word::POSZ) => Vec3::z(),
            Value::Word(word::ZSMALL | word::NEGZ) => -Vec3::z(),
            ref other => panic!("{other:?} is no modifier"),
        }
    }

    /// Largest length among arguments and result.
    pub(super) fn size(&self) -> f64 {
        let form = |f: &Form| match f {
            Form::Point(p) => p.amax(),
            Form::Line(l) => l.d.abs(),
            Form::Plane(p) => p.d.abs(),
            Form::Circle(c) => c.center.amax() + c.radius,
            Form::Cylinder(c) => c.point.amax() + c.radius,
            Form::Sphere(s) => s.center.amax() + s.radius,
            Form::Matrix(m) => m.shift.amax(),
            Form::Pattern(p) => p.points.iter().fold(0.0, |m, p| p.amax().max(m)),
            Form::Tabcyl(t) => t.spans.iter().fold(0.0, |m, s| s.start.amax().max(m)),
            _ => 0.0,
        };
        let arg = |(i, v): (usize, &Value)| match v {
            // Angles and slopes are no lengths.
            Value::Number(_) if i > 0 && self.is_angle(i - 1) => 0.0,
            Value::Number(n) => n.abs(),
            Value::Tuple { x, y, z } => x.abs().max(y.abs()).max(z.unwrap_or(0.0).abs()),
            Value::Form { form: f, .. } => form(f),
            _ => 0.0,
        };
        self.args.iter().enumerate().map(arg).fold(form(self.form), f64::max)
    }

    fn is_angle(&self, i: usize) -> bool {
        [word::ATANGL, word::SLOPE, word::XYROT, word::YZROT, word::ZXROT]
            .iter()
            .any(|w| self.is(i, *w))
    }
}

fn circle(form: &Form) -> Circle {
    match form {
        Form::Circle(c) => *c,
        Form::Cylinder(c) => Circle { center: c.point, axis: c.axis, radius: c.radius },
        Form::Sphere(s) => Circle { center: s.center, axis: Vec3::z(), radius: s.radius },
        other => panic!("{other:?} is no circle"),
    }
}

/// Unit vector of an angle in degrees.
pub(super) fn at(degrees: f64) -> Vec2 {
    let (s, c) = aptc_geometry::trig::sin_cos(degrees.to_radians());
    Vec2::new(c, s)
}

/// The mirror image of `p` about the straight line through `at` along the unit vector `u`.
pub(super) fn mirror(p: Vec2, at: Vec2, u: Vec2) -> Vec2 {
    let way = p - at;
    at + u * (2.0 * u.dot(&way)) - way
}
