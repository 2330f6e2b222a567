//! Launches of tops, and how Python gives them.

use crate::arrays::{Frame, Given, quaternions};
use crate::error::{refused, renamed, value_error};
use crate::motion::{Single, TopDefinition};
use pyo3::prelude::*;
use pyo3::types::{PyList, PyTuple};
use std::sync::Arc;
use toytop::{Orientation, ParameterError, Release, State};

/// Launch of a top.
#[derive(Clone, Copy)]
pub(crate) enum Launch {
    Release(Release),
    Attitude {
        quaternion: [f64; 4],
        omega: [f64; 3],
        /// Name of the argument ω: `omega` in the fixed frame, `omega_body` in the body frame.
        name: &'static str,
    },
}

impl Launch {
    /// Motion of a top from this launch.
    ///
    /// # Errors
    /// `ValueError` that names the parameter.
    pub(crate) fn of(self, top: &TopDefinition) -> PyResult<Arc<Single>> {
        let (state, rate) = match self {
            Self::Release(release) => {
                let Release { spin, precession, nutation, .. } = release;
                let rates = [("spin", spin), ("precession", precession), ("nutation", nutation)];
                let fastest = rates.into_iter().max_by(|(_, x), (_, y)| x.abs().total_cmp(&y.abs()));
                (State::release(&release).map_err(refused)?, fastest.map_or("spin", |(name, _)| name))
            }
            Self::Attitude { quaternion, omega, name } => {
                let state = match name {
                    "omega" => State::new(Orientation::from_quaternion(quaternion), omega),
                    _ => State::from_quaternion_and_gyro(quaternion, omega),
                };
                let refuse = |error: ParameterError| match error.parameter() {
                    "alpha" | "beta" => {
                        let reason = "must be of unit norm: | w^2 + x^2 + y^2 + z^2 - 1 | <= 1e-6";
                        value_error("quaternion", reason)
                    }
                    _ => renamed(error, &[("gyro", name)]),
                };
                (state.map_err(refuse)?, name)
            }
        };
        Single::launched(top, &state, rate)
    }
}

/// Name and value of the one of two arguments that is given; `None` where neither is.
///
/// # Errors
/// `ValueError`: both are given.
pub(crate) fn rates<'a, 'py>(
    omega: Option<&'a Bound<'py, PyAny>>,
    omega_body: Option<&'a Bound<'py, PyAny>>,
) -> PyResult<Option<(&'static str, &'a Bound<'py, PyAny>)>> {
    match (omega, omega_body) {
        (Some(_), Some(_)) => Err(value_error("omega", "must be left out if omega_body is given")),
        (Some(omega), None) => Ok(Some(("omega", omega))),
        (None, omega_body) => Ok(omega_body.map(|omega| ("omega_body", omega))),
    }
}

/// Launches from quaternions and the angular velocities that are the argument `name`.
///
/// # Errors
/// `ValueError` that names the parameter.
pub(crate) fn attitudes(
    quaternion: &Bound<'_, PyAny>,
    (name, omega): (&'static str, &Bound<'_, PyAny>),
) -> PyResult<Vec<Launch>> {
    let quaternions = quaternions("quaternion", quaternion)?;
    let omega = Given::read(name, omega)?.rows(name)?;
    if omega.len() != quaternions.len() {
        let reason = format!("must have {} rows, as quaternion; has {}", quaternions.len(), omega.len());
        return Err(value_error(name, reason));
    }
    let launches = quaternions.into_iter().zip(omega);
    Ok(launches.map(|(quaternion, omega)| Launch::Attitude { quaternion, omega, name }).collect())
}

/// Numbers of a release by their names.
const NAMES: [&str; 6] = ["tilt", "spin", "precession", "nutation", "azimuth", "roll"];
/// Number of the names, from the first, that must be given.
const REQUIRED: usize = 2;

/// Releases: columns of numbers or of one-dimensional arrays, or a sequence of mappings to numbers.
///
/// # Errors
/// `ValueError`: a name is unknown or missing, or the arrays differ in length.
pub(crate) fn releases(releases: &Bound<'_, PyAny>) -> PyResult<Vec<Launch>> {
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

fn of_frame(frame: &Frame<'_>) -> PyResult<Vec<Launch>> {
    if let Some(name) = frame.names.iter().find(|name| !NAMES.contains(&name.as_str())) {
        return Err(value_error(&frame.full_name(name), format!("unknown; allowed: {}", NAMES.join(", "))));
    }
    let mut columns = NAMES.map(|_| Given { numbers: vec![0.0], shape: Vec::new() });
    for (index, (name, column)) in NAMES.iter().zip(&mut columns).enumerate() {
        if frame.has(name) {
            *column = Given::read(&frame.full_name(name), &frame.column(name)?)?;
        } else if index < REQUIRED {
            return Err(value_error(&frame.full_name(name), "missing"));
        }
    }
    // a number counts for all releases, and so does an array of one number
    let arrays = columns.iter().filter(|column| !column.shape.is_empty());
    let lengths = arrays.map(|column| column.numbers.len());
    let length = lengths.clone().find(|length| *length != 1).or(lengths.clone().next()).unwrap_or(1);
    for (name, Given { numbers, shape }) in NAMES.iter().zip(&columns) {
        if shape.len() > 1 || ![1, length].contains(&numbers.len()) {
            let reason = format!("must be a number or of shape ({length},), as the others");
            return Err(value_error(&frame.full_name(name), reason));
        }
    }
    let release = |index: usize| {
        let [tilt, spin, precession, nutation, azimuth, roll] =
            columns.each_ref().map(|Given { numbers, .. }| *numbers.get(index).unwrap_or(&numbers[0]));
        Launch::Release(Release { tilt, azimuth, roll, spin, precession, nutation })
    };
    Ok((0..length).map(release).collect())
}
