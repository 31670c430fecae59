//! `aptc compile`.

use std::collections::BTreeMap;
use std::ffi::{OsStr, OsString};
use std::fmt::Write as _;
use std::io::{self, Write as _};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::sync::Arc;

use aptc_control::{Artifact, CodeOptions, Compiled, Disk, Options, Verify};

use crate::cli::{CodeArgs, Common, CompileArgs, Emit, SourceArgs, SourceDialect, VerifyHow};
use crate::input::{Inputs, is_same, part_program};
use crate::output::write_whole;
use crate::plain::plain;
use crate::progress::Progress;
use crate::{exit, report};

/// Compiles every part; the exit code is that of the worst.
pub(crate) fn compile(args: &CompileArgs, common: &Common) -> io::Result<ExitCode> {
    let folder = args.output.clone().unwrap_or_else(|| PathBuf::from("."));
    if let Err(e) = std::fs::create_dir_all(&folder) {
        return report::complain(&format!("cannot make the folder {}: {e}", folder.display()));
    }
    let mut code = match code_options(&args.code, common)? {
        Ok(c) => c,
        Err(done) => return Ok(done),
    };
    // A program that is named twice, also in two ways, is compiled once.
    let mut parts: Vec<&Path> = Vec::new();
    for part in &args.parts {
        if !parts.iter().any(|other| is_same(other, part)) {
            parts.push(part);
        }
    }
    if let Some((a, b, stem)) = twice(&parts) {
        return report::complain(&format!(
            "{} and {} would both be written to {}; give each a folder of its own by -o",
            a.display(),
            b.display(),
            folder.join(with_ending(stem.to_owned(), "*")).display()
        ));
    }
    code.map = args.emit.contains(&Emit::Map);
    code.unasked = ![Emit::Nc, Emit::Setup, Emit::Map].iter().any(|kind| args.emit.contains(kind));
    code.by_default = args.emit == [Emit::Cl, Emit::Nc, Emit::Lst, Emit::Svg];
    let mut worst = 0;
    for part in parts {
        let code = compile_one(part, &folder, args, common, code.clone())?;
        worst = worst.max(code);
    }
    Ok(ExitCode::from(worst))
}

fn compile_one(
    part: &Path,
    folder: &Path,
    args: &CompileArgs,
    common: &Common,
    code: CodeOptions,
) -> io::Result<u8> {
    let source = match part_program(part, args.source.max_file_size) {
        Ok(s) => s,
        Err(e) => {
            report::complain(&e)?;
            return Ok(exit::FILES);
        }
    };
    let mut options = options(&args.source);
    options.code = code;
    options.keep_protap = args.emit.contains(&Emit::Protap);
    options.plot = args.emit.contains(&Emit::Svg);
    options.verify = match args.verify {
        None => options.verify,
        Some(VerifyHow::Full) => Verify::Full,
        Some(VerifyHow::Sample) => Verify::Sample,
        Some(VerifyHow::Off) => Verify::Off,
    };
    let mut world =
        Disk::new(folders(part, &args.source), args.source.max_file_size).for_program(part);
    let numeric = part.extension().is_some_and(|e| e.eq_ignore_ascii_case("protap"));
    let progress = Progress::of(part, common, options.passes.clone());
    let compiled = if numeric {
        aptc_control::resume(source, &options)
    } else {
        aptc_control::compile(source, &mut world, &options)
    };
    drop(progress);
    report::messages(&mut io::stderr().lock(), &compiled, common)?;
    let written = match write_artifacts(part, folder, args, &compiled, world.included()) {
        Ok(w) => w,
        Err((path, e)) => {
            report::complain(&format!("cannot write {}: {e}", path.display()))?;
            return Ok(exit::FILES);
        }
    };
    if let Some(old) = stale_code(part, folder, args, &written) {
        let left = "is of an earlier run: this one wrote no machine code";
        writeln!(io::stderr(), "aptc: warning: {} {left}", old.display())?;
    }
    if !common.quiet {
        let text = summary(part, &compiled, &args.emit, &written);
        io::stdout().lock().write_all(text.as_bytes())?;
    }
    Ok(exit_code(&compiled))
}

/// 0, 1 or 3.
pub(crate) fn exit_code(compiled: &Compiled) -> u8 {
    if compiled.has_errors() {
        exit::ERRORS
    } else if compiled.is_refuted() {
        exit::REFUTED
    } else {
        0
    }
}

/// The choices that say how a program is read.
pub(crate) fn options(source: &SourceArgs) -> Options {
    let mut options = Options::default();
    options.translate.free_form = source.free_form;
    if source.deny_unknown_words {
        options.translate.unknown_words = aptc_control::UnknownWords::Refuse;
    }
    if source.dialect == SourceDialect::Ncl {
        options.translate.language = aptc_control::Language::Ncl;
    }
    options.translate.unused = source.warn_unused;
    options.time = source.max_seconds;
    options.threads = source.threads.map_or(0, usize::from);
    options.passes = Some(Arc::default());
    if let Some(n) = source.max_include_depth {
        options.translate.limits.include_depth = n as usize;
    }
    if let Some(n) = source.max_array_elements {
        options.translate.limits.array_elements = n as usize;
    }
    if let Some(n) = source.max_points {
        options.translate.limits.points = n as usize;
    }
    if let Some(n) = source.max_statements {
        options.translate.limits.statements = n;
    }
    if let Some(n) = source.max_macro_depth {
        options.translate.limits.macro_depth = n as usize;
    }
    options
}

/// Folders of included files: the part's own, then those given.
pub(crate) fn folders(part: &Path, source: &SourceArgs) -> Vec<PathBuf> {
    let own = part.parent().filter(|p| !p.as_os_str().is_empty()).unwrap_or(Path::new("."));
    std::iter::once(own.to_owned()).chain(source.include.iter().cloned()).collect()
}

/// The first two part programs whose results would have the same names, and those names' stem.
fn twice<'a>(parts: &[&'a Path]) -> Option<(&'a Path, &'a Path, &'a OsStr)> {
    let mut seen: BTreeMap<&OsStr, &Path> = BTreeMap::new();
    parts.iter().find_map(|part| {
        let stem = part.file_stem()?;
        seen.insert(stem, part).map(|first| (first, *part, stem))
    })
}

/// How machine code is to be written, or the exit code of what has been said of the machine.
pub(crate) fn code_options(
    args: &CodeArgs,
    common: &Common,
) -> io::Result<Result<CodeOptions, ExitCode>> {
    let choice = super::machines::choice(args.machine.as_deref(), common)?;
    Ok(choice.map(|machine| CodeOptions {
        machine,
        work_offset: args.work_offset.clone(),
        stock: args.stock,
        annotate: args.annotate,
        map: false,
        unasked: false,
        by_default: false,
    }))
}

/// Writes what was asked for and can be made. An error leaves what was there before; a file that was read stays,
/// and nothing is written where a result would have its name.
fn write_artifacts(
    part: &Path,
    folder: &Path,
    args: &CompileArgs,
    compiled: &Compiled,
    included: &[PathBuf],
) -> Result<Vec<PathBuf>, (PathBuf, io::Error)> {
    let mut emit = args.emit.clone();
    emit.sort_unstable();
    emit.dedup();
    let stem = part.file_stem().unwrap_or(part.as_os_str());
    let mut all = Vec::new();
    for kind in emit {
        let artifact = match kind {
            Emit::Protap => Artifact::Protap,
            Emit::Cl => Artifact::Cl,
            Emit::ClJson => Artifact::ClJson,
            Emit::Cltape => Artifact::Cltape,
            Emit::Nc => Artifact::Nc,
            Emit::Setup => Artifact::Setup,
            Emit::Map => Artifact::Map,
            Emit::Lst => Artifact::Listing,
            Emit::Svg => Artifact::Svg,
            Emit::Geometry => Artifact::Geometry,
            Emit::Deviation => Artifact::Deviation,
            Emit::Diagram => Artifact::Diagram,
        };
        let files = compiled.files(artifact, args.keep_going).map_err(|e| (part.into(), e))?;
        for file in files {
            all.push((folder.join(with_ending(stem.to_owned(), &file.ending)), artifact, file));
        }
    }
    let others = args.parts.iter().map(|part| (&**part, "a part program of this run"));
    let others = others.chain(included.iter().map(|file| (&**file, "included in the program")));
    let files = std::iter::once((part, "what was compiled")).chain(others);
    let inputs = Inputs::new(files, args.code.machine.as_deref());
    if let Some((path, what)) = all.iter().find_map(|(p, ..)| inputs.what_is(p).map(|w| (p, w))) {
        let why = format!("it is {what}; name another folder by -o");
        return Err((path.clone(), io::Error::other(why)));
    }
    let mut written = Vec::new();
    for (path, artifact, file) in all {
        write_whole(&path, &file, artifact).map_err(|e| (path.clone(), e))?;
        written.push(path);
    }
    Ok(written)
}

/// Machine code of an earlier run where this one wrote none: nobody shall take it for that of the program as it is.
fn stale_code(
    part: &Path,
    folder: &Path,
    args: &CompileArgs,
    written: &[PathBuf],
) -> Option<PathBuf> {
    let stem = part.file_stem().unwrap_or(part.as_os_str());
    let path = folder.join(with_ending(stem.to_owned(), "nc"));
    (args.emit.contains(&Emit::Nc) && !written.contains(&path) && path.exists()).then_some(path)
}

fn with_ending(mut stem: OsString, ending: &str) -> OsString {
    stem.push(".");
    stem.push(ending);
    stem
}

/// A few lines: what was made, how long it takes, what is proved, what was written.
fn summary(part: &Path, compiled: &Compiled, asked: &[Emit], written: &[PathBuf]) -> String {
    let mut out = String::new();
    let mut add = |label: &str, text: String| {
        writeln!(out, "  {label:<15}{}", plain(&text)).expect("strings take all");
    };
    for p in &compiled.parts {
        let s = &p.summary;
        add("part", s.partno.clone());
        let unit = s.units.word().to_lowercase();
        add("cut vectors", format!("{} in {} motions", s.cut_vectors, s.motions));
        add(
            "path length",
            format!("{:.3} {unit} at feed rate, {:.3} {unit} rapid", s.cut_length, s.rapid_length),
        );
        for nc in &p.nc {
            add("machining time", format!("{} on {}", clock(nc.seconds()), nc.machine.name));
        }
        if let Some(certificate) = &p.certificate {
            add("tolerance", certificate.to_string());
        }
    }
    // What is not always made is not left out in silence.
    let milled = if compiled.has_errors() {
        "none, for the program has errors"
    } else {
        "none, for nothing was milled by regions"
    };
    let pictures = [
        (Emit::Diagram, "diagram", "none, for no motion failed"),
        (Emit::Deviation, "deviation", milled),
    ];
    for (kind, name, why) in pictures {
        let made = |p: &PathBuf| p.to_string_lossy().ends_with(&format!(".{name}.svg"));
        if asked.contains(&kind) && !written.iter().any(made) {
            add(name, why.to_owned());
        }
    }
    if !written.is_empty() {
        let names: Vec<_> = written.iter().map(|p| p.display().to_string()).collect();
        add("wrote", names.join(" "));
    }
    format!("{}\n{out}", part.display())
}

/// `1 h 02 min 03 s`.
fn clock(seconds: f64) -> String {
    let s = seconds.max(0.0).round();
    let (h, m, s) = ((s / 3600.0).floor(), (s / 60.0).floor() % 60.0, s % 60.0);
    if h > 0.0 {
        format!("{h} h {m:02} min {s:02} s")
    } else if m > 0.0 {
        format!("{m} min {s:02} s")
    } else {
        format!("{s} s")
    }
}
