//! Problem of the catalogue, from its three files.

use super::Files;
use crate::Failure;
use crate::input::scenario::Scenario;
use crate::motion::propagate::Sample;
use serde::Deserialize;
use toytop::{Orientation, Stepper};

/// Motion with its source, conventions and reference values.
pub struct Problem {
    /// Scenario of the motion.
    pub scenario: Scenario,
    /// File of the scenario.
    pub text: &'static str,
    /// Title of the problem.
    pub title: String,
    /// Paper or program that posed it.
    pub source: String,
    /// Body axes and length of its source.
    pub conventions: Conventions,
    /// Length of a run, in the unit of time.
    pub seconds: f64,
    /// Programs that use the problem, one sentence for each.
    pub used_by: Vec<String>,
    /// Values that others printed.
    pub printed: Vec<Printed>,
    /// Values to 30 digits, at the source's times.
    pub references: Vec<Reference>,
}

/// File that describes a problem.
#[derive(Deserialize)]
struct Description {
    title: String,
    source: String,
    #[serde(flatten)]
    conventions: Conventions,
    seconds: f64,
    used_by: Vec<String>,
    #[serde(default)]
    printed: Vec<Printed>,
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
    pub position: Vec<String>,
    /// Quaternion w, x, y, z from body to fixed axes.
    pub quaternion: Vec<String>,
    /// Angular velocity along the body axes.
    pub omega_body: Vec<String>,
}

impl Problem {
    pub fn read((name, text, description, references): &Files) -> Result<Self, Failure> {
        let broken =
            |error: &dyn std::fmt::Display| Failure::Tool(format!("the catalogue's {name}: {error}"));
        let Description { title, source, conventions, seconds, used_by, printed } =
            toml::from_str(description).map_err(|error| broken(&error))?;
        let References { samples: references } =
            serde_json::from_str(references).map_err(|error| broken(&error))?;
        let scenario = Scenario::parse(name, text)?;
        Ok(Self { scenario, text, title, source, conventions, seconds, used_by, printed, references })
    }

    /// Name of the problem on the command line.
    pub fn name(&self) -> &str {
        &self.scenario.name
    }

    /// Greatest difference of the components of a printed value from the reference. A quaternion has the sign that is nearer to the
    /// reference. `None` if the catalogue has no reference for the value.
    pub fn off(&self, printed: &Printed) -> Option<f64> {
        let there = self.references.iter().find(|reference| reference.t == printed.t);
        let digits = |texts: &[String]| texts.iter().filter_map(|text| text.parse().ok()).collect();
        let reference = match &*printed.quantity {
            "energy" => vec![self.scenario.motion.first_integrals().h],
            "u" => vec![Stepper::<f64>::new(&self.scenario.motion).attitude_state().u()],
            "position" => digits(&there?.position),
            "quaternion" => digits(&there?.quaternion),
            _ => digits(&there?.omega_body),
        };
        let distance = |sign: f64| {
            let pairs = reference.iter().zip(&printed.values);
            pairs.map(|(reference, value)| (sign * value - reference).abs()).fold(0.0, f64::max)
        };
        let off = distance(1.0);
        Some(if printed.quantity == "quaternion" { off.min(distance(-1.0)) } else { off })
    }
}

/// Body axes and length of a source. The third fixed axis points up in all of them.
#[derive(Clone, Copy, Deserialize)]
pub struct Conventions {
    /// Number of the body axis that points from the tip to the centre of mass: 2 or 3.
    pub symmetry_axis: usize,
    /// Distance from the tip to the centre of mass, in which positions are computed.
    pub length: f64,
}

impl Conventions {
    /// Rotation P that takes the source's body coordinates to those of the core, whose third axis is the axis of symmetry.
    pub fn to_core(self) -> Orientation<f64> {
        match self.symmetry_axis {
            // a quarter turn about the first axis takes the second axis to the third
            2 => Orientation::from_quaternion([1.0, 1.0, 0.0, 0.0]).normalised(),
            _ => Orientation::IDENTITY,
        }
    }

    /// Numbers of a sample of the core in the source's conventions: position of the centre of mass relative to the tip, quaternion w, x,
    /// y, z from body to fixed axes, and angular velocity along the body axes.
    pub fn values(&self, sample: &Sample) -> Vec<f64> {
        let core = sample.orientation();
        let orientation = core.compose(&self.to_core());
        let position = core.axis().map(|x| self.length * x);
        let omega = orientation.inverse().adjoint(sample.omega);
        [&position[..], &orientation.quaternion(), &omega].concat()
    }
}

#[cfg(test)]
mod tests {
    use crate::benchmarks;

    #[test]
    fn every_file_is_read_whole() {
        for problem in benchmarks::all().unwrap() {
            let name = problem.name();
            assert!(!problem.references.is_empty() && !problem.used_by.is_empty(), "{name}");
            for reference in &problem.references {
                let counts =
                    [&reference.position, &reference.quaternion, &reference.omega_body].map(Vec::len);
                assert_eq!(counts, [3, 4, 3], "{name}");
                let longest = reference
                    .quaternion
                    .iter()
                    .map(|text| text.trim_start_matches(['-', '0', '.']).replace('.', "").len())
                    .max();
                assert_eq!(longest, Some(30), "{name}");
            }
            for printed in &problem.printed {
                let components = match &*printed.quantity {
                    "position" | "omega_body" => 3,
                    "quaternion" => 4,
                    "energy" | "u" => 1,
                    other => panic!("{name}: {other}"),
                };
                assert_eq!(printed.values.len(), components, "{name}");
                assert!(
                    printed.t == "0" || problem.references.iter().any(|reference| reference.t == printed.t),
                    "{name}: {}",
                    printed.t
                );
            }
        }
        assert!(benchmarks::named("nothing").is_err());
    }
}
