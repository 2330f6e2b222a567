//! Scenario file in which some numbers vary.

use super::{Scenario, motion, top};
use crate::Failure;
use crate::output::shown;
use std::fmt;
use std::path::Path;
use toml::{Table, Value};

/// Scenario file whose numbers can be replaced.
pub struct Template {
    file: String,
    root: Table,
}

/// Key whose value is one number: its table and its name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Key {
    table: &'static str,
    /// Name of the key.
    pub name: &'static str,
}

impl fmt::Display for Key {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}.{}", self.table, self.name)
    }
}

impl Template {
    /// Template of a scenario file, in which the keys that vary may be missing.
    ///
    /// # Errors
    /// [`Failure::Input`]: as [`Scenario::keys`].
    pub fn read(path: &Path) -> Result<Self, Failure> {
        let file = path.display().to_string();
        Ok(Self { root: Scenario::keys(path)?, file })
    }

    /// Name of the scenario file.
    pub fn file(&self) -> &str {
        &self.file
    }

    /// Key of this name.
    ///
    /// # Errors
    /// [`Failure::Input`]: the scenario has no such number; the message lists those it has.
    pub fn key(&self, name: &str) -> Result<Key, Failure> {
        let kind = self.root.get("motion").and_then(|motion| motion.get("kind")).and_then(Value::as_str);
        let of_motion = motion::numbers(kind.unwrap_or_default()).iter().map(|key| ("motion", key.name));
        let keys: Vec<_> = top::KEYS.iter().map(|key| ("top", key.name)).chain(of_motion).collect();
        let found = keys.iter().find(|(_, key)| *key == name).map(|&(table, name)| Key { table, name });
        found.ok_or_else(|| {
            let allowed: Vec<_> = keys.iter().map(|(_, key)| *key).collect();
            let name = shown(name);
            Failure::Input(format!(
                "{}: {name}: no number of this scenario; allowed: {}",
                self.file,
                allowed.join(", ")
            ))
        })
    }

    /// Scenario with these numbers.
    ///
    /// # Errors
    /// As [`Scenario::parse`].
    pub fn with(&self, numbers: &[(Key, f64)]) -> Result<Scenario, Failure> {
        let mut root = self.root.clone();
        for (key, number) in numbers {
            if let Some(Value::Table(table)) = root.get_mut(key.table) {
                table.insert(key.name.to_owned(), Value::Float(*number));
            }
        }
        Scenario::of_table(&self.file, &root)
    }
}
