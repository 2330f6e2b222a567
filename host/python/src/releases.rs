//! Many releases from Python: arrays by name, or one mapping each.

use crate::arrays::Given;
use crate::error::value_error;
use pyo3::prelude::*;
use toytop::Release;

/// Numbers of a release by their names.
const NAMES: [&str; 6] = ["tilt", "spin", "precession", "nutation", "azimuth", "roll"];

/// Number of the names, from the first, that must be given.
const REQUIRED: usize = 2;

/// Releases: a mapping from names to numbers or one-dimensional arrays, or a sequence of mappings to numbers.
///
/// # Errors
/// `ValueError`: a name is unknown or missing, or the arrays differ in length.
pub(crate) fn read(releases: &Bound<'_, PyAny>) -> PyResult<Vec<Release>> {
    if releases.hasattr("keys")? {
        return of_arrays("releases", releases);
    }
    let mut read = Vec::new();
    for (index, release) in releases.try_iter()?.enumerate() {
        let name = format!("releases[{index}]");
        let [release] = of_arrays(&name, &release?)?[..] else {
            return Err(value_error(&name, "must hold numbers, not arrays"));
        };
        read.push(release);
    }
    Ok(read)
}

fn of_arrays(place: &str, releases: &Bound<'_, PyAny>) -> PyResult<Vec<Release>> {
    let columns = columns(place, releases)?;
    let lengths = columns.iter().flatten().filter(|given| !given.shape.is_empty());
    let length = lengths.map(|given| given.numbers.len()).max().unwrap_or(1);
    for (name, given) in NAMES.iter().zip(&columns) {
        if given
            .as_ref()
            .is_some_and(|given| ![1, length].contains(&given.numbers.len()) || given.shape.len() > 1)
        {
            let reason = format!("must be a number or of shape ({length},), as the longest");
            return Err(value_error(&format!("{place}: {name}"), &reason));
        }
    }
    let release = |index: usize| {
        let [tilt, spin, precession, nutation, azimuth, roll] = columns.each_ref().map(|given| match given {
            None => 0.0,
            Some(Given { numbers, .. }) => {
                if let [only] = numbers[..] {
                    only
                } else {
                    numbers[index]
                }
            }
        });
        Release { tilt, azimuth, roll, spin, precession, nutation }
    };
    Ok((0..length).map(release).collect())
}

fn columns(place: &str, releases: &Bound<'_, PyAny>) -> PyResult<[Option<Given>; NAMES.len()]> {
    let allowed = NAMES.join(", ");
    for key in releases.call_method0("keys")?.try_iter()? {
        let key: String = key?.str()?.extract()?;
        if !NAMES.contains(&key.as_str()) {
            return Err(value_error(&format!("{place}: {key}"), &format!("unknown; allowed: {allowed}")));
        }
    }
    let mut columns = NAMES.map(|_| None);
    for (index, (name, column)) in NAMES.iter().zip(&mut columns).enumerate() {
        let full_name = format!("{place}: {name}");
        if releases.contains(name)? {
            *column = Some(Given::read(&full_name, &releases.get_item(name)?)?);
        } else if index < REQUIRED {
            return Err(value_error(&full_name, "missing"));
        }
    }
    Ok(columns)
}
