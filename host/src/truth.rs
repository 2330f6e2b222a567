//! The full solver, started from the same motion as the core and taken to the same times.

use crate::Failure;
use crate::full_solver::{FULL_SOLVER_TOLERANCE, FullSolver, FullState, FullTop};
use crate::progress::Progress;
use crate::propagate::{Paced, Sample, steps_needed, sweep};
use crate::scenario::Scenario;
use crate::tip_angle::remainder;
use std::f64::consts::PI;
use toytop::{Complex, Motion, Phi, Stepper, TipClass, Top};

/// Where the full equations start from.
///
/// A state goes over as it was given. A motion given by branch points has none, so it is read off the core's stepper at
/// t = 0: that hands over initial conditions (α, β, ω), no physics; what follows from them is the full solver's own.
#[must_use]
pub fn start(scenario: &Scenario) -> (FullTop, FullState) {
    let top = scenario.motion.top();
    let (phi, omega) = match &scenario.state {
        Some(state) => (state.phi(), state.omega()),
        None => {
            let pose = Stepper::<f64>::new(&scenario.motion).pose();
            (pose.phi, pose.omega())
        }
    };
    let pair = |z: Complex<f64>| [z.re, z.im];
    let state = FullState { alpha: pair(phi.alpha), beta: pair(phi.beta), omega };
    (FullTop { a: top.a(), c: top.c(), s: top.s(), p: top.p(), g: top.g() }, state)
}

/// The orientation of a state of the full solver.
#[must_use]
pub fn phi(state: &FullState) -> Phi<f64> {
    let complex = |[re, im]: [f64; 2]| Complex::new(re, im);
    Phi { alpha: complex(state.alpha), beta: complex(state.beta) }
}

/// How far one orientation is from another: 2 √(|Δα|² + |Δβ|²), rad.
#[must_use]
pub fn distance(a: &Phi<f64>, b: &Phi<f64>) -> f64 {
    2.0 * ((a.alpha - b.alpha).norm_squared() + (a.beta - b.beta).norm_squared()).sqrt()
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
    sweep(times, start, |solver, t| {
        solver.advance_to(t).map_err(|error| Failure::Method(format!("{}: {error}", scenario.name)))
    })
}

/// Samples at the given times; `step` in s is that of the stepper which continues the tip angle.
///
/// # Errors
/// As [`states`] and [`steps_needed`].
pub fn samples(scenario: &Scenario, times: &[f64], step: f64) -> Result<Vec<Sample>, Failure> {
    let motion = &scenario.motion;
    let mut progress = Progress::new(steps_needed(times, step)?, "steps");
    let states = states(scenario, times)?;
    // An orientation knows its tip angle up to whole turns only. How often the tip has gone round is taken from the
    // core's stepper; the angle itself is the full solver's.
    let guides = sweep(
        times,
        || Paced::<f64>::new(motion, step),
        |paced, t| {
            paced.reach(t, &mut progress);
            Ok(paced.stepper().tip().angle.map(|angle| angle.phi.to_radians()))
        },
    )?;
    let paired = times.iter().zip(&states).zip(guides);
    Ok(paired.map(|((&t, state), guide)| sample(motion, t, state, guide)).collect())
}

/// |αβ| of a tip whose angle the full solver's rounding (some 1e-14) blurs by more than 1e-5 rad.
const NO_ARGUMENT: f64 = 1e-9;

fn sample(motion: &Motion, t: f64, state: &FullState, guide: Option<f64>) -> Sample {
    let complex = |[re, im]: [f64; 2]| Complex::new(re, im);
    let (alpha, beta) = (complex(state.alpha), complex(state.beta));
    let product = alpha * beta;
    // a curve that reaches the centre has a signed radius: there the angle is known up to half turns
    let signed = matches!(motion.tip_class(), TipClass::ThroughOrigin | TipClass::Spiral);
    let unit = if signed { PI } else { 2.0 * PI };
    let argument = |guide: f64| {
        let own = product.im.atan2(product.re);
        // so near the centre the argument is noise
        if product.norm_squared() < NO_ARGUMENT * NO_ARGUMENT { guide } else { own }
    };
    Sample {
        t,
        u: alpha.norm_squared() - beta.norm_squared(),
        udot: state.axis_height_rate(),
        alpha,
        beta,
        omega: state.omega,
        tip: tip(motion.top(), product),
        phi: guide.map(|guide| guide + remainder(argument(guide) - guide, unit)),
    }
}

/// 2 s αβ, or 2 αβ for a fixed tip.
fn tip(top: &Top, product: Complex<f64>) -> Complex<f64> {
    product.scaled(2.0 * top.tip_scale())
}
