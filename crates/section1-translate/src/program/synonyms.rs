//! SYN: new spellings of vocabulary words.

use aptc_syntax::Symbol;
use aptc_syntax::tree::{Expr, ExprKind, Name};
use aptc_vocabulary::{Class, Dialect, Word, find, from_code, word};

use crate::Language;

/// Which word a name means.
#[derive(Clone, Debug, Default)]
pub(crate) struct Synonyms {
    language: Language,
    words: Vec<Option<Word>>,
}

impl Synonyms {
    /// No synonyms yet.
    pub(crate) fn new(language: Language) -> Self {
        Self { language, words: Vec::new() }
    }

    /// The word that `name` means as a synonym or by its spelling.
    pub(crate) fn word(&self, name: &Name) -> Option<Word> {
        if let Some(Some(word)) = self.words.get(name.symbol.0 as usize) {
            return Some(*word);
        }
        let word = name.word.filter(|w| self.knows(*w))?;
        match self.language {
            Language::Ncl => Some(in_full(word)),
            Language::Apt => Some(word),
        }
    }

    /// Is it a word of the language?
    pub(crate) fn knows(&self, word: Word) -> bool {
        self.language == Language::Ncl || !of_ncl_alone(word)
    }

    /// Takes in the pairs of a SYN statement; gives back the arguments that are wrong with the reason.
    ///
    /// The first pair decides the order: new name first, unless its second is no word.
    pub(crate) fn take<'e>(&mut self, args: &'e [Expr]) -> Vec<(&'e Expr, Fault)> {
        let mut faults = Vec::new();
        let name = |e: &'e Expr| match &e.kind {
            ExprKind::Name(name) => Some(*name),
            _ => None,
        };
        let mut word_first = None;
        for pair in args.chunks(2) {
            let [first, second] = pair else {
                faults.push((&pair[0], Fault::Alone));
                continue;
            };
            let (Some(a), Some(b)) = (name(first), name(second)) else {
                let odd = if name(first).is_none() { first } else { second };
                faults.push((odd, Fault::NoName));
                continue;
            };
            let second_is_word = self.word(&b).is_some();
            let order = *word_first.get_or_insert(!second_is_word);
            let (new, old, at) = if order { (b, a, first) } else { (a, b, second) };
            match self.word(&old) {
                Some(word) => self.set(new.symbol, word),
                // When neither is a word, the usual order is taken to be meant.
                None if self.word(&new).is_none() => faults.push((second, Fault::NoWord)),
                None => faults.push((at, Fault::NoWord)),
            }
        }
        faults
    }

    fn set(&mut self, symbol: Symbol, word: Word) {
        let place = symbol.0 as usize;
        if self.words.len() <= place {
            self.words.resize(place + 1, None);
        }
        self.words[place] = Some(word);
    }
}

/// What is wrong with an argument of SYN.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Fault {
    /// The last one has no partner.
    Alone,
    /// It is no name.
    NoName,
    /// It should be a vocabulary word.
    NoWord,
}

/// The word of APT that NCL lets be shortened to `short`: GT is GOTO, which has the same code there, and SIN is SINF.
fn in_full(short: Word) -> Word {
    // TA is a modifier of regional milling, which NCL does not have.
    if !of_ncl_alone(short) && short != word::TA {
        return short;
    }
    let full = if short.is(Class::Function) {
        find(&format!("{short}F"))
    } else if let (1..=2, Some(code)) = (short.text().len(), short.code(Dialect::Ncl)) {
        [true, false].into_iter().find_map(|major| from_code(Dialect::Ncl, major, code))
    } else {
        None
    };
    let apt = |w: &Word| w.is_in(Dialect::Apt360) || w.is_in(Dialect::Apt4);
    full.filter(apt).unwrap_or(short)
}

/// Is the word known to NCL and to nobody else? INCLUD is not counted: other processors read files by it.
pub(super) fn of_ncl_alone(word: Word) -> bool {
    word != word::INCLUD
        && word.is_in(Dialect::Ncl)
        && !Dialect::ALL.iter().any(|d| *d != Dialect::Ncl && word.is_in(*d))
}
