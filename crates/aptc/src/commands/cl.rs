//! `aptc convert`, `aptc cldiff` and `aptc stats`: CL files of any dialect.

use std::fs::File;
use std::io::{self, BufReader, Write};
use std::path::Path;
use std::process::ExitCode;

use aptc_control::{
    CatiaWriter, ClfileWriter, Codes, Decimals, Dialect, FileKind, JsonWriter, NcReader, Reader,
    Record, RecordReader, RecordWriter, TapeWriter, TextOptions, TextWriter, copy, diff, edit_cl,
    find_places, machines, stats,
};
use aptc_diagnostics::{Diagnostic, SourceMap};

use crate::cli::{CldiffArgs, Common, ConvertArgs, StatsArgs};
use crate::input::{cl_fault, is_same, kind};
use crate::output::Aside;
use crate::{exit, report};

type FileReader = Reader<BufReader<File>>;

/// Converts a CL file, record by record; the result takes its name when it is whole.
pub(crate) fn convert(args: &ConvertArgs, common: &Common) -> io::Result<ExitCode> {
    let Some(to) = Dialect::from_name(&args.to) else {
        return report::complain(&format!("there is no CL dialect {}; {}", args.to, dialects()));
    };
    let mut reader = match open(&args.file, args.from.as_deref()) {
        Ok(r) => r,
        Err(e) => return report::complain(&e),
    };
    if is_same(&args.output, &args.file) {
        let name = args.output.display();
        return report::complain(&format!("{name} is what is converted; name another file by -o"));
    }
    let mut aside = match Aside::begin(&args.output) {
        Ok(a) => a,
        Err(e) => return cannot_write(&args.output, &e),
    };
    let mut edited = Vec::new();
    let done = {
        let out = &mut aside;
        let mut writer: Box<dyn RecordWriter> = match to {
            Dialect::Iso => {
                // Lines of another CL file are no origins worth a comment each.
                let marks = reader.is_marked();
                Box::new(TextWriter::new(out, TextOptions { marks, ..TextOptions::default() }))
            }
            Dialect::Catia => Box::new(CatiaWriter::new(out, Decimals::Shortest)),
            Dialect::Json => Box::new(JsonWriter::new(out)),
            Dialect::Tape => Box::new(TapeWriter::new(out, Codes::Apt360)),
            Dialect::Clfile => Box::new(ClfileWriter::new(out)),
            _ => {
                let text = format!("CL data are not written as {}, only read", to.name());
                return report::complain(&text);
            }
        };
        if args.edit {
            edit_cl(&mut reader, &mut *writer).map(|list| edited = list)
        } else {
            copy(&mut reader, &mut *writer).map(|_| ())
        }
    };
    if let Err(e) = done.and_then(|()| aside.keep(&args.output)) {
        return cannot_write(&args.output, &e);
    }
    messages(reader, edited, &args.file, common)
}

fn cannot_write(path: &Path, e: &io::Error) -> io::Result<ExitCode> {
    report::complain(&format!("cannot write {}: {e}", path.display()))
}

/// Compares two CL files or two files of machine code; exit code 1 when they differ or cannot be read.
pub(crate) fn cldiff(args: &CldiffArgs, common: &Common) -> io::Result<ExitCode> {
    let opened = |path: &Path| Compared::open(path, args.machine.as_deref());
    let (mut a, mut b) = match (opened(&args.first), opened(&args.second)) {
        (Ok(a), Ok(b)) => (a, b),
        (Err(e), _) | (_, Err(e)) => return report::complain(&e),
    };
    if a.is_code() != b.is_code() {
        return report::complain("one of the files is machine code, the other CL data");
    }
    let difference = diff::diff(a.reader(), b.reader(), args.tolerance)?;
    let mut unread = Vec::new();
    for (compared, path) in [(a, &args.first), (b, &args.second)] {
        // Units and words that no table has are no matter of a comparison.
        let mut found = compared.into_diagnostics();
        found.retain(Diagnostic::is_error);
        tell(&found, path, common)?;
        if !found.is_empty() {
            unread.push(path.display().to_string());
        }
    }
    let mut out = io::stdout().lock();
    if args.json {
        writeln!(out, "{}", serde_json::to_string_pretty(&difference)?)?;
    } else if unread.is_empty() {
        out.write_all(difference.text().as_bytes())?;
    } else {
        // What was read of them tells nothing of the rest.
        let files = unread.join(" and ");
        writeln!(out, "nothing is said of the ways: {files} cannot be read in whole")?;
    }
    let good = difference.is_same() && unread.is_empty();
    Ok(if good { exit::GOOD } else { ExitCode::from(exit::ERRORS) })
}

/// A file to be compared.
enum Compared {
    Cl(Box<FileReader>),
    Code(Box<NcReader<BufReader<File>>>),
}

impl Compared {
    /// Machine code when a machine is given, or the file's name says so and not its first lines something else.
    fn open(path: &Path, machine: Option<&str>) -> Result<Self, String> {
        let ending = path.extension().map(|e| e.to_string_lossy().to_lowercase());
        let kind = kind(path);
        let usual = match ending.as_deref() {
            _ if matches!(kind, Some(FileKind::PartProgram | FileKind::Statements)) => None,
            Some("nc" | "ngc" | "cnc" | "gcode" | "tap" | "eia" | "iso")
                if kind == Some(FileKind::PlainCode) =>
            {
                Some("heidenhain-tnc")
            }
            Some("nc" | "ngc" | "cnc" | "gcode" | "tap" | "eia" | "iso") => Some("linuxcnc-mill"),
            Some("mpf" | "spf") => Some("siemens-840d-mill"),
            Some("h") => Some("heidenhain-tnc"),
            _ => None,
        };
        let Some(name) = machine.or(usual) else {
            return open(path, None).map(|r| Self::Cl(Box::new(r)));
        };
        let machine = machines()
            .find(|m| m.name.eq_ignore_ascii_case(name))
            .ok_or_else(|| format!("there is no machine {name}; `aptc machines` lists them"))?;
        let fault = |e: io::Error| format!("cannot read {}: {e}", path.display());
        if !path.is_file() {
            return Err(format!("cannot read {}: it is no file", path.display()));
        }
        let input = BufReader::new(File::open(path).map_err(fault)?);
        Ok(Self::Code(Box::new(NcReader::new(machine, input))))
    }

    fn is_code(&self) -> bool {
        matches!(self, Self::Code(_))
    }

    fn reader(&mut self) -> &mut dyn RecordReader {
        match self {
            Self::Cl(r) => &mut **r,
            Self::Code(r) => &mut **r,
        }
    }

    fn into_diagnostics(self) -> Vec<Diagnostic> {
        match self {
            Self::Cl(r) => r.into_diagnostics(),
            Self::Code(r) => r.into_diagnostics(),
        }
    }
}

/// Prints the figures of a CL file.
pub(crate) fn stats(args: &StatsArgs, common: &Common) -> io::Result<ExitCode> {
    let mut reader = match open(&args.file, None) {
        Ok(r) => r,
        Err(e) => return report::complain(&e),
    };
    let mut figures = stats::Stats::new();
    let mut record = Record::default();
    while reader.read(&mut record)? {
        figures.push(&record);
    }
    let mut out = io::stdout().lock();
    if args.json {
        writeln!(out, "{}", serde_json::to_string_pretty(&figures)?)?;
    } else {
        out.write_all(figures.text().as_bytes())?;
    }
    messages(reader, Vec::new(), &args.file, common)
}

/// The dialect of that name, if one is given.
pub(crate) fn dialect(name: Option<&str>) -> Result<Option<Dialect>, String> {
    let Some(name) = name else { return Ok(None) };
    match Dialect::from_name(name) {
        Some(d) => Ok(Some(d)),
        None => Err(format!("there is no CL dialect {name}; {}", dialects())),
    }
}

fn open(path: &Path, name: Option<&str>) -> Result<FileReader, String> {
    let dialect = dialect(name)?;
    if let Some(fault) = cl_fault(path, dialect) {
        return Err(fault);
    }
    let fault = |e: io::Error| format!("cannot read {}: {e}", path.display());
    let file = File::open(path).map_err(fault)?;
    Reader::open(BufReader::new(file), dialect).map_err(fault)
}

fn dialects() -> String {
    let names: Vec<_> = Dialect::ALL.iter().map(|d| d.name()).collect();
    format!("known are {}", names.join(", "))
}

/// Writes the messages about a file.
fn tell(diagnostics: &[Diagnostic], path: &Path, common: &Common) -> io::Result<()> {
    let mut sources = SourceMap::default();
    let file = sources.add_unkept(path.display().to_string());
    find_places(diagnostics, &mut sources, file, File::open(path)?)?;
    report::write(&mut io::stderr().lock(), diagnostics, &sources, common)
}

/// Tells what the reader and the editor found; the file's text is not kept, but the places are found.
fn messages(
    reader: FileReader,
    edited: Vec<Diagnostic>,
    path: &Path,
    common: &Common,
) -> io::Result<ExitCode> {
    let mut diagnostics = reader.into_diagnostics();
    diagnostics.extend(edited);
    tell(&diagnostics, path, common)?;
    let errors = diagnostics.iter().any(Diagnostic::is_error);
    Ok(if errors { ExitCode::from(exit::ERRORS) } else { exit::GOOD })
}
