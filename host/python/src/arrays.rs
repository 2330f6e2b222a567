//! Conversion of arrays of NumPy to and from numbers.

use crate::error::value_error;
use numpy::ndarray::{ArrayD, IxDyn};
use numpy::{IntoPyArray, PyArrayDyn, PyArrayMethods, PyUntypedArrayMethods};
use pyo3::exceptions::PyTypeError;
use pyo3::intern;
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::{PyFloat, PyInt};

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
        Self::finite(Self::read_any(name, object)?, name)
    }

    /// The same numbers, if they are finite.
    ///
    /// # Errors
    /// `ValueError` that names the parameter.
    pub(crate) fn finite(self, name: &str) -> PyResult<Self> {
        match self.numbers.iter().all(|x| x.is_finite()) {
            true => Ok(self),
            false => Err(value_error(name, "must be finite")),
        }
    }

    /// Numbers, finite or not, of anything that `numpy.asarray` makes an array of.
    ///
    /// # Errors
    /// `ValueError` that names the parameter: no numbers, but dates, intervals, texts, or an array with a mask.
    pub(crate) fn read_any(name: &str, object: &Bound<'_, PyAny>) -> PyResult<Self> {
        Ok(if object.is_instance_of::<PyFloat>() || object.is_exact_instance_of::<PyInt>() {
            Self { numbers: vec![object.extract()?], shape: Vec::new() }
        } else {
            let array = as_array(name, object)?.try_readonly()?;
            let numbers = match array.as_slice() {
                Ok(numbers) if array.is_c_contiguous() => numbers.to_vec(),
                _ => array.as_array().iter().copied().collect(),
            };
            Self { numbers, shape: array.shape().to_vec() }
        })
    }

    /// Finite number.
    ///
    /// # Errors
    /// `ValueError` that names the parameter.
    pub(crate) fn number(name: &str, object: &Bound<'_, PyAny>) -> PyResult<f64> {
        match Self::read(name, object)? {
            Self { numbers, shape } if shape.is_empty() => Ok(numbers[0]),
            Self { shape, .. } => {
                Err(value_error(name, &format!("must be a number, not of shape {shape:?}")))
            }
        }
    }

    /// Numbers in rows of N, for an array of two axes whose last one has that length.
    ///
    /// # Errors
    /// `ValueError`: another shape.
    pub(crate) fn rows<const N: usize>(&self, name: &str) -> PyResult<Vec<[f64; N]>> {
        match self.shape[..] {
            [_, last] if last == N => Ok(self.numbers.as_chunks().0.to_vec()),
            _ => Err(value_error(name, &format!("must be of shape (n, {N}), not {:?}", self.shape))),
        }
    }
}

/// N finite numbers.
///
/// # Errors
/// `ValueError` that names the parameter.
pub(crate) fn vector<const N: usize>(name: &str, object: &Bound<'_, PyAny>) -> PyResult<[f64; N]> {
    one(name, &Given::read(name, object)?)
}

fn one<const N: usize>(name: &str, given: &Given) -> PyResult<[f64; N]> {
    let Given { numbers, shape } = given;
    let wrong = || value_error(name, &format!("must be {N} numbers, not of shape {shape:?}"));
    if shape.len() == 1 { numbers[..].try_into().map_err(|_| wrong()) } else { Err(wrong()) }
}

/// Quaternion w, x, y, z: 4 numbers, or a single `scipy.spatial.transform.Rotation`.
///
/// # Errors
/// `ValueError` that names the parameter.
pub(crate) fn quaternion(name: &str, object: &Bound<'_, PyAny>) -> PyResult<[f64; 4]> {
    one(name, &scalar_first(name, object)?)
}

/// Quaternions w, x, y, z: an array of shape (n, 4), or a `scipy.spatial.transform.Rotation`.
///
/// # Errors
/// `ValueError` that names the parameter.
pub(crate) fn quaternions(name: &str, object: &Bound<'_, PyAny>) -> PyResult<Vec<[f64; 4]>> {
    scalar_first(name, object)?.rows(name)
}

fn scalar_first(name: &str, object: &Bound<'_, PyAny>) -> PyResult<Given> {
    let py = object.py();
    if !object.hasattr(intern!(py, "as_quat"))? {
        return Given::read(name, object);
    }
    let mut given = Given::read(name, &object.call_method0(intern!(py, "as_quat"))?)?;
    given.numbers.as_chunks_mut::<4>().0.iter_mut().for_each(|row| row.rotate_right(1));
    Ok(given)
}

fn as_array<'py>(name: &str, object: &Bound<'py, PyAny>) -> PyResult<Bound<'py, Numbers>> {
    static ASARRAY: PyOnceLock<Py<PyAny>> = PyOnceLock::new();
    if let Ok(array) = object.cast_exact::<Numbers>() {
        return Ok(array.clone());
    }
    let py = object.py();
    let no_numbers = |error: PyErr| value_error(name, &format!("must be numbers ({})", error.value(py)));
    let asarray = ASARRAY.import(py, "numpy", "asarray")?;
    let array = asarray.call1((object,)).map_err(no_numbers)?;
    let dtype = array.getattr(intern!(py, "dtype"))?;
    let kind: String = dtype.getattr(intern!(py, "kind"))?.extract()?;
    if !"iufO".contains(&kind) {
        return Err(value_error(name, &format!("must be numbers, not {}", dtype.str()?)));
    }
    if object.hasattr(intern!(py, "mask"))? && object.hasattr(intern!(py, "filled"))? {
        return Err(value_error(name, "must have no mask: use its method filled or compressed"));
    }
    let array = asarray.call1((array, py.get_type::<PyFloat>())).map_err(no_numbers)?;
    Ok(array.cast_into::<Numbers>()?)
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

/// [`array`], which cannot be written to.
pub(crate) fn constant_array<'py>(
    py: Python<'py>,
    numbers: Vec<f64>,
    shape: &[usize],
    width: usize,
) -> PyResult<Bound<'py, Numbers>> {
    let array = array(py, numbers, shape, width)?;
    array.readwrite().make_nonwriteable();
    Ok(array)
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
        let attribute = |name: &str| columns.getattr_opt(name);
        let fields = attribute("dtype")?.map(|dtype| dtype.getattr_opt("names")).transpose()?.flatten();
        let mut columns = columns.clone();
        let names = match fields.filter(|names| !names.is_none()) {
            Some(names) => names,
            None => {
                if attribute("index")?
                    .is_some_and(|index| index.getattr("name").is_ok_and(|name| !name.is_none()))
                {
                    columns = columns.call_method0("reset_index")?;
                }
                match columns.getattr_opt("column_names")? {
                    Some(names) => names,
                    None if columns.hasattr("keys")? => columns.call_method0("keys")?,
                    None => columns.getattr("columns").map_err(|_| {
                        PyTypeError::new_err(format!(
                            "{parameter}: must be columns by name, as a mapping or a data frame"
                        ))
                    })?,
                }
            }
        };
        let names = names.try_iter()?.map(|name| Ok(name?.str()?.to_string())).collect::<PyResult<_>>()?;
        Ok(Self { parameter: parameter.to_owned(), columns, names })
    }

    /// Name of a column in messages.
    pub(crate) fn full_name(&self, name: &str) -> String {
        format!("{}: {name}", self.parameter)
    }

    /// Column of this name.
    ///
    /// # Errors
    /// `ValueError` that names the column: no numbers.
    pub(crate) fn column(&self, name: &str) -> PyResult<Given> {
        Given::read_any(&self.full_name(name), &self.columns.get_item(name)?)
    }
}
