//! Phase without whole turns, the type of a table's phases.

use super::Phase;
use crate::integer::{product_u32, wrapping_product};

/// Phase in [0, 1) turn: the 96 bits of the fraction of a [`Phase`].
///
/// ```text
/// 95            64 63            32 31             0
/// | words[2]      | words[1]       | words[0]       |
/// | leading bits                   |
/// ```
///
/// The rounding of a step causes 4e-17 rad after 2^40 ticks. With 64 bits it would be 1.9e-7 rad.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(crate) struct WrappedPhase {
    /// Words of 32 bits, the least significant first.
    words: [u32; 3],
}

impl WrappedPhase {
    const fn new(words: [u32; 3]) -> Self {
        Self { words }
    }

    pub(crate) const fn from_phase(phase: Phase) -> Self {
        let bits = phase.to_bits();
        Self::new([bits as u32, (bits >> 32) as u32, (bits >> 64) as u32])
    }

    /// Phase without whole turns from the words of a [`Phase`].
    #[inline(always)]
    pub(crate) const fn from_words([low, middle, upper, _]: [u32; 4]) -> Self {
        Self::new([low, middle, upper])
    }

    /// Phase in [0, 1) turn, exact.
    pub(crate) const fn to_phase(self) -> Phase {
        let [.., upper] = self.words;
        Phase::from_bits(((upper as i128) << 64) | self.lower() as i128)
    }

    /// Lower 64 bits.
    #[inline(always)]
    pub(crate) const fn lower(self) -> u64 {
        let [low, middle, _] = self.words;
        ((middle as u64) << 32) | low as u64
    }

    /// Sum, modulo one turn.
    #[inline(always)]
    pub(crate) const fn plus(self, other: Self) -> Self {
        Self::from_phase(Phase::from_bits(self.to_phase().to_bits() + other.to_phase().to_bits()))
    }

    pub(crate) fn minus(self, other: Self) -> Self {
        Self::from_phase(self.to_phase() - other.to_phase())
    }

    /// Product with n, modulo one turn.
    #[inline(always)]
    pub(crate) const fn times(self, n: u64) -> Self {
        let [low, ..] = self.words;
        let n_low = n as u32;
        let n_high = (n >> 32) as u32;
        let lowest = product_u32(low, n_low);
        let leading = wrapping_product(self.leading_bits(), n)
            .wrapping_add(product_u32(low, n_high))
            .wrapping_add(lowest >> 32);
        Self::new([lowest as u32, leading as u32, (leading >> 32) as u32])
    }

    /// Sum with a phase given by its 64 leading bits, modulo one turn.
    #[inline(always)]
    pub(crate) const fn plus_leading_bits(self, other: u64) -> Self {
        let [low, ..] = self.words;
        let sum = self.leading_bits().wrapping_add(other);
        Self::new([low, sum as u32, (sum >> 32) as u32])
    }

    #[inline(always)]
    pub(crate) const fn leading_bits(self) -> u64 {
        let [_, middle, upper] = self.words;
        ((upper as u64) << 32) | middle as u64
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn multiples_are_repeated_sums_and_wrap() {
        let step = WrappedPhase::new([0x89ab_cdef, 0x0123_4567, 0xdead_beef]);
        let start = 0x8000_0001_ffff_0000;
        let mut sum = WrappedPhase::new([0; 3]).plus_leading_bits(start);
        for n in 0..1000 {
            assert_eq!(step.times(n).plus_leading_bits(start), sum);
            assert_eq!(sum.plus(step).minus(step), sum);
            sum = sum.plus(step);
        }
        for n in [u64::MAX, 1 << 63, 1 << 40, 0x7fff_ffff_0000_0001] {
            // compare with 128-bit arithmetic
            let product = step.to_phase().to_bits().wrapping_mul(i128::from(n));
            assert_eq!(step.times(n), WrappedPhase::from_phase(Phase::from_bits(product)), "{n}");
        }
    }

    #[test]
    fn a_phase_is_wrapped_and_returned() {
        let phase = Phase::from_turns(3.7);
        assert_eq!(WrappedPhase::from_phase(phase).to_phase(), phase - Phase::from_turns(3.0));
        assert_eq!(WrappedPhase::from_phase(Phase::from_turns(-0.25)).leading_bits(), 3 << 62);
    }
}
