//! Full solver: step-by-step integration of the three-dimensional equations of motion. From the core it takes products of vectors and
//! the state at t = 0 of branch points and releases; the equations and their integration are its own.
//!
//! The integrator is Verner's 9(8) pair from `differential-equations`, called for one step at a time, so that the last step ends exactly at
//! the requested time without dense output. Three measures limit the rounding to a single operation per step:
//! - units of inertia and time are powers of two near A and the fastest rate, so that changing units is exact
//!   and one tolerance suits every top;
//! - each step integrates the *change* of the state from zero, and the changes are added with
//!   compensation (the integrator's own sums and its error estimate would be rounded relative to the state);
//! - after each step the orientation is normalised, by a change of its length only.

mod compensation;

use crate::Failure;
use crate::input::scenario::{Launch, Scenario};
use crate::motion::times::step_to_each;
use compensation::{normalise_orientation, two_sum};
use differential_equations::methods::ExplicitRungeKutta;
use differential_equations::ode::{ODE, OrdinaryNumericalMethod};
use differential_equations::status::Status;
use toytop::Top;
pub use toytop_model::equations::{Equations, FullState};
use toytop_model::equations::{Vector7, dot};

/// Default tolerance per step. By measurement, smaller ones increase the number of evaluations, but not the accuracy.
pub const FULL_SOLVER_TOLERANCE: f64 = 3e-16;
/// Limit on evaluations of the equations, which takes about five seconds, for some thirty thousand nutations.
const MAX_EVALUATIONS: u64 = 100_000_000;

const UNUSABLE: &str = "the numbers of top, state and time must be finite and not too far apart in size";

fn failure(reason: &str) -> Failure {
    Failure::method(format!("full solver: {reason}"))
}

/// Numerical integration of a motion from t = 0.
#[derive(Clone)]
pub struct FullSolver {
    equations: Equations,
    /// Natural unit of angular rates, rad/s.
    rate_unit: f64,
    tolerances: Vector7,
    limit: u64,
    time: f64,
    /// State, as the sum of `y` and the smaller part `low`.
    y: Vector7,
    low: Vector7,
    step: f64,
    evaluations: u64,
}

impl FullSolver {
    /// Integration from `state` at t = 0, whose orientation is normalised. `tolerance`, in \[1e-17, 1e-2\], bounds the error of a step
    /// in alpha and beta (absolute) and m (relative to the momenta of the motion).
    ///
    /// Measured at the default tolerance, over three nutations and the project's reference motions:
    /// orientation within 5e-14 rad, except where the motion itself amplifies rounding (separatrix,
    /// aperiodic: 3e-9 rad).
    ///
    /// # Errors
    /// [`Failure::method`]: the numbers are not finite, or too far apart in size.
    pub fn new(top: &Top, state: FullState, tolerance: f64) -> Result<Self, Failure> {
        let equations = Equations::new(top, &state);
        let Equations { a, pg, k, .. } = equations;
        let rotor = k / a;
        let rate = (pg / a + dot(state.omega, state.omega) + rotor * rotor).sqrt();
        // a body at rest without weight has no natural rate, and its unit is 1
        let (rate_unit, inertia_unit) = (power_of_two(rate), power_of_two(a));
        let equations = equations.in_units(inertia_unit, rate_unit);
        let ([a, b], [c, d]) = (state.alpha, state.beta);
        let norm = (a * a + b * b + c * c + d * d).sqrt();
        // If the norm is 1 up to rounding, the numbers are kept, and `normalise_orientation` computes their deviation.
        let scale = if (norm - 1.0).abs() > 1e-14 { norm } else { 1.0 };
        let (alpha, beta) = ([a / scale, b / scale], [c / scale, d / scale]);
        let y = equations.vector(&FullState { alpha, beta, omega: state.omega.map(|w| w / rate_unit) });
        let m = [y[4], y[5], y[6]];
        let mut low = [0.0; 7];
        normalise_orientation(&y, &mut low);
        // momentum after a fall from rest, or at the start
        let momentum = (equations.a * (equations.a + equations.ps)).sqrt().max(dot(m, m).sqrt());
        // A rounding of m changes the angular velocity by momentum / min(A, C), to which the step control must not
        // react. The factor is 1 for ordinary tops, and larger for slender ones and for p s >> A. The quarter is
        // an empirical value.
        let least_inertia = if equations.c > 0.0 { equations.c } else { equations.a };
        let tolerance_factor = (0.25 * momentum / equations.a.min(least_inertia)).max(1.0);
        let usable = rate_unit.is_finite()
            && (momentum * tolerance_factor).is_finite()
            && (norm - 1.0).abs() <= 1e-6
            && (1e-17..=1e-2).contains(&tolerance);
        if !usable {
            return Err(failure(UNUSABLE));
        }
        let mut tolerances = [tolerance * tolerance_factor; 7];
        tolerances[4..].fill(tolerance * tolerance_factor * momentum);
        Ok(Self {
            equations,
            rate_unit,
            tolerances,
            limit: MAX_EVALUATIONS,
            time: 0.0,
            y,
            low,
            step: 0.05,
            evaluations: 0,
        })
    }

    /// State at exactly the time `t`, s, after an integration forward or backward. Cost: about 2700 evaluations (0.05 microseconds each)
    /// per nutation.
    ///
    /// # Errors
    /// [`Failure::method`]: the time is not finite, or it takes too many evaluations.
    pub fn advance_to(&mut self, t: f64) -> Result<FullState, Failure> {
        let span = (t - self.time) * self.rate_unit;
        if !span.is_finite() {
            return Err(failure(UNUSABLE));
        }
        self.integrate(span)?;
        self.time = t;
        Ok(self.state())
    }

    /// State at the time of the last call of [`advance_to`](Self::advance_to).
    pub fn state(&self) -> FullState {
        let state = self.equations.state(&self.y);
        FullState { omega: state.omega.map(|w| w * self.rate_unit), ..state }
    }

    /// Integrates over `span` in natural time.
    fn integrate(&mut self, span: f64) -> Result<(), Failure> {
        // A new method for each span, because the old one would refuse a span much shorter than its last step.
        let mut method = ExplicitRungeKutta::rkv988e().rtol(0.0).atol(self.tolerances).max_steps(usize::MAX);
        let mut done = 0.0;
        while done != span {
            let rest = span - done;
            // Two equal last steps replace a long one and a very short one.
            let planned = match self.step / rest.abs() {
                x if x >= 1.0 => rest,
                x if x > 0.5 => 0.5 * rest,
                _ => self.step.copysign(rest),
            };
            let change = Change { equations: &self.equations, from: &self.y };
            let time = self.time + done / self.rate_unit;
            let failed = || failure(&format!("no step meets the tolerance at t = {time:e}"));
            method.h0 = planned;
            let start = method.init(&change, 0.0, rest, &self.low).map_err(|_| failed())?;
            self.evaluations += start.function as u64;
            let mut taken = planned;
            loop {
                self.evaluations += method.step(&change).map_err(|_| failed())?.function as u64;
                // The integrator accepts a step whose error is not a number, so the state is checked.
                if !method.y().iter().all(|x| x.is_finite()) {
                    return Err(failed());
                }
                if self.evaluations > self.limit {
                    return Err(failure(&format!(
                        "gives up at t = {time:.2e} after {} evaluations of the equations; ask for earlier times",
                        self.limit
                    )));
                }
                if !matches!(method.status(), Status::RejectedStep) {
                    break;
                }
                taken = method.h();
            }
            for i in 0..7 {
                (self.y[i], self.low[i]) = two_sum(self.y[i], method.y()[i]);
            }
            normalise_orientation(&self.y, &mut self.low);
            // A step that was shortened to end the span is no measure for the next one.
            let proposed = method.h().abs();
            let cut_short = taken == planned && taken.abs() < self.step;
            self.step = if cut_short { proposed.max(self.step) } else { proposed };
            done = if taken == rest { span } else { done + taken };
        }
        Ok(())
    }
}

/// State of a scenario at t = 0: that of the launch without change, or for branch points that of the core.
pub fn initial_state(scenario: &Scenario) -> FullState {
    match scenario.input.launch {
        Launch::State { orientation, omega } => FullState::new(&orientation, omega),
        Launch::BranchPoints { .. } => {
            let state = scenario.motion.attitude_at_launch();
            FullState::new(&state.orientation, state.omega())
        }
    }
}

/// States of a scenario at these times, in their order.
///
/// # Errors
/// [`Failure::method`]: the solver cannot integrate that far.
pub fn states(scenario: &Scenario, times: &[f64]) -> Result<Vec<FullState>, Failure> {
    FullSolver::new(scenario.motion.top(), initial_state(scenario), FULL_SOLVER_TOLERANCE)
        .and_then(|start| step_to_each(times, || start.clone(), FullSolver::advance_to))
        .map_err(|failure| failure.at(&scenario.name))
}

/// Equations for the change that is added to `from`.
struct Change<'a> {
    equations: &'a Equations,
    from: &'a Vector7,
}

impl ODE<f64, Vector7> for Change<'_> {
    fn diff(&self, _t: f64, change: &Vector7, rate: &mut Vector7) {
        *rate = self.equations.derivative(&core::array::from_fn(|i| self.from[i] + change[i]));
    }
}

/// Greatest power of two that is at most `x`, for `x` > 0; 1 for any other number.
fn power_of_two(x: f64) -> f64 {
    let power = f64::from_bits(x.to_bits() & f64::INFINITY.to_bits());
    if power > 0.0 { power } else { 1.0 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use toytop::TopParameters;

    /// A, C, s and p.
    const TOP: [f64; 4] = [1.3, 0.7, 0.8, 1.1];
    const START: FullState = FullState { alpha: [0.48, 0.64], beta: [0.36, -0.48], omega: [0.4, -0.3, 2.1] };

    fn top([transverse_inertia, axial_inertia, com_height, mass_moment]: [f64; 4], gravity: f64) -> Top {
        let others = TopParameters::default();
        let parameters =
            TopParameters { transverse_inertia, axial_inertia, com_height, mass_moment, gravity, ..others };
        if com_height > 0.0 { Top::sliding(&parameters) } else { Top::fixed(&parameters) }.unwrap()
    }

    fn at(top: &Top, state: FullState, t: f64) -> FullState {
        FullSolver::new(top, state, FULL_SOLVER_TOLERANCE).unwrap().advance_to(t).unwrap()
    }

    /// Distance of two orientations, 2 sqrt(|d alpha|^2 + |d beta|^2), rad.
    fn angle(x: FullState, y: FullState) -> f64 {
        let gap = |x: [f64; 2], y: [f64; 2]| (x[0] - y[0]).hypot(x[1] - y[1]);
        2.0 * gap(x.alpha, y.alpha).hypot(gap(x.beta, y.beta))
    }

    /// State with this tilt, azimuth and roll, and omega = precession k + spin r.
    fn precessing(tilt: f64, azimuth: f64, roll: f64, precession: f64, spin: f64) -> FullState {
        let polar = |size: f64, angle: f64| [size * angle.cos(), size * angle.sin()];
        let alpha = polar((tilt / 2.0).cos(), (azimuth + roll) / 2.0);
        let beta = polar(-(tilt / 2.0).sin(), (azimuth - roll) / 2.0);
        let still = FullState { alpha, beta, omega: [0.0, 0.0, precession] };
        let r = still.axis();
        FullState { omega: core::array::from_fn(|i| still.omega[i] + spin * r[i]), ..still }
    }

    #[test]
    fn regular_precession() {
        // A e f^2 - n f + p g = 0 with n = C (f e + spin) keeps the tilt acos e at the precession f; e = 1
        // sleeps.
        for (g, s, e, t) in [(1.0, 0.8, 0.6, -20.0), (9.81, 0.03, 0.6_f64, 20.0), (9.81, 0.0, 1.0, 20.0)] {
            let ([a, c, _, p], f) = (TOP, 1.7 * f64::sqrt(g));
            let top = top([a, c, s, p], g);
            let spin = (a * e * f * f + p * g) / (f * c) - f * e;
            let exact = precessing(e.acos(), 0.3 + f * t, -0.2 + spin * t, f, spin);
            assert!(
                angle(at(&top, precessing(e.acos(), 0.3, -0.2, f, spin), t), exact) < 1e-12,
                "e {e}, g {g}"
            );
        }
    }

    #[test]
    fn first_integrals_and_there_and_back() {
        // The second top is the first in other units (inertia 2.3e-5, time 1/9.7).
        let [a, c, s, p] = TOP;
        let toy = [a * 2.3e-5, c * 2.3e-5, s * 0.023, p * 1e-3];
        for (top, rate) in [(top(TOP, 1.0), 1.0), (top(toy, 2.16407), 9.7)] {
            let start = FullState { omega: START.omega.map(|w| w * rate), ..START };
            let mut solver = FullSolver::new(&top, start, FULL_SOLVER_TOLERANCE).unwrap();
            let integrals = |state: &FullState| Equations::new(&top, state).first_integrals(state);
            let [l, n, h] = integrals(&solver.state());
            solver.advance_to(50.0 / rate).unwrap();
            let [l2, n2, h2] = integrals(&solver.state());
            assert!([l2 / l, n2 / n, h2 / h].iter().all(|x| (x - 1.0).abs() < 5e-14), "{l2} {n2} {h2}");
            assert!(angle(solver.advance_to(0.0).unwrap(), start) < 1e-12);
        }
    }

    #[test]
    fn unusable_input_is_an_error() {
        let run = |state, t| {
            let mut solver = FullSolver::new(&top(TOP, 1.0), state, 1e-12)?;
            solver.limit = 5000;
            solver.advance_to(t)
        };
        assert!(run(FullState { alpha: [1.0, 0.0], ..START }, 1.0).is_err());
        assert!(run(FullState { omega: [f64::NAN; 3], ..START }, 1.0).is_err());
        assert!(run(START, 1e300).err().unwrap().to_string().contains("after 5000 evaluations"));
    }
}
