//! Catalogue of benchmark problems: tops that the tests and papers of other integrators use, with reference values to 30 digits.
//!
//! | module | contents |
//! |---|---|
//! | [`problem`] | problem with scenario, conventions of its source, reference values, and values that others printed |
//! | [`conventions`] | body axes and quantities of a source |
//! | [`compare`] | errors of printed values |

pub(crate) mod compare;
pub(crate) mod conventions;
pub(crate) mod problem;

pub(crate) use problem::{Printed, Problem, Reference};

use crate::Failure;

macro_rules! files {
    ($($name:literal)*) => { [$((
        $name,
        include_str!(concat!("../benchmarks/", $name, "/scenario.toml")),
        include_str!(concat!("../benchmarks/", $name, "/problem.toml")),
        include_str!(concat!("../benchmarks/", $name, "/reference.json")),
    )),*] };
}

/// Name, scenario, description and reference values of each problem.
const FILES: [(&str, &str, &str, &str); 9] = files! {
    "bruls_cardona" "simo_wong" "kinon_betsch" "diffman" "parker" "critical_spin" "springborn_cusp" "springborn_loops"
    "drake_cylinder"
};

/// Names of all problems.
#[must_use]
pub(crate) fn names() -> Vec<&'static str> {
    FILES.iter().map(|(name, ..)| *name).collect()
}

/// Scenario file of a problem, as text.
///
/// # Errors
/// [`Failure::Input`]: there is no problem of this name.
pub(crate) fn scenario(name: &str) -> Result<&'static str, Failure> {
    let found = FILES.iter().find(|(known, ..)| *known == name);
    found.map(|(_, scenario, ..)| *scenario).ok_or_else(|| unknown(name))
}

/// All problems.
///
/// # Errors
/// None: a test reads every file.
pub(crate) fn all() -> Result<Vec<Problem>, Failure> {
    FILES
        .iter()
        .map(|(name, scenario, about, reference)| Problem::read(name, scenario, about, reference))
        .collect()
}

/// Problem of this name.
///
/// # Errors
/// [`Failure::Input`]: there is no such problem; the message lists the names.
pub(crate) fn named(name: &str) -> Result<Problem, Failure> {
    match FILES.iter().find(|(known, ..)| *known == name) {
        Some((name, scenario, about, reference)) => Problem::read(name, scenario, about, reference),
        None => Err(unknown(name)),
    }
}

fn unknown(name: &str) -> Failure {
    Failure::Input(format!("{}: must be one of {}", crate::output::shown(name), names().join(", ")))
}
