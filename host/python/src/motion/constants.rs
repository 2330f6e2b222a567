//! Constants of a motion.

use crate::motion::MotionCore;
use pyo3::prelude::*;
use toytop_host::output::names;
use toytop_model::constants::{CONSTANTS, MotionConstants};

#[pymethods]
impl MotionCore {
    /// Constant of this name; NaN where it does not exist.
    pub(crate) fn constant(&self, name: &str) -> f64 {
        let has_tip_angle = !self.motion.regime().is_vertical();
        let of = CONSTANTS.into_iter().find(|(known, _)| *known == name);
        let of = of.filter(|_| has_tip_angle || name != "phi_per_period");
        of.map_or(f64::NAN, |(_, of)| of(&MotionConstants::new(self.motion)))
    }

    #[getter]
    fn regime(&self) -> &'static str {
        names::regime(self.motion.regime())
    }

    #[getter]
    fn tip_class(&self) -> &'static str {
        names::tip_class(self.motion.tip_class())
    }

    #[getter]
    fn e3_minus_e2(&self) -> f64 {
        self.motion.branch_points().e3_minus_e2
    }
}
