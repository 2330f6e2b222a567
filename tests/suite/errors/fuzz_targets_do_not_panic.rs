//! The targets of the fuzzer run on the inputs that it has found so far and on random bytes, and do not panic.

use proptest::prelude::*;
use std::fs;
use std::path::Path;
use toytop_tests::fuzz_targets::TARGETS;

/// Runs a target; its panic names the input and the call that repeats it.
fn hold(name: &str, run: fn(&[u8]), what: &str, bytes: &[u8]) {
    if let Err(panic) = std::panic::catch_unwind(|| run(bytes)) {
        eprintln!("{name}: {what}: {bytes:?}");
        std::panic::resume_unwind(panic);
    }
}

#[test]
fn no_committed_seed_panics() {
    for target in TARGETS {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("fuzz/seeds").join(target.name);
        let seeds: Vec<_> = fs::read_dir(&folder).unwrap().map(|entry| entry.unwrap().path()).collect();
        assert!(seeds.len() >= 10, "{} seeds in {}", seeds.len(), folder.display());
        for seed in seeds {
            let bytes = fs::read(&seed).unwrap();
            hold(target.name, target.run, &seed.display().to_string(), &bytes);
        }
    }
}

#[test]
fn no_random_bytes_panic() {
    let mut runner = proptest::test_runner::TestRunner::new(crate::motion::random_tops::config(600));
    let bytes = prop::collection::vec(any::<u8>(), 0..400);
    runner
        .run(&bytes, |bytes| {
            TARGETS.iter().for_each(|target| hold(target.name, target.run, "random bytes", &bytes));
            Ok(())
        })
        .unwrap();
}
