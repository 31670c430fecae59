//! `aptc machines`.

use std::io::{self, Write as _};
use std::path::Path;
use std::process::ExitCode;

use aptc_control::{Machine, machine_for, machines as all};

use crate::cli::Common;
use crate::{exit, report};

/// Lists the machines, or checks a machine file and says what the machine has.
pub(crate) fn machines(name: Option<&str>, common: &Common) -> io::Result<ExitCode> {
    let mut out = io::stdout().lock();
    let Some(name) = name else {
        for m in all() {
            writeln!(out, "{:<28}{:<26}{}", m.name, m.machin.join(" "), m.title)?;
        }
        writeln!(out, "The second column is what MACHIN/ may name; --machine takes the first.")?;
        return Ok(exit::GOOD);
    };
    if !Path::new(name).extension().is_some_and(|e| e.eq_ignore_ascii_case("toml")) {
        return match machine_for(name, &[]) {
            Some(m) => describe(&mut out, m).map(|()| exit::GOOD),
            None => {
                report::complain(&format!("there is no machine {name}; `aptc machines` lists them"))
            }
        };
    }
    let source = match aptc_control::Disk::open(Path::new(name), 16 << 20) {
        Ok(s) => s,
        Err(e) => return report::complain(&format!("cannot read {name}: {e}")),
    };
    let mut sources = aptc_diagnostics::SourceMap::default();
    let file = sources.add(source.name, std::sync::Arc::clone(&source.text));
    match Machine::parse_in(&source.text, file) {
        Ok(m) => describe(&mut out, &m).map(|()| exit::GOOD),
        Err(diagnostics) => {
            report::write(&mut io::stderr().lock(), &diagnostics, &sources, common)?;
            Ok(ExitCode::from(exit::ERRORS))
        }
    }
}

fn describe(out: &mut impl io::Write, m: &Machine) -> io::Result<()> {
    writeln!(out, "{}: {}", m.name, m.title)
}
