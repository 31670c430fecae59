//! What is known of the gap along a cut vector.

use aptc_geometry::Vec3;

/// Bounds of the gap between tool and surface along a cut vector, positive clear of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Bound {
    /// The gap is nowhere less.
    pub(crate) low: f64,
    /// The gap is nowhere more.
    pub(crate) high: f64,
    /// Least gap met, where a violation can be shown.
    pub(crate) least: f64,
    /// Where along the vector it was met, 0 to 1.
    pub(crate) low_at: f64,
    /// Where the greatest gap is, 0 to 1.
    pub(crate) high_at: f64,
}

/// The gap at a position, from below and from above.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Touch {
    pub(crate) low: f64,
    pub(crate) high: f64,
    /// The direction that proves it, and outside of a solid the point of the tool that has it.
    pub(crate) m: Vec3,
    pub(crate) p: Vec3,
}

/// A bound that is as near as this, of the length of tool and vector, to a gap that was met, or to one that was told before and
/// would be enough, is not made better: a tenth of what covers rounding.
pub(crate) const CLOSE: f64 = 1e-12;
