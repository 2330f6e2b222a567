//! Full solver, with the initial state of a motion of core.

use toytop::{Complex, Motion, State, Stepper, Top};
use toytop_host::full_equations::full_solver::{FULL_SOLVER_TOLERANCE, FullSolver, FullState, FullTop};

pub(crate) fn full_top(top: &Top) -> FullTop {
    FullTop {
        a: top.transverse_inertia(),
        c: top.axial_inertia(),
        s: top.com_height(),
        p: top.mass_moment(),
        g: top.gravity(),
        k: top.rotor_momentum(),
    }
}

pub(crate) fn full_state(state: &State) -> FullState {
    let pair = |z: Complex<f64>| [z.re, z.im];
    FullState {
        alpha: pair(state.orientation().alpha),
        beta: pair(state.orientation().beta),
        omega: state.omega(),
    }
}

/// Full solver of a motion; only the state at t = 0 is taken from core.
pub(crate) fn solver(motion: &Motion) -> FullSolver {
    let state = Stepper::<f64>::new(motion).attitude_state().state().unwrap();
    FullSolver::new(full_top(motion.top()), full_state(&state), FULL_SOLVER_TOLERANCE)
}
