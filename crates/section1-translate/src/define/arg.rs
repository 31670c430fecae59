//! A resolved argument of a definition.

use std::sync::Arc;

use aptc_diagnostics::Span;
use aptc_geometry::{Form, NotCarried, Transform, Vec3};
use aptc_protap::NameRef;
use aptc_vocabulary::Word;

/// An argument with its place in the text.
#[derive(Clone, Debug, PartialEq)]
pub struct Arg {
    /// Its value.
    pub value: Value,
    /// Where it stands.
    pub span: Span,
}

/// What an argument is once names are looked up and expressions computed.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    /// A number.
    Number(f64),
    /// A vocabulary word.
    Word(Word),
    /// A geometric symbol or a nested definition.
    Form {
        /// Its form, in the base system.
        form: Arc<Form>,
        /// Its name; empty for an unnamed nested definition.
        name: NameRef,
    },
    /// `(x,y)` or `(x,y,z)`: an unnamed point, in the system of the definition.
    Tuple {
        /// First coordinate.
        x: f64,
        /// Second coordinate.
        y: f64,
        /// Third coordinate; from ZSURF when left out.
        z: Option<f64>,
    },
    /// Quoted text.
    Text(Box<str>),
    /// An empty field.
    Empty,
}

impl Arg {
    /// An argument at `span`.
    pub fn new(value: Value, span: Span) -> Self {
        Self { value, span }
    }

    /// The geometric form in its normal shape, when it is one.
    pub(super) fn form(&self) -> Option<&Form> {
        match &self.value {
            Value::Form { form, .. } => Some(form.shape()),
            _ => None,
        }
    }

    /// The word, when it is one.
    pub(super) fn word(&self) -> Option<Word> {
        match self.value {
            Value::Word(word) => Some(word),
            _ => None,
        }
    }

    /// Carries a form from one system to another; anything else stays.
    pub(super) fn carry(&mut self, m: &Transform) -> Result<(), NotCarried> {
        if let Value::Form { form, .. } = &mut self.value {
            *form = Arc::new(form.transformed(m)?);
        }
        Ok(())
    }

    /// In words: `line L1`, `number 3`, `TANTO`.
    pub(super) fn describe(&self) -> String {
        match &self.value {
            Value::Number(n) => format!("number {n}"),
            Value::Word(word) => word.text().to_owned(),
            Value::Form { form, name } => {
                let kind = form.kind().word();
                match (name.name.as_str(), name.subscript) {
                    ("", _) => match form.canonical() {
                        e if e.len() > 12 => format!("this {kind}"),
                        _ => format!("{kind} ({})", in_words(form)),
                    },
                    (symbol, 0) => format!("{kind} {symbol}"),
                    (symbol, i) => format!("{kind} {symbol}({i})"),
                }
            }
            Value::Tuple { x, y, z: None } => format!("point ({x},{y})"),
            Value::Tuple { x, y, z: Some(z) } => format!("point ({x},{y},{z})"),
            Value::Text(_) => "text".to_owned(),
            Value::Empty => "an empty field".to_owned(),
        }
    }

    /// The same in one word, for the list of what was found: `line`, `number`, `TANTO`.
    pub(super) fn class(&self) -> &'static str {
        match &self.value {
            Value::Number(_) => "number",
            Value::Word(word) => word.text(),
            Value::Form { form, .. } => form.kind().noun(),
            Value::Tuple { .. } => "point",
            Value::Text(_) => "text",
            Value::Empty => "empty",
        }
    }
}

/// Numbers as short as six figures allow.
pub(super) fn list(numbers: &[f64]) -> String {
    numbers.iter().map(|x| short(*x)).collect::<Vec<_>>().join(",")
}

/// A form as a drawing has it: `y = 50`, `centre 100,60, radius 25`; others by their canonical elements.
pub(super) fn in_words(form: &Form) -> String {
    let place = |p: Vec3| list(&[p.x, p.y, p.z]);
    match form {
        Form::Line(l) => equation([l.a, l.b, 0.0], l.d),
        Form::Plane(p) => equation([p.n.x, p.n.y, p.n.z], p.d),
        Form::Circle(c) if c.axis == Vec3::z() => {
            format!("centre {}, radius {}", list(&[c.center.x, c.center.y]), short(c.radius))
        }
        Form::Sphere(s) => format!("centre {}, radius {}", place(s.center), short(s.radius)),
        Form::Cylinder(c) => {
            format!(
                "through {} along {}, radius {}",
                place(c.point),
                place(c.axis),
                short(c.radius)
            )
        }
        form => {
            let e = form.canonical();
            list(&e[..e.len().min(12)])
        }
    }
}

/// `0.6x - 0.8y = 12`, the first number positive.
fn equation(normal: [f64; 3], d: f64) -> String {
    /// Less of a unit normal is rounding.
    const NONE: f64 = 1e-12;
    let terms = normal.into_iter().zip(['x', 'y', 'z']).filter(|(k, _)| k.abs() > NONE);
    let mut sense = 0.0;
    let mut text = String::new();
    for (k, axis) in terms {
        let first = sense == 0.0;
        if first {
            sense = k.signum();
        }
        let k = k * sense;
        text += match (first, k < 0.0) {
            (true, _) => "",
            (false, true) => " - ",
            (false, false) => " + ",
        };
        let size = short(k.abs());
        if size != "1" {
            text += &size;
        }
        text.push(axis);
    }
    format!("{text} = {}", short(d * sense))
}

/// A number as short as six figures allow.
pub(crate) fn short(x: f64) -> String {
    let rounded: f64 = format!("{x:.5e}").parse().unwrap_or(x);
    // A zero with a sign tells the user nothing.
    let rounded = rounded + 0.0;
    let tiny = rounded.abs() < 1e-4 && rounded != 0.0;
    if tiny { format!("{rounded:e}") } else { rounded.to_string() }
}

impl From<f64> for Value {
    fn from(n: f64) -> Self {
        Self::Number(n)
    }
}

impl From<Word> for Value {
    fn from(word: Word) -> Self {
        Self::Word(word)
    }
}

impl From<Form> for Value {
    fn from(form: Form) -> Self {
        Self::Form { form: Arc::new(form), name: NameRef::default() }
    }
}

impl From<Vec3> for Value {
    fn from(p: Vec3) -> Self {
        Self::Tuple { x: p.x, y: p.y, z: Some(p.z) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use aptc_geometry::{Circle, Line, Plane};

    #[test]
    fn forms_are_told_as_a_drawing_has_them() {
        let line = |a, b, d| in_words(&Form::Line(Line { a, b, d }));
        assert_eq!(line(0.0, -1.0, -50.0), "y = 50");
        assert_eq!(line(-0.6, 0.8, 12.0), "0.6x - 0.8y = -12");
        let plane = Form::Plane(Plane { n: Vec3::new(0.0, 0.6, 0.8), d: -0.0 });
        assert_eq!(in_words(&plane), "0.6y + 0.8z = 0");
        let (center, axis) = (Vec3::new(100.0, 60.0, 0.0), Vec3::z());
        let circle = Form::Circle(Circle { center, axis, radius: 25.0 });
        assert_eq!(in_words(&circle), "centre 100,60, radius 25");
        assert_eq!(in_words(&Form::Point(axis)), "0,0,1");
    }
}
