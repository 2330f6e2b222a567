//! Samples by column, and their CSV. A row has a time and the readings of the sensors; an empty field is no reading.

use super::models::{SensorKind, Sensors};
use crate::input::csv_rows::{self, CsvRows, finite};
use crate::input::text_file;
use crate::output::csv_line;
use crate::{Failure, excerpt};
use std::iter::once;
use std::path::Path;
use toytop_fit::Measurement;

/// Fraction of a sensor's range above which a reading is refused, because it has another unit.
const RANGE_TOLERANCE: f64 = 1.01;

/// Samples by column. NaN means that there is no reading.
pub struct Columns {
    /// Time of each row, s.
    pub t: Vec<f64>,
    /// Columns of readings with their names, as long as `t`, in the order of the sensors.
    pub readings: Vec<(&'static str, Vec<f64>)>,
}

impl Columns {
    /// Columns of measurements, one row for each time.
    pub fn new(sensors: &Sensors, measurements: &[Measurement]) -> Self {
        let same = |a: &Measurement, b: &Measurement| a.time == b.time && a.sensor < b.sensor;
        let rows: Vec<_> = measurements.chunk_by(same).collect();
        let mut readings = Vec::new();
        for (sensor, model) in sensors.models.iter().enumerate() {
            for (component, name) in model.kind.columns().iter().enumerate() {
                let reading = |row: &&[Measurement]| {
                    let own = row.iter().find(|measurement| measurement.sensor == sensor);
                    own.map_or(f64::NAN, |measurement| measurement.values[component])
                };
                readings.push((*name, rows.iter().map(reading).collect()));
            }
        }
        Self { t: rows.iter().map(|row| row[0].time).collect(), readings }
    }

    /// Measurements in the order of the rows, each with its row.
    ///
    /// * `sensors`: those whose columns these are, in their order
    /// * `place`: name of a row and a column in messages
    ///
    /// # Errors
    /// Place and reason: a time that is not finite or earlier than the one before, a sensor with only some of its readings, or a
    /// reading beyond its range.
    pub fn measurements(
        &self,
        sensors: &Sensors,
        place: impl Fn(usize, &str) -> String,
    ) -> Result<Vec<(usize, Measurement)>, String> {
        let mut measurements = Vec::new();
        let mut last = f64::NEG_INFINITY;
        for (row, time) in self.t.iter().copied().enumerate() {
            let refuse = |column, reason| Err(format!("{}: {reason}", place(row, column)));
            if !time.is_finite() {
                return refuse("t", "must be a finite number");
            }
            if time < last {
                return refuse("t", "must not be earlier than in the row before");
            }
            last = time;
            let mut rest = &self.readings[..];
            for (sensor, model) in sensors.models.iter().enumerate() {
                let (columns, others) = rest.split_at(model.kind.columns().len());
                rest = others;
                if columns.iter().all(|(_, readings)| readings[row].is_nan()) {
                    continue;
                }
                let mut values = [0.0; 4];
                for (value, (name, readings)) in values.iter_mut().zip(columns) {
                    *value = readings[row];
                    if !value.is_finite() {
                        return refuse(name, "must be a finite number, as the sensor has a reading");
                    }
                    if value.abs() > RANGE_TOLERANCE * model.range {
                        return refuse(name, "must be at most the range of the sensor: another unit?");
                    }
                }
                measurements.push((row, Measurement { time, sensor, values }));
            }
        }
        Ok(measurements)
    }
}

/// Measurements of a file in the order of its rows, and the names of unread columns. Removes sensors without columns.
///
/// * `all`: whether every sensor must have its columns
///
/// # Errors
/// [`Failure::input`]: the file cannot be read; no column `t`, or no sensor with all its columns; a field that is no
/// finite number; a row that is incomplete for a sensor, beyond its range, or earlier than the one before.
pub fn read(
    path: &Path,
    sensors: &mut Sensors,
    all: bool,
) -> Result<(Vec<Measurement>, Vec<String>), Failure> {
    let file = path.display().to_string();
    let text = text_file::read(&file, path, csv_rows::MAX_FILE_MIB)?;
    parse(&text, sensors, all).map_err(|reason| Failure::input(reason).at(file))
}

/// Spellings of the unit of a column.
fn unit_of(column: &str) -> &'static [&'static str] {
    let sensor = SensorKind::ALL.into_iter().find(|kind| kind.columns().contains(&column));
    if column == "t" { &["s"] } else { sensor.map_or(&[], SensorKind::unit) }
}

fn parse(text: &str, sensors: &mut Sensors, all: bool) -> Result<(Vec<Measurement>, Vec<String>), String> {
    let CsvRows { line, header, rows } = csv_rows::parse(text, unit_of)?;
    let in_header = |reason: String| format!("line {line}: {reason}");
    let index_of = |name: &str| header.iter().position(|column| column == name);
    let time = index_of("t").ok_or_else(|| in_header("must have a column t".to_owned()))?;
    sensors.retain_with_columns(|name| index_of(name).is_some(), all).map_err(in_header)?;
    let mut columns = Columns::new(sensors, &[]);
    let indices: Vec<_> = columns.readings.iter().filter_map(|(name, _)| index_of(name)).collect();
    let mut lines = Vec::new();
    for row in rows {
        let (line, row) = row?;
        let value = |index: usize| {
            let (name, field) = (&header[index], &row[index]);
            let refused =
                || format!("line {line}: {name}: must be a finite number, not {:?}", excerpt(field));
            finite(field).ok_or_else(refused)
        };
        columns.t.push(value(time)?);
        for ((_, readings), index) in columns.readings.iter_mut().zip(&indices) {
            readings.push(if row[*index].is_empty() { f64::NAN } else { value(*index)? });
        }
        lines.push(line);
    }
    let measurements =
        columns.measurements(sensors, |row, column| format!("line {}: {column}", lines[row]))?;
    let used = |name: &str| name == "t" || columns.readings.iter().any(|(own, _)| *own == name);
    let unused = header.iter().filter(|name| !used(name)).cloned().collect();
    Ok((measurements.into_iter().map(|(_, measurement)| measurement).collect(), unused))
}

/// Measurements as CSV, one row for each time.
pub fn csv(sensors: &Sensors, measurements: &[Measurement]) -> String {
    let Columns { t, readings } = Columns::new(sensors, measurements);
    let header = csv_line(once("t").chain(readings.iter().map(|(name, _)| *name)));
    let row = |(row, time): (usize, &f64)| {
        csv_line(once(*time).chain(readings.iter().map(|(_, readings)| readings[row])))
    };
    once(header).chain(t.iter().enumerate().map(row)).collect()
}
