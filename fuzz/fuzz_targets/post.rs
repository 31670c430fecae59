//! Any CL data for any machine.
#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| aptc_tests::targets::post(data));
