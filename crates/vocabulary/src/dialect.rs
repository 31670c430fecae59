//! The word tables in use and the codes they hold.

/// A table of words and codes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Dialect {
    /// IBM System/360 APT, the table of its translator.
    Apt360,
    /// APT4 with sculptured surfaces.
    Apt4,
    /// PostWorks, the post-processor that reads NCL's CL files.
    PostWorks,
    /// NCL. Its codes are token numbers of the NCL language; single letters and abbreviations such as
    /// GT for GOTO are words in it and in no other dialect.
    Ncl,
    /// CL files of IBM's APT. Its table is PostWorks's but for the words listed as its own.
    IbmCl,
    /// CL text of ISO 4343 and of today's CAM systems. Words without codes.
    ClText,
}

impl Dialect {
    /// All dialects, in the order of the table's columns.
    pub const ALL: [Self; 6] =
        [Self::Apt360, Self::Apt4, Self::PostWorks, Self::Ncl, Self::IbmCl, Self::ClText];

    /// The dialect's name for people.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Apt360 => "APT-360",
            Self::Apt4 => "APT4",
            Self::PostWorks => "PostWorks",
            Self::Ncl => "NCL",
            Self::IbmCl => "IBM CL",
            Self::ClText => "CL text",
        }
    }

    pub(crate) const fn column(self) -> usize {
        self as usize
    }
}

/// The number that stands for a word in the records of a dialect.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Code {
    /// A word code: the subtype of a 2000 record for a major word, an argument for a minor one.
    Word(u16),
    /// The word defines geometry; the type of its canonical form: POINT 1 .. TABCYL 50.
    Surface(u8),
    /// The word is a record of its own.
    Record {
        /// Record type: 1000, 2000, ... 14000.
        kind: u16,
        /// Record subtype.
        subtype: u8,
    },
}

impl std::fmt::Display for Code {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Word(number) => write!(f, "{number}"),
            Self::Surface(number) => write!(f, "surface type {number}"),
            Self::Record { kind, subtype } => write!(f, "{kind}:{subtype}"),
        }
    }
}
