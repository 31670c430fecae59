//! `aptc post`.

use std::io::{self, Write as _};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use aptc_control::Disk;

use super::compile::machine_choice;
use crate::cli::{Common, PostArgs};
use crate::output::write_whole;
use crate::{exit, report};

/// Largest CL file that is read.
const MOST_BYTES: u64 = 4 << 30;

/// Posts a CL file. The machine code is written whole or, where the post refused, not at all.
pub(crate) fn post(args: &PostArgs, common: &Common) -> io::Result<ExitCode> {
    let machine = match machine_choice(args.machine.as_deref(), MOST_BYTES) {
        Ok(m) => m,
        Err(e) => return report::complain(&e),
    };
    let bytes = match Disk::bytes(&args.file, MOST_BYTES) {
        Ok(b) => b,
        Err(e) => return report::complain(&format!("cannot read {}: {e}", args.file.display())),
    };
    let name = args.file.display().to_string();
    let posted = aptc_control::post_cl(&name, bytes, None, machine.as_ref());
    report::write(&mut io::stderr().lock(), &posted.diagnostics, &posted.sources, common)?;
    let code = if posted.has_errors() { ExitCode::from(exit::ERRORS) } else { exit::GOOD };
    if args.output.as_deref() == Some(Path::new("-")) {
        let mut out = io::stdout().lock();
        for (_, text) in posted.artifact(aptc_control::Artifact::Nc, false) {
            out.write_all(&text)?;
        }
        return Ok(code);
    }
    let path = args.output.clone().unwrap_or_else(|| {
        PathBuf::from(args.file.file_name().unwrap_or_default()).with_extension("nc")
    });
    for (ending, text) in posted.artifact(aptc_control::Artifact::Nc, false) {
        // The first text has the name that was asked for, further ones `2.nc` and so on.
        let path = if ending == "nc" { path.clone() } else { path.with_extension(ending) };
        if let Err(e) = write_whole(&path, &text) {
            return report::complain(&format!("cannot write {}: {e}", path.display()));
        }
        if !common.quiet {
            writeln!(io::stdout(), "wrote {}", path.display())?;
        }
    }
    Ok(code)
}
