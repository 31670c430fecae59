//! A stack of fixed size, so that a proof allocates nothing.

use arrayvec::ArrayVec;

/// At most `N` entries.
#[derive(Debug)]
pub(crate) struct Pile<T, const N: usize>(ArrayVec<T, N>);

impl<T, const N: usize> Pile<T, N> {
    #[inline]
    pub(crate) fn new() -> Self {
        Self(ArrayVec::new())
    }

    /// Puts an entry on top; false when there is no room for it.
    #[inline]
    pub(crate) fn push(&mut self, entry: T) -> bool {
        self.0.try_push(entry).is_ok()
    }

    /// Takes the top entry.
    #[inline]
    pub(crate) fn pop(&mut self) -> Option<T> {
        self.0.pop()
    }
}
