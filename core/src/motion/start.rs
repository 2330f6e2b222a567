//! Start of a motion: half phase χ and slow phases at t = 0.

use crate::body::{ScaledTop, State};
use crate::complex::Complex;
use crate::constants::{ReducedPoint, Regime};
use crate::motion::cayley_klein::{Ellipse, Ellipses};
use crate::motion::phase_equations::{PhaseEquations, PhaseRates};
use crate::motion::{HalfPhase, Motion};
use crate::phase::Phase;
use crate::scalar::{Extended, Float, Ring};
use crate::su2::{AttitudeState, OrientationRate};

/// Phases at t = 0 of a motion given by branch points. All are in rad, and 0 by default.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct InitialPhases {
    /// Nutation angle θ(0) = 2χ(0): 0 at u = e₁, π at u = e₂, with u rising in between. The `f64` nearest to a multiple of π counts as it. θ = π with
    /// e₂ = e₃ = 1 means the sleeping top.
    pub theta: f64,
    /// Argument of α(0); where α(0) = 0, that of α'(0).
    pub arg_alpha: f64,
    /// Argument of β(0); where β(0) = 0, that of β'(0).
    pub arg_beta: f64,
}

impl Motion {
    /// Sets the half phase at a point of the reduced curve.
    ///
    /// √(e₂ - e₁) sin χ = √(u - e₁), and √(e₂ - e₁) cos χ = ±√(e₂ - u) with the sign of u'. In an aperiodic motion sin χ has that sign
    /// instead. The smaller difference comes from (u - e₁)(e₂ - u) = g₀/(e₃ - u).
    #[inline(never)] // stack
    pub(super) fn start_nutation(&mut self, point: &ReducedPoint) {
        let ScaledTop { a, s, p, g, .. } = self.scaled_top();
        let ReducedPoint { one_minus_u, one_plus_u, udot, .. } = *point;
        let torque_free = self.top.is_torque_free();
        if torque_free {
            // the axis rotates about the angular momentum m at the rate |m|/A
            self.torque_free_rate = (point.momentum(a, self.integrals.n) / a).halved();
        }
        if self.is_steady() {
            return;
        }
        let (g0, below_e3) = if torque_free {
            ((udot / self.torque_free_rate.doubled()).squared(), Extended::ONE)
        } else {
            let d = a / p + s * one_minus_u * one_plus_u;
            (d * udot.squared() / g.doubled(), one_minus_u + self.e.e3_minus_one)
        };
        let (above_e1, below_e2) = (one_plus_u - self.e.one_plus_e1, one_minus_u - self.e.one_minus_e2);
        let (above_e1, below_e2) = if below_e2 < above_e1 {
            (above_e1, g0 / (below_e3 * above_e1))
        } else {
            (g0 / (below_e3 * below_e2), below_e2)
        };
        let rising = Complex::new(below_e2.sqrt().to_f64(), above_e1.sqrt().to_f64());
        let falls = udot < Extended::ZERO;
        self.chi = if self.regime == Regime::Aperiodic {
            let rising = rising.scaled(1.0 / rising.norm_squared().sqrt());
            HalfPhase::Aperiodic(if falls { rising.conj() } else { rising })
        } else {
            HalfPhase::Nutating(half_phase_of_direction(if falls { -rising.conj() } else { rising }))
        };
    }

    /// Sets the slow phases at an attitude, whose half phase is known.
    #[inline(never)] // stack
    pub(super) fn start_slow_phases(
        &mut self,
        AttitudeState { orientation: phi, rate }: &AttitudeState<f64>,
        pause: &mut dyn FnMut(),
    ) {
        if self.is_steady() {
            self.phases = [phi.alpha, phi.beta].map(|z| Phase::from_radians(z.arg()));
            return;
        }
        let equations: PhaseEquations<f64> = self.equations().cast();
        pause();
        let chi = self.chi.direction();
        let PhaseRates { nutation, slow_alpha, slow_beta } = equations.rates(chi.im, chi.re);
        let half_tau = self.half_tau.to_f64();
        let Ellipses { alpha: alpha_ellipse, beta: beta_ellipse } = &self.ellipses;
        self.phases = [
            slow_phase(alpha_ellipse, chi, [nutation, slow_alpha + half_tau], [phi.alpha, rate.alpha]),
            slow_phase(beta_ellipse, chi, [nutation, slow_beta - half_tau], [phi.beta, rate.beta]),
        ];
    }
}

/// Orientation of a state and its rate, computed in extended precision.
#[inline(never)]
pub(super) fn attitude(state: &State) -> AttitudeState<f64> {
    let (phi, omega) = state.in_extended();
    let AttitudeState { orientation, rate } = AttitudeState::from_fixed(phi.normalised(), omega);
    AttitudeState {
        orientation: orientation.cast(),
        rate: OrientationRate { alpha: rate.alpha.cast(), beta: rate.beta.cast() },
    }
}

/// Half phase χ in [0, 1/2] turn of a number along e^{iχ}, relatively exact near 0, 1/4 and 1/2 turn.
fn half_phase_of_direction(Complex { re: cosine, im: sine }: Complex<f64>) -> Phase {
    let from = |y: f64, x: f64| Phase::from_radians(libm::atan2(y, x));
    if cosine.abs() < sine {
        Phase::QUARTER - from(cosine, sine)
    } else if cosine > 0.0 {
        from(sine, cosine)
    } else {
        Phase::HALF - from(sine, -cosine)
    }
}

/// Half phase χ = θ/2.
pub(super) fn half_phase_of_angle(theta: f64) -> Phase {
    let nearest = libm::round(theta * core::f64::consts::FRAC_1_PI);
    let multiple = Extended::TWO_PI.halved() * nearest.into();
    if nearest != 0.0 && multiple.to_f64() == theta {
        return Phase::new(0.25 * nearest);
    }
    (Extended::from(theta).in_turns() * Extended::from(0.5)).to_phase()
}

/// Slow phase of a parameter: the least-squares rotation of the ellipse and its rate to z and z'.
fn slow_phase(ellipse: &Ellipse<f64>, chi: Complex<f64>, rates: [f64; 2], z: [Complex<f64>; 2]) -> Phase {
    let [value, rate] = z;
    let (model, model_rate) = (ellipse.at(chi), ellipse.rate(chi, rates));
    let [nutation, slow] = rates;
    let time = 1.0 / (nutation.squared() + slow.squared());
    let sum = value * model.conj() + (rate * model_rate.conj()).scaled(time);
    Phase::from_radians(sum.arg())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// `f64` nearest to k π, computed in integers: π to 100 fraction bits, and the leading 53 bits of the product.
    fn nearest_to_multiple(k: u32) -> f64 {
        const PI: u128 = 0x32_43f6_a888_5a30_8d31_3198_a2e0;
        let product = PI * u128::from(k);
        let dropped = product.ilog2() - 52;
        let remainder = product & ((1 << dropped) - 1);
        let half = 1 << (dropped - 1);
        // the product is smaller than k π, by less than k units
        assert!(remainder.abs_diff(half) > u128::from(k), "{k}");
        let mantissa = (product >> dropped) + u128::from(remainder > half);
        libm::ldexp(mantissa as f64, dropped as i32 - 100)
    }

    #[test]
    fn the_nearest_number_to_any_multiple_of_pi_is_that_multiple() {
        let most = if cfg!(miri) { 300 } else { 400_000 };
        for k in 1..=most {
            let theta = nearest_to_multiple(k);
            let turns = Phase::from_bits(i128::from(k) * (Phase::QUARTER.to_bits()));
            assert_eq!(
                [half_phase_of_angle(theta), half_phase_of_angle(-theta)],
                [turns, -turns],
                "{k}: {theta:e}"
            );
            // a neighbouring number is a different, close angle
            for near in [theta.next_up(), theta.next_down()] {
                let off = half_phase_of_angle(near) - turns;
                let unit = (near - theta).abs() * 0.25 * core::f64::consts::FRAC_1_PI;
                let relative = off.to_f64().abs() / unit;
                assert!((0.49..1.51).contains(&relative), "{k}: {relative}");
                assert!((half_phase_of_angle(-near) + half_phase_of_angle(near)).to_bits().abs() <= 1, "{k}");
            }
        }
        assert_eq!(half_phase_of_angle(0.0), Phase::ZERO);
    }
}
