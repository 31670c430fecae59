//! Surfaces prepared for evaluation, kept from one motion to the next.

use std::cell::RefCell;
use std::collections::VecDeque;

use aptc_geometry::{Form, Surface};

/// Surfaces kept: more than a program cuts along in turn.
const KEPT: usize = 32;

/// The surfaces that were used last and whose preparation takes time.
#[derive(Clone, Debug, Default)]
pub(crate) struct Fitted {
    last: RefCell<VecDeque<(Form, Option<Surface>)>>,
}

impl Fitted {
    /// The surface that a form stands for; see [`Surface::from_form`].
    pub(crate) fn of(&self, form: &Form) -> Option<Surface> {
        if !matches!(
            form.shape(),
            Form::Ssurf(_) | Form::Ruled(_) | Form::Polyconic(_) | Form::Tabcyl(_)
        ) {
            return Surface::from_form(form);
        }
        let mut last = self.last.borrow_mut();
        if let Some(at) = last.iter().position(|(f, _)| same(f, form)) {
            // The one used stands in front.
            last.make_contiguous()[..=at].rotate_right(1);
            return last.front().and_then(|(_, s)| s.clone());
        }
        let surface = Surface::from_form(form);
        last.truncate(KEPT - 1);
        last.push_front((form.clone(), surface.clone()));
        surface
    }
}

fn same(a: &Form, b: &Form) -> bool {
    match (a, b) {
        (Form::Ssurf(a), Form::Ssurf(b)) if std::sync::Arc::ptr_eq(a, b) => true,
        _ => a == b,
    }
}
