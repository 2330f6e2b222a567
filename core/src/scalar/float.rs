//! `f32` and `f64` as scalars. Transcendental functions come from `libm` on every target, never from `std`.

use crate::phase::Phase;
use crate::scalar::{Extended, Float, Real, Ring, Scalar, sine};

macro_rules! float_scalar {
    ($float:ty, $sqrt:path, $atan2:path, $exp_minus_one:path) => {
        impl Ring for $float {
            const ZERO: Self = 0.0;
            const ONE: Self = 1.0;
        }

        impl Float for $float {
            #[inline]
            fn from_f64(x: f64) -> Self {
                x as Self
            }
            #[inline]
            fn to_f64(self) -> f64 {
                self.into()
            }
            #[inline]
            fn sqrt(self) -> Self {
                if self > 0.0 { $sqrt(self) } else { 0.0 }
            }
            #[inline]
            fn abs(self) -> Self {
                // clears the sign bit, where a soft comparison would cost a call
                <$float>::abs(self)
            }
        }

        impl Real for $float {
            #[inline]
            fn atan2(y: Self, x: Self) -> Self {
                $atan2(y, x)
            }
            #[inline]
            fn exp_minus_one(self) -> Self {
                $exp_minus_one(self)
            }
        }
    };
}

float_scalar!(f32, libm::sqrtf, libm::atan2f, libm::expm1f);
float_scalar!(f64, libm::sqrt, libm::atan2, libm::expm1);

impl Scalar for f32 {
    const ROUNDING: f64 = f32::EPSILON as f64 / 2.0;

    #[inline]
    fn sine_cosine(phase: Phase) -> (Self, Self) {
        const UNIT: f32 = 1.0 / (1_u64 << 31) as f32;
        let (sine, cosine) = sine::sine_cosine_q31((phase.fraction() >> 32) as u32);
        (sine as f32 * UNIT, cosine as f32 * UNIT)
    }
}

impl Scalar for f64 {
    const ROUNDING: f64 = f64::EPSILON / 2.0;

    fn sine_cosine(phase: Phase) -> (Self, Self) {
        let (quadrant, rest) = phase.quadrant();
        sine::quarter_turns(quadrant, rest.to_f64())
    }
}

/// (sin x, cos x) for an angle of x rad up to 1e6. The error is below 4e-16, relative to the result near its zeros. Those of libm would
/// take several kilobytes of flash.
pub(crate) fn sine_cosine_of_radians(x: f64) -> (f64, f64) {
    if x.abs() < core::f64::consts::FRAC_PI_4 {
        return sine::quarter_turns(0, x * (0.5 * core::f64::consts::FRAC_1_PI));
    }
    f64::sine_cosine(Extended::from(x).in_turns().to_phase())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The error is relative to the result also near the zeros, and for the largest angles.
    #[test]
    fn sines_of_radians_are_those_of_libm() {
        let mut worst = 0.0_f64;
        for k in 1..if cfg!(miri) { 100 } else { 20_000 } {
            let x = 1e6 * libm::exp(-0.002_77 * f64::from(k)) * if k % 2 == 0 { 1.0 } else { -1.0 };
            let (sine, cosine) = sine_cosine_of_radians(x);
            let (true_sine, true_cosine) = libm::sincos(x);
            worst = worst.max((sine / true_sine - 1.0).abs()).max((cosine / true_cosine - 1.0).abs());
        }
        assert!(worst < 4e-16 && worst > 2e-16, "{worst:e}");
        assert_eq!(sine_cosine_of_radians(0.0), (0.0, 1.0));
        assert_eq!(sine_cosine_of_radians(core::f64::consts::PI).1, -1.0);
    }
}
