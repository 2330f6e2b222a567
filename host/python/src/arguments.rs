//! Arguments, their refusals, and arrays for Python. A refusal is a `ValueError` whose message begins with the name of the argument.

use numpy::{IntoPyArray, PyArrayDyn, PyArrayMethods, PyUntypedArrayMethods};
use pyo3::exceptions::{PyOSError, PyValueError};
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::{PyFloat, PyInt};
use std::fmt::Display;
use toytop::ParameterError;
use toytop_host::motion::times;
use toytop_host::{Failure, FailureKind};

/// Exception for a parameter and the reason.
pub(crate) fn value_error(parameter: &str, reason: impl Display) -> PyErr {
    failed(Failure::input(reason.to_string()).at(parameter))
}

/// Exception for a failure of the host library, or for a parameter that core refuses.
pub(crate) fn failed(failure: impl Into<Failure>) -> PyErr {
    let failure = failure.into();
    let message = failure.to_string();
    match failure.kind {
        FailureKind::System => PyOSError::new_err(message),
        FailureKind::Input | FailureKind::Method => PyValueError::new_err(message),
    }
}

/// Exception for a parameter that core refuses; `names` lists those with another name here.
pub(crate) fn renamed(error: ParameterError, names: &[(&str, &str)]) -> PyErr {
    failed(Failure::from(error).renamed(names.iter().copied()))
}

/// Array of numbers for Python.
pub(crate) type Array = PyArrayDyn<f64>;

/// Array of numbers in row-major order. A single number has an empty shape.
pub(crate) struct NumericArg {
    pub(crate) numbers: Vec<f64>,
    pub(crate) shape: Vec<usize>,
}

impl NumericArg {
    /// Reads an argument of numbers, finite or not.
    ///
    /// # Errors
    /// `ValueError` that names the argument: no numbers.
    pub(crate) fn read(name: &str, object: &Bound<'_, PyAny>) -> PyResult<Self> {
        static NUMBERS: PyOnceLock<Py<PyAny>> = PyOnceLock::new();
        if object.is_instance_of::<PyFloat>() || object.is_exact_instance_of::<PyInt>() {
            return Ok(Self { numbers: vec![object.extract()?], shape: Vec::new() });
        }
        let array = match object.cast_exact::<Array>() {
            Ok(array) => array.clone(),
            Err(_) => {
                let numbers = NUMBERS.import(object.py(), "toytop._arguments", "numbers")?;
                numbers.call1((name, object))?.cast_into()?
            }
        };
        let array = array.try_readonly()?;
        let numbers = match array.as_slice() {
            Ok(numbers) if array.is_c_contiguous() => numbers.to_vec(),
            _ => array.as_array().iter().copied().collect(),
        };
        Ok(Self { numbers, shape: array.shape().to_vec() })
    }
}

/// Finite times of an argument `t`: a number, or an array of any shape.
impl FromPyObject<'_, '_> for NumericArg {
    type Error = PyErr;

    fn extract(t: Borrowed<'_, '_, PyAny>) -> PyResult<Self> {
        let times = Self::read("t", &t)?;
        match times.numbers.iter().all(|t| t.is_finite()) {
            true => Ok(times),
            false => Err(value_error("t", "must be finite")),
        }
    }
}

/// Checks that no time is farther than `reach` from t = 0.
///
/// # Errors
/// `ValueError`: one of the times is farther.
pub(crate) fn require_within(reach: f64, times: &[f64]) -> PyResult<()> {
    let within = times::require_within(times.iter().copied(), reach, "");
    within.map_err(|failure| failed(failure.at("t")))
}

/// Array of these numbers, which are not copied.
pub(crate) fn array<'py>(py: Python<'py>, numbers: Vec<f64>, shape: &[usize]) -> PyResult<Bound<'py, Array>> {
    numbers.into_pyarray(py).reshape(shape)
}
