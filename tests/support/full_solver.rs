//! Full solver, with the initial state of a motion of core.

use toytop::{Motion, State};
use toytop_host::motion::full_solver::{FULL_SOLVER_TOLERANCE, FullSolver, FullState};

/// Full solver of a motion; only the state at t = 0 is taken from core.
///
/// # Panics
/// If the state is beyond the allowed range.
pub fn solver(motion: &Motion) -> FullSolver {
    let state = State::from_attitude(&motion.attitude_at_launch()).unwrap();
    let state = FullState::new(&state.orientation(), state.omega());
    FullSolver::new(motion.top(), state, FULL_SOLVER_TOLERANCE).unwrap()
}
