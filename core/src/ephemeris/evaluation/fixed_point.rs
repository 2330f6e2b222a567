//! [`I2F30`] and [`I2F14`]: their integer representations are evaluated directly.

use crate::complex::Complex;
use crate::ephemeris::evaluation::{
    EphemerisScalar, EvaluationErrors, SegmentPoint, coefficient, integer, narrow, rates,
};
use crate::scalar::{RateNumber, Scalar, sine_cosine_q31};
use crate::su2::Vector;
use fixed::types::{I2F14, I2F30};

/// Upper bound on the relative rounding error of the angular velocity: one rounding to `f32` each for the constants and
/// for the result, and truncations to 2^-28 in the rotation to the fixed frame, which add up to at most 13 units where
/// |Ω| is at least 1/2.
const RATE_ROUNDING: f64 = 3.7 * <f32 as Scalar>::ROUNDING;

impl EphemerisScalar for I2F30 {
    type Coefficient = i32;
    type Segment = [[i32; 4]; 4];
    type Wide = f32;
    type Rate = Self;

    const TERMS: usize = 4;
    const ZERO_SEGMENT: Self::Segment = [[0; 4]; 4];
    const CODE: u32 = 31;
    const ERRORS: EvaluationErrors = EvaluationErrors {
        tick: integer::ERROR_Q31,
        tick_deviation: 0.0,
        slope: 0.0,
        place: integer::PLACE_ROUNDING,
        rate: integer::RATE_ERROR,
        relative_rate: RATE_ROUNDING,
        operation: <Self::Rates as RateNumber>::OPERATION_ERROR,
    };

    fn coefficient(value: i64, power: usize) -> (i32, i64) {
        coefficient::nearest(value, power)
    }

    fn coefficient_error(polynomial: &[i64]) -> f32 {
        coefficient::error(polynomial)
    }

    fn number(held: i32, power: usize) -> f32 {
        coefficient::number(held, power)
    }

    fn widened(self) -> f32 {
        self.to_num()
    }

    #[inline(always)]
    fn alpha_beta(terms: &[[i32; 4]], point: SegmentPoint) -> [Complex<Self>; 2] {
        let [re_alpha, im_alpha, re_beta, im_beta] =
            integer::alpha_beta::<false>(terms, point, sine_cosine_q31).map(Self::from_bits);
        [Complex::new(re_alpha, im_alpha), Complex::new(re_beta, im_beta)]
    }

    #[inline(always)]
    fn alpha_beta_and_rates(
        terms: &[[i32; 4]],
        point: SegmentPoint,
        level: u32,
        rates: [f32; 3],
    ) -> ([Complex<Self>; 2], Vector<Self>, i32) {
        let (parameters, found) = integer::alpha_beta_and_rates(terms, point, level, rates, sine_cosine_q31);
        let [re_alpha, im_alpha, re_beta, im_beta] = parameters.map(Self::from_bits);
        let parameters = [Complex::new(re_alpha, im_alpha), Complex::new(re_beta, im_beta)];
        (parameters, found.omega.map(Self::from_bits), found.exponent)
    }

    fn rate_number(self) -> Self {
        self
    }

    fn rate_in(rate: Self, exponent: i32) -> f32 {
        rates::rate_in(rate.to_bits(), exponent)
    }
}

impl EphemerisScalar for I2F14 {
    type Coefficient = i16;
    type Segment = [[i16; 4]; 3];
    type Wide = f32;
    type Rate = I2F30;

    const TERMS: usize = 3;
    const ZERO_SEGMENT: Self::Segment = [[0; 4]; 3];
    const CODE: u32 = 15;
    const ERRORS: EvaluationErrors = EvaluationErrors {
        tick: narrow::ERROR,
        tick_deviation: 0.0,
        slope: narrow::SLOPE_ROUNDING,
        place: integer::PLACE_ROUNDING,
        rate: narrow::RATE_ERROR,
        relative_rate: RATE_ROUNDING,
        operation: <Self::Rates as RateNumber>::OPERATION_ERROR,
    };

    fn coefficient(value: i64, power: usize) -> (i16, i64) {
        narrow::coefficient(value, power)
    }

    fn coefficient_error(polynomial: &[i64]) -> f32 {
        coefficient::overflow(polynomial, narrow::OVERFLOW)
    }

    fn number(coefficient: i16, power: usize) -> f32 {
        narrow::number(coefficient, power)
    }

    fn widened(self) -> f32 {
        self.to_num()
    }

    #[inline(always)]
    fn alpha_beta(terms: &[[i16; 4]], point: SegmentPoint) -> [Complex<Self>; 2] {
        let [re_alpha, im_alpha, re_beta, im_beta] = narrow::alpha_beta(terms, point).map(Self::from_bits);
        [Complex::new(re_alpha, im_alpha), Complex::new(re_beta, im_beta)]
    }

    #[inline(always)]
    fn alpha_beta_and_rates(
        terms: &[[i16; 4]],
        point: SegmentPoint,
        level: u32,
        rates: [f32; 3],
    ) -> ([Complex<Self>; 2], Vector<I2F30>, i32) {
        let (parameters, found) = narrow::alpha_beta_and_rates(terms, point, level, rates);
        let [re_alpha, im_alpha, re_beta, im_beta] = parameters.map(Self::from_bits);
        let parameters = [Complex::new(re_alpha, im_alpha), Complex::new(re_beta, im_beta)];
        (parameters, found.omega.map(I2F30::from_bits), found.exponent)
    }

    fn rate_number(self) -> I2F30 {
        I2F30::from_bits(i32::from(self.to_bits()) << 16)
    }

    fn rate_in(rate: I2F30, exponent: i32) -> f32 {
        rates::rate_in(rate.to_bits(), exponent)
    }
}
