//! Conversion of arrays of NumPy to and from numbers.

use crate::error::value_error;
use numpy::ndarray::{ArrayD, IxDyn};
use numpy::{IntoPyArray, PyArrayDyn, PyArrayMethods, PyReadonlyArrayDyn};
use pyo3::intern;
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::{PyDict, PyFloat, PyInt};

/// Array of numbers for Python.
pub(crate) type Numbers = PyArrayDyn<f64>;

/// Numbers in row-major order with their shape; a single number has an empty shape.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Given {
    pub(crate) numbers: Vec<f64>,
    pub(crate) shape: Vec<usize>,
}

impl Given {
    /// Finite numbers of anything that `numpy.asarray` makes an array of.
    ///
    /// # Errors
    /// `ValueError` that names the parameter: no numbers, or a number that is not finite.
    pub(crate) fn read(name: &str, object: &Bound<'_, PyAny>) -> PyResult<Self> {
        let given = Self::read_any(name, object)?;
        match given.numbers.iter().all(|x| x.is_finite()) {
            true => Ok(given),
            false => Err(value_error(name, "must be finite")),
        }
    }

    /// Numbers, finite or not, of anything that `numpy.asarray` makes an array of.
    ///
    /// # Errors
    /// `ValueError` that names the parameter: no numbers.
    pub(crate) fn read_any(name: &str, object: &Bound<'_, PyAny>) -> PyResult<Self> {
        Ok(if object.is_instance_of::<PyFloat>() || object.is_instance_of::<PyInt>() {
            Self { numbers: vec![object.extract()?], shape: Vec::new() }
        } else {
            let array = as_array(name, object)?;
            let view = array.as_array();
            Self { numbers: view.iter().copied().collect(), shape: view.shape().to_vec() }
        })
    }

    /// Numbers in rows of N, for an array whose last axis has that length.
    ///
    /// # Errors
    /// `ValueError`: the last axis has another length.
    pub(crate) fn rows<const N: usize>(&self, name: &str) -> PyResult<Vec<[f64; N]>> {
        if self.shape.last() != Some(&N) {
            let shape = &self.shape;
            return Err(value_error(name, &format!("must be of shape (..., {N}), not {shape:?}")));
        }
        Ok(self.numbers.as_chunks().0.to_vec())
    }
}

/// N finite numbers.
///
/// # Errors
/// `ValueError` that names the parameter.
pub(crate) fn vector<const N: usize>(name: &str, object: &Bound<'_, PyAny>) -> PyResult<[f64; N]> {
    let given = Given::read(name, object)?;
    given.numbers.try_into().map_err(|_| value_error(name, &format!("must be {N} numbers")))
}

/// Quaternions w, x, y, z: an array of shape (..., 4), or a `scipy.spatial.transform.Rotation`.
///
/// # Errors
/// `ValueError` that names the parameter.
pub(crate) fn quaternions(name: &str, object: &Bound<'_, PyAny>) -> PyResult<Vec<[f64; 4]>> {
    let py = object.py();
    if !object.hasattr(intern!(py, "as_quat"))? {
        return Given::read(name, object)?.rows(name);
    }
    let scalar_last = Given::read(name, &object.call_method0(intern!(py, "as_quat"))?)?;
    Ok(scalar_last.rows(name)?.into_iter().map(|[x, y, z, w]| [w, x, y, z]).collect())
}

fn as_array<'py>(name: &str, object: &Bound<'py, PyAny>) -> PyResult<PyReadonlyArrayDyn<'py, f64>> {
    static ASARRAY: PyOnceLock<Py<PyAny>> = PyOnceLock::new();
    if let Ok(array) = object.cast::<Numbers>() {
        return Ok(array.try_readonly()?);
    }
    let py = object.py();
    let options = PyDict::new(py);
    options.set_item(intern!(py, "dtype"), py.get_type::<PyFloat>())?;
    let converted = ASARRAY.import(py, "numpy", "asarray")?.call((object,), Some(&options));
    let array =
        converted.map_err(|error| value_error(name, &format!("must be numbers ({})", error.value(py))))?;
    Ok(array.cast::<Numbers>()?.try_readonly()?)
}

/// Array of these numbers, which are not copied. Rows of `width` numbers add an axis, unless there is one number a row.
pub(crate) fn array<'py>(
    py: Python<'py>,
    numbers: Vec<f64>,
    shape: &[usize],
    width: usize,
) -> PyResult<Bound<'py, Numbers>> {
    let mut shape = shape.to_vec();
    if width > 1 {
        shape.push(width);
    }
    let array = ArrayD::from_shape_vec(IxDyn(&shape), numbers);
    Ok(array.map_err(|error| value_error("shape", &error.to_string()))?.into_pyarray(py))
}
