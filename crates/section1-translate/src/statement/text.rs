//! Words that take the rest of their card: PARTNO PPRINT INSERT REMARK TITLES.

use aptc_protap::Kind;
use aptc_vocabulary::{Word, word};

use crate::Interpreter;
use crate::listing::EntryKind;

impl Interpreter<'_> {
    /// A word with plain text. REMARK says something to the reader of the source only.
    pub(super) fn text(&mut self, word: Word, text: &str) {
        match word {
            word::REMARK => {}
            word::TITLES => {
                let shifted = text.strip_prefix("RIGHT ").or_else(|| text.strip_prefix("right "));
                let right = shifted.is_some();
                let text = shifted.unwrap_or(text).into();
                self.list(EntryKind::Title { text, right });
            }
            _ => self.emit(Kind::Text { word: word.text().into(), text: text.into() }),
        }
    }
}
