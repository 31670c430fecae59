//! Any bytes as a part program: lexer and parser.
#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| aptc_tests::targets::syntax(data));
