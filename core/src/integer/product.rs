//! Products wider than a chip's multiply instruction.
//!
//! A Cortex-M0+ multiplies to 32 bits only. There a product to 64 bits takes some 40 cycles as the compiler makes it, and 15 from halves of
//! 16 bits.

/// Whether products are made of 16-bit halves: on ARMv6-M, which lacks 32-bit atomics.
const BY_HALVES: bool = cfg!(all(target_arch = "arm", not(target_has_atomic = "32")));

/// Product a·b·2^-32 rounded down: one cycle of a Cortex-M4 with an addition (SMMLA).
#[inline(always)]
pub(crate) const fn high_product(a: i32, b: i32) -> i32 {
    if BY_HALVES {
        product_of_halves(split_halves(a), split_halves(b))
    } else {
        ((a as i64 * b as i64) >> 32) as i32
    }
}

/// Product a·b·2^-32 with only the 16 upper bits of b, rounded down (SMLAWT).
#[inline(always)]
pub(crate) const fn product_32x16(a: i32, b: i32) -> i32 {
    if BY_HALVES { product_32x16_by_halves(a, b) } else { ((a as i64 * (b >> 16) as i64) >> 16) as i32 }
}

/// Complete 64-bit product of two unsigned numbers.
#[inline(always)]
pub(crate) const fn product_u32(a: u32, b: u32) -> u64 {
    if BY_HALVES { product_u32_by_halves(a, b) } else { a as u64 * b as u64 }
}

/// Complete 64-bit product of two signed numbers.
#[inline(always)]
pub(crate) const fn product_i32(a: i32, b: i32) -> i64 {
    if BY_HALVES { product_i32_by_halves(a, b) } else { a as i64 * b as i64 }
}

/// Product modulo 2^64.
#[inline(always)]
pub(crate) const fn wrapping_product(a: u64, b: u64) -> u64 {
    let (a_low, a_high) = (a as u32, (a >> 32) as u32);
    let (b_low, b_high) = (b as u32, (b >> 32) as u32);
    let mixed = a_high.wrapping_mul(b_low).wrapping_add(a_low.wrapping_mul(b_high));
    product_u32(a_low, b_low).wrapping_add((mixed as u64) << 32)
}

/// Complete 128-bit product of two unsigned numbers: upper and lower half.
#[inline(always)]
pub(crate) fn product_u64(a: u64, b: u64) -> [u64; 2] {
    if cfg!(target_pointer_width = "64") {
        let product = u128::from(a) * u128::from(b);
        return [(product >> 64) as u64, product as u64];
    }
    product_by_words(a, b)
}

#[inline(always)]
fn product_by_words(a: u64, b: u64) -> [u64; 2] {
    let (a_low, a_high) = (a as u32, (a >> 32) as u32);
    let (b_low, b_high) = (b as u32, (b >> 32) as u32);
    let low = product_u32(a_low, b_low);
    let mixed = product_u32(a_high, b_low) + (low >> 32);
    let back = product_u32(a_low, b_high) + u64::from(mixed as u32);
    let high = product_u32(a_high, b_high) + (mixed >> 32) + (back >> 32);
    [high, (back << 32) | u64::from(low as u32)]
}

/// Signed lower half of a number, and its upper half rounded to the nearest, in -2^15..=2^15.
#[inline(always)]
const fn split_halves(number: i32) -> [i32; 2] {
    [number as i16 as i32, ((number >> 15) + 1) >> 1]
}

/// The lower halves are signed, so that the sum of mixed products does not overflow.
#[inline(always)]
const fn product_of_halves([a_low, a_high]: [i32; 2], [b_low, b_high]: [i32; 2]) -> i32 {
    let mixed = a_high.wrapping_mul(b_low).wrapping_add(a_low.wrapping_mul(b_high));
    let mixed = mixed.wrapping_add(a_low.wrapping_mul(b_low) >> 16);
    a_high.wrapping_mul(b_high).wrapping_add(mixed >> 16)
}

#[inline(always)]
const fn product_32x16_by_halves(a: i32, b: i32) -> i32 {
    let b_high = b >> 16;
    (a >> 16) * b_high + (((a & 0xffff) * b_high) >> 16)
}

/// With an unsigned half of b the compiler would call its own routine.
#[inline(always)]
const fn product_u32_by_halves(a: u32, b: u32) -> u64 {
    let a_low = a & 0xffff;
    let a_high = a >> 16;
    let b_low = b as i16 as i32;
    // at most 2^16
    let b_high = ((b >> 15) + 1) >> 1;
    let low = (a_low as i32).wrapping_mul(b_low);
    let mixed = (a_high as i32).wrapping_mul(b_low).wrapping_add(low >> 16);
    let back = a_low.wrapping_mul(b_high).wrapping_add(mixed as u32 & 0xffff);
    let high = a_high.wrapping_mul(b_high).wrapping_add((mixed >> 16) as u32).wrapping_add(back >> 16);
    ((high as u64) << 32) | a.wrapping_mul(b) as u64
}

/// Unsigned product, corrected for factors that are 2^32 larger.
#[inline(always)]
const fn product_i32_by_halves(a: i32, b: i32) -> i64 {
    let excess = (b & (a >> 31)).wrapping_add(a & (b >> 31));
    (product_u32_by_halves(a as u32, b as u32) as i64).wrapping_sub((excess as i64) << 32)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn halves_give_the_same_bits() {
        let mut bits = 0x9e37_79b9_7f4a_7c15_u64;
        let extremes = [i32::MIN, i32::MAX, -1, 0, 1, 0xffff, -0x1_0000, 0x7fff_0001];
        for k in 0..if cfg!(miri) { 3000 } else { 100_000 } {
            bits = crate::integer::next_random(bits);
            let pick = |random: i32, choice: usize| {
                if k % 3 == 0 { extremes[choice % extremes.len()] } else { random }
            };
            let (a, b) = (pick(bits as i32, k / 3), pick((bits >> 32) as i32, k / 24));
            let high = ((i64::from(a) * i64::from(b)) >> 32) as i32;
            assert_eq!(product_of_halves(split_halves(a), split_halves(b)), high, "{a} {b}");
            let short = ((i64::from(a) * i64::from(b & !0xffff)) >> 32) as i32;
            assert_eq!([product_32x16_by_halves(a, b), product_32x16(a, b)], [short; 2], "{a} {b}");
            assert_eq!(product_i32_by_halves(a, b), i64::from(a) * i64::from(b), "{a} {b}");
            let wide = (a as u64, !(b as u64));
            assert_eq!(wrapping_product(wide.0, wide.1), wide.0.wrapping_mul(wide.1), "{a} {b}");
            let [x, y] =
                [(a, b), (b, !a)].map(|(high, low)| u64::from(high as u32) << 32 | u64::from(low as u32));
            assert_eq!(product_by_words(x, y), product_u64(x, y), "{x} {y}");
            let (a, b) = (a as u32, b as u32);
            assert_eq!(product_u32_by_halves(a, b), u64::from(a) * u64::from(b), "{a} {b}");
        }
    }
}
