//! `f64`: four polynomials by Horner's rule and two rotations, in floating point.

use crate::complex::Complex;
use crate::ephemeris::evaluation::rates::ValuesAndSlopes;
use crate::ephemeris::evaluation::{EphemerisScalar, EvaluationErrors, SegmentPoint};
use crate::law::series::UNIT;
use crate::scalar::{RateNumber, Scalar, sine_cosine_f64};
use crate::su2::Vector;

/// Rounding unit, 2^-53.
const ROUNDING: f64 = <f64 as Scalar>::ROUNDING;

impl EphemerisScalar for f64 {
    type Coefficient = Self;
    type Segment = [[Self; 4]; 11];
    type Wide = Self;
    type Rate = Self;

    const TERMS: usize = 11;
    const ZERO_SEGMENT: Self::Segment = [[0.0; 4]; 11];
    const CODE: u32 = 64;
    const ERRORS: EvaluationErrors = EvaluationErrors {
        tick: 0.0,
        // In units of 2^-53: the root of the sum of squares of 0.8 for the last sum of Horner's rule, 1.2 for the
        // rotation and 1.4 for its sine and cosine. The worst case is the sum of 2, 4.5 and 4.6.
        tick_deviation: 2.0 * ROUNDING,
        // Zero, because the sums before the last are counted with the roundings of their coefficients.
        slope: 0.0,
        // Zero, because the local coordinate is rounded on the segment and counts as another rounding of the
        // coefficients.
        place: 0.0,
        // Zero, because the roundings are relative to the angular velocity.
        rate: 0.0,
        // Five standard deviations of one rounding.
        relative_rate: 5.0 * ROUNDING,
        operation: <Self::Rates as RateNumber>::OPERATION_ERROR,
    };

    fn coefficient(value: i64, _: usize) -> (Self, i64) {
        let nearest = value as f64;
        (nearest * UNIT, (nearest as i64).saturating_sub(value))
    }

    fn coefficient_error(_: &[i64]) -> f32 {
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
        values_and_slopes(terms, point.x).alpha_beta(point.mirrored, point.slow.map(direction))
    }

    #[inline(always)]
    fn alpha_beta_and_rates(
        terms: &[[Self; 4]],
        point: SegmentPoint,
        level: u32,
        [x, mean, axial]: [Self; 3],
    ) -> ([Complex<Self>; 2], Vector<Self>, i32) {
        let polynomials = values_and_slopes(terms, point.x);
        let [a, b] = point.slow.map(direction);
        let parameters = polynomials.alpha_beta(point.mirrored, [a, b]);
        let rates = [x * Self::from(1_u16 << level), mean, axial];
        (parameters, polynomials.omega_body(point.mirrored, a.conj() * b, rates), 0)
    }

    fn rate_number(self) -> Self {
        self
    }

    fn rate_in(rate: Self, _: i32) -> Self {
        rate
    }
}

/// e^{iA} from the leading bits of A.
#[inline(always)]
fn direction(phase: u64) -> Complex<f64> {
    let (sine, cosine) = sine_cosine_f64(phase);
    Complex::new(cosine, sine)
}

/// Polynomials and their derivatives at x·2^63.
#[inline(always)]
fn values_and_slopes(terms: &[[f64; 4]], x: i64) -> ValuesAndSlopes<f64> {
    const UNIT: f64 = 1.0 / (1_u64 << 63) as f64;
    ValuesAndSlopes::at(terms.iter().rev().copied(), x as f64 * UNIT)
}
