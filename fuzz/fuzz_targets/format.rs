//! Any bytes through the formatter.
#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| aptc_tests::targets::format(data));
