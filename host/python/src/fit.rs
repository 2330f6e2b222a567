//! A launch is fitted to samples of sensors, and sensors are simulated.

use crate::arguments::{Array, NumericArg, array, failed, value_error};
use crate::interrupt;
use crate::motion::MotionCore;
use crate::top::TopCore;
use numpy::IntoPyArray;
use pyo3::prelude::*;
use pyo3::types::{IntoPyDict, PyDict, PyString};
use pythonize::{depythonize, pythonize};
use toytop_fit::{Drift, Measurement};
use toytop_host::Failure;
use toytop_host::sensors::columns::Columns;
use toytop_host::sensors::fit::{FitInput, FitResult, fit_launch};
use toytop_host::sensors::models::{Sensors, centre_of_mass};
use toytop_host::sensors::simulated::{MAX_SAMPLES, Recording, simulate_measurements};
use toytop_host::sensors::summary::FitSummary;

/// Fitted launch with the covariance of its unknowns.
#[pyclass(module = "toytop._toytop", frozen)]
pub(crate) struct FittedLaunch(toytop_fit::Fitted);

#[pymethods]
impl FittedLaunch {
    /// Covariance of the predicted orientation at the time t of the motion.
    fn orientation_covariance<'py>(
        &self,
        py: Python<'py>,
        motion: &MotionCore,
        t: NumericArg,
    ) -> PyResult<Bound<'py, Array>> {
        let NumericArg { numbers, shape } = t;
        let covariances =
            motion.partials_at(py, &numbers, |partials| self.0.orientation_covariance(partials))?;
        let refuse = || value_error("t", "must not be so far for a motion without a period");
        let covariances = covariances.ok_or_else(refuse)?.into_iter().flatten().flatten().collect();
        array(py, covariances, &[&shape[..], &[3, 3]].concat())
    }
}

/// Launch of a top, fitted to samples of sensors, which are columns by name.
#[pyfunction]
pub(crate) fn fit<'py>(
    py: Python<'py>,
    samples: &Bound<'py, PyDict>,
    top: &TopCore,
    sensors: Option<(String, Bound<'py, PyAny>)>,
    free: Vec<String>,
    huber: f64,
    drift: Option<f64>,
) -> PyResult<Bound<'py, PyDict>> {
    let mut used_sensors = self::sensors(sensors.as_ref(), top)?;
    let given = columns(samples, &mut used_sensors, sensors.is_some())?;
    let rows = given
        .measurements(&used_sensors, |row, column| format!("{column}: row {row}"))
        .map_err(|reason| value_error("samples", reason))?;
    let readings: Vec<Measurement> = rows.iter().map(|(_, measurement)| *measurement).collect();
    let input = FitInput { top: top.top, table: top.table(), free, sensors: used_sensors, huber, drift };
    let (result, residuals) = interrupt::interruptible(py, move || {
        let result = fit_launch(input, &readings)?;
        let residuals = result.residuals(&readings);
        Ok::<_, Failure>((result, residuals))
    })?
    .map_err(failed)?;
    let mut by_column = Columns { t: given.t, readings: Vec::new() };
    for (sensor, model) in result.input.sensors.models.iter().enumerate() {
        for (component, name) in model.kind.residuals().iter().enumerate() {
            let mut column = vec![f64::NAN; by_column.t.len()];
            for ((row, measurement), residual) in rows.iter().zip(&residuals) {
                if measurement.sensor == sensor {
                    column[*row] = residual[component];
                }
            }
            by_column.readings.push((*name, column));
        }
    }
    fields(py, &result, by_column)
}

/// Numbers of the fit by the keys of JSON; the launch, its tilt in rad, the residuals and the names of the losses.
fn fields<'py>(py: Python<'py>, result: &FitResult, residuals: Columns) -> PyResult<Bound<'py, PyDict>> {
    let core = result.fitted;
    let refused = |reason: String| PyString::new(py, &reason).into_any();
    let launched = match (core.warning, result.scenario(None)) {
        (Some(reason), _) => refused(format!("must be that of a fit that has converged: {reason}")),
        (None, Err(failure)) => refused(failure.to_string()),
        (None, Ok(text)) => Bound::new(py, MotionCore::from_text("fitted", &text)?)?.into_any(),
    };
    let [_, tilt] = result.spin_and_tilt();
    let fields = pythonize(py, &FitSummary::new(result))?.cast_into::<PyDict>()?;
    fields.set_item("_core", FittedLaunch(core))?;
    fields.set_item("launched", launched)?;
    fields.set_item("loss_names", Drift::LOSS_NAMES)?;
    fields.set_item("tilt", (tilt.value, tilt.deviation))?;
    fields.set_item("residuals", dictionary(py, residuals)?)?;
    Ok(fields)
}

/// Samples that sensors on a top would give, as columns by name.
#[pyfunction]
pub(crate) fn simulate<'py>(
    py: Python<'py>,
    motion: &MotionCore,
    sensors: Option<(String, Bound<'py, PyAny>)>,
    hertz: f64,
    duration: f64,
    seed: i128,
) -> PyResult<Bound<'py, PyDict>> {
    let sensors = self::sensors(sensors.as_ref(), &motion.top)?;
    let seed = seed.try_into().map_err(|_| value_error("seed", "must be between 0 and 2^64 - 1"))?;
    let recording = Recording::new(hertz, duration, seed).ok_or_else(|| {
        value_error("hertz, duration", format!("must give from 1 to {MAX_SAMPLES:e} samples"))
    })?;
    let motion = motion.motion;
    let columns = interrupt::interruptible(py, move || {
        simulate_measurements(&motion, &sensors, &recording)
            .map(|measurements| Columns::new(&sensors, &measurements))
    })?;
    let refuse = || value_error("motion", "has no period, and cannot be followed for so long");
    dictionary(py, columns.ok_or_else(refuse)?)
}

/// Sensors of a name and a dictionary or the text of a file, or of a telephone.
///
/// # Errors
/// `ValueError` that names the key.
fn sensors(given: Option<&(String, Bound<'_, PyAny>)>, top: &TopCore) -> PyResult<Sensors> {
    let com = centre_of_mass(&top.top, top.parameters.com_height);
    match given {
        None => Ok(Sensors::telephone(com)),
        Some((file, given)) => match given.extract::<String>() {
            Ok(text) => Sensors::parse(file, &text, com),
            Err(_) => Sensors::from_tables(&depythonize(given)?, com).map_err(|failure| failure.at(file)),
        }
        .map_err(failed),
    }
}

/// Samples by column. The sensors without columns are removed.
///
/// * `all`: whether every sensor must have its columns
///
/// # Errors
/// `ValueError` that names the column.
fn columns(samples: &Bound<'_, PyDict>, sensors: &mut Sensors, all: bool) -> PyResult<Columns> {
    let has = |name: &str| samples.contains(name).unwrap_or(false);
    if !has("t") {
        return Err(value_error("samples", "must have a column t"));
    }
    sensors.retain_with_columns(has, all).map_err(|reason| value_error("samples", reason))?;
    let column = |name: &str, rows: Option<usize>| -> PyResult<Vec<f64>> {
        let full_name = format!("samples: {name}");
        let NumericArg { numbers, shape } = NumericArg::read(&full_name, &samples.as_any().get_item(name)?)?;
        let reason = match shape[..] {
            [length] if rows.is_none_or(|rows| rows == length) => return Ok(numbers),
            [length] => format!("must have as many rows as t; has {length}"),
            _ => format!("must have one axis, not shape {shape:?}"),
        };
        Err(value_error(&full_name, reason))
    };
    let t = column("t", None)?;
    let wanted = sensors.models.iter().flat_map(|model| model.kind.columns().iter().copied());
    let readings: PyResult<Vec<_>> = wanted.map(|name| Ok((name, column(name, Some(t.len()))?))).collect();
    Ok(Columns { t, readings: readings? })
}

/// Columns as a dictionary of arrays.
fn dictionary(py: Python<'_>, columns: Columns) -> PyResult<Bound<'_, PyDict>> {
    let columns = [("t", columns.t)].into_iter().chain(columns.readings);
    columns.map(|(name, numbers)| (name, numbers.into_pyarray(py))).into_py_dict(py)
}
