//! Catalogue of benchmark problems: tops that the tests and papers of other integrators use, with reference values to 30 digits.

use crate::Failure;
use crate::input::scenario::Scenario;
use crate::motion::propagate::Sample;
use crate::output::shown;
use serde::Deserialize;
use toytop::{Orientation, Stepper};

macro_rules! files {
    ($($name:literal)*) => { [$((
        $name,
        include_str!(concat!("../../benchmarks/", $name, "/scenario.toml")),
        include_str!(concat!("../../benchmarks/", $name, "/problem.toml")),
        include_str!(concat!("../../benchmarks/", $name, "/reference.json")),
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
pub fn all() -> Vec<Problem> {
    FILES.map(Problem::new).into()
}

/// Problem of this name.
///
/// # Errors
/// [`Failure::Input`]: there is no such problem; the message lists the names.
pub fn named(name: &str) -> Result<Problem, Failure> {
    let files = FILES.into_iter().find(|(known, ..)| *known == name);
    files.map(Problem::new).ok_or_else(|| {
        let names = FILES.map(|(name, ..)| name).join(", ");
        Failure::Input(format!("{}: must be one of {names}", shown(name)))
    })
}

/// Motion with its source and reference values.
pub struct Problem {
    /// Scenario of the motion.
    pub scenario: Scenario,
    /// File of the scenario.
    pub text: &'static str,
    /// File that describes the problem.
    pub about: Description,
    /// Values to 30 digits, at the source's times.
    pub references: Vec<Reference>,
}

/// File that describes a problem. The third fixed axis points up in all sources.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Description {
    /// Title of the problem.
    pub title: String,
    /// Paper or program that posed it.
    pub source: String,
    /// Number of the source's body axis that points from the tip to the centre of mass: 2 or 3.
    pub symmetry_axis: u64,
    /// Distance from the tip to the centre of mass, in which positions are computed.
    pub length: f64,
    /// Length of a run, in the unit of time.
    pub seconds: f64,
    /// Programs that use the problem, one sentence for each.
    pub used_by: Vec<String>,
    /// Values that others printed.
    #[serde(default)]
    pub printed: Vec<Printed>,
}

/// Value that another program or paper printed.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Printed {
    /// Program or paper that printed it, and its method.
    pub by: String,
    /// Time, as text.
    pub t: String,
    /// Name of the quantity of these numbers: position, quaternion, omega_body, energy or u.
    pub quantity: String,
    /// Numbers, in the source's conventions.
    pub values: Vec<f64>,
}

/// File of reference values.
#[derive(Deserialize)]
struct References {
    samples: Vec<Reference>,
}

/// Values to 30 digits at one time, in the source's conventions.
#[derive(Deserialize)]
pub struct Reference {
    /// Time, as text.
    pub t: String,
    /// Position of the centre of mass relative to the tip.
    pub position: [String; 3],
    /// Quaternion w, x, y, z from body to fixed axes.
    pub quaternion: [String; 4],
    /// Angular velocity along the body axes.
    pub omega_body: [String; 3],
}

impl Problem {
    fn new((name, text, description, references): Files) -> Self {
        const READ: &str = "a test reads the files of every problem";
        let References { samples: references } = serde_json::from_str(references).expect(READ);
        let scenario = Scenario::parse(name, text).expect(READ);
        Self { scenario, text, about: toml::from_str(description).expect(READ), references }
    }

    /// Name of the problem on the command line.
    pub fn name(&self) -> &str {
        &self.scenario.name
    }

    /// Greatest difference of the components of a printed value from the reference. A quaternion has the sign that is nearer to the
    /// reference. `None` if the catalogue has no reference for the value.
    pub fn off(&self, Printed { t, quantity, values, .. }: &Printed) -> Option<f64> {
        let reference = self.references.iter().find(|reference| reference.t == *t);
        let digits = |texts: &[String]| texts.iter().filter_map(|text| text.parse().ok()).collect();
        let exact = match &**quantity {
            "energy" => vec![self.scenario.motion.first_integrals().h],
            "u" => vec![Stepper::<f64>::new(&self.scenario.motion).attitude_state().u()],
            "position" => digits(&reference?.position),
            "quaternion" => digits(&reference?.quaternion),
            _ => digits(&reference?.omega_body),
        };
        let distance = |sign: f64| {
            let pairs = exact.iter().zip(values);
            pairs.map(|(exact, value)| (sign * value - exact).abs()).fold(0.0, f64::max)
        };
        let off = distance(1.0);
        Some(if quantity == "quaternion" { off.min(distance(-1.0)) } else { off })
    }

    /// Rotation P that takes the source's body coordinates to those of the core, whose third axis is the axis of symmetry.
    pub fn to_core(&self) -> Orientation<f64> {
        match self.about.symmetry_axis {
            // a quarter turn about the first axis takes the second axis to the third
            2 => Orientation::from_quaternion([1.0, 1.0, 0.0, 0.0]).normalised(),
            _ => Orientation::IDENTITY,
        }
    }

    /// Numbers of a sample of the core in the source's conventions: position of the centre of mass relative to the tip, quaternion w, x,
    /// y, z from body to fixed axes, and angular velocity along the body axes.
    pub fn values(&self, sample: &Sample) -> Vec<f64> {
        let orientation = sample.orientation().compose(&self.to_core());
        let position = sample.orientation().axis().map(|x| self.about.length * x);
        let omega = orientation.inverse().adjoint(sample.omega);
        [&position[..], &orientation.quaternion(), &omega].concat()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_file_is_read_whole() {
        for problem in all() {
            let name = problem.name();
            assert!(!problem.references.is_empty() && !problem.about.used_by.is_empty(), "{name}");
            for reference in &problem.references {
                let digits = |text: &String| text.trim_start_matches(['-', '0', '.']).replace('.', "").len();
                assert_eq!(reference.quaternion.iter().map(digits).max(), Some(30), "{name}");
            }
            for Printed { t, quantity, values, .. } in &problem.about.printed {
                let components = match &**quantity {
                    "position" | "omega_body" => 3,
                    "quaternion" => 4,
                    "energy" | "u" => 1,
                    other => panic!("{name}: {other}"),
                };
                assert_eq!(values.len(), components, "{name}");
                let known = problem.references.iter().any(|reference| reference.t == *t);
                assert!(t == "0" || known, "{name}: {t}");
            }
        }
        assert!(named("nothing").is_err());
    }
}
