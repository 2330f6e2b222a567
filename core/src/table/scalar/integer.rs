//! Evaluation in integers, with the same bits on every chip: four polynomials by Horner's rule and two rotations.

use crate::complex::Complex;
use crate::product::high_product;
use crate::scalar::{Scalar, times_power_of_two};
use crate::su2::{Orientation, Vector};
use crate::table::scalar::q30::Q30;
use crate::table::scalar::word::{Word, is_short};
use crate::table::scalar::{Coefficient, EphemerisScalar, EvaluationErrors, SegmentPoint};
#[cfg(feature = "fixed")]
use fixed::types::{I2F14, I2F30};

/// Unit of the results, 2^-30.
const UNIT: f64 = 1.0 / (1_u64 << 30) as f64;
/// Error of an orientation with sines to 26 bits and results in `f32`.
const SINGLE_ERROR: f64 = (17.2 + 2.83 * 12.5) * UNIT + f32::EPSILON as f64;

/// Errors in 32 bits: `core/docs/error_bound.md` lists their parts.
const ERRORS: EvaluationErrors = EvaluationErrors {
    tick: (17.2 + 2.83 * 1.23) * UNIT,
    slope: PLACE,
    rate: 40.0 * UNIT,
    relative_rate: 3.7 * <f32 as Scalar>::ROUNDING,
};
const PLACE: f64 = 2.0 / (1_u64 << 32) as f64;
/// Unit of the sums in 16 bits, 2^-15.
#[cfg(feature = "fixed")]
const SHORT_UNIT: f64 = 1.0 / (1_u64 << 15) as f64;

impl EphemerisScalar for f32 {
    type Coefficient = i32;
    type Segment = [[i32; 4]; 5];
    type Quantity = Self;

    const TERMS: usize = 5;
    const ZERO_SEGMENT: Self::Segment = [[0; 4]; 5];
    const CODE: u32 = 32;
    const ERRORS: EvaluationErrors = EvaluationErrors { tick: SINGLE_ERROR, ..ERRORS };

    #[inline(always)]
    fn rounded(number: Q30) -> Self {
        number.to_f32()
    }
}

#[cfg(feature = "fixed")]
impl EphemerisScalar for I2F30 {
    type Coefficient = i32;
    type Segment = [[i32; 4]; 4];
    type Quantity = f32;

    const TERMS: usize = 4;
    const ZERO_SEGMENT: Self::Segment = [[0; 4]; 4];
    const CODE: u32 = 31;
    const ERRORS: EvaluationErrors = ERRORS;
    const TRUNCATION: f64 = 4.0 * Self::ROUNDING;

    #[inline(always)]
    fn rounded(number: Q30) -> Self {
        Self::from_bits(number.0)
    }
}

#[cfg(feature = "fixed")]
impl EphemerisScalar for I2F14 {
    type Coefficient = i16;
    type Segment = [[i16; 4]; 3];
    type Quantity = f32;

    const TERMS: usize = 3;
    const ZERO_SEGMENT: Self::Segment = [[0; 4]; 3];
    const CODE: u32 = 15;
    const ERRORS: EvaluationErrors = EvaluationErrors {
        tick: 16.83 * SHORT_UNIT + 2.6e-5,
        slope: 0.5 * SHORT_UNIT + PLACE,
        rate: 2.001 * SHORT_UNIT,
        ..ERRORS
    };

    #[inline(always)]
    fn rounded(number: Q30) -> Self {
        Self::from_bits((number.0 >> 16) as i16)
    }
}

impl<W: Word> Coefficient for W {
    type Number = Q30;
    type Quantity = f32;

    fn nearest(value: i64, power: usize) -> (Self, i64) {
        W::nearest(value, power)
    }

    fn error(polynomial: &[i64]) -> f32 {
        W::error(polynomial)
    }

    fn value(self, power: usize) -> f64 {
        times_power_of_two(self.sum().into(), -31 - power as i32)
    }

    #[inline(always)]
    fn orientation(terms: &[[W; 4]], point: SegmentPoint, slow: [u64; 2]) -> Orientation<Q30> {
        let [values, _] = polynomials::<W, false>(terms, point.short_x);
        let [a, b] = slow.map(|phase| (phase >> 32) as u32);
        let count = terms.len();
        rotated::<W>(values, point.mirrored, || W::sine_cosine(a, count), || W::sine_cosine(b, count))
    }

    #[inline(always)]
    fn orientation_and_rates(
        terms: &[[W; 4]],
        point: SegmentPoint,
        slow: [u64; 2],
        rates: [f32; 3],
    ) -> (Orientation<Q30>, Vector<Q30>, i32) {
        let [a, b] = slow.map(|phase| W::sine_cosine((phase >> 32) as u32, terms.len()));
        let polynomials = polynomials::<W, true>(terms, point.short_x);
        let orientation = rotated::<W>(polynomials[0], point.mirrored, || a, || b);
        let (omega, exponent) =
            omega_body(polynomials, point.mirrored, W::difference(a, b), point.level, rates);
        (orientation, omega, exponent)
    }

    #[inline(always)]
    fn wide(number: Q30) -> f32 {
        number.to_f32()
    }

    #[inline(always)]
    fn rate(number: Q30, exponent: i32) -> f32 {
        number.times_power_of_two(exponent)
    }
}

/// Orientation from the tabulated values and the sines and cosines of A and B, each computed when it is needed.
#[inline(always)]
fn rotated<W: Word>(
    [re_a, im_a, re_b, im_b]: [i32; 4],
    mirrored: bool,
    a: impl FnOnce() -> (i32, i32),
    b: impl FnOnce() -> (i32, i32),
) -> Orientation<Q30> {
    let mask = -i32::from(mirrored);
    let turned = |re, im: i32, by| {
        let [re, im] = W::rotated([re, im ^ mask], by).map(Q30);
        Complex::new(re, im)
    };
    Orientation { alpha: turned(re_a, im_a, a()), beta: turned(re_b, im_b, b()) }
}

/// Whether the four polynomials are evaluated together, which suits vector units; the smallest chips have too few registers.
const FOUR_AT_A_TIME: bool = cfg!(target_pointer_width = "64");

/// Polynomials and, if `SLOPES`, their derivatives, from the local coordinate times 2^31.
#[inline(always)]
fn polynomials<W: Word, const SLOPES: bool>(terms: &[[W; 4]], x: i32) -> [[i32; 4]; 2] {
    if FOUR_AT_A_TIME {
        return horner::<W, 4, SLOPES>(terms, x, |four| *four);
    }
    let [[re_b, im_b], [re_slope_b, im_slope_b]] =
        horner::<W, 2, SLOPES>(terms, x, |&[_, _, re, im]| [re, im]);
    let [[re_a, im_a], [re_slope_a, im_slope_a]] =
        horner::<W, 2, SLOPES>(terms, x, |&[re, im, _, _]| [re, im]);
    [[re_a, im_a, re_b, im_b], [re_slope_a, im_slope_a, re_slope_b, im_slope_b]]
}

/// Polynomials and, if `SLOPES`, their derivatives by Horner's rule. The sums for a derivative have half the scale, because they may be
/// twice as large. A row is borrowed because the compiler then recognises a vector.
#[inline(always)]
fn horner<W: Word, const N: usize, const SLOPES: bool>(
    terms: &[[W; 4]],
    x: i32,
    part: impl Fn(&[W; 4]) -> [W; N],
) -> [[i32; N]; 2] {
    let [constant, higher @ ..] = terms else { return [[0; N]; 2] };
    let x = W::coordinate(x);
    let (mut sums, mut slopes) = ([0; N], [0; N]);
    for (power, coefficients) in higher.iter().enumerate().map(|(below, four)| (below + 2, four)).rev() {
        let short = is_short(power, terms.len());
        for ((sum, slope), c) in sums.iter_mut().zip(&mut slopes).zip(&part(coefficients)) {
            if SLOPES {
                *slope = (*sum >> 1) + W::product(*slope, x, short);
            }
            *sum = c.sum() + W::product(*sum, x, short);
        }
    }
    for ((sum, slope), c) in sums.iter_mut().zip(&mut slopes).zip(part(constant)) {
        if SLOPES {
            *slope = (*sum >> 1) + W::product(*slope, x, false);
        }
        *sum = (c.sum() + W::HALF).saturating_add(W::product(*sum, x, false));
    }
    [sums, slopes]
}

/// Angular velocity Ω over a power of two, with the exponent of that power: the formula of `float.rs`, from values and derivatives in
/// units of 2^-31 and from e^{i(B-A)} in units of 2^-30. Sums wrap, which happens only with invalid literal data.
#[inline(always)]
fn omega_body(
    polynomials: [[i32; 4]; 2],
    mirrored: bool,
    [cosine, sine]: [i32; 2],
    level: u32,
    rates: [f32; 3],
) -> (Vector<Q30>, i32) {
    let [[a, ia, b, ib], [da, dia, db, dib]] = polynomials;
    // x ȳ of complex numbers, to units of 2^-30
    let times_conj = |[x, ix]: [i32; 2], [y, iy]: [i32; 2]| {
        let re = high_product(x, y).wrapping_add(high_product(ix, iy));
        [re, high_product(ix, y).wrapping_sub(high_product(x, iy))]
    };
    let [forth, iforth] = times_conj([db, dib], [a, ia]);
    let [back, iback] = times_conj([b, ib], [da, dia]);
    let [product, iproduct] = times_conj([b, ib], [a, ia]);
    let [x, mean, axial] = rates.map(Significand::new);
    let x = Significand { exponent: x.exponent + level as i32, ..x };
    let exponent = x.exponent.max(mean.exponent);
    let sum = |change: i32, turned: i32| x.times(change, exponent).wrapping_add(mean.times(turned, exponent));
    let re = sum(forth.wrapping_sub(back), iproduct.wrapping_neg());
    let n = [if mirrored { re.wrapping_neg() } else { re }, sum(iforth.wrapping_sub(iback), product)];
    // shifted left as far as the sum of two products allows
    let [size, isize] = n.map(|part| part ^ (part >> 31));
    let spare = (size | isize).leading_zeros().saturating_sub(2);
    let [re, im] = n.map(|part| part << spare);
    let transverse = [
        high_product(re, sine).wrapping_add(high_product(im, cosine)) << 2,
        high_product(im, sine).wrapping_sub(high_product(re, cosine)) << 2,
    ];
    let own = exponent + 3 - spare as i32;
    let exponent = own.max(axial.exponent + 1);
    let [x1, x2] = transverse.map(|part| part >> (exponent - own).min(31));
    let omega = [x1, x2, axial.digits >> (exponent - axial.exponent).min(31)];
    (omega.map(Q30), exponent - 127)
}

/// Number `digits` · 2^(`exponent` - 157), where 2^30 <= |`digits`| < 2^31; 0 below 2^-126.
#[derive(Clone, Copy)]
struct Significand {
    digits: i32,
    exponent: i32,
}

impl Significand {
    #[inline(always)]
    fn new(number: f32) -> Self {
        let bits = number.to_bits();
        let exponent = (bits >> 23 & 0xff) as i32;
        let digits = ((bits << 7 | 1 << 30) & 0x7fff_ffff) as i32;
        let digits = if exponent == 0 { 0 } else { digits };
        Self { digits: if bits >> 31 == 0 { digits } else { -digits }, exponent }
    }

    /// Product with an integer in units of 2^-30, in units of 2^(`exponent` - 155).
    #[inline(always)]
    fn times(self, integer: i32, exponent: i32) -> i32 {
        high_product(self.digits, integer) >> (exponent - self.exponent).min(31)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::table::scalar::float;

    /// Rates of any size and sign have an error below 3e-8 of their sum.
    #[test]
    fn integers_give_what_floating_point_gives() {
        let mut bits = 0x9e37_79b9_7f4a_7c15_u64;
        let mut random = || {
            bits = bits.wrapping_mul(0x5851_f42d_4c95_7f2d).wrapping_add(0x1405_7b7e_f767_814f);
            (bits >> 32) as i32
        };
        let mut worst = 0.0_f64;
        for case in 0..if cfg!(miri) { 100 } else { 20_000 } {
            let values = [(); 4].map(|()| random() >> 2);
            let slopes = [(); 4].map(|()| random() >> (3 + case % 20));
            let angle = f64::from(random());
            let turn = [libm::cos(angle), libm::sin(angle)];
            let mut rate = || (libm::exp2(f64::from(random() % 9)) * f64::from(random()) / 2e9) as f32;
            let rates = [rate().abs(), rate(), rate()];
            let (level, mirrored) = (case % 12, case % 2 == 1);
            let unit = 1.0 / (1_u64 << 31) as f64;
            let wide = [values, slopes].map(|four| four.map(|number| f64::from(number) * unit));
            let [x, mean, axial] = rates.map(f64::from);
            let x = x * f64::from(1_u32 << level);
            let exact = float::omega_body(wide, mirrored, Complex::new(turn[0], turn[1]), [x, mean, axial]);
            let turn = turn.map(|part| (part * (1_u64 << 30) as f64) as i32);
            let (omega, exponent) = omega_body([values, slopes], mirrored, turn, level, rates);
            let allowed = 3e-8 * (x + mean.abs() + axial.abs());
            for (number, exact) in omega.into_iter().zip(exact) {
                // a rotated number may exceed 1 by up to √2
                assert!(number.0.unsigned_abs() < 3 << 29, "{case}: {number:?}");
                worst = worst.max((f64::from(number.times_power_of_two(exponent)) - exact).abs() / allowed);
            }
        }
        assert!(worst < 1.0 && worst > 0.1, "{worst}");
    }
}
