//! Samples by column: a time for each row, and the readings of the sensors.

use super::sensors::{KINDS, Sensors};
use toytop_fit::Measurement;

/// Share of a sensor's range that a reading may reach: data sheets and registers round it.
const BEYOND: f64 = 1.01;

/// Samples by column. NaN means that there is no reading.
pub struct Columns {
    /// Time of each row, s.
    pub t: Vec<f64>,
    /// Columns of readings with their names, as long as `t`.
    pub readings: Vec<(&'static str, Vec<f64>)>,
}

/// Row from which no measurements can be made.
pub struct RefusedRow {
    /// Row, from 0.
    pub row: usize,
    /// Name of the column.
    pub column: &'static str,
    /// Requirement that the value does not meet.
    pub reason: &'static str,
}

impl Columns {
    /// Columns of measurements, those of one time in one row.
    pub fn of(sensors: &Sensors, measurements: &[Measurement]) -> Self {
        let same = |a: &Measurement, b: &Measurement| a.time == b.time && a.sensor < b.sensor;
        let rows: Vec<_> = measurements.chunk_by(same).collect();
        let t = rows.iter().map(|row| row[0].time).collect();
        let mut readings = Vec::new();
        for (sensor, instrument) in sensors.instruments.iter().enumerate() {
            for (component, name) in instrument.kind.columns.iter().enumerate() {
                let reading = |row: &&[Measurement]| {
                    let own = row.iter().find(|measurement| measurement.sensor == sensor);
                    own.map_or(f64::NAN, |measurement| measurement.values[component])
                };
                readings.push((*name, rows.iter().map(reading).collect()));
            }
        }
        Self { t, readings }
    }

    /// Measurements in the order of the rows, each with its row. Sensors whose columns are missing have none.
    ///
    /// # Errors
    /// [`RefusedRow`]: a time that is not finite or earlier than the one before, a sensor with only some of its readings, or a
    /// reading beyond its range.
    pub fn measurements(&self, sensors: &Sensors) -> Result<Vec<(usize, Measurement)>, RefusedRow> {
        let column = |name: &&str| {
            self.readings.iter().find(|(own, _)| own == name).map(|(_, readings)| readings.as_slice())
        };
        let columns: Vec<Option<Vec<&[f64]>>> = sensors
            .instruments
            .iter()
            .map(|instrument| instrument.kind.columns.iter().map(column).collect())
            .collect();
        let mut measurements = Vec::new();
        let mut last = f64::NEG_INFINITY;
        for (row, time) in self.t.iter().copied().enumerate() {
            let refuse = |column, reason| Err(RefusedRow { row, column, reason });
            if !time.is_finite() {
                return refuse("t", "must be a finite number");
            }
            if time < last {
                return refuse("t", "must not be earlier than in the row before");
            }
            last = time;
            for (sensor, (instrument, columns)) in sensors.instruments.iter().zip(&columns).enumerate() {
                let Some(columns) = columns else { continue };
                if columns.iter().all(|column| column[row].is_nan()) {
                    continue;
                }
                let mut values = [0.0; 4];
                for ((slot, column), name) in values.iter_mut().zip(columns).zip(instrument.kind.columns) {
                    *slot = column[row];
                    if !slot.is_finite() {
                        return refuse(name, "must be a finite number, as the sensor has a reading");
                    }
                    if slot.abs() > BEYOND * instrument.range {
                        return refuse(name, "must be at most the range of the sensor: another unit?");
                    }
                }
                measurements.push((row, Measurement { time, sensor, values }));
            }
        }
        Ok(measurements)
    }
}

/// Removes the sensors without columns.
///
/// * `all`: whether every sensor must have its columns
///
/// # Errors
/// Requirement that the columns do not meet: those of at least one sensor must be complete, or with `all` those of every sensor.
pub fn keep_present(sensors: &mut Sensors, has: impl Fn(&str) -> bool, all: bool) -> Result<(), String> {
    let present = |columns: &[&'static str]| columns.iter().all(|name| has(name));
    if all && let Some(missing) = sensors.instruments.iter().find(|one| !present(one.kind.columns)) {
        let columns = missing.kind.columns.join(", ");
        return Err(format!("must have the columns of the {}: {columns}", missing.kind.name));
    }
    sensors.instruments.retain(|instrument| present(instrument.kind.columns));
    if sensors.instruments.is_empty() {
        let names: Vec<_> = KINDS.iter().map(|kind| kind.columns.join(",")).collect();
        return Err(format!("must have the columns of a sensor: {}", names.join("; ")));
    }
    Ok(())
}
