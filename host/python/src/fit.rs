//! `fit` and `simulate`: from samples of sensors to a launch, and back.

use crate::error::value_error;
use crate::fitted::Fitted;
use crate::motion::PyMotion;
use crate::sensors::{columns, dictionary, sensors};
use crate::top::PyTop;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use toml::{Table, Value};
use toytop::fit::{Fit, FitError, Measurement, Sensor};
use toytop_host::fit::columns::Columns;
use toytop_host::fit::free::{FreeKey, ratios};
use toytop_host::fit::report::FitReport;
use toytop_host::fit::residuals::residuals;
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
    if huber.is_nan() || huber < 1.0 {
        return Err(value_error("huber", "must be a number from 1, or inf"));
    }
    let free = free.iter().map(|name| key(name)).collect::<PyResult<Vec<_>>>()?;
    let file: Table = definition.to_toml().parse().unwrap_or_default();
    let table = file.get("top").and_then(Value::as_table).cloned().unwrap_or_default();
    let ratios = ratios(&table, &definition.top, &free).map_err(|reason| value_error("free", &reason))?;
    let mut instruments = self::sensors(sensors, &definition)?;
    let given = columns(samples, &mut instruments, sensors.is_some())?;
    let rows = given.measurements(&instruments).map_err(|refused| {
        value_error("samples", &format!("{}: row {}: {}", refused.column, refused.row, refused.reason))
    })?;
    let readings: Vec<Measurement> = rows.iter().map(|(_, measurement)| *measurement).collect();
    let fitted = py.detach(|| {
        let listed: Vec<&dyn Sensor> =
            instruments.instruments.iter().map(|instrument| &*instrument.sensor as &dyn Sensor).collect();
        let fit = Fit::new(&definition.top, &listed, &ratios)?.with_huber(huber);
        let mut fit = match drift {
            Some(deviation) => fit.with_drift(deviation)?,
            None => fit,
        };
        fit.run(readings.iter().copied())
    });
    let fitted = fitted.map_err(|error: FitError| match error {
        FitError::DriftDeviation => value_error("drift", "must be a positive number"),
        FitError::TooManyUnknowns if drift.is_some() => {
            value_error("free", "must have at most one name with a drift")
        }
        _ => value_error("samples", &error.to_string()),
    })?;
    let end = readings.last().map_or(0.0, |last| last.time);
    let report = FitReport {
        fitted: &fitted,
        reason: fitted.reason.map(|reason| reason.to_string()),
        top: &definition.top,
        table: &table,
        free: &free,
        sensors: &instruments,
        end,
    };
    // without a motion there is nothing to compare with
    let left = fitted.motion(&definition.top).map(|_| py.detach(|| residuals(&report, &readings)));
    let mut by_column = Columns { t: given.t, readings: Vec::new() };
    for (sensor, instrument) in instruments.instruments.iter().enumerate() {
        for (component, name) in instrument.kind.residuals().iter().enumerate() {
            let mut column = vec![f64::NAN; by_column.t.len()];
            for ((row, measurement), residual) in rows.iter().zip(left.as_ref().into_iter().flatten()) {
                if measurement.sensor == sensor {
                    column[*row] = residual[component];
                }
            }
            by_column.readings.push((*name, column));
        }
    }
    Fitted::new(py, &report, by_column)
}

/// Free key of a name.
fn key(name: &str) -> PyResult<FreeKey> {
    let named = FreeKey::ALL.into_iter().find(|key| key.name() == name);
    named.ok_or_else(|| {
        let all = FreeKey::ALL.map(FreeKey::name).join(", ");
        value_error("free", &format!("{name:?} must be one of {all}"))
    })
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
#[pyo3(signature = (motion, sensors=None, *, hertz=1000.0, duration=1.0, seed=1))]
pub(crate) fn simulate<'py>(
    py: Python<'py>,
    motion: &PyMotion,
    sensors: Option<&Bound<'py, PyAny>>,
    hertz: f64,
    duration: f64,
    seed: u64,
) -> PyResult<Bound<'py, PyDict>> {
    let sensors = self::sensors(sensors, &motion.top)?;
    let recording = Recording::new(hertz, duration, seed).ok_or_else(|| {
        value_error("hertz, duration", &format!("must give from 1 to {MOST_SAMPLES:e} samples"))
    })?;
    let found = py.detach(|| {
        let found = measurements(&motion.motion, &sensors, &recording)?;
        Some(Columns::of(&sensors, &found))
    });
    let refuse = || value_error("motion", "has no period, and cannot be followed for so long");
    dictionary(py, found.ok_or_else(refuse)?)
}
