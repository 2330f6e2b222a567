//! Options of several commands: method, scalars, name of a file, times, ticks.

use crate::arguments::values::Values;
use clap::ValueEnum;
use std::path::PathBuf;
use toytop_host::motion::Scalar;

/// Method that computes a motion.
#[derive(Clone, Copy, PartialEq, ValueEnum)]
pub enum Method {
    /// Table of the core: any time at the same cost
    // astronomers call a table of positions an ephemeris
    #[value(name = "ephemeris")]
    Table,
    /// Stepper of the core
    Stepper,
    /// Numerical integration of the full 3-D equations
    Full,
    /// Elliptic or elementary solution of the paper, for a motion that has one (otherwise exit code 3)
    ClosedForm,
}

impl Method {
    /// Name on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::Table => "ephemeris",
            Self::Stepper => "stepper",
            Self::Full => "full",
            Self::ClosedForm => "closed-form",
        }
    }
}

/// Scalar types of a list.
#[derive(Clone)]
pub struct Scalars(pub Vec<Scalar>);

/// Scalar types of a text such as `f64,q31` or `all`, each once, in the order of their declaration.
pub fn scalars(text: &str) -> Result<Scalars, &'static str> {
    let names: Vec<_> = text.split(',').collect();
    let is_known = |name: &&str| *name == "all" || Scalar::ALL.iter().any(|scalar| scalar.name() == *name);
    if !names.iter().all(is_known) {
        return Err("must be a list of f64, f32, q31, q15, all");
    }
    let is_chosen = |scalar: &Scalar| names.contains(&scalar.name()) || names.contains(&"all");
    Ok(Scalars(Scalar::ALL.into_iter().filter(is_chosen).collect()))
}

/// Endings of a picture.
pub const PICTURE: &[&str] = &[".svg", ".png"];

/// Parser of the name of a file with one of these endings.
pub fn ending_in(endings: &'static [&'static str]) -> impl Fn(&str) -> Result<PathBuf, String> + Clone {
    move |name| {
        if endings.iter().any(|ending| name.to_lowercase().ends_with(ending)) {
            Ok(name.into())
        } else {
            Err(format!("must end in {}", endings.join(" or ")))
        }
    }
}

/// Parser of the name of a file or folder other than standard output, which has the report.
pub fn not_stdout(name: &str) -> Result<PathBuf, &'static str> {
    if name == "-" { Err("must not be -, because stdout has the report") } else { Ok(name.into()) }
}

/// Two times, LOW..HIGH, s.
pub fn time_range(text: &str) -> Result<[f64; 2], &'static str> {
    match text.parse() {
        Ok(Values::Range { low, high, log: false, count: None }) => Ok([low, high]),
        _ => Err("must be LOW..HIGH, two times in s"),
    }
}

/// Tick rate [A, B] of `A/B`: A ticks in B seconds.
pub fn hertz(text: &str) -> Result<[u32; 2], &'static str> {
    let (ticks, seconds) = text.split_once('/').unwrap_or((text, "1"));
    let whole = |text: &str| text.parse::<u32>().ok().filter(|n| *n > 0);
    whole(ticks)
        .zip(whole(seconds))
        .map(|(ticks, seconds)| [ticks, seconds])
        .ok_or("must be N or A/B, whole numbers from 1 to 4294967295, as 44100/2")
}
