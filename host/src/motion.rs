//! Motion at given times by the core's table, its stepper or the full equations, and quantities of a motion.
//!
//! | module | contents |
//! |---|---|
//! | [`Scalar`] | scalar types of the core |
//! | [`times`] | times within reach, spread over an interval, and their order for a method that steps |
//! | [`sample`] | motion at one time |
//! | [`euler_angles`], [`mod@column`] | quantities of a sample |
//! | [`errors`] | errors of samples, and drifts of the first integrals |
//! | [`evaluator`] | smallest table that fits, or the closed form of an aperiodic motion |
//! | [`tip_angle`] | tip angle of a table, continued from t = 0 |
//! | [`stepper`] | stepper at given times |
//! | [`full_solver`] | integration of the full 3-D equations |

pub mod times;

pub mod sample;

pub mod euler_angles;

pub mod column;

pub mod errors;

pub mod evaluator;
pub mod tip_angle;

pub mod stepper;

pub mod full_solver;

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
