//! Hostile input: functions that take any bytes, build what these describe, and assert what must hold of it whatever the
//! bytes were. No panic, no hang, and no NaN or infinity out of anything that was constructed.
//!
//! cargo-fuzz looks for bytes that break one of them (`cargo xtask fuzz`, `tests/fuzz`); the suite runs them over the
//! committed seeds and over random bytes.

mod bake;
mod ephemeris;
mod fixed;
mod input;
mod launch;
#[cfg(feature = "host")]
mod scenario;
mod sound;

/// A function that any bytes may be given to.
pub struct Target {
    /// That of its seeds' folder and of its program in `tests/fuzz`.
    pub name: &'static str,
    /// Panics if what must hold does not.
    pub run: fn(&[u8]),
}

/// All of them.
pub const TARGETS: &[Target] = &[
    #[cfg(feature = "host")]
    Target { name: "scenario", run: scenario::run },
    Target { name: "launch", run: launch::run },
    Target { name: "ephemeris", run: ephemeris::run },
    Target { name: "fixed", run: fixed::run },
    Target { name: "bake", run: bake::run },
];

/// Runs the one so named.
///
/// # Panics
/// If there is none, or as the target does.
pub fn run(name: &str, bytes: &[u8]) {
    let target = TARGETS.iter().find(|target| target.name == name);
    (target.unwrap_or_else(|| panic!("no target {name}")).run)(bytes);
}
