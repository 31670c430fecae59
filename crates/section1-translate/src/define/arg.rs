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
                        e => format!("{kind} ({})", list(&e)),
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
