//! One table of a TOML file. Each [`Key`] states its allowed values, by which the table is read.

use super::units::UnitTable;
use crate::{Failure, excerpt};
use toml::{Table, Value};
use toytop::ParameterError;

/// Key whose value is a number or an array of numbers.
pub struct Key {
    pub name: &'static str,
    /// Allowed values, in words.
    allowed: &'static str,
    /// Value of a missing key; `None` where it must not be missing.
    pub default: Option<f64>,
    /// Least and greatest value.
    range: [f64; 2],
    /// Units of a value that is a text; none where it must be a number.
    pub units: UnitTable,
}

impl Key {
    pub const fn required(name: &'static str, allowed: &'static str) -> Self {
        Self { name, allowed, default: None, range: [f64::MIN, f64::MAX], units: &[] }
    }

    pub const fn optional(name: &'static str, default: f64, allowed: &'static str) -> Self {
        Self { default: Some(default), ..Self::required(name, allowed) }
    }

    /// Key whose value is in this range.
    pub const fn within(self, low: f64, high: f64) -> Self {
        Self { range: [low, high], ..self }
    }

    /// Key whose value may have one of these units.
    pub const fn with_units(self, units: UnitTable) -> Self {
        Self { units, ..self }
    }
}

/// Keys and values of a TOML file; `file` is its name in messages.
///
/// # Errors
/// [`Failure::input`] with the line: no TOML.
pub fn parse(file: &str, text: &str) -> Result<Table, Failure> {
    text.parse::<Table>().map_err(|error| {
        let line = error.span().map_or(1, |span| 1 + text[..span.start].matches('\n').count());
        Failure::input(format!("must be TOML: {}", error.message())).at(format!("line {line}")).at(file)
    })
}

/// Table of a file.
#[derive(Clone, Copy)]
pub struct Section<'a> {
    pub name: &'a str,
    pub table: &'a Table,
}

impl Section<'_> {
    /// Failure that names a key and the reason.
    pub fn failure(&self, key: &str, reason: impl Into<String>) -> Failure {
        Failure::input(reason).at(format!("{}.{}", excerpt(self.name), excerpt(key)))
    }

    /// Failure that names the key of the core's error.
    pub fn refusal(&self, error: ParameterError) -> Failure {
        let named = Failure::from(error).renamed([("theta", "nutation_phase"), ("top", "kind")]);
        self.failure(named.name(), &*named.reason)
    }

    /// Refuses all keys except `names` and the key of `choice`.
    ///
    /// * `choice`: key that selects the kind of the table, with its value
    pub fn refuse_other_keys<'a>(
        &self,
        choice: Option<(&'a str, &str)>,
        names: impl Iterator<Item = &'a str>,
    ) -> Result<(), Failure> {
        let names: Vec<_> = choice.iter().map(|(key, _)| *key).chain(names).collect();
        let Some(key) = self.table.keys().find(|key| !names.contains(&key.as_str())) else {
            return Ok(());
        };
        let condition = choice.map_or_else(String::new, |(key, value)| format!(" with {key} = {value:?}"));
        let allowed = names.join(", ");
        Err(self.failure(key, format!("unknown or unneeded key; allowed{condition}: {allowed}")))
    }

    /// Value of a key by `read`, or the default where it is missing.
    fn value<T>(
        &self,
        (key, allowed): (&str, &str),
        default: Option<T>,
        read: impl Fn(&Value) -> Option<T>,
    ) -> Result<T, Failure> {
        match self.table.get(key) {
            Some(value) => read(value).ok_or_else(|| self.failure(key, format!("must be {allowed}"))),
            None => default.ok_or_else(|| self.failure(key, format!("missing; must be {allowed}"))),
        }
    }

    /// Word of a key and its meaning, one of several, with an optional default.
    pub fn choice<T: Copy>(
        &self,
        key: &str,
        choices: &[(&'static str, T)],
        default: Option<(&'static str, T)>,
    ) -> Result<(&'static str, T), Failure> {
        let quoted: Vec<_> = choices.iter().map(|(word, _)| format!("{word:?}")).collect();
        let allowed = format!("one of {}", quoted.join(", "));
        let chosen = |value: &Value| choices.iter().copied().find(|(word, _)| value.as_str() == Some(word));
        self.value((key, &allowed), default, chosen)
    }

    /// Like [`numbers`](Self::numbers); refuses keys other than these and `choice`.
    pub fn only_numbers<const N: usize>(
        &self,
        choice: Option<(&str, &str)>,
        keys: &[Key; N],
    ) -> Result<[f64; N], Failure> {
        self.refuse_other_keys(choice, keys.iter().map(|key| key.name))?;
        self.numbers(keys)
    }

    /// Values of these keys, each a number in its range.
    pub fn numbers<const N: usize>(&self, keys: &[Key; N]) -> Result<[f64; N], Failure> {
        let mut numbers = [0.0; N];
        for (slot, key) in numbers.iter_mut().zip(keys) {
            let [low, high] = key.range;
            let within = |value: &Value| as_f64(value).filter(|number| (low..=high).contains(number));
            *slot = self.value((key.name, key.allowed), key.default, within)?;
        }
        Ok(numbers)
    }

    /// Value of a key that is an array of N finite numbers.
    pub fn array<const N: usize>(&self, key: &Key, default: Option<[f64; N]>) -> Result<[f64; N], Failure> {
        let finite = |value: &Value| as_f64(value).filter(|number| number.is_finite());
        self.value((key.name, key.allowed), default, |value| {
            value.as_array()?.iter().map(finite).collect::<Option<Vec<_>>>()?.try_into().ok()
        })
    }

    /// Failure for a number that is not allowed.
    pub fn not_allowed(&self, key: &Key) -> Failure {
        self.failure(key.name, format!("must be {}", key.allowed))
    }
}

/// Number of a value; an integer is allowed.
pub fn as_f64(value: &Value) -> Option<f64> {
    value.as_float().or(value.as_integer().map(|number| number as f64))
}
