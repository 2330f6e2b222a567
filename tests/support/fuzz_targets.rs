//! Targets of the fuzzer: functions that accept any bytes, construct what the bytes describe, and assert the properties that
//! must always hold: no panic, no endless loop, and no NaN or infinity from anything that was constructed.
//!
//! cargo-fuzz searches for bytes that violate one of them (`cargo fuzz`, `tests/fuzz`). The suite runs them on
//! the committed seeds and on random bytes.

mod input;
pub mod invariants;
#[cfg(feature = "host")]
mod scenario;
mod table;

/// Function that accepts any bytes.
pub struct Target {
    /// Name of the folder of its seeds and of its program in `tests/fuzz`.
    pub name: &'static str,
    /// Function that panics if a property is violated.
    pub run: fn(&[u8]),
}

/// All targets.
pub const TARGETS: &[Target] = &[
    #[cfg(feature = "host")]
    Target { name: "scenario", run: scenario::run },
    Target { name: "launch", run: launch },
    Target { name: "table", run: table::run },
    Target { name: "fixed", run: table::run_fixed },
];

/// Checks a motion from arbitrary bits.
fn launch(bytes: &[u8]) {
    let mut input = input::Input::new(bytes);
    match input.motion() {
        Ok(motion) => invariants::motion(&motion, &mut input),
        Err(error) => assert!(!error.parameter().is_empty() && !error.allowed().is_empty()),
    }
}

/// Runs the target of this name.
///
/// # Panics
/// If there is no such target, or if the target panics.
pub fn run(name: &str, bytes: &[u8]) {
    let target = TARGETS.iter().find(|target| target.name == name);
    (target.unwrap_or_else(|| panic!("no target {name}")).run)(bytes);
}
