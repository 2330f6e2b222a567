//! Costs of the calls on the chips: measured ones, or the limits that the tests check.

use super::{Table, words};
use serde_json::Value;
use std::path::Path;
use toytop_host::Failure;
use toytop_host::budget::{Cost, Limits};

/// Limits of each call on each chip, from `firmware-examples/budgets.toml`.
pub(super) fn allowed() -> Result<Table, Failure> {
    let limits = Limits::parse(include_str!("../../../../../firmware-examples/budgets.toml"))?;
    let header =
        words(["chip", "call", "instructions", "cycles", "stack, bytes", "flash, bytes", "kept, bytes"]);
    let row = |chip: &str, cost: &Cost| {
        let figures = [Some(cost.instructions), cost.cycles, cost.stack, Some(cost.flash), cost.ram];
        let figure = |figure: Option<u64>| figure.map_or("-".to_owned(), |figure| figure.to_string());
        [vec![chip.to_owned(), cost.call.clone()], figures.map(figure).into()].concat()
    };
    let rows = limits.0.iter().flat_map(|(chip, costs)| costs.iter().map(move |cost| row(chip, cost)));
    Ok(Table { header, rows: rows.collect() })
}

/// Records of another command, `{"rows":[{..}]}` with any keys, as a table.
pub(super) fn records(text: &str, path: &Path) -> Result<Table, Failure> {
    let refused = || {
        Failure::Input(format!(
            "--budget: {}: must be {{\"rows\":[..]}}, records with the same keys",
            path.display()
        ))
    };
    let json: Value = serde_json::from_str(text).map_err(|_| refused())?;
    let rows = json["rows"].as_array().ok_or_else(refused)?;
    let first = rows.first().and_then(Value::as_object).ok_or_else(refused)?;
    let mut header: Vec<String> = first.keys().cloned().collect();
    // the order of the columns is that of the file
    header.sort_by_key(|key| text.find(&format!("\"{key}\"")));
    let cell = |value: &Value| match value {
        Value::String(text) => text.clone(),
        Value::Null => "-".to_owned(),
        other => other.to_string(),
    };
    let line = |row: &Value| header.iter().map(|key| row.get(key).map(cell)).collect::<Option<Vec<_>>>();
    let rows = rows.iter().map(line).collect::<Option<Vec<_>>>().ok_or_else(refused)?;
    Ok(Table { header, rows })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_chip_has_its_calls() {
        let Table { header, rows } = allowed().unwrap();
        assert!(rows.iter().all(|row| row.len() == header.len()));
        for chip in toytop_host::budget::CHIPS {
            let tick = |row: &&Vec<String>| row[0] == chip.name && row[1] == "ephemeris_f32";
            let found: Vec<_> = rows.iter().filter(tick).collect();
            assert!(found.len() == 1 && found[0][2].parse::<u64>().is_ok(), "{}", chip.name);
        }
    }
}
