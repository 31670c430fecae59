//! Charts of surfaces, each made once.

use std::sync::{Arc, Mutex, PoisonError};

use aptc_geometry::sculpt::fit_surface;
use aptc_geometry::{Form, Sculptured};

use crate::sheet::Sheet;

/// Surfaces that are prepared; all clones share them.
#[derive(Clone, Debug, Default)]
pub(crate) struct Sheets {
    milled: Arc<Mutex<Vec<Known<Sculptured>>>>,
    /// The same with their continuation.
    led: Arc<Mutex<Vec<Known<Sculptured>>>>,
    /// Those that guide the tool, the last [`FORMS`].
    forms: Arc<Mutex<Vec<Known<Form>>>>,
    /// The same without their continuation.
    alone: Arc<Mutex<Vec<Known<Form>>>>,
}

/// A surface with its charts.
type Known<T> = (Arc<T>, Arc<Sheet>);

/// Forms whose charts are kept: a program may define any number of them.
const FORMS: usize = 64;

impl Sheets {
    /// The surface with charts; `None` where it has none.
    pub(crate) fn of(&self, surface: &Arc<Sculptured>) -> Option<Arc<Sheet>> {
        known(&self.milled, surface, usize::MAX, Sheet::bare)
    }

    /// The surface with charts of itself and of what goes straight on beyond its borders, along which a tool end is led.
    pub(crate) fn on(&self, surface: &Arc<Sculptured>) -> Option<Arc<Sheet>> {
        known(&self.led, surface, usize::MAX, |s| Sheet::reaching(s).or_else(|| Sheet::bare(s)))
    }

    /// The charts of a form; `None` for those without.
    pub(crate) fn of_form(&self, form: &Arc<Form>) -> Option<Arc<Sheet>> {
        known(&self.forms, form, FORMS, Sheet::new)
    }

    /// The charts of a sculptured form without its continuation.
    pub(crate) fn alone(&self, form: &Arc<Form>) -> Option<Arc<Sheet>> {
        known(&self.alone, form, FORMS, |form| match form.shape() {
            Form::Ssurf(d) => Sheet::bare(&fit_surface(d).ok()?),
            _ => None,
        })
    }
}

/// The charts that are kept, or made; of more than `most` the oldest are let go.
fn known<T>(
    kept: &Mutex<Vec<Known<T>>>,
    surface: &Arc<T>,
    most: usize,
    make: impl Fn(&T) -> Option<Sheet>,
) -> Option<Arc<Sheet>> {
    let mut known = kept.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some((_, sheet)) = known.iter().find(|(s, _)| Arc::ptr_eq(s, surface)) {
        return Some(Arc::clone(sheet));
    }
    let sheet = Arc::new(make(surface)?);
    if known.len() >= most {
        known.remove(0);
    }
    known.push((Arc::clone(surface), Arc::clone(&sheet)));
    Some(sheet)
}
