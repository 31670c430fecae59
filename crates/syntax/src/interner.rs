//! Names met in a run, each stored once.

use std::collections::HashMap;
use std::hash::{BuildHasherDefault, Hasher};

use aptc_vocabulary::{Word, find};

/// A name: its place in the [`Interner`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Symbol(pub u32);

/// All names of a run, upper case, without blanks. Shared by the files of a run, so that a name is the
/// same symbol in all of them.
#[derive(Clone, Debug, Default)]
pub struct Interner {
    names: Vec<Box<str>>,
    words: Vec<Option<Word>>,
    /// Names of up to eight letters, as most are, by [`packed`].
    short: HashMap<u64, u32, BuildHasherDefault<NameHasher>>,
    long: HashMap<Box<str>, u32, BuildHasherDefault<NameHasher>>,
}

impl Interner {
    /// The symbol of `name`, which must be upper case already.
    pub fn intern(&mut self, name: &str) -> Symbol {
        let short = packed(name);
        let known = match short {
            Some(key) => self.short.get(&key),
            None => self.long.get(name),
        };
        if let Some(&i) = known {
            return Symbol(i);
        }
        let i = u32::try_from(self.names.len()).expect("fewer names than bytes of source");
        self.names.push(name.into());
        self.words.push(find(name));
        match short {
            Some(key) => self.short.insert(key, i),
            None => self.long.insert(name.into(), i),
        };
        Symbol(i)
    }

    /// The symbol of `name` if it was met.
    pub fn find(&self, name: &str) -> Option<Symbol> {
        let place = match packed(name) {
            Some(key) => self.short.get(&key),
            None => self.long.get(name),
        };
        place.map(|&i| Symbol(i))
    }

    /// The spelling.
    pub fn text(&self, symbol: Symbol) -> &str {
        &self.names[symbol.0 as usize]
    }

    /// The vocabulary word of that spelling, in any dialect.
    pub fn word(&self, symbol: Symbol) -> Option<Word> {
        self.words[symbol.0 as usize]
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

/// The letters of a short name as one number; without zero bytes no two have the same.
fn packed(name: &str) -> Option<u64> {
    let bytes = name.as_bytes();
    let fits = bytes.len() <= 8 && !bytes.contains(&0);
    fits.then(|| bytes.iter().fold(0, |key, b| key << 8 | u64::from(*b)))
}

/// A hash for short names, several times quicker than the standard one, which resists chosen
/// collisions. Here nobody gains by them: the author of a part program only delays his own run, and
/// eight thousand colliding names cost well under a second.
#[derive(Clone, Copy, Default)]
struct NameHasher(u64);

const MULTIPLIER: u64 = 0x9e37_79b9_7f4a_7c15;

impl NameHasher {
    fn mix(&mut self, word: u64) {
        self.0 = (self.0.rotate_left(5) ^ word).wrapping_mul(MULTIPLIER);
    }
}

impl Hasher for NameHasher {
    fn write(&mut self, bytes: &[u8]) {
        for part in bytes.chunks(8) {
            let mut word = [0; 8];
            word[..part.len()].copy_from_slice(part);
            self.mix(u64::from_le_bytes(word));
        }
    }

    fn write_u8(&mut self, byte: u8) {
        self.mix(u64::from(byte));
    }

    fn write_u64(&mut self, word: u64) {
        self.mix(word);
    }

    fn finish(&self) -> u64 {
        // The table takes its place from the low bits and its tag from the high ones.
        self.0 ^ (self.0 >> 32)
    }
}
