//! `many`: motions on all cores.

use crate::arrays::{Given, Numbers, array, quaternions};
use crate::definition::TopDefinition;
use crate::error::value_error;
use crate::interrupt;
use crate::motion::{PyMotion, Single, furthest, scalar_named};
use crate::releases;
use crate::samples::{Samples, Source};
use crate::top::{PyTop, launched, released};
use pyo3::exceptions::{PyIndexError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{PyIterator, PyList, PySlice};
use std::sync::Arc;
use toytop_page::constants::{CONSTANTS, MotionConstants};

/// Motions of many tops or many launches, computed on all cores without the interpreter's lock.
///
/// An index gives a Motion, a slice another Many with the same tables. The first call of at sets up the tables, some ten kilobytes a
/// motion, which are kept.
#[pyclass(module = "toytop", frozen, sequence)]
pub(crate) struct Many(Vec<Arc<Single>>);

/// Launches: the name of their argument, their number, and the motion of a top from one of them.
type Launches = (&'static str, usize, Box<dyn Fn(&TopDefinition, usize) -> PyResult<Single> + Send + Sync>);

fn launches(
    releases: Option<&Bound<'_, PyAny>>,
    quaternion: Option<&Bound<'_, PyAny>>,
    rates: Option<(&'static str, &Bound<'_, PyAny>)>,
) -> PyResult<Launches> {
    match (releases, quaternion, rates) {
        (Some(releases), None, None) => {
            let releases = releases::read(releases)?;
            Ok(("releases", releases.len(), Box::new(move |top, index| released(top, &releases[index]))))
        }
        (None, Some(quaternion), Some((name, omega))) => {
            let quaternions = quaternions("quaternion", quaternion)?;
            let omega = Given::read(name, omega)?.rows(name)?;
            let count = quaternions.len();
            if omega.len() != count {
                let reason = format!("must have {count} rows, as quaternion; has {}", omega.len());
                return Err(value_error(name, &reason));
            }
            let launch = move |top: &_, index: usize| launched(top, quaternions[index], omega[index], name);
            Ok(("quaternion", count, Box::new(launch)))
        }
        _ => {
            Err(value_error("releases", "must be given, or else quaternion and one of omega and omega_body"))
        }
    }
}

/// Motions of many tops or many launches.
///
/// Args:
///     tops: a Top for all, or a sequence of them.
///     releases: a mapping from the arguments of Top.release to numbers or one-dimensional arrays, such as a dict or a data frame, or a
///         sequence of mappings to numbers.
///     quaternion: in place of releases, an array of shape (n, 4) with w, x, y, z from body to fixed coordinates, or a scipy Rotation.
///     omega: angular velocities in the fixed frame, rad/s, of shape (n, 3); either this or
///     omega_body: angular velocities in the body frame, rad/s, of shape (n, 3).
///
/// Tops and launches are equal in number, or one of them is single.
///
/// Raises:
///     ValueError: a number is out of range; the message names the launch and the number.
#[pyfunction]
#[pyo3(signature = (tops, releases=None, *, quaternion=None, omega=None, omega_body=None))]
pub(crate) fn many(
    py: Python<'_>,
    tops: &Bound<'_, PyAny>,
    releases: Option<&Bound<'_, PyAny>>,
    quaternion: Option<&Bound<'_, PyAny>>,
    omega: Option<&Bound<'_, PyAny>>,
    omega_body: Option<&Bound<'_, PyAny>>,
) -> PyResult<Many> {
    let tops: Vec<TopDefinition> = match tops.cast::<PyTop>() {
        Ok(top) => vec![top.get().0],
        Err(_) => {
            let tops =
                tops.try_iter()?.map(|top| top?.cast::<PyTop>().map(|top| top.get().0).map_err(PyErr::from));
            tops.collect::<PyResult<_>>()?
        }
    };
    let (name, launched, motion) = launches(releases, quaternion, crate::top::rates(omega, omega_body)?)?;
    for (name, length) in [("tops", tops.len()), (name, launched)] {
        if length == 0 {
            return Err(value_error(name, "must not be empty"));
        }
    }
    let count = tops.len().max(launched);
    let fits = |length: usize| length == 1 || length == count;
    if !fits(tops.len()) || !fits(launched) {
        let reason = format!("must be one or {launched} as {name}, not {}", tops.len());
        return Err(value_error("tops", &reason));
    }
    let launch = |index: usize| {
        let top = tops.get(index).unwrap_or(&tops[0]);
        motion(top, if launched == 1 { 0 } else { index }).map(Arc::new)
    };
    let motions = interrupt::map(py, count, launch)?;
    let named = motions.into_iter().enumerate().map(|(index, motion)| {
        motion.map_err(|error| PyValueError::new_err(format!("{name}[{index}]: {}", error.value(py))))
    });
    named.collect::<PyResult<_>>().map(Many)
}

#[pymethods]
impl Many {
    /// Samples of all motions at time t, s: a number or an array for all, whose shape follows the number of motions in the arrays.
    ///
    /// Args:
    ///     scalar: as that of Motion.at.
    ///
    /// Raises:
    ///     ValueError: t is not finite or beyond 2^62 ticks of a motion.
    #[pyo3(signature = (t, *, scalar="f64"))]
    fn at(slf: &Bound<'_, Self>, t: &Bound<'_, PyAny>, scalar: &str) -> PyResult<Samples> {
        let (py, motions) = (slf.py(), &slf.get().0);
        let (times, number) = (Given::read("t", t)?, scalar_named(scalar)?);
        let furthest = furthest(&times);
        let tables = interrupt::map(py, motions.len(), |index| {
            let table = motions[index].table(number)?;
            motions[index].within_reach(furthest).map(|()| table)
        })?;
        let tables = tables.into_iter().collect::<PyResult<_>>()?;
        Ok(Samples::new(times, Some(motions.len()), Source::Tables(tables), crate::motion::at(slf, scalar)?))
    }

    /// Constant of every motion as an array, NaN where it does not exist: e1, e2, e3, e4, l, n, h, period, alpha_turns, beta_turns,
    /// phi_per_period, min_normal_force and others.
    ///
    /// Raises:
    ///     ValueError: there is no constant of this name; the message lists them.
    fn constant<'py>(&self, py: Python<'py>, name: &str) -> PyResult<Bound<'py, Numbers>> {
        let Some((_, of)) = CONSTANTS.iter().find(|(known, _)| *known == name) else {
            let names = CONSTANTS.map(|(name, _)| name).join(", ");
            return Err(value_error("name", &format!("must be one of {names}")));
        };
        let numbers =
            interrupt::map(py, self.0.len(), |index| of(&MotionConstants::new(self.0[index].motion)))?;
        array(py, numbers, &[self.0.len()], 1)
    }

    fn __len__(&self) -> usize {
        self.0.len()
    }

    fn __getitem__<'py>(&self, py: Python<'py>, index: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        if let Ok(slice) = index.cast::<PySlice>() {
            let range = slice.indices(self.0.len() as isize)?;
            let places = (0..range.slicelength as isize).map(|i| (range.start + i * range.step) as usize);
            let chosen = places.map(|place| self.0[place].clone()).collect();
            return Ok(Bound::new(py, Self(chosen))?.into_any());
        }
        let index: isize = index.extract()?;
        let place = if index < 0 { index + self.0.len() as isize } else { index };
        let found = usize::try_from(place).ok().and_then(|place| self.0.get(place));
        let found = found.ok_or_else(|| PyIndexError::new_err("index out of range"))?;
        Ok(Bound::new(py, PyMotion(found.clone()))?.into_any())
    }

    fn __iter__<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyIterator>> {
        PyList::new(py, self.0.iter().map(|motion| PyMotion(motion.clone())))?.try_iter()
    }

    fn __repr__(&self) -> String {
        format!("<Many: {} motions>", self.0.len())
    }

    fn __copy__(slf: Py<Self>) -> Py<Self> {
        slf
    }

    fn __deepcopy__(slf: Py<Self>, _memo: &Bound<'_, PyAny>) -> Py<Self> {
        slf
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, (Bound<'py, PyList>,))> {
        let motions = PyList::new(py, self.0.iter().map(|motion| PyMotion(motion.clone())))?;
        Ok((py.get_type::<Self>().getattr("_of")?, (motions,)))
    }

    /// Many of the motions that pickle has stored.
    #[staticmethod]
    fn _of(motions: Vec<Py<PyMotion>>) -> Self {
        Self(motions.iter().map(|motion| motion.get().0.clone()).collect())
    }
}
