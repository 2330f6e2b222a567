#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| toytop_tests::fuzz_targets::run("launch", bytes));
