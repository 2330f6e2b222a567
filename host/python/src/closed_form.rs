//! Closed form of a motion, where it has one.

use crate::arrays::Given;
use crate::error::{failed, value_error};
use crate::point::Point;
use crate::samples::{Samples, Source};
use pyo3::prelude::*;
use toytop::Motion;
use toytop::exact::ClosedForm;
use toytop_host::motion::propagate::period;
use toytop_host::motion::tip_angle::TipAngle;

/// Motion in elementary or elliptic functions: no step, no table, no quadrature. It is slower than Motion.at.
#[pyclass(name = "ClosedForm", module = "toytop", frozen)]
pub(crate) struct PyClosedForm {
    motion: Motion,
    form: ClosedForm,
}

impl PyClosedForm {
    /// Closed form of a motion.
    ///
    /// # Errors
    /// `ValueError`: there is none.
    pub(crate) fn of(motion: &Motion) -> PyResult<Self> {
        let form = ClosedForm::of(motion).map_err(|none| value_error("closed_form", &none.to_string()))?;
        Ok(Self { motion: *motion, form })
    }
}

/// Greatest number of nutation periods. If e₃ = e₄ holds only up to rounding, the form loses up to 5e-14 rad in a period.
const MOST_PERIODS: f64 = 1e12;
/// Least |αβ| at which the rounding of α and β changes the argument of αβ by less than 1e-5 rad.
const NOISE: f64 = 1e-11;

#[pymethods]
impl PyClosedForm {
    /// Kind: "free_body", "pendulum", "regular_precession", "aperiodic", "e3_equals_e4" or "lagrange".
    #[getter]
    fn kind(&self) -> &'static str {
        match self.form {
            ClosedForm::FreeBody(_) => "free_body",
            ClosedForm::Pendulum(_) => "pendulum",
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
    fn at(&self, py: Python<'_>, t: &Bound<'_, PyAny>) -> PyResult<Samples> {
        let times = Given::read("t", t)?;
        let reach = MOST_PERIODS * period(&self.motion);
        if let Some(t) = times.numbers.iter().find(|t| t.abs() > reach) {
            return Err(value_error("t", &format!("{t:e} must be within ±{reach:.1e}")));
        }
        let points = py.detach(|| {
            let angle = TipAngle::of(&self.motion)?;
            let point = |t: &f64| {
                let state = self.form.at(*t);
                let product = state.orientation.alpha * state.orientation.beta;
                Point {
                    orientation: state.orientation,
                    omega_body: state.omega_body(),
                    tip_angle: angle.continued(*t, product, NOISE).unwrap_or(f64::NAN),
                    tip_scale: self.motion.top().tip_scale(),
                    error_bound: f64::NAN,
                }
            };
            Ok(times.numbers.iter().map(point).collect())
        });
        let points = points.map_err(|failure| failed(&failure))?;
        Ok(Samples::new(times, Source::Points(points)))
    }

    fn __repr__(&self) -> String {
        format!("<ClosedForm: {}>", self.kind())
    }
}
