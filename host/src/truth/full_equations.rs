//! Motion of a scenario by the full 3-D equations, a reference that shares no formula with the core.

pub mod full_solver;

use crate::Failure;
use crate::input::scenario::{Given, Scenario};
use crate::motion::propagate::{Sample, visit_times};
use crate::motion::tip_angle::TipAngle;
use crate::truth::motions::Start;
use full_solver::{FULL_SOLVER_TOLERANCE, FullSolver, FullState, FullTop};
use toytop::Stepper;

/// Top and initial state of the full equations.
///
/// The state of a scenario is used without change. For a motion given by branch points it is the state of the core's stepper at t = 0.
pub fn start(scenario: &Scenario) -> (FullTop, FullState) {
    let state = match scenario.given {
        Some(Given { start: Start::State { phi: [alpha, beta], omega }, .. }) => {
            FullState { alpha, beta, omega }
        }
        _ => {
            let state = Stepper::<f64>::new(&scenario.motion).attitude_state();
            FullState::new(&state.orientation, state.omega())
        }
    };
    (scenario.motion.top().into(), state)
}

/// State of the full solver at each time, in the order of the times.
///
/// # Errors
/// [`Failure::Method`]: the solver cannot integrate that far.
pub fn states(scenario: &Scenario, times: &[f64]) -> Result<Vec<FullState>, Failure> {
    let (top, state) = start(scenario);
    let solver = || FullSolver::new(top, state, FULL_SOLVER_TOLERANCE);
    visit_times(times, solver, |solver, t| {
        solver.advance_to(t).map_err(|failure| failure.with_context(&scenario.name))
    })
}

/// Samples of the full solver at the given times.
///
/// # Errors
/// As [`states`] and [`TipAngle::new`].
pub fn samples(scenario: &Scenario, times: &[f64]) -> Result<Vec<Sample>, Failure> {
    /// Least |αβ| whose argument is not noise of the full solver.
    const MIN_PRODUCT: f64 = 1e-9;
    let states = states(scenario, times)?;
    // the whole turns of the tip angle are those of the core's ephemeris, the angle itself is the full solver's
    let angle = TipAngle::new(&scenario.motion, MIN_PRODUCT)?;
    let sample = |(&t, state): (&f64, &FullState)| {
        angle.sample(t, state.orientation(), state.omega, state.axis_height_rate())
    };
    Ok(times.iter().zip(&states).map(sample).collect())
}
