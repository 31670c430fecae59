//! Damaged corpus programs: cut short anywhere, or with a byte changed. Messages are welcome, panics not.

use std::fs;

use aptc_control::{
    Memory, Options, RecordWriter as _, Source, TextOptions, TextWriter, Verify, compile,
};
use aptc_golden::{Case, discover};
use aptc_testkit::repository;
use aptc_tests::targets;

/// Every program of the corpus, and how much less densely it is tried: those that show a mistake are variations of
/// a few.
fn programs() -> Vec<(Vec<u8>, usize)> {
    let cases = discover(&repository().join("corpus"), "").expect("the corpus can be read");
    assert!(cases.len() > 80);
    let read = |case: &Case| {
        let text = fs::read(&case.program).expect("a program can be read");
        (text, if case.name.starts_with("errors/") { 37 } else { 1 })
    };
    cases.iter().map(read).collect()
}

/// Runs `check` over every program cut short after each byte.
fn truncated(check: fn(&[u8]), step: usize) {
    for (program, sparse) in programs() {
        (0..program.len()).step_by(step * sparse).for_each(|length| check(&program[..length]));
    }
}

/// Runs `check` over every program with each `step`-th byte replaced by one that means something to a lexer,
/// or does not belong in a program.
fn changed(check: fn(&[u8]), step: usize) {
    let bytes = b"$(),/=*+-.'0A \n\r\t\0\x7f\xff";
    for (program, sparse) in programs() {
        for (at, &byte) in (0..program.len()).zip(bytes.iter().cycle()).step_by(step * sparse) {
            let mut damaged = program.clone();
            damaged[at] = byte;
            check(&damaged);
        }
    }
}

#[test]
fn truncated_programs_parse() {
    truncated(targets::syntax, 1);
}

#[test]
fn programs_with_a_changed_byte_parse() {
    changed(targets::syntax, 1);
}

#[test]
fn damaged_programs_are_formatted() {
    truncated(targets::format, 13);
    changed(targets::format, 13);
}

#[test]
fn truncated_programs_translate() {
    truncated(targets::section1, 1);
}

#[test]
fn programs_with_a_changed_byte_translate() {
    changed(targets::section1, 1);
}

#[test]
fn damaged_programs_are_read_as_cl_data() {
    truncated(targets::cldata, 17);
    changed(targets::cldata, 17);
}

#[test]
fn damaged_programs_take_the_whole_road() {
    truncated(targets::road, 499);
    changed(targets::road, 499);
}

#[test]
fn damaged_cl_data_are_posted() {
    changed(targets::post, 499);
    for (program, _) in programs() {
        let cl = cl_data(&program);
        for (at, machine) in (0..cl.len()).step_by(997).zip(0..) {
            let mut damaged = cl.clone();
            damaged[at] = b"$(),/=*+-.'0A \n"[at % 15];
            // The first byte chooses the machine; a blank line more harms nothing.
            damaged.insert(0, machine);
            damaged.insert(1, b'\n');
            targets::post(&damaged);
        }
    }
}

/// What a program has in the way of CL data.
fn cl_data(program: &[u8]) -> Vec<u8> {
    let text = String::from_utf8_lossy(program);
    let source = Source { name: "part.apt".into(), text: text.as_ref().into() };
    let options = Options { verify: Verify::Off, post: false, plot: false, ..Options::default() };
    let compiled = compile(source, &mut Memory::default(), &options);
    let mut bytes = Vec::new();
    let mut writer = TextWriter::new(&mut bytes, TextOptions::default());
    for part in &compiled.parts {
        let read = part.edited.for_each(|record| writer.write(record).expect("memory takes all"));
        read.expect("so few stand in memory");
    }
    writer.finish().expect("memory takes all");
    drop(writer);
    bytes
}
