#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| toytop_tests::random_bytes::run("launch", bytes));
