//! Motions, each with its tables and its input.

mod changes;
mod events;
mod other_methods;

pub(crate) use other_methods::ClosedFormCore;

use crate::arguments::{NumericArg, failed, renamed, require_within, value_error};
use crate::samples::{Sampler, SharedEvaluator, Source};
use crate::top::TopCore;
use pyo3::prelude::*;
use std::sync::{Arc, OnceLock};
use toytop::{Motion, State};
use toytop_host::Failure;
use toytop_host::input::scenario::{Launch, Scenario, ScenarioFile, to_toml};
use toytop_host::motion::Scalar;
use toytop_host::motion::evaluator::MotionEvaluator;
use toytop_host::pictures::curve::TipCurve;
use toytop_host::pictures::page;
use toytop_host::reference::quadrature::Quadrature;
use toytop_model::constants::{number_constants, regime, tip_class};
use toytop_model::motion_with_period::MotionWithPeriod;

/// Rust side of `toytop.Motion`.
#[pyclass(module = "toytop._toytop", frozen)]
pub(crate) struct MotionCore {
    #[pyo3(get)]
    pub(crate) top: TopCore,
    pub(crate) launch: Launch,
    /// Motion with its period.
    pub(crate) motion: MotionWithPeriod,
    tables: [OnceLock<Result<SharedEvaluator, Failure>>; Scalar::ALL.len()],
    /// Motion in numbers of 640 bits.
    pub(crate) reference: OnceLock<Quadrature>,
}

/// Scalar of this name.
///
/// # Errors
/// `ValueError`: there is none.
pub(crate) fn scalar_named(name: &str) -> PyResult<Scalar> {
    let named = Scalar::ALL.into_iter().find(|scalar| scalar.name() == name);
    named.ok_or_else(|| value_error("scalar", "must be one of 'f64', 'f32', 'q31', 'q15'"))
}

impl MotionCore {
    pub(crate) fn new(top: TopCore, launch: Launch, motion: MotionWithPeriod) -> Self {
        Self { top, launch, motion, tables: Default::default(), reference: OnceLock::new() }
    }

    /// Motion from a state, with this name of the rates in error messages.
    ///
    /// # Errors
    /// `ValueError` that names the parameter.
    pub(crate) fn from_state(top: &TopCore, state: &State, rate: &str) -> PyResult<Self> {
        let motion = Motion::launch(&top.top, state).map_err(|error| renamed(error, &[("omega", rate)]))?;
        Ok(Self::new(*top, Launch::from(state), MotionWithPeriod::new(motion)))
    }

    /// Table in a scalar, set up at its first use.
    ///
    /// # Errors
    /// `ValueError`: no table in this scalar is large enough.
    pub(crate) fn table(&self, scalar: Scalar) -> PyResult<SharedEvaluator> {
        let set_up = || {
            let evaluator = MotionEvaluator::new(&self.motion, scalar);
            evaluator.map(Arc::new).map_err(|failure| failure.at("scalar"))
        };
        let table = self.tables[scalar as usize].get_or_init(set_up).clone();
        table.map_err(failed)
    }

    /// Table in a scalar whose ticks reach the times.
    ///
    /// # Errors
    /// `ValueError`: as [`Self::table`], or one of the times is beyond the ticks.
    pub(crate) fn table_for(&self, scalar: Scalar, times: &[f64]) -> PyResult<SharedEvaluator> {
        let table = self.table(scalar)?;
        require_within(table.furthest_time(), times)?;
        Ok(table)
    }
}

#[pymethods]
impl MotionCore {
    /// Motion of a scenario file's text; `file` is its name in messages.
    #[new]
    pub(crate) fn from_text(file: &str, text: &str) -> PyResult<Self> {
        let Scenario { motion, input, .. } = Scenario::parse(file, text).map_err(failed)?;
        Ok(Self::new(TopCore { parameters: input.top, top: *motion.top() }, input.launch, motion))
    }

    pub(crate) fn to_toml(&self) -> String {
        to_toml(&self.top.table(), &self.launch)
    }

    /// Page with the top in motion, as HTML.
    fn view(&self) -> PyResult<String> {
        let file = ScenarioFile::parse("A spinning top", &self.to_toml()).map_err(failed)?;
        page::html(&file).map_err(failed)
    }

    /// Picture of the curve that the tip draws, as SVG.
    fn tip_curve(&self, py: Python<'_>) -> PyResult<String> {
        py.detach(|| TipCurve::new(&self.motion)).map(|curve| curve.svg()).map_err(failed)
    }

    /// Constant of this name; NaN where it does not exist.
    pub(crate) fn constant(&self, name: &str) -> f64 {
        let value = number_constants().find(|(known, _)| *known == name);
        value.map_or(f64::NAN, |(_, value)| value(&self.motion))
    }

    #[getter]
    fn regime(&self) -> &'static str {
        regime(self.motion.regime())
    }

    #[getter]
    fn tip_class(&self) -> &'static str {
        tip_class(self.motion.tip_class())
    }

    /// Samples at these times, of a table in a scalar.
    fn at(&self, py: Python<'_>, t: NumericArg, scalar: &str) -> PyResult<Sampler> {
        let scalar = scalar_named(scalar)?;
        let table = py.detach(|| self.table_for(scalar, &t.numbers))?;
        Ok(Sampler::new(t, None, Source::Tables(vec![table])))
    }

    /// Bounds on the errors of the orientation, rad, and of the rates, rad/s, at a time.
    fn error_bounds(&self, t: f64, scalar: &str) -> PyResult<[f64; 2]> {
        let table = self.table(scalar_named(scalar)?)?;
        let ticks = t * table.ticks_per_time;
        Ok([table.error_bound.after(ticks), table.rate_error_bound.after(ticks)])
    }
}
