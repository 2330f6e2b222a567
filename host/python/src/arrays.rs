//! Arrays and columns of Python to and from numbers.

use crate::error::value_error;
use numpy::{IntoPyArray, PyArrayDyn, PyArrayMethods, PyUntypedArrayMethods};
use pyo3::exceptions::PyTypeError;
use pyo3::intern;
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::{PyFloat, PyInt};

/// Array of numbers for Python.
pub(crate) type Numbers = PyArrayDyn<f64>;

/// Numbers in row-major order with their shape; a single number has an empty shape.
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
    /// `ValueError` that names the parameter: no numbers, but dates, intervals, texts, or an array with a mask.
    pub(crate) fn read_any(name: &str, object: &Bound<'_, PyAny>) -> PyResult<Self> {
        if object.is_instance_of::<PyFloat>() || object.is_exact_instance_of::<PyInt>() {
            return Ok(Self { numbers: vec![object.extract()?], shape: Vec::new() });
        }
        let array = as_array(name, object)?.try_readonly()?;
        let numbers = match array.as_slice() {
            Ok(numbers) if array.is_c_contiguous() => numbers.to_vec(),
            _ => array.as_array().iter().copied().collect(),
        };
        Ok(Self { numbers, shape: array.shape().to_vec() })
    }

    /// N numbers.
    ///
    /// # Errors
    /// `ValueError`: another shape.
    fn exactly<const N: usize>(&self, name: &str) -> PyResult<[f64; N]> {
        match self.shape[..] {
            [length] if length == N => Ok(self.numbers.as_chunks().0[0]),
            _ => Err(value_error(name, format!("must be {N} numbers, not of shape {:?}", self.shape))),
        }
    }

    /// Numbers in rows of N, for an array of two axes whose last one has that length.
    ///
    /// # Errors
    /// `ValueError`: another shape.
    pub(crate) fn rows<const N: usize>(&self, name: &str) -> PyResult<Vec<[f64; N]>> {
        match self.shape[..] {
            [_, last] if last == N => Ok(self.numbers.as_chunks().0.to_vec()),
            _ => Err(value_error(name, format!("must be of shape (n, {N}), not {:?}", self.shape))),
        }
    }
}

/// Finite times of an argument `t`: a number, or an array of any shape.
impl FromPyObject<'_, '_> for Given {
    type Error = PyErr;

    fn extract(t: Borrowed<'_, '_, PyAny>) -> PyResult<Self> {
        Self::read("t", &t)
    }
}

/// Finite number, if it is given.
///
/// # Errors
/// `ValueError` that names the parameter.
pub(crate) fn number(name: &str, object: Option<&Bound<'_, PyAny>>) -> PyResult<Option<f64>> {
    let Some(object) = object else { return Ok(None) };
    let Given { numbers, shape } = Given::read(name, object)?;
    match shape.is_empty() {
        true => Ok(Some(numbers[0])),
        false => Err(value_error(name, format!("must be a number, not of shape {shape:?}"))),
    }
}

/// N finite numbers.
///
/// # Errors
/// `ValueError` that names the parameter.
pub(crate) fn vector<const N: usize>(name: &str, object: &Bound<'_, PyAny>) -> PyResult<[f64; N]> {
    Given::read(name, object)?.exactly(name)
}

/// Quaternion w, x, y, z: 4 numbers, or a single `scipy.spatial.transform.Rotation`.
///
/// # Errors
/// `ValueError` that names the parameter.
pub(crate) fn quaternion(name: &str, object: &Bound<'_, PyAny>) -> PyResult<[f64; 4]> {
    scalar_first(name, object)?.exactly(name)
}

/// Quaternions w, x, y, z: an array of shape (n, 4), or a `scipy.spatial.transform.Rotation`.
///
/// # Errors
/// `ValueError` that names the parameter.
pub(crate) fn quaternions(name: &str, object: &Bound<'_, PyAny>) -> PyResult<Vec<[f64; 4]>> {
    scalar_first(name, object)?.rows(name)
}

fn scalar_first(name: &str, object: &Bound<'_, PyAny>) -> PyResult<Given> {
    let as_quat = intern!(object.py(), "as_quat");
    if !object.hasattr(as_quat)? {
        return Given::read(name, object);
    }
    let mut given = Given::read(name, &object.call_method0(as_quat)?)?;
    given.numbers.as_chunks_mut::<4>().0.iter_mut().for_each(|row| row.rotate_right(1));
    Ok(given)
}

fn as_array<'py>(name: &str, object: &Bound<'py, PyAny>) -> PyResult<Bound<'py, Numbers>> {
    static ASARRAY: PyOnceLock<Py<PyAny>> = PyOnceLock::new();
    if let Ok(array) = object.cast_exact::<Numbers>() {
        return Ok(array.clone());
    }
    let py = object.py();
    let no_numbers = |error: PyErr| value_error(name, format!("must be numbers ({})", error.value(py)));
    let asarray = ASARRAY.import(py, "numpy", "asarray")?;
    let array = asarray.call1((object,)).map_err(no_numbers)?;
    let dtype = array.getattr(intern!(py, "dtype"))?;
    let kind: String = dtype.getattr(intern!(py, "kind"))?.extract()?;
    if !"iufO".contains(&kind) {
        return Err(value_error(name, format!("must be numbers, not {}", dtype.str()?)));
    }
    if object.hasattr(intern!(py, "mask"))? && object.hasattr(intern!(py, "filled"))? {
        return Err(value_error(name, "must have no mask: use its method filled or compressed"));
    }
    let array = asarray.call1((array, py.get_type::<PyFloat>())).map_err(no_numbers)?;
    Ok(array.cast_into::<Numbers>()?)
}

/// Checks that the times are within a distance from t = 0.
///
/// # Errors
/// `ValueError`: one of the times is not.
pub(crate) fn within(reach: f64, times: &[f64]) -> PyResult<()> {
    let furthest = times.iter().fold(0.0, |furthest, t| f64::max(furthest, t.abs()));
    match furthest <= reach {
        true => Ok(()),
        false => Err(value_error("t", format!("{furthest:e} must be within ±{reach:.1e}"))),
    }
}

/// Array of these numbers, which are not copied.
pub(crate) fn array<'py>(
    py: Python<'py>,
    numbers: Vec<f64>,
    shape: &[usize],
) -> PyResult<Bound<'py, Numbers>> {
    numbers.into_pyarray(py).reshape(shape)
}

/// Columns by name: a mapping, a structured array, or a data frame of pandas, polars or pyarrow.
pub(crate) struct Frame<'py> {
    parameter: String,
    columns: Bound<'py, PyAny>,
    pub(crate) names: Vec<String>,
}

impl<'py> Frame<'py> {
    /// Columns of an object; the index of a data frame of pandas is one if it has a name.
    ///
    /// # Errors
    /// `TypeError`: the object has no columns.
    pub(crate) fn read(parameter: &str, columns: &Bound<'py, PyAny>) -> PyResult<Self> {
        let attribute = |object: &str, name: &str| {
            let found = columns.getattr(object).and_then(|object| object.getattr(name)).ok();
            found.filter(|found| !found.is_none())
        };
        let columns = match attribute("index", "name") {
            Some(_) => columns.call_method0("reset_index")?,
            None => columns.clone(),
        };
        let own = || ["column_names", "keys", "columns"].iter().find_map(|name| columns.getattr(*name).ok());
        let names = attribute("dtype", "names").or_else(own).ok_or_else(|| {
            let reason = "must be columns by name, as a mapping or a data frame";
            PyTypeError::new_err(format!("{parameter}: {reason}"))
        })?;
        let names = if names.is_callable() { names.call0()? } else { names };
        let names = names.try_iter()?.map(|name| Ok(name?.str()?.to_string())).collect::<PyResult<_>>()?;
        Ok(Self { parameter: parameter.to_owned(), columns, names })
    }

    /// Whether there is a column of this name.
    pub(crate) fn has(&self, name: &str) -> bool {
        self.names.iter().any(|own| own == name)
    }

    /// Name of a column in messages.
    pub(crate) fn full_name(&self, name: &str) -> String {
        format!("{}: {name}", self.parameter)
    }

    /// Column of this name.
    pub(crate) fn column(&self, name: &str) -> PyResult<Bound<'py, PyAny>> {
        self.columns.get_item(name)
    }
}
