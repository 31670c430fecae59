//! `aptc verify`.

use std::io::{self, Write as _};
use std::process::ExitCode;

use aptc_control::{Certificate, ClFile, Compiled, Disk, Verify};
use serde_json::json;

use super::compile::{folders, options};
use crate::cli::{Common, VerifyArgs, VerifyHow};
use crate::{exit, report};

/// Judges every part; exit code 0 only when all of the path is proved.
pub(crate) fn verify(args: &VerifyArgs, common: &Common) -> io::Result<ExitCode> {
    if args.cl.is_some() && args.parts.len() > 1 {
        return report::complain("a CL file goes with one program: name only that");
    }
    let mut worst = 0;
    let mut documents = Vec::new();
    for part in &args.parts {
        let limit = args.source.max_file_size;
        let source = match Disk::open(part, limit) {
            Ok(s) => s,
            Err(e) => return report::complain(&format!("cannot read {}: {e}", part.display())),
        };
        let file = match &args.cl {
            None => None,
            Some(path) => match Disk::bytes(path, limit) {
                Ok(bytes) => Some(ClFile { name: path.display().to_string(), bytes }),
                Err(e) => return report::complain(&format!("cannot read {}: {e}", path.display())),
            },
        };
        let mut options = options(&args.source);
        options.verify = match args.verify {
            VerifyHow::Full => Verify::Full,
            VerifyHow::Sample => Verify::Sample,
            VerifyHow::Off => Verify::Off,
        };
        let mut world = Disk::new(folders(part, &args.source), limit);
        let judged = aptc_control::verify(source, &mut world, &options, file);
        report::messages(&mut io::stderr().lock(), &judged, common)?;
        if args.json {
            let parts: Vec<_> = judged
                .parts
                .iter()
                .map(|p| json!({ "part": p.summary.partno, "certificate": p.certificate }))
                .collect();
            documents.push(json!({ "program": part.display().to_string(), "parts": parts }));
        } else if !common.quiet {
            let mut out = io::stdout().lock();
            for certificate in judged.parts.iter().filter_map(|p| p.certificate.as_ref()) {
                writeln!(out, "{}: {certificate}", part.display())?;
            }
        }
        worst = worst.max(code(&judged, args.verify == VerifyHow::Off));
    }
    if args.json {
        let mut out = io::stdout().lock();
        serde_json::to_writer_pretty(&mut out, &json!({ "programs": documents }))?;
        writeln!(out)?;
    }
    Ok(ExitCode::from(worst))
}

/// 1 for a program with errors, else 0 where everything is proved and 3 where not; a sample proves what it
/// holds.
fn code(judged: &Compiled, off: bool) -> u8 {
    if judged.has_errors() {
        return exit::ERRORS;
    }
    let proved = |c: &Certificate| c.is_proved();
    let all = judged.parts.iter().all(|p| p.certificate.as_ref().map_or(off, proved));
    if all && !judged.is_refuted() { 0 } else { exit::REFUTED }
}
