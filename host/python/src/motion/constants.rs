//! Constants of a `Motion`; `toytop/_constants.py` makes attributes of those that are numbers.

use crate::motion::PyMotion;
use pyo3::prelude::*;
use toytop_host::output::names;
use toytop_model::constants::{CONSTANTS, MotionConstants};

#[pymethods]
impl PyMotion {
    /// Constant of this name; None where it does not exist.
    #[pyo3(name = "_constant")]
    pub(crate) fn constant(&self, name: &str) -> Option<f64> {
        let (_, of) = CONSTANTS.into_iter().find(|(known, _)| *known == name)?;
        let has_tip_angle = !self.motion.regime().is_vertical();
        let number = of(&MotionConstants::new(self.motion));
        (!number.is_nan() && (has_tip_angle || name != "phi_per_period")).then_some(number)
    }

    /// Kind of motion: "nutating", "regular_precession", "sleeping_stable", "sleeping_unstable", "hanging" or "aperiodic".
    #[getter]
    pub(crate) fn regime(&self) -> &'static str {
        names::regime(self.motion.regime())
    }

    /// Class of the curve that the tip draws: "smooth", "cusp", "loops", "circle", "through_origin", "spiral" or "point".
    #[getter]
    fn tip_class(&self) -> &'static str {
        names::tip_class(self.motion.tip_class())
    }

    /// Difference e3 - e2, without the rounding of either.
    #[getter]
    fn e3_minus_e2(&self) -> f64 {
        self.motion.branch_points().e3_minus_e2
    }

    /// Sign of l + n: 1 or -1; 1 for 0.
    #[getter]
    fn sign_l_plus_n(&self) -> i32 {
        self.motion.signs().l_plus_n.factor()
    }

    /// Sign of l - n: 1 or -1; 1 for 0.
    #[getter]
    fn sign_l_minus_n(&self) -> i32 {
        self.motion.signs().l_minus_n.factor()
    }
}
