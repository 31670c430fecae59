//! VTLAXS and WCORN: a wall cut by a tool that tilts along the way; Section 3 carries them out.

use aptc_protap::Kind;
use aptc_syntax::tree::Clause;
use aptc_vocabulary::{Word, word};

use super::shape::{Shape, fixed};
use crate::Interpreter;
use crate::define::Item::{self, Num, Of, W};
use crate::eval::{Known, Names};

const SIDE: Item = Of(&[word::LEFT, word::RIGHT]);

const ANGLE: Item = Num("the tilt");
const DIAMETER: Item = Num("the diameter of the cutter");
const CORNER: Item = Num("its corner radius");

/// VTLAXS: tilt, diameter, corner radius, side of the wall; and the tilt at the end.
const VTLAXS: &[Shape] = &[
    fixed(&[W(word::ON), SIDE, ANGLE, DIAMETER, CORNER, SIDE]),
    fixed(&[W(word::ON), SIDE, ANGLE, DIAMETER, CORNER, SIDE, W(word::ZSMALL)]),
    fixed(&[W(word::OFF), SIDE, ANGLE]),
];

/// WCORN: tilts before and behind the corner, height of the wall, steps.
const WCORN: &[Shape] = &[
    fixed(&[SIDE, BEFORE, SIDE, BEHIND, HIGH]),
    fixed(&[SIDE, BEFORE, SIDE, BEHIND, HIGH, STEPS]),
];
const BEFORE: Item = Num("the tilt before the corner");
const BEHIND: Item = Num("the tilt behind the corner");
const HIGH: Item = Num("the height of the wall");
const STEPS: Item = Num("the number of steps");

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
