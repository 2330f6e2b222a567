//! Motion at one time, by any method.

use toytop::scalar::Real;
use toytop::{AttitudeState, Complex, Orientation, Pose};
use toytop_model::equations::Rates;

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

impl Sample {
    /// Sample of an attitude state of the core at time t.
    pub fn from_state<R: Real>(
        t: f64,
        state: &AttitudeState<R>,
        tip: Complex<R>,
        tip_angle: Option<f64>,
    ) -> Self {
        let Orientation { alpha, beta } = state.orientation;
        let [alpha, beta, tip] = [alpha, beta, tip].map(|z| Complex::new(z.re.to_f64(), z.im.to_f64()));
        let pose = Pose {
            orientation: Orientation { alpha, beta },
            u: state.orientation.u().to_f64().clamp(-1.0, 1.0),
            tip,
        };
        Self { t, pose, rates: body_rates(state), tip_angle, error_bound: None }
    }
}

/// Rates of an attitude state of the core.
pub fn body_rates<R: Real>(state: &AttitudeState<R>) -> Rates {
    let [omega, omega_body] = [state.omega(), state.omega_body()].map(|vector| vector.map(R::to_f64));
    Rates { omega, omega_body, udot: state.udot().to_f64() }
}
