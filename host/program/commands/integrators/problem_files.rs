//! Benchmark problems: tops that the tests and papers of other integrators use, with reference values to 30 digits.

use serde::Deserialize;
use toytop::Orientation;
use toytop_host::input::scenario::Scenario;
use toytop_host::{Failure, excerpt};

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
    /// Reference values at the times of the source and in its body axes.
    pub samples: Vec<ReferenceSample>,
}

/// Numbers at one time to 30 digits, as texts.
#[derive(Deserialize)]
pub struct ReferenceSample {
    /// Time, s.
    pub t: String,
    /// Position of the centre of mass relative to the tip.
    pub position: [String; 3],
    /// Unit quaternion w, x, y, z from body to fixed coordinates.
    pub quaternion: [String; 4],
    /// Angular velocity along the body axes, rad/s.
    pub omega_body: [String; 3],
}

/// File of reference values.
#[derive(Deserialize)]
struct Reference {
    samples: Vec<ReferenceSample>,
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

impl Description {
    /// Rotation that takes the source's body coordinates to the core's, where the third axis is the axis of symmetry.
    pub fn body_axes(&self) -> Orientation<f64> {
        match self.symmetry_axis {
            // a quarter turn about the first axis takes the second axis to the third
            2 => Orientation::from_quaternion([1.0, 1.0, 0.0, 0.0]).normalised(),
            _ => Orientation::IDENTITY,
        }
    }
}

/// All problems.
pub fn all() -> Vec<Problem> {
    let problem = |(name, text, about, reference)| {
        const READ: &str = "a test reads the files of every problem";
        let Reference { samples } = serde_json::from_str(reference).expect(READ);
        let scenario = Scenario::parse(name, text).expect(READ);
        Problem { scenario, text, about: toml::from_str(about).expect(READ), samples }
    };
    FILES.map(problem).into()
}

/// Problem of this name.
///
/// # Errors
/// [`Failure::input`]: there is no such problem; the message lists the names.
pub fn find(name: &str) -> Result<Problem, Failure> {
    all().into_iter().find(|problem| problem.scenario.name == name).ok_or_else(|| {
        let names = FILES.map(|(name, ..)| name).join(", ");
        Failure::input(format!("must be one of {names}")).at(excerpt(name))
    })
}
