//! Instant: any time, counted in ticks.

use crate::integer::mantissa_and_exponent;
use crate::phase::{FRACTION_BITS, Phase};
use crate::scalar::Extended;

/// Instant in ticks.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Instant {
    /// Last tick at or before the instant.
    pub(crate) tick: i128,
    /// Fraction of the following tick that passes before the instant, a turn for a tick.
    pub(crate) fraction: Phase,
}

impl Instant {
    pub(crate) const ZERO: Self = Self::at_tick(0);

    #[inline(always)]
    pub(crate) const fn at_tick(n: i64) -> Self {
        Self { tick: n as i128, fraction: Phase::ZERO }
    }

    /// Instant at a time t for a number of ticks in a unit of time, the sum of two parts; tick 0 if t is not finite.
    #[inline(always)]
    pub(crate) fn at_time(t: f64, [rate, correction]: [f64; 2]) -> Self {
        let instant = Self::product(t, rate);
        if correction == 0.0 {
            return instant;
        }
        let Self { tick, fraction } = Self::product(t, correction);
        Self::new(instant.tick.wrapping_add(tick), instant.fraction + fraction)
    }

    /// Advance of a phase until the instant for its increment per tick, modulo 2^32 turns. Error below 2^-62 turns, and 0 at a tick.
    #[inline(always)]
    pub(crate) fn advance(self, increment: Phase) -> Phase {
        Phase::from_bits(increment.to_bits().wrapping_mul(self.tick))
            + increment.times_fraction(self.fraction)
    }

    /// Product of two numbers as an instant, rounded down to 2^-96 ticks.
    #[inline(always)]
    fn product(a: f64, b: f64) -> Self {
        let (a, a_exponent) = mantissa_and_exponent(a);
        let (b, b_exponent) = mantissa_and_exponent(b);
        let product = i128::from(a) * i128::from(b);
        let exponent = a_exponent + b_exponent;
        if exponent >= 0 {
            return Self { tick: product.checked_shl(exponent as u32).unwrap_or(0), fraction: Phase::ZERO };
        }
        let product = product >> (-127 - exponent).clamp(0, 127);
        let bits = (-exponent).min(127) as u32;
        let fraction = (product as u128) << (128 - bits) >> (128 - FRACTION_BITS);
        Self { tick: product >> bits, fraction: Phase::from_bits(fraction as i128) }
    }

    /// Instant from whole ticks and a fraction, of which whole ticks are carried.
    #[inline(always)]
    fn new(tick: i128, fraction: Phase) -> Self {
        let bits = fraction.to_bits();
        let carry = bits >> FRACTION_BITS;
        Self { tick: tick.wrapping_add(carry), fraction: Phase::from_bits(bits - (carry << FRACTION_BITS)) }
    }
}

/// Instant after a number of ticks, rounded to 2^-96 ticks.
impl From<Extended> for Instant {
    fn from(ticks: Extended) -> Self {
        let (tick, fraction) = ticks.floor_and_fraction();
        Self::new(tick, fraction.to_phase())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_time_becomes_whole_ticks_and_a_fraction() {
        let least = Phase::from_bits(1);
        for (t, rate, tick, fraction) in [
            (0.75, [1.0, 0.0], 0, Phase::QUARTER * 3),
            (-0.25, [9.0, 0.0], -3, Phase::from_turns(0.75)),
            // the two parts give whole ticks together
            (4.0, [2.25, 0.5], 11, Phase::ZERO),
            (3.0, [0.25, 0.25], 1, Phase::HALF),
            (-1e-300, [1000.0, 0.0], -1, Phase::TURN - least),
            (1e-300, [1000.0, 0.0], 0, Phase::ZERO),
            (2_f64.powi(90), [8.0, 0.0], 1 << 93, Phase::ZERO),
            (1e300, [8.0, 0.0], 0, Phase::ZERO),
            (f64::NAN, [1000.0, 0.0], 0, Phase::ZERO),
            (f64::INFINITY, [1000.0, 0.0], 0, Phase::ZERO),
        ] {
            let found = Instant::at_time(t, rate);
            assert_eq!((found.tick, found.fraction), (tick, fraction), "{t} {rate:?}");
        }
        let nearly = Extended::from_f64_pair([3.0, -1e-31]);
        let found = Instant::from(nearly);
        assert_eq!((found.tick, found.fraction), (3, Phase::ZERO), "rounded to a whole tick");
    }
}
