//! `f32` and `f64` as scalars. Transcendental functions come from `libm` on every target, never from `std`.

use super::{Float, Real, Ring, Scalar, sine};
use crate::turns::Turns;

macro_rules! float_scalar {
    ($float:ty, $sqrt:path, $atan2:path, $exp:path) => {
        impl Ring for $float {
            const ZERO: Self = 0.0;
            const ONE: Self = 1.0;
        }

        impl Scalar for $float {
            #[inline]
            fn sine_cosine(phase: Turns) -> (Self, Self) {
                sine::sine_cosine(phase)
            }
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
        }

        impl Real for $float {
            #[inline]
            fn atan2(y: Self, x: Self) -> Self {
                $atan2(y, x)
            }
            #[inline]
            fn exp(self) -> Self {
                $exp(self)
            }
        }
    };
}

float_scalar!(f32, libm::sqrtf, libm::atan2f, libm::expf);
float_scalar!(f64, libm::sqrt, libm::atan2, libm::exp);
