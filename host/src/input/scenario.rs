//! Scenario: one top and one motion, from a TOML file.
//!
//! Reading is strict. A key that is unknown, missing, of the wrong type, out of range or not needed is refused with one
//! line that names file, key and what is allowed.

mod motion;
mod top;

pub use motion::fastest_rate;
pub use toytop_model::launch::Launch;

use super::section::{self, Key, Section};
use super::text_file;
use super::units::{self, DEGREES, RADIANS};
use crate::{Failure, excerpt};
use serde_json::json;
use std::path::Path;
use toml::{Table, Value};
use toytop::{InitialAngles, ParameterError, Support, Top, TopParameters};
use toytop_model::constants::Unit;
use toytop_model::launch::{KINDS, Kind};
use toytop_model::motion_with_period::MotionWithPeriod;
use toytop_model::parameters::{self, SUPPORTS};

/// Units of a scenario's numbers.
#[derive(Clone, Copy, PartialEq)]
pub enum Units {
    /// SI: kg, m, s.
    Si,
    /// Any consistent units, such as the paper's, with p = s = g = 1. They have no names.
    Unnamed,
}

impl Units {
    /// Name of a unit; empty where it has none.
    pub fn name(self, unit: Unit) -> &'static str {
        match (self, unit) {
            (Self::Unnamed, Unit::Si(_)) => "",
            _ => unit.name(),
        }
    }
}

/// Numbers of a top and of its launch, taken as exact.
#[derive(Clone, Copy, Debug)]
pub struct MotionInput {
    /// Support of the tip.
    pub support: Support,
    /// Numbers of the top.
    pub top: TopParameters,
    /// Launch.
    pub launch: Launch,
}

impl MotionInput {
    /// Motion with its period.
    ///
    /// # Errors
    /// The errors of a top, a state and a launch.
    pub fn motion(&self) -> Result<MotionWithPeriod, ParameterError> {
        let top = parameters::top(self.support, &self.top)?;
        self.launch.motion(&top).map(MotionWithPeriod::new)
    }
}

/// One top with one motion.
#[derive(Clone)]
pub struct Scenario {
    /// Name in reports.
    pub name: String,
    /// Motion, with its top and its period.
    pub motion: MotionWithPeriod,
    /// Numbers of the top and of the launch, as they are given.
    pub input: MotionInput,
    /// Units of the numbers.
    pub units: Units,
}

impl Scenario {
    /// Scenario of a file, with the name of the file.
    ///
    /// # Errors
    /// As [`ScenarioFile::read`] and [`ScenarioFile::scenario`].
    pub fn read(path: &Path) -> Result<Self, Failure> {
        ScenarioFile::read(path)?.scenario()
    }

    /// Scenario of the text of a file; `file` is its name in messages.
    ///
    /// # Errors
    /// As [`ScenarioFile::parse`] and [`ScenarioFile::scenario`].
    pub fn parse(file: &str, text: &str) -> Result<Self, Failure> {
        ScenarioFile::parse(file, text)?.scenario()
    }
}

/// Parsed scenario file; `toytop sweep` replaces its numbers.
#[derive(Clone)]
pub struct ScenarioFile {
    /// Name of the file in messages.
    pub file: String,
    /// Name of its scenario.
    name: String,
    /// Keys and values, with numbers in the units of the keys.
    pub table: Table,
}

impl ScenarioFile {
    /// Keys and values of a file.
    ///
    /// # Errors
    /// [`Failure::input`]: the file cannot be read, is larger than 1 MiB or not UTF-8, or as [`ScenarioFile::parse`].
    pub fn read(path: &Path) -> Result<Self, Failure> {
        let file = path.display().to_string();
        let read = Self::parse(&file, &text_file::read(&file, path, 1)?)?;
        Ok(Self { name: path.file_stem().map_or(file, |stem| stem.to_string_lossy().into_owned()), ..read })
    }

    /// Keys and values of the text of a file; `file` is its name in messages.
    ///
    /// # Errors
    /// [`Failure::input`]: no TOML, or a text in place of a number that is not a number with a unit of its key.
    pub fn parse(file: &str, text: &str) -> Result<Self, Failure> {
        let mut table = section::parse(file, text)?;
        let has_units = table.get("units").and_then(Value::as_str) != Some("none");
        for (name, value) in &mut table {
            let Value::Table(table) = value else { continue };
            let replaced = replace_units(table, has_units).and_then(|()| replace_angles(table));
            replaced.map_err(|(key, reason)| Section { name, table }.failure(key, reason).at(file))?;
        }
        Ok(Self { file: file.to_owned(), name: file.to_owned(), table })
    }

    /// Top, and the numbers that are given for it. The motion is not read and may be missing.
    ///
    /// # Errors
    /// [`Failure::input`]: not a table `[top]` with exactly the keys it needs, in range.
    pub fn top(&self) -> Result<(Top, TopParameters), Failure> {
        let top = self.section("top").and_then(|section| top::read(&section));
        top.map_err(|failure| failure.at(&self.file))
    }

    /// Scenario.
    ///
    /// # Errors
    /// [`Failure::input`]: a table or a key is missing, unknown, not needed, or out of range.
    pub fn scenario(&self) -> Result<Scenario, Failure> {
        self.scenario_of_this_file().map_err(|failure| failure.at(&self.file))
    }

    /// Scenario; the failures do not name the file.
    fn scenario_of_this_file(&self) -> Result<Scenario, Failure> {
        if let Some(key) = self.table.keys().find(|key| !["units", "top", "motion"].contains(&key.as_str())) {
            return Err(Failure::input("unknown key; allowed: units, top, motion").at(excerpt(key)));
        }
        let units = match self.table.get("units").map(Value::as_str) {
            None | Some(Some("SI")) => Units::Si,
            Some(Some("none")) => Units::Unnamed,
            _ => return Err(Failure::input("must be one of \"SI\", \"none\"").at("units")),
        };
        let (top, parameters) = top::read(&self.section("top")?)?;
        let (motion, launch) = motion::read(&self.section("motion")?, &top)?;
        let input = MotionInput { support: top.support(), top: parameters, launch };
        Ok(Scenario { name: self.name.clone(), motion: MotionWithPeriod::new(motion), input, units })
    }

    fn section(&self, name: &'static str) -> Result<Section<'_>, Failure> {
        let missing = match self.table.get(name) {
            Some(Value::Table(table)) => return Ok(Section { name, table }),
            Some(_) => "",
            None => "missing; ",
        };
        Err(Failure::input(format!("{missing}must be a table, [{name}]")).at(name))
    }

    /// Key of the scenario's number with this name.
    ///
    /// # Errors
    /// [`Failure::input`]: the scenario has no such number; the message lists those it has.
    pub fn require_key(&self, name: &str) -> Result<&'static str, Failure> {
        let word = self.table.get("motion").and_then(|motion| motion.get("kind")).and_then(Value::as_str);
        // a state has lists of numbers
        let is_kind = |(name, kind): &&(&str, Kind)| Some(*name) == word && *kind != Kind::State;
        let of_motion = KINDS.iter().find(is_kind).map_or(&[][..], |(_, kind)| motion::keys(*kind));
        let names: Vec<_> = top::KEYS.iter().chain(of_motion).map(|key| key.name).collect();
        names.iter().copied().find(|known| *known == name).ok_or_else(|| {
            let allowed = names.join(", ");
            Failure::input(format!("no number of this scenario; allowed: {allowed}"))
                .at(excerpt(name))
                .at(&self.file)
        })
    }

    /// Scenario in which these numbers replace numbers of the file.
    ///
    /// # Errors
    /// As [`ScenarioFile::scenario`], without the name of the file in front.
    pub fn with_numbers(&self, numbers: &[(&'static str, f64)]) -> Result<Scenario, Failure> {
        let mut changed = self.clone();
        for (name, number) in numbers {
            if let Some(Value::Table(table)) = changed.table.get_mut(table_of(name)) {
                table.insert((*name).to_owned(), Value::Float(*number));
            }
        }
        changed.scenario_of_this_file()
    }
}

/// Name of the table that has the number with this key.
fn table_of(key: &str) -> &'static str {
    if top::KEYS.iter().any(|of_top| of_top.name == key) { "top" } else { "motion" }
}

/// Name of a number in a failure: its table and its key.
pub fn full_name(key: &str) -> String {
    format!("{}.{key}", table_of(key))
}

/// Text of a scenario file, from the keys and values of its top and from a launch.
pub fn to_toml(top: &Table, launch: &Launch) -> String {
    let motion = match launch {
        Launch::State { orientation, omega } => {
            let [alpha, beta] = [orientation.alpha, orientation.beta].map(|z| [z.re, z.im]);
            format!("kind = \"state\"\nalpha = {alpha:?}\nbeta = {beta:?}\nomega = {omega:?}\n")
        }
        Launch::BranchPoints { e: [e1, e2, e3], signs, phases } => {
            let (plus, minus) = (signs.l_plus_n.as_i32(), signs.l_minus_n.as_i32());
            let InitialAngles { theta, arg_alpha, arg_beta } = phases;
            format!(
                "kind = \"branch_points\"\ne1 = {e1:?}\ne2 = {e2:?}\ne3 = {e3:?}\nsign_l_plus_n = {plus}\n\
                 sign_l_minus_n = {minus}\nnutation_phase = {theta:?}\narg_alpha = {arg_alpha:?}\narg_beta = {arg_beta:?}\n"
            )
        }
    };
    format!("[top]\n{top}\n[motion]\n{motion}")
}

/// Supports and kinds of motion of a scenario, and the keys of each table with their default values.
pub fn keys_as_json() -> serde_json::Value {
    let keys = |keys: &[Key]| keys.iter().map(|key| (key.name, key.default)).collect::<Vec<_>>();
    let kinds = KINDS.map(|(name, kind)| (name, keys(motion::keys(kind))));
    json!({ "supports": SUPPORTS.map(|(name, _)| name), "top": keys(&top::KEYS), "kinds": kinds })
}

/// Key, and the reason why its value is refused.
type RefusedKey = (&'static str, String);

/// Replaces numbers with units by numbers in the units of their keys.
fn replace_units(table: &mut Table, has_units: bool) -> Result<(), RefusedKey> {
    for Key { name, units, .. } in
        top::KEYS.iter().chain(KINDS.iter().flat_map(|(_, kind)| motion::keys(*kind)))
    {
        let entries = match table.get_mut(*name) {
            Some(Value::Array(entries)) => &mut entries[..],
            Some(value) => std::slice::from_mut(value),
            None => continue,
        };
        for entry in entries {
            let Value::String(text) = entry else { continue };
            if units.is_empty() {
                continue;
            }
            if !has_units && *units != RADIANS {
                return Err((name, "must be a number, because of units = \"none\"".to_owned()));
            }
            *entry = Value::Float(units::parse(text, units).map_err(|reason| (*name, reason))?);
        }
    }
    Ok(())
}

/// Replaces the angles of a release, which have units, by angles in degrees.
fn replace_angles(table: &mut Table) -> Result<(), RefusedKey> {
    if table.get("kind").and_then(Value::as_str) != Some("release") {
        return Ok(());
    }
    for (key, in_degrees) in motion::ANGLES {
        let Some(value) = table.remove(key) else { continue };
        let refuse = |reason| (key, reason);
        // a bare number would be ambiguous: degrees or radians
        let text = value.as_str().ok_or_else(|| {
            refuse(format!("must be a text with a unit, as \"20 deg\", or {in_degrees} a number"))
        })?;
        let degrees = units::parse(text, DEGREES).map_err(refuse)?;
        if table.insert(in_degrees.to_owned(), Value::Float(degrees)).is_some() {
            return Err(refuse(format!("allowed only without {in_degrees}")));
        }
    }
    Ok(())
}
