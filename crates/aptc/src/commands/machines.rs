//! `aptc machines`.

use std::io::{self, Write as _};
use std::path::Path;
use std::process::ExitCode;
use std::sync::Arc;

use aptc_control::{Disk, Machine, MachineChoice, machine_file, machine_for, machines as all};
use aptc_diagnostics::SourceMap;

use crate::cli::Common;
use crate::{exit, report};

/// Largest machine file that is read.
const MOST_BYTES: u64 = 16 << 20;

/// Lists the machines, prints the file of one that is built in, or checks a machine file.
pub(crate) fn machines(name: Option<&str>, common: &Common) -> io::Result<ExitCode> {
    let mut out = io::stdout().lock();
    let Some(name) = name else {
        for m in all() {
            writeln!(out, "{:<28}{:<26}{}", m.name, m.machin.join(" "), m.title)?;
        }
        writeln!(out, "The second column is what MACHIN/ may name; --machine takes the first.")?;
        return Ok(exit::GOOD);
    };
    if !is_file(name) {
        return match machine_for(name, &[]).and_then(|m| machine_file(&m.name)) {
            Some(text) => out.write_all(text.as_bytes()).map(|()| exit::GOOD),
            None => unknown(name),
        };
    }
    match read(name, common)? {
        Ok(m) => writeln!(out, "{}: {}", m.name, m.title).map(|()| exit::GOOD),
        Err(code) => Ok(code),
    }
}

/// The machine that was asked for by `--machine`, or the exit code of what has been said of it.
pub(crate) fn choice(
    name: Option<&str>,
    common: &Common,
) -> io::Result<Result<Option<MachineChoice>, ExitCode>> {
    Ok(match name {
        None => Ok(None),
        Some(name) if is_file(name) => {
            read(name, common)?.map(|m| Some(MachineChoice::Read(Box::new(m))))
        }
        Some(name) if machine_for(name, &[]).is_none() => Err(unknown(name)?),
        Some(name) => Ok(Some(MachineChoice::Named(name.to_owned()))),
    })
}

fn is_file(name: &str) -> bool {
    Path::new(name).extension().is_some_and(|e| e.eq_ignore_ascii_case("toml"))
}

fn unknown(name: &str) -> io::Result<ExitCode> {
    let file =
        if Path::new(name).is_file() { "; the name of a machine file ends in .toml" } else { "" };
    report::complain(&format!("there is no machine {name}; `aptc machines` lists them{file}"))
}

/// Reads a machine file; what is wrong with it is said at its own lines.
fn read(name: &str, common: &Common) -> io::Result<Result<Machine, ExitCode>> {
    let source = match Disk::open(Path::new(name), MOST_BYTES) {
        Ok(s) => s,
        Err(e) => return report::complain(&format!("cannot read {name}: {e}")).map(Err),
    };
    let mut sources = SourceMap::default();
    let file = sources.add(source.name, Arc::clone(&source.text));
    match Machine::parse_in(&source.text, file) {
        Ok(m) => Ok(Ok(m)),
        Err(found) => {
            report::write(&mut io::stderr().lock(), &found, &sources, common)?;
            Ok(Err(ExitCode::from(exit::ERRORS)))
        }
    }
}
