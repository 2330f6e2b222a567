//! Angular velocity from the values and the derivatives of a segment's polynomials.
//!
//! With α = a e^{iA} and β = b e^{iB}, where a and b are tabulated, Ω = Φ⁻¹Φ' has the transverse part
//!
//! ```text
//! Ω₁ + iΩ₂ = -2i (ᾱβ' - βᾱ') = -2i e^{i(B-A)} N,    N = x' (ā db/dx - b dā/dx) + i (A' + B') ā b
//! ```
//!
//! which is regular at both verticals and at the turning points. Where u falls, the tabulated values are mirrored, and
//! N becomes -N̄. The axial part Ω₃ = (n - K)/C is constant.

use crate::complex::Complex;
use crate::product::high_product;
use crate::scalar::Ring;
use crate::su2::Vector;

/// Values of Re a, Im a, Re b and Im b on the half period with rising u, and their derivatives with respect to x.
pub(crate) struct ValuesAndSlopes<T>(pub(crate) [T; 4], pub(crate) [T; 4]);

impl<R: Ring> ValuesAndSlopes<R> {
    /// Polynomials at x by Horner's rule, from rows of coefficients, the highest power first.
    #[inline(always)]
    pub(crate) fn at(mut backwards: impl Iterator<Item = [R; 4]>, x: R) -> Self {
        let mut sums = backwards.next().unwrap_or([R::ZERO; 4]);
        let mut slopes = [R::ZERO; 4];
        for coefficients in backwards {
            for ((sum, slope), c) in sums.iter_mut().zip(&mut slopes).zip(coefficients) {
                *slope = *slope * x + *sum;
                *sum = *sum * x + c;
            }
        }
        Self(sums, slopes)
    }

    /// α and β, from e^{iA} and e^{iB}.
    #[inline(always)]
    pub(crate) fn alpha_beta(&self, mirrored: bool, [a, b]: [Complex<R>; 2]) -> [Complex<R>; 2] {
        let Self([re_a, im_a, re_b, im_b], _) = *self;
        let sign = |y: R| if mirrored { -y } else { y };
        [Complex::new(re_a, sign(im_a)) * a, Complex::new(re_b, sign(im_b)) * b]
    }

    /// Angular velocity Ω, from e^{i(B-A)} and from the rates of x, of A + B and about the axis.
    #[inline(always)]
    pub(crate) fn omega_body(self, mirrored: bool, turn: Complex<R>, [x, mean, axial]: [R; 3]) -> Vector<R> {
        let Self(values, slopes) = self;
        let pair = |[re_a, im_a, re_b, im_b]: [R; 4]| [Complex::new(re_a, im_a), Complex::new(re_b, im_b)];
        let ([a, b], [a_slope, b_slope]) = (pair(values), pair(slopes));
        let change = (a.conj() * b_slope - b * a_slope.conj()).scaled(x);
        let n = change + (a.conj() * b).times_i().scaled(mean);
        let n = if mirrored { -n.conj() } else { n } * turn;
        [n.im.doubled(), -n.re.doubled(), axial]
    }
}

/// Angular velocity Ω in units of 2^(`exponent` - 157) rad per unit time: integers below 2^31 in magnitude.
pub(crate) struct IntegerRates {
    pub(crate) omega: [i32; 3],
    /// Exponent of 2^30 units, biased as in an `f32`.
    pub(crate) exponent: i32,
}

/// Number in units of 2^(`exponent` - 157) as an `f32`, without a product: a rate below 2^-96 counts as 0.
#[inline(always)]
pub(crate) fn rate_in(number: i32, exponent: i32) -> f32 {
    if number == 0 || exponent <= 31 {
        return 0.0;
    }
    // the exponent of the converted number is at most 158, and that of the result at most `exponent` + 1
    let bits = (number as f32).to_bits().wrapping_add_signed((exponent - 157) << 23);
    f32::from_bits(bits)
}

impl ValuesAndSlopes<i32> {
    /// Angular velocity Ω from values and derivatives in units of 2^-31, from e^{i(B-A)} in units of 2^-30, and from
    /// the rates of x (on a segment of a whole pair of cells), of A + B and about the axis.
    ///
    /// A sum that is too large wraps, which happens only with invalid literal data.
    #[inline(always)]
    pub(crate) fn integer_rates(
        self,
        mirrored: bool,
        [cosine, sine]: [i32; 2],
        level: u32,
        rates: [f32; 3],
    ) -> IntegerRates {
        let Self([a, ia, b, ib], [da, dia, db, dib]) = self;
        // x ȳ of complex numbers, to units of 2^-30
        let times_conj = |[x, ix]: [i32; 2], [y, iy]: [i32; 2]| {
            let re = high_product(x, y).wrapping_add(high_product(ix, iy));
            [re, high_product(ix, y).wrapping_sub(high_product(x, iy))]
        };
        let [forth, iforth] = times_conj([db, dib], [a, ia]);
        let [back, iback] = times_conj([b, ib], [da, dia]);
        let [product, iproduct] = times_conj([b, ib], [a, ia]);
        let [x, mean, axial] = rates.map(Significand::of);
        let x = Significand { exponent: x.exponent + level as i32, ..x };
        let exponent = x.exponent.max(mean.exponent);
        let sum =
            |change: i32, turned: i32| x.times(change, exponent).wrapping_add(mean.times(turned, exponent));
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
        // -2i N has units of 2^-27 before the shift
        let own = exponent + 3 - spare as i32;
        let exponent = own.max(axial.exponent + 1);
        let [x1, x2] = transverse.map(|part| part >> (exponent - own).min(31));
        IntegerRates { omega: [x1, x2, axial.digits >> (exponent - axial.exponent).min(31)], exponent }
    }
}

/// Floating-point number as an integer times a power of two: `digits` · 2^(`exponent` - 157), where 2^30 <= |`digits`| <
/// 2^31. A number below 2^-126 counts as 0.
#[derive(Clone, Copy)]
struct Significand {
    digits: i32,
    exponent: i32,
}

impl Significand {
    #[inline(always)]
    fn of(number: f32) -> Self {
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

    #[test]
    fn a_power_of_two_is_exact() {
        for (number, exponent) in [(1 << 30, 127), (-3, 157), (i32::MAX, 246), (1, 32), (i32::MIN, 100)] {
            let exact = f64::from(number as f32) * libm::exp2(f64::from(exponent - 157));
            assert_eq!(f64::from(rate_in(number, exponent)), exact, "{number} {exponent}");
        }
        assert_eq!([rate_in(0, 200), rate_in(1 << 30, 31), rate_in(5, -40)], [0.0; 3]);
    }

    /// The integers against the same formula in `f64`, for rates of any size and sign, with an error below 3e-8 of the sum of the
    /// rates.
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
            let wide = ValuesAndSlopes(
                values.map(|value| f64::from(value) * unit),
                slopes.map(|slope| f64::from(slope) * unit),
            );
            let [x, mean, axial] = rates.map(f64::from);
            let x = x * f64::from(1_u32 << level);
            let exact = wide.omega_body(mirrored, Complex::new(turn[0], turn[1]), [x, mean, axial]);
            let turn = turn.map(|part| (part * (1_u64 << 30) as f64) as i32);
            let found = ValuesAndSlopes(values, slopes).integer_rates(mirrored, turn, level, rates);
            let allowed = 3e-8 * (x + mean.abs() + axial.abs());
            for (number, exact) in found.omega.into_iter().zip(exact) {
                // a rotated number may exceed 2^30 by up to √2
                assert!(number.unsigned_abs() < 3 << 29, "{case}: {number}");
                worst = worst.max((f64::from(rate_in(number, found.exponent)) - exact).abs() / allowed);
            }
        }
        assert!(worst < 1.0 && worst > 0.1, "{worst}");
    }
}
