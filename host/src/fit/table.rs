//! Samples as CSV: a time, and the columns of the sensors; an empty field means that there is no reading.

use super::sensors::{Instrument, KINDS, Sensors};
use crate::Failure;
use crate::output::{number, shown, whole_file};
use std::path::Path;
use toytop::fit::Measurement;

/// Largest file of samples, MiB.
const LARGEST_FILE: u64 = 1024;

/// Measurements of a file in the order of its rows, with the line of each; the sensors without columns are removed.
///
/// # Errors
/// [`Failure::Input`]: the file cannot be read; no column `t`, or no sensor with all its columns; a field that is no
/// finite number; a row that is incomplete for a sensor, or earlier than the one before.
pub fn read(path: &Path, sensors: &mut Sensors, all: bool) -> Result<Vec<Measurement>, Failure> {
    let file = path.display().to_string();
    let text = whole_file::read(&file, path, LARGEST_FILE)?;
    let refuse = |line: u64, reason: String| Failure::Input(format!("{file}: line {line}: {reason}"));
    let mut reader =
        csv::ReaderBuilder::new().comment(Some(b'#')).trim(csv::Trim::All).from_reader(text.as_bytes());
    let header = reader.headers().map_err(|error| refuse(1, error.to_string()))?.clone();
    let place = |name: &str| header.iter().position(|column| column == name);
    let time = place("t").ok_or_else(|| refuse(1, "must have a column t".to_owned()))?;
    let places = |instrument: &Instrument| -> Option<Vec<usize>> {
        instrument.kind.columns.iter().map(|name| place(name)).collect()
    };
    if all && let Some(missing) = sensors.instruments.iter().find(|one| places(one).is_none()) {
        let columns = missing.kind.columns.join(", ");
        return Err(refuse(1, format!("must have the columns of the {}: {columns}", missing.kind.name)));
    }
    sensors.instruments.retain(|instrument| places(instrument).is_some());
    let columns: Vec<_> = sensors.instruments.iter().filter_map(places).collect();
    if columns.is_empty() {
        let names: Vec<_> = KINDS.iter().map(|kind| kind.columns.join(",")).collect();
        return Err(refuse(1, format!("must have the columns of a sensor: {}", names.join("; "))));
    }
    let mut measurements = Vec::new();
    let mut last = f64::NEG_INFINITY;
    for record in reader.records() {
        let record = record.map_err(|error| {
            let line = error.position().map_or(0, csv::Position::line);
            refuse(line, "must have as many fields as the header".to_owned())
        })?;
        let line = record.position().map_or(0, csv::Position::line);
        let value = |place: usize, name: &str| {
            let field = record.get(place).unwrap_or_default();
            field.parse::<f64>().ok().filter(|x| x.is_finite()).ok_or_else(|| {
                refuse(line, format!("{name}: must be a finite number, not {:?}", shown(field)))
            })
        };
        let t = value(time, "t")?;
        if t < last {
            return Err(refuse(line, "t: must not be earlier than in the line before".to_owned()));
        }
        last = t;
        for (sensor, (instrument, places)) in sensors.instruments.iter().zip(&columns).enumerate() {
            if places.iter().all(|place| record.get(*place).unwrap_or_default().is_empty()) {
                continue;
            }
            let mut values = [0.0; 4];
            for ((slot, place), name) in values.iter_mut().zip(places).zip(instrument.kind.columns) {
                *slot = value(*place, name)?;
            }
            measurements.push(Measurement { time: t, sensor, values });
        }
    }
    Ok(measurements)
}

/// Measurements as CSV, those of one time in one row.
#[must_use]
pub fn written(sensors: &Sensors, measurements: &[Measurement]) -> String {
    let names = sensors.instruments.iter().flat_map(|instrument| instrument.kind.columns.iter().copied());
    let header: Vec<_> = std::iter::once("t").chain(names).collect();
    let mut text = header.join(",") + "\n";
    let same = |a: &Measurement, b: &Measurement| a.time == b.time && a.sensor < b.sensor;
    for row in measurements.chunk_by(same) {
        let mut fields = vec![number(row[0].time)];
        for (sensor, instrument) in sensors.instruments.iter().enumerate() {
            let reading = row.iter().find(|measurement| measurement.sensor == sensor);
            for k in 0..instrument.kind.columns.len() {
                fields.push(reading.map_or(String::new(), |reading| number(reading.values[k])));
            }
        }
        text += &(fields.join(",") + "\n");
    }
    text
}
