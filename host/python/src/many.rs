//! `many`: motions on all cores.

use crate::arrays::{Given, Numbers, array};
use crate::definition::TopDefinition;
use crate::error::{failed, value_error};
use crate::motion::PyMotion;
use crate::point::Point;
use crate::releases;
use crate::samples::{Samples, Source};
use crate::top::{PyTop, released};
use pyo3::exceptions::{PyIndexError, PyValueError};
use pyo3::prelude::*;
use rayon::prelude::*;
use toytop::{Motion, Release};
use toytop_host::Failure;
use toytop_host::motion::Scalar;
use toytop_host::motion::ephemeris::{furthest_time, smallest_with_period, ticks_for};
use toytop_host::motion::propagate::period;
use toytop_host::thread_pool;
use toytop_page::constants::CONSTANTS;

/// Motions of many tops or many releases, computed on all cores without the interpreter's lock.
#[pyclass(module = "toytop", frozen)]
pub(crate) struct Many {
    motions: Vec<(TopDefinition, Release, Motion)>,
}

/// Motions of many tops or many releases.
///
/// Args:
///     tops: a Top for all, or a sequence of them.
///     releases: a mapping from the arguments of Top.release to numbers or one-dimensional arrays, such as a dict or a data frame, or a
///         sequence of mappings to numbers. Tops and releases are equal in number, or one of them is single.
///
/// Raises:
///     ValueError: a number is out of range; the message names the release and the number.
#[pyfunction]
pub(crate) fn many(py: Python<'_>, tops: &Bound<'_, PyAny>, releases: &Bound<'_, PyAny>) -> PyResult<Many> {
    let tops: Vec<TopDefinition> = match tops.cast::<PyTop>() {
        Ok(top) => vec![top.get().0],
        Err(_) => {
            let tops =
                tops.try_iter()?.map(|top| top?.cast::<PyTop>().map(|top| top.get().0).map_err(PyErr::from));
            tops.collect::<PyResult<_>>()?
        }
    };
    let releases = releases::read(releases)?;
    let count = tops.len().max(releases.len());
    let fits = |length: usize| length == 1 || length == count;
    if !fits(tops.len()) || !fits(releases.len()) {
        let reason = format!("must be one or {} as the releases, not {}", releases.len(), tops.len());
        return Err(value_error("tops", &reason));
    }
    let launch = |index: usize| {
        let top = tops.get(index).unwrap_or(&tops[0]);
        let release = releases.get(index).unwrap_or(&releases[0]);
        let launched = released(top, release);
        launched.map(|motion| (*top, *release, motion.motion)).map_err(|error| (index, error))
    };
    let motions: Result<Vec<_>, _> = py.detach(|| {
        let cores = thread_pool::of_all_cores().map_err(|failure| (0, failed(&failure)))?;
        cores.install(|| (0..count).into_par_iter().map(launch).collect())
    });
    let named = |(index, error): (usize, PyErr)| {
        PyValueError::new_err(format!("releases[{index}]: {}", error.value(py)))
    };
    Ok(Many { motions: motions.map_err(named)? })
}

#[pymethods]
impl Many {
    /// Samples of all motions at time t, s: a number or an array for all, whose shape follows the number of motions in the arrays.
    ///
    /// Raises:
    ///     ValueError: t is not finite or beyond 2^62 ticks of a motion.
    fn at(&self, py: Python<'_>, t: &Bound<'_, PyAny>) -> PyResult<Samples> {
        let times = Given::read("t", t)?;
        let points: Result<Vec<Vec<Point>>, Failure> = py.detach(|| {
            let cores = thread_pool::of_all_cores()?;
            cores.install(|| {
                let points = |(.., motion): &(_, _, Motion)| points(motion, &times.numbers);
                self.motions.par_iter().map(points).collect()
            })
        });
        let points = points.map_err(|failure| failed(&failure))?.into_iter().flatten().collect();
        let mut shape = vec![self.motions.len()];
        shape.extend(&times.shape);
        let numbers = times.numbers.repeat(self.motions.len());
        Ok(Samples::new(Given { numbers, shape }, Source::Points(points)))
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
        let numbers = py.detach(|| self.motions.iter().map(|(.., motion)| of(motion)).collect());
        array(py, numbers, &[self.motions.len()], 1)
    }

    fn __len__(&self) -> usize {
        self.motions.len()
    }

    fn __getitem__(&self, index: isize) -> PyResult<PyMotion> {
        let place = if index < 0 { index + self.motions.len() as isize } else { index };
        let found = usize::try_from(place).ok().and_then(|place| self.motions.get(place));
        let (top, release, _) = found.ok_or_else(|| PyIndexError::new_err("index out of range"))?;
        released(top, release)
    }

    fn __repr__(&self) -> String {
        format!("<Many: {} motions>", self.motions.len())
    }
}

/// Points of one motion.
fn points(motion: &Motion, times: &[f64]) -> Result<Vec<Point>, Failure> {
    let reach = furthest_time(motion);
    if let Some(t) = times.iter().find(|t| t.abs() > reach) {
        return Err(Failure::Input(format!("t: {t:e} must be within ±{reach:.1e}")));
    }
    let period = period(motion);
    let (table, ticks) = (smallest_with_period(Scalar::F64, motion, period)?, ticks_for(motion, period));
    let bound = table.error_bound();
    let point = |&t: &f64| {
        let now = table.at(t);
        let orientation = now.sample.orientation();
        Point {
            orientation,
            omega_body: now.rate.omega_body(&orientation),
            tip_angle: now.sample.phi.unwrap_or(f64::NAN),
            tip_scale: motion.top().tip_scale(),
            error_bound: bound.after(t * ticks),
        }
    };
    Ok(times.iter().map(point).collect())
}
