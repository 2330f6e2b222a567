//! Motions of one scenario, some of whose numbers vary.

use super::Axis;
use crate::Failure;
use crate::input::random::Random;
use crate::input::scenario::{Key, Template};
use crate::output::short;
use std::fmt;
use toytop::Motion;

/// Scenario with the numbers that vary, each over an axis in the unit of its key.
#[derive(Clone, Debug, PartialEq)]
pub struct Launches {
    template: Template,
    axes: Vec<(Key, Axis)>,
    /// Number of motions to draw, and the seed; `None` for the grid of all combinations.
    pub(super) sample: Option<(u64, u64)>,
}

impl Launches {
    /// Launches over these axes.
    ///
    /// # Errors
    /// [`Failure::Input`]: no axis, a key that the scenario does not have or that is given twice, a range in a grid, or
    /// a scenario whose first motion is refused for a key that does not vary.
    pub fn new(
        template: Template,
        axes: &[(String, Axis)],
        sample: Option<(u64, u64)>,
    ) -> Result<Self, Failure> {
        if axes.is_empty() {
            return Err(Failure::Input(
                "a sweep of a scenario: needs at least one of --spin, --tilt, ..., --axis".into(),
            ));
        }
        let mut keys: Vec<(Key, Axis)> = Vec::new();
        for (name, axis) in axes {
            let key = template.key(name)?;
            if keys.iter().any(|(other, _)| *other == key) {
                return Err(Failure::Input(format!("{name}: must be one axis only")));
            }
            if sample.is_none() && axis.count().is_none() {
                return Err(Failure::Input(format!(
                    "{name}: {axis} in a grid: must be LOW..HIGH/PLACES or numbers (or draw a sample: --motions N)"
                )));
            }
            keys.push((key, axis.clone()));
        }
        let launches = Self { template, axes: keys, sample };
        if launches.checked_len().is_none() {
            return Err(Failure::Input("a grid: must have at most 2^64 places".into()));
        }
        match launches.template.with(&launches.numbers(0)) {
            Err(Failure::Input(message))
                if !launches.axes.iter().any(|(key, _)| message.contains(key.name)) =>
            {
                Err(Failure::Input(message))
            }
            _ => Ok(launches),
        }
    }

    /// Names of the keys that vary.
    pub(super) fn keys(&self) -> impl Iterator<Item = &'static str> {
        self.axes.iter().map(|(key, _)| key.name)
    }

    /// Axis of a key.
    pub fn axis(&self, name: &str) -> Option<&Axis> {
        self.axes.iter().find(|(key, _)| key.name == name).map(|(_, axis)| axis)
    }

    fn checked_len(&self) -> Option<u64> {
        let sizes = self.axes.iter().map(|(_, axis)| axis.count().unwrap_or(1));
        self.sample.map_or_else(
            || sizes.clone().try_fold(1_u64, |product, size| product.checked_mul(size)),
            |(motions, _)| Some(motions),
        )
    }

    /// Number of motions.
    pub(super) fn count(&self) -> u64 {
        self.checked_len().unwrap_or(u64::MAX)
    }

    /// Numbers of the motion with this index; in a grid the last key changes fastest.
    pub(super) fn numbers(&self, number: u64) -> Vec<(Key, f64)> {
        if let Some((_, seed)) = self.sample {
            let mut random = Random::new(seed, number);
            return self.axes.iter().map(|(key, axis)| (*key, axis.draw(&mut random))).collect();
        }
        let mut rest = number;
        let mut numbers: Vec<_> = self
            .axes
            .iter()
            .rev()
            .map(|(key, axis)| {
                let size = axis.count().unwrap_or(1);
                let place = rest % size;
                rest /= size;
                (*key, axis.at(place))
            })
            .collect();
        numbers.reverse();
        numbers
    }

    /// Motion with this index; `None` where the scenario refuses its numbers.
    pub(super) fn motion(&self, number: u64) -> Option<Motion> {
        self.template.with(&self.numbers(number)).ok().map(|scenario| scenario.motion)
    }

    /// Key and value that the scenario refuses in the row with this index, and the reason; without the key where it does not vary.
    pub(super) fn refusal(&self, number: u64) -> Option<String> {
        let numbers = self.numbers(number);
        let message = self.template.with(&numbers).err()?.to_string();
        let reason = message.strip_prefix(&format!("{}: ", self.template.file())).unwrap_or(&message);
        let of_key = numbers.iter().find_map(|(key, number)| {
            let reason = reason.strip_prefix(&format!("{key}: "))?;
            Some(format!("{} = {}: {reason}", key.name, short(*number, 5)))
        });
        Some(of_key.unwrap_or_else(|| reason.to_owned()))
    }
}

/// Options of `toytop sweep` that select the motions.
impl fmt::Display for Launches {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.template.file())?;
        self.axes.iter().try_for_each(|(key, axis)| write!(f, " --axis {}={axis}", key.name))?;
        match self.sample {
            Some((motions, seed)) => write!(f, " --motions {motions} --seed {seed}"),
            None => Ok(()),
        }
    }
}
