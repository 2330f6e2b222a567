//! The mean rates of a motion: what an ephemeris counts with.

use super::averages::{Averages, Quadrature, averages};
use super::{Motion, Regime};
use crate::cayley_klein::Brackets;
use crate::nutation::{Nutation, gudermannian};
use crate::real::{DoubleDouble, Float, Ring};
use crate::turns::{in_turns, two_pi};

/// Nutation and mean slow rates, and what the march through half a period needs.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Rates {
    /// T/2; for an aperiodic motion the time from its lowest point to u = 1; 0 where u is constant.
    pub(crate) half_period: DoubleDouble,
    /// Whether the nutation comes back: not if aperiodic, whose nutation phase stops at half a turn.
    pub(crate) returns: bool,
    /// What the rates of the slow phases have besides ψ': drift less mean, rad per unit time.
    pub(crate) excess: [DoubleDouble; 2],
    /// 1/T, and the mean rates of α and β, in turns per unit time.
    pub(crate) turns: [DoubleDouble; 3],
    /// Relative error of `turns`.
    pub(crate) relative_error: f64,
    /// Of the scalar that they are for.
    pub(crate) rounding: f64,
}

/// A rounding of double-double arithmetic, with room for the thousands that make a rate and for a difference of two.
const ARITHMETIC: f64 = 1e-28;

impl Rates {
    /// Of a motion; for an aperiodic one up to where 1 - u is below `rounding`².
    #[inline(never)]
    pub(crate) fn of(motion: &Motion, rounding: f64) -> Self {
        if motion.is_steady() {
            let [alpha, beta] = motion.steady_rates().map(in_turns);
            let turns = [DoubleDouble::ZERO, alpha, beta];
            return Self {
                half_period: DoubleDouble::ZERO,
                returns: true,
                excess: [DoubleDouble::ZERO; 2],
                turns,
                relative_error: ARITHMETIC,
                rounding,
            };
        }
        if motion.regime() == Regime::Aperiodic {
            Self::rising(motion, rounding)
        } else {
            Self::periodic(motion, rounding)
        }
    }

    fn periodic(motion: &Motion, rounding: f64) -> Self {
        let (averages, winding, relative_error) = motion.exact_averages();
        let half = DoubleDouble::from(0.5);
        let frequency = DoubleDouble::ONE / averages.period;
        // a bracket that passes through 0 changes sign in a period: half a turn, in either sense
        let whole = |turns: DoubleDouble, winding: i32| if winding == 0 { turns + half } else { turns };
        let [alpha_winding, beta_winding] = winding;
        let alpha = whole(averages.alpha_turns, alpha_winding) * frequency;
        let beta = whole(averages.beta_turns, beta_winding) * frequency;
        let drift = motion.half_tau();
        Self {
            half_period: averages.period.halved(),
            returns: true,
            excess: [drift - two_pi() * alpha, -drift - two_pi() * beta],
            turns: [frequency, alpha, beta],
            relative_error: relative_error + ARITHMETIC,
            rounding,
        }
    }

    /// The slow phases are counted with the rates they tend to at the vertical.
    fn rising(motion: &Motion, rounding: f64) -> Self {
        let law = motion.law();
        // cos χ = sech v ≈ 2 e^{-v}
        let half_period = DoubleDouble::from(rise_time(&law.cast(), libm::log(4.0 / rounding)));
        let at_the_top = law.aperiodic_rates(DoubleDouble::ONE, DoubleDouble::ZERO);
        let drift = motion.half_tau();
        let frequency = DoubleDouble::ONE / half_period.doubled();
        Self {
            half_period,
            returns: false,
            excess: [-at_the_top.alpha, DoubleDouble::ZERO],
            turns: [frequency, in_turns(at_the_top.alpha + drift), in_turns(-drift)],
            relative_error: ARITHMETIC,
            rounding,
        }
    }
}

/// The time from v = 0 to v, by Simpson's rule; it only has to cover the rise.
pub(super) fn rise_time(law: &Nutation<f64>, v: f64) -> f64 {
    const INTERVALS: u32 = 1024;
    let step = v / f64::from(INTERVALS);
    let sum = (0..=INTERVALS).fold(0.0, |sum, i| {
        let weight = if i == 0 || i == INTERVALS {
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

impl Motion {
    /// The averages in double-double, the windings of the two brackets in them, and their relative error. Only for a
    /// motion that has a period.
    pub(super) fn exact_averages(&self) -> (Averages<DoubleDouble>, [i32; 2], f64) {
        let quadrature = Quadrature::over_period(&self.law(), self.exact_branch_points());
        // the half turn of each bracket, 0 where it passes through 0 (also for the parameter that is always 0)
        let swinging = Brackets::<f64>::swinging(self.exact_branch_points(), self.signs());
        let winding = [swinging.alpha.winding(), swinging.beta.winding()];
        let half = DoubleDouble::from(0.5);
        let turns = winding.map(|sense| half * f64::from(sense).into());
        (averages(&quadrature, self.half_tau(), turns), winding, quadrature.relative_error)
    }
}
