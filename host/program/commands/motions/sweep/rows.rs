//! Many motions of a scenario, some of whose numbers vary: a grid or a random sample, one row for each motion.
//!
//! A row depends only on the options of the sweep and on its index, so that parts from different machines fit together.

use super::columns::{RowMotion, SweepColumn};
use crate::arguments::values::Values;
use serde_json::Value;
use toytop_host::Failure;
use toytop_host::input::scenario::{ScenarioFile, full_name};
use toytop_host::output::{csv_line, significant};
use toytop_host::random::Random;
use toytop_model::motion_with_period::MotionWithPeriod;

/// Greatest number of motions.
pub const MAX_MOTIONS: u64 = 1_000_000_000_000;

/// Motions of a sweep, with a header and a row for each.
pub struct Sweep {
    template: ScenarioFile,
    /// Numbers that vary, by their keys.
    varied: Vec<(&'static str, Values)>,
    /// Number of motions to draw, and the seed; `None` for the grid of all combinations.
    sample: Option<(u64, u64)>,
    /// Number of motions.
    pub count: u64,
    /// Columns after the numbers that vary.
    columns: Vec<SweepColumn>,
    /// Number of times at which each motion is evaluated.
    times: u32,
    /// Number of nutation periods over which these times are spread.
    periods: f64,
}

impl Sweep {
    /// Sweep of a scenario over these values, each in the unit of its key.
    ///
    /// # Errors
    /// [`Failure::input`]: no varied key, a key that the scenario does not have or that is given twice, a range in a grid, or a file that
    /// is no scenario for another reason than the numbers that vary.
    pub fn new(
        template: ScenarioFile,
        varied: Vec<(String, Values)>,
        sample: Option<(u64, u64)>,
        columns: Vec<SweepColumn>,
        times: u32,
        periods: f64,
    ) -> Result<Self, Failure> {
        if varied.is_empty() {
            return Err(Failure::input("a sweep: needs at least one of --spin, --tilt, ..., --vary"));
        }
        let mut by_key: Vec<(&'static str, Values)> = Vec::new();
        for (name, values) in varied {
            let key = template.require_key(&name)?;
            if by_key.iter().any(|(other, _)| *other == key) {
                return Err(Failure::input("must be given once only").at(name));
            }
            if sample.is_none() && values.is_continuous() {
                let forms = "must be LOW..HIGH/COUNT or numbers (or draw a sample: --motions N)";
                return Err(Failure::input(forms).at("a range in a grid").at(name));
            }
            by_key.push((key, values));
        }
        let grid = || by_key.iter().try_fold(1_u64, |count, (_, values)| count.checked_mul(values.count()));
        let Some(count) = sample.map(|(motions, _)| motions).or_else(grid).filter(|n| *n <= MAX_MOTIONS)
        else {
            let reason = format!("a grid: must have at most {:e} motions", MAX_MOTIONS as f64);
            return Err(Failure::input(reason));
        };
        let sweep = Self { template, varied: by_key, sample, count, columns, times, periods };
        // a file that is no scenario may lack only numbers that vary
        let first = |_| sweep.template.with_numbers(&sweep.numbers(0));
        match sweep.template.scenario().or_else(first) {
            Err(failure) if !sweep.varied.iter().any(|(key, _)| full_name(key) == failure.name()) => {
                Err(failure.at(&sweep.template.file))
            }
            _ => Ok(sweep),
        }
    }

    /// Numbers of the motion with this index. In a grid the last key changes fastest.
    fn numbers(&self, index: u64) -> Vec<(&'static str, f64)> {
        let mut random = self.sample.map(|(_, seed)| Random::new(seed, index));
        let mut motions = self.count;
        let number = |(key, values): &(&'static str, Values)| match &mut random {
            Some(random) => (*key, values.draw(random)),
            None => {
                motions /= values.count();
                (*key, values.at(index / motions % values.count()))
            }
        };
        self.varied.iter().map(number).collect()
    }

    fn motion(&self, numbers: &[(&'static str, f64)]) -> Result<MotionWithPeriod, Failure> {
        Ok(self.template.with_numbers(numbers)?.motion)
    }

    /// Line of the names of the columns.
    pub fn header(&self) -> String {
        let mut names = vec!["index".to_owned()];
        names.extend(self.varied.iter().map(|(key, _)| (*key).to_owned()));
        names.extend(self.columns.iter().flat_map(|column| column.names(self.times)));
        csv_line(names)
    }

    /// Appends the line of the row with this index; false if the scenario refuses its numbers.
    pub fn row(&self, index: u64, text: &mut Vec<u8>) -> bool {
        let numbers = self.numbers(index);
        let motion = self.motion(&numbers).ok();
        let motion = motion.map(|motion| RowMotion::new(motion, self.times, self.periods));
        let mut values = vec![Value::from(index)];
        values.extend(numbers.iter().map(|(_, number)| Value::from(*number)));
        values.extend(self.columns.iter().flat_map(|column| column.values(motion.as_ref(), self.times)));
        text.extend_from_slice(csv_line(values).as_bytes());
        motion.is_some()
    }

    /// Reason why the scenario refuses the numbers of a row, beginning with the key, and with its value if it varies.
    pub fn refusal(&self, index: u64) -> Option<String> {
        let numbers = self.numbers(index);
        let failure = self.motion(&numbers).err()?;
        let with_value =
            |(key, number): &(&str, f64)| (full_name(key), format!("{key} = {}", significant(*number, 5)));
        Some(failure.renamed(numbers.iter().map(with_value)).to_string())
    }
}
