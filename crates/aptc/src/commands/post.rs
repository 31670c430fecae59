//! `aptc post`.

use std::fs::File;
use std::io::{self, Read, Write as _};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use aptc_control::{Artifact, ClOptions, PostedCl, post_cl};

use super::cl::dialect;
use super::compile::{code_options, exit_code};
use crate::cli::{Common, PostArgs};
use crate::input::{Inputs, cl_fault};
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
    let inputs = Inputs::new([(&*args.file, "what is posted")], args.code.machine.as_deref());
    let taken = |path: &Path| {
        let what = inputs.what_is(path).filter(|_| !show)?;
        Some(format!("{} is {what}; name another file by -o", path.display()))
    };
    if let Some(e) = taken(&path) {
        return report::complain(&e);
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
    // The first text has the name that was asked for, further ones `2.nc` and so on.
    let named = |ending: String| {
        if ending == "nc" { path.clone() } else { path.with_extension(ending) }
    };
    let texts = compiled.nc().map(|(stem, _)| named(format!("{stem}nc"))).zip(texts);
    let texts: Vec<(PathBuf, Aside)> = texts.filter(|_| whole).collect();
    let mut sheets = Vec::new();
    let kinds =
        [(args.setup, Artifact::Setup), (args.map, Artifact::Map)].into_iter().filter(|k| k.0);
    for (_, kind) in kinds.filter(|_| !show) {
        for file in compiled.files(kind, false)? {
            sheets.push((path.with_extension(&file.ending), kind, file));
        }
    }
    // All names are asked before the first is written.
    let paths = texts.iter().map(|(path, _)| path).chain(sheets.iter().map(|(path, ..)| path));
    if let Some(e) = paths.into_iter().find_map(|path| taken(path)) {
        return report::complain(&e);
    }
    for (path, text) in texts {
        if show {
            text.copy_to(&mut io::stdout().lock())?;
            continue;
        }
        if let Some(done) = wrote(&path, text.keep(&path), common)? {
            return Ok(done);
        }
    }
    for (path, kind, file) in sheets {
        if let Some(done) = wrote(&path, write_whole(&path, &file, kind), common)? {
            return Ok(done);
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
