//! Lists on their way: elements wait on a shelf that is used again and again, until the list is complete
//! and takes one allocation of just its size.

use std::cell::RefCell;

use crate::climb::Operand;
use crate::tree::{BinaryOp, Clause, Expr, Param};

/// A shelf for each kind of list.
#[derive(Default)]
pub(crate) struct Shelves {
    pub(crate) exprs: Shelf<Expr>,
    pub(crate) clauses: Shelf<Clause>,
    pub(crate) params: Shelf<Param>,
    pub(crate) operands: Shelf<(BinaryOp, Operand)>,
}

impl Shelves {
    /// Throws away what readings that failed have left.
    pub(crate) fn clear(&self) {
        self.exprs.0.borrow_mut().clear();
        self.clauses.0.borrow_mut().clear();
        self.params.0.borrow_mut().clear();
        self.operands.0.borrow_mut().clear();
    }
}

/// Elements of the lists that are being read, the inner lists above the outer ones.
pub(crate) struct Shelf<T>(RefCell<Vec<T>>);

impl<T> Default for Shelf<T> {
    fn default() -> Self {
        Self(RefCell::new(Vec::new()))
    }
}

/// One list on a shelf. A reading that fails may leave elements above it, which the next `put` drops.
#[derive(Clone, Copy)]
pub(crate) struct Pile {
    start: usize,
    end: usize,
}

impl Pile {
    pub(crate) fn is_empty(self) -> bool {
        self.start == self.end
    }
}

impl<T> Shelf<T> {
    /// A list without elements.
    pub(crate) fn pile(&self) -> Pile {
        let start = self.0.borrow().len();
        Pile { start, end: start }
    }

    /// The list with one element more.
    pub(crate) fn put(&self, pile: Pile, element: T) -> Pile {
        let mut shelf = self.0.borrow_mut();
        shelf.truncate(pile.end);
        shelf.push(element);
        Pile { end: shelf.len(), ..pile }
    }

    /// The complete list.
    pub(crate) fn take(&self, pile: Pile) -> Box<[T]> {
        self.with(pile, |elements| elements.collect())
    }

    /// What `work` makes of the elements.
    pub(crate) fn with<R>(&self, pile: Pile, work: impl FnOnce(std::vec::Drain<'_, T>) -> R) -> R {
        let mut shelf = self.0.borrow_mut();
        shelf.truncate(pile.end);
        work(shelf.drain(pile.start.min(pile.end)..))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_a_failed_reading_leaves_is_dropped() {
        let shelf = Shelf::default();
        let outer = shelf.put(shelf.pile(), 1);
        let failed = shelf.put(shelf.put(shelf.pile(), 7), 8);
        assert!(!failed.is_empty());
        let outer = shelf.put(outer, 2);
        let inner = shelf.put(shelf.pile(), 3);
        assert_eq!(*shelf.take(inner), [3]);
        assert_eq!(*shelf.take(shelf.put(outer, 4)), [1, 2, 4]);
    }
}
