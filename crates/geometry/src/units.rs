//! The unit of a part program.

use serde::{Deserialize, Serialize};

/// Unit of length, as UNITS gives it; inches where it is not given.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[expect(missing_docs, reason = "the names say it")]
#[serde(rename_all = "lowercase")]
pub enum Units {
    Mm,
    Cm,
    #[default]
    Inches,
    Feet,
}

impl Units {
    /// Millimetres in one unit, exactly.
    pub const fn mm(self) -> f64 {
        match self {
            Self::Mm => 1.0,
            Self::Cm => 10.0,
            Self::Inches => 25.4,
            Self::Feet => 304.8,
        }
    }

    /// The APT word.
    pub const fn word(self) -> &'static str {
        match self {
            Self::Mm => "MM",
            Self::Cm => "CM",
            Self::Inches => "INCHES",
            Self::Feet => "FEET",
        }
    }
}
