//! Functions of the Python module `many`.

use crate::arguments::{Given, Numbers, array, value_error};
use crate::interrupt;
use crate::motion::{PyMotion, scalar_named};
use crate::samples::{Source, samples};
use crate::top::PyTop;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use toytop_model::constants::CONSTANTS;

/// Motions of tops by rows: the numbers of a release, or a quaternion and the rates of this name. A single top or row counts for all.
///
/// # Errors
/// `ValueError` that names the launch and the parameter.
#[pyfunction]
pub(crate) fn launch_many(
    py: Python<'_>,
    tops: Vec<Py<PyTop>>,
    rates: &str,
    rows: Given,
) -> PyResult<Vec<Py<PyMotion>>> {
    let rows: Vec<_> = rows.numbers.chunks(rows.shape[1]).collect();
    let motions = interrupt::map(py, tops.len().max(rows.len()), |index| {
        let top = tops[index % tops.len()].get();
        let (name, motion) = match *rows[index % rows.len()] {
            [w, x, y, z, a, b, c] => ("quaternion", top.motion_of_attitude([w, x, y, z], rates, [a, b, c])),
            [a, b, c, d, e, f] => ("releases", top.motion_of_release([a, b, c, d, e, f])),
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

/// Samples of all motions of a `Many` at time t, s.
#[pyfunction]
pub(crate) fn sample_many<'py>(
    many: Bound<'py, PyAny>,
    motions: Vec<Py<PyMotion>>,
    t: Given,
    scalar: &str,
) -> PyResult<Bound<'py, PyAny>> {
    let scalar = scalar_named(scalar)?;
    let table = |index: usize| motions[index].get().table_for(scalar, &t.numbers);
    let py = many.py();
    let tables = interrupt::map(py, motions.len(), table)?.into_iter().collect::<PyResult<_>>()?;
    samples(py, (many.unbind(), "at", Some(scalar)), t, Some(motions.len()), Source::Tables(tables))
}

/// Constant of each motion as an array.
#[pyfunction]
pub(crate) fn constant_of_many<'py>(
    py: Python<'py>,
    motions: Vec<Py<PyMotion>>,
    name: &str,
) -> PyResult<Bound<'py, Numbers>> {
    if !CONSTANTS.iter().any(|(known, _)| *known == name) {
        let names = CONSTANTS.map(|(name, _)| name).join(", ");
        return Err(value_error("name", format!("must be one of {names}")));
    }
    let number = |index: usize| motions[index].get().constant(name).unwrap_or(f64::NAN);
    array(py, interrupt::map(py, motions.len(), number)?, &[motions.len()])
}
