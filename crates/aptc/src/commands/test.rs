//! `aptc test`.

use std::io::{self, Write as _};
use std::process::ExitCode;

use aptc_golden::{Fault, Mode, Report, run};

use crate::cli::{Common, TestArgs};
use crate::{exit, report};

/// Compiles every program of a folder and holds the results against their goldens; `--bless` writes these
/// anew. Exit code 1 when a part or its messages changed; a cosmetic change is told and passes.
pub(crate) fn test(args: &TestArgs, common: &Common) -> io::Result<ExitCode> {
    let mode = if args.bless { Mode::Bless } else { Mode::Compare };
    let tested = match run(&args.folder, &args.filter, mode, aptc_golden::compile) {
        Ok(report) => report,
        Err(e) => return report::complain(&e),
    };
    if tested.n_cases() == 0 {
        let folder = args.folder.display();
        return report::complain(&match args.filter.as_str() {
            "" => format!("there is no program X.apt in {folder}"),
            filter => format!("no program of {folder} has {filter} in its name"),
        });
    }
    let out = &mut io::stdout().lock();
    if common.quiet {
        tested.faults().try_for_each(|(case, fault)| writeln!(out, "{case}: {fault}"))?;
    } else {
        writeln!(out, "{tested}")?;
        writeln!(out, "{}", verdict(&tested))?;
    }
    Ok(if tested.is_cosmetic() { exit::GOOD } else { ExitCode::from(exit::ERRORS) })
}

fn verdict(tested: &Report) -> &'static str {
    let blessed = tested.faults().any(|(_, fault)| matches!(fault, Fault::Blessed(_)));
    if tested.is_good() && blessed {
        "goldens are written anew; read them before you keep them"
    } else if tested.is_good() {
        "all is as it was"
    } else if tested.is_cosmetic() {
        "cosmetic changes only: the parts are the same; --bless takes them over"
    } else {
        "read the changes; where they are right, --bless takes them over"
    }
}
