//! Orientation of a motion at any time, from α and β of a closed form within a period.

use crate::elliptic::elementary::{ValueAndSlope, angle, rounded, widened};
use toytop::internal::{ExtendedConstants, attitude_without_roll};
use toytop::scalar::{Extended, Float, Ring};
use toytop::su2::{Orientation, OrientationRate};
use toytop::{AttitudeState, Complex, Motion, Phase};

/// Constant arguments of α and β, and the rates ±τ/2 of a top with A ≠ C.
///
/// The orientation is Φ(t) = diag(e^{ia}, e^{ib}) Φ_closed(t) diag(e^{iτt/2}, e^{-iτt/2}), with Φ_closed that of a
/// top with A = C.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct ArgumentOffsets {
    /// Angles a and b.
    pub(super) angles: [Phase; 2],
    half_tau: Extended,
}

impl ArgumentOffsets {
    /// Arguments from α, β and their time derivatives in the closed form at t = 0, for C = A.
    ///
    /// The derivatives count too, so that the argument is well defined also where a parameter is 0 at t = 0.
    pub(super) fn new(motion: &Motion, [alpha, beta]: [ValueAndSlope; 2]) -> Self {
        let ExtendedConstants { a, p, g, half_tau, .. } = motion.into();
        let AttitudeState { orientation, rate } = attitude_without_roll(motion);
        // squares of the greatest rates of this motion: of its rotation and of its nutation
        let rotation = rate.alpha.norm_squared() + rate.beta.norm_squared();
        let time_squared = Extended::ONE / (p * g / a + rotation.into());
        let offset = |z: Complex<f64>, z_rate: Complex<f64>, closed: ValueAndSlope| {
            let [z, z_rate] = [z, z_rate].map(widened);
            let sum = z * closed.value.conj() + (z_rate * closed.slope.conj()).scaled(time_squared);
            angle(sum.im, sum.re).radians_to_turns().to_phase()
        };
        let angles =
            [offset(orientation.alpha, rate.alpha, alpha), offset(orientation.beta, rate.beta, beta)];
        Self { angles, half_tau }
    }

    /// Attitude state at t, from α, β and their time derivatives in the closed form, and the rotation of α and β over
    /// the whole periods.
    pub(super) fn attitude_state(
        &self,
        t: f64,
        [alpha, beta]: [ValueAndSlope; 2],
        [alpha_rotation, beta_rotation]: [Phase; 2],
    ) -> AttitudeState<f64> {
        let half_tau_phase = (self.half_tau * t.into()).radians_to_turns().to_phase();
        let half_tau = self.half_tau.to_f64();
        let placed = |closed: ValueAndSlope, rotation: Phase, tau: f64| {
            let factor = Complex::cis(rotation);
            let value = rounded(closed.value) * factor;
            (value, rounded(closed.slope) * factor + value.times_i().scaled(tau))
        };
        let [a, b] = self.angles;
        let (alpha, alpha_rate) = placed(alpha, a + alpha_rotation + half_tau_phase, half_tau);
        let (beta, beta_rate) = placed(beta, b + beta_rotation - half_tau_phase, -half_tau);
        let rate = OrientationRate { alpha: alpha_rate, beta: beta_rate };
        AttitudeState { orientation: Orientation { alpha, beta }, rate }
    }
}

/// Periods of a closed form, which reduce any time to a time of its solution, within half a period of 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Periods {
    /// Nutation period.
    pub(super) period: Extended,
    /// Rotation of α and β over one period, for C = A.
    pub(super) rotations: [Phase; 2],
    /// Time of the solution at t = 0 of the motion.
    pub(super) origin: Extended,
    pub(super) arguments: ArgumentOffsets,
}

impl Periods {
    /// Attitude state at t, from α, β and their derivatives at a time of the solution.
    pub(super) fn attitude_state(
        &self,
        t: f64,
        parameters: impl Fn(Extended) -> [ValueAndSlope; 2],
    ) -> AttitudeState<f64> {
        let (periods, remainder) = split(self.origin, t, self.period);
        self.arguments.attitude_state(
            t,
            parameters(remainder),
            self.rotations.map(|rotation| rotation * periods),
        )
    }

    /// Number of periods from time 0 of the solution until t, as a phase of one turn for each period.
    pub(super) fn phase(&self, t: f64) -> Phase {
        let (periods, remainder) = split(self.origin, t, self.period);
        Phase::TURN * periods + (remainder / self.period).to_phase()
    }
}

/// Nearest whole number of periods in origin + t, and the remainder, which is 0 beyond 9e15 periods. A t that is not
/// finite counts as 0.
fn split(origin: Extended, t: f64, period: Extended) -> (i64, Extended) {
    let time = origin + t.into();
    let periods = libm::round(time.to_f64() / period.to_f64());
    if Float::abs(periods) >= 9e15 {
        return (0, Extended::ZERO);
    }
    (periods as i64, time - period * periods.into())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn whole_periods_are_taken_off_exactly() {
        let period = Extended::ONE / 3.0.into();
        let (periods, remainder) = split(Extended::from(0.125), 1e9, period);
        assert_eq!(periods, 3_000_000_000);
        assert!((remainder.to_f64() - 0.125).abs() < 1e-22, "{remainder:?}");
        assert_eq!(split(Extended::ZERO, 1e300, Extended::ONE), (0, Extended::ZERO));
    }
}
