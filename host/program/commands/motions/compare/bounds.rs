//! Bounds on the errors of the core, the verdict by a bound, and the time over which the core is compared.

use serde::Serialize;
use toytop::{Motion, Regime};
use toytop_host::motion::Scalar;
use toytop_model::motion_with_period::MotionWithPeriod;

/// Steps in a period. In f64 the truncation of a step equals its rounding between 2048 and 8192 steps; in f32 it is below the rounding
/// from 512 steps on.
pub fn steps_per_period(scalar: Scalar) -> u32 {
    match scalar {
        Scalar::F64 => 4096,
        _ => 512,
    }
}

/// Growth of the errors of steps with time, as a factor from ten periods on.
fn growth(periods: u32) -> f64 {
    (f64::from(periods) / 10.0).max(1.0)
}

/// Bound on the error of the stepper, rad, which grows with time. Near the separatrix the error in f32 over ten periods was at most 1.1e-4
/// rad in 180 motions.
pub fn stepper_bound(motion: &Motion, scalar: Scalar, periods: u32) -> f64 {
    /// Upper limit of e₃ - e₂ for motions that count as near the separatrix.
    const NEAR: f64 = 1e-2;
    let near = motion.regime() == Regime::Nutating && motion.branch_points().e3_minus_e2 < NEAR;
    let over_ten_periods = match scalar {
        Scalar::F64 => 1e-10,
        _ if near => 2e-4,
        _ => 2e-5,
    };
    over_ten_periods * growth(periods)
}

/// Bound on the error of the full solver over ten periods, rad. The full equations amplify rounding by 1/(e₃ - e₂) and by the ratio of the
/// greatest to the least inertia: in 180 motions the error was at most 6e-14/(e₃ - e₂), and with A/(ps) down to 1e-4 at most 3e-13 times
/// the ratio.
fn full_solver_bound(motion: &Motion) -> f64 {
    let amplified = match motion.regime() {
        Regime::Nutating => 1e-13 / motion.branch_points().e3_minus_e2,
        // the motion is followed until the error has grown by this factor
        Regime::Aperiodic => MAX_GROWTH * f64::EPSILON,
        _ => 0.0,
    };
    let top = motion.top();
    let (a, c) = (top.transverse_inertia(), top.axial_inertia());
    // without axial inertia the integration does not compute the axial rate
    let least = if c > 0.0 { a.min(c) } else { a };
    (amplified + 1e-12) * (a + top.mass_moment() * top.com_height()) / least
}

/// Upper bound on the distance of two orientations, rad.
const MAX_DISTANCE: f64 = 4.0;

/// Bound on the difference of the core and the full solver, rad; `None` where it exceeds the greatest distance of two orientations.
///
/// * `core`: bound on the error of the core, rad
///
/// Beyond ten periods the bound of the full solver, whose energy drifts, grows with the square of time.
pub fn bound(motion: &Motion, periods: u32, core: f64) -> Option<f64> {
    let solver = full_solver_bound(motion) * growth(periods) * growth(periods);
    Some(core + solver).filter(|bound| *bound < MAX_DISTANCE)
}

/// Greatest growth of rounding errors near the upright position, where the full equations amplify them by e^{λt}; the comparison ends there.
const MAX_GROWTH: f64 = 1e4;

/// Time of `periods` periods, s, or a shorter one with the reason: an aperiodic motion is followed until shortly before the axis reaches
/// the vertical, from where the solution of the full equations falls again.
pub fn compared_time(motion: &MotionWithPeriod, periods: u32) -> (f64, Option<String>) {
    let time = motion.characteristic_time() * f64::from(periods);
    if motion.regime() != Regime::Aperiodic {
        return (time, None);
    }
    // λ = √(4 A p g - n²)/(2 A)
    let (top, n) = (motion.top(), motion.first_integrals().n);
    let rate = (4.0 * top.transverse_inertia() * top.mass_moment() * top.gravity() - n * n).sqrt()
        / (2.0 * top.transverse_inertia());
    let sensible = MAX_GROWTH.ln() / rate;
    let remark = || {
        format!(
            "followed for {sensible:.3e} s only; from there on the full equations fall away from the vertical"
        )
    };
    (sensible.min(time), (sensible < time).then(remark))
}

/// Verdict on an error, from the best to the worst.
#[derive(Clone, Copy, Default, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(into = "&'static str")]
pub enum Verdict {
    /// Error within its bound.
    #[default]
    Kept,
    /// Error without a bound.
    Unbounded,
    /// No table: none is large enough, or the motion is aperiodic and the scalar is not `f64`.
    NoTable,
    /// Error beyond its bound.
    Missed,
}

impl Verdict {
    /// Verdict on an error, if there is one, by its bound.
    pub fn new(error: Option<f64>, bound: Option<f64>) -> Self {
        match (error, bound) {
            (None, _) => Self::NoTable,
            (_, None) => Self::Unbounded,
            (Some(error), Some(bound)) if error <= bound => Self::Kept,
            _ => Self::Missed,
        }
    }
}

/// Word of the output.
impl From<Verdict> for &'static str {
    fn from(verdict: Verdict) -> Self {
        match verdict {
            Verdict::Kept => "ok",
            Verdict::Unbounded => "no bound",
            Verdict::NoTable => "no table",
            Verdict::Missed => "MISS",
        }
    }
}
