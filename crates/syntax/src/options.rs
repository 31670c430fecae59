//! What a caller may set, and what he gets.

use aptc_diagnostics::Diagnostic;

use crate::tree::Program;

/// How a file is read.
#[derive(Clone, Debug)]
pub struct Options {
    /// Lines of any length are statement text; without it only columns 1 to 72 are.
    pub free_form: bool,
    /// Cards that begin with `%` are comments, as in the dialect NCL; without it they are told.
    pub percent_comments: bool,
    /// Statement number of the first card.
    pub first_isn: u32,
    /// Brackets within each other.
    pub max_bracket_depth: usize,
    /// Words, numbers and signs in a statement; APT-360 stopped at about 600.
    pub max_elements: usize,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            free_form: false,
            percent_comments: false,
            first_isn: 1,
            max_bracket_depth: 64,
            max_elements: 100_000,
        }
    }
}

/// What came of a file.
#[derive(Clone, Debug, Default)]
pub struct Parsed {
    /// The statements, those in error included.
    pub program: Program,
    /// Messages in order of their places.
    pub diagnostics: Vec<Diagnostic>,
}
