//! `aptc check`.

use std::io;
use std::process::ExitCode;

use aptc_control::Disk;

use super::compile::{exit_code, folders, options};
use crate::cli::{CheckArgs, Common, MessageFormat};
use crate::input::part_program;
use crate::progress::Progress;
use crate::{exit, report};

/// Reports all errors of the parts and writes no files. JSON and SARIF go to standard output, since there
/// they are the data.
pub(crate) fn check(args: &CheckArgs, common: &Common) -> io::Result<ExitCode> {
    let mut worst = 0;
    for part in &args.parts {
        let source = match part_program(part, args.source.max_file_size) {
            Ok(s) => s,
            Err(e) => {
                report::complain(&e)?;
                worst = worst.max(exit::FILES);
                continue;
            }
        };
        let mut world =
            Disk::new(folders(part, &args.source), args.source.max_file_size).for_program(part);
        let mut options = options(&args.source);
        options.plot = false;
        let progress = Progress::of(part, common, None);
        let compiled = aptc_control::compile(source, &mut world, &options);
        drop(progress);
        if matches!(common.message_format, MessageFormat::Json | MessageFormat::Sarif) {
            report::messages(&mut io::stdout().lock(), &compiled, common)?;
        } else {
            report::messages(&mut io::stderr().lock(), &compiled, common)?;
        }
        worst = worst.max(exit_code(&compiled));
    }
    Ok(ExitCode::from(worst))
}
