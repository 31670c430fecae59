//! Any bytes as CL data of every dialect.
#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| aptc_tests::targets::cldata(data));
