//! Mean rates of a motion, and their errors.

use crate::motion::period::Period;
use crate::motion::{LaunchRounding, Motion};
use crate::scalar::{Extended, Float, Ring};
use crate::table::time::Phases;

/// Relative error of the number of ticks in a unit of time, stored as the sum of two `f64`.
const STORED: f64 = 1.0 / (1_u128 << 106) as f64;

/// Rates of the nutation phase and of the mean phases, turns/s.
#[derive(Clone, Copy, Debug)]
pub(crate) struct MeanRates {
    pub(crate) rates: Phases<Extended>,
    pub(super) errors: Phases<f64>,
}

impl MeanRates {
    pub(super) const ZERO: Self =
        Self { rates: Phases::from_array([Extended::ZERO; 3]), errors: Phases::from_array([0.0; 3]) };

    /// Rates from the period, or without one those of a steady motion.
    #[inline(never)]
    pub(super) fn new(motion: &Motion, period: Option<&Period>) -> Self {
        period.map_or_else(|| Self::steady(motion), |period| Self::periodic(motion, period))
    }

    fn steady(motion: &Motion) -> Self {
        let [alpha, beta] = motion.steady_rates().map(Extended::radians_to_turns);
        let relative = Period::rounding_error::<Extended>(0) + STORED + motion.rounding.period_error;
        // a rate is the sum of a quotient and ±τ/2, which may cancel
        let half_tau = size_in_turns(motion.half_tau);
        let launch = size_in_turns(motion.rounding.slow_rate_error.into());
        let error = |rate: Extended| (rate.to_f64().abs() + 2.0 * half_tau) * relative + launch;
        let rates = Phases { nutation: Extended::ZERO, alpha, beta };
        Self { rates, errors: Phases { nutation: 0.0, alpha: error(alpha), beta: error(beta) } }
    }

    fn periodic(motion: &Motion, period: &Period) -> Self {
        let windings = motion.windings();
        let frequency = Extended::ONE / period.time;
        let mut rates = period.advances(motion.half_tau, windings);
        for (rate, winding) in rates.iter_mut().zip(windings) {
            // an ellipse through 0 changes sign once in a period: half a turn
            let advance = if winding == 0 { *rate + Extended::from(0.5) } else { *rate };
            *rate = advance * frequency;
        }
        let [alpha, beta] = rates;
        Self { rates: Phases { nutation: frequency, alpha, beta }, errors: errors(motion, period) }
    }
}

fn size_in_turns(angle: Extended) -> f64 {
    angle.radians_to_turns().to_f64().abs()
}

/// Errors of the rates, turns/s.
fn errors(motion: &Motion, period: &Period) -> Phases<f64> {
    let LaunchRounding { period_error, slow_rate_error } = motion.rounding;
    let arithmetic = period.rounding_error + STORED + period_error;
    let frequency = 1.0 / period.time.to_f64();
    let [alpha, beta] = period.psi.map(size_in_turns);
    let half_tau = 2.0 * size_in_turns(motion.half_tau) * arithmetic + size_in_turns(slow_rate_error.into());
    let error = |advance_turns: f64| {
        // the rate is (ψ(T) + half a turn)/T ± τ/2
        let advance = alpha + beta + advance_turns + 0.5;
        advance * 2.0 * arithmetic * frequency + half_tau
    };
    Phases { nutation: frequency * arithmetic, alpha: error(alpha), beta: error(beta) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::table::build::tests::nutating_motion;

    /// A large error of the period: the errors of all three rates contain it.
    #[test]
    fn the_error_of_the_period_is_in_every_rate() {
        let motion = nutating_motion();
        let exact = motion.period::<Extended>(&motion.equations(), &mut || {}).unwrap();
        let rough = Period { rounding_error: 1e-3, ..exact };
        let frequency = 1.0 / exact.time.to_f64();
        let psi: f64 = exact.psi.iter().map(|angle| Float::abs(angle.radians_to_turns().to_f64())).sum();
        for (rate, (small, large)) in errors(&motion, &exact)
            .zip_map(errors(&motion, &rough), |small, large| (small, large))
            .into_array()
            .into_iter()
            .enumerate()
        {
            assert!(small < 1e-25, "{rate}: {small:e}");
            let least = if rate == 0 { frequency } else { frequency * psi };
            assert!((1e-3..1e-2).contains(&(large / least)), "{rate}: {large:e}");
        }
    }
}
