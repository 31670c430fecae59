//! A stack of fixed size, so that a proof allocates nothing.

/// At most `N` entries.
#[derive(Debug)]
pub(crate) struct Pile<T: Copy + Default, const N: usize> {
    entries: [T; N],
    n: usize,
}

impl<T: Copy + Default, const N: usize> Pile<T, N> {
    pub(crate) fn new() -> Self {
        Self { entries: [T::default(); N], n: 0 }
    }

    /// Puts an entry on top; false when there is no room for it.
    pub(crate) fn push(&mut self, entry: T) -> bool {
        let room = self.n < N;
        if room {
            self.entries[self.n] = entry;
            self.n += 1;
        }
        room
    }

    /// Takes the top entry.
    pub(crate) fn pop(&mut self) -> Option<T> {
        self.n = self.n.checked_sub(1)?;
        Some(self.entries[self.n])
    }
}
