//! Problem of the catalogue, from its three files.

use super::conventions::{Conventions, Quantity};
use crate::Failure;
use crate::input::scenario::Scenario;
use serde_json::Value as Json;
use toml::{Table, Value};

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

/// Value that another program or paper printed.
#[derive(Clone, Debug, PartialEq)]
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

/// Values to 30 digits at one time, in the source's conventions.
#[derive(Clone, Debug, PartialEq)]
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
    pub(super) fn read(name: &str, scenario: &str, about: &str, reference: &str) -> Result<Self, Failure> {
        let broken = |what: String| Failure::Tool(format!("the catalogue's {name}: {what}"));
        let scenario = Scenario::parse(name, scenario)?;
        let about = about.parse::<Table>().map_err(|error| broken(error.to_string()))?;
        let text = |table: &Table, key: &str| {
            table
                .get(key)
                .and_then(Value::as_str)
                .map(str::to_owned)
                .ok_or_else(|| broken(format!("needs {key}")))
        };
        let number = |key: &str| about.get(key).and_then(float).ok_or_else(|| broken(format!("needs {key}")));
        let list = |key: &str| about.get(key).and_then(Value::as_array).cloned().unwrap_or_default();
        let mut printed = Vec::new();
        for entry in list("printed") {
            let entry = entry.as_table().ok_or_else(|| broken("printed: needs tables".to_owned()))?;
            let values = entry
                .get("values")
                .and_then(Value::as_array)
                .map_or(Vec::new(), |values| values.iter().filter_map(float).collect());
            let quantity = text(entry, "quantity")?;
            let quantity =
                Quantity::named(&quantity).ok_or_else(|| broken(format!("unknown quantity {quantity}")))?;
            printed.push(Printed { by: text(entry, "by")?, t: text(entry, "t")?, quantity, values });
        }
        let reference: Json = serde_json::from_str(reference).map_err(|error| broken(error.to_string()))?;
        let samples = reference["samples"].as_array().ok_or_else(|| broken("needs samples".to_owned()))?;
        let digits = |sample: &Json, key: &str| -> Vec<String> {
            let numbers = sample[key].as_array().map_or(&[][..], Vec::as_slice);
            numbers.iter().filter_map(Json::as_str).map(str::to_owned).collect()
        };
        let references = samples.iter().map(|sample| Reference {
            t: sample["t"].as_str().unwrap_or_default().to_owned(),
            position: digits(sample, "position"),
            quaternion: digits(sample, "quaternion"),
            omega_body: digits(sample, "omega_body"),
        });
        Ok(Self {
            title: text(&about, "title")?,
            source: text(&about, "source")?,
            conventions: Conventions {
                symmetry_axis: number("symmetry_axis")? as usize,
                length: number("length")?,
            },
            seconds: number("seconds")?,
            used_by: list("used_by").iter().filter_map(Value::as_str).map(str::to_owned).collect(),
            printed,
            references: references.collect(),
            scenario,
        })
    }

    /// Name of the problem on the command line.
    #[must_use]
    pub(crate) fn name(&self) -> &str {
        &self.scenario.name
    }

    /// Values to 30 digits at one of the source's times.
    #[must_use]
    pub(crate) fn reference(&self, t: &str) -> Option<&Reference> {
        self.references.iter().find(|reference| reference.t == t)
    }
}

fn float(value: &Value) -> Option<f64> {
    value.as_float().or(value.as_integer().map(|n| n as f64))
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
                assert!(printed.t == "0" || problem.reference(&printed.t).is_some(), "{name}: {}", printed.t);
            }
        }
        assert!(benchmarks::named("nothing").is_err());
    }
}
