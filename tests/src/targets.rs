//! What must hold for any input at all: the bodies of the fuzz targets, which tests also run over damaged
//! corpus programs.
//!
//! Each takes bytes, does its work, and panics when something is broken that the work itself would not
//! notice, such as a message that points outside its file.

use std::fmt::Debug;
use std::time::Duration;

use aptc_cldata::{
    Dialect, JsonReader, JsonWriter, Kind, Reader, Record, RecordReader as _, RecordWriter as _,
    TextOptions, TextWriter,
};
use aptc_control::{
    ClOptions, CodeOptions, Compiled, MachineChoice, Memory, Source, compile, machines, post_cl,
};
use aptc_diagnostics::{Diagnostic, FileId, codes};
use aptc_protap::Outcome;
use aptc_syntax::{FormatOptions, Interner, Options, parse};
use aptc_translate::{Interpreter, NoFiles, Step};

/// Lexer and parser: every statement and message lies within the text, on whole characters, in order.
pub fn syntax(data: &[u8]) {
    let text = String::from_utf8_lossy(data);
    for free_form in [false, true] {
        let options = Options { free_form, ..Options::default() };
        let parsed = parse(FileId(0), &text, &mut Interner::default(), &options);
        places_are_right(&text, &parsed.diagnostics);
        let mut last = 0;
        for statement in &parsed.program.statements {
            assert!(
                statement.span.start >= last,
                "statements out of order at {}",
                statement.span.start
            );
            assert!(text.get(range(statement.span.start, statement.span.end)).is_some());
            last = statement.span.start;
        }
    }
}

/// Formatter: the statements say the same, and formatted text stays as it is.
pub fn format(data: &[u8]) {
    let text = String::from_utf8_lossy(data);
    for free_form in [false, true] {
        let keep_identification = data.len() % 2 == 1;
        let options = FormatOptions { free_form, keep_identification };
        let once = aptc_syntax::format(&text, &options);
        let mut interner = Interner::default();
        let mut said = |text: &str| -> Vec<String> {
            let options = Options { free_form, ..Options::default() };
            let program = parse(FileId(0), text, &mut interner, &options).program;
            let all = program.statements.iter();
            all.map(|s| without_places(&format!("{} {:?} {:?}", s.isn, s.label, s.body))).collect()
        };
        assert_eq!(said(&text), said(&once), "formatted it says something else");
        assert_eq!(aptc_syntax::format(&once, &options), once, "formatted again it changes");
    }
}

/// The record as it is shown for debugging, without spans.
fn without_places(shown: &str) -> String {
    let mut parts = shown.split("Span {");
    let first = parts.next().unwrap_or_default().to_owned();
    parts.fold(first, |all, part| all + part.split_once('}').map_or("", |(_, rest)| rest))
}

/// Section 1: a program ends within its limits, and nothing that is no number leaves it.
pub fn section1(data: &[u8]) {
    let text = String::from_utf8_lossy(data);
    let mut options = aptc_translate::Options::default();
    let limits = &mut options.limits;
    (limits.statements, limits.array_elements, limits.points) = (5_000, 10_000, 1_000);
    let mut files = NoFiles;
    let mut program = Interpreter::new("fuzz.apt", &text, &mut files, options);
    let mut records = Vec::new();
    while let Step::Record(record) = program.step() {
        if !matches!(record.kind, aptc_protap::Kind::Text { .. }) {
            holds_numbers(&record.kind);
        }
        records.push(record);
        program.outcome(Outcome::None);
    }
    places_are_right(&text, &program.take_diagnostics());
    let written = aptc_protap::write(&records);
    let (again, complaints) = aptc_protap::read(FileId(0), &written);
    assert!(complaints.is_empty(), "its own PROTAP is not read: {complaints:?}\n{written}");
    assert_eq!(again, records, "as PROTAP text the records are others");
}

/// Reader of PROTAP text: what it takes without complaint it writes so that it reads the same again.
pub fn protap(data: &[u8]) {
    let text = String::from_utf8_lossy(data);
    let (records, complaints) = aptc_protap::read(FileId(0), &text);
    places_are_right(&text, &complaints);
    let (placed, _) = aptc_protap::read_in_place(FileId(0), &text);
    places_are_right(&text, &aptc_protap::verify(&placed));
    if complaints.is_empty() {
        let written = aptc_protap::write(&records);
        assert_eq!(aptc_protap::read(FileId(0), &written), (records, Vec::new()));
    }
}

/// Readers of CL data, in the dialect that is detected and in one that the first byte chooses: positions are numbers, and what was
/// read is written as text and as JSON lines, of which the latter give the same records again.
pub fn cldata(data: &[u8]) {
    let chosen = data.first().map(|byte| Dialect::ALL[usize::from(*byte) % Dialect::ALL.len()]);
    for dialect in [None, chosen] {
        let records = read_cl(data, dialect);
        for record in &records {
            if let Kind::Motion(motion) = &record.kind {
                holds_numbers(motion);
            }
        }
        let mut text = TextWriter::new(Vec::new(), TextOptions::default());
        let mut lines = Vec::new();
        let mut json = JsonWriter::new(&mut lines);
        for record in &records {
            text.write(record).expect("memory takes all");
            json.write(record).expect("memory takes all");
        }
        json.finish().expect("memory takes all");
        drop(json);
        let mut reader = JsonReader::new(lines.as_slice(), FileId(0));
        let (mut again, mut record) = (Vec::new(), Record::default());
        while reader.read(&mut record).expect("memory gives all") {
            again.push(record.clone());
        }
        assert_eq!(again, records, "as JSON lines the records are others");
    }
}

/// All Sections over a part program: it ends within its limits, what leaves it are numbers, and nothing is machine
/// code that disagrees with its CL data.
pub fn road(data: &[u8]) {
    let text = String::from_utf8_lossy(data);
    let mut options =
        aptc_control::Options { time: Some(Duration::from_secs(4)), ..Default::default() };
    let limits = &mut options.translate.limits;
    (limits.statements, limits.array_elements, limits.points) = (2_000, 10_000, 1_000);
    let source = Source { name: "fuzz.apt".into(), text: text.as_ref().into() };
    let compiled = compile(source, &mut Memory::default(), &options);
    places_are_right(&text, &compiled.diagnostics);
    for records in compiled.parts.iter().flat_map(|part| [&part.computed, &part.edited]) {
        let read = records.for_each(|record| {
            if let Kind::Motion(motion) = &record.kind {
                holds_numbers(motion);
            }
        });
        read.expect("so few stand in memory");
    }
    code_agrees(&compiled);
}

/// Section 4: any CL data for the machine that the first byte chooses.
pub fn post(data: &[u8]) {
    let n = usize::from(data.first().copied().unwrap_or_default());
    let machine = machines().nth(n % machines().count()).expect("the rest is less");
    let named = Some(MachineChoice::Named(machine.name.to_string()));
    let code = CodeOptions { machine: named, map: true, ..CodeOptions::default() };
    let mut open = || Ok(Box::new(std::io::Cursor::new(data.to_vec())) as Box<dyn std::io::Read>);
    let posted =
        post_cl("fuzz.cl", &mut open, ClOptions::default(), &code, &mut || Ok(Vec::<u8>::new()));
    let posted = posted.expect("memory gives and takes all");
    for text in &posted.texts {
        let text = String::from_utf8_lossy(text);
        assert!(!text.contains("NaN") && !text.contains("inf"), "{text}");
    }
    for diagnostic in &posted.compiled.diagnostics {
        assert!(!diagnostic.message.is_empty(), "{} says nothing", diagnostic.code);
    }
    code_agrees(&posted.compiled);
}

/// Reading machine code back never finds another motion than that of the CL data.
fn code_agrees(compiled: &Compiled) {
    let read_back = compiled.diagnostics.iter().find(|d| d.code == codes::NOT_THE_CL);
    assert!(read_back.is_none(), "{read_back:?}");
}

/// All records and no complaint about places; an error of the stream itself ends the reading.
fn read_cl(data: &[u8], dialect: Option<Dialect>) -> Vec<Record> {
    let (mut records, mut record) = (Vec::new(), Record::default());
    let Ok(mut reader) = Reader::open(data, dialect) else { return records };
    while let Ok(true) = reader.read(&mut record) {
        records.push(record.clone());
    }
    for diagnostic in reader.into_diagnostics() {
        assert!(!diagnostic.message.is_empty(), "{} says nothing", diagnostic.code);
    }
    records
}

/// No NaN and no infinity: they are refused at the edge of each Section.
fn holds_numbers(record: &impl Debug) {
    let shown = format!("{record:?}");
    let mut words = shown.split(|c: char| !c.is_ascii_alphanumeric());
    assert!(!words.any(|word| matches!(word, "NaN" | "inf")), "{shown}");
}

/// Every message about file 0 points at characters of `text`.
fn places_are_right(text: &str, diagnostics: &[Diagnostic]) {
    for diagnostic in diagnostics {
        let labels = diagnostic.labels.iter().map(|label| label.span);
        for span in labels.chain([diagnostic.span]).filter(|span| span.file == FileId(0)) {
            let there = text.get(range(span.start, span.end));
            assert!(there.is_some(), "{} points at {}..{}", diagnostic.code, span.start, span.end);
        }
        assert!(!diagnostic.message.is_empty(), "{} says nothing", diagnostic.code);
    }
}

fn range(start: u32, end: u32) -> std::ops::Range<usize> {
    let at = |n: u32| usize::try_from(n).expect("32 bits fit");
    at(start)..at(end)
}
