//! `f32` with the functions of the crate micromath: the rival that a maker of firmware without an FPU would take.
//!
//! Its sines are good to 1e-3, its square root to 6 %: what the same algorithms make of that is the comparison. (The program
//! `cost` compiles this file for the chips, so nothing here needs `std`.)

use core::ops::{Add, Div, Mul, Neg, Sub};
// in full wherever `std` has a method of the same name, which would go before
use micromath::F32Ext;
use toytop::real::{Float, Real, Ring, Scalar};
use toytop::{Complex, Place, Tabular, Turns};

/// An `f32`; roots, sines, arctangent and exponential are micromath's.
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

impl Ring for Micromath {
    const ZERO: Self = Self(0.0);
    const ONE: Self = Self(1.0);
}

impl Scalar for Micromath {
    const ROUNDING: f64 = f32::ROUNDING;

    /// The phase is brought to half a turn in integers, which micromath cannot do; the rest is its own.
    #[inline]
    fn sine_cosine(phase: Turns) -> (Self, Self) {
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
    fn exp(self) -> Self {
        Self(F32Ext::exp(self.0))
    }
    #[inline]
    fn exp_minus_one(self) -> Self {
        Self(F32Ext::exp(self.0) - 1.0)
    }
}

/// The crate's tables as one would read them with such a library: four Horner sums and two rotations in `f32`.
impl Tabular for Micromath {
    type Coefficient = Self;
    type Wide = Self;

    const NOTHING: Self = Self(0.0);
    /// What micromath's sines leave: measured, as all of its errors.
    const TICK_ERROR: f64 = 3e-3;
    const PLACE_ROUNDING: f64 = f32::EPSILON as f64;

    fn coefficient(value: f64, _: usize) -> Self {
        Self::from_f64(value)
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

    #[inline]
    fn alpha_beta(terms: &[[Self; 4]], place: Place) -> [Complex<Self>; 2] {
        let x = Self(place.short_x as f32 * (1.0 / (1_u32 << 31) as f32));
        let sums = terms.iter().rev().fold([Self::ZERO; 4], |mut sums, coefficients| {
            for (sum, &c) in sums.iter_mut().zip(coefficients) {
                *sum = *sum * x + c;
            }
            sums
        });
        let [re_alpha, im_alpha, re_beta, im_beta] = sums;
        let sign = |y: Self| if place.mirrored { -y } else { y };
        let [a, b] = place.slow.map(|phase| Complex::cis(Turns::from_bits(i128::from(phase) << 32)));
        [Complex::new(re_alpha, sign(im_alpha)) * a, Complex::new(re_beta, sign(im_beta)) * b]
    }

    #[inline]
    fn tip(product: Complex<Self>, scale: Self) -> Complex<Self> {
        product.scaled(scale)
    }
}
