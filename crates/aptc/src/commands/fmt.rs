//! `aptc fmt`.

use std::io::{self, Write as _};
use std::process::ExitCode;

use aptc_control::{FormatOptions, format};

use crate::cli::FmtArgs;
use crate::input::part_program;
use crate::output::write_aside;
use crate::{exit, report};

/// Puts part programs into one style. With `--check` and `--diff` nothing is written, and the exit code is 1
/// when a file would change.
pub(crate) fn fmt(args: &FmtArgs) -> io::Result<ExitCode> {
    let options =
        FormatOptions { free_form: args.free_form, keep_identification: args.keep_columns };
    let mut worst = 0;
    for part in &args.parts {
        let source = match part_program(part, 256 << 20) {
            Ok(s) => s,
            Err(e) => {
                report::complain(&e)?;
                worst = exit::FILES;
                continue;
            }
        };
        let formatted = format(&source.text, &options);
        if formatted == *source.text {
            continue;
        }
        if args.check || args.diff {
            worst = worst.max(exit::ERRORS);
            let mut out = io::stdout().lock();
            if args.diff {
                difference(&mut out, &source.name, &source.text, &formatted)?;
            } else {
                writeln!(out, "would change {}", source.name)?;
            }
        } else if let Err(e) = write_aside(part, |out| out.write_all(formatted.as_bytes())) {
            report::complain(&format!("cannot write {}: {e}", part.display()))?;
            worst = exit::FILES;
        }
    }
    Ok(ExitCode::from(worst))
}

/// The lines that change: the formatter keeps their number, so they can be shown side by side.
fn difference(out: &mut impl io::Write, name: &str, old: &str, new: &str) -> io::Result<()> {
    writeln!(out, "--- {name}\n+++ {name}")?;
    let (mut old, mut new) = (old.lines(), new.lines());
    for line in 1_u32.. {
        match (old.next(), new.next()) {
            (None, None) => break,
            (a, b) if a == b => {}
            (a, b) => {
                writeln!(out, "@@ line {line} @@")?;
                for (sign, text) in [('-', a), ('+', b)] {
                    if let Some(text) = text {
                        writeln!(out, "{sign}{text}")?;
                    }
                }
            }
        }
    }
    Ok(())
}
