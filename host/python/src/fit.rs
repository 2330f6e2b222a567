//! `fit` and `simulate`: from samples of sensors to a launch, and back.

use crate::arrays::Given;
use crate::error::value_error;
use crate::fitted::Fitted;
use crate::interrupt;
use crate::motion::PyMotion;
use crate::sensors::{columns, dictionary, sensors};
use crate::top::PyTop;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use toml::{Table, Value};
use toytop_fit::Measurement;
use toytop_host::fit::columns::Columns;
use toytop_host::fit::launch::FitInput;
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
        value_error("samples", &format!("{}: row {}: {}", refused.column, refused.row, refused.reason))
    })?;
    let readings: Vec<Measurement> = rows.iter().map(|(_, measurement)| *measurement).collect();
    let input = FitInput { top: definition.top, table, free, sensors: instruments, huber, drift };
    let (report, residuals) = interrupt::alone(py, move || {
        let report = input.fitted(&readings)?;
        let residuals = report.residuals(&readings);
        Ok((report, residuals))
    })?
    .map_err(|(parameter, reason): (&str, String)| value_error(parameter, &reason))?;
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
    let hertz = hertz.map_or(Ok(1000.0), |hertz| Given::number("hertz", hertz))?;
    let duration = duration.map_or(Ok(1.0), |duration| Given::number("duration", duration))?;
    let seed = seed.try_into().map_err(|_| value_error("seed", "must be between 0 and 2^64 - 1"))?;
    let recording = Recording::new(hertz, duration, seed).ok_or_else(|| {
        value_error("hertz, duration", &format!("must give from 1 to {MOST_SAMPLES:e} samples"))
    })?;
    let motion = motion.0.motion;
    let found = interrupt::alone(py, move || {
        measurements(&motion, &sensors, &recording).map(|found| Columns::of(&sensors, &found))
    })?;
    let refuse = || value_error("motion", "has no period, and cannot be followed for so long");
    dictionary(py, found.ok_or_else(refuse)?)
}
