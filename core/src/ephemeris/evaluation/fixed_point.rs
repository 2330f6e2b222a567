//! [`I2F30`] and [`I2F14`]: their integer representations are evaluated directly.

use crate::complex::Complex;
use crate::ephemeris::evaluation::{EphemerisScalar, SegmentPoint, integer, narrow};
use crate::scalar::sine_cosine_q31;
use fixed::types::{I2F14, I2F30};

impl EphemerisScalar for I2F30 {
    type Coefficient = i32;
    type Segment = [[i32; 4]; 4];
    type Wide = f32;

    const TERMS: usize = 4;
    const ZERO_SEGMENT: Self::Segment = [[0; 4]; 4];
    const CODE: u32 = 31;
    const TICK_ERROR: f64 = integer::ERROR_Q31;
    const TICK_DEVIATION: f64 = 0.0;
    const SLOPE_ROUNDING: f64 = 0.0;
    const PLACE_ROUNDING: f64 = integer::PLACE_ROUNDING;

    fn coefficient(value: f64, power: usize) -> i32 {
        integer::coefficient(value, power)
    }

    fn coefficient_error(polynomial: &[f64]) -> f64 {
        integer::overflow(polynomial, integer::MARGIN) + integer::shortfall(polynomial)
    }

    fn number(coefficient: i32, power: usize) -> f32 {
        integer::number(coefficient, power) as f32
    }

    fn widened(self) -> f32 {
        self.to_num()
    }

    #[inline(always)]
    fn alpha_beta(terms: &[[i32; 4]], point: SegmentPoint) -> [Complex<Self>; 2] {
        let [re_alpha, im_alpha, re_beta, im_beta] =
            integer::alpha_beta(terms, point, sine_cosine_q31).map(Self::from_bits);
        [Complex::new(re_alpha, im_alpha), Complex::new(re_beta, im_beta)]
    }
}

impl EphemerisScalar for I2F14 {
    type Coefficient = i16;
    type Segment = [[i16; 4]; 3];
    type Wide = f32;

    const TERMS: usize = 3;
    const ZERO_SEGMENT: Self::Segment = [[0; 4]; 3];
    const CODE: u32 = 15;
    const TICK_ERROR: f64 = narrow::ERROR;
    const TICK_DEVIATION: f64 = 0.0;
    const SLOPE_ROUNDING: f64 = narrow::SLOPE_ROUNDING;
    const PLACE_ROUNDING: f64 = integer::PLACE_ROUNDING;

    fn coefficient(value: f64, power: usize) -> i16 {
        narrow::coefficient(value, power)
    }

    fn coefficient_error(polynomial: &[f64]) -> f64 {
        integer::overflow(polynomial, narrow::MARGIN)
    }

    fn number(coefficient: i16, power: usize) -> f32 {
        narrow::number(coefficient, power) as f32
    }

    fn widened(self) -> f32 {
        self.to_num()
    }

    #[inline(always)]
    fn alpha_beta(terms: &[[i16; 4]], point: SegmentPoint) -> [Complex<Self>; 2] {
        let [re_alpha, im_alpha, re_beta, im_beta] = narrow::alpha_beta(terms, point).map(Self::from_bits);
        [Complex::new(re_alpha, im_alpha), Complex::new(re_beta, im_beta)]
    }
}
