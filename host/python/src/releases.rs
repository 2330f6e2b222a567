//! Many releases from Python: arrays by name, or one mapping each.

use crate::arrays::{Frame, Given};
use crate::error::value_error;
use pyo3::prelude::*;
use pyo3::types::{PyList, PyTuple};
use toytop::Release;

/// Numbers of a release by their names.
const NAMES: [&str; 6] = ["tilt", "spin", "precession", "nutation", "azimuth", "roll"];

/// Number of the names, from the first, that must be given.
const REQUIRED: usize = 2;

/// Releases: columns of numbers or of one-dimensional arrays, or a sequence of mappings to numbers.
///
/// # Errors
/// `ValueError`: a name is unknown or missing, or the arrays differ in length.
pub(crate) fn read(releases: &Bound<'_, PyAny>) -> PyResult<Vec<Release>> {
    if !releases.is_instance_of::<PyList>() && !releases.is_instance_of::<PyTuple>() {
        return of_frame(&Frame::read("releases", releases)?);
    }
    let mut read = Vec::new();
    for (index, release) in releases.try_iter()?.enumerate() {
        let name = format!("releases[{index}]");
        let [release] = of_frame(&Frame::read(&name, &release?)?)?[..] else {
            return Err(value_error(&name, "must hold numbers, not arrays"));
        };
        read.push(release);
    }
    Ok(read)
}

fn of_frame(frame: &Frame<'_>) -> PyResult<Vec<Release>> {
    if let Some(name) = frame.names.iter().find(|name| !NAMES.contains(&name.as_str())) {
        return Err(value_error(&frame.full_name(name), &format!("unknown; allowed: {}", NAMES.join(", "))));
    }
    let mut columns = NAMES.map(|_| None);
    for (index, (name, column)) in NAMES.iter().zip(&mut columns).enumerate() {
        if frame.names.iter().any(|given| given == name) {
            *column = Some(Given::finite(frame.column(name)?, &frame.full_name(name))?);
        } else if index < REQUIRED {
            return Err(value_error(&frame.full_name(name), "missing"));
        }
    }
    // a number counts for all releases, and so does an array of one number
    let lengths =
        || columns.iter().flatten().filter(|given| !given.shape.is_empty()).map(|given| given.numbers.len());
    let length = lengths().find(|length| *length != 1).or(lengths().next()).unwrap_or(1);
    for (name, given) in NAMES.iter().zip(&columns) {
        let fits = |given: &Given| given.shape.len() < 2 && [1, length].contains(&given.numbers.len());
        if !given.as_ref().is_none_or(fits) {
            let reason = format!("must be a number or of shape ({length},), as the others");
            return Err(value_error(&frame.full_name(name), &reason));
        }
    }
    let release = |index: usize| {
        let [tilt, spin, precession, nutation, azimuth, roll] = columns.each_ref().map(|given| {
            let numbers = given.as_ref().map_or(&[0.0][..], |given| &given.numbers);
            *numbers.get(index).unwrap_or(&numbers[0])
        });
        Release { tilt, azimuth, roll, spin, precession, nutation }
    };
    Ok((0..length).map(release).collect())
}
