//! Damaged corpus programs: cut short anywhere, or with a byte changed. Messages are welcome, panics not.

use std::fs;

use aptc_testkit::repository;
use aptc_tests::golden::discover;
use aptc_tests::targets;

fn programs() -> Vec<Vec<u8>> {
    let cases = discover(&repository().join("corpus"), "").expect("the corpus can be read");
    assert!(!cases.is_empty());
    cases.iter().map(|case| fs::read(case.program()).expect("a program can be read")).collect()
}

#[test]
fn truncated_programs_parse() {
    for program in programs() {
        for length in 0..program.len() {
            targets::syntax(&program[..length]);
        }
    }
}

#[test]
fn programs_with_a_changed_byte_parse() {
    // Bytes that mean something to the lexer, and some that do not belong in a program.
    let bytes = b"$(),/=*+-.'0A \n\r\t\0\x7f\xff";
    for program in programs() {
        for (at, &byte) in (0..program.len()).zip(bytes.iter().cycle()) {
            let mut damaged = program.clone();
            damaged[at] = byte;
            targets::syntax(&damaged);
        }
    }
}
