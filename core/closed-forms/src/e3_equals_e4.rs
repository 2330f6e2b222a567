//! Toy top with e₃ = e₄: elliptic functions instead of hyperelliptic ones (section 5.1 of the paper).
//!
//! With w² = 4 (u - e₁)(u - e₂)(u + e₃), whose half periods are ω₂ > 0 and ω₁ imaginary,
//!
//! ```text
//! u = ℘(x - ω₂) + (e₁ + e₂ - e₃)/3
//! t = i √(2s/g) [ζ(x - ω₂) + ζ(ω₂) - (e₁ + e₂ + 2e₃) x/3]
//! α = k₁ e^{ l₁x} σ(x - a)/σ(x - ω₂),   l₁ = w₋₁/(2(e₃ - 1)) + ζ(a - ω₂),   u(a) = -1
//! β = k₂ e^{-l₃x} σ(x + b)/σ(x + ω₂),   l₃ = w₊₁/(2(e₃ + 1)) + ζ(b - ω₂),   u(b) = 1
//! ```
//!
//! The values of w at u = -1 and at u = 1 are w₋₁ = √(2s/g) (e₃ - 1)(l + n)/A and w₊₁ = √(2s/g) (e₃ + 1)(l - n)/A,
//! where l and n are the first integrals. x increases along the imaginary axis, from u = e₂ at x = 0. The paper prints √R instead of 1/√R in a and b, ω₁
//! instead of ω₂ in the shift, and the opposite direction of x.

use crate::elliptic::elementary::{ValueAndSlope, imaginary, real};
use crate::elliptic::lattice::{Lattice, LatticeHalfPeriod};
use crate::inverse::solve_increasing;
use crate::orientation::{ArgumentOffsets, Periods};
use crate::theta_quotient::{ThetaQuotient, elliptic_integral, zeros};
use toytop::internal::ExtendedConstants;
use toytop::scalar::{Extended, Float, Ring};
use toytop::{AttitudeState, Complex, Motion, Phase, Support};

/// Nutating toy top with e₃ = e₄ as a function of time.
///
/// Error of an orientation: below 1e-15 rad at any time up to 1e9 periods where e₃ = e₄ exactly. Where they differ
/// within [`E3EqualsE4::TOLERANCE`], the solution belongs to a slightly different motion, and the error grows by up
/// to 5e-14 rad per period (measured for A/(ps) down to 2e-3; it grows for smaller A/(ps)). Cost: about 30 theta
/// functions in extended precision for set-up, and about 30 for one time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct E3EqualsE4 {
    solution: Solution,
    periods: Periods,
}

/// Solution for t, α and β as functions of x = iy.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Solution {
    /// Time √(2s/g).
    time_scale: Extended,
    /// Coefficient (e₁ + e₂ + 2e₃)/3.
    linear: Extended,
    alpha: ThetaQuotient,
    beta: ThetaQuotient,
}

impl E3EqualsE4 {
    /// Tolerance for the difference of e₃ and e₄, because √(1 + A/(ps)) is rarely an `f64`. It is relative to e₃ - 1
    /// and e₃ - e₂, which determine the motion, and not to e₄.
    pub const TOLERANCE: f64 = 4.0 * f64::EPSILON;

    /// Closed form of a motion; `None` unless the tip slides, e₁ < e₂, and e₃ = e₄ to [`E3EqualsE4::TOLERANCE`]: |e₃²
    /// - e₄²| relative to e₄² - 1, and |e₃ - e₄| relative to e₃ - e₂.
    #[must_use]
    pub fn new(motion: &Motion) -> Option<Self> {
        let ExtendedConstants { a, s, g, e, integrals, half_phase, .. } = motion.into();
        let chi = half_phase?;
        if motion.top().support() != Support::Sliding || !e3_is_e4(motion) {
            return None;
        }
        let e2_plus_e3 = e.one_plus_e3() - e.one_minus_e2;
        let e1_plus_e3 = e.one_plus_e1 + e.e3_minus_one;
        let lattice = Lattice::from_gaps(e.e2_minus_e1, e1_plus_e3);
        let [_, half] = lattice.half_periods;
        let time_scale = (s.doubled() / g).sqrt();

        let third = [e.e3_minus_one, e1_plus_e3, e2_plus_e3, e.one_plus_e3()];
        let [alpha_zero, beta_zero] = zeros(e, motion.signs(), third).map(|x| real(-x));
        // |k₁| follows from |α| at u = e₂ and |k₂| from |β| at u = e₁, which are never 0
        let highest = Complex::ZERO;
        let lowest = imaginary(-half);
        let [alpha_size, beta_size] = [e.one_plus_e2(), e.one_minus_e1()].map(|x| x.halved().sqrt());
        // w₋₁/(2(e₃ - 1)) = √(s/2g) (l + n)/A, and w₊₁ likewise
        let quotient = |half, zero, momentum: Extended, point| {
            let rate_offset = real((time_scale * momentum / a).halved());
            ThetaQuotient::through(&lattice, [half, LatticeHalfPeriod::Omega], zero, rate_offset, point)
        };
        let alpha =
            quotient(LatticeHalfPeriod::OmegaPrime, alpha_zero, integrals.l_plus_n, (highest, alpha_size));
        let beta = quotient(LatticeHalfPeriod::Origin, beta_zero, -integrals.l_minus_n, (lowest, beta_size));
        let whole = imaginary(half.doubled());
        let rotations = [alpha.rotation(highest, whole), beta.rotation(lowest, whole)];

        // y(0) within half a period of u = e₂, from cos²χ = sn²(√(e₂ + e₃) y)
        let (_, remainder) = chi.split_half_turns();
        let start = elliptic_integral(remainder - Phase::QUARTER, [e2_plus_e3, e.e2_minus_e1, e1_plus_e3]);

        let linear = (e.e1 + e.e2 + e.e3.doubled()) / 3.0.into();
        let solution = Solution { time_scale, linear, alpha, beta };
        let period = solution.time(half).0.doubled();
        let origin = solution.time(start).0;
        let arguments = ArgumentOffsets::new(motion, solution.parameters(start));
        Some(Self { solution, periods: Periods { period, rotations, origin, arguments } })
    }

    /// Nutation period, |t(2ω₁)|.
    #[must_use]
    pub fn period(&self) -> f64 {
        self.periods.period.to_f64()
    }

    /// Orientation Φ and rate Φ' at t.
    #[must_use]
    pub fn at(&self, t: f64) -> AttitudeState<f64> {
        let y = |time| self.solution.y_at(time, self.periods.period);
        self.periods.attitude_state(t, |time| self.solution.parameters(y(time)))
    }

    /// Nutation phase at t, whole periods included: 0 at u = e₁, half a turn at u = e₂.
    #[must_use]
    pub fn nutation_phase(&self, t: f64) -> Phase {
        // the time of the solution is 0 at u = e₂
        self.periods.phase(t) + Phase::HALF
    }
}

/// Difference e₃² - e₄², and e₄² - 1 = A/(ps).
fn squares(&ExtendedConstants { a, s, p, e, .. }: &ExtendedConstants<'_>) -> [Extended; 2] {
    let a_over_ps = a / (p * s);
    [e.e3_minus_one * e.one_plus_e3() - a_over_ps, a_over_ps]
}

/// Difference e₃ - e₄ for a sliding tip.
pub(super) fn e3_minus_e4(motion: &Motion) -> f64 {
    let constants = motion.into();
    let [apart, a_over_ps] = squares(&constants);
    (apart / (constants.e.e3 + (Extended::ONE + a_over_ps).sqrt())).to_f64()
}

/// Whether e₃ = e₄ to the tolerance.
fn e3_is_e4(motion: &Motion) -> bool {
    let constants = motion.into();
    let [apart, a_over_ps] = squares(&constants);
    let e = constants.e;
    let allowed = Extended::from(E3EqualsE4::TOLERANCE);
    apart.abs() <= a_over_ps * allowed && apart.abs() <= e.e3_minus_e2 * e.e3.doubled() * allowed
}

impl Solution {
    /// Time t and derivative dt/dy at x = iy.
    fn time(&self, y: Extended) -> (Extended, Extended) {
        let lattice = &self.alpha.lattice;
        let zeta = lattice.log_slope(LatticeHalfPeriod::Omega, imaginary(y)).im;
        let linear = lattice.sigma_exponent.doubled() - self.linear;
        let [shift, _] = lattice.half_periods;
        let [_, _, u_plus_e3] = lattice.differences(Complex::new(-shift, y));
        (-(self.time_scale * (zeta + linear * y)), self.time_scale * u_plus_e3.re)
    }

    /// Coordinate y at a time within half a period of u = e₂.
    fn y_at(&self, time: Extended, period: Extended) -> Extended {
        let [_, half] = self.alpha.lattice.half_periods;
        solve_increasing(time, [-half, half], half.doubled() * time / period, |y| self.time(y))
    }

    /// α and β at x = iy, and their time derivatives.
    fn parameters(&self, y: Extended) -> [ValueAndSlope; 2] {
        let (_, per_y) = self.time(y);
        let rate = imaginary(Extended::ONE / per_y);
        [self.alpha, self.beta].map(|parameter| parameter.at(imaginary(y)).by(rate))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use toytop::{Signs, Top, TopParameters};

    /// √(1 + A/(ps)) = 3/2 exactly, and with a difference of one unit in the last place.
    #[test]
    fn a_unit_in_the_last_place_is_accepted() {
        let top = Top::sliding(&TopParameters {
            transverse_inertia: 1.25,
            axial_inertia: 1.0,
            com_height: 1.0,
            mass_moment: 1.0,
            gravity: 1.0,
            ..TopParameters::default()
        })
        .unwrap();
        let form = |e3: f64| {
            let motion =
                Motion::from_branch_points(&top, [-0.2, 0.7, e3], Signs::default(), &Default::default());
            E3EqualsE4::new(&motion.unwrap())
        };
        assert!(form(1.5).is_some() && form(1.5 + f64::EPSILON).is_some());
        assert!(form(1.5 + 2.0 * f64::EPSILON).is_none() && form(1.6).is_none());
    }
}
