//! `aptc convert`, `aptc cldiff` and `aptc stats`: CL files of any dialect.

use std::fs::File;
use std::io::{self, BufReader, Write};
use std::path::Path;
use std::process::ExitCode;

use aptc_control::{
    CatiaWriter, ClfileWriter, Codes, Decimals, Dialect, JsonWriter, Reader, Record,
    RecordReader as _, RecordWriter, TapeWriter, TextOptions, TextWriter, copy, diff, stats,
};
use aptc_diagnostics::SourceMap;

use crate::cli::{CldiffArgs, Common, ConvertArgs, StatsArgs};
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
    let folder =
        args.output.parent().filter(|p| !p.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let mut aside = tempfile::Builder::new().prefix(".aptc-").tempfile_in(folder)?;
    {
        let out = aside.as_file_mut();
        let mut writer: Box<dyn RecordWriter> = match to {
            Dialect::Iso => Box::new(TextWriter::new(out, TextOptions::default())),
            Dialect::Catia => Box::new(CatiaWriter::new(out, Decimals::Shortest)),
            Dialect::Json => Box::new(JsonWriter::new(out)),
            Dialect::Tape => Box::new(TapeWriter::new(out, Codes::Apt360)),
            Dialect::Clfile => Box::new(ClfileWriter::new(out)),
            _ => {
                let text = format!("CL data are not written as {}, only read", to.name());
                return report::complain(&text);
            }
        };
        copy(&mut reader, &mut *writer)?;
    }
    aside.persist(&args.output).map_err(|e| e.error)?;
    messages(reader, &args.file, common)
}

/// Compares two CL files; exit code 1 when they differ.
pub(crate) fn cldiff(args: &CldiffArgs) -> io::Result<ExitCode> {
    let (mut a, mut b) = match (open(&args.first, None), open(&args.second, None)) {
        (Ok(a), Ok(b)) => (a, b),
        (Err(e), _) | (_, Err(e)) => return report::complain(&e),
    };
    let difference = diff::diff(&mut a, &mut b, args.tolerance)?;
    io::stdout().lock().write_all(difference.text().as_bytes())?;
    Ok(if difference.is_same() { exit::GOOD } else { ExitCode::from(exit::ERRORS) })
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
    messages(reader, &args.file, common)
}

fn open(path: &Path, dialect: Option<&str>) -> Result<FileReader, String> {
    let dialect = match dialect {
        None => None,
        Some(name) => Some(
            Dialect::from_name(name)
                .ok_or_else(|| format!("there is no CL dialect {name}; {}", dialects()))?,
        ),
    };
    let fault = |e: io::Error| format!("cannot read {}: {e}", path.display());
    if !path.is_file() {
        return Err(format!("cannot read {}: it is no file", path.display()));
    }
    let file = File::open(path).map_err(fault)?;
    Reader::open(BufReader::new(file), dialect).map_err(fault)
}

fn dialects() -> String {
    let names: Vec<_> = Dialect::ALL.iter().map(|d| d.name()).collect();
    format!("known are {}", names.join(", "))
}

/// Tells what the reader found; the file's text is not kept, so the messages give lines in their words.
fn messages(reader: FileReader, path: &Path, common: &Common) -> io::Result<ExitCode> {
    let diagnostics = reader.into_diagnostics();
    let mut sources = SourceMap::default();
    sources.add(path.display().to_string(), "");
    report::write(&mut io::stderr().lock(), &diagnostics, &sources, common)?;
    let errors = diagnostics.iter().any(aptc_diagnostics::Diagnostic::is_error);
    Ok(if errors { ExitCode::from(exit::ERRORS) } else { exit::GOOD })
}
