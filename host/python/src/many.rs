//! `many`: motions on all cores.

use crate::arrays::{Given, Numbers, array};
use crate::error::value_error;
use crate::interrupt;
use crate::launch::{attitudes, rates, releases};
use crate::motion::{PyMotion, Single, TopDefinition, scalar_named};
use crate::samples::{Samples, Source};
use crate::top::PyTop;
use pyo3::exceptions::{PyIndexError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{PyIterator, PyList, PySlice};
use std::sync::Arc;
use toytop_model::constants::{CONSTANTS, MotionConstants};

/// Motions of many tops or many launches, computed on all cores without the interpreter's lock.
///
/// An index gives a Motion, a slice another Many with the same tables. The first call of at sets up the tables, some ten kilobytes a
/// motion, which are kept.
#[pyclass(module = "toytop", frozen, sequence)]
pub(crate) struct Many(Vec<Arc<Single>>);

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
            tops.try_iter()?.map(|top| Ok(top?.cast_into::<PyTop>()?.get().0)).collect::<PyResult<_>>()?
        }
    };
    let (name, launches) = match (releases, quaternion, rates(omega, omega_body)?) {
        (Some(releases), None, None) => ("releases", self::releases(releases)?),
        (None, Some(quaternion), Some(rates)) => ("quaternion", attitudes(quaternion, rates)?),
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
        launches.get(index).unwrap_or(&launches[0]).of(tops.get(index).unwrap_or(&tops[0]))
    })?;
    let named = motions.into_iter().enumerate().map(|(index, motion)| {
        motion.map_err(|error| PyValueError::new_err(format!("{name}[{index}]: {}", error.value(py))))
    });
    named.collect::<PyResult<_>>().map(Many)
}

impl Many {
    /// Motions as objects of Python.
    fn motions<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyList>> {
        PyList::new(py, self.0.iter().map(|motion| PyMotion(motion.clone())))
    }
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
    fn at(slf: &Bound<'_, Self>, t: Given, scalar: &str) -> PyResult<Samples> {
        let (motions, scalar) = (&slf.get().0, scalar_named(scalar)?);
        let tables =
            interrupt::map(slf.py(), motions.len(), |index| motions[index].table_for(scalar, &t.numbers))?;
        let tables = tables.into_iter().collect::<PyResult<_>>()?;
        let origin = slf.clone().into_any().unbind();
        Ok(Samples::new((origin, "at", Some(scalar)), t, Some(motions.len()), Source::Tables(tables)))
    }

    /// Constant of every motion as an array, NaN where it does not exist: e1, e2, e3, e4, l, n, h, period, alpha_turns, beta_turns,
    /// phi_per_period, min_normal_force and others.
    ///
    /// Raises:
    ///     ValueError: there is no constant of this name; the message lists them.
    fn constant<'py>(&self, py: Python<'py>, name: &str) -> PyResult<Bound<'py, Numbers>> {
        let Some((_, of)) = CONSTANTS.iter().find(|(known, _)| *known == name) else {
            let names = CONSTANTS.map(|(name, _)| name).join(", ");
            return Err(value_error("name", format!("must be one of {names}")));
        };
        let numbers =
            interrupt::map(py, self.0.len(), |index| of(&MotionConstants::new(self.0[index].motion)))?;
        array(py, numbers, &[self.0.len()])
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
        self.motions(py)?.try_iter()
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
        Ok((py.get_type::<Self>().getattr("_of")?, (self.motions(py)?,)))
    }

    /// Many of the motions that pickle has stored.
    #[staticmethod]
    fn _of(motions: Vec<Py<PyMotion>>) -> Self {
        Self(motions.iter().map(|motion| motion.get().0.clone()).collect())
    }
}
