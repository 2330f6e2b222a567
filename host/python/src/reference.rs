//! Truth of a motion, to more than thirty digits.

use crate::arrays::Given;
use crate::error::{failed, value_error};
use crate::interrupt;
use crate::motion::{PyMotion, Single, furthest};
use crate::samples::{Samples, Source};
use pyo3::prelude::*;
use toytop_host::motion::propagate::{Sample, period};
use toytop_host::motion::tip_angle::TipAngle;
use toytop_host::truth::precise::{decimal, precise};

/// Bound on the rounding of α and β to `f64`: 2 √4 2^-54 rad.
const ROUNDING: f64 = 0.25 * f64::EPSILON * 4.0;
/// Least |αβ| at which rounding does not change the argument of αβ noticeably.
const NOISE: f64 = 1e-11;

/// Truth at given times, rounded to `f64`.
pub(crate) fn samples(motion: &Bound<'_, PyMotion>, times: Given) -> PyResult<Samples> {
    let (py, single) = (motion.py(), &motion.get().0);
    single.within_reach(furthest(&times))?;
    let angle = TipAngle::of(&single.motion, NOISE).map_err(|failure| failed(&failure))?;
    let (truth, unit) = (py.detach(|| single.truth()), period(&single.motion));
    let points = interrupt::map(py, times.numbers.len(), |index| {
        let t = times.numbers[index];
        let orientation = truth.at(&precise(t)).to_f64();
        let rates = truth.rates(&precise(t), unit);
        let sample = angle.sample(t, orientation, rates.omega, rates.udot);
        Sample { error_bound: Some(ROUNDING), ..sample }
    })?;
    Ok(Samples::new(times, None, Source::Points(points), motion.getattr("reference")?))
}

/// Decimal digits of the quaternions at given times, as an array of `decimal.Decimal`.
pub(crate) fn digits<'py>(
    py: Python<'py>,
    motion: &Single,
    times: Given,
    digits: i64,
) -> PyResult<Bound<'py, PyAny>> {
    let digits = usize::try_from(digits).ok().filter(|digits| (1..=50).contains(digits));
    let digits = digits.ok_or_else(|| value_error("digits", "must be between 1 and 50"))?;
    motion.within_reach(furthest(&times))?;
    let truth = py.detach(|| motion.truth());
    let texts = interrupt::map(py, times.numbers.len(), |index| {
        let phi = truth.at(&precise(times.numbers[index]));
        let [[w, z], [y, x]] = [phi.alpha, phi.beta];
        [w, x, -y, z].map(|component| decimal(&component, digits))
    })?;
    let exact = py.import("decimal")?.getattr("Decimal")?;
    let numbers =
        texts.into_iter().flatten().map(|text| exact.call1((text,))).collect::<PyResult<Vec<_>>>()?;
    let mut shape = times.shape;
    shape.push(4);
    py.import("numpy")?.call_method1("array", (numbers, "object"))?.call_method1("reshape", (shape,))
}
