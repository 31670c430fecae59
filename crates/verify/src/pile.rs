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

    /// Takes the entry with the greatest key, the first of equal ones.
    pub(crate) fn pop_greatest(&mut self, key: impl Fn(&T) -> f64) -> Option<T> {
        let greater = |best: usize, i: usize| {
            if key(&self.0[i]).total_cmp(&key(&self.0[best])).is_gt() { i } else { best }
        };
        let greatest = (0..self.0.len()).reduce(greater)?;
        self.0.swap_pop(greatest)
    }

    /// Takes all.
    pub(crate) fn clear(&mut self) {
        self.0.clear();
    }

    /// Takes the top entry.
    #[inline]
    pub(crate) fn pop(&mut self) -> Option<T> {
        self.0.pop()
    }
}
