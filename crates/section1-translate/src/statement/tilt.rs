//! VTLAXS and WCORN: a wall cut by a tool that tilts along the way; Section 3 carries them out.

use aptc_protap::Kind;
use aptc_syntax::tree::Clause;
use aptc_vocabulary::{Word, word};

use super::shape::{Shape, fixed};
use crate::Interpreter;
use crate::define::Item::{self, N, Of, W};
use crate::eval::{Known, Names};

const SIDE: Item = Of(&[word::LEFT, word::RIGHT]);

/// VTLAXS: tilt, diameter, corner radius, side of the wall; and the tilt at the end.
const VTLAXS: &[Shape] = &[
    fixed(&[W(word::ON), SIDE, N, N, N, SIDE]),
    fixed(&[W(word::ON), SIDE, N, N, N, SIDE, W(word::ZSMALL)]),
    fixed(&[W(word::OFF), SIDE, N]),
];

/// WCORN: tilts before and behind the corner, height of the wall, steps.
const WCORN: &[Shape] = &[fixed(&[SIDE, N, SIDE, N, N]), fixed(&[SIDE, N, SIDE, N, N, N])];

/// The shapes of a word.
pub(super) fn shapes(word: Word) -> &'static [Shape] {
    if word == word::VTLAXS { VTLAXS } else { WCORN }
}

impl Interpreter<'_> {
    /// VTLAXS/..., WCORN/...
    pub(super) fn tilt(&mut self, word: Word, clause: &Clause) -> Known<()> {
        let args = self.args(clause, Names::Defined)?;
        self.shaped(word, shapes(word), clause, &args)?;
        let args = self.handed_on(args)?;
        self.emit(Kind::Post { word: word.text().into(), args });
        Ok(())
    }
}
