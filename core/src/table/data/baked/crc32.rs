//! CRC-32 of ISO-HDLC (zlib, Ethernet): polynomial 0xEDB88320 reflected, initial value and final exclusive-or 0xFFFFFFFF.

/// Remainders of the 256 values of a byte.
#[allow(clippy::indexing_slicing)] // in a constant, an index out of range does not compile
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

/// CRC-32 of the numbers so far; the bytes of a number follow each other from the least significant.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Crc32(u32);

/// One function for each type of number, because a generic one cannot be `const`.
macro_rules! numbers {
    ($($number:ident),*) => {
        $(
            /// Checksum with these numbers after those so far.
            pub(crate) const fn $number(self, mut numbers: &[$number]) -> Self {
                let mut sum = self;
                while let [number, rest @ ..] = numbers {
                    sum = sum.bytes(&number.to_le_bytes());
                    numbers = rest;
                }
                sum
            }
        )*
    };
}

impl Crc32 {
    pub(crate) const EMPTY: Self = Self(u32::MAX);

    numbers!(u8, u16, u32, u64, i32, i64, f32, f64);
    #[cfg(feature = "fixed")]
    numbers!(i16);

    #[allow(clippy::indexing_slicing)] // a byte is below 256
    const fn bytes(self, mut bytes: &[u8]) -> Self {
        let Self(mut sum) = self;
        while let [byte, rest @ ..] = bytes {
            sum = sum >> 8 ^ REMAINDERS[(sum as u8 ^ *byte) as usize];
            bytes = rest;
        }
        Self(sum)
    }

    pub(crate) const fn value(self) -> u32 {
        !self.0
    }
}

#[cfg(test)]
mod tests {
    use super::Crc32;

    #[test]
    fn the_check_value_of_the_standard() {
        assert_eq!(Crc32::EMPTY.u8(b"123456789").value(), 0xcbf4_3926);
        assert_eq!(Crc32::EMPTY.value(), 0);
    }
}
