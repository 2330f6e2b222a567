//! Full solver: step by step integration of the three-dimensional equations of motion. It shares no code and no formula with the core, so
//! that it is an independent reference.
//!
//! The integrator is Verner's 9(8) pair from `differential-equations`, called for one step at a time, so that the last step ends exactly at
//! the requested time without dense output. Three measures limit the rounding to that of a single operation per step:
//! - units of inertia and time are powers of two near A and the fastest rate, so that changing units is exact
//!   and one tolerance suits every top;
//! - each step integrates the *change* of the state from zero, and the changes are added with
//!   compensation (the integrator's own sums and its error estimate would be rounded relative to the state);
//! - after each step the orientation is normalised, by a change of its length only.

mod equations;
mod rounding;

use core::fmt;

use differential_equations::methods::ExplicitRungeKutta;
use differential_equations::ode::{ODE, OrdinaryNumericalMethod};
use differential_equations::status::Status;

pub use equations::{Equations, FullState, FullTop, Vector7, cross, dot};
use rounding::{power_of_two, project, two_sum};

/// Default tolerance per step. By measurement, smaller ones increase the number of evaluations, but not the accuracy.
pub const FULL_SOLVER_TOLERANCE: f64 = 3e-16;
/// Default limit on evaluations of the equations, which takes about five seconds, for some thirty thousand nutations.
pub const FULL_SOLVER_EVALUATIONS: u64 = 100_000_000;

/// Reason why [`FullSolver::advance_to`] failed. Times are in the caller's units, s.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum FullSolverError {
    /// Invalid top, state, tolerance or time, which the text names.
    BadInput(&'static str),
    /// Limit on evaluations, which was reached at `time`.
    EvaluationLimit {
        /// Greatest number of evaluations.
        limit: u64,
        /// Time that the integration reached.
        time: f64,
    },
    /// Tolerance that no step meets at `time`.
    StepFailed {
        /// Time that the integration reached.
        time: f64,
    },
    /// State that is not finite after `time`.
    NotFinite {
        /// Time that the integration reached.
        time: f64,
    },
}

impl fmt::Display for FullSolverError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::BadInput(what) => write!(f, "full solver: {what}"),
            Self::EvaluationLimit { limit, time } => {
                write!(
                    f,
                    "full solver: gives up at t = {time:.2e} after {limit} evaluations of the equations; ask for earlier times"
                )
            }
            Self::StepFailed { time } => {
                write!(f, "full solver: no step meets the tolerance at t = {time:e}")
            }
            Self::NotFinite { time } => write!(f, "full solver: the state is not finite after t = {time:e}"),
        }
    }
}

impl core::error::Error for FullSolverError {}

/// Numerical integration of a motion from t = 0.
#[derive(Debug, Clone)]
pub struct FullSolver {
    top: FullTop,
    equations: Equations,
    /// Natural unit of angular rates, rad/s.
    rate_unit: f64,
    tolerances: Vector7,
    limit: u64,
    fault: Option<&'static str>,
    time: f64,
    /// State, as the sum of `y` and the smaller part `low`.
    y: Vector7,
    low: Vector7,
    step: f64,
    evaluations: u64,
    steps: u64,
}

impl FullSolver {
    /// Integration from `state` at t = 0, whose orientation is normalised. `tolerance`, in \[1e-17, 1e-2\], bounds the error of a step
    /// in alpha and beta (absolute) and m (relative to the momenta of the motion). The first [`advance_to`](Self::advance_to) reports
    /// invalid arguments.
    ///
    /// Measured at the default tolerance, over three nutations and the project's reference motions:
    /// orientation within 5e-14 rad, except where the motion itself amplifies rounding (separatrix,
    /// aperiodic: 3e-9 rad).
    #[must_use]
    pub fn new(top: FullTop, state: FullState, tolerance: f64) -> Self {
        let rotor = top.k / top.a;
        let rate = (top.p * top.g.abs() / top.a + dot(state.omega, state.omega) + rotor * rotor).sqrt();
        // a body at rest without weight has no natural rate
        let rate_unit = if rate > 0.0 { power_of_two(rate) } else { 1.0 };
        let inertia_unit = power_of_two(top.a);
        let equations = Equations {
            k: top.k / inertia_unit / rate_unit,
            spin: dot(state.omega, state.axis()) / rate_unit,
            a: top.a / inertia_unit,
            c: top.c / inertia_unit,
            ps: top.p * top.s / inertia_unit,
            pg: top.p * top.g / inertia_unit / rate_unit / rate_unit,
        };
        let ([a, b], [c, d]) = (state.alpha, state.beta);
        let norm = (a * a + b * b + c * c + d * d).sqrt();
        // If the norm is 1 up to rounding, the numbers are kept, and `project` computes their deviation.
        let scale = if (norm - 1.0).abs() > 1e-14 { norm } else { 1.0 };
        let (alpha, beta) = ([a / scale, b / scale], [c / scale, d / scale]);
        let m = equations.momentum(&FullState { alpha, beta, omega: state.omega.map(|w| w / rate_unit) });
        let y = [alpha[0], alpha[1], beta[0], beta[1], m[0], m[1], m[2]];
        let mut low = [0.0; 7];
        project(&y, &mut low);
        // A top that falls reaches the first of these momenta even if it starts at rest.
        let momentum = (equations.a * (equations.a + equations.ps)).sqrt().max(dot(m, m).sqrt());
        // A rounding of m changes the angular velocity by momentum / min(A, C), to which the step control must not
        // react. The factor is 1 for ordinary tops, and larger for slender ones and for p s >> A. The quarter is
        // an empirical value.
        let thin = if equations.c > 0.0 { equations.c } else { equations.a };
        let blur = (0.25 * momentum / equations.a.min(thin)).max(1.0);
        let fault = fault(&top, &state, tolerance, &[equations.c, equations.pg, rate_unit, momentum * blur]);
        let mut tolerances = [tolerance * blur; 7];
        tolerances[4..].fill(tolerance * blur * momentum);
        Self {
            top,
            equations,
            rate_unit,
            tolerances,
            limit: FULL_SOLVER_EVALUATIONS,
            fault,
            time: 0.0,
            y,
            low,
            step: 0.05,
            evaluations: 0,
            steps: 0,
        }
    }

    /// Solver with this limit on the total number of evaluations of the equations, so that its time is limited for every input.
    #[must_use]
    pub fn with_evaluation_limit(mut self, limit: u64) -> Self {
        self.limit = limit;
        self
    }

    /// State at exactly the time `t`, s, after an integration forward or backward. After an error the solver is in the state before the
    /// call. Cost: about 2700 evaluations (0.05 microseconds each) per nutation.
    ///
    /// # Errors
    /// [`FullSolverError`]. A returned state is finite.
    pub fn advance_to(&mut self, t: f64) -> Result<FullState, FullSolverError> {
        if let Some(what) = self.fault {
            return Err(FullSolverError::BadInput(what));
        }
        let span = (t - self.time) * self.rate_unit;
        if !span.is_finite() {
            return Err(FullSolverError::BadInput("the time has to be finite"));
        }
        let (y, low) = (self.y, self.low);
        let reached = self.integrate(span).and_then(|()| {
            let state = self.state();
            let finite = state.omega.iter().all(|w| w.is_finite());
            if finite { Ok(state) } else { Err(FullSolverError::NotFinite { time: t }) }
        });
        match reached {
            Ok(_) => self.time = t,
            Err(_) => (self.y, self.low) = (y, low),
        }
        reached
    }

    /// State at [`time`](Self::time).
    #[must_use]
    pub fn state(&self) -> FullState {
        let state = self.equations.state(&self.y);
        FullState { omega: state.omega.map(|w| w * self.rate_unit), ..state }
    }

    /// Time that is reached, s.
    #[must_use]
    pub fn time(&self) -> f64 {
        self.time
    }

    /// First integrals (l, n, h) of the state, see [`FullTop::first_integrals`].
    #[must_use]
    pub fn first_integrals(&self) -> (f64, f64, f64) {
        self.top.first_integrals(&self.state())
    }

    /// Number of evaluations of the equations so far.
    #[must_use]
    pub fn evaluations(&self) -> u64 {
        self.evaluations
    }

    /// Number of steps so far, with the rejected ones.
    #[must_use]
    pub fn steps(&self) -> u64 {
        self.steps
    }

    /// Integrates over `span` in natural time.
    fn integrate(&mut self, span: f64) -> Result<(), FullSolverError> {
        // A new method for each span, because the old one would refuse a span much shorter than its last step.
        let mut method = ExplicitRungeKutta::rkv988e().rtol(0.0).atol(self.tolerances).max_steps(usize::MAX);
        let mut done = 0.0;
        while done != span {
            let time = self.time + done / self.rate_unit;
            let rest = span - done;
            // Two equal last steps replace a long one and a very short one.
            let planned = match self.step / rest.abs() {
                x if x >= 1.0 => rest,
                x if x > 0.5 => 0.5 * rest,
                _ => self.step.copysign(rest),
            };
            let change = Change { equations: &self.equations, from: &self.y };
            method.h0 = planned;
            let start = method.init(&change, 0.0, rest, &self.low);
            self.evaluations += start.map_err(|_| FullSolverError::StepFailed { time })?.function as u64;
            let mut taken = planned;
            loop {
                let cost = method.step(&change).map_err(|_| FullSolverError::StepFailed { time })?;
                self.evaluations += cost.function as u64;
                self.steps += 1;
                // The integrator accepts a step whose error is not a number, so the state is checked.
                if !method.y().iter().all(|x| x.is_finite()) {
                    return Err(FullSolverError::NotFinite { time });
                }
                if self.evaluations > self.limit {
                    return Err(FullSolverError::EvaluationLimit { limit: self.limit, time });
                }
                if !matches!(method.status(), Status::RejectedStep) {
                    break;
                }
                taken = method.h();
            }
            for i in 0..7 {
                (self.y[i], self.low[i]) = two_sum(self.y[i], method.y()[i]);
            }
            project(&self.y, &mut self.low);
            // A step that was shortened to end the span is no measure for the next one.
            let proposed = method.h().abs();
            let cut_short = taken == planned && taken.abs() < self.step;
            self.step = if cut_short { proposed.max(self.step) } else { proposed };
            done = if taken == rest { span } else { done + taken };
        }
        Ok(())
    }
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

/// Error of the arguments of [`FullSolver::new`], if there is one. `natural` are the natural units that were computed from them.
fn fault(top: &FullTop, state: &FullState, tolerance: f64, natural: &[f64; 4]) -> Option<&'static str> {
    let FullTop { a, c, s, p, g, k } = *top;
    let ([ar, ai], [br, bi]) = (state.alpha, state.beta);
    let positive = |x: f64| x > 0.0 && x.is_finite();
    let checks = [
        (
            positive(a) && c >= 0.0 && c.is_finite(),
            "the inertias have to be positive, the axial one at least 0",
        ),
        (s >= 0.0 && p >= 0.0, "the centre of mass' distance and the mass moment must not be negative"),
        ([s, p, g, k].iter().all(|x| x.is_finite()), "the top's numbers have to be finite"),
        (state.omega.iter().all(|w| w.is_finite()), "the angular velocity has to be finite"),
        (
            (ar * ar + ai * ai + br * br + bi * bi - 1.0).abs() <= 1e-6,
            "|alpha|^2 + |beta|^2 has to be 1 within 1e-6",
        ),
        ((1e-17..=1e-2).contains(&tolerance), "the tolerance has to lie in [1e-17, 1e-2]"),
        (
            natural.iter().all(|x| x.is_finite()) && positive(natural[3]),
            "the top's and the state's numbers are too far apart in size",
        ),
    ];
    checks.iter().find(|(fine, _)| !fine).map(|(_, what)| *what)
}

#[cfg(test)]
mod tests;
