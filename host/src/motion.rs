//! Motion by the core: its propagators at given times, and quantities of a motion.
//!
//! | module | contents |
//! |---|---|
//! | [`propagate`] | stepper at given times |
//! | [`ephemeris`] | ephemeris in the smallest table that fits |
//! | [`tip_angle`] | tip angle of an ephemeris, continued from t = 0 |
//! | [`invariants`] | l, n, h from orientation and angular velocity, without the core's formulas |
//! | [`Scalar`] | scalar types of the core |

pub mod ephemeris;
pub mod invariants;
pub mod propagate;
pub mod tip_angle;

use toytop::{Complex, Motion, Regime};

/// Complex number in `f64`, each part by `to_f64`.
pub fn widened<R>(z: Complex<R>, to_f64: impl Fn(R) -> f64) -> Complex<f64> {
    Complex { re: to_f64(z.re), im: to_f64(z.im) }
}

/// Greater of two errors; infinite where the second is no number.
pub fn greater(a: f64, b: f64) -> f64 {
    if b.is_nan() { f64::INFINITY } else { a.max(b) }
}

/// Least and greatest tilt of the axis, degrees.
pub fn tilts(motion: &Motion) -> [f64; 2] {
    let e = motion.branch_points();
    let tilt =
        |one_plus_e: f64, one_minus_e: f64| 2.0 * one_minus_e.sqrt().atan2(one_plus_e.sqrt()).to_degrees();
    match motion.regime() {
        Regime::Hanging => [180.0; 2],
        regime if regime.is_vertical() => [0.0; 2],
        _ => [tilt(2.0 - e.one_minus_e2, e.one_minus_e2), tilt(e.one_plus_e1, 2.0 - e.one_plus_e1)],
    }
}

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
