//! `f64`: four polynomials by Horner's rule and two rotations, in floating point.

use crate::complex::Complex;
use crate::ephemeris::evaluation::{EphemerisScalar, SegmentPoint};
use crate::scalar::{Scalar, sine_cosine_f64};

/// Rounding unit, 2^-53.
const ROUNDING: f64 = <f64 as Scalar>::ROUNDING;

impl EphemerisScalar for f64 {
    type Coefficient = Self;
    type Segment = [[Self; 4]; 11];
    type Wide = Self;

    const TERMS: usize = 11;
    const ZERO_SEGMENT: Self::Segment = [[0.0; 4]; 11];
    const CODE: u32 = 64;
    const TICK_ERROR: f64 = 0.0;
    /// In units of 2^-53: the root of the sum of squares of 0.8 for the last sum of Horner's rule, 1.2 for the
    /// rotation and 1.4 for its sine and cosine. The worst case is the sum of 2, 4.5 and 4.6.
    const TICK_DEVIATION: f64 = 2.0 * ROUNDING;
    /// Zero, because the sums before the last are counted with the roundings of their coefficients.
    const SLOPE_ROUNDING: f64 = 0.0;
    /// Zero, because the local coordinate is rounded on the segment and counts as another rounding of the
    /// coefficients.
    const PLACE_ROUNDING: f64 = 0.0;

    fn coefficient(value: f64, _: usize) -> Self {
        value
    }

    fn coefficient_error(_: &[f64]) -> f64 {
        0.0
    }

    fn number(coefficient: Self, _: usize) -> Self {
        coefficient
    }

    fn widened(self) -> Self {
        self
    }

    #[inline(always)]
    fn alpha_beta(terms: &[[Self; 4]], point: SegmentPoint) -> [Complex<Self>; 2] {
        const UNIT: f64 = 1.0 / (1_u64 << 63) as f64;
        let x = point.x as f64 * UNIT;
        let mut backwards = terms.iter().rev();
        let mut four = backwards.next().copied().unwrap_or([0.0; 4]);
        for coefficients in backwards {
            for (sum, &c) in four.iter_mut().zip(coefficients) {
                *sum = *sum * x + c;
            }
        }
        let [re_alpha, im_alpha, re_beta, im_beta] = four;
        let sign = |y: f64| if point.mirrored { -y } else { y };
        let [a, b] = point.slow.map(|phase| {
            let (sine, cosine) = sine_cosine_f64(phase);
            Complex::new(cosine, sine)
        });
        [Complex::new(re_alpha, sign(im_alpha)) * a, Complex::new(re_beta, sign(im_beta)) * b]
    }
}
