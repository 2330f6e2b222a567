#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| toytop_tests::any_input::run("table", bytes));
