//! Scenario: one top and one motion, from a TOML file.
//!
//! Reading is strict. A key that is unknown, missing, of the wrong type, out of range or not needed is refused with one
//! line that names file, key and what is allowed.

mod motion;
mod section;
mod template;
mod top;
mod units;

pub use template::{Key, Template};

use crate::Failure;
use crate::output::{shown, whole_file};
use crate::truth::motions::Start;
use section::Section;
use std::path::Path;
use toml::{Table, Value};
use toytop::{Motion, Top, TopParameters};

/// Units of a scenario's numbers.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Units {
    /// SI: kg, m, s.
    #[default]
    Si,
    /// No names: any consistent units, or those of the paper, with p = s = g = 1.
    None,
}

impl Units {
    /// Name of a unit; empty where units have no names.
    pub fn name(self, si: &'static str) -> &'static str {
        match self {
            Self::Si => si,
            Self::None => "",
        }
    }
}

/// One top with one motion.
#[derive(Clone, Debug)]
pub struct Scenario {
    /// Name in reports.
    pub name: String,
    /// Motion, with its top.
    pub motion: Motion,
    /// Numbers of the file; `None` for a motion that comes from no file.
    pub given: Option<Given>,
    /// Units of the numbers.
    pub units: Units,
}

/// Numbers of a scenario file.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Given {
    /// Numbers of the top.
    pub top: TopParameters,
    /// State of the launch, or its branch points.
    pub start: Start,
}

/// Size of the largest scenario file, MiB; a usual one has a dozen lines.
const LARGEST_FILE: u64 = 1;

impl Scenario {
    /// Scenario of a file, with the name of the file.
    ///
    /// # Errors
    /// [`Failure::Input`]: the file cannot be read, is larger than 1 MiB or not UTF-8, or as [`Scenario::parse`].
    pub fn read(path: &Path) -> Result<Self, Failure> {
        let file = path.display().to_string();
        let text = whole_file::read(&file, path, LARGEST_FILE)?;
        let mut scenario = Self::parse(&file, &text)?;
        if let Some(stem) = path.file_stem() {
            scenario.name = stem.to_string_lossy().into_owned();
        }
        Ok(scenario)
    }

    /// Keys and values of a scenario file, with numbers in the units of the keys.
    ///
    /// # Errors
    /// [`Failure::Input`]: the file cannot be read, is larger than 1 MiB or not UTF-8, or as [`Scenario::keys_of`].
    pub fn keys(path: &Path) -> Result<Table, Failure> {
        let file = path.display().to_string();
        Self::keys_of(&file, &whole_file::read(&file, path, LARGEST_FILE)?)
    }

    /// Keys and values of the text of a scenario file, with numbers in the units of the keys; `file` is its name in messages.
    ///
    /// # Errors
    /// [`Failure::Input`]: no TOML, or a text in place of a number that is not a number with a unit of its key.
    pub fn keys_of(file: &str, text: &str) -> Result<Table, Failure> {
        units::in_units_of_keys(file, table(file, text)?)
    }

    /// Top of a scenario file, whose motion is not read and may be missing.
    ///
    /// # Errors
    /// As [`Scenario::keys`], and [`Failure::Input`]: not a table `[top]` with exactly the keys it needs, in range.
    pub fn top(path: &Path) -> Result<Top, Failure> {
        let file = path.display().to_string();
        top::read(&section(&file, "top", &Self::keys(path)?)?).map(|(top, _)| top)
    }

    /// Scenario of the text of a file; `file` is its name in messages.
    ///
    /// # Errors
    /// [`Failure::Input`]: no TOML, or not the tables `[top]` and `[motion]` with exactly the keys they need, in range.
    pub fn parse(file: &str, text: &str) -> Result<Self, Failure> {
        let root = Self::keys_of(file, text)?;
        Self::of_table(file, &root)
    }

    fn of_table(file: &str, root: &Table) -> Result<Self, Failure> {
        if let Some(key) = root.keys().find(|key| !["units", "top", "motion"].contains(&key.as_str())) {
            let key = shown(key);
            return Err(Failure::Input(format!("{file}: {key}: unknown key; allowed: units, top, motion")));
        }
        let units = match root.get("units").map(Value::as_str) {
            None | Some(Some("SI")) => Units::Si,
            Some(Some("none")) => Units::None,
            _ => return Err(Failure::Input(format!("{file}: units: must be one of \"SI\", \"none\""))),
        };
        let (top, parameters) = top::read(&section(file, "top", root)?)?;
        let (motion, start) = motion::read(&section(file, "motion", root)?, &top)?;
        let given = Some(Given { top: parameters, start });
        Ok(Self { name: file.to_owned(), motion, given, units })
    }
}

fn table(file: &str, text: &str) -> Result<Table, Failure> {
    text.parse::<Table>().map_err(|error| {
        let line = error.span().map_or(1, |span| 1 + text[..span.start].matches('\n').count());
        Failure::Input(format!("{file}: line {line}: must be TOML: {}", error.message()))
    })
}

fn section<'a>(file: &'a str, name: &'static str, root: &'a Table) -> Result<Section<'a>, Failure> {
    match root.get(name) {
        Some(Value::Table(table)) => Ok(Section::new(file, name, table)),
        Some(_) => Err(Failure::Input(format!("{file}: {name}: must be a table, [{name}]"))),
        None => Err(Failure::Input(format!("{file}: {name}: missing; must be a table, [{name}]"))),
    }
}
