//! A surface that guides a motion of the arithmetic element.

use std::sync::Arc;

use aptc_cldata::{Controlled, NameRef, Relation};
use aptc_geometry::Form;

/// INTOL and OUTTOL.
const BAND: f64 = 0.01;

pub(crate) fn controlled(name: &str, form: Form, relation: Relation, side: i8) -> Controlled {
    Controlled {
        name: NameRef { name: name.into(), subscript: 0 },
        form: Arc::new(form),
        relation,
        side,
        open: false,
        nth: 1,
        thick: 0.0,
        disk: None,
        intol: BAND,
        outtol: BAND,
    }
}
