//! `aptc verify`.

use std::fs::File;
use std::io::{self, BufReader, Write as _};
use std::path::Path;
use std::process::ExitCode;

use aptc_control::{Certificate, ClFile, Compiled, Disk, Verify};
use aptc_diagnostics::{SourceMap, codes};
use serde_json::json;

use super::cl::dialect;
use super::compile::{folders, options};
use crate::cli::{Common, VerifyArgs, VerifyHow};
use crate::input::{cl_fault, nc_fault, part_program};
use crate::{exit, report};

/// Judges every part; exit code 0 only when all of the path is proved.
pub(crate) fn verify(args: &VerifyArgs, common: &Common) -> io::Result<ExitCode> {
    if let Some(nc) = &args.nc {
        return match &args.cl {
            Some(cl) if args.parts.is_empty() => verify_nc(nc, cl, args, common),
            _ => report::complain(&held_so(nc, args)),
        };
    }
    if args.cl.is_some() && args.parts.len() > 1 {
        return report::complain("a CL file goes with one program: name only that");
    }
    let mut worst = 0;
    let mut documents = Vec::new();
    for part in &args.parts {
        let limit = args.source.max_file_size;
        let source = match part_program(part, limit) {
            Ok(s) => s,
            Err(e) => return report::complain(&e),
        };
        if let Some(e) = args.cl.as_ref().and_then(|path| cl_fault(path, None)) {
            return report::complain(&e);
        }
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
        let mut world = Disk::new(folders(part, &args.source), limit).for_program(part);
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
            for judged in &judged.parts {
                match &judged.certificate {
                    Some(certificate) => writeln!(out, "{}: {certificate}", part.display())?,
                    None if args.verify == VerifyHow::Off => {
                        writeln!(out, "{}: nothing is proved (--verify off)", part.display())?;
                    }
                    None => {}
                }
            }
        }
        worst = worst.max(code(&judged));
    }
    if args.json {
        let mut out = io::stdout().lock();
        serde_json::to_writer_pretty(&mut out, &json!({ "programs": documents }))?;
        writeln!(out)?;
    }
    Ok(ExitCode::from(worst))
}

/// How machine code is held against CL data, with what is known of that.
fn held_so(nc: &Path, args: &VerifyArgs) -> String {
    let part = args.parts.first().map(|part| part.with_extension("cl"));
    let cl = args.cl.clone().or(part).unwrap_or_else(|| "FILE.cl".into());
    let machine = args.machine.as_deref().unwrap_or("NAME");
    let (nc, cl) = (nc.display(), cl.display());
    format!(
        "machine code is held against CL data, of a machine that is named (`aptc machines` lists them): \
         aptc verify --nc {nc} --cl {cl} --machine {machine}"
    )
}

/// Holds machine code against CL data; exit code 0 only when it goes where they do.
fn verify_nc(nc: &Path, cl: &Path, args: &VerifyArgs, common: &Common) -> io::Result<ExitCode> {
    let machine = match super::machines::choice(args.machine.as_deref(), common)? {
        Ok(Some(choice)) => choice.machine(),
        Ok(None) => return report::complain(&held_so(nc, args)),
        Err(done) => return Ok(done),
    };
    let dialect = match dialect(args.from.as_deref()) {
        Ok(d) => d,
        Err(e) => return report::complain(&e),
    };
    if let Some(e) = nc_fault(nc).or_else(|| cl_fault(cl, dialect)) {
        return report::complain(&e);
    }
    let mut sources = SourceMap::default();
    // Places in the machine code stand in the messages themselves.
    sources.add_unkept(cl.display().to_string());
    let machine = match machine {
        Ok(m) => m,
        Err(list) => {
            report::write(&mut io::stderr().lock(), &list, &sources, common)?;
            return Ok(ExitCode::from(exit::ERRORS));
        }
    };
    let open = |path: &Path| match File::open(path) {
        Ok(f) if path.is_file() => Ok(f),
        Ok(_) => Err(format!("cannot read {}: it is no file", path.display())),
        Err(e) => Err(format!("cannot read {}: {e}", path.display())),
    };
    let (text, records) = match (open(nc), open(cl)) {
        (Ok(a), Ok(b)) => (a, b),
        (Err(e), _) | (_, Err(e)) => return report::complain(&e),
    };
    let mut text = BufReader::new(text);
    let done = aptc_control::verify_code(&machine, Box::new(records), dialect, &mut text);
    let (proof, found) = match done {
        Ok(d) => d,
        Err(e) => return report::complain(&format!("cannot read {}: {e}", cl.display())),
    };
    report::write(&mut io::stderr().lock(), &found, &sources, common)?;
    let mut out = io::stdout().lock();
    if args.json {
        let name = |p: &Path| p.display().to_string();
        let document = json!({
            "nc": name(nc), "cl": name(cl), "machine": machine.name,
            "proved": found.is_empty(), "proof": proof,
        });
        serde_json::to_writer_pretty(&mut out, &document)?;
        writeln!(out)?;
    } else if !common.quiet {
        let (nc, cl) = (nc.display(), cl.display());
        if found.is_empty() {
            let rest = "speeds, feeds and coolant are not compared";
            writeln!(out, "{nc} goes where {cl} says: {proof}; {rest}")?;
        } else {
            let n = proof.points;
            writeln!(
                out,
                "{nc} does not go where {cl} says; {n} positions are reached before or between"
            )?;
        }
    }
    let unread = found.iter().any(|d| d.code != codes::NOT_THE_CL);
    Ok(match (found.is_empty(), unread) {
        (true, _) => exit::GOOD,
        (false, true) => ExitCode::from(exit::ERRORS),
        (false, false) => ExitCode::from(exit::REFUTED),
    })
}

/// 1 for a program with errors, else 0 where everything is proved and 3 where not: a sample leaves cut vectors out, and
/// without the proof nothing is proved.
fn code(judged: &Compiled) -> u8 {
    if judged.has_errors() {
        return exit::ERRORS;
    }
    let proved = |c: &Certificate| c.is_proved();
    let all = judged.parts.iter().all(|p| p.certificate.as_ref().is_some_and(proved));
    if all && !judged.is_refuted() { 0 } else { exit::REFUTED }
}
