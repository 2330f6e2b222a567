//! Constants of a motion.

use crate::motion::MotionCore;
use pyo3::prelude::*;
use toytop_model::constants::{self, MotionWithPeriod, number_constants};

#[pymethods]
impl MotionCore {
    /// Constant of this name; NaN where it does not exist.
    pub(crate) fn constant(&self, name: &str) -> f64 {
        let value = number_constants().find(|(known, _)| *known == name);
        value.map_or(f64::NAN, |(_, value)| value(&MotionWithPeriod::new(self.motion)))
    }

    #[getter]
    fn regime(&self) -> &'static str {
        constants::regime(self.motion.regime())
    }

    #[getter]
    fn tip_class(&self) -> &'static str {
        constants::tip_class(self.motion.tip_class())
    }
}
