//! Body without torque (e₃ → ∞): two rotations, about the angular momentum and about the axis.
//!
//! The angular momentum m is constant in the fixed frame. The axis rotates about it at the rate |m|/A, and relative to that the
//! body turns about its axis at the rate τ = ⟨ω, r⟩ - n/A:
//!
//! ```text
//! Φ(t) = exp(m t/A) Φ(0) diag(e^{iτt/2}, e^{-iτt/2})
//! ```
//!
//! The formula needs neither branch points nor a table.

use toytop::internal::{ExtendedConstants, attitude_without_roll};
use toytop::scalar::{Extended, Float, Ring};
use toytop::su2::{Orientation, Vector, add_scaled, dot, scaled};
use toytop::{AttitudeState, Complex, Motion, Phase};

/// Motion of a body without torque as a function of time: a free body, or a top with a fixed tip and g = 0.
///
/// Error of an orientation: below 3e-15 rad at any time up to 1e9 turns of the body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FreeBody {
    start: Orientation<f64>,
    /// Unit vector along m; 0 where m is 0.
    angular_momentum_axis: Vector<f64>,
    /// Rate |m|/A, rad per unit time.
    precession: Extended,
    /// Half of τ, rad per unit time.
    half_tau: Extended,
    nutation: Option<Phase>,
}

impl FreeBody {
    /// Closed form of a motion; `None` unless no torque acts.
    #[must_use]
    pub fn new(motion: &Motion) -> Option<Self> {
        if !motion.top().is_torque_free() {
            return None;
        }
        let ExtendedConstants { torque_free_rate, half_tau, half_phase, .. } = motion.into();
        let attitude = attitude_without_roll(motion);
        let m_over_a = attitude.omega();
        let length = Float::sqrt(dot(m_over_a, m_over_a));
        Some(Self {
            start: attitude.orientation,
            angular_momentum_axis: if length > 0.0 {
                m_over_a.map(|component| component / length)
            } else {
                [0.0; 3]
            },
            precession: torque_free_rate.doubled(),
            half_tau,
            nutation: half_phase,
        })
    }

    /// Angular rate |m|/A of the axis about the angular momentum, rad per unit time.
    #[must_use]
    pub fn precession(&self) -> f64 {
        self.precession.to_f64()
    }

    /// Unit vector along the angular momentum, in the fixed frame; 0 for a body without angular momentum.
    #[must_use]
    pub fn angular_momentum_axis(&self) -> Vector<f64> {
        self.angular_momentum_axis
    }

    /// Orientation Φ and rate Φ' at t. A t that is not finite counts as 0.
    #[must_use]
    pub fn at(&self, t: f64) -> AttitudeState<f64> {
        let t = if t.is_finite() { t } else { 0.0 };
        let half_angle = |rate: Extended| (rate * t.into()).radians_to_turns().to_phase();
        let turn = Complex::<f64>::cis(half_angle(self.precession.halved()));
        let [x, y, z] = self.angular_momentum_axis;
        let about_m = Orientation {
            alpha: Complex::new(turn.re, z * turn.im),
            beta: Complex::new(-y * turn.im, x * turn.im),
        };
        let roll = Complex::<f64>::cis(half_angle(self.half_tau));
        let about_axis = Orientation { alpha: roll, beta: Complex::ZERO };
        let orientation = about_m.compose(&self.start).compose(&about_axis);
        let fast = self.precession.to_f64();
        let slow = 2.0 * self.half_tau.to_f64();
        let omega = add_scaled(scaled(self.angular_momentum_axis, fast), orientation.axis(), slow);
        AttitudeState::from_fixed(orientation, omega)
    }

    /// Nutation phase at t, whole periods included: 0 at u = e₁, half a turn at u = e₂. `None` for a steady motion.
    #[must_use]
    pub fn nutation_phase(&self, t: f64) -> Option<Phase> {
        let t = if t.is_finite() { t } else { 0.0 };
        self.nutation.map(|chi| chi + chi + (self.precession * t.into()).radians_to_turns().to_phase())
    }
}
