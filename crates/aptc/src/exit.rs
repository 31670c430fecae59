//! Exit codes.

use std::process::ExitCode;

/// All is well.
pub(crate) const GOOD: ExitCode = ExitCode::SUCCESS;
/// Exit code 1: the program has errors.
pub(crate) const ERRORS: u8 = 1;
/// Exit code 2: wrong usage, or a file that cannot be read or written.
pub(crate) const FILES: u8 = 2;
/// Exit code 3: verification failed.
pub(crate) const REFUTED: u8 = 3;
