//! Any text as a part program through all Sections.
#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| aptc_tests::targets::road(data));
