//! `f32` and `f64` as scalars. Transcendental functions come from `libm` on every target, never from `std`.

use super::{Float, Real, Ring, Scalar, sine};

macro_rules! float_scalar {
    ($float:ty, $from_fraction:expr, $sqrt:path, $atan2:path, $exp:path) => {
        impl Ring for $float {
            const ZERO: Self = 0.0;
            const ONE: Self = 1.0;
        }

        impl Scalar for $float {
            const ROUNDING: f64 = <$float>::EPSILON as f64 / 2.0;

            #[inline(always)]
            fn sine_cosine(phase: u64) -> (Self, Self) {
                let [pair] = sine::sine_cosine([phase]);
                pair
            }
            #[inline(always)]
            fn sine_cosine_pair(phases: [u64; 2]) -> [(Self, Self); 2] {
                sine::sine_cosine(phases)
            }
            #[inline(always)]
            fn from_fraction(fraction: i64) -> Self {
                $from_fraction(fraction)
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

/// 24 bits of the upper word are all that `f32` can hold.
const UPPER_WORD: fn(i64) -> f32 = |fraction| ((fraction >> 32) as i32) as f32 * (1.0 / (1_u64 << 31) as f32);
const ALL: fn(i64) -> f64 = |fraction| fraction as f64 * (1.0 / (1_u64 << 63) as f64);

float_scalar!(f32, UPPER_WORD, libm::sqrtf, libm::atan2f, libm::expf);
float_scalar!(f64, ALL, libm::sqrt, libm::atan2, libm::exp);
