//! Any bytes as a numeric part program.
#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| aptc_tests::targets::protap(data));
