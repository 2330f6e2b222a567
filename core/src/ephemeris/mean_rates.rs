//! Mean rates of a motion: the constant rates of the phases of an ephemeris.

use crate::constants::Conditioning;
use crate::law::{Law, gudermannian};
use crate::mean_motion::MeanMotion;
use crate::motion::Motion;
use crate::scalar::{Extended, Float, Ring, exponent};

/// Rates of the nutation phase and of the mean slow phases, with the values needed to step through the half period.
#[derive(Clone, Copy, Debug)]
pub(crate) struct MeanRates {
    /// Half period T/2; for an aperiodic motion the time from its lowest point until 1 - u is below the square of the
    /// rounding; 0 where u is constant.
    pub(crate) half_period: Extended,
    /// Whether the nutation is periodic; false for an aperiodic motion, whose nutation phase stops at half a turn.
    pub(crate) is_periodic: bool,
    /// Constant rates of θ_A and θ_B besides ψ_A' and ψ_B': ±τ/2 minus the mean rate, rad per unit time.
    pub(crate) theta_offset: [Extended; 2],
    /// Nutation frequency 1/T, and the mean rates of α and β, in turns per unit time.
    pub(crate) turns: [Extended; 3],
    /// Errors of `turns`, turns per unit time.
    pub(crate) errors: [f64; 3],
    /// Rounding unit of the scalar that the rates are used with.
    pub(crate) rounding: f64,
}

/// Number of successive roundings in a rate, in the tick length and in their product, without those of the
/// quadrature's nodes.
const OPERATIONS: f64 = 64.0;
/// Relative error of an increment that is stored as the sum of two `f64`: half a unit in the last place of each.
const STORED: f64 = 1.0 / (1_u128 << 106) as f64;
/// Number of roundings per node of the quadrature: sine and cosine of the next node are computed from those of the
/// last by two products and a sum each, and the rounding error of the constant factor recurs at every node.
const OPERATIONS_PER_NODE: f64 = 2.0;

impl MeanRates {
    /// Placeholder for rates that are not computed yet.
    pub(crate) const ZERO: Self = Self {
        half_period: Extended::ZERO,
        is_periodic: true,
        theta_offset: [Extended::ZERO; 2],
        turns: [Extended::ZERO; 3],
        errors: [0.0; 3],
        rounding: 0.0,
    };

    /// Mean rates of a motion with this law, of which a steady motion makes no use; an aperiodic one is followed until 1 - u is below
    /// `rounding`².
    #[inline(never)]
    pub(crate) fn of(motion: &Motion, law: &Law<Extended>, rounding: f64) -> Self {
        if motion.is_steady() {
            return Self::steady(motion, rounding);
        }
        match motion.mean_motion() {
            Some(mean) => Self::periodic(motion, mean, rounding),
            None => Self::rising(motion, law, rounding),
        }
    }

    /// Greater of the angles by which the constant rates turn θ_A and θ_B in half a period, rad.
    pub(crate) fn greatest_turning(&self) -> f64 {
        let [alpha, beta] = self.theta_offset.map(|rate| Float::abs((rate * self.half_period).to_f64()));
        alpha.max(beta)
    }

    fn steady(motion: &Motion, rounding: f64) -> Self {
        let [alpha, beta] = motion.steady_rates().map(Extended::in_turns);
        let relative = OPERATIONS * Extended::ROUNDING + STORED + motion.conditioning().relative;
        // a rate is the sum of a quotient and ±τ/2, which may cancel
        let half_tau = Float::abs(motion.half_tau().in_turns().to_f64());
        let slow = Extended::from(motion.conditioning().turning).in_turns().to_f64();
        let error = |rate: Extended| (Float::abs(rate.to_f64()) + 2.0 * half_tau) * relative + slow;
        Self {
            half_period: Extended::ZERO,
            is_periodic: true,
            theta_offset: [Extended::ZERO; 2],
            turns: [Extended::ZERO, alpha, beta],
            errors: [0.0, error(alpha), error(beta)],
            rounding,
        }
    }

    fn periodic(motion: &Motion, mean: &MeanMotion, rounding: f64) -> Self {
        let MeanMotion { advance, winding, .. } = *mean;
        let half = Extended::from(0.5);
        let frequency = Extended::ONE / advance.period;
        // a bracket that passes through 0 changes sign once in a period, which is half a turn in either direction
        let whole = |turns: Extended, winding: i32| if winding == 0 { turns + half } else { turns };
        let [alpha_winding, beta_winding] = winding;
        let alpha = whole(advance.alpha_turns, alpha_winding) * frequency;
        let beta = whole(advance.beta_turns, beta_winding) * frequency;
        let half_tau = motion.half_tau();
        Self {
            half_period: advance.period.halved(),
            is_periodic: true,
            theta_offset: [half_tau - Extended::TWO_PI * alpha, -half_tau - Extended::TWO_PI * beta],
            turns: [frequency, alpha, beta],
            errors: errors(motion, mean),
            rounding,
        }
    }

    /// Mean rates of an aperiodic motion: the slow phases have the rates that they tend to at the vertical.
    fn rising(motion: &Motion, law: &Law<Extended>, rounding: f64) -> Self {
        // cos χ = sech v ≈ 2 e^{-v}
        let half_period = Extended::from(rise_time(&law.cast(), last_v(rounding), 256));
        // ψ_A' at u = 1, where D = A/p, in extended precision also where the law has less
        let momentum = motion.exact_integrals().l_plus_n;
        let at_the_top =
            momentum / (motion.quantities().a.doubled() * motion.exact_branch_points().one_plus_e3());
        let half_tau = motion.half_tau();
        let frequency = Extended::ONE / half_period.doubled();
        let Conditioning { relative, turning } = *motion.conditioning();
        let relative = OPERATIONS * Extended::ROUNDING + STORED + relative;
        let slow = Float::abs(at_the_top.to_f64()) + Float::abs(half_tau.to_f64());
        let error = Extended::from(slow * relative + turning).in_turns().to_f64();
        Self {
            half_period,
            is_periodic: false,
            theta_offset: [-at_the_top, Extended::ZERO],
            turns: [frequency, (at_the_top + half_tau).in_turns(), (-half_tau).in_turns()],
            // the frequency can be chosen freely, so only the increments contain its rounding error
            errors: [frequency.to_f64() * (OPERATIONS * Extended::ROUNDING + STORED), error, error],
            rounding,
        }
    }
}

/// Errors of 1/T and of the mean rates of α and β, turns per unit time: truncation of the trapezoid rule, rounding of
/// the arithmetic, and the effect of the state's rounding on the law.
#[inline(never)]
fn errors(motion: &Motion, mean: &MeanMotion) -> [f64; 3] {
    let Conditioning { relative, turning } = *motion.conditioning();
    let operations = OPERATIONS + OPERATIONS_PER_NODE * f64::from(mean.nodes);
    let arithmetic = operations * mean.operation_error + STORED + relative;
    let rule = mean.relative_error;
    let frequency = 1.0 / mean.advance.period.to_f64();
    let psi = mean.psi.map(|angle| Float::abs(angle.in_turns().to_f64()));
    let [psi_alpha, psi_beta] = psi;
    let half_tau = Float::abs(motion.half_tau().in_turns().to_f64());
    let slow = Extended::from(turning).in_turns().to_f64();
    let [alpha, beta] = psi.map(|own| {
        // the rate is (ψ(T) + half a turn)/T ± τ/2; the error of the trapezoid rule affects the first term only
        let advance = own + 0.5;
        let of_rule = (psi_alpha + psi_beta + advance) * rule;
        (of_rule + 2.0 * (psi_alpha + psi_beta + advance) * arithmetic) * frequency
            + 2.0 * half_tau * arithmetic
            + slow
    });
    [frequency * (rule + arithmetic), alpha, beta]
}

/// Variable v at which 1 - u is below `rounding`².
pub(crate) fn last_v(rounding: f64) -> f64 {
    // the rounding is a power of two
    f64::from(exponent(4.0 / rounding) - 1) * core::f64::consts::LN_2
}

/// Time from v = 0 to v by Simpson's rule with an even number of intervals.
pub(crate) fn rise_time(law: &Law<f64>, v: f64, intervals: u32) -> f64 {
    let step = v / f64::from(intervals);
    let sum = (0..=intervals).fold(0.0, |sum, i| {
        let weight = if i == 0 || i == intervals {
            1.0
        } else if i % 2 == 1 {
            4.0
        } else {
            2.0
        };
        let (tanh, sech) = gudermannian(f64::from(i) * step);
        sum + weight * law.time_per_amplitude(tanh, sech)
    });
    sum * step / 3.0
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Signs, Start, Top, TopParameters};

    /// A large error of the trapezoid rule: the errors of all three rates contain it.
    #[test]
    fn the_error_of_the_quadrature_is_in_every_rate() {
        let parameters = TopParameters {
            transverse_inertia: 1.0,
            axial_inertia: 0.7,
            com_height: 1.0,
            mass_moment: 1.0,
            ..TopParameters::default()
        };
        let top = Top::sliding(&parameters).unwrap();
        let motion =
            Motion::from_branch_points(&top, [-0.5, 0.5, 1.5], Signs::default(), &Start::default()).unwrap();
        let exact = *motion.mean_motion().unwrap();
        let rough = MeanMotion { relative_error: 1e-3, ..exact };
        let frequency = 1.0 / exact.advance.period.to_f64();
        let psi: f64 = exact.psi.iter().map(|angle| Float::abs(angle.in_turns().to_f64())).sum();
        for (rate, (small, large)) in
            errors(&motion, &exact).into_iter().zip(errors(&motion, &rough)).enumerate()
        {
            assert!(small < 1e-25, "{rate}: {small:e}");
            let least = if rate == 0 { frequency } else { frequency * psi };
            assert!((1e-3..1e-2).contains(&(large / least)), "{rate}: {large:e}");
        }
    }
}
