//! From cards to statements: the significant characters of each, with their places in the file.

use std::ops::Range;

use aptc_vocabulary::word;

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

    /// Do blanks or the end of a card part the characters?
    pub(crate) fn is_parted(&self, range: &Range<usize>) -> bool {
        match self.places.get(range.clone()) {
            Some([first, .., last]) => (last - first) as usize + 1 != range.len(),
            _ => false,
        }
    }

    /// The pieces of `range` between blanks and ends of cards.
    pub(crate) fn pieces(&self, range: Range<usize>) -> Vec<Range<usize>> {
        let mut pieces = vec![];
        let mut start = range.start;
        for i in range.start + 1..range.end {
            if self.places[i] != self.places[i - 1] + 1 {
                pieces.push(start..i);
                start = i;
            }
        }
        pieces.push(start..range.end);
        pieces
    }

    /// Takes in `text`, which stands at `at`.
    fn push(&mut self, text: &str, at: usize, in_capitals: bool) {
        let from = self.text.len();
        self.text.push_str(text);
        if in_capitals {
            self.text[from..].make_ascii_uppercase();
        }
        self.places.extend(place(at)..place(at + text.len()));
    }
}

/// A byte of the file as it is stored; Section 0 refuses files of 4 GiB.
pub(crate) fn place(at: usize) -> u32 {
    u32::try_from(at).unwrap_or(u32::MAX)
}

/// How the text of a card ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum End {
    /// With its last column.
    Card,
    /// With the comment that begins at this place.
    Comment(usize),
    /// With the `$` at this place, after which the next card goes on.
    GoesOn(usize),
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
    /// Cards that have a number: all but continuations.
    pub(crate) n_numbered: u32,
    /// Text behind column 72 that is not part of a comment.
    pub(crate) tails: Vec<Range<u32>>,
    /// The `%` of cards that NCL would take for comments.
    pub(crate) percents: Vec<Range<u32>>,
    /// Cards of the last statement.
    pub(crate) pieces: Vec<(Card, End)>,
}

impl<'s> Scanner<'s> {
    pub(crate) fn new(source: &'s str, free_form: bool, first_isn: u32) -> Self {
        let cards = Cards::new(source, free_form);
        Self {
            source,
            cards,
            isn: first_isn,
            n_numbered: 0,
            tails: Vec::new(),
            percents: Vec::new(),
            pieces: Vec::new(),
        }
    }

    /// The next statement; its characters go to `flat`.
    pub(crate) fn next(&mut self, flat: &mut Flat) -> Option<Scanned> {
        loop {
            let card = self.cards.next()?;
            let isn = self.isn;
            self.isn = self.isn.saturating_add(1);
            self.n_numbered += 1;
            flat.clear();
            self.pieces.clear();
            if let Some(at) = percent(&self.source[card.text.clone()]) {
                let at = place(card.text.start + at);
                self.percents.push(at..at + 1);
                continue;
            }
            let mut scanned = Scanned { isn, line: card.line, fixed: None, dangling: None };
            if let Some(start) = fixed::start_of_text(self.source, card.text.clone()) {
                let text = fixed::read(self.source, start, card.text.end);
                self.characters(card.text.start..start, flat);
                if text.word_is != word::REMARK {
                    self.note_tail(&card);
                }
                scanned.fixed = Some(text);
                self.pieces.push((card, End::Card));
                return Some(scanned);
            }
            let mut end = self.card(card, flat);
            while let End::GoesOn(dollar) = end {
                let Some(card) = self.cards.next() else {
                    scanned.dangling = Some(place(dollar)..place(dollar + 1));
                    break;
                };
                end = self.card(card, flat);
            }
            if !flat.text.is_empty() || scanned.dangling.is_some() {
                return Some(scanned);
            }
        }
    }

    fn card(&mut self, card: Card, flat: &mut Flat) -> End {
        let end = self.characters(card.text.clone(), flat);
        if end == End::Card {
            self.note_tail(&card);
        }
        self.pieces.push((card, end));
        end
    }

    fn note_tail(&mut self, card: &Card) {
        if card.end > card.text.end && !self.source[card.text.end..card.end].trim().is_empty() {
            self.tails.push(place(card.text.end)..place(card.end));
        }
    }

    /// Takes the characters of a card, plain ones a run at a time.
    fn characters(&self, card: Range<usize>, flat: &mut Flat) -> End {
        let text = &self.source[card.clone()];
        let bytes = text.as_bytes();
        let mut i = 0;
        while let Some(&b) = bytes.get(i) {
            let at = card.start + i;
            let run = bytes[i..].iter().take_while(|b| is_plain(**b)).count();
            if run > 0 {
                flat.push(&text[i..i + run], at, true);
                i += run;
                continue;
            }
            match b {
                b'$' if bytes.get(i + 1) == Some(&b'$') => return End::Comment(at),
                b'$' => return End::GoesOn(at),
                b'\'' | b'"' => {
                    // Text up to the same mark on this card; a lone mark is kept for the message.
                    let length = text[i + 1..].find(char::from(b)).map_or(1, |n| n + 2);
                    flat.push(&text[i..i + length], at, false);
                    i += length;
                }
                0x80.. => {
                    let length = text[i..].chars().next().map_or(1, char::len_utf8);
                    flat.push(&text[i..i + length], at, false);
                    i += length;
                }
                // A blank.
                _ => i += 1,
            }
        }
        End::Card
    }
}

/// Is it neither blank nor `$` nor quote, and of ASCII?
fn is_plain(byte: u8) -> bool {
    !matches!(byte, b' ' | b'\t' | b'\r' | 0x0b | 0x0c | b'$' | b'\'' | b'"' | 0x80..)
}

/// Where the `%` stands that a card begins with.
fn percent(card: &str) -> Option<usize> {
    let at = card.bytes().position(|b| !matches!(b, b' ' | b'\t'))?;
    (card.as_bytes()[at] == b'%').then_some(at)
}
