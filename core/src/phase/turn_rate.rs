//! Constant rates of rotation, and the phase they add up to over a time.

use super::{FRACTION_BITS, Phase, integer_parts, shifted};

/// Constant rate of rotation with 62 significant bits at any magnitude, so that the relative error of a phase that
/// grows at this rate does not grow with time.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(crate) struct TurnRate {
    /// Turns per unit time = mantissa · 2^exponent.
    mantissa: i64,
    exponent: i32,
}

impl TurnRate {
    /// Rate from turns per unit time, given as a sum of two `f64`, the leading part first.
    #[must_use]
    pub(crate) fn new(leading: f64, rest: f64) -> Self {
        let (mantissa, exponent) = integer_parts(leading);
        if mantissa == 0 {
            return Self::default();
        }
        // The mantissa of 53 bits is extended to 62; the nine new bits come from the second part.
        const EXTRA_BITS: i32 = 9;
        let (small, small_exponent) = integer_parts(rest);
        let exponent = exponent - EXTRA_BITS;
        let rest = shifted(small.into(), small_exponent - exponent) as i64;
        Self { mantissa: (mantissa << EXTRA_BITS).wrapping_add(rest), exponent }
    }

    /// Phase rate · dt, exact to 2^-96 turns and modulo 2^32 turns; the zero phase where dt is not finite.
    #[must_use]
    pub(crate) fn over(self, dt: f64) -> Phase {
        let (time, exponent) = integer_parts(dt);
        let product = i128::from(self.mantissa) * i128::from(time);
        Phase(shifted(product, self.exponent + exponent + FRACTION_BITS))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_rate_over_a_long_time_loses_nothing() {
        // At 1/3 turn per second, 3·2^30 s are 2^30 turns; the leading f64 alone would be off by 6e-8 turns.
        let third = TurnRate::new(1.0 / 3.0, 1.850371707708594e-17);
        let rest = third.over(3.0 * (1_u64 << 30) as f64) - Phase::new((1_u64 << 30) as f64);
        assert!(rest.to_f64().abs() < 6e-8 / 256.0, "{}", rest.to_f64());
        assert_eq!(third.over(-3.0).to_f64(), -third.over(3.0).to_f64());
        assert_eq!(third.over(f64::NAN), Phase::ZERO);
    }
}
