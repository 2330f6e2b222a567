//! Motion at one time, by any method.

use std::f64::consts::TAU;
use toytop::scalar::Real;
use toytop::{AttitudeState, Complex, Orientation, Phase};
use toytop_model::equations::Rates;

/// Motion at one time in `f64`.
#[derive(Clone, Copy)]
pub struct MotionSample {
    /// Time, s.
    pub t: f64,
    /// Orientation Φ.
    pub orientation: Orientation<f64>,
    /// Cosine u of the tilt.
    pub u: f64,
    /// Position of the tip c = 2 s αβ, m; 2 αβ for a fixed tip.
    pub tip: Complex<f64>,
    /// Angular velocities, and rate of u.
    pub rates: Rates,
    /// Tip angle continued from t = 0, rad; `None` where the axis is vertical at all times or the motion has no table.
    pub tip_angle: Option<f64>,
    /// Upper bound on the error of the orientation, rad, where the method has one.
    pub error_bound: Option<f64>,
}

impl MotionSample {
    /// Sample without quantities: its numbers are NaN.
    pub(super) const EMPTY: Self = Self {
        t: f64::NAN,
        orientation: Orientation { alpha: NAN, beta: NAN },
        u: f64::NAN,
        tip: NAN,
        rates: Rates { omega: [f64::NAN; 3], omega_body: [f64::NAN; 3], udot: f64::NAN },
        tip_angle: None,
        error_bound: None,
    };

    /// Sample of an attitude state of the core at time t.
    pub fn from_state<R: Real>(
        t: f64,
        state: &AttitudeState<R>,
        tip: Complex<R>,
        tip_angle: Option<f64>,
    ) -> Self {
        Self {
            t,
            orientation: state.orientation.map(R::to_f64),
            u: state.orientation.u().to_f64().clamp(-1.0, 1.0),
            tip: tip.map(R::to_f64),
            rates: Rates::from_attitude(state),
            tip_angle,
            error_bound: None,
        }
    }
}

const NAN: Complex<f64> = Complex { re: f64::NAN, im: f64::NAN };

/// Angle in radians of a phase known modulo 2^32 turns, nearest to `near`, a number of turns.
pub fn unwrapped(phase: Phase, near: f64) -> f64 {
    const MODULUS: f64 = (1_u64 << 32) as f64;
    let turns = phase.to_turns();
    TAU * (turns + MODULUS * ((near - turns) / MODULUS).round())
}
