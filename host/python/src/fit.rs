//! `fit` and `simulate`: from samples of sensors to a launch, and back.

use crate::arrays::{Frame, Given, number};
use crate::error::{failed, value_error};
use crate::fitted::{Fitted, dictionary};
use crate::interrupt;
use crate::motion::{PyMotion, TopDefinition, text_of};
use crate::top::PyTop;
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyFloat, PyInt, PyMapping};
use std::path::PathBuf;
use toml::{Table, Value};
use toytop_fit::Measurement;
use toytop_host::fit::columns::{Columns, keep_present};
use toytop_host::fit::launch::FitInput;
use toytop_host::fit::sensors::{Body, Sensors};
use toytop_host::fit::simulated::{MOST_SAMPLES, Recording, measurements};

/// Launch of a top, fitted to samples of sensors on it or beside it, without a first guess.
///
/// Args:
///     samples: columns by name, in a mapping, a structured array or a data frame: t (s), and those of the sensors, such as gyro_x,
///         gyro_y, gyro_z. NaN means that a sensor has no reading at this time. Other columns are not read.
///     top: the top.
///     sensors: noise, bias, range and mounting of the sensors, as a mapping of mappings with the keys of host/docs/fit.md, such as
///         {"gyroscope": {"noise": 0.002}}, or the path of such a TOML file; without it, those of a telephone, as far as the samples
///         have their columns.
///     free: names of numbers of the top that are unknown too, at most four, such as ["axial_inertia"].
///     huber: residual, in standard deviations, from which a sample is an outlier, at least 1; inf for least squares.
///     drift: standard deviation of a slow loss of rotation, in units of the rotation itself, 1/s, such as 1/60 where the spin may be
///         lost in a minute. The loss is then unknown too, and the launch is that of the last sample.
///
/// A launch that must not be trusted has converged = False and a reason; this is no exception.
///
/// Raises:
///     ValueError: a column, a sensor, a key or a row is wrong; the message names it.
#[pyfunction]
#[pyo3(signature = (samples, top, sensors=None, *, free=Vec::new(), huber=3.0, drift=None))]
pub(crate) fn fit(
    py: Python<'_>,
    samples: &Bound<'_, PyAny>,
    top: &PyTop,
    sensors: Option<&Bound<'_, PyAny>>,
    free: Vec<String>,
    huber: f64,
    drift: Option<f64>,
) -> PyResult<Fitted> {
    let definition = top.0;
    let file: Table = definition.to_toml().parse().unwrap_or_default();
    let table = file.get("top").and_then(Value::as_table).cloned().unwrap_or_default();
    let mut instruments = self::sensors(sensors, &definition)?;
    let given = columns(samples, &mut instruments, sensors.is_some())?;
    let rows = given.measurements(&instruments).map_err(|refused| {
        value_error("samples", format!("{}: row {}: {}", refused.column, refused.row, refused.reason))
    })?;
    let readings: Vec<Measurement> = rows.iter().map(|(_, measurement)| *measurement).collect();
    let input = FitInput { top: definition.top, table, free, sensors: instruments, huber, drift };
    let (report, residuals) = interrupt::alone(py, move || {
        let report = input.fitted(&readings)?;
        let residuals = report.residuals(&readings);
        Ok((report, residuals))
    })?
    .map_err(|(parameter, reason): (&str, String)| value_error(parameter, reason))?;
    let mut by_column = Columns { t: given.t, readings: Vec::new() };
    for (sensor, instrument) in report.input.sensors.instruments.iter().enumerate() {
        for (component, name) in instrument.kind.residuals().iter().enumerate() {
            let mut column = vec![f64::NAN; by_column.t.len()];
            for ((row, measurement), residual) in rows.iter().zip(&residuals) {
                if measurement.sensor == sensor {
                    column[*row] = residual[component];
                }
            }
            by_column.readings.push((*name, column));
        }
    }
    Fitted::new(py, &report, by_column)
}

/// Samples that sensors on a top would give: arrays by name, as fit takes them, with NaN where a sensor has no reading.
///
/// Args:
///     sensors: as those of fit; without it, a gyroscope, an accelerometer and a magnetometer of a telephone at the centre of mass.
///     hertz: samples a second.
///     duration: length of the recording, s, from t = 0.
///     seed: another seed gives other noise and other biases.
///
/// Raises:
///     ValueError: a number or a sensor is wrong, or the motion has no period and cannot be followed for so long.
#[pyfunction]
#[pyo3(signature = (motion, sensors=None, *, hertz=None, duration=None, seed=1))]
pub(crate) fn simulate<'py>(
    py: Python<'py>,
    motion: &PyMotion,
    sensors: Option<&Bound<'py, PyAny>>,
    hertz: Option<&Bound<'py, PyAny>>,
    duration: Option<&Bound<'py, PyAny>>,
    seed: i128,
) -> PyResult<Bound<'py, PyDict>> {
    let sensors = self::sensors(sensors, &motion.0.top)?;
    let hertz = number("hertz", hertz)?.unwrap_or(1000.0);
    let duration = number("duration", duration)?.unwrap_or(1.0);
    let seed = seed.try_into().map_err(|_| value_error("seed", "must be between 0 and 2^64 - 1"))?;
    let recording = Recording::new(hertz, duration, seed).ok_or_else(|| {
        value_error("hertz, duration", format!("must give from 1 to {MOST_SAMPLES:e} samples"))
    })?;
    let motion = motion.0.motion;
    let found = interrupt::alone(py, move || {
        measurements(&motion, &sensors, &recording).map(|found| Columns::of(&sensors, &found))
    })?;
    let refuse = || value_error("motion", "has no period, and cannot be followed for so long");
    dictionary(py, found.ok_or_else(refuse)?)
}

/// Sensors of a mapping, of a file, or those of a telephone.
///
/// # Errors
/// `ValueError` that names the key; `OSError` for a file that cannot be read.
fn sensors(given: Option<&Bound<'_, PyAny>>, top: &TopDefinition) -> PyResult<Sensors> {
    let body = Body::of(&top.top, top.parameters.com_height);
    let Some(given) = given else { return Ok(Sensors::telephone(body)) };
    let sensors = if let Ok(tables) = given.cast::<PyMapping>() {
        Sensors::of_table("sensors", &table(tables)?, body)
    } else {
        let path: PathBuf = given
            .extract()
            .map_err(|_| PyTypeError::new_err("sensors: must be a mapping or the path of a file"))?;
        Sensors::parse(&path.display().to_string(), &text_of(&path)?, body)
    };
    sensors.map_err(failed)
}

/// Tables of the sensors: numbers, and arrays of numbers, by name.
fn table(given: &Bound<'_, PyMapping>) -> PyResult<Table> {
    let mut table = Table::new();
    for pair in given.items()?.iter() {
        let (key, value): (String, Bound<'_, PyAny>) = pair.extract()?;
        let value = if let Ok(inner) = value.cast::<PyMapping>() {
            Value::Table(self::table(inner)?)
        } else if value.is_instance_of::<PyFloat>() || value.is_instance_of::<PyInt>() {
            Value::Float(value.extract()?)
        } else {
            let numbers = Given::read_any("sensors", &value)?.numbers;
            Value::Array(numbers.into_iter().map(Value::Float).collect())
        };
        table.insert(key, value);
    }
    Ok(table)
}

/// Samples by column: a mapping, a structured array or a data frame. The sensors without columns are removed.
///
/// * `all`: whether every sensor must have its columns
///
/// # Errors
/// `ValueError` that names the column.
fn columns(samples: &Bound<'_, PyAny>, sensors: &mut Sensors, all: bool) -> PyResult<Columns> {
    let frame = Frame::read("samples", samples)?;
    if !frame.has("t") {
        return Err(value_error("samples", "must have a column t"));
    }
    keep_present(sensors, |name| frame.has(name), all).map_err(|reason| value_error("samples", reason))?;
    let column = |name: &str, rows: Option<usize>| -> PyResult<Vec<f64>> {
        let full_name = frame.full_name(name);
        let Given { numbers, shape } = Given::read_any(&full_name, &frame.column(name)?)?;
        let reason = match shape[..] {
            [length] if rows.is_none_or(|rows| rows == length) => return Ok(numbers),
            [length] => format!("must have as many rows as t; has {length}"),
            _ => format!("must have one axis, not shape {shape:?}"),
        };
        Err(value_error(&full_name, reason))
    };
    let t = column("t", None)?;
    let wanted = sensors.instruments.iter().flat_map(|instrument| instrument.kind.columns.iter().copied());
    let readings: PyResult<Vec<_>> = wanted.map(|name| Ok((name, column(name, Some(t.len()))?))).collect();
    Ok(Columns { t, readings: readings? })
}
