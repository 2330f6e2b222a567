//! Angular velocity in integers, and conversion to `f32`: for ticks in `f32` and fixed point.

use crate::integer::high_product;
use crate::scalar::Q30;
use crate::su2::Vector;
use crate::table::evaluation::{SegmentPoint, TickNumber};

/// Whether conversions to `f32` and their products are calls.
const SOFT_FLOAT: bool = cfg!(any(
    all(target_arch = "arm", not(target_abi = "eabihf")),
    all(target_arch = "riscv32", not(target_feature = "f"))
));

impl TickNumber for Q30 {
    type Sum = i32;
    type Quantity = f32;

    /// Product rounded to `f32`; 0 for an exponent below -95, at which it could be subnormal.
    #[inline(always)]
    fn to_quantity(self, exponent: i32) -> f32 {
        let number = if exponent < -95 { 0 } else { self.0 };
        let exponent = exponent.max(-95) - 30;
        if SOFT_FLOAT {
            // the same bits as the product below: a product with a power of two is exact
            let converted = (number as f32).to_bits();
            return if number == 0 {
                0.0
            } else {
                f32::from_bits(converted.wrapping_add_signed(exponent << 23))
            };
        }
        number as f32 * f32::from_bits(((exponent + 127) as u32) << 23)
    }

    /// Values and derivatives are in units of 2^-31, sine and cosine of Λ_β - Λ_α in units of 2^-30. Sums wrap only with invalid table data.
    #[inline(always)]
    fn omega_body(
        polynomials: [[i32; 4]; 2],
        [sine, cosine]: [i32; 2],
        point: SegmentPoint,
        rates: [f32; 3],
    ) -> (Vector<Self>, i32) {
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
        let x = Significand { exponent: x.exponent + point.halvings as i32, ..x };
        let exponent = x.exponent.max(mean.exponent);
        let sum =
            |change: i32, value: i32| x.times(change, exponent).wrapping_add(mean.times(value, exponent));
        let re = sum(forth.wrapping_sub(back), iproduct.wrapping_neg());
        let n =
            [if point.is_falling { re.wrapping_neg() } else { re }, sum(iforth.wrapping_sub(iback), product)];
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
        (omega.map(Self), exponent - 127)
    }
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

    #[test]
    fn a_power_of_two_is_exact() {
        for (number, exponent) in [(1 << 30, 0), (-3, 30), (i32::MAX, 119), (1, -95), (i32::MIN, -27)] {
            let exact = f64::from(number as f32) * libm::exp2(f64::from(exponent - 30));
            assert_eq!(f64::from(Q30(number).to_quantity(exponent)), exact, "{number} {exponent}");
        }
        let zeros = [(0, 73), (1 << 30, -96), (5, -167)];
        assert_eq!(zeros.map(|(number, exponent)| Q30(number).to_quantity(exponent)), [0.0; 3]);
    }
    /// Rates of any size and sign have an error below 3e-8 of their sum.
    #[test]
    fn integers_give_what_floating_point_gives() {
        let mut bits = 0x9e37_79b9_7f4a_7c15_u64;
        let mut random = || {
            bits = crate::integer::next_random(bits);
            (bits >> 32) as i32
        };
        let mut worst = 0.0_f64;
        for case in 0..if cfg!(miri) { 100 } else { 20_000 } {
            let values = [(); 4].map(|()| random() >> 2);
            let slopes = [(); 4].map(|()| random() >> (3 + case % 20));
            let angle = f64::from(random());
            let turn = [libm::sin(angle), libm::cos(angle)];
            let mut rate = || (libm::exp2(f64::from(random() % 9)) * f64::from(random()) / 2e9) as f32;
            let rates = [rate().abs(), rate(), rate()];
            let (halvings, is_falling) = (case % 12, case % 2 == 1);
            let unit = 1.0 / (1_u64 << 31) as f64;
            let wide = [values, slopes].map(|four| four.map(|number| f64::from(number) * unit));
            let [x, mean, axial] = rates.map(f64::from);
            let point = SegmentPoint { x_q63: 0, x_q31: 0, halvings, is_falling };
            let (exact, _) = f64::omega_body(wide, turn, point, [x, mean, axial]);
            let turn = turn.map(|part| (part * (1_u64 << 30) as f64) as i32);
            let (omega, exponent) = Q30::omega_body([values, slopes], turn, point, rates);
            let allowed = 3e-8 * (x * f64::from(1_u32 << halvings) + mean.abs() + axial.abs());
            for (number, exact) in omega.into_iter().zip(exact) {
                // a rotated number may exceed 1 by up to √2
                assert!(number.0.unsigned_abs() < 3 << 29, "{case}: {number:?}");
                worst = worst.max((f64::from(number.to_quantity(exponent)) - exact).abs() / allowed);
            }
        }
        assert!(worst < 1.0 && worst > 0.1, "{worst}");
    }
}
