//! Benchmark problems: tops that the tests and papers of other integrators use, with reference values to 30 digits.

use serde::Deserialize;
use serde_json::Value;
use toytop_host::Failure;
use toytop_host::input::scenario::Scenario;
use toytop_host::input::text_file::excerpt;

macro_rules! files {
    ($($name:literal)*) => { [$((
        $name,
        include_str!(concat!("../../../problems/", $name, "/scenario.toml")),
        include_str!(concat!("../../../problems/", $name, "/problem.toml")),
        include_str!(concat!("../../../problems/", $name, "/reference.json")),
    )),*] };
}

/// Name, scenario, description and reference values of each problem.
const FILES: [(&str, &str, &str, &str); 9] = files! {
    "bruls_cardona" "simo_wong" "kinon_betsch" "diffman" "parker" "critical_spin" "springborn_cusp" "springborn_loops"
    "drake_cylinder"
};

/// Motion with its source and reference values. The third fixed axis points up in all sources.
pub struct Problem {
    /// Scenario of the motion.
    pub scenario: Scenario,
    /// File of the scenario.
    pub text: &'static str,
    /// Source of the problem.
    pub about: Description,
    /// Values to 30 digits as texts, at the times of the source and in its body axes.
    pub samples: Vec<Value>,
}

/// File that describes a problem.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Description {
    /// Title of the problem.
    pub title: String,
    /// Paper or program that posed it.
    pub source: String,
    /// Number of the source's body axis that points from the tip to the centre of mass: 2 or 3.
    pub symmetry_axis: u8,
    /// Distance from the tip to the centre of mass, in which positions are computed.
    pub length: f64,
    /// Programs that use the problem, one sentence for each.
    pub used_by: Vec<String>,
}

/// All problems.
pub fn all() -> Vec<Problem> {
    let problem = |(name, text, about, reference)| {
        const READ: &str = "a test reads the files of every problem";
        let reference: Value = serde_json::from_str(reference).expect(READ);
        let scenario = Scenario::parse(name, text).expect(READ);
        let samples = reference["samples"].as_array().expect(READ).clone();
        Problem { scenario, text, about: toml::from_str(about).expect(READ), samples }
    };
    FILES.map(problem).into()
}

/// Problem of this name.
///
/// # Errors
/// [`Failure::Input`]: there is no such problem; the message lists the names.
pub fn find(name: &str) -> Result<Problem, Failure> {
    all().into_iter().find(|problem| problem.scenario.name == name).ok_or_else(|| {
        let names = FILES.map(|(name, ..)| name).join(", ");
        Failure::Input(format!("{}: must be one of {names}", excerpt(name)))
    })
}
