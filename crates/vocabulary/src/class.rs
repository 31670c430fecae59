//! What a word is for.

/// The kind of statement or place in a statement that a word belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Class {
    /// Defines geometry: POINT to SSURF.
    Geometry,
    /// Executed by the arithmetic element: motion, cutter, tolerances, tool axis.
    Motion,
    /// Steers translation, listing and CL editing: LOOPST, MACRO, PRINT, COPY, FINI.
    Control,
    /// A function of an expression: SINF, DISTF.
    Function,
    /// Takes the rest of its card as text: PARTNO PPRINT INSERT REMARK TITLES.
    Text,
    /// Passed to the post-processor: SPINDL, CYCLE.
    Post,
    /// Regional milling and its checks: SCON SMIL GOLOFT CHKSRF AVCTRL.
    Regional,
    /// An operator between operands: `.EQ`, `.AND`, KREUZ, DOT.
    Operator,
    /// Stands among the arguments of another word: TO, XLARGE, CLW.
    Modifier,
}
