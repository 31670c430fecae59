//! What the program prints: PRINT, PRINT/ON, TITLES, and what the translator tells beside.

use aptc_diagnostics::Origin;
use aptc_protap::NameRef;

/// One entry of the listing, in order of execution.
#[derive(Clone, Debug, PartialEq)]
pub struct Entry {
    /// The statement that printed it.
    pub origin: Origin,
    /// What is printed.
    pub kind: EntryKind,
}

/// What an entry prints.
#[derive(Clone, Debug, PartialEq)]
pub enum EntryKind {
    /// PRINT/0: a new page.
    Page,
    /// TITLES: a line of text; `right` shifts it to the right half of the page.
    Title {
        /// The text.
        text: Box<str>,
        /// Was RIGHT given?
        right: bool,
    },
    /// A scalar.
    Scalar {
        /// Its name; `None` for a bare number and for PRINT/2, which gives no names.
        name: Option<NameRef>,
        /// Its value.
        value: f64,
    },
    /// A geometric form: type and canonical elements.
    Form {
        /// Its name; empty for an unnamed nested definition, `None` for PRINT/2.
        name: Option<NameRef>,
        /// The APT word of its type.
        word: &'static str,
        /// Its canonical elements.
        elements: Vec<f64>,
    },
    /// A card of what PUNCH saves.
    Saved(String),
    /// Numbers bit by bit, as PRINT/1 wants them.
    Bits {
        /// Its name.
        name: NameRef,
        /// The APT word of its type, SCALAR for a number.
        word: &'static str,
        /// The elements.
        elements: Vec<f64>,
    },
    /// PRINT of a name without a value.
    Undefined {
        /// The name.
        name: NameRef,
    },
    /// Said by the translator itself: the unit taken, words without effect.
    Remark(String),
}
