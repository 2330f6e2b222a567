//! [`I2F30`] and [`I2F14`]: the integers as they are.

use super::{Place, Tabular, integer, narrow};
use crate::complex::Complex;
use crate::real::sine_cosine_q31;
use fixed::types::{I2F14, I2F30};

impl Tabular for I2F30 {
    type Coefficient = i32;
    type Wide = f32;

    const NOTHING: i32 = 0;
    const TICK_ERROR: f64 = integer::ERROR;
    const PLACE_ROUNDING: f64 = integer::PLACE_ROUNDING;

    fn coefficient(value: f64, power: usize) -> i32 {
        integer::coefficient(value, power)
    }

    fn excess(polynomial: &[f64]) -> f64 {
        integer::excess(polynomial, integer::MARGIN) + integer::shortfall(polynomial)
    }

    fn number(coefficient: i32, power: usize) -> f32 {
        integer::number(coefficient, power) as f32
    }

    fn widened(self) -> f32 {
        self.to_num()
    }

    #[inline(always)]
    fn alpha_beta(terms: &[[i32; 4]], place: Place) -> [Complex<Self>; 2] {
        let [re_alpha, im_alpha, re_beta, im_beta] =
            integer::alpha_beta(terms, place, sine_cosine_q31).map(Self::from_bits);
        [Complex::new(re_alpha, im_alpha), Complex::new(re_beta, im_beta)]
    }

    #[inline(always)]
    fn tip(product: Complex<Self>, _: f32) -> Complex<Self> {
        product + product
    }
}

impl Tabular for I2F14 {
    type Coefficient = i16;
    type Wide = f32;

    const NOTHING: i16 = 0;
    const TICK_ERROR: f64 = narrow::ERROR;
    const PLACE_ROUNDING: f64 = integer::PLACE_ROUNDING;

    fn coefficient(value: f64, power: usize) -> i16 {
        narrow::coefficient(value, power)
    }

    fn excess(polynomial: &[f64]) -> f64 {
        integer::excess(polynomial, narrow::MARGIN)
    }

    fn number(coefficient: i16, power: usize) -> f32 {
        narrow::number(coefficient, power) as f32
    }

    fn widened(self) -> f32 {
        self.to_num()
    }

    #[inline(always)]
    fn alpha_beta(terms: &[[i16; 4]], place: Place) -> [Complex<Self>; 2] {
        let [re_alpha, im_alpha, re_beta, im_beta] = narrow::alpha_beta(terms, place).map(Self::from_bits);
        [Complex::new(re_alpha, im_alpha), Complex::new(re_beta, im_beta)]
    }

    #[inline(always)]
    fn tip(product: Complex<Self>, _: f32) -> Complex<Self> {
        product + product
    }
}
