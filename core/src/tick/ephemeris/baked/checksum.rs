//! A checksum that the compiler computes in a fraction of a second for the largest table, and a chip in four operations
//! a word.

/// A checksum of words of 32 bits, in order.
///
/// A step is one-to-one in the word and in the sum so far: a change of one word is always seen, any other in all but one
/// case of 2^32.
#[derive(Clone, Copy, Debug)]
pub(super) struct Checksum(u32);

impl Checksum {
    /// Of nothing.
    pub(super) const EMPTY: Self = Self(0);

    pub(super) const fn word(self, word: u32) -> Self {
        // odd; the golden ratio of 2^32, which spreads a bit upwards, as the shift does downwards
        let sum = (self.0 ^ word).wrapping_mul(0x9e37_79b1);
        Self(sum ^ (sum >> 15))
    }

    /// Two words, the least significant first.
    pub(super) const fn wide(self, words: u64) -> Self {
        self.word(words as u32).word((words >> 32) as u32)
    }

    pub(super) const fn words(self, [low, middle, upper]: &[u32; 3]) -> Self {
        self.word(*low).word(*middle).word(*upper)
    }

    pub(super) const fn signed(self, number: i32) -> Self {
        self.word(number as u32)
    }

    #[cfg(feature = "fixed")]
    pub(super) const fn short(self, number: i16) -> Self {
        self.signed(number as i32)
    }

    pub(super) const fn single(self, number: f32) -> Self {
        self.word(number.to_bits())
    }

    pub(super) const fn double(self, number: f64) -> Self {
        self.wide(number.to_bits())
    }

    pub(super) const fn pair(self, [hi, lo]: [f64; 2]) -> Self {
        self.double(hi).double(lo)
    }

    pub(super) const fn value(self) -> u32 {
        self.0
    }
}
