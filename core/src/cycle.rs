//! A share of a turn as an integer of 96 bits: what an ephemeris counts in.

use crate::real::{long_product, wrapping_product};
use crate::turns::Turns;

/// A fraction of a turn in 96 bits, the whole turns dropped.
///
/// Resolution 2^-96 turns: after 2^40 ticks an increment this fine is 4e-17 rad off (64 bits would be 1.9e-7). Three words on
/// a 32-bit chip: a sum is one addition and two with carry, a multiple five multiplications.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Cycle {
    /// Least significant first; words and not wider numbers, so that nine of them lie without gaps.
    words: [u32; 3],
}

impl Cycle {
    /// No turn.
    pub const ZERO: Self = Self::new([0; 3]);

    /// Half a turn, which counts as -1/2.
    pub const HALF: Self = Self::new([0, 0, 1 << 31]);
    /// The last phase before half a turn.
    pub const ALMOST_HALF: Self = Self::new([u32::MAX, u32::MAX, (1 << 31) - 1]);

    /// From its words, the least significant first.
    #[must_use]
    pub const fn new(words: [u32; 3]) -> Self {
        Self { words }
    }

    /// Its words, the least significant first.
    #[must_use]
    pub const fn words(self) -> [u32; 3] {
        self.words
    }

    /// The fraction of a phase, exactly.
    #[must_use]
    pub const fn of(phase: Turns) -> Self {
        let bits = phase.to_bits();
        Self::new([bits as u32, (bits >> 32) as u32, (bits >> 64) as u32])
    }

    /// The phase in [0, 1) turn, exactly.
    #[must_use]
    pub const fn to_turns(self) -> Turns {
        let [.., upper] = self.words;
        Turns::from_bits(((upper as i128) << 64) | self.lower() as i128)
    }

    /// The phase in [-1/2, 1/2) turn, exactly.
    pub(crate) const fn to_signed_turns(self) -> Turns {
        let [.., upper] = self.words;
        Turns::from_bits(((upper as i32 as i128) << 64) | self.lower() as i128)
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

    /// The two lower words.
    #[inline(always)]
    const fn lower(self) -> u64 {
        let [low, middle, _] = self.words;
        ((middle as u64) << 32) | low as u64
    }

    /// The sum, whole turns dropped.
    #[inline(always)]
    #[must_use]
    pub const fn plus(self, other: Self) -> Self {
        let ([.., upper], [.., other_upper]) = (self.words, other.words);
        let (lower, carry) = self.lower().overflowing_add(other.lower());
        let upper = upper.wrapping_add(other_upper).wrapping_add(carry as u32);
        Self::new([lower as u32, (lower >> 32) as u32, upper])
    }

    /// The difference, whole turns dropped.
    #[must_use]
    pub(crate) const fn minus(self, other: Self) -> Self {
        let ([.., upper], [.., other_upper]) = (self.words, other.words);
        let (lower, borrow) = self.lower().overflowing_sub(other.lower());
        let upper = upper.wrapping_sub(other_upper).wrapping_sub(borrow as u32);
        Self::new([lower as u32, (lower >> 32) as u32, upper])
    }

    /// n times, whole turns dropped.
    #[inline(always)]
    #[must_use]
    pub const fn times(self, n: u64) -> Self {
        let [low, ..] = self.words;
        let (n_low, n_high) = (n as u32, (n >> 32) as u32);
        let lowest = long_product(low, n_low);
        let leading = wrapping_product(self.leading(), n)
            .wrapping_add(long_product(low, n_high))
            .wrapping_add(lowest >> 32);
        Self::new([lowest as u32, leading as u32, (leading >> 32) as u32])
    }

    /// The sum with a phase of 64 bits, whole turns dropped: the lowest word has no carry.
    #[inline(always)]
    #[must_use]
    pub const fn plus_leading(self, other: u64) -> Self {
        let ([low, ..], sum) = (self.words, self.leading().wrapping_add(other));
        Self::new([low, sum as u32, (sum >> 32) as u32])
    }

    /// The 64 leading bits.
    #[inline(always)]
    #[must_use]
    pub const fn leading(self) -> u64 {
        let [_, middle, upper] = self.words;
        ((upper as u64) << 32) | middle as u64
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn multiples_are_repeated_sums_and_wrap() {
        let step = Cycle::new([0x89ab_cdef, 0x0123_4567, 0xdead_beef]);
        let start = 0x8000_0001_ffff_0000;
        let mut sum = Cycle::ZERO.plus_leading(start);
        for n in 0..1000 {
            assert_eq!(step.times(n).plus_leading(start), sum);
            assert_eq!(sum.plus(step).minus(step), sum);
            sum = sum.plus(step);
        }
        for n in [u64::MAX, 1 << 63, 1 << 40, 0x7fff_ffff_0000_0001] {
            // against 128-bit arithmetic
            let product = step.to_turns().to_bits().wrapping_mul(i128::from(n));
            assert_eq!(step.times(n), Cycle::of(Turns::from_bits(product)), "{n}");
        }
    }

    #[test]
    fn the_fraction_of_a_phase_and_back() {
        let phase = Turns::new(3.7);
        assert_eq!(Cycle::of(phase).to_turns(), phase - Turns::new(3.0));
        assert_eq!(Cycle::of(Turns::new(-0.25)).leading(), 3 << 62);
    }
}
