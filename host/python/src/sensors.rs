//! Sensors and their samples, as Python gives them.

use crate::arrays::{Frame, Given, array};
use crate::definition::TopDefinition;
use crate::error::{failed, value_error};
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyFloat, PyInt, PyMapping};
use std::path::PathBuf;
use std::{fs, io};
use toml::{Table, Value};
use toytop_host::fit::columns::{Columns, keep_present};
use toytop_host::fit::sensors::{Body, Sensors};

/// Lengths of a top's body that sensors need.
fn body(top: &TopDefinition) -> Body {
    Body::of(&top.top, top.parameters.com_height)
}

/// Sensors of a mapping, of a file, or those of a telephone.
///
/// # Errors
/// `ValueError` that names the key; `OSError` for a file that cannot be read.
pub(crate) fn sensors(given: Option<&Bound<'_, PyAny>>, top: &TopDefinition) -> PyResult<Sensors> {
    let body = body(top);
    let Some(given) = given else { return Ok(Sensors::telephone(body)) };
    let sensors = if let Ok(tables) = given.cast::<PyMapping>() {
        Sensors::of_table("sensors", &table(tables)?, body)
    } else {
        let path: PathBuf = given
            .extract()
            .map_err(|_| PyTypeError::new_err("sensors: must be a mapping or the path of a file"))?;
        let file = path.display().to_string();
        let named = |error: io::Error| io::Error::new(error.kind(), format!("{file}: {error}"));
        Sensors::parse(&file, &fs::read_to_string(&path).map_err(named)?, body)
    };
    sensors.map_err(|failure| failed(&failure))
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
pub(crate) fn columns(samples: &Bound<'_, PyAny>, sensors: &mut Sensors, all: bool) -> PyResult<Columns> {
    let frame = Frame::read("samples", samples)?;
    let has = |name: &str| frame.names.iter().any(|own| own == name);
    if !has("t") {
        return Err(value_error("samples", "must have a column t"));
    }
    keep_present(sensors, has, all).map_err(|reason| value_error("samples", &reason))?;
    let column = |name: &str, rows: Option<usize>| -> PyResult<Vec<f64>> {
        let Given { numbers, shape } = frame.column(name)?;
        let refuse = |reason: String| Err(value_error(&frame.full_name(name), &reason));
        match shape[..] {
            [length] if rows.is_none_or(|rows| rows == length) => Ok(numbers),
            [length] => refuse(format!("must have as many rows as t; has {length}")),
            _ => refuse(format!("must have one axis, not shape {shape:?}")),
        }
    };
    let t = column("t", None)?;
    let wanted = sensors.instruments.iter().flat_map(|instrument| instrument.kind.columns.iter().copied());
    let readings: PyResult<Vec<_>> = wanted.map(|name| Ok((name, column(name, Some(t.len()))?))).collect();
    Ok(Columns { t, readings: readings? })
}

/// Columns as a dictionary of arrays.
pub(crate) fn dictionary<'py>(py: Python<'py>, columns: Columns) -> PyResult<Bound<'py, PyDict>> {
    let shape = [columns.t.len()];
    let dictionary = PyDict::new(py);
    dictionary.set_item("t", array(py, columns.t, &shape, 1)?)?;
    for (name, readings) in columns.readings {
        dictionary.set_item(name, array(py, readings, &shape, 1)?)?;
    }
    Ok(dictionary)
}
