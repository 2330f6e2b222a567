//! Tables in `f32`: coefficients and sums in integers of 32 bits, with results in `f32`.

use crate::scalar::{Q30, Wide, short_sine_cosine_q31};
use crate::table::evaluation::i32::{ERRORS_Q30, UNIT_Q30};
use crate::table::evaluation::{TableScalar, TickErrors};

impl TableScalar for f32 {
    type Coefficient = i32;
    type Segment = [[i32; 4]; 5];
    type Quantity = Self;
    type SetUpFloat = Wide<1>;

    const ROUNDING: f64 = f32::EPSILON as f64 / 2.0;
    const CODE: u32 = 32;
    const TERMS: usize = 5;
    const ZERO_SEGMENT: Self::Segment = [[0; 4]; 5];
    /// Errors with sines to 26 bits and results in `f32`.
    const ERRORS: TickErrors =
        TickErrors { orientation: (15.2 + 2.83 * 12.5) * UNIT_Q30 + f32::EPSILON as f64, ..ERRORS_Q30 };

    #[inline]
    fn from_component(number: Q30) -> Self {
        number.into()
    }

    #[inline]
    fn to_quantity(number: Q30) -> f32 {
        number.into()
    }

    #[inline(always)]
    fn sine_cosine(phase: u64) -> [i32; 2] {
        short_sine_cosine_q31((phase >> 32) as u32).into()
    }
}
