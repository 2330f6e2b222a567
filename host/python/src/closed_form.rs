//! Closed form of a motion, where it has one.

use crate::arrays::Given;
use crate::error::{failed, value_error};
use crate::interrupt;
use crate::motion::{PyMotion, furthest};
use crate::samples::{Samples, Source};
use pyo3::prelude::*;
use toytop_closed_forms::ClosedForm;
use toytop_host::motion::propagate::period;
use toytop_host::motion::tip_angle::TipAngle;

/// Motion in elementary or elliptic functions: no step, no table, no quadrature. It is slower than Motion.at.
#[pyclass(name = "ClosedForm", module = "toytop", frozen)]
pub(crate) struct PyClosedForm {
    motion: Py<PyMotion>,
    form: ClosedForm,
}

impl PyClosedForm {
    /// Closed form of a motion.
    ///
    /// # Errors
    /// `ValueError`: there is none.
    pub(crate) fn of(motion: &Bound<'_, PyMotion>) -> PyResult<Self> {
        let form = ClosedForm::of(&motion.get().0.motion)
            .map_err(|none| value_error("closed_form", &none.to_string()))?;
        Ok(Self { motion: motion.clone().unbind(), form })
    }
}

/// Greatest number of nutation periods. If e₃ = e₄ holds only up to rounding, the form loses up to 5e-14 rad in a period.
const MOST_PERIODS: f64 = 1e12;
/// Least |αβ| at which the rounding of α and β changes the argument of αβ by less than 1e-5 rad.
const NOISE: f64 = 1e-11;

#[pymethods]
impl PyClosedForm {
    /// Kind: "free_body", "regular_precession", "aperiodic", "e3_equals_e4" or "lagrange".
    #[getter]
    fn kind(&self) -> &'static str {
        match self.form {
            ClosedForm::FreeBody(_) => "free_body",
            ClosedForm::RegularPrecession(_) => "regular_precession",
            ClosedForm::Aperiodic(_) => "aperiodic",
            ClosedForm::E3EqualsE4(_) => "e3_equals_e4",
            ClosedForm::Lagrange(_) => "lagrange",
        }
    }

    /// Samples of the motion at time t, s: a number, or an array of any shape.
    ///
    /// Raises:
    ///     ValueError: t is not finite, or beyond 1e12 periods.
    fn at(slf: &Bound<'_, Self>, t: &Bound<'_, PyAny>) -> PyResult<Samples> {
        let (times, form, motion) = (Given::read("t", t)?, &slf.get().form, slf.get().motion.get().0.motion);
        let reach = MOST_PERIODS * period(&motion);
        let furthest = furthest(&times);
        if furthest > reach {
            return Err(value_error("t", &format!("{furthest:e} must be within ±{reach:.1e}")));
        }
        let angle = TipAngle::of(&motion, NOISE).map_err(|failure| failed(&failure))?;
        let points = interrupt::map(slf.py(), times.numbers.len(), |index| {
            let (t, state) = (times.numbers[index], form.at(times.numbers[index]));
            angle.sample(t, state.orientation, state.omega(), state.udot())
        })?;
        Ok(Samples::new(times, None, Source::Points(points), slf.getattr("at")?))
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, ())> {
        Ok((self.motion.bind(py).getattr("closed_form")?, ()))
    }

    fn __repr__(&self) -> String {
        format!("<ClosedForm: {}>", self.kind())
    }
}
