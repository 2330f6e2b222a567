//! Lagrange top, whose tip is held at a fixed point: Klein's elliptic solution (section 5.4 of the paper; s = 0).
//!
//! With z = √(pg/2A) t and w² = 4 (u - e₁)(u - e₂)(u - e₃), whose half periods are ω > 0 and ω' imaginary,
//!
//! ```text
//! u = ℘(z + ω') + (e₁ + e₂ + e₃)/3 = e₁ + (e₂ - e₁) sn²(√(e₃ - e₁) z)
//! α = k e^{ζ(a + ω') z} σ(z - a)/σ(z + ω'),   u(a) = -1,   ℘'(a + ω') =  i (l + n) √(2/(A p g))
//! β = k e^{ζ(b + ω') z} σ(z - b)/σ(z + ω'),   u(b) =  1,   ℘'(b + ω') = -i (l - n) √(2/(A p g))
//! ```
//!
//! z increases along the real axis, from u = e₁ at z = 0.

use crate::elliptic::elementary::{ValueAndSlope, imaginary, real};
use crate::elliptic::lattice::{Lattice, LatticeHalfPeriod};
use crate::orientation::{ArgumentOffsets, Periods};
use crate::theta_quotient::{ThetaQuotient, elliptic_integral, zeros};
use toytop::internal::ExtendedConstants;
use toytop::scalar::{Extended, Float, Ring};
use toytop::{AttitudeState, Complex, Motion, Phase, Regime, Support};

/// Nutating Lagrange top as a function of time.
///
/// Error of an orientation: below 1e-15 rad at any time up to 1e9 periods, also where several differences of the
/// branch points are as small as 1e-12. Cost: about 20 theta functions in extended precision for set-up, and four for one
/// time, without iteration.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lagrange {
    solution: Solution,
    periods: Periods,
}

/// Solution for α and β within a period.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Solution {
    /// Rate of z per unit of time.
    z_rate: Extended,
    alpha: ThetaQuotient,
    beta: ThetaQuotient,
}

impl Lagrange {
    /// Closed form of a motion; `None` unless the tip is fixed and u oscillates, e₁ < e₂ < e₃.
    #[must_use]
    pub fn new(motion: &Motion) -> Option<Self> {
        let ExtendedConstants { a, p, g, e, half_phase, .. } = motion.into();
        let chi = half_phase?;
        if motion.top().support() != Support::Fixed
            || motion.top().is_torque_free()
            || motion.regime() == Regime::Aperiodic
        {
            return None;
        }
        let swing = e.e2_minus_e1;
        let gap = e.e3_minus_e2;
        let lattice = Lattice::from_gaps(gap, swing);
        let [half, _] = lattice.half_periods;
        let z_rate = (p * g / a).halved().sqrt();

        // along imaginary z
        let third = [e.one_plus_e3(), e.e3_minus_e1(), gap, e.e3_minus_one];
        let [alpha_zero, beta_zero] = zeros(e, motion.signs(), third).map(imaginary);
        // |k| from |α| at u = e₂ and from |β| at u = e₁, which are never 0
        let highest = real(half);
        let lowest = Complex::ZERO;
        let [alpha_size, beta_size] = [e.one_plus_e2(), e.one_minus_e1()].map(|x| x.halved().sqrt());
        let quotient = |half, zero, point| {
            ThetaQuotient::through(
                &lattice,
                [half, LatticeHalfPeriod::OmegaPrime],
                zero,
                Complex::ZERO,
                point,
            )
        };
        let alpha = quotient(LatticeHalfPeriod::Origin, alpha_zero, (highest, alpha_size));
        let beta = quotient(LatticeHalfPeriod::Omega, beta_zero, (lowest, beta_size));
        let whole = real(half.doubled());
        let rotations = [alpha.rotation(-highest, whole), beta.rotation(lowest, whole)];

        let solution = Solution { z_rate, alpha, beta };
        // z(0) within half a period of u = e₁
        let (_, remainder) = chi.split_half_turns();
        let angle = if remainder > Phase::QUARTER { remainder - Phase::HALF } else { remainder };
        let origin = elliptic_integral(angle, [e.e3_minus_e1(), swing, gap]) / z_rate;
        let period = half.doubled() / z_rate;
        let arguments = ArgumentOffsets::new(motion, solution.parameters(origin));
        Some(Self { solution, periods: Periods { period, rotations, origin, arguments } })
    }

    /// Nutation period, 2ω √(2A/(pg)).
    #[must_use]
    pub fn period(&self) -> f64 {
        self.periods.period.to_f64()
    }

    /// Orientation Φ and rate Φ' at t.
    #[must_use]
    pub fn at(&self, t: f64) -> AttitudeState<f64> {
        self.periods.attitude_state(t, |time| self.solution.parameters(time))
    }

    /// Nutation phase at t, whole periods included: 0 at u = e₁, half a turn at u = e₂.
    #[must_use]
    pub fn nutation_phase(&self, t: f64) -> Phase {
        self.periods.phase(t)
    }
}

impl Solution {
    /// α and β, and their time derivatives, at this time since u = e₁.
    fn parameters(&self, time: Extended) -> [ValueAndSlope; 2] {
        let z = real(self.z_rate * time);
        [self.alpha, self.beta].map(|parameter| parameter.at(z).by(real(self.z_rate)))
    }
}
