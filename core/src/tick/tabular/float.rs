//! `f64`: four Horner sums and two rotations in floating point.

use super::{Place, Tabular};
use crate::complex::Complex;
use crate::real::sine_cosine_f64;

impl Tabular for f64 {
    type Coefficient = Self;
    type Wide = Self;

    const NOTHING: Self = 0.0;
    /// Eight roundings: products and sums of numbers up to 1, and two sines and cosines.
    const TICK_ERROR: f64 = 4.0 * f64::EPSILON;
    const PLACE_ROUNDING: f64 = 0.5 * f64::EPSILON;

    fn coefficient(value: f64, _: usize) -> Self {
        value
    }

    fn excess(_: &[f64]) -> f64 {
        0.0
    }

    fn number(coefficient: Self, _: usize) -> Self {
        coefficient
    }

    fn widened(self) -> Self {
        self
    }

    #[inline(always)]
    fn alpha_beta(terms: &[[Self; 4]], place: Place) -> [Complex<Self>; 2] {
        const UNIT: f64 = 1.0 / (1_u64 << 63) as f64;
        let x = place.x as f64 * UNIT;
        let mut backwards = terms.iter().rev();
        let mut four = backwards.next().copied().unwrap_or([0.0; 4]);
        for coefficients in backwards {
            for (sum, &c) in four.iter_mut().zip(coefficients) {
                *sum = *sum * x + c;
            }
        }
        let [re_alpha, im_alpha, re_beta, im_beta] = four;
        let sign = |y: f64| if place.mirrored { -y } else { y };
        let [a, b] = place.slow.map(|phase| {
            let (sine, cosine) = sine_cosine_f64(phase);
            Complex::new(cosine, sine)
        });
        [Complex::new(re_alpha, sign(im_alpha)) * a, Complex::new(re_beta, sign(im_beta)) * b]
    }

    #[inline(always)]
    fn tip(product: Complex<Self>, scale: Self) -> Complex<Self> {
        product.scaled(scale)
    }
}
