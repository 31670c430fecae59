//! What an installation has beside the program: completions of the shell, manual pages.

use std::io::{self, Write as _};
use std::path::Path;
use std::process::ExitCode;

use clap::CommandFactory as _;
use clap_complete::Shell;

use crate::cli::Cli;
use crate::exit;

/// `aptc completions SHELL`: the script, to standard output.
pub(crate) fn completions(shell: Shell) -> io::Result<ExitCode> {
    // Into memory first: the generator panics where a pipe is closed.
    let mut script = Vec::new();
    clap_complete::generate(shell, &mut Cli::command(), "aptc", &mut script);
    io::stdout().lock().write_all(&script)?;
    Ok(exit::GOOD)
}

/// `aptc man -o DIR`: `aptc.1` and a page for each command, `aptc-compile.1`.
pub(crate) fn man(folder: &Path) -> io::Result<ExitCode> {
    let named = |e: io::Error| io::Error::new(e.kind(), format!("{}: {e}", folder.display()));
    std::fs::create_dir_all(folder).map_err(named)?;
    clap_mangen::generate_to(Cli::command(), folder).map_err(named)?;
    Ok(exit::GOOD)
}
