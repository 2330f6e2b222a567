//! Full solver of a scenario's motion at given times.

use crate::Failure;
use crate::full_equations::full_solver::{FULL_SOLVER_TOLERANCE, FullSolver, FullState, FullTop};
use crate::input::scenario::Scenario;
use crate::motion::propagate::{Sample, visit_times};
use crate::motion::tip_angle::TipAngle;
use toytop::{Complex, Orientation, Stepper, Top};

/// Top and initial state of the full equations.
///
/// The state of a scenario is used without change. For a motion given by branch points, the state is that of the core's stepper at t = 0:
/// only the initial conditions (α, β, ω) come from the core, and the motion from the full solver.
#[must_use]
pub fn start(scenario: &Scenario) -> (FullTop, FullState) {
    let top = scenario.motion.top();
    let (phi, omega) = match &scenario.state {
        Some(state) => (state.orientation(), state.omega()),
        None => {
            let pose = Stepper::<f64>::new(&scenario.motion).attitude_state();
            (pose.orientation, pose.omega())
        }
    };
    let pair = |z: Complex<f64>| [z.re, z.im];
    let state = FullState { alpha: pair(phi.alpha), beta: pair(phi.beta), omega };
    (
        FullTop {
            a: top.transverse_inertia(),
            c: top.axial_inertia(),
            s: top.com_height(),
            p: top.mass_moment(),
            g: top.gravity(),
            k: top.rotor_momentum(),
        },
        state,
    )
}

/// Orientation of a state of the full solver.
#[must_use]
pub fn phi(state: &FullState) -> Orientation<f64> {
    let complex = |[re, im]: [f64; 2]| Complex::new(re, im);
    Orientation { alpha: complex(state.alpha), beta: complex(state.beta) }
}

/// Full solver at t = 0 of a scenario.
#[must_use]
pub fn solver(scenario: &Scenario) -> FullSolver {
    let (top, state) = start(scenario);
    FullSolver::new(top, state, FULL_SOLVER_TOLERANCE)
}

/// State of the full solver at each time, in the order of the times.
///
/// # Errors
/// [`Failure::Method`]: the solver cannot integrate that far.
pub fn states(scenario: &Scenario, times: &[f64]) -> Result<Vec<FullState>, Failure> {
    let start = || solver(scenario);
    visit_times(times, start, |solver, t| {
        solver.advance_to(t).map_err(|error| Failure::Method(format!("{}: {error}", scenario.name)))
    })
}

/// Samples of the full solver at the given times.
///
/// # Errors
/// As [`states`] and [`TipAngle::of`].
pub fn samples(scenario: &Scenario, times: &[f64]) -> Result<Vec<Sample>, Failure> {
    let states = states(scenario, times)?;
    // An orientation determines its tip angle up to whole turns. The number of whole turns is that of the core's ephemeris; the angle
    // itself is the full solver's.
    let angle = TipAngle::of(&scenario.motion)?;
    let top = scenario.motion.top();
    Ok(times.iter().zip(&states).map(|(&t, state)| sample(top, &angle, t, state)).collect())
}

/// Least |αβ| at which the rounding of the full solver (some 1e-14) changes the argument of αβ by less than 1e-5 rad.
const NO_ARGUMENT: f64 = 1e-9;

fn sample(top: &Top, angle: &TipAngle, t: f64, state: &FullState) -> Sample {
    let complex = |[re, im]: [f64; 2]| Complex::new(re, im);
    let (alpha, beta) = (complex(state.alpha), complex(state.beta));
    let product = alpha * beta;
    Sample {
        t,
        u: (alpha.norm_squared() - beta.norm_squared()).clamp(-1.0, 1.0),
        udot: state.axis_height_rate(),
        alpha,
        beta,
        omega: state.omega,
        tip: product.scaled(2.0 * top.tip_scale()),
        phi: angle.continued(t, product, NO_ARGUMENT),
    }
}
