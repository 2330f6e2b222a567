//! CRC-32 of ISO-HDLC (zlib, Ethernet): polynomial 0xEDB88320 reflected, initial value and final exclusive-or 0xFFFFFFFF.

/// Remainders of the 256 values of a byte.
#[allow(clippy::indexing_slicing)] // evaluated by the compiler, which would refuse an index out of range
static REMAINDERS: [u32; 256] = {
    let mut table = [0; 256];
    let mut byte = 0;
    while byte < 256 {
        let mut remainder = byte as u32;
        let mut bit = 0;
        while bit < 8 {
            remainder = if remainder & 1 == 1 { remainder >> 1 ^ 0xedb8_8320 } else { remainder >> 1 };
            bit += 1;
        }
        table[byte] = remainder;
        byte += 1;
    }
    table
};

/// CRC-32 of the bytes so far; numbers are added as their bytes, the least significant first.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Crc32(u32);

impl Crc32 {
    pub(crate) const EMPTY: Self = Self(u32::MAX);

    /// Checksum of all bytes so far.
    pub(crate) const fn value(self) -> u32 {
        !self.0
    }

    #[allow(clippy::indexing_slicing)] // a byte is below 256
    pub(crate) const fn bytes(self, mut bytes: &[u8]) -> Self {
        let Self(mut sum) = self;
        while let [byte, rest @ ..] = bytes {
            sum = sum >> 8 ^ REMAINDERS[(sum as u8 ^ *byte) as usize];
            bytes = rest;
        }
        Self(sum)
    }

    pub(crate) const fn u8(self, number: u8) -> Self {
        self.bytes(&[number])
    }

    pub(crate) const fn u16(self, number: u16) -> Self {
        self.bytes(&number.to_le_bytes())
    }

    #[cfg(feature = "fixed")]
    pub(crate) const fn i16(self, number: i16) -> Self {
        self.bytes(&number.to_le_bytes())
    }

    pub(crate) const fn u32(self, number: u32) -> Self {
        self.bytes(&number.to_le_bytes())
    }

    pub(crate) const fn i32(self, number: i32) -> Self {
        self.bytes(&number.to_le_bytes())
    }

    pub(crate) const fn u64(self, number: u64) -> Self {
        self.bytes(&number.to_le_bytes())
    }

    pub(crate) const fn f32(self, number: f32) -> Self {
        self.u32(number.to_bits())
    }

    pub(crate) const fn f64(self, number: f64) -> Self {
        self.u64(number.to_bits())
    }

    pub(crate) const fn words(self, mut words: &[u32]) -> Self {
        let mut sum = self;
        while let [word, rest @ ..] = words {
            sum = sum.u32(*word);
            words = rest;
        }
        sum
    }

    pub(crate) const fn pair(self, [hi, lo]: [f64; 2]) -> Self {
        self.f64(hi).f64(lo)
    }
}

#[cfg(test)]
mod tests {
    use super::Crc32;

    #[test]
    fn the_check_value_of_the_standard() {
        assert_eq!(Crc32::EMPTY.bytes(b"123456789").value(), 0xcbf4_3926);
        assert_eq!(Crc32::EMPTY.value(), 0);
    }
}
