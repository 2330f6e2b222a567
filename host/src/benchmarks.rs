//! Catalogue of benchmark problems: tops that the tests and papers of other integrators use, with reference values to 30 digits.
//!
//! | module | contents |
//! |---|---|
//! | [`problem`] | problem with scenario, body axes and quantities of its source, reference values, and values that others printed |

pub mod problem;

pub use problem::{Printed, Problem, Reference};

use crate::Failure;

macro_rules! files {
    ($($name:literal)*) => { [$((
        $name,
        include_str!(concat!("../benchmarks/", $name, "/scenario.toml")),
        include_str!(concat!("../benchmarks/", $name, "/problem.toml")),
        include_str!(concat!("../benchmarks/", $name, "/reference.json")),
    )),*] };
}

/// Name, scenario, description and reference values of a problem.
type Files = (&'static str, &'static str, &'static str, &'static str);

/// Files of each problem.
const FILES: [Files; 9] = files! {
    "bruls_cardona" "simo_wong" "kinon_betsch" "diffman" "parker" "critical_spin" "springborn_cusp" "springborn_loops"
    "drake_cylinder"
};

/// All problems.
///
/// # Errors
/// None: a test reads every file.
pub fn all() -> Result<Vec<Problem>, Failure> {
    FILES.iter().map(Problem::read).collect()
}

/// Problem of this name.
///
/// # Errors
/// [`Failure::Input`]: there is no such problem; the message lists the names.
pub fn named(name: &str) -> Result<Problem, Failure> {
    let files = FILES.iter().find(|(known, ..)| *known == name).ok_or_else(|| {
        let names = FILES.map(|(name, ..)| name).join(", ");
        Failure::Input(format!("{}: must be one of {names}", crate::output::shown(name)))
    })?;
    Problem::read(files)
}
