//! `f32` with the functions of the crate micromath: a scalar for the benchmarks only.
//!
//! Its sines have an error of 1e-3 and its square root of 6 %; the benchmarks show the resulting error of the same
//! algorithms.

use core::ops::{Add, Div, Mul, Neg, Sub};
// names in full wherever `std` has a method of the same name, which would take precedence
use super::rates::ValuesAndSlopes;
use super::{EphemerisScalar, EvaluationErrors, SegmentPoint};
use crate::complex::Complex;
use crate::law::series::UNIT;
use crate::phase::Phase;
use crate::scalar::{Extended64, Float, RateNumber, Real, Ring, Scalar, sealed};
use crate::su2::Vector;
use micromath::F32Ext;

/// `f32` whose roots, sines, arctangent and exponential are those of micromath.
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
pub struct Micromath(pub f32);

impl From<Micromath> for f64 {
    fn from(x: Micromath) -> Self {
        x.0.into()
    }
}

impl Add for Micromath {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        Self(self.0 + other.0)
    }
}

impl Sub for Micromath {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        Self(self.0 - other.0)
    }
}

impl Mul for Micromath {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        Self(self.0 * other.0)
    }
}

impl Div for Micromath {
    type Output = Self;
    #[inline]
    fn div(self, other: Self) -> Self {
        Self(self.0 / other.0)
    }
}

impl Neg for Micromath {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl sealed::Sealed for Micromath {}

impl Ring for Micromath {
    const ZERO: Self = Self(0.0);
    const ONE: Self = Self(1.0);
}

impl Scalar for Micromath {
    type Rates = Extended64;
    const ROUNDING: f64 = f32::ROUNDING;

    /// The phase is reduced to half a turn in integers, which micromath cannot do; the sine and cosine are those of
    /// micromath.
    #[inline]
    fn sine_cosine(phase: Phase) -> (Self, Self) {
        let angle =
            (phase.fraction() >> 32) as u32 as i32 as f32 * (core::f32::consts::PI / (1_u32 << 31) as f32);
        let (sine, cosine) = F32Ext::sin_cos(angle);
        (Self(sine), Self(cosine))
    }
}

impl Float for Micromath {
    #[inline]
    fn from_f64(x: f64) -> Self {
        Self(x as f32)
    }
    #[inline]
    fn to_f64(self) -> f64 {
        self.into()
    }
    #[inline]
    fn sqrt(self) -> Self {
        if self.0 > 0.0 { Self(F32Ext::sqrt(self.0)) } else { Self::ZERO }
    }
}

impl Real for Micromath {
    #[inline]
    fn atan2(y: Self, x: Self) -> Self {
        Self(F32Ext::atan2(y.0, x.0))
    }
    #[inline]
    fn exp_minus_one(self) -> Self {
        Self(F32Ext::exp(self.0) - 1.0)
    }
}

/// Evaluation of the crate's tables in `f32` with micromath's sines: four polynomials by Horner's rule and two
/// rotations.
impl EphemerisScalar for Micromath {
    type Coefficient = Self;
    type Segment = [[Self; 4]; 5];
    type Wide = Self;
    type Rate = Self;

    const TERMS: usize = 5;
    const ZERO_SEGMENT: Self::Segment = [[Self(0.0); 4]; 5];
    const CODE: u32 = 0;
    const ERRORS: EvaluationErrors = EvaluationErrors {
        // Measured error caused by micromath's sines.
        tick: 3e-3,
        tick_deviation: 0.0,
        slope: 1.25 * f32::EPSILON as f64,
        place: 1.0 / (1_u64 << 32) as f64,
        rate: 4.0 * f32::EPSILON as f64,
        relative_rate: 16.0 * f32::EPSILON as f64,
        operation: <Self::Rates as RateNumber>::OPERATION_ERROR,
    };

    fn coefficient(value: i64, _: usize) -> (Self, i64) {
        let nearest = value as f32;
        (Self::from_f64(f64::from(nearest) * UNIT), (nearest as i64).saturating_sub(value))
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

    #[inline]
    fn alpha_beta(terms: &[[Self; 4]], point: SegmentPoint) -> [Complex<Self>; 2] {
        values_and_slopes(terms, point.short_x).alpha_beta(point.mirrored, point.slow.map(direction))
    }

    #[inline]
    fn alpha_beta_and_rates(
        terms: &[[Self; 4]],
        point: SegmentPoint,
        level: u32,
        [x, mean, axial]: [Self; 3],
    ) -> ([Complex<Self>; 2], Vector<Self>, i32) {
        let polynomials = values_and_slopes(terms, point.short_x);
        let [a, b] = point.slow.map(direction);
        let parameters = polynomials.alpha_beta(point.mirrored, [a, b]);
        let rates = [x * Self(f32::from(1_u16 << level)), mean, axial];
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
#[inline]
fn direction(phase: u64) -> Complex<Micromath> {
    Complex::cis(Phase::from_fraction(phase))
}

/// Polynomials and their derivatives at x·2^31.
#[inline(always)]
fn values_and_slopes(terms: &[[Micromath; 4]], x: i32) -> ValuesAndSlopes<Micromath> {
    const UNIT: f32 = 1.0 / (1_u32 << 31) as f32;
    ValuesAndSlopes::at(terms.iter().rev().copied(), Micromath(x as f32 * UNIT))
}
