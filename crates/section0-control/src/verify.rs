//! The proof of a program's path, or of a CL file against the surfaces of the program.

use std::io::Cursor;

use aptc_cldata::{Dialect, Kind, Reader, Record, RecordReader as _, detect};
use aptc_diagnostics::{Diagnostic, SourceMap, Span, codes};
use aptc_geometry::Vec3;
use aptc_verify::{Astray, Marks, Matched, Verifier, matched, times_as_large};

use crate::compile::no_room;
use crate::proof::{PathProof, effort, positions};
use crate::tools::exchange;
use crate::{Compiled, Options, Source, Verify, World, compile};

/// A CL file to be held against a program.
#[derive(Clone, Debug)]
pub struct ClFile {
    /// Its name.
    pub name: String,
    /// Its content, in any dialect.
    pub bytes: Vec<u8>,
}

/// Compiles the program up to Section 2 and judges its path, or that of the file in its place. The
/// certificates stand in the parts.
pub fn verify(
    source: Source,
    world: &mut dyn World,
    options: &Options,
    file: Option<ClFile>,
) -> Compiled {
    let own = Options { post: false, plot: false, ..options.clone() };
    let Some(file) = file else { return compile(source, world, &own) };
    let own = Options { verify: Verify::Off, ..own };
    let mut compiled = compile(source, world, &own);
    let (programs, marks, mut said) = read(&file, &mut compiled.sources);
    if programs.len() != compiled.parts.len() {
        let (n, m) = (programs.len(), compiled.parts.len());
        let message = format!(
            "{} has {n} part program{}, the source {m}",
            file.name,
            if n == 1 { "" } else { "s" }
        );
        said.push(Diagnostic::error(codes::UNMATCHED, Span::default(), message));
    }
    for (part, records) in compiled.parts.iter_mut().zip(&programs) {
        let computed = match part.computed.to_vec() {
            Ok(records) => records,
            Err(e) => {
                said.push(no_room(&e));
                continue;
            }
        };
        match matched(&computed, records, marks) {
            Ok(found) if found.is_of_another() => {
                said.push(of_another(&file.name, &found, &computed, records));
            }
            Ok(mut found) => {
                said.extend(exchange(
                    &mut found.records,
                    records,
                    (&file.name, detect(&file.bytes)),
                ));
                let n = found.records.iter().map(positions).sum();
                let verifier = Verifier::foreign(effort(n, options.verify));
                let mut judge = PathProof::new(verifier, options.threads);
                for record in &found.records {
                    judge.push(record);
                }
                let (mut certificate, diagnostics) = judge.finish();
                certificate.unmatched = found.missing.len() as u64;
                certificate.extra = found.extra;
                part.certificate = Some(certificate);
                said.extend(diagnostics);
                said.extend(found.missing.iter().map(|origin| {
                    let message = format!("no motion of {} is that of this statement", file.name);
                    Diagnostic::error(codes::UNMATCHED, origin.span, message)
                        .within(origin.trace.clone())
                }));
                if found.extra > 0 {
                    let message = format!(
                        "{} positions of {} belong to no motion of the program",
                        found.extra, file.name
                    );
                    said.push(Diagnostic::error(codes::UNMATCHED, Span::default(), message));
                }
            }
            Err(why) => {
                said.push(Diagnostic::error(codes::UNMATCHED, Span::default(), why));
            }
        }
    }
    compiled.diagnostics.extend(said);
    compiled
}

/// The one message about a file of another program.
fn of_another(name: &str, found: &Matched, computed: &[Record], records: &[Record]) -> Diagnostic {
    let span = found.astray.as_ref().map_or_else(Span::default, |a| a.origin.span);
    let partno = |records: &[Record]| {
        records.iter().find_map(|r| match &r.kind {
            Kind::Text { word, text } if word == "PARTNO" => Some(text.trim().to_owned()),
            _ => None,
        })
    };
    let [at_home, motions] = found.at_home;
    let what = match (partno(computed), partno(records)) {
        (Some(here), Some(there)) if here != there => {
            format!("{name} is of another program: its part is {there}, not {here}")
        }
        _ => format!(
            "{name} is not of this program: {at_home} of {motions} motions end where it has them"
        ),
    };
    let mut error = Diagnostic::error(codes::UNMATCHED, span, what);
    if let Some(Astray { origin, here, there }) = &found.astray {
        let here = place(*here);
        error = error.within(origin.trace.clone()).label(match there {
            Some(there) => format!("this ends at {here} and in the file at {}", place(*there)),
            None => format!("this ends at {here}, where the file does not go"),
        });
    }
    let times = times_as_large(computed, records);
    if [25.4, 1.0 / 25.4].iter().any(|inch| (times / inch - 1.0).abs() < 0.01) {
        error = error
            .help(format!("its path is {times:.3} times as large: it lacks UNITS, or has another"));
    }
    error
}

fn place(p: Vec3) -> String {
    let number = |x: f64| {
        let text = format!("{x:.4}");
        let text = text.trim_end_matches('0').trim_end_matches('.');
        if text == "-0" { "0".to_owned() } else { text.to_owned() }
    };
    format!("{},{},{}", number(p.x), number(p.y), number(p.z))
}

/// The part programs of the file, and how its records say where they come from.
fn read(file: &ClFile, sources: &mut SourceMap) -> (Vec<Vec<Record>>, Marks, Vec<Diagnostic>) {
    let dialect = detect(&file.bytes);
    let text = if dialect.is_text() {
        String::from_utf8_lossy(&file.bytes).into_owned()
    } else {
        String::new()
    };
    let id = sources.add(file.name.clone(), text);
    let mut reader =
        Reader::open_file(Cursor::new(&file.bytes), Some(dialect), id).expect("memory can be read");
    let mut programs: Vec<Vec<Record>> = Vec::new();
    let mut open = false;
    let mut record = Record::default();
    while reader.read(&mut record).expect("memory can be read") {
        if !open {
            programs.push(Vec::new());
        }
        open = !matches!(record.kind, Kind::Fini);
        programs.last_mut().expect("one is there").push(record.clone());
    }
    let marks = match dialect {
        Dialect::Tape | Dialect::Clfile => Marks::Statements,
        _ if reader.is_marked() => Marks::Lines,
        _ => Marks::None,
    };
    (programs, marks, reader.into_diagnostics())
}
