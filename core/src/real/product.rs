//! Products of integers wider than a word, which the smallest chips have no instruction for.
//!
//! A Cortex-M0+ multiplies 32 bits by 32 bits to the *lower* 32; the compiler's own routine for more costs some 40 cycles a
//! call. Written out in halves it is 17, to the same bits. (ARMv6-M is told from its larger sisters by what it lacks in
//! atomics: the compiler names no other difference.)

/// The upper 32 bits of the 64-bit product, rounded down: a·b·2^-32. On a Cortex-M4 one cycle, and with a sum too (SMMLA).
#[inline(always)]
pub(crate) const fn high_product(a: i32, b: i32) -> i32 {
    if cfg!(all(target_arch = "arm", not(target_has_atomic = "32"))) {
        high_product_by_halves(a, b)
    } else {
        ((a as i64 * b as i64) >> 32) as i32
    }
}

/// The whole product.
#[inline(always)]
pub(crate) const fn long_product(a: u32, b: u32) -> u64 {
    if cfg!(all(target_arch = "arm", not(target_has_atomic = "32"))) {
        long_product_by_halves(a, b)
    } else {
        a as u64 * b as u64
    }
}

/// The product modulo 2^64.
#[inline(always)]
pub(crate) const fn wrapping_product(a: u64, b: u64) -> u64 {
    let ((a_low, a_high), (b_low, b_high)) = ((a as u32, (a >> 32) as u32), (b as u32, (b >> 32) as u32));
    let across = a_high.wrapping_mul(b_low).wrapping_add(a_low.wrapping_mul(b_high));
    long_product(a_low, b_low).wrapping_add((across as u64) << 32)
}

#[inline(always)]
const fn high_product_by_halves(a: i32, b: i32) -> i32 {
    let ((a_low, a_high), (b_low, b_high)) = ((a & 0xffff, a >> 16), (b & 0xffff, b >> 16));
    let carry = (a_low as u32).wrapping_mul(b_low as u32) >> 16;
    // each sum below fits: |high| <= 2^15, low < 2^16
    let across = a_high * b_low + carry as i32;
    let back = a_low * b_high + (across & 0xffff);
    a_high * b_high + (across >> 16) + (back >> 16)
}

/// The lower half of b is taken with a sign: from the usual halves the compiler would infer a product of 64 bits, and call its
/// own routine after all.
#[inline(always)]
const fn long_product_by_halves(a: u32, b: u32) -> u64 {
    let (a_low, a_high) = (a & 0xffff, a >> 16);
    let b_low = b as i16 as i32;
    // up to 2^16
    let b_high = (b >> 16) + ((b >> 15) & 1);
    let low = (a_low as i32).wrapping_mul(b_low);
    let across = (a_high as i32).wrapping_mul(b_low).wrapping_add(low >> 16);
    let back = a_low.wrapping_mul(b_high).wrapping_add(across as u32 & 0xffff);
    let high = a_high.wrapping_mul(b_high).wrapping_add((across >> 16) as u32).wrapping_add(back >> 16);
    ((high as u64) << 32) | ((back << 16) | (low as u32 & 0xffff)) as u64
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn halves_give_the_same_bits() {
        let mut bits = 0x9e37_79b9_7f4a_7c15_u64;
        let extremes = [i32::MIN, i32::MAX, -1, 0, 1, 0xffff, -0x1_0000, 0x7fff_0001];
        for k in 0..100_000 {
            bits = bits.wrapping_mul(0x5851_f42d_4c95_7f2d).wrapping_add(0x1405_7b7e_f767_814f);
            let pick = |random: i32, choice: usize| {
                if k % 3 == 0 { extremes[choice % extremes.len()] } else { random }
            };
            let (a, b) = (pick(bits as i32, k / 3), pick((bits >> 32) as i32, k / 24));
            assert_eq!(high_product_by_halves(a, b), ((i64::from(a) * i64::from(b)) >> 32) as i32, "{a} {b}");
            let wide = (a as u64, !(b as u64));
            assert_eq!(wrapping_product(wide.0, wide.1), wide.0.wrapping_mul(wide.1), "{a} {b}");
            let (a, b) = (a as u32, b as u32);
            assert_eq!(long_product_by_halves(a, b), u64::from(a) * u64::from(b), "{a} {b}");
        }
    }
}
