//! Samples of a motion as tables of chosen columns, written as they are computed.
//!
//! | module | contents |
//! |---|---|
//! | `column` | quantities of a sample |
//! | [`angles`] | Euler angles of an orientation |
//! | `sheet` | rows as CSV, JSON or an aligned table |
//! | `stream` | blocks of rows, computed on all cores and written in order |

pub mod angles;
pub mod column;
#[cfg(feature = "program")]
pub mod sheet;
#[cfg(feature = "program")]
pub mod stream;

/// Times from 0 to `horizon`, s: one in each of `count` equal parts, at a place in its part that is a multiple of the golden section
/// modulo 1.
#[cfg(feature = "program")]
pub(crate) fn spread_times(horizon: f64, count: u32) -> Vec<f64> {
    const GOLDEN_SECTION: f64 = 0.618_033_988_749_894_9;
    let part = horizon / f64::from(count);
    (0..count).map(|i| part * (f64::from(i) + (f64::from(i) * GOLDEN_SECTION).fract())).collect()
}
