//! `f32` and `f64` as scalars. Transcendental functions come from `libm` on every target, never from `std`.

use crate::phase::Phase;
use crate::scalar::{Float, Real, Ring, Scalar, sine};

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
        sine::sine_cosine_of_phase(phase)
    }
}
