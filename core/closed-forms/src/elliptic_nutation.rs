//! Nutation in elliptic functions: the Lagrange top, whose tip is held (Klein's solution; section 5.4 of the paper), and the toy top
//! with e₃ = e₄, whose functions are elliptic instead of hyperelliptic ones (section 5.1).
//!
//! z runs along the real axis, and increases by 2ω in a period. v oscillates between the two lower roots of w²/4, and is the lowest root
//! at z = 0:
//!
//! ```text
//! v = ℘(z + ω') + mean of the three roots
//! α = k₁ e^{(ζ(a + ω') + iκ₁) z} σ(z - a)/σ(z + ω'),   u(a) = -1
//! β = k₂ e^{(ζ(b + ω') - iκ₂) z} σ(z - b)/σ(z + ω'),   u(b) = 1
//!
//!           Lagrange top        toy top
//! v         u                   -u
//! roots     e₃ > e₂ > e₁        e₃ > -e₁ > -e₂
//! t         √(2A/(pg)) z        √(2s/g) [ζ(z + ω') - ζ(ω') + (e₁ + e₂ + 2e₃) z/3]
//! κ₁        0                   √(s/2g) (l + n)/A
//! κ₂        0                   √(s/2g) (l - n)/A
//! ```
//!
//! The imaginary parts of a and b have the signs of l + n and l - n. For the toy top the paper has x = iz, with the half periods ω₁ = iω
//! and ω₂ = -iω'. It prints √R instead of 1/√R in a and b, ω₁ instead of ω₂ in the shift, and the opposite direction of x.

use crate::elliptic::elementary::{ValueAndSlope, imaginary, real};
use crate::elliptic::lattice::{Lattice, LatticeHalfPeriod};
use crate::inverse::solve_increasing;
use crate::orientation::{ArgumentOffsets, Periods};
use crate::theta_quotient::{ThetaQuotient, elliptic_integral, zeros};
use toytop::internal::ExtendedConstants;
use toytop::scalar::{Extended, Float, Ring};
use toytop::{AttitudeState, Complex, Motion, Phase, Regime, Support};

/// Nutating Lagrange top, or nutating toy top with e₃ = e₄, as a function of time.
///
/// Error of an orientation: below 1e-15 rad at any time up to 1e9 periods, for a Lagrange top also where several differences of the
/// branch points are as small as 1e-12. Where e₃ and e₄ of a toy top differ within [`EllipticNutation::TOLERANCE`], the solution belongs
/// to a slightly different motion, and the error grows by up to 5e-14 rad per period (measured for A/(ps) down to 2e-3; it grows for
/// smaller A/(ps)).
///
/// Cost: about 30 theta functions in extended precision for set-up; for one time four for a Lagrange top, and about 30 for a toy top.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EllipticNutation {
    solution: Solution,
    periods: Periods,
    /// Nutation phase at z = 0.
    phase_at_zero: Phase,
}

/// Solution for t, α and β as functions of z.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Solution {
    /// Time √(2A/(pg)) of a Lagrange top, √(2s/g) of a toy top.
    time_scale: Extended,
    /// Coefficient (e₁ + e₂ + 2e₃)/3 of a toy top; `None` for a Lagrange top.
    linear: Option<Extended>,
    alpha: ThetaQuotient,
    beta: ThetaQuotient,
}

impl EllipticNutation {
    /// Tolerance for the difference of e₃ and e₄, because √(1 + A/(ps)) is rarely an `f64`. It is relative to e₄² - 1
    /// and e₃ - e₂, which determine the motion.
    pub const TOLERANCE: f64 = 4.0 * f64::EPSILON;

    /// Closed form of a motion; `None` unless u oscillates, e₁ < e₂ < e₃, and the tip is held, or slides and e₃ = e₄ to
    /// [`EllipticNutation::TOLERANCE`]: |e₃² - e₄²| relative to e₄² - 1, and |e₃ - e₄| relative to e₃ - e₂.
    #[must_use]
    pub fn new(motion: &Motion) -> Option<Self> {
        let ExtendedConstants { a, s, p, g, e, integrals, half_phase, .. } = motion.into();
        let chi = half_phase?;
        let slides = match motion.top().support() {
            Support::Sliding if e3_is_e4(motion) => true,
            Support::Fixed if !motion.top().is_torque_free() && motion.regime() != Regime::Aperiodic => false,
            _ => return None,
        };
        // third factor of w²/4 beside u - e₁ and u - e₂, at u = -1, e₁, e₂ and 1
        let (e1_plus_e3, e2_plus_e3) = (e.one_plus_e1 + e.e3_minus_one, e.one_plus_e3() - e.one_minus_e2);
        let third @ [_, at_e1, at_e2, _] = if slides {
            [e.e3_minus_one, e1_plus_e3, e2_plus_e3, e.one_plus_e3()]
        } else {
            [e.one_plus_e3(), e.e3_minus_e1(), e.e3_minus_e2, e.e3_minus_one]
        };
        // differences of the roots: the highest minus the lowest, the middle minus the lowest, the highest minus the middle
        let swing = e.e2_minus_e1;
        let differences @ [_, _, gap] = if slides { [at_e2, swing, at_e1] } else { [at_e1, swing, at_e2] };
        let lattice = Lattice::from_gaps(gap, swing);
        let [omega, _] = lattice.half_periods;
        let time_scale = (if slides { s / g } else { a / (p * g) }).doubled().sqrt();
        let kappa = |momentum| if slides { (time_scale * momentum / a).halved() } else { Extended::ZERO };

        // the real part of a or b, and the z at the other end of the oscillation of v, where |α| or |β| gives |k₁| or |k₂|
        let below = (LatticeHalfPeriod::Origin, real(omega));
        let above = (LatticeHalfPeriod::Omega, Complex::ZERO);
        let [of_alpha, of_beta] = if slides { [above, below] } else { [below, above] };
        let [a_distance, b_distance] = zeros(e, motion.signs(), third).map(imaginary);
        let [alpha_size, beta_size] = [e.one_plus_e2(), e.one_minus_e1()].map(|x| x.halved().sqrt());
        let quotient = |(real_part, z), zero, rate, size| {
            let half_periods = [real_part, LatticeHalfPeriod::OmegaPrime];
            let quotient = ThetaQuotient::through(&lattice, half_periods, zero, imaginary(rate), (z, size));
            (quotient, quotient.rotation(-z, real(omega.doubled())))
        };
        let (alpha, alpha_rotation) = quotient(of_alpha, a_distance, kappa(integrals.l_plus_n), alpha_size);
        let (beta, beta_rotation) = quotient(of_beta, b_distance, -kappa(integrals.l_minus_n), beta_size);
        let linear = slides.then(|| (e.e1 + e.e2 + e.e3.doubled()) / 3.0.into());
        let solution = Solution { time_scale, linear, alpha, beta };

        // z at t = 0, within half a period of 0
        let (_, remainder) = chi.split_half_turns();
        let from_zero = match slides {
            true => remainder - Phase::QUARTER,
            false if remainder > Phase::QUARTER => remainder - Phase::HALF,
            false => remainder,
        };
        let start = elliptic_integral(from_zero, differences);
        let periods = Periods {
            period: solution.time(omega).0.doubled(),
            rotations: [alpha_rotation, beta_rotation],
            origin: solution.time(start).0,
            arguments: ArgumentOffsets::new(motion, solution.parameters(start)),
        };
        let phase_at_zero = if slides { Phase::HALF } else { Phase::ZERO };
        Some(Self { solution, periods, phase_at_zero })
    }

    /// Nutation period: 2ω √(2A/(pg)) of a Lagrange top, t at z = 2ω of a toy top.
    #[must_use]
    pub fn period(&self) -> f64 {
        self.periods.period.to_f64()
    }

    /// Orientation Φ and rate Φ' at t.
    #[must_use]
    pub fn at(&self, t: f64) -> AttitudeState<f64> {
        let z = |time| self.solution.z_at(time, self.periods.period);
        self.periods.attitude_state(t, |time| self.solution.parameters(z(time)))
    }

    /// Nutation phase at t, whole periods included: 0 at u = e₁, half a turn at u = e₂.
    #[must_use]
    pub fn nutation_phase(&self, t: f64) -> Phase {
        self.periods.phase(t) + self.phase_at_zero
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
    let allowed = Extended::from(EllipticNutation::TOLERANCE);
    apart.abs() <= a_over_ps * allowed && apart.abs() <= e.e3_minus_e2 * e.e3.doubled() * allowed
}

impl Solution {
    /// Time t and derivative dt/dz.
    fn time(&self, z: Extended) -> (Extended, Extended) {
        let Some(linear) = self.linear else { return (self.time_scale * z, self.time_scale) };
        let lattice = &self.alpha.lattice;
        let [_, omega_prime] = lattice.half_periods;
        // ζ(z + ω') - ζ(ω') = 2cz + ϑ'(z)/ϑ(z), with the coefficient c in the exponent of σ
        let zeta = lattice.sigma_exponent.doubled() * z
            + lattice.log_slope(LatticeHalfPeriod::OmegaPrime, real(z)).re;
        let [v_minus_e3, _, _] = lattice.differences(Complex::new(z, omega_prime));
        (self.time_scale * (zeta + linear * z), -(self.time_scale * v_minus_e3.re))
    }

    /// Number z at a time within half a period of z = 0.
    fn z_at(&self, time: Extended, period: Extended) -> Extended {
        let [omega, _] = self.alpha.lattice.half_periods;
        solve_increasing(time, [-omega, omega], omega.doubled() * time / period, |z| self.time(z))
    }

    /// α and β, and their time derivatives, at z.
    fn parameters(&self, z: Extended) -> [ValueAndSlope; 2] {
        let (_, dt_dz) = self.time(z);
        let rate = real(Extended::ONE / dt_dz);
        [self.alpha, self.beta].map(|parameter| parameter.at(real(z)).by(rate))
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
            EllipticNutation::new(&motion.unwrap())
        };
        assert!(form(1.5).is_some() && form(1.5 + f64::EPSILON).is_some());
        assert!(form(1.5 + 2.0 * f64::EPSILON).is_none() && form(1.6).is_none());
    }
}
