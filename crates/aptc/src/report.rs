//! Messages of a run, in the form that was asked for.

use std::io::{self, BufWriter, IsTerminal as _, Write};
use std::process::ExitCode;

use aptc_control::Compiled;
use aptc_diagnostics::{Diagnostic, Severity, SourceMap};

use crate::cli::{Color, Common, MessageFormat};
use crate::{exit, render};

/// Writes all messages of a run, and a line that counts the errors.
pub(crate) fn messages(
    out: &mut dyn Write,
    compiled: &Compiled,
    common: &Common,
) -> io::Result<()> {
    write(out, &compiled.diagnostics, &compiled.sources, common)
}

/// Writes messages; `--quiet` keeps the errors alone.
pub(crate) fn write(
    out: &mut dyn Write,
    diagnostics: &[Diagnostic],
    sources: &SourceMap,
    common: &Common,
) -> io::Result<()> {
    // Pictures of source lines come a character at a time.
    let mut out = BufWriter::new(out);
    let kept: Vec<Diagnostic> = diagnostics
        .iter()
        .filter(|d| !common.quiet || d.severity == Severity::Error)
        .cloned()
        .collect();
    render::render(&mut out, &kept, sources, common.message_format, colored(common.color))?;
    let errors = kept.iter().filter(|d| d.is_error()).count();
    if errors > 0 && common.message_format == MessageFormat::Human {
        writeln!(out, "{errors} error{}", if errors == 1 { "" } else { "s" })?;
    }
    out.flush()
}

/// Says on standard error why nothing can be done; exit code 2.
pub(crate) fn complain(text: &str) -> io::Result<ExitCode> {
    writeln!(io::stderr(), "aptc: {text}")?;
    Ok(ExitCode::from(exit::FILES))
}

fn colored(color: Color) -> bool {
    match color {
        Color::Always => true,
        Color::Never => false,
        Color::Auto => {
            io::stderr().is_terminal() && std::env::var_os("NO_COLOR").is_none_or(|v| v.is_empty())
        }
    }
}
