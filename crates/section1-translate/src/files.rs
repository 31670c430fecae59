//! The way to files that a program names. Section 0 stands behind it and guards the folders.

use std::sync::Arc;

use aptc_diagnostics::{Code, codes};

/// Which statement asks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Asker {
    /// READ/2,name: statements of a part program.
    Segment,
    /// LIBRY/name: a system macro.
    Library,
    /// INCLUD/name.
    Include,
    /// READ/1,name: saved definitions of a name.
    Geometry,
}

/// A file that a program asks for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FileRequest {
    /// Which statement asks.
    pub asker: Asker,
    /// The name as written: upper case for a symbol, as quoted for a text.
    pub name: Arc<str>,
}

/// A file that was read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LoadedFile {
    /// The name to show; two requests for the same file give the same name.
    pub name: Arc<str>,
    /// Its text.
    pub text: Arc<str>,
}

/// Why a file could not be had: the message of Section 0.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FileError {
    /// The code of the message.
    pub code: Code,
    /// What is wrong, small letters, no full stop.
    pub message: String,
    /// What to do, when that is known.
    pub help: Option<String>,
}

/// Where a program's READ, LIBRY and INCLUD get their files.
pub trait Files {
    /// The file, or why not.
    ///
    /// # Errors
    /// When there is none, or it may not be read.
    fn read(&mut self, request: &FileRequest) -> Result<LoadedFile, FileError>;
}

/// No files at all.
#[derive(Clone, Copy, Debug, Default)]
pub struct NoFiles;

impl Files for NoFiles {
    fn read(&mut self, _: &FileRequest) -> Result<LoadedFile, FileError> {
        let message = "no files can be read here".to_owned();
        Err(FileError { code: codes::NOT_READ, message, help: None })
    }
}
