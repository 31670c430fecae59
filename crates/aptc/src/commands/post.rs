//! `aptc post`.

use std::fs::File;
use std::io::{self, Read, Write as _};
use std::path::Path;
use std::process::ExitCode;

use aptc_control::{Artifact, ClOptions, PostedCl, post_cl};

use super::cl::dialect;
use super::compile::{code_options, exit_code};
use crate::cli::{Common, PostArgs};
use crate::input::{cl_fault, is_same};
use crate::output::{Aside, write_whole};
use crate::{exit, report};

/// Posts a CL file, record by record. The machine code is written whole or, where the post refused, not at
/// all.
pub(crate) fn post(args: &PostArgs, common: &Common) -> io::Result<ExitCode> {
    let mut code = match code_options(&args.code, common)? {
        Ok(c) => c,
        Err(done) => return Ok(done),
    };
    code.map = args.map;
    let dialect = match dialect(args.from.as_deref()) {
        Ok(d) => d,
        Err(e) => return report::complain(&e),
    };
    let show = args.output.as_deref() == Some(Path::new("-"));
    let own_name = Path::new(args.file.file_name().unwrap_or_default()).with_extension("nc");
    let path = match &args.output {
        Some(folder) if folder.is_dir() => folder.join(own_name),
        Some(file) if !show => file.clone(),
        _ => own_name,
    };
    let beside = if show { std::env::temp_dir().join("nc") } else { path.clone() };
    if let Some(e) = cl_fault(&args.file, dialect) {
        return report::complain(&e);
    }
    if !show && is_same(&path, &args.file) {
        return report::complain(&format!(
            "{} is what is posted; name another file by -o",
            path.display()
        ));
    }
    let name = args.file.display().to_string();
    let mut open = || Ok(Box::new(File::open(&args.file)?) as Box<dyn Read>);
    let cl = ClOptions { dialect, edit: args.edit };
    let posted = match post_cl(&name, &mut open, cl, &code, &mut || Aside::begin(&beside)) {
        Ok(p) => p,
        Err(e) => return report::complain(&format!("cannot post {name}: {e}")),
    };
    let PostedCl { compiled, texts } = posted;
    report::messages(&mut io::stderr().lock(), &compiled, common)?;
    let exit = ExitCode::from(exit_code(&compiled));
    let whole = compiled.is_cl_whole();
    if texts.is_empty() && exit == exit::GOOD {
        let why = "it has no motion and no word that a machine obeys";
        return report::complain(&format!("no machine code comes of {name}: {why}"));
    }
    let texts = compiled.nc().map(|(stem, _)| format!("{stem}nc")).zip(texts);
    for (ending, text) in texts.filter(|_| whole) {
        if show {
            text.copy_to(&mut io::stdout().lock())?;
            continue;
        }
        // The first text has the name that was asked for, further ones `2.nc` and so on.
        let path = if ending == "nc" { path.clone() } else { path.with_extension(ending) };
        if let Some(done) = wrote(&path, text.keep(&path), common)? {
            return Ok(done);
        }
    }
    if show {
        return Ok(exit);
    }
    let kinds =
        [(args.setup, Artifact::Setup), (args.map, Artifact::Map)].into_iter().filter(|k| k.0);
    for (_, kind) in kinds {
        for file in compiled.files(kind, false)? {
            let path = path.with_extension(&file.ending);
            if let Some(done) = wrote(&path, write_whole(&path, &file, kind), common)? {
                return Ok(done);
            }
        }
    }
    Ok(exit)
}

/// Tells of a file that was written; the exit code if it could not be.
fn wrote(path: &Path, done: io::Result<()>, common: &Common) -> io::Result<Option<ExitCode>> {
    if let Err(e) = done {
        return report::complain(&format!("cannot write {}: {e}", path.display())).map(Some);
    }
    if !common.quiet {
        writeln!(io::stdout(), "wrote {}", path.display())?;
    }
    Ok(None)
}
