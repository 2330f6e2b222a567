//! Motion of one launch, its constants, and its partial derivatives.

use crate::input::{toytop_state, toytop_top};
use crate::memory::{Opaque, load, opaque, read, store, write};
use crate::status::{Refusal, status_of, toytop_error, toytop_status};
use core::ffi::c_void;
use toytop::{Complex, Level, Motion, Regime};
use toytop_fit::Sensitivity;

opaque! {
/// Bytes of a motion.
TOYTOP_MOTION_SIZE = 1024;

/// Motion of one launch, from which a table is set up. It may be copied; a program must not use its words.
toytop_motion[128]
}

impl Opaque for Motion {
    const TAG: u32 = 0x746f_706d;
}

/// Regime of a motion.
#[repr(u32)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(clippy::upper_case_acronyms, reason = "constants of C")]
pub enum toytop_regime {
    /// The axis rises and falls between e1 and e2.
    TOYTOP_NUTATING = 0,
    /// The tilt is constant and |l| < |n|: of a fast top, the slower of its two regular precessions.
    TOYTOP_SLOW_PRECESSION = 1,
    /// The tilt is constant and |l| >= |n|: of a fast top, the faster of the two.
    TOYTOP_FAST_PRECESSION = 2,
    /// The axis is upright, and a small push causes a small nutation.
    TOYTOP_SLEEPING_STABLE = 3,
    /// The axis is upright, and any push makes the top fall.
    TOYTOP_SLEEPING_UNSTABLE = 4,
    /// The centre of mass is straight below the tip.
    TOYTOP_HANGING = 5,
    /// The axis leaves the vertical and returns to it, in infinite time.
    TOYTOP_APERIODIC = 6,
    /// The regime has no name in this version.
    TOYTOP_OTHER_REGIME = 7,
}

/// Constants of a motion, by the paper's symbols.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct toytop_constants {
    /// Regime.
    pub regime: toytop_regime,
    /// Vertical angular momentum l, kg m^2/s.
    pub l: f64,
    /// Axial angular momentum n, kg m^2/s.
    pub n: f64,
    /// Energy h, J.
    pub h: f64,
    /// Least cosine of the tilt, e1.
    pub e1: f64,
    /// Greatest cosine of the tilt, e2.
    pub e2: f64,
    /// Third branch point e3 >= 1.
    pub e3: f64,
    /// Nutation period, s; NaN where there is none.
    pub period: f64,
    /// Least force of the plane over the weight; NaN for a fixed tip or a free body. Below 0 a real top would leave the plane.
    pub min_normal_force: f64,
    /// Tilt at which the normal force changes its sign, rad; NaN where it never does. Crossings of it, in any scalar, are the lift-offs.
    pub lift_off_tilt: f64,
}

/// Function of the program that a launch or a set-up calls at least every 50 000 cycles of a Cortex-M4F (80 000 in `f64`, 200 000 of a
/// Cortex-M0+): to feed a watchdog, or to read another table. Null for none.
pub type toytop_pause = Option<unsafe extern "C" fn(context: *mut c_void)>;

/// Call of a pause, if there is one.
///
/// # Safety
/// `pause` may be called with `context`.
pub(crate) unsafe fn call_of(pause: toytop_pause, context: *mut c_void) -> impl FnMut() {
    move || {
        if let Some(pause) = pause {
            // SAFETY: the caller guarantees that it may be called.
            unsafe { pause(context) };
        }
    }
}

/// Motion of a top from a state at t = 0.
///
/// Refusals name a parameter of the top or of the state. `error` may be null.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn toytop_launch(
    top: *const toytop_top,
    state: *const toytop_state,
    motion: *mut toytop_motion,
    error: *mut toytop_error,
) -> toytop_status {
    // SAFETY: the caller guarantees valid pointers.
    unsafe { toytop_launch_with_pauses(top, state, None, core::ptr::null_mut(), motion, error) }
}

/// Motion of a top from a state at t = 0, with pauses for other work.
///
/// It has the refusals of `toytop_launch`.
///
/// * `context`: argument of `pause`
#[unsafe(no_mangle)]
pub unsafe extern "C" fn toytop_launch_with_pauses(
    top: *const toytop_top,
    state: *const toytop_state,
    pause: toytop_pause,
    context: *mut c_void,
    motion: *mut toytop_motion,
    error: *mut toytop_error,
) -> toytop_status {
    // SAFETY: the caller guarantees valid pointers, and that `pause` may be called.
    unsafe {
        status_of(error, || {
            let top = read(top)?.checked()?;
            let state = read(state)?.checked()?;
            store(motion, Motion::launch_with_pauses(&top, &state, &mut call_of(pause, context))?)
        })
    }
}

/// Constants of a motion. The call integrates the period, as a set-up does, so it takes too long for an interrupt.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn toytop_motion_constants(
    motion: *const toytop_motion,
    constants: *mut toytop_constants,
) -> toytop_status {
    let found = |motion: Motion| {
        let integrals = motion.first_integrals();
        let e = motion.branch_points();
        toytop_constants {
            regime: regime(motion.regime()),
            l: integrals.l,
            n: integrals.n,
            h: integrals.h,
            e1: e.e1,
            e2: e.e2,
            e3: e.e3,
            period: motion.period_advance().map_or(f64::NAN, |advance| advance.period),
            min_normal_force: motion.min_normal_force().unwrap_or(f64::NAN),
            lift_off_tilt: Level::lift_off(&motion).map_or(f64::NAN, |level| level.tilt()),
        }
    };
    // SAFETY: the caller guarantees valid pointers.
    unsafe { load(motion).and_then(|motion| write(constants, found(motion))) }.into()
}

fn regime(regime: Regime) -> toytop_regime {
    use toytop_regime::*;
    match regime {
        Regime::Nutating => TOYTOP_NUTATING,
        Regime::SlowPrecession => TOYTOP_SLOW_PRECESSION,
        Regime::FastPrecession => TOYTOP_FAST_PRECESSION,
        Regime::SleepingStable => TOYTOP_SLEEPING_STABLE,
        Regime::SleepingUnstable => TOYTOP_SLEEPING_UNSTABLE,
        Regime::Hanging => TOYTOP_HANGING,
        Regime::Aperiodic => TOYTOP_APERIODIC,
        _ => TOYTOP_OTHER_REGIME,
    }
}

/// Partial derivatives of a motion at one time.
///
/// In each array they are with respect to: the rotation vector in the fixed frame that turns orientation and omega of the launch, rad (0 to
/// 2); omega of the launch in the fixed frame, rad/s (3 to 5); A/C (6); A/(p s), for a fixed tip A/p (7); the height s of the centre of
/// mass (8); gravity (9). Relative to the largest derivative of a column the error is about 1e-10.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct toytop_partials {
    /// Derivatives of the orientation: rotation vectors in the fixed frame, rad.
    pub orientation: [[f64; 3]; 10],
    /// Derivatives of the angular velocity in the fixed frame, rad/s.
    pub omega: [[f64; 3]; 10],
    /// Derivatives of the angular velocity in the body frame, rad/s.
    pub omega_body: [[f64; 3]; 10],
    /// Derivatives of the position of the tip, m; without unit for a fixed tip.
    pub tip: [[f64; 2]; 10],
}

/// Partial derivatives at a time, s from the launch. The call integrates over a nutation period, so it takes too long for an interrupt.
/// `TOYTOP_NONE` where the time is not finite or too far to integrate to, or a derivative is beyond 1e150.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn toytop_motion_partials(
    motion: *const toytop_motion,
    time: f64,
    partials: *mut toytop_partials,
) -> toytop_status {
    let found = |motion: Motion| -> Result<_, Refusal> {
        let now = Sensitivity::new(&motion).at(time).ok_or(toytop_status::TOYTOP_NONE)?;
        Ok(toytop_partials {
            orientation: now.d_orientation(),
            omega: now.d_omega(),
            omega_body: now.d_omega_body(),
            tip: now.d_tip().map(|Complex { re, im }| [re, im]),
        })
    };
    // SAFETY: the caller guarantees valid pointers.
    unsafe { load(motion).and_then(|motion| write(partials, found(motion)?)) }.into()
}
