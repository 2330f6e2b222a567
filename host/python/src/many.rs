//! Motions of many tops or launches are computed on all cores.

use crate::arguments::{Array, NumericArg, array, value_error};
use crate::interrupt;
use crate::motion::{MotionCore, scalar_named};
use crate::samples::{Sampler, Source};
use crate::top::TopCore;
use numpy::PyReadonlyArray2;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use toytop_model::constants::number_constants;

/// Motions of tops by rows. A row has the numbers of a release, or a quaternion and `omega` or `omega_body`. A single top or row counts for all.
///
/// # Errors
/// `ValueError` that names the launch and the parameter.
#[pyfunction]
pub(crate) fn launch_many(
    py: Python<'_>,
    tops: Vec<Py<TopCore>>,
    omega_name: &str,
    rows: PyReadonlyArray2<'_, f64>,
) -> PyResult<Vec<Py<MotionCore>>> {
    let rows = rows.as_array();
    let motions = interrupt::map(py, tops.len().max(rows.nrows()), |index| {
        let top = tops[index % tops.len()].get();
        let (name, motion) = match rows.row(index % rows.nrows()).to_vec()[..] {
            [w, x, y, z, a, b, c] => ("quaternion", top.launch([w, x, y, z], omega_name, [a, b, c])),
            [a, b, c, d, e, f] => ("releases", top.release(a, b, c, d, e, f)),
            _ => ("rows", Err(value_error("rows", "must be of 6 or 7 numbers"))),
        };
        motion.map(Box::new).map_err(|error| (name, error))
    })?;
    let named = motions.into_iter().enumerate().map(|(index, motion)| match motion {
        Ok(motion) => Py::new(py, *motion),
        Err((name, error)) => Err(PyValueError::new_err(format!("{name}[{index}]: {}", error.value(py)))),
    });
    named.collect()
}

/// Samples of all these motions at time t, s.
#[pyfunction]
pub(crate) fn sample_many(
    py: Python<'_>,
    motions: Vec<Py<MotionCore>>,
    t: NumericArg,
    scalar: &str,
) -> PyResult<Sampler> {
    let scalar = scalar_named(scalar)?;
    let table = |index: usize| motions[index].get().table_for(scalar, &t.numbers);
    let tables = interrupt::map(py, motions.len(), table)?.into_iter().collect::<PyResult<_>>()?;
    Ok(Sampler::new(t, Some(motions.len()), Source::Tables(tables)))
}

/// Constant of each motion as an array.
#[pyfunction]
pub(crate) fn constant_of_many<'py>(
    py: Python<'py>,
    motions: Vec<Py<MotionCore>>,
    name: &str,
) -> PyResult<Bound<'py, Array>> {
    if !number_constants().any(|(known, _)| known == name) {
        let names = number_constants().map(|(name, _)| name).collect::<Vec<_>>().join(", ");
        return Err(value_error("name", format!("must be one of {names}")));
    }
    let number = |index: usize| motions[index].get().constant(name);
    array(py, interrupt::map(py, motions.len(), number)?, &[motions.len()])
}
