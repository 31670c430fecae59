//! Any bytes as a part program: Section 1 carries it out within its limits.
#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| aptc_tests::targets::section1(data));
