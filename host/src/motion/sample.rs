//! Motion at one time, by any method.

use std::f64::consts::TAU;
use toytop::scalar::Real;
use toytop::{AttitudeState, Complex, Phase, Pose};
use toytop_model::equations::Rates;

/// Motion at one time: each quantity is computed when it is asked for. The fields of [`Sample`] describe them.
#[expect(missing_docs)]
pub trait SampleQuantities {
    fn t(&self) -> f64;
    fn pose(&self) -> Pose<f64, f64>;
    fn omega(&self) -> [f64; 3];
    fn omega_body(&self) -> [f64; 3];
    fn udot(&self) -> f64;
    fn tip_angle(&self) -> Option<f64>;
    fn error_bound(&self) -> Option<f64>;
}

/// Motion at one time in `f64`.
#[derive(Clone, Copy)]
pub struct Sample {
    /// Time, s.
    pub t: f64,
    /// Orientation Φ, cosine u of the tilt, and position of the tip c = 2 s αβ, m; 2 αβ for a fixed tip.
    pub pose: Pose<f64, f64>,
    /// Angular velocities, and rate of u.
    pub rates: Rates,
    /// Tip angle continued from t = 0, rad; `None` where the axis is vertical at all times.
    pub tip_angle: Option<f64>,
    /// Upper bound on the error of the orientation, rad, where the method has one.
    pub error_bound: Option<f64>,
}

impl SampleQuantities for Sample {
    fn t(&self) -> f64 {
        self.t
    }

    fn pose(&self) -> Pose<f64, f64> {
        self.pose
    }

    fn omega(&self) -> [f64; 3] {
        self.rates.omega
    }

    fn omega_body(&self) -> [f64; 3] {
        self.rates.omega_body
    }

    fn udot(&self) -> f64 {
        self.rates.udot
    }

    fn tip_angle(&self) -> Option<f64> {
        self.tip_angle
    }

    fn error_bound(&self) -> Option<f64> {
        self.error_bound
    }
}

impl Sample {
    /// Sample with all quantities.
    pub fn new(now: &impl SampleQuantities) -> Self {
        let rates = Rates { omega: now.omega(), omega_body: now.omega_body(), udot: now.udot() };
        let (tip_angle, error_bound) = (now.tip_angle(), now.error_bound());
        Self { t: now.t(), pose: now.pose(), rates, tip_angle, error_bound }
    }

    /// Sample of an attitude state of the core at time t.
    pub fn from_state<R: Real>(
        t: f64,
        state: &AttitudeState<R>,
        tip: Complex<R>,
        tip_angle: Option<f64>,
    ) -> Self {
        let orientation = state.orientation.map(R::to_f64);
        let u = state.orientation.u().to_f64().clamp(-1.0, 1.0);
        let pose = Pose { orientation, u, tip: tip.map(R::to_f64) };
        Self { t, pose, rates: body_rates(state), tip_angle, error_bound: None }
    }
}

/// Rates of an attitude state of the core.
pub fn body_rates<R: Real>(state: &AttitudeState<R>) -> Rates {
    let [omega, omega_body] = [state.omega(), state.omega_body()].map(|vector| vector.map(R::to_f64));
    Rates { omega, omega_body, udot: state.udot().to_f64() }
}

/// Angle in radians of a phase known modulo 2^32 turns, nearest to `near`, a number of turns.
pub fn unwrapped(phase: Phase, near: f64) -> f64 {
    const MODULUS: f64 = (1_u64 << 32) as f64;
    let turns = phase.to_turns();
    TAU * (turns + MODULUS * ((near - turns) / MODULUS).round())
}
