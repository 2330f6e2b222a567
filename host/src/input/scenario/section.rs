//! One table of a scenario file. Each [`Key`] states its allowed values, by which the table is read.

use crate::Failure;
use crate::output::shown;
use toml::{Table, Value};
use toytop::ParameterError;

/// Key whose value is a number or an array of numbers.
pub(super) struct Key {
    pub(super) name: &'static str,
    /// Allowed values, in words.
    allowed: &'static str,
    /// Value of a missing key; `None` where it must not be missing.
    default: Option<f64>,
}

impl Key {
    pub(super) const fn required(name: &'static str, allowed: &'static str) -> Self {
        Self { name, allowed, default: None }
    }

    pub(super) const fn optional(name: &'static str, default: f64, allowed: &'static str) -> Self {
        Self { name, allowed, default: Some(default) }
    }
}

/// Table `[top]` or `[motion]`.
pub(super) struct Section<'a> {
    file: &'a str,
    name: &'static str,
    table: &'a Table,
}

impl<'a> Section<'a> {
    pub(super) fn new(file: &'a str, name: &'static str, table: &'a Table) -> Self {
        Self { file, name, table }
    }

    /// Failure that names a key and the reason.
    pub(super) fn refuse(&self, key: &str, reason: &str) -> Failure {
        Failure::Input(format!("{}: {}.{}: {reason}", self.file, self.name, shown(key)))
    }

    /// Failure for an error of the core, whose parameters have the names of the keys, except for those that `renamed` lists.
    pub(super) fn refused(&self, error: &ParameterError, renamed: &[(&str, &str)]) -> Failure {
        let parameter = error.parameter();
        let key = renamed.iter().find(|(name, _)| *name == parameter).map_or(parameter, |(_, key)| key);
        self.refuse(key, &format!("must be {}", error.allowed()))
    }

    pub(super) fn has(&self, key: &Key) -> bool {
        self.table.contains_key(key.name)
    }

    /// Failure if there is a key other than `choice`, which selects among the kinds of a table, and those listed.
    pub(super) fn only(&self, choice: &str, keys: &[Key]) -> Result<(), Failure> {
        let mut names = vec![choice];
        names.extend(keys.iter().map(|key| key.name));
        match self.table.keys().find(|key| !names.contains(&key.as_str())) {
            Some(key) => {
                let selected = self.table.get(choice).and_then(Value::as_str);
                let place =
                    selected.map_or(String::new(), |value| format!(" with {choice} = {:?}", shown(value)));
                Err(self
                    .refuse(key, &format!("unknown or unneeded key; allowed{place}: {}", names.join(", "))))
            }
            None => Ok(()),
        }
    }

    /// Value of a key that is one of several words, with an optional default.
    pub(super) fn choice(
        &self,
        key: &str,
        words: &[&'static str],
        default: Option<&'static str>,
    ) -> Result<&'static str, Failure> {
        let allowed = || words.iter().map(|word| format!("{word:?}")).collect::<Vec<_>>().join(", ");
        let Some(value) = self.table.get(key) else {
            return default
                .ok_or_else(|| self.refuse(key, &format!("missing; must be one of {}", allowed())));
        };
        let chosen = words.iter().find(|word| value.as_str() == Some(word));
        chosen.copied().ok_or_else(|| self.refuse(key, &format!("must be one of {}", allowed())))
    }

    /// Value of a key that is a finite number.
    pub(super) fn number(&self, key: &Key) -> Result<f64, Failure> {
        match (self.table.get(key.name), key.default) {
            (Some(value), _) => number(value).ok_or_else(|| self.not_allowed(key)),
            (None, Some(default)) => Ok(default),
            (None, None) => Err(self.missing(key)),
        }
    }

    /// Values of exactly these keys besides `choice`, each a finite number.
    pub(super) fn numbers<const N: usize>(&self, choice: &str, keys: &[Key; N]) -> Result<[f64; N], Failure> {
        self.only(choice, keys)?;
        let mut numbers = [0.0; N];
        for (slot, key) in numbers.iter_mut().zip(keys) {
            *slot = self.number(key)?;
        }
        Ok(numbers)
    }

    /// Value of a key that is an array of N finite numbers.
    pub(super) fn array<const N: usize>(&self, key: &Key) -> Result<[f64; N], Failure> {
        let value = self.table.get(key.name).ok_or_else(|| self.missing(key))?;
        value
            .as_array()
            .and_then(|entries| entries.iter().map(number).collect::<Option<Vec<_>>>())
            .and_then(|numbers| numbers.try_into().ok())
            .ok_or_else(|| self.not_allowed(key))
    }

    fn missing(&self, key: &Key) -> Failure {
        self.refuse(key.name, &format!("missing; must be {}", key.allowed))
    }

    pub(super) fn not_allowed(&self, key: &Key) -> Failure {
        self.refuse(key.name, &format!("must be {}", key.allowed))
    }
}

/// Finite number of a value; an integer is allowed.
fn number(value: &Value) -> Option<f64> {
    match value {
        Value::Float(number) => Some(*number),
        Value::Integer(number) => Some(*number as f64),
        _ => None,
    }
    .filter(|number| number.is_finite())
}
