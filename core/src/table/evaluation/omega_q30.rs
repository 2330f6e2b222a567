//! Angular velocity in integers: for ticks in `f32` and fixed point.

use crate::integer::high_product;
use crate::scalar::Q30;
use crate::su2::Vector;
use crate::table::evaluation::{SegmentPoint, TickNumber};

/// Values and derivatives are in units of 2^-31, sine and cosine in units of 2^-30. Sums wrap only with invalid table data.
impl TickNumber for Q30 {
    type Sum = i32;
    type Quantity = f32;

    #[inline(always)]
    fn to_quantity(self, exponent: i32) -> f32 {
        self.to_f32(exponent)
    }

    #[inline(always)]
    fn omega_body(
        polynomials: [[i32; 4]; 2],
        [sine, cosine]: [i32; 2],
        point: SegmentPoint,
        rates: [f32; 3],
    ) -> (Vector<Q30>, i32) {
        let [[re_a, im_a, re_b, im_b], [re_slope_a, im_slope_a, re_slope_b, im_slope_b]] = polynomials;
        // x ȳ of complex numbers, to units of 2^-30
        let times_conj = |[x, ix]: [i32; 2], [y, iy]: [i32; 2]| {
            let re = high_product(x, y).wrapping_add(high_product(ix, iy));
            [re, high_product(ix, y).wrapping_sub(high_product(x, iy))]
        };
        let [forth, forth_im] = times_conj([re_slope_b, im_slope_b], [re_a, im_a]);
        let [back, back_im] = times_conj([re_b, im_b], [re_slope_a, im_slope_a]);
        let [product, product_im] = times_conj([re_b, im_b], [re_a, im_a]);
        let [x, mean, axial] = rates.map(Significand::new);
        let x = Significand { exponent: x.exponent + point.halvings as i32, ..x };
        let exponent = x.exponent.max(mean.exponent);
        let sum =
            |change: i32, value: i32| x.times(change, exponent).wrapping_add(mean.times(value, exponent));
        let re = sum(forth.wrapping_sub(back), product_im.wrapping_neg());
        let n = [
            if point.is_falling { re.wrapping_neg() } else { re },
            sum(forth_im.wrapping_sub(back_im), product),
        ];
        // shifted left as far as the sum of two products allows
        let [re_bits, im_bits] = n.map(|part| part ^ (part >> 31));
        let spare = (re_bits | im_bits).leading_zeros().saturating_sub(2);
        let [re, im] = n.map(|part| part << spare);
        let transverse = [
            high_product(re, sine).wrapping_add(high_product(im, cosine)) << 2,
            high_product(im, sine).wrapping_sub(high_product(re, cosine)) << 2,
        ];
        let transverse_exponent = exponent + 3 - spare as i32;
        let exponent = transverse_exponent.max(axial.exponent + 1);
        let [x1, x2] = transverse.map(|part| part >> (exponent - transverse_exponent).min(31));
        let omega = [x1, x2, axial.digits >> (exponent - axial.exponent).min(31)];
        (omega.map(Q30), exponent - 127)
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
            let (exact, _) = <f64 as TickNumber>::omega_body(wide, turn, point, [x, mean, axial]);
            let turn = turn.map(|part| (part * (1_u64 << 30) as f64) as i32);
            let (omega, exponent) = Q30::omega_body([values, slopes], turn, point, rates);
            let allowed = 3e-8 * (x * f64::from(1_u32 << halvings) + mean.abs() + axial.abs());
            for (number, exact) in omega.into_iter().zip(exact) {
                // a rotated number may exceed 1 by up to √2
                assert!(number.0.unsigned_abs() < 3 << 29, "{case}: {number:?}");
                worst = worst.max((f64::from(number.to_f32(exponent)) - exact).abs() / allowed);
            }
        }
        assert!(worst < 1.0 && worst > 0.1, "{worst}");
    }
}
