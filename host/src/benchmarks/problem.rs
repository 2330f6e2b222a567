//! Problem of the catalogue, from its three files.

use super::Files;
use super::conventions::{Conventions, Quantity};
use crate::Failure;
use crate::input::scenario::Scenario;
use serde::Deserialize;
use toytop::Stepper;

/// Motion with its source, conventions and reference values.
#[derive(Clone, Debug)]
pub(crate) struct Problem {
    /// Scenario of the motion.
    pub(crate) scenario: Scenario,
    /// Title of the problem.
    pub(crate) title: String,
    /// Paper or program that posed it.
    pub(crate) source: String,
    /// Body axes and length of its source.
    pub(crate) conventions: Conventions,
    /// Length of a run, in the unit of time.
    pub(crate) seconds: f64,
    /// Programs that use the problem, one sentence for each.
    pub(crate) used_by: Vec<String>,
    /// Values that others printed.
    pub(crate) printed: Vec<Printed>,
    /// Values to 30 digits, at the source's times.
    pub(crate) references: Vec<Reference>,
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
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Printed {
    /// Program or paper that printed it, and its method.
    pub(crate) by: String,
    /// Time, as text.
    pub(crate) t: String,
    /// Quantity of these numbers.
    pub(crate) quantity: Quantity,
    /// Numbers, in the source's conventions.
    pub(crate) values: Vec<f64>,
}

/// File of reference values.
#[derive(Deserialize)]
struct References {
    samples: Vec<Reference>,
}

/// Values to 30 digits at one time, in the source's conventions.
#[derive(Clone, Debug, PartialEq, Deserialize)]
pub(crate) struct Reference {
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
    pub(super) fn read((name, scenario, description, references): &Files) -> Result<Self, Failure> {
        let broken =
            |error: &dyn std::fmt::Display| Failure::Tool(format!("the catalogue's {name}: {error}"));
        let Description { title, source, conventions, seconds, used_by, printed } =
            toml::from_str(description).map_err(|error| broken(&error))?;
        let References { samples: references } =
            serde_json::from_str(references).map_err(|error| broken(&error))?;
        let scenario = Scenario::parse(name, scenario)?;
        Ok(Self { scenario, title, source, conventions, seconds, used_by, printed, references })
    }

    /// Name of the problem on the command line.
    #[must_use]
    pub(crate) fn name(&self) -> &str {
        &self.scenario.name
    }

    /// Greatest difference of the components of a printed value from the reference. A quaternion has the sign that is nearer to the
    /// reference. `None` if the catalogue has no reference for the value.
    #[must_use]
    pub(crate) fn off(&self, printed: &Printed) -> Option<f64> {
        let there = self.references.iter().find(|reference| reference.t == printed.t);
        let digits = |texts: &[String]| texts.iter().filter_map(|text| text.parse().ok()).collect();
        let reference = match printed.quantity {
            Quantity::Energy => vec![self.scenario.motion.first_integrals().h],
            Quantity::U => vec![Stepper::<f64>::new(&self.scenario.motion).attitude_state().u()],
            Quantity::Position => digits(&there?.position),
            Quantity::Quaternion => digits(&there?.quaternion),
            Quantity::OmegaBody => digits(&there?.omega_body),
        };
        let distance = |sign: f64| {
            let pairs = reference.iter().zip(&printed.values);
            pairs.map(|(reference, value)| (sign * value - reference).abs()).fold(0.0, f64::max)
        };
        let off = distance(1.0);
        Some(if printed.quantity == Quantity::Quaternion { off.min(distance(-1.0)) } else { off })
    }
}

#[cfg(test)]
mod tests {
    use crate::benchmarks::{self, conventions::Quantity};

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
                let components = match printed.quantity {
                    Quantity::Position | Quantity::OmegaBody => 3,
                    Quantity::Quaternion => 4,
                    Quantity::Energy | Quantity::U => 1,
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
