//! Samples as CSV: a time, and the columns of the sensors; an empty field means that there is no reading.

use super::columns::{Columns, keep_present};
use super::sensors::Sensors;
use crate::Failure;
use crate::input::finite;
use crate::input::rows::{self, unread};
use crate::output::{number, shown};
use std::path::Path;
use toytop_fit::Measurement;

/// Measurements of a file in the order of its rows, and the names of the columns that no sensor reads; the sensors without columns are
/// removed.
///
/// * `all`: whether every sensor must have its columns
///
/// # Errors
/// [`Failure::Input`]: the file cannot be read; no column `t`, or no sensor with all its columns; a field that is no
/// finite number; a row that is incomplete for a sensor, beyond its range, or earlier than the one before.
pub fn read(
    path: &Path,
    sensors: &mut Sensors,
    all: bool,
) -> Result<(Vec<Measurement>, Vec<String>), Failure> {
    let file = path.display().to_string();
    let text = rows::read(&file, path)?;
    let refuse = |line: u64, reason: String| Failure::Input(format!("{file}: line {line}: {reason}"));
    let mut reader = rows::reader(&text);
    let header = reader.headers().map_err(|error| refuse(1, error.to_string()))?;
    let header = rows::names(header).map_err(|reason| refuse(1, reason))?;
    let place = |name: &str| header.iter().position(|column| column == name);
    let time = place("t").ok_or_else(|| refuse(1, "must have a column t".to_owned()))?;
    keep_present(sensors, |name| place(name).is_some(), all).map_err(|reason| refuse(1, reason))?;
    let names = sensors.instruments.iter().flat_map(|instrument| instrument.kind.columns.iter().copied());
    let mut columns = Columns { t: Vec::new(), readings: names.map(|name| (name, Vec::new())).collect() };
    let places: Vec<_> = columns.readings.iter().filter_map(|(name, _)| place(name)).collect();
    let used = |name: &&String| *name == "t" || columns.readings.iter().any(|(own, _)| own == name);
    let unused: Vec<_> = header.iter().filter(|name| !used(name)).cloned().collect();
    let mut lines = Vec::new();
    for record in reader.records() {
        let record = record.map_err(|error| Failure::Input(format!("{file}: {}", unread(&error))))?;
        let line = record.position().map_or(0, csv::Position::line);
        let value = |place: usize, name: &str| {
            let field = record.get(place).unwrap_or_default();
            finite(field).ok_or_else(|| {
                refuse(line, format!("{name}: must be a finite number, not {:?}", shown(field)))
            })
        };
        columns.t.push(value(time, "t")?);
        for ((name, readings), place) in columns.readings.iter_mut().zip(&places) {
            let empty = record.get(*place).unwrap_or_default().is_empty();
            readings.push(if empty { f64::NAN } else { value(*place, name)? });
        }
        lines.push(line);
    }
    let measurements = columns
        .measurements(sensors)
        .map_err(|refused| refuse(lines[refused.row], format!("{}: {}", refused.column, refused.reason)))?;
    Ok((measurements.into_iter().map(|(_, measurement)| measurement).collect(), unused))
}

/// Measurements as CSV, those of one time in one row.
pub fn written(sensors: &Sensors, measurements: &[Measurement]) -> String {
    let Columns { t, readings } = Columns::of(sensors, measurements);
    let names = readings.iter().map(|(name, _)| *name);
    let header: Vec<_> = std::iter::once("t").chain(names).collect();
    let mut text = header.join(",") + "\n";
    for (row, time) in t.iter().enumerate() {
        text += &number(*time);
        for (_, readings) in &readings {
            text.push(',');
            if !readings[row].is_nan() {
                text += &number(readings[row]);
            }
        }
        text.push('\n');
    }
    text
}
