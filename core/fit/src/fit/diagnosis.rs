//! Reasons not to trust an estimate.

use crate::estimate::Estimate;
use crate::fit::error::FitWarning;
use crate::fit::first_guess::rotation_from_vertical;
use crate::fit::problem::Problem;
use crate::fit::solver::Solver;
use crate::model::Model;
use crate::sensitivity::LAUNCH_COLUMNS;
use crate::sensors::Measurements;
use crate::vector::{cross, dot, scaled};
use toytop::scalar::Real;

/// Largest sine of the tilt, and largest fraction of ω across the axis, of a launch that is compared with an upright one.
const UPRIGHT_SINE: f64 = 0.1;
/// Largest difference of sums of squares that chance explains: twice that between the best of 100 random spins and the true one.
const CHANCE_COST: f64 = 40.0;

/// Reason in the residuals not to trust the best estimate.
pub(super) fn warning<F>(model: &Model, solver: &Solver<F>, settled: bool) -> Option<FitWarning> {
    let statistics = &solver.best.statistics;
    if statistics.used == 0 && statistics.unused > 0 {
        Some(FitWarning::AllSaturated)
    } else if statistics.used < LAUNCH_COLUMNS as u32 {
        Some(FitWarning::TooFew)
    } else if statistics.is_misfit(model.count) {
        Some(FitWarning::Misfit)
    } else if settled {
        None
    } else {
        Some(FitWarning::NotSettled)
    }
}

/// Whether an upright launch with twice this spin explains the measurements equally well. They do not determine the spin then.
///
/// An upright top with a saturated gyroscope fits any spin.
#[inline(never)] // stack
pub(super) fn is_explained_upright<F: Real>(
    problem: &Problem<F, impl Measurements>,
    solver: &mut Solver<F>,
    spin: f64,
) -> bool {
    let found = solver.best.estimate;
    let axis = found.orientation.axis();
    let transverse = cross(found.omega, axis);
    let [x, y, z] = axis;
    let near = UPRIGHT_SINE * UPRIGHT_SINE;
    if x * x + y * y > near || dot(transverse, transverse) > near * dot(found.omega, found.omega) {
        return false;
    }
    let sign = libm::copysign(1.0, z);
    let orientation = rotation_from_vertical(scaled(axis, sign)).inverse().compose(&found.orientation);
    let upright = Estimate { orientation, omega: [0.0, 0.0, sign * 2.0 * spin], ..found };
    solver.cost_of(upright, problem) <= solver.best.statistics.cost + CHANCE_COST
}
