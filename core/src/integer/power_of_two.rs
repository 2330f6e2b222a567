//! Products with powers of two, and parts of a floating-point number.
//!
//! Without an FPU, a change of the exponent takes a tenth of the time of a product.

/// 2^exponent; 0 below the normal numbers of `f64`, infinity above them.
pub(crate) const fn power_of_two(exponent: i32) -> f64 {
    let field = match exponent {
        ..-1022 => 0,
        1024.. => 2047,
        _ => exponent + 1023,
    };
    f64::from_bits((field as u64) << 52)
}

/// Least e with |x| < 2^e; -1022 for 0 and the numbers below the normal ones.
pub(crate) fn exponent(x: f64) -> i32 {
    ((x.to_bits() >> 52) & 0x7ff) as i32 - 1022
}

/// Number as an `f32`, with at most two roundings. An FPU converts 32 bits in one instruction, 64 bits in forty.
#[inline(always)]
pub(crate) fn u64_to_f32(number: u64) -> f32 {
    const WORD: f32 = (1_u64 << 32) as f32;
    let upper = (number >> 32) as u32;
    let lower = number as u32;
    if upper == 0 { lower as f32 } else { upper as f32 * WORD + lower as f32 }
}

/// Product x · 2^exponent, at a tenth of a soft multiplication.
#[inline(never)]
pub(crate) fn ldexp(x: f64, exponent: i32) -> f64 {
    let upper = (x.to_bits() >> 32) as u32;
    let lower = x.to_bits() as u32;
    let field = ((upper >> 20) & 0x7ff) as i32;
    let result = field.saturating_add(exponent);
    if field == 0 && (upper << 1) | lower == 0 {
        return x;
    }
    if field == 0 || field == 0x7ff || !(1..0x7ff).contains(&result) {
        return x * power_of_two(exponent);
    }
    let upper = upper.wrapping_add((exponent as u32) << 20);
    f64::from_bits(u64::from(upper) << 32 | u64::from(lower))
}

/// Mantissa below 2^53 and exponent of x = mantissa · 2^exponent; 0 if x is not finite.
pub(crate) fn mantissa_and_exponent(x: f64) -> (i64, i32) {
    const MANTISSA_BITS: u32 = 52;
    const BIAS: i32 = 1075; // 1023 + 52
    let bits = x.to_bits();
    let fraction = (bits & ((1 << MANTISSA_BITS) - 1)) as i64;
    let magnitude = ((bits >> MANTISSA_BITS) & 0x7ff) as i32;
    let (mantissa, exponent) = match magnitude {
        0 => (fraction, 1 - BIAS),
        0x7ff => (0, 0),
        _ => (fraction | (1 << MANTISSA_BITS), magnitude - BIAS),
    };
    (if bits >> 63 == 1 { -mantissa } else { mantissa }, exponent)
}

/// Integer nearest to x / 2^exponent, at most ±2^62.
#[inline(never)]
pub(crate) fn to_units(x: f64, exponent: i32) -> i64 {
    let (mantissa, x_exponent) = mantissa_and_exponent(x);
    match x_exponent.saturating_sub(exponent) {
        10.. => mantissa.signum() << 62,
        shift @ 0.. => mantissa << shift,
        shift @ -62.. => shifted_right(mantissa, -shift as u32),
        _ => 0,
    }
}

/// value / 2^bits, rounded to the nearest, for bits of 1 to 63.
pub(crate) const fn shifted_right(value: i64, bits: u32) -> i64 {
    ((value >> (bits - 1)) + 1) >> 1
}

/// value · 2^shift, rounded to the nearest integer, modulo 2^128.
pub(crate) fn ldexp_i128(value: i128, shift: i32) -> i128 {
    match shift {
        128.. => 0,
        0.. => value << shift,
        -126.. => ((value >> (-shift - 1)) + 1) >> 1,
        _ => 0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn powers_at_the_ends_of_the_range() {
        let powers = [-1023, -1022, 1023, 1024].map(power_of_two);
        assert_eq!(powers, [0.0, f64::MIN_POSITIVE, 2_f64.powi(1023), f64::INFINITY]);
    }
}
