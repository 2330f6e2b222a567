//! A share of a turn as an integer of 96 bits: what an ephemeris counts in.

use crate::turns::Turns;

/// A fraction of a turn, the whole turns dropped: `upper`·2^-32 + `lower`·2^-96.
///
/// Resolution 2^-96 turns: after 2^40 ticks an increment this fine is 4e-17 rad off (64 bits would be 1.9e-7). Three words on
/// a 32-bit chip: a sum is one addition and two with carry, a multiple five multiplications.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Cycle {
    upper: u32,
    lower: u64,
}

impl Cycle {
    /// No turn.
    pub const ZERO: Self = Self::new(0, 0);

    /// Half a turn, which counts as -1/2.
    pub const HALF: Self = Self::new(1 << 31, 0);
    /// The last phase before half a turn.
    pub const ALMOST_HALF: Self = Self::new((1 << 31) - 1, u64::MAX);

    /// From its words.
    #[must_use]
    pub const fn new(upper: u32, lower: u64) -> Self {
        Self { upper, lower }
    }

    /// Its words.
    #[must_use]
    pub const fn words(self) -> (u32, u64) {
        (self.upper, self.lower)
    }

    /// The fraction of a phase, exactly.
    #[must_use]
    pub const fn of(phase: Turns) -> Self {
        let bits = phase.to_bits();
        Self { upper: (bits >> 64) as u32, lower: bits as u64 }
    }

    /// The phase in [0, 1) turn, exactly.
    #[must_use]
    pub const fn to_turns(self) -> Turns {
        Turns::from_bits(((self.upper as i128) << 64) | self.lower as i128)
    }

    /// The phase in [-1/2, 1/2) turn, exactly.
    pub(crate) const fn to_signed_turns(self) -> Turns {
        Turns::from_bits(((self.upper as i32 as i128) << 64) | self.lower as i128)
    }

    /// The fraction of a phase that does not wrap: what is beyond half a turn stays there.
    pub(crate) fn clamping(phase: Turns) -> Self {
        if phase < -Turns::HALF {
            Self::HALF
        } else if phase >= Turns::HALF {
            Self::ALMOST_HALF
        } else {
            Self::of(phase)
        }
    }

    /// The sum, whole turns dropped.
    #[inline(always)]
    #[must_use]
    pub const fn plus(self, other: Self) -> Self {
        let (lower, carry) = self.lower.overflowing_add(other.lower);
        let upper = self.upper.wrapping_add(other.upper).wrapping_add(carry as u32);
        Self { upper, lower }
    }

    /// n times, whole turns dropped.
    #[inline(always)]
    #[must_use]
    pub const fn times(self, n: i64) -> Self {
        // modulo 2^96 a negative n counts as 2^96 + n: its third word is all ones, which subtracts the lowest word
        let n_bits = n as u64;
        let (a0, a1, a2) = (self.lower as u32, (self.lower >> 32) as u32, self.upper);
        let (n0, n1) = (n_bits as u32, (n_bits >> 32) as u32);
        let low = a0 as u64 * n0 as u64;
        let middle = (low >> 32) + ((a0 as u64 * n1 as u64) & 0xffff_ffff);
        let other = a1 as u64 * n0 as u64;
        let middle = middle + (other & 0xffff_ffff);
        let high = ((a0 as u64 * n1 as u64) >> 32) as u32;
        let high = high.wrapping_add((other >> 32) as u32).wrapping_add((middle >> 32) as u32);
        let high = high.wrapping_add(a1.wrapping_mul(n1)).wrapping_add(a2.wrapping_mul(n0));
        let high = if n < 0 { high.wrapping_sub(a0) } else { high };
        Self { upper: high, lower: (middle << 32) | (low & 0xffff_ffff) }
    }

    /// The 64 leading bits.
    #[inline(always)]
    #[must_use]
    pub const fn leading(self) -> u64 {
        ((self.upper as u64) << 32) | (self.lower >> 32)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn multiples_are_repeated_sums_and_wrap() {
        let step = Cycle::new(0xdead_beef, 0x0123_4567_89ab_cdef);
        let mut sum = Cycle::ZERO;
        for n in 0..1000 {
            assert_eq!(step.times(n), sum);
            assert_eq!(step.times(-n).plus(sum), Cycle::ZERO);
            sum = sum.plus(step);
        }
        for n in [i64::MAX, i64::MIN, -1, 1 << 40, 0x7fff_ffff_0000_0001] {
            // against 128-bit arithmetic
            let bits = (i128::from(step.upper) << 64) | i128::from(step.lower);
            let product = bits.wrapping_mul(i128::from(n));
            assert_eq!(step.times(n), Cycle::new((product >> 64) as u32, product as u64), "{n}");
        }
    }

    #[test]
    fn the_fraction_of_a_phase_and_back() {
        let phase = Turns::new(3.7);
        assert_eq!(Cycle::of(phase).to_turns(), phase - Turns::new(3.0));
        assert_eq!(Cycle::of(Turns::new(-0.25)).leading(), 3 << 62);
    }
}
