//! Truth of a motion, to more than thirty digits.

use crate::arrays::Given;
use crate::error::{failed, value_error};
use crate::motion::PyMotion;
use crate::point::Point;
use crate::samples::{Samples, Source};
use pyo3::prelude::*;
use rayon::prelude::*;
use toytop_host::motion::ephemeris::ticks_per_time;
use toytop_host::motion::propagate::period;
use toytop_host::motion::tip_angle::TipAngle;
use toytop_host::thread_pool;
use toytop_host::truth::precise::{decimal, precise};

/// Bound on the rounding of α and β to `f64`: 2 √4 2^-54 rad.
const ROUNDING: f64 = 0.25 * f64::EPSILON * 4.0;
/// Least |αβ| at which rounding does not change the argument of αβ noticeably.
const NOISE: f64 = 1e-11;

/// Truth at given times, rounded to `f64`.
pub(crate) fn samples(py: Python<'_>, motion: &PyMotion, times: Given) -> PyResult<Samples> {
    motion.within_reach(&times, ticks_per_time(&motion.motion))?;
    let points = py.detach(|| {
        let (truth, angle) = (motion.truth(), TipAngle::of(&motion.motion)?);
        let unit = period(&motion.motion);
        let point = |&t: &f64| {
            let orientation = truth.at(&precise(t)).to_f64();
            Point {
                orientation,
                omega_body: truth.rates(&precise(t), unit).omega_body,
                tip_angle: angle
                    .continued(t, orientation.alpha * orientation.beta, NOISE)
                    .unwrap_or(f64::NAN),
                tip_scale: motion.motion.top().tip_scale(),
                error_bound: ROUNDING,
            }
        };
        let cores = thread_pool::of_all_cores()?;
        Ok(cores.install(|| times.numbers.par_iter().map(point).collect()))
    });
    let points = points.map_err(|failure| failed(&failure))?;
    Ok(Samples::new(times, Source::Points(points)))
}

/// Decimal digits of the quaternions at given times, as an array of `decimal.Decimal`.
pub(crate) fn digits<'py>(
    py: Python<'py>,
    motion: &PyMotion,
    times: Given,
    digits: usize,
) -> PyResult<Bound<'py, PyAny>> {
    if !(1..=50).contains(&digits) {
        return Err(value_error("digits", "must be between 1 and 50"));
    }
    motion.within_reach(&times, ticks_per_time(&motion.motion))?;
    let texts: Vec<String> = py.detach(|| {
        let truth = motion.truth();
        let quaternion = |&t: &f64| {
            let phi = truth.at(&precise(t));
            let [[w, z], [y, x]] = [phi.alpha, phi.beta];
            [w, x, -y, z].map(|component| decimal(&component, digits))
        };
        times.numbers.iter().flat_map(quaternion).collect()
    });
    let exact = py.import("decimal")?.getattr("Decimal")?;
    let numbers = texts.into_iter().map(|text| exact.call1((text,))).collect::<PyResult<Vec<_>>>()?;
    let mut shape = times.shape;
    shape.push(4);
    py.import("numpy")?.call_method1("array", (numbers, "object"))?.call_method1("reshape", (shape,))
}
