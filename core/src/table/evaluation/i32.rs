//! Evaluation in integers of 32 bits. Sums are in units of 2^-31.
//!
//! A coefficient of x^k is stored as c·2^(31+k). The upper word of its product with x·2^31 has half the scale, which is that of the next lower
//! coefficient. The sums for a derivative have half the scale, because they may be twice as large. Set-up refuses sums that could overflow; the
//! last one saturates.

use crate::complex::Complex;
use crate::integer::{high_product, shifted_right};
use crate::scalar::Q30;
use crate::table::evaluation::{Coefficient, SegmentPoint, TABLE_BITS, TableScalar, TickErrors, range};
#[cfg(feature = "fixed")]
use {
    crate::scalar::{Wide, sine_cosine_q31},
    fixed::types::I2F30,
};

/// Unit of the results, 2^-30.
pub(super) const UNIT_Q30: f64 = 1.0 / (1_u64 << 30) as f64;
/// Error of the local coordinate, by which a and b are off.
pub(super) const COORDINATE_ERROR: f64 = 2.0 / (1_u64 << 32) as f64;
/// Errors with sines to 31 bits.
pub(super) const ERRORS_Q30: TickErrors = TickErrors {
    orientation: (15.2 + 2.83 * 1.23) * UNIT_Q30,
    coordinate: COORDINATE_ERROR,
    omega: 22.0 * UNIT_Q30,
    relative_omega: 21.0 * f32::ROUNDING,
};

#[cfg(feature = "fixed")]
impl TableScalar for I2F30 {
    type Coefficient = i32;
    type Segment = [[i32; 4]; 4];
    type Quantity = f32;
    type SetUpFloat = Wide<1>;

    const ROUNDING: f64 = 0.5 * UNIT_Q30;
    const CODE: u32 = 31;
    const TERMS: usize = 4;
    const ZERO_SEGMENT: Self::Segment = [[0; 4]; 4];
    const TRUNCATION: f64 = 4.0 * Self::ROUNDING;
    const ERRORS: TickErrors = ERRORS_Q30;

    #[inline]
    fn from_component(number: Q30) -> Self {
        Self::from_bits(number.0)
    }

    #[inline]
    fn to_quantity(number: Q30) -> f32 {
        number.into()
    }

    #[inline(always)]
    fn sine_cosine(phase: u64) -> [i32; 2] {
        sine_cosine_q31((phase >> 32) as u32).into()
    }
}

impl Coefficient for i32 {
    type Accumulator = Self;
    type Component = Q30;

    /// Coefficient in units of 2^-(31 + power). Half a unit is added, because the product that Horner's rule adds is rounded down;
    /// not to the constant, of which the falling half takes the complement.
    fn nearest(value: i64, power: usize) -> Self {
        let dropped = TABLE_BITS - 31 - power as u32;
        if power == 0 {
            return shifted_right(value, dropped).clamp(i32::MIN.into(), i32::MAX.into()) as i32;
        }
        ((value >> dropped) + 1).try_into().unwrap_or(i32::MIN)
    }

    fn are_safe(segment: &[[i32; 4]]) -> bool {
        range::are_safe_i32(segment.as_flattened())
    }

    #[inline]
    fn to_sum(self) -> i32 {
        self
    }

    #[inline]
    fn coordinate(point: SegmentPoint) -> i32 {
        point.x_q31
    }

    #[inline(always)]
    fn step(self, sum: i32, x: i32) -> i32 {
        self + high_product(sum, x)
    }

    #[inline(always)]
    fn last_step(self, sum: i32, x: i32) -> i32 {
        self.saturating_add(high_product(sum, x))
    }

    #[inline(always)]
    fn slope_step(sum: i32, slope: i32, x: i32) -> i32 {
        (sum >> 1).step(slope, x)
    }

    #[inline(always)]
    fn rotated([re, im]: [i32; 2], is_falling: bool, [sine, cosine]: [i32; 2]) -> Complex<Q30> {
        let im = im ^ -i32::from(is_falling);
        Complex::new(
            Q30(high_product(!im, sine) + high_product(re, cosine)),
            Q30(high_product(im, cosine) + high_product(re, sine)),
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::table::evaluation::TABLE_UNIT;

    /// Coefficients of the segment nearest to polynomials with these values, lowest power first.
    fn segment<C: Coefficient, const N: usize>(values: [f64; N]) -> [[C; 4]; N] {
        let mut power = 0..;
        values.map(|value| [C::nearest((value / TABLE_UNIT) as i64, power.next().unwrap_or(0)); 4])
    }

    #[test]
    fn sums_stay_below_1() {
        for (values, is_safe) in [
            ([0.9, 0.3, 0.05, 0.02, -0.03, 0.01], true),
            ([0.0, 0.0, 0.0, 0.0, 0.02, 0.03], true),
            ([0.0, 0.0, 0.0, 0.0, 0.02, 0.04], false),
        ] {
            assert_eq!(i32::are_safe(&segment(values)), is_safe, "{values:?}");
        }
        #[cfg(feature = "fixed")]
        for (values, is_safe) in [
            ([0.9, 0.4999, 0.0, 0.0], true),
            ([0.9, 0.5001, 0.0, 0.0], false),
            ([0.9, 0.2, -0.2501, 0.0], false),
            // of the second sum, half of the first is 0.375
            ([0.9, 0.33, 0.1875, 0.0], false),
            ([0.9, 0.31, 0.1875, 0.0], true),
        ] {
            assert_eq!(i16::are_safe(&segment(values)), is_safe, "{values:?}");
        }
    }

    #[test]
    fn a_coefficient_is_within_a_unit() {
        for power in 0..16 {
            for value in [0.2, -0.2, 1e-9, 0.0].map(|value| value * 0.5_f64.powi(power)) {
                let value = (value / TABLE_UNIT) as i64;
                let stored = f64::from(i32::nearest(value, power as usize)) * 2_f64.powi(-31 - power);
                let error = stored - value as f64 * TABLE_UNIT;
                assert!(error.abs() <= 2_f64.powi(-31 - power), "{power} {value}");
            }
        }
        assert!(!i32::are_safe(&[[0; 4], [i32::nearest(i64::MAX, 1); 4]]));
    }
}
