//! What a caller may set.

/// The language of the source text.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Language {
    /// APT-360 and APT4, with the words of post-processors and CL texts.
    #[default]
    Apt,
    /// Words of NCL too; its statements are accepted where they are those of APT.
    Ncl,
}

/// What to do with a post-processor word that no table has.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum UnknownWords {
    /// Pass it on with a warning.
    #[default]
    Warn,
    /// Refuse it.
    Refuse,
}

/// How a part program is translated.
#[derive(Clone, Debug, Default)]
pub struct Options {
    /// The language.
    pub language: Language,
    /// Post-processor words that no table has.
    pub unknown_words: UnknownWords,
    /// Columns beyond 72 are text too.
    pub free_form: bool,
    /// Warn of names that are defined and never used.
    pub unused: bool,
    /// Bounds on what a program may ask for.
    pub limits: Limits,
}

/// Bounds on what a program may ask for. Each is reached with a diagnostic, never in silence.
#[derive(Clone, Debug)]
pub struct Limits {
    /// Macro calls within each other; APT-360 allowed 5.
    pub macro_depth: usize,
    /// Files read by files read by files.
    pub include_depth: usize,
    /// Statements executed; what ends a loop that never ends by itself.
    pub statements: u64,
    /// Statements executed after the first error, to find more: what the error left undone may have been the
    /// end of a loop.
    pub after_error: u64,
    /// Elements of all arrays together.
    pub array_elements: usize,
    /// Points of a PATERN or a TABCYL.
    pub points: usize,
    /// Lines of PRINT output.
    pub printed: usize,
    /// Messages; further ones are counted only.
    pub messages: usize,
    /// Brackets within each other.
    pub bracket_depth: usize,
    /// Words, numbers and signs in a statement.
    pub elements: usize,
}

impl Default for Limits {
    fn default() -> Self {
        let syntax = aptc_syntax::Options::default();
        Self {
            macro_depth: 64,
            include_depth: 16,
            statements: 20_000_000,
            after_error: 50_000,
            array_elements: 4_000_000,
            points: 100_000,
            printed: 1_000_000,
            messages: 1_000,
            bracket_depth: syntax.max_bracket_depth,
            elements: syntax.max_elements,
        }
    }
}
