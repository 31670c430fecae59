//! From cards to statements: the significant characters of each, with their places in the file.

use std::ops::Range;

use crate::cards::{Card, Cards};
use crate::fixed::{self, FixedText};

/// The significant characters of one statement.
#[derive(Default)]
pub(crate) struct Flat {
    /// In capitals and without blanks, but quoted text as it stands.
    pub(crate) text: String,
    /// Place in the file of each byte of `text`.
    pub(crate) places: Vec<u32>,
}

impl Flat {
    fn clear(&mut self) {
        self.text.clear();
        self.places.clear();
    }

    fn push(&mut self, c: char, at: usize) {
        for i in 0..c.len_utf8() {
            self.places.push(place(at + i));
        }
        self.text.push(c);
    }
}

/// A byte of the file as it is stored; Section 0 refuses files of 4 GiB.
pub(crate) fn place(at: usize) -> u32 {
    u32::try_from(at).unwrap_or(u32::MAX)
}

/// What stands on a card or a card with its continuations.
pub(crate) struct Scanned {
    pub(crate) isn: u32,
    pub(crate) line: u32,
    /// A fixed-field word with its text; `Flat` then holds what stands in front of it.
    pub(crate) fixed: Option<FixedText>,
    /// Place of a `$` that no card follows.
    pub(crate) dangling: Option<Range<u32>>,
}

/// Iterates over the statements of a file; comment and blank cards are only counted.
pub(crate) struct Scanner<'s> {
    source: &'s str,
    cards: Cards<'s>,
    isn: u32,
    pub(crate) n_cards: u32,
}

impl<'s> Scanner<'s> {
    pub(crate) fn new(source: &'s str, free_form: bool, first_isn: u32) -> Self {
        Self { source, cards: Cards::new(source, free_form), isn: first_isn, n_cards: 0 }
    }

    /// The next statement; its characters go to `flat`.
    pub(crate) fn next(&mut self, flat: &mut Flat) -> Option<Scanned> {
        loop {
            let card = self.cards.next()?;
            self.n_cards += 1;
            let isn = self.isn;
            self.isn += 1;
            flat.clear();
            let line = card.line;
            let mut scanned = Scanned { isn, line, fixed: None, dangling: None };
            let start = fixed::start_of_text(self.source, card.text.clone());
            if let Some(start) = start {
                let text = fixed::read(self.source, start, card.text.end);
                self.characters(card.text.start..text.word.start as usize, flat);
                scanned.fixed = Some(text);
                return Some(scanned);
            }
            let mut goes_on = self.characters(card.text.clone(), flat);
            while let Some(dollar) = goes_on {
                let Some(Card { text, .. }) = self.cards.next() else {
                    scanned.dangling = Some(place(dollar)..place(dollar + 1));
                    break;
                };
                self.n_cards += 1;
                goes_on = self.characters(text, flat);
            }
            if !flat.text.is_empty() || scanned.dangling.is_some() {
                return Some(scanned);
            }
        }
    }

    /// Takes the characters of one card; gives the place of the `$` after which the next card goes on.
    fn characters(&self, card: Range<usize>, flat: &mut Flat) -> Option<usize> {
        let text = &self.source[card.clone()];
        let bytes = text.as_bytes();
        let mut i = 0;
        while let Some(&b) = bytes.get(i) {
            let at = card.start + i;
            match b {
                b' ' | b'\t' | b'\r' | 0x0b | 0x0c => {}
                b'$' => return (bytes.get(i + 1) != Some(&b'$')).then_some(at),
                b'\'' | b'"' => {
                    // Text up to the same mark on this card; a lone mark is kept for the message.
                    let length = text[i + 1..].find(char::from(b)).map_or(1, |n| n + 2);
                    for (n, c) in text[i..i + length].char_indices() {
                        flat.push(c, at + n);
                    }
                    i += length;
                    continue;
                }
                0x80.. => {
                    let c = text[i..].chars().next().unwrap_or(' ');
                    flat.push(c, at);
                    i += c.len_utf8();
                    continue;
                }
                _ => flat.push(char::from(b.to_ascii_uppercase()), at),
            }
            i += 1;
        }
        None
    }
}
