//! Names met in a run, each stored once.

use std::collections::HashMap;

/// A name: its place in the [`Interner`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Symbol(pub u32);

/// All names of a run, upper case, without blanks. Shared by the files of a run, so that a name is the
/// same symbol in all of them.
#[derive(Clone, Debug, Default)]
pub struct Interner {
    names: Vec<Box<str>>,
    places: HashMap<Box<str>, u32>,
}

impl Interner {
    /// The symbol of `name`, which must be upper case already.
    pub fn intern(&mut self, name: &str) -> Symbol {
        if let Some(&i) = self.places.get(name) {
            return Symbol(i);
        }
        let i = u32::try_from(self.names.len()).expect("fewer names than bytes of source");
        self.names.push(name.into());
        self.places.insert(name.into(), i);
        Symbol(i)
    }

    /// The symbol of `name` if it was met.
    pub fn find(&self, name: &str) -> Option<Symbol> {
        self.places.get(name).map(|&i| Symbol(i))
    }

    /// The spelling.
    pub fn text(&self, symbol: Symbol) -> &str {
        &self.names[symbol.0 as usize]
    }

    /// How many names were met.
    pub fn len(&self) -> usize {
        self.names.len()
    }

    /// Was no name met?
    pub fn is_empty(&self) -> bool {
        self.names.is_empty()
    }
}
