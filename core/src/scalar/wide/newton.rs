//! First approximations of reciprocals and inverse roots, by Newton's method in integers.

use crate::product::{long_product, product_of_long};

/// Reciprocal 2^126/d of a divisor in [2^63, 2^64), with 60 correct bits, by Newton's method from a division of 32-bit numbers.
#[inline(never)]
pub(super) fn short_reciprocal(divisor: u64) -> u64 {
    let word = (divisor >> 32) as u32;
    // the leading bit is set already; setting it again shows the compiler that the divisor is not 0
    let first = u32::MAX / ((word >> 16) | (1 << 15));
    // 2^48 less the product of word and inverse, which is nearly 2^48
    let rest = (1_i64 << 48) - long_product(word, first) as i64;
    let second = (i64::from(first) << 15) + ((i64::from(first) * (rest >> 4)) >> 29);
    let second = u32::try_from(second).unwrap_or(u32::MAX);
    // 2^63 less the product, which is nearly 2^63
    let product = long_product(word, second) + (long_product(divisor as u32, second) >> 32);
    let rest = (1_u64 << 63).wrapping_sub(product) as i64;
    let third = (u64::from(second) << 31).wrapping_add_signed((i64::from(second) * (rest >> 6)) >> 26);
    // 2^62 less the product, which is a small number
    let rest = (1_u64 << 62).wrapping_sub(high_product_of_long(divisor, third)) as i64;
    third.wrapping_add_signed((rest * (third >> 54) as i64) >> 8)
}

/// Inverse root 2^94/√x of a number in [2^62, 2^64), with 52 correct bits, by Newton's method.
#[inline(never)]
pub(super) fn short_inverse_root(number: u64) -> u64 {
    let word = (number >> 32) as u32;
    // 2^30 times 2.2 - 1.2 x, whose relative error is at most a seventh
    let line = 2_362_232_012 - (long_product(word, 1_288_490_189) >> 32) as u32;
    let short = (0..4).fold(line, |inverse, _| {
        let square = (long_product(inverse, inverse) >> 32) as u32;
        // 2^28 times the product of number and square, which is nearly 1
        let product = (long_product(word, square) >> 32) as u32;
        (long_product(inverse, (3 << 28) - product) >> 29) as u32
    });
    let inverse = u64::from(short) << 32;
    let square = high_product_of_long(inverse, inverse);
    // 2^60 times the product, which is nearly 1
    let product = high_product_of_long(number, square);
    high_product_of_long(inverse, (3 << 60) - product) << 3
}

/// Upper 64 bits of the product of two unsigned numbers.
#[inline(never)]
fn high_product_of_long(a: u64, b: u64) -> u64 {
    let [high, _] = product_of_long(a, b);
    high
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::{Extended, Float, Ring};

    /// The first approximations have the stated accuracy over their whole range.
    #[test]
    fn reciprocals_and_roots_begin_well() {
        let whole = |number: u64| Extended::from_integer(number, 0);
        let power = |exponent| Extended::from_integer(1, exponent);
        let (mut worst, steps) = ([0.0_f64; 2], if cfg!(miri) { 300 } else { 100_000 });
        for k in 0..=steps {
            let divisor = (1 << 63) + k * ((u64::MAX >> 1) / steps);
            let exact = power(126) / whole(divisor);
            let found = whole(short_reciprocal(divisor));
            let number = (1 << 62) + k * ((u64::MAX - (1 << 62)) / steps);
            let root = whole(short_inverse_root(number));
            let square = root * root * whole(number) / power(126);
            let errors =
                [found / exact - Extended::ONE, square.halved().halved() - Extended::from(2_f64.powi(60))];
            let [reciprocal, root] = errors.map(|error| error.abs().to_f64());
            worst = [worst[0].max(reciprocal), worst[1].max(root * 2_f64.powi(-61))];
        }
        assert!((1e-20..8e-19).contains(&worst[0]) && (1e-18..3e-16).contains(&worst[1]), "{worst:?}");
    }
}
