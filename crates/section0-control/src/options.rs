//! What the user may choose.

/// Choices of a run.
#[derive(Clone, Debug)]
pub struct Options {
    /// How statements are read and carried out, with the limits.
    pub translate: aptc_translate::Options,
    /// Machine instead of the program's MACHIN.
    pub machine: Option<MachineChoice>,
    /// How much of the path is proved.
    pub verify: Verify,
    /// Keep the PROTAP records.
    pub keep_protap: bool,
    /// Run Section 2 and what follows; off for checking the language alone.
    pub motion: bool,
    /// Run Section 4.
    pub post: bool,
    /// Draw the plot.
    pub plot: bool,
}

/// A machine by its name or by the text of a machine file.
#[derive(Clone, Debug)]
pub enum MachineChoice {
    /// Name of a machine that aptc knows.
    Named(String),
    /// Name and text of a machine file.
    File(String, String),
}

/// How much of the path is proved.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verify {
    /// Every cut vector up to this number, a sample of as many beyond.
    UpTo(u64),
    /// Every cut vector.
    Full,
    /// A sample by count.
    Sample,
    /// Nothing.
    Off,
}

/// Cut vectors that are proved without being asked for a full proof.
pub const FULL_PROOF: u64 = 20_000;

impl Default for Options {
    fn default() -> Self {
        Self {
            translate: aptc_translate::Options::default(),
            machine: None,
            verify: Verify::UpTo(FULL_PROOF),
            keep_protap: false,
            motion: true,
            post: true,
            plot: true,
        }
    }
}
