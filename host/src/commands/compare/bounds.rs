//! What the core is held to, and over how long: one table.

use crate::cli::Scalar;
use crate::propagate::period;
use toytop::{Motion, Regime};

/// Steps a period. In f64, truncation and rounding of the fourth-order step are equal near 2048 (smooth motions) to 8192
/// (near the separatrix). In f32, rounding alone is left from 512 on, also near the separatrix; as the phases are
/// integers it does not grow with more steps, which only cost time.
pub(super) fn steps_per_period(scalar: Scalar) -> u32 {
    match scalar {
        Scalar::F64 => 4096,
        Scalar::F32 => 512,
    }
}

/// rad over ten periods, away from the separatrix.
fn ordinary(scalar: Scalar) -> f64 {
    match scalar {
        Scalar::F64 => 1e-10,
        Scalar::F32 => 2e-5,
    }
}

/// Below this e₃ - e₂ a motion counts as near the separatrix.
const NEAR: f64 = 1e-2;

/// In f64 the *truth* sets this bound: the full equations amplify their own rounding, and that of their start, by
/// 1/(e₃ - e₂). Measured over 180 motions with e₃ - e₂ from 1e-3 to 1e-12: 4e-15 to 6e-14 over e₃ - e₂.
const TRUTH: f64 = 1e-13;
/// In f32 besides: the same motions, at most 1.1e-4 rad above what is the truth's.
const NEAR_F32: f64 = 2e-4;

/// No orientation is further from another.
const WORST: f64 = 4.0;

/// What the error of the orientation may be, rad; in proportion to the time beyond ten periods. `own` are the bounds (f64,
/// f32) of a motion that has bounds of its own.
pub(super) fn bound(motion: &Motion, scalar: Scalar, periods: u32, own: Option<[f64; 2]>) -> f64 {
    let gap = motion.branch_points().e3_minus_e2;
    let over_ten_periods = match (own, scalar) {
        (Some([bound, _]), Scalar::F64) | (Some([_, bound]), Scalar::F32) => bound,
        (None, _) if motion.regime() != Regime::Nutating || gap >= NEAR => ordinary(scalar),
        (None, Scalar::F64) => ordinary(scalar) + TRUTH / gap,
        (None, Scalar::F32) => NEAR_F32 + TRUTH / gap,
    };
    (over_ten_periods * (f64::from(periods) / 10.0).max(1.0)).min(WORST)
}

/// How long a motion is followed.
pub(super) struct Span {
    /// The nutation period or, where there is none, a natural time of the top, s.
    pub(super) period: f64,
    /// s.
    pub(super) time: f64,
    /// Why it is shorter than what was asked for.
    pub(super) remark: Option<String>,
}

/// The upright position repels the full equations' rounding errors like e^{λt}; they are followed until this factor.
const MOST_AMPLIFIED: f64 = 1e4;

/// `periods` periods. An aperiodic motion is followed until the axis has all but reached the vertical: from there on the
/// full equations, unlike the core, fall back.
pub(super) fn horizon(motion: &Motion, periods: u32) -> Span {
    let period = period(motion);
    let time = period * f64::from(periods);
    let span = Span { period, time, remark: None };
    if motion.regime() != Regime::Aperiodic {
        return span;
    }
    // λ = √(4 A p g - n²)/(2 A)
    let (top, n) = (motion.top(), motion.first_integrals().n);
    let rate = (4.0 * top.a() * top.p() * top.g() - n * n).sqrt() / (2.0 * top.a());
    let sensible = MOST_AMPLIFIED.ln() / rate;
    if sensible >= time {
        return span;
    }
    let remark = format!(
        "followed for {sensible:.3e} s only; from there on the full equations fall away from the vertical"
    );
    Span { time: sensible, remark: Some(remark), ..span }
}
