//! What names stand for when a program is over.

use std::collections::HashMap;
use std::sync::Arc;

use aptc_geometry::Form;
use aptc_protap::NameRef;

use super::Interpreter;
use crate::memory::Value;

/// What a name stands for at the end of a program.
#[derive(Clone, Debug, PartialEq)]
pub enum Quantity {
    /// A number.
    Scalar(f64),
    /// A geometric form, in the base system.
    Form(Arc<Form>),
}

impl Quantity {
    /// The APT word of its type; SCALAR for a number.
    pub fn word(&self) -> &'static str {
        match self {
            Self::Scalar(_) => "SCALAR",
            Self::Form(form) => form.kind().word(),
        }
    }

    /// The number, or the canonical elements.
    pub fn elements(&self) -> Vec<f64> {
        match self {
            Self::Scalar(n) => vec![*n],
            Self::Form(form) => form.canonical(),
        }
    }
}

impl Interpreter<'_> {
    /// The last value of each name, in the order in which they first got one; of several part programs
    /// in a file, all. Parameters and LOCAL names of macros are not among them.
    pub fn geometry(&self) -> Vec<(NameRef, Quantity)> {
        let mut values = self.finished.clone();
        self.add_geometry(&mut values);
        values
    }

    /// Adds the values of the present part program; a name that is there already gets the later one.
    pub(super) fn add_geometry(&self, values: &mut Vec<(NameRef, Quantity)>) {
        let mut known: HashMap<NameRef, usize> =
            values.iter().enumerate().map(|(i, (n, _))| (n.clone(), i)).collect();
        for (place, value) in self.memory.in_order() {
            let quantity = match value {
                Value::Number(n) => Quantity::Scalar(*n),
                Value::Form(form) => Quantity::Form(Arc::clone(form)),
                _ => continue,
            };
            let name = self.name_ref(place);
            if let Some(&i) = known.get(&name) {
                values[i].1 = quantity;
            } else {
                known.insert(name.clone(), values.len());
                values.push((name, quantity));
            }
        }
    }
}
