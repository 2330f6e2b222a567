//! Functions of the Python module `many`.

use crate::arguments::{Given, Numbers, array, value_error};
use crate::interrupt;
use crate::launch::{Launch, rates};
use crate::motion::{PyMotion, scalar_named};
use crate::samples::{Samples, Source};
use crate::top::PyTop;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use toytop_model::constants::{CONSTANTS, MotionConstants};

/// Motions of many tops or many launches, in equal number or one of them single.
///
/// * `releases`: rows of tilt, spin, precession, nutation, azimuth and roll, in place of `quaternion` and one of the rates
///
/// # Errors
/// `ValueError` that names the launch and the parameter.
#[pyfunction]
pub(crate) fn launched(
    py: Python<'_>,
    tops: Vec<Py<PyTop>>,
    releases: Option<&Bound<'_, PyAny>>,
    quaternion: Option<&Bound<'_, PyAny>>,
    omega: Option<&Bound<'_, PyAny>>,
    omega_body: Option<&Bound<'_, PyAny>>,
) -> PyResult<Vec<PyMotion>> {
    let (name, launches): (_, Vec<Launch>) = match (releases, quaternion, rates(omega, omega_body)?) {
        (Some(releases), None, None) => {
            let releases = Given::read("releases", releases)?;
            ("releases", releases.rows("releases")?.iter().copied().map(Launch::Release).collect())
        }
        (None, Some(quaternion), Some((name, omega))) => {
            let (quaternions, omega) = (Given::read("quaternion", quaternion)?, Given::read(name, omega)?);
            let (quaternions, omega) = (quaternions.rows("quaternion")?, omega.rows(name)?);
            if omega.len() != quaternions.len() {
                let (wanted, rows) = (quaternions.len(), omega.len());
                return Err(value_error(name, format!("must have {wanted} rows, as quaternion; has {rows}")));
            }
            let launch = |(quaternion, omega): (&_, &_)| Launch::Attitude {
                quaternion: *quaternion,
                omega: *omega,
                name,
            };
            ("quaternion", quaternions.iter().zip(omega).map(launch).collect())
        }
        _ => {
            let reason = "must be given, or else quaternion and one of omega and omega_body";
            return Err(value_error("releases", reason));
        }
    };
    for (name, length) in [("tops", tops.len()), (name, launches.len())] {
        if length == 0 {
            return Err(value_error(name, "must not be empty"));
        }
    }
    let count = tops.len().max(launches.len());
    if ![tops.len(), launches.len()].iter().all(|length| [1, count].contains(length)) {
        let reason = format!("must be one or {} as {name}, not {}", launches.len(), tops.len());
        return Err(value_error("tops", reason));
    }
    let motions = interrupt::map(py, count, |index| {
        let top = tops.get(index).unwrap_or(&tops[0]).get();
        top.launched(launches.get(index).unwrap_or(&launches[0]))
    })?;
    let named = motions.into_iter().enumerate().map(|(index, motion)| {
        motion.map_err(|error| PyValueError::new_err(format!("{name}[{index}]: {}", error.value(py))))
    });
    named.collect()
}

/// Samples of all motions of a `Many` at time t, s.
#[pyfunction]
pub(crate) fn samples(
    many: Bound<'_, PyAny>,
    motions: Vec<Py<PyMotion>>,
    t: Given,
    scalar: &str,
) -> PyResult<Samples> {
    let scalar = scalar_named(scalar)?;
    let table = |index: usize| motions[index].get().table_for(scalar, &t.numbers);
    let tables = interrupt::map(many.py(), motions.len(), table)?.into_iter().collect::<PyResult<_>>()?;
    Ok(Samples::new((many.unbind(), "at", Some(scalar)), t, Some(motions.len()), Source::Tables(tables)))
}

/// Constant of each motion as an array.
#[pyfunction]
pub(crate) fn constant<'py>(
    py: Python<'py>,
    motions: Vec<Py<PyMotion>>,
    name: &str,
) -> PyResult<Bound<'py, Numbers>> {
    let Some((_, of)) = CONSTANTS.iter().find(|(known, _)| *known == name) else {
        let names = CONSTANTS.map(|(name, _)| name).join(", ");
        return Err(value_error("name", format!("must be one of {names}")));
    };
    let number = |index: usize| of(&MotionConstants::new(motions[index].get().motion));
    array(py, interrupt::map(py, motions.len(), number)?, &[motions.len()])
}
