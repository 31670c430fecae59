//! The forms of CL data.

/// Who writes CL data so.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Dialect {
    /// ISO 4343 text and what has no mark of its own: our `.cl`, classic APT.
    #[default]
    Iso,
    /// CATIA V5 aptsource.
    Catia,
    /// Siemens NX CLSF.
    Nx,
    /// Creo (Pro/ENGINEER) `.ncl`.
    Creo,
    /// CAMWorks and SolidWorks CAM.
    Camworks,
    /// DMG MORI's APT form: keyword couplets.
    Dmg,
    /// Fusion, HSMWorks and Inventor CAM: their common APT form.
    Fusion,
    /// NCL, PostWorks `.as`.
    Ncl,
    /// One JSON object a line.
    Json,
    /// Binary records of APT-360 and APT-III.
    Tape,
    /// Binary records in the layout of ISO 3592, as CATIA's clfile has them.
    Clfile,
}

impl Dialect {
    /// All of them.
    pub const ALL: [Self; 11] = [
        Self::Iso,
        Self::Catia,
        Self::Nx,
        Self::Creo,
        Self::Camworks,
        Self::Dmg,
        Self::Fusion,
        Self::Ncl,
        Self::Json,
        Self::Tape,
        Self::Clfile,
    ];

    /// The name that options use.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Iso => "iso",
            Self::Catia => "catia",
            Self::Nx => "nx",
            Self::Creo => "creo",
            Self::Camworks => "camworks",
            Self::Dmg => "dmg",
            Self::Fusion => "fusion",
            Self::Ncl => "ncl",
            Self::Json => "json",
            Self::Tape => "cltape",
            Self::Clfile => "clfile",
        }
    }

    /// The dialect of that name.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|d| d.name().eq_ignore_ascii_case(name))
    }

    /// Is it text, one statement a line?
    pub const fn is_text(self) -> bool {
        !matches!(self, Self::Json | Self::Tape | Self::Clfile)
    }
}
