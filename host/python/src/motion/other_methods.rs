//! Other methods for a motion at a time: its closed form, where it has one, and the reference to more than thirty digits.

use crate::arguments::{NumericArg, require_within, value_error};
use crate::interrupt;
use crate::motion::MotionCore;
use crate::samples::Sampler;
use crate::top::TopCore;
use pyo3::prelude::*;
use toytop_closed_forms::ClosedForm;
use toytop_host::input::scenario::MotionInput;
use toytop_host::reference::float640::{decimal, from_f64};
use toytop_host::reference::quadrature::Quadrature;
use toytop_model::equations::Rates;
use toytop_model::motion_with_period::MotionWithPeriod;

/// Rust side of `toytop.ClosedForm`.
#[pyclass(module = "toytop._toytop", frozen)]
pub(crate) struct ClosedFormCore {
    motion: MotionWithPeriod,
    form: ClosedForm,
}

#[pymethods]
impl ClosedFormCore {
    #[new]
    fn new(of: &MotionCore) -> PyResult<Self> {
        let form = ClosedForm::from_motion(&of.motion).map_err(|none| value_error("closed_form", none))?;
        Ok(Self { motion: of.motion, form })
    }

    /// Kind of the form.
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

    /// Samples at these times.
    fn at(&self, py: Python<'_>, t: NumericArg) -> PyResult<Sampler> {
        require_within(self.motion.furthest_time_of_closed_form(), &t.numbers)?;
        Sampler::by_method(py, t, &self.motion, None, |t| {
            let state = self.form.at(t);
            (state.orientation, Rates::from_attitude(&state))
        })
    }
}

/// Bound on the rounding of α and β to `f64`: 2 √4 2^-54 rad.
const ROUNDING: f64 = 0.25 * f64::EPSILON * 4.0;

#[pymethods]
impl MotionCore {
    /// Samples of the reference at these times.
    fn reference(&self, py: Python<'_>, t: NumericArg) -> PyResult<Sampler> {
        require_within(self.motion.furthest_time(), &t.numbers)?;
        let (reference, tick) = (py.detach(|| self.quadrature()), self.motion.ticks_per_time().recip());
        Sampler::by_method(py, t, &self.motion, Some(ROUNDING), |t| {
            (reference.at(&from_f64(t)).to_f64(), reference.rates(&from_f64(t), tick))
        })
    }

    /// Quaternions of the reference to this number of digits, as texts, and the shape of the times.
    fn reference_digits(
        &self,
        py: Python<'_>,
        t: NumericArg,
        digits: usize,
    ) -> PyResult<(Vec<[String; 4]>, Vec<usize>)> {
        require_within(self.motion.furthest_time(), &t.numbers)?;
        let reference = py.detach(|| self.quadrature());
        let texts = interrupt::map(py, t.numbers.len(), |index| {
            let phi = reference.at(&from_f64(t.numbers[index]));
            let [[w, z], [y, x]] = [phi.alpha, phi.beta];
            [w, x, -y, z].map(|component| decimal(&component, digits))
        })?;
        Ok((texts, t.shape))
    }
}

impl MotionCore {
    /// Motion in numbers of 640 bits.
    fn quadrature(&self) -> &Quadrature {
        self.reference.get_or_init(|| {
            let TopCore { top, parameters } = self.top;
            Quadrature::new(&MotionInput { support: top.support(), top: parameters, launch: self.launch })
        })
    }
}
