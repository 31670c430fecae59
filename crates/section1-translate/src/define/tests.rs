//! Definitions against APT-360's answers and against their own meaning.

mod case;
mod generate;
mod oracle;
mod properties;
mod relations;
mod systems;

use aptc_diagnostics::Span;
use aptc_geometry::Form;
use aptc_vocabulary::{Word, find};

use super::{Arg, Context, DefineError, Value};

/// Arguments of a definition.
pub(super) fn args(values: &[Value]) -> Vec<Arg> {
    values.iter().map(|v| Arg::new(v.clone(), Span::default())).collect()
}

/// A definition without ZSURF and REFSYS.
pub(super) fn define(head: Word, values: &[Value]) -> Result<Form, DefineError> {
    super::define(head, &args(values), &Context::default())
}

/// A word of the table.
pub(super) fn w(text: &str) -> Value {
    Value::Word(find(text).expect("a word of APT"))
}

/// A number.
pub(super) fn n(x: f64) -> Value {
    Value::Number(x)
}
