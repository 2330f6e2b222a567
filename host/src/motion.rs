//! Motion at given times by the core's ephemeris, its stepper or the full equations, and quantities of a motion.
//!
//! | module | contents |
//! |---|---|
//! | [`Scalar`] | scalar types of the core |
//! | [`sample`] | motion at one time |
//! | [`euler_angles`], [`mod@column`] | quantities of a sample |
//! | [`errors`] | errors of samples, and drifts of the first integrals |
//! | [`ephemeris`] | ephemeris in the smallest table that fits |
//! | [`tip_angle`] | tip angle of an ephemeris, continued from t = 0 |
//! | [`stepper`] | stepper at given times |
//! | [`full_solver`] | integration of the full 3-D equations |

pub mod sample;

pub mod euler_angles;

pub mod column;

pub mod errors;

pub mod ephemeris;
pub mod tip_angle;

pub mod stepper;

pub mod full_solver;

pub use toytop_model::constants::{regime, tilts};
pub use toytop_model::timed_motion::TimedMotion;

use toytop_model::constants::{Constant, Value};

/// Scalar types of the core.
#[derive(Clone, Copy, PartialEq)]
#[cfg_attr(feature = "program", derive(clap::ValueEnum))]
pub enum Scalar {
    /// Double precision
    F64,
    /// Single precision
    F32,
    /// Fixed point of 32 bits
    Q31,
    /// Fixed point of 16 bits
    Q15,
}

impl Scalar {
    /// All scalar types.
    pub const ALL: [Self; 4] = [Self::F64, Self::F32, Self::Q31, Self::Q15];

    /// Name on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::F64 => "f64",
            Self::F32 => "f32",
            Self::Q31 => "q31",
            Self::Q15 => "q15",
        }
    }
}

/// Times in [0, `end`], s: one in each of `count` equal parts, shifted within the part by multiples of the golden section.
pub fn spread_times(end: f64, count: u32) -> Vec<f64> {
    const GOLDEN_SECTION: f64 = 0.618_033_988_749_894_9;
    let part = end / f64::from(count);
    (0..count).map(|i| part * (f64::from(i) + (f64::from(i) * GOLDEN_SECTION).fract())).collect()
}

/// Value of a constant in JSON; null where the motion does not have it.
pub fn constant_as_json(constant: &Constant, motion: &TimedMotion) -> serde_json::Value {
    match constant.value {
        Value::Number(value) => value(motion).into(),
        Value::Word(value) => value(motion).into(),
    }
}
