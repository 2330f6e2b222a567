//! Other methods for a motion at a time: its closed form, where it has one, and the truth to more than thirty digits.

use crate::arguments::{Given, value_error, within};
use crate::interrupt;
use crate::motion::PyMotion;
use crate::samples::samples_of_points;
use crate::top::PyTop;
use pyo3::prelude::*;
use toytop::Support;
use toytop_closed_forms::ClosedForm;
use toytop_host::motion::propagate::period;
use toytop_host::truth::exact::Exact;
use toytop_host::truth::motions::Numbers;
use toytop_host::truth::precise::{decimal, precise};

/// Motion in elementary or elliptic functions: no step, no table, no quadrature. It is slower than Motion.at.
#[pyclass(name = "ClosedForm", module = "toytop", frozen)]
pub(crate) struct PyClosedForm {
    motion: Py<PyMotion>,
    form: ClosedForm,
}

/// Greatest number of nutation periods. If e₃ = e₄ holds only up to rounding, the form loses up to 5e-14 rad in a period.
const MOST_PERIODS: f64 = 1e12;

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
    fn at<'py>(slf: &Bound<'py, Self>, t: Given) -> PyResult<Bound<'py, PyAny>> {
        let Self { motion, form } = slf.get();
        let motion = &motion.get().motion;
        within(MOST_PERIODS * period(motion), &t.numbers)?;
        let origin = slf.clone().into_any().unbind();
        samples_of_points(slf.py(), (origin, "at", None), t, motion, None, |t| {
            let state = form.at(t);
            (state.orientation, state.omega(), state.udot())
        })
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, ())> {
        Ok((self.motion.bind(py).getattr("closed_form")?, ()))
    }

    fn __repr__(&self) -> String {
        format!("<ClosedForm: {}>", self.kind())
    }
}

/// Bound on the rounding of α and β to `f64`: 2 √4 2^-54 rad.
const ROUNDING: f64 = 0.25 * f64::EPSILON * 4.0;

#[pymethods]
impl PyMotion {
    /// Closed form of the motion, in elementary or elliptic functions.
    ///
    /// Raises:
    ///     ValueError: the motion has none; the message says which motions do.
    fn closed_form(slf: &Bound<'_, Self>) -> PyResult<PyClosedForm> {
        let form = ClosedForm::of(&slf.get().motion).map_err(|none| value_error("closed_form", none))?;
        Ok(PyClosedForm { motion: slf.clone().unbind(), form })
    }

    /// Truth at time t, s, rounded to float64: the paper's integrals in numbers of 640 bits, which share no formula and no
    /// arithmetic with Motion.at. It takes some milliseconds a time.
    ///
    /// Raises:
    ///     ValueError: t is not finite or beyond 2^62 ticks.
    fn reference<'py>(slf: &Bound<'py, Self>, t: Given) -> PyResult<Bound<'py, PyAny>> {
        let (py, own) = (slf.py(), slf.get());
        own.within_reach(&t.numbers)?;
        let (truth, unit) = (py.detach(|| own.truth()), period(&own.motion));
        let origin = slf.clone().into_any().unbind();
        samples_of_points(py, (origin, "reference", None), t, &own.motion, Some(ROUNDING), |t| {
            let rates = truth.rates(&precise(t), unit);
            (truth.at(&precise(t)).to_f64(), rates.omega, rates.udot)
        })
    }

    /// Truth at time t, s, to as many digits as wanted: an array of decimal.Decimal with the quaternion w, x, y, z in its last
    /// axis.
    ///
    /// Args:
    ///     digits: significant digits, from 1 to 50; the truth itself has more than thirty.
    #[pyo3(signature = (t, *, digits=30))]
    fn reference_digits<'py>(&self, py: Python<'py>, t: Given, digits: i64) -> PyResult<Bound<'py, PyAny>> {
        if !(1..=50).contains(&digits) {
            return Err(value_error("digits", "must be between 1 and 50"));
        }
        self.within_reach(&t.numbers)?;
        let truth = py.detach(|| self.truth());
        let texts = interrupt::map(py, t.numbers.len(), |index| {
            let phi = truth.at(&precise(t.numbers[index]));
            let [[w, z], [y, x]] = [phi.alpha, phi.beta];
            [w, x, -y, z].map(|component| decimal(&component, digits as usize))
        })?;
        py.import("toytop._samples")?.call_method1("decimals", (texts, t.shape))
    }
}

impl PyMotion {
    /// Motion in numbers of 640 bits, with the mass moment p = M s, whose product is not rounded to `f64`.
    fn truth(&self) -> &Exact {
        self.truth.get_or_init(|| {
            let PyTop { top, parameters: given } = &self.top;
            let p = match top.support() {
                Support::Free => precise(0.0),
                _ if given.mass == 0.0 => precise(given.mass_moment),
                _ => precise(given.mass) * precise(given.com_height),
            };
            let (a, c, s) = (top.transverse_inertia(), top.axial_inertia(), top.com_height());
            let top = [a, c, s, top.mass_moment(), top.gravity(), top.rotor_momentum()];
            Exact::with_mass_moment(&Numbers { top, start: self.start }, &p)
        })
    }
}
