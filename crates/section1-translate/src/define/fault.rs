//! Why a definition fails, as data; the words are in [`super::message`].

use aptc_geometry::{NotCarried, Plane, Vec3};
use aptc_vocabulary::Word;

use super::mismatch::Mismatch;

/// Why a definition gives no form. Places are indices of arguments.
#[derive(Clone, Debug, PartialEq)]
pub enum DefineError {
    /// The head defines nothing.
    NoWord {
        /// The head.
        head: Word,
    },
    /// No format of the word reads these arguments.
    NoSuchFormat {
        /// The major word.
        head: Word,
        /// The argument at fault; one past the last when something is missing there.
        at: usize,
        /// What is amiss there.
        mismatch: Mismatch,
        /// The formats that come nearest.
        candidates: Vec<String>,
    },
    /// The format is right and there is nothing, or no one thing, that satisfies it.
    NoForm {
        /// The major word.
        head: Word,
        /// Why.
        fault: Box<Fault>,
    },
    /// An argument (or, with `None`, the result) cannot be carried between the base system and that of
    /// REFSYS.
    NotCarried {
        /// The argument.
        at: Option<usize>,
        /// Why.
        why: NotCarried,
    },
    /// REFSYS flattens space.
    FlatSystem,
}

/// Why a matched format has no solution.
#[derive(Clone, Debug, PartialEq)]
#[expect(missing_docs, reason = "places and figures that the message below puts into words")]
pub enum Fault {
    /// A format table and its solver disagree: our mistake, kept from being a crash.
    Kind { at: usize },
    /// A number that is infinite or none.
    NotFinite { at: usize },
    /// Lines or planes that do not meet.
    Parallel { a: usize, b: usize, one: Plane, other: Plane },
    /// Three planes that all contain one direction.
    OneDirection { planes: [usize; 3], along: Vec3 },
    /// Curves that miss each other.
    Apart { a: usize, b: usize, gap: f64 },
    /// A line through a point, along a vector or to another point, that misses a surface.
    LineMisses { p: usize, to: usize, on: usize },
    /// Two curves that no circle of the radius touches at once.
    OutOfReach { a: usize, b: usize, gap: f64 },
    /// Points, centres or curves that fall together.
    Coincide { a: usize, b: usize },
    /// Points on one straight line, or in one plane, or on one conic too many.
    Dependent { places: Vec<usize>, what: &'static str },
    /// A point that lies where it must not, by this much.
    Misplaced { at: usize, by: usize, what: &'static str, amount: f64 },
    /// A vector without length.
    NoLength { at: usize },
    /// Two directions along each other.
    Aligned { a: usize, b: usize, what: &'static str },
    /// A number out of its range.
    Range { at: usize, value: f64, need: &'static str },
    /// A plane that is not vertical where a line is wanted, or a leaning cylinder for a circle.
    Leans { at: usize, normal: Vec3 },
    /// Both solutions are alike for the modifier.
    Undecided { at: usize, one: Vec3, other: Vec3 },
    /// The normal has no component along the modifier's axis.
    NoSide { at: usize, normal: Vec3 },
    /// Nothing on the side that the modifiers name.
    NothingThere { at: usize, what: String },
    /// A map that flattens space.
    Flat { at: usize },
    /// A map that does not keep angles, where one is needed.
    Skew { at: usize },
    /// Nothing of the curve does what is asked of it from the point.
    NoFoot { p: usize, at: usize, what: &'static str },
    /// Planes or vectors that should stand at right angles.
    NotSquare { a: usize, b: usize, degrees: f64 },
    /// A pattern has no such point.
    NoSuchPoint { at: usize, value: f64, n: usize },
    /// More points than the limit.
    TooMany { at: usize, limit: usize },
    /// Fewer points, increments or elements than needed.
    TooFew { at: usize, need: usize, found: usize, what: &'static str },
    /// More points and tangents than a conic can meet.
    TooManyConditions { at: usize, need: usize, found: usize },
    /// A spline of a mesh with another number of points than the first.
    OtherCount { at: usize, need: usize, found: usize },
    /// Definitions within definitions beyond the limit.
    TooDeep { limit: usize },
    /// A sculptured form that cannot be fitted.
    NotFitted { at: usize, why: String },
    /// A surface without that patch, a curve without that arc or segment.
    NoSuchPart { at: usize, value: f64, n: usize, whole: &'static str },
    /// A vector that the curve or surface does not have here.
    NoVector { at: usize },
    /// Something else than what a list may hold.
    Unexpected { at: usize, expected: &'static str },
    /// A quadric without a curve or surface.
    NoCurve { what: &'static str },
    /// An iteration that did not come to its end.
    NotConverged { at: usize, turn_deg: f64, residual: f64 },
    /// A TABCYL whose points ask for a curve that is no function of its chord.
    Overhang { at: usize, degrees: f64 },
    /// Elements of CANON.
    Elements { at: usize, need: usize, found: usize },
    /// The reference of CANON has another kind.
    OtherKind { found: &'static str },
    /// A normal or axis of no length among canonical elements.
    NoNormal { at: usize },
}

impl DefineError {
    pub(super) fn from_fault(head: Word, fault: Fault) -> Self {
        Self::NoForm { head, fault: Box::new(fault) }
    }

    pub(super) fn no_word(head: Word) -> Self {
        Self::NoWord { head }
    }

    pub(super) fn flat_system() -> Self {
        Self::FlatSystem
    }

    pub(super) fn not_carried(at: usize, why: NotCarried) -> Self {
        Self::NotCarried { at: Some(at), why }
    }

    pub(super) fn result_not_carried(why: NotCarried) -> Self {
        Self::NotCarried { at: None, why }
    }
}
