//! The full solver, started where a motion of core starts.

use toytop::{Complex, Motion, State, Stepper, Top};
use toytop_host::full_solver::{FULL_SOLVER_TOLERANCE, FullSolver, FullState, FullTop};

pub(crate) fn full_top(top: &Top) -> FullTop {
    FullTop { a: top.a(), c: top.c(), s: top.s(), p: top.p(), g: top.g() }
}

pub(crate) fn full_state(state: &State) -> FullState {
    let pair = |z: Complex<f64>| [z.re, z.im];
    FullState { alpha: pair(state.phi().alpha), beta: pair(state.phi().beta), omega: state.omega() }
}

/// Only the state at t = 0 is core's.
pub(crate) fn solver(motion: &Motion) -> FullSolver {
    let state = Stepper::<f64>::new(motion).pose().state().unwrap();
    FullSolver::new(full_top(motion.top()), full_state(&state), FULL_SOLVER_TOLERANCE)
}
