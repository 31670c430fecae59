//! Charts of surfaces, each made once.

use std::sync::{Arc, Mutex, PoisonError};

use aptc_geometry::Sculptured;

use crate::sheet::Sheet;

/// Sculptured surfaces that are prepared; all clones share them.
#[derive(Clone, Debug, Default)]
pub(crate) struct Sheets(Arc<Mutex<Vec<Known>>>);

/// A surface with its charts.
type Known = (Arc<Sculptured>, Arc<Sheet>);

impl Sheets {
    /// The surface with charts; `None` where it has none.
    pub(crate) fn of(&self, surface: &Arc<Sculptured>) -> Option<Arc<Sheet>> {
        let mut known = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some((_, sheet)) = known.iter().find(|(s, _)| Arc::ptr_eq(s, surface)) {
            return Some(Arc::clone(sheet));
        }
        let sheet = Arc::new(Sheet::bare(surface)?);
        known.push((Arc::clone(surface), Arc::clone(&sheet)));
        Some(sheet)
    }
}
