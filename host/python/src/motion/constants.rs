//! Constants of a `Motion`, as attributes.

use crate::motion::PyMotion;
use pyo3::prelude::*;
use toytop_model::constants;

#[pymethods]
impl PyMotion {
    /// Kind of motion: "nutating", "regular_precession", "sleeping_stable", "sleeping_unstable", "hanging" or "aperiodic".
    #[getter]
    pub(crate) fn regime(&self) -> &'static str {
        constants::regime(self.motion.regime())
    }

    /// Class of the curve that the tip draws: "smooth", "cusp", "loops", "circle", "through_origin", "spiral" or "point".
    #[getter]
    fn tip_class(&self) -> &'static str {
        constants::tip_class(self.motion.tip_class())
    }

    /// Vertical angular momentum l, kg m²/s.
    #[getter]
    fn l(&self) -> f64 {
        self.motion.first_integrals().l
    }

    /// Axial angular momentum n = C (omega . r) + K, kg m²/s.
    #[getter]
    fn n(&self) -> f64 {
        self.motion.first_integrals().n
    }

    /// Energy h, J; the potential energy is 0 where the centre of mass is at the height of the tip.
    #[getter]
    fn h(&self) -> f64 {
        self.motion.first_integrals().h
    }

    /// Branch point e1: the least cosine of the tilt.
    #[getter]
    fn e1(&self) -> f64 {
        self.motion.branch_points().e1
    }

    /// Branch point e2: the greatest cosine of the tilt.
    #[getter]
    fn e2(&self) -> f64 {
        self.motion.branch_points().e2
    }

    /// Branch point e3 >= 1.
    #[getter]
    fn e3(&self) -> f64 {
        self.motion.branch_points().e3
    }

    /// Branch point e4 = sqrt(1 + A/(p s)); None for a fixed tip.
    #[getter]
    fn e4(&self) -> Option<f64> {
        self.motion.top().e4()
    }

    /// Sum 1 + e1, without the rounding of e1.
    #[getter]
    fn one_plus_e1(&self) -> f64 {
        self.motion.branch_points().one_plus_e1
    }

    /// Difference 1 - e2, without the rounding of e2.
    #[getter]
    fn one_minus_e2(&self) -> f64 {
        self.motion.branch_points().one_minus_e2
    }

    /// Difference e2 - e1, without the rounding of either.
    #[getter]
    fn e2_minus_e1(&self) -> f64 {
        self.motion.branch_points().e2_minus_e1
    }

    /// Difference e3 - e2, without the rounding of either.
    #[getter]
    fn e3_minus_e2(&self) -> f64 {
        self.motion.branch_points().e3_minus_e2
    }

    /// Difference e3 - 1, without the rounding of e3.
    #[getter]
    fn e3_minus_one(&self) -> f64 {
        self.motion.branch_points().e3_minus_one
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

    /// Nutation period, s; where the tilt is constant, that of a small nutation. None where no motion nearby is periodic.
    #[getter]
    fn period(&self) -> Option<f64> {
        Some(self.motion.period_advance()?.period)
    }

    /// Mean rotation of alpha in a nutation period, turns, whole turns included; None without a period.
    #[getter]
    fn alpha_turns(&self) -> Option<f64> {
        Some(self.motion.period_advance()?.alpha_turns)
    }

    /// Mean rotation of beta in a nutation period, turns, whole turns included; None without a period.
    #[getter]
    fn beta_turns(&self) -> Option<f64> {
        Some(self.motion.period_advance()?.beta_turns)
    }

    /// Advance of the tip angle in a nutation period, rad; None without a period, or where the axis is vertical.
    #[getter]
    fn phi_per_period(&self) -> Option<f64> {
        let advance = self.motion.period_advance().filter(|_| !self.motion.regime().is_vertical());
        Some(advance?.phi_per_period())
    }

    /// Least normal force of the plane, in units of the weight; below 0 a real top leaves the plane. None for a fixed tip.
    #[getter]
    fn min_normal_force(&self) -> Option<f64> {
        self.motion.min_normal_force()
    }
}
