//! Search for a launch without a first guess, on longer and longer parts of the measurements.

use crate::estimate::Estimate;
use crate::fit::diagnosis::{is_explained_upright, warning};
use crate::fit::error::FitWarning;
use crate::fit::first_guess::{FIRST_INSTANTS, Guesses, guesses};
use crate::fit::pass::Pass;
use crate::fit::problem::Problem;
use crate::fit::solver::{CONVERGED_SIGMA, Solver};
use crate::sensors::Measurements;
use crate::vector::{Vector, dot};
use toytop::scalar::Real;
use toytop::su2::Orientation;

/// Largest last correction of a part of the measurements, in standard deviations.
const PARTIAL_STEP_SIGMA: f64 = 0.5;
/// Largest difference of the sums of squares of two launches that fit equally well.
const EQUAL_COST: f64 = 9.0;
/// Least distance of two launches that are not the same, in standard deviations.
const OTHER_LAUNCH_SIGMA: f64 = 10.0;
/// Least mean square of residuals of rates in degrees: the noise given may be twice too large.
const MIN_NOISE: f64 = 0.25;
/// Least quotient of a rate beyond the range and a reading at its end. Bias and mounting may shift the reading.
const RANGE_FRACTION: f64 = 0.9;

/// Finds an estimate without a first guess. Returns the reason not to trust it, and the number of other launches that fit as well.
#[inline(never)] // stack
pub(super) fn search<F: Real>(
    problem: &Problem<F, impl Measurements>,
    solver: &mut Solver<F>,
) -> (Option<FitWarning>, usize) {
    let [first, _] = problem.times;
    solver.start_from(&Estimate::new(Orientation::IDENTITY, [0.0; 3]));
    if problem.measurements().filter(|one| one.time > first).take(2).count() < 2 {
        return (Some(FitWarning::TooFew), 0);
    }
    let Some(guesses) = guesses(problem) else {
        return (Some(FitWarning::NoBeginning), 0);
    };
    // the first part that is fitted is four times as long as the part of the guess
    let mut count = 4 * FIRST_INSTANTS * problem.sensors.len();
    let other_launch_count = try_guesses(problem, solver, &guesses, count);
    // each part begins from an estimate that is good enough for it
    while count.saturating_mul(8) < problem.total {
        count = count.saturating_mul(4);
        solver.settle(problem, count, PARTIAL_STEP_SIGMA);
    }
    // a shorter part does not show how far the equations are linear over all measurements
    solver.curvature = f64::INFINITY;
    (settle_on_all(problem, solver), other_launch_count)
}

/// Begins from the best of the guesses, on the first measurements, where no phase can have an error of a turn. Returns the number
/// of other launches that fit as well.
#[inline(never)] // stack
fn try_guesses<F: Real>(
    problem: &Problem<F, impl Measurements>,
    solver: &mut Solver<F>,
    guesses: &Guesses,
    count: usize,
) -> usize {
    let mut best = (solver.best.estimate, f64::INFINITY);
    let mut others = 0;
    for guess in (0..).map_while(|number| guesses.get(number)) {
        solver.start_from(&guess);
        solver.settle(problem, count / 4, PARTIAL_STEP_SIGMA);
        solver.settle(problem, count, CONVERGED_SIGMA);
        let Pass { estimate, information, statistics } = &solver.best;
        let cost = statistics.cost;
        let change = estimate.change_from(&best.0).map(F::from_f64);
        if cost < best.1 - EQUAL_COST {
            others = 0;
        } else if cost < best.1 + EQUAL_COST
            && information.square(&change).to_f64() > OTHER_LAUNCH_SIGMA * OTHER_LAUNCH_SIGMA
        {
            others += 1;
        }
        if cost < best.1 {
            best = (*estimate, cost);
        }
    }
    if guesses.get(1).is_some() {
        solver.start_from(&best.0);
    }
    others
}

/// Passes over all measurements. Returns the reason not to trust the estimate.
pub(super) fn settle_on_all<F: Real>(
    problem: &Problem<F, impl Measurements>,
    solver: &mut Solver<F>,
) -> Option<FitWarning> {
    let settled = solver.settle(problem, usize::MAX, CONVERGED_SIGMA);
    let launch = &solver.best.estimate;
    let found = dot(launch.omega, launch.orientation.axis());
    let bound = |([_, _, low], saturated): (Vector<f64>, bool)| (saturated && low != 0.0).then_some(low);
    let least = problem.rates().find_map(bound);
    // the axial rate is constant, so that one reading at the end of the range bounds it
    let spin = least.filter(|least| found / least < RANGE_FRACTION).unwrap_or(found);
    let warning = warning(problem.model, solver, settled && spin == found);
    let misfit = matches!(warning, Some(FitWarning::AllSaturated | FitWarning::TooFew | FitWarning::Misfit));
    let unknown = is_explained_upright(problem, solver, spin);
    if unknown && !misfit { Some(FitWarning::SpinUnknown) } else { warning }
}

/// Cause of residuals that are too large. The best estimate is overwritten.
#[inline(never)] // stack
pub(super) fn misfit_cause<F: Real>(
    problem: &Problem<F, impl Measurements>,
    solver: &mut Solver<F>,
    chi_squared: f64,
) -> Option<FitWarning> {
    let (warning, _) = search(&problem.in_degrees(), solver);
    // smaller numbers have smaller residuals, whatever the motion is
    let statistics = &solver.best.statistics;
    let has_noise = statistics.chi_squared > MIN_NOISE * f64::from(statistics.used);
    if has_noise && (warning.is_none() || statistics.chi_squared < 0.1 * chi_squared) {
        return Some(FitWarning::RatesInDegrees);
    }
    let mut rates = problem.rates();
    // below 0.1 per unit time, a bias may explain the rates
    let is_small =
        |(omega, saturated): (Vector<f64>, bool)| !saturated && omega.iter().all(|x| libm::fabs(*x) < 0.1);
    (rates.next().is_some_and(is_small) && rates.all(is_small)).then_some(FitWarning::AtRest)
}
