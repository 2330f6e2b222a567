//! Motion of a scenario by the full 3-D equations. The core supplies the initial state of branch points, nothing else.

use crate::Failure;
use crate::input::scenario::{Launch, Scenario};
use crate::motion::outwards::step_outwards;
use crate::motion::sample::MotionSample;
use crate::motion::tip_angle::TipAngle;
use crate::truth::full_solver::{FULL_SOLVER_TOLERANCE, FullSolver, FullState};
use toytop::Stepper;
use toytop_model::equations::Rates;

/// State at t = 0: the state of the launch without change, or for branch points the state of the core's stepper.
pub fn initial_state(scenario: &Scenario) -> FullState {
    match scenario.launch {
        Launch::State { orientation, omega } => FullState::new(&orientation, omega),
        Launch::BranchPoints { .. } => {
            let state = Stepper::<f64>::new(&scenario.motion).attitude_state();
            FullState::new(&state.orientation, state.omega())
        }
    }
}

/// State of the full solver at each time, in the order of the times.
///
/// # Errors
/// [`Failure::Method`]: the solver cannot integrate that far.
pub fn states(scenario: &Scenario, times: &[f64]) -> Result<Vec<FullState>, Failure> {
    let start = FullSolver::new(scenario.motion.top(), initial_state(scenario), FULL_SOLVER_TOLERANCE);
    start
        .and_then(|start| step_outwards(times, || start.clone(), FullSolver::advance_to))
        .map_err(|failure| failure.with_context(&scenario.name))
}

/// Samples of the full solver at the given times.
///
/// # Errors
/// As [`states`].
pub fn samples(scenario: &Scenario, times: &[f64]) -> Result<Vec<MotionSample>, Failure> {
    let states = states(scenario, times)?;
    // only the whole turns of the tip angle come from the core
    let angle = TipAngle::new(&scenario.motion);
    let sample = |(&t, state): (&f64, &FullState)| {
        let (orientation, omega) = (state.orientation(), state.omega);
        let omega_body = orientation.inverse().adjoint(omega);
        angle.sample(t, orientation, Rates { omega, omega_body, udot: state.udot() })
    };
    Ok(times.iter().zip(&states).map(sample).collect())
}
