//! The full solver, started from the same motion as the core and taken to the same times.

use crate::Failure;
use crate::full_equations::full_solver::{FULL_SOLVER_TOLERANCE, FullSolver, FullState, FullTop};
use crate::input::scenario::Scenario;
use crate::motion::propagate::{Sample, visit_times};
use crate::motion::tip_angle::TipAngle;
use toytop::{Complex, Orientation, Stepper, Top};

/// Where the full equations start from.
///
/// A state goes over as it was given. A motion given by branch points has none, so it is read off the core's stepper at
/// t = 0: that hands over initial conditions (α, β, ω), no physics; what follows from them is the full solver's own.
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

/// The orientation of a state of the full solver.
#[must_use]
pub fn phi(state: &FullState) -> Orientation<f64> {
    let complex = |[re, im]: [f64; 2]| Complex::new(re, im);
    Orientation { alpha: complex(state.alpha), beta: complex(state.beta) }
}

/// The full solver at the start of a scenario.
#[must_use]
pub fn solver(scenario: &Scenario) -> FullSolver {
    let (top, state) = start(scenario);
    FullSolver::new(top, state, FULL_SOLVER_TOLERANCE)
}

/// The full solver's state at every time, in the order given.
///
/// # Errors
/// [`Failure::Method`]: it cannot follow the motion that far.
pub fn states(scenario: &Scenario, times: &[f64]) -> Result<Vec<FullState>, Failure> {
    let start = || solver(scenario);
    visit_times(times, start, |solver, t| {
        solver.advance_to(t).map_err(|error| Failure::Method(format!("{}: {error}", scenario.name)))
    })
}

/// Samples at the given times.
///
/// # Errors
/// As [`states`] and [`TipAngle::of`].
pub fn samples(scenario: &Scenario, times: &[f64]) -> Result<Vec<Sample>, Failure> {
    let states = states(scenario, times)?;
    // An orientation knows its tip angle up to whole turns only. How often the tip has gone round is taken from the
    // core's ephemeris; the angle itself is the full solver's.
    let angle = TipAngle::of(&scenario.motion)?;
    let top = scenario.motion.top();
    Ok(times.iter().zip(&states).map(|(&t, state)| sample(top, &angle, t, state)).collect())
}

/// |αβ| of a tip whose angle the full solver's rounding (some 1e-14) blurs by more than 1e-5 rad.
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
