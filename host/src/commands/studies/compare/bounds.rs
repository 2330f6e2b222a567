//! Bounds on the errors of the core, and the times over which it is compared, in one place.

use crate::commands::options::Method;
use crate::motion::Scalar;
use crate::motion::propagate::period;
use toytop::{Motion, Regime};

/// Bounds on the errors of the full solver, and of the stepper in f32, of a built-in motion over ten periods, rad, in place of those of any
/// motion. In f64 the bound of the full solver is the larger one. The measured errors are 1.7e-11 and 5e-6 rad for the first motion,
/// 4.1e-9 and 1.6e-5 rad for the second.
pub fn own_bounds(name: &str) -> Option<[f64; 2]> {
    match name {
        "near separatrix 1e-3" => Some([1e-10, 2e-5]),
        "near separatrix 1e-6" => Some([1e-8, 5e-5]),
        _ => None,
    }
}

/// Steps in a period, in f64 and in every other type. In f64, truncation and rounding of the fourth-order step are equal at about
/// 2048 steps (smooth motions) to 8192 steps (near the separatrix). In f32, the error from 512 steps on is rounding alone, also near
/// the separatrix; because the phases are integers, it does not grow with more steps, which only take time.
pub fn steps_per_period(scalar: Scalar) -> u32 {
    match scalar {
        Scalar::F64 => 4096,
        _ => 512,
    }
}

/// Bound on the error of the stepper over ten periods, rad. In f32 near the separatrix, 180 motions with e₃ - e₂ from 1e-3 to 1e-12
/// have errors of at most 1.1e-4 rad beyond the bound of the reference.
fn of_the_stepper(motion: &Motion, scalar: Scalar) -> f64 {
    /// Upper limit of e₃ - e₂ for motions that count as near the separatrix.
    const NEAR: f64 = 1e-2;
    let near = motion.regime() == Regime::Nutating && motion.branch_points().e3_minus_e2 < NEAR;
    match scalar {
        Scalar::F64 => 1e-10,
        _ if near => 2e-4,
        _ => 2e-5,
    }
}

/// Bound on the error of an ephemeris at any time, rad. In f64 the error is some 1e-15 (measured against vectors of 30 digits), and
/// the error of the reference, up to 3e-13 over ten periods of the motions here, determines the bound. In f32 the error is up to 4e-7, in
/// fixed point 9e-9 and 3e-4. The bound that the table states counts too.
fn of_the_ephemeris(scalar: Scalar) -> f64 {
    match scalar {
        Scalar::F64 => 1e-13,
        Scalar::F32 => 5e-7,
        Scalar::Q31 => 2e-8,
        _ => 5e-4,
    }
}

/// Bound on the error of the full solver over ten periods, rad. The full equations amplify their own rounding, and that of their
/// initial state, by 1/(e₃ - e₂) and by the ratio of the greatest to the least inertia. Measured against the core's stepper at a million
/// steps in a period, the error of the same 180 motions is 4e-15/(e₃ - e₂) to 6e-14/(e₃ - e₂); with A/(ps) from 100 to 1e-4 it is up to
/// 3e-13 times the ratio.
fn of_the_full_solver(motion: &Motion) -> f64 {
    let amplified = match motion.regime() {
        Regime::Nutating => 1e-13 / motion.branch_points().e3_minus_e2,
        // the motion is followed until the error has grown by this factor
        Regime::Aperiodic => MOST_AMPLIFIED * f64::EPSILON,
        _ => 0.0,
    };
    let top = motion.top();
    let (a, c) = (top.transverse_inertia(), top.axial_inertia());
    // without axial inertia the integration does not compute the axial rate
    let least = if c > 0.0 { a.min(c) } else { a };
    (amplified + 1e-12) * (a + top.mass_moment() * top.com_height()) / least
}

/// Upper bound on the distance of two orientations, rad.
const WORST: f64 = 4.0;

/// Bound on the error of the orientation, rad; `None` where the bound exceeds the greatest distance of two orientations.
///
/// * `own`: bounds of a built-in motion that has bounds of its own
/// * `table`: bound that a table states
///
/// Beyond ten periods the bound of the stepper grows in proportion to time, and that of the reference, whose energy drifts, with the
/// square of time (measured: over 1000 periods the error is 10^3 to 10^4 times as large).
pub fn bound(
    motion: &Motion,
    (method, scalar): (Method, Scalar),
    periods: u32,
    own: Option<[f64; 2]>,
    table: Option<f64>,
) -> Option<f64> {
    let tens = (f64::from(periods) / 10.0).max(1.0);
    let solver = own.map_or_else(|| of_the_full_solver(motion), |[solver, _]| solver) * tens * tens;
    let core = match (method, own, scalar) {
        (Method::Ephemeris, ..) => {
            table.map_or(of_the_ephemeris(scalar), |table| of_the_ephemeris(scalar).min(table))
        }
        (_, Some(_), Scalar::F64) => 0.0,
        (_, Some([_, stepper]), _) => stepper * tens,
        (_, None, _) => of_the_stepper(motion, scalar) * tens,
    };
    Some(core + solver).filter(|bound| *bound < WORST)
}

/// Greatest growth of rounding errors. Near the upright position the errors of the full equations grow like e^{λt}; the comparison ends
/// when they have grown by this factor.
const MOST_AMPLIFIED: f64 = 1e4;

/// Time of `periods` periods, s, or a shorter one with the reason. For an aperiodic motion the time ends shortly before the axis reaches
/// the vertical, because from there the solution of the full equations, unlike that of the core, falls again.
pub fn horizon(motion: &Motion, periods: u32) -> (f64, Option<String>) {
    let time = period(motion) * f64::from(periods);
    if motion.regime() != Regime::Aperiodic {
        return (time, None);
    }
    // λ = √(4 A p g - n²)/(2 A)
    let (top, n) = (motion.top(), motion.first_integrals().n);
    let rate = (4.0 * top.transverse_inertia() * top.mass_moment() * top.gravity() - n * n).sqrt()
        / (2.0 * top.transverse_inertia());
    let sensible = MOST_AMPLIFIED.ln() / rate;
    let remark = || {
        format!(
            "followed for {sensible:.3e} s only; from there on the full equations fall away from the vertical"
        )
    };
    (sensible.min(time), (sensible < time).then(remark))
}
