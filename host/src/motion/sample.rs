//! Motion at one time, by any method.

use toytop::scalar::Real;
use toytop::{AttitudeState, Complex, Orientation, Pose};
use toytop_model::equations::BodyRates;

/// Quantities of a motion at one time. A source that can compute one without the others does so.
pub trait Quantities {
    /// All of them.
    fn sample(&self) -> Sample;

    /// Time, s.
    fn t(&self) -> f64 {
        self.sample().t
    }

    /// Orientation Φ, cosine u of the tilt, and position of the tip.
    fn pose(&self) -> Pose<f64, f64> {
        self.sample().pose
    }

    /// Orientation Φ.
    fn orientation(&self) -> Orientation<f64> {
        self.pose().orientation
    }

    /// Angular velocity ω in the fixed frame, rad/s.
    fn omega(&self) -> [f64; 3] {
        self.sample().rates.omega
    }

    /// Angular velocity Ω in the body frame, rad/s.
    fn omega_body(&self) -> [f64; 3] {
        self.sample().rates.omega_body
    }

    /// Rate u' of the cosine of the tilt, 1/s.
    fn udot(&self) -> f64 {
        self.sample().rates.udot
    }

    /// Tip angle continued from t = 0, rad; `None` where the axis is vertical at all times.
    fn tip_angle(&self) -> Option<f64> {
        self.sample().tip_angle
    }

    /// Upper bound on the error of the orientation, rad, where the method has one.
    fn error_bound(&self) -> Option<f64> {
        self.sample().error_bound
    }
}

/// Motion at one time in `f64`.
#[derive(Clone, Copy)]
pub struct Sample {
    /// Time, s.
    pub t: f64,
    /// Orientation Φ, cosine u of the tilt, and position of the tip c = 2 s αβ, m; 2 αβ for a fixed tip.
    pub pose: Pose<f64, f64>,
    /// Angular velocities, and rate of u.
    pub rates: BodyRates,
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

impl Quantities for Sample {
    fn sample(&self) -> Sample {
        *self
    }
}

/// Rates of an attitude state of the core.
pub fn body_rates<R: Real>(state: &AttitudeState<R>) -> BodyRates {
    let [omega, omega_body] = [state.omega(), state.omega_body()].map(|vector| vector.map(R::to_f64));
    BodyRates { omega, omega_body, udot: state.udot().to_f64() }
}
