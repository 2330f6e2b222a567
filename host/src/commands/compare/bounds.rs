//! What the core is held to, and over how long: one table.

use crate::cli::{Method, Scalar};
use crate::input::builtin::OwnBounds;
use crate::motion::propagate::period;
use toytop::{Motion, Regime};

/// Steps a period, in f64 and in every other type. In f64, truncation and rounding of the fourth-order step are equal near 2048
/// (smooth motions) to 8192 (near the separatrix). In f32, rounding alone is left from 512 on, also near the separatrix; as the
/// phases are integers it does not grow with more steps, which only cost time.
pub(super) fn steps_per_period(scalar: Scalar) -> u32 {
    match scalar {
        Scalar::F64 => 4096,
        _ => 512,
    }
}

/// Of the stepper over ten periods, rad. In f32 near the separatrix: 180 motions with e₃ - e₂ from 1e-3 to 1e-12, at most
/// 1.1e-4 rad above what is the truth's. Of micromath, whose square root is 6 % off, nothing can be promised;
/// in fixed point there is no stepper.
fn of_the_stepper(motion: &Motion, scalar: Scalar) -> f64 {
    /// Below this e₃ - e₂ a motion counts as near the separatrix.
    const NEAR: f64 = 1e-2;
    let near = motion.regime() == Regime::Nutating && motion.branch_points().e3_minus_e2 < NEAR;
    match (scalar, near) {
        (Scalar::F64, _) => 1e-10,
        (Scalar::F32, false) => 2e-5,
        (Scalar::F32, true) => 2e-4,
        (Scalar::Micromath | Scalar::Q31 | Scalar::Q15, _) => WORST,
    }
}

/// Of an ephemeris at any time, rad. In f64 it is some 1e-15 (measured against vectors of 30 digits), so that the truth,
/// up to 3e-13 over ten periods of the motions here, sets the bound; in f32 up to 4e-7, in
/// fixed point 9e-9 and 3e-4, with micromath's sines 2.2e-3.
fn of_the_ephemeris(scalar: Scalar) -> f64 {
    match scalar {
        Scalar::F64 => 0.0,
        Scalar::F32 => 5e-7,
        Scalar::Q31 => 2e-8,
        Scalar::Q15 => 5e-4,
        Scalar::Micromath => 1e-2,
    }
}

/// How far the full solver may be off over ten periods, rad. The full equations amplify their own rounding, and that of
/// their start, by 1/(e₃ - e₂), and by the ratio of the greatest to the least inertia. Measured: over the same 180 motions
/// 4e-15 to 6e-14 over e₃ - e₂; with A/(ps) from 100 to 1e-4 up to 3e-13 times the ratio, against the core's stepper at
/// a million steps a period.
fn of_the_truth(motion: &Motion) -> f64 {
    let amplified = match motion.regime() {
        Regime::Nutating => 1e-13 / motion.branch_points().e3_minus_e2,
        // followed until it has grown this much
        Regime::Aperiodic => MOST_AMPLIFIED * f64::EPSILON,
        _ => 0.0,
    };
    let top = motion.top();
    let (a, c) = (top.transverse_inertia(), top.axial_inertia());
    // without axial inertia the axial rate is no result of the integration
    let least = if c > 0.0 { a.min(c) } else { a };
    (amplified + 1e-12) * (a + top.mass_moment() * top.com_height()) / least
}

/// No orientation is further from another.
pub(super) const WORST: f64 = 4.0;

/// What the error of the orientation may be, rad. `own` are the bounds of a motion that has bounds of its own.
///
/// Beyond ten periods the stepper's share grows like the time; the truth's, whose energy drifts, like its square (measured:
/// over 1000 periods 10^3 to 10^4 times as much).
pub(super) fn bound(
    motion: &Motion,
    (method, scalar): (Method, Scalar),
    periods: u32,
    own: Option<OwnBounds>,
) -> f64 {
    let tens = (f64::from(periods) / 10.0).max(1.0);
    let truth = own.map_or_else(|| of_the_truth(motion), |own| own.truth) * tens * tens;
    let core = match method {
        Method::Ephemeris => of_the_ephemeris(scalar),
        _ => own.map_or_else(|| of_the_stepper(motion, scalar), |own| own.stepper(scalar)) * tens,
    };
    (core + truth).min(WORST)
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
    let rate = (4.0 * top.transverse_inertia() * top.mass_moment() * top.gravity() - n * n).sqrt()
        / (2.0 * top.transverse_inertia());
    let sensible = MOST_AMPLIFIED.ln() / rate;
    if sensible >= time {
        return span;
    }
    let remark = format!(
        "followed for {sensible:.3e} s only; from there on the full equations fall away from the vertical"
    );
    Span { time: sensible, remark: Some(remark), ..span }
}
