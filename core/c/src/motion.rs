//! Motion of one launch, and its constants.

use crate::launch::{toytop_state, toytop_top};
use crate::memory::{Kept, keep, kept, read, write};
use crate::status::{Refusal, status_of, toytop_error, toytop_status};
use toytop::{Motion, Regime};

/// Bytes of a motion.
pub const TOYTOP_MOTION_SIZE: usize = 1024;

/// Motion of one launch, from which a table is set up. It may be copied; a program must not use its words.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct toytop_motion {
    opaque: [u64; 128],
}

// cbindgen accepts only a number as a length
const _: () = assert!(size_of::<toytop_motion>() == TOYTOP_MOTION_SIZE);

impl Kept for Motion {
    const TAG: u32 = 0x746f_706d;
}

/// Regime of a motion.
#[repr(u32)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(clippy::upper_case_acronyms, reason = "constants of C")]
pub enum toytop_regime {
    /// The axis rises and falls between e1 and e2.
    TOYTOP_NUTATING = 0,
    /// The tilt is constant: the slower of the two regular precessions at this tilt and spin.
    TOYTOP_SLOW_PRECESSION = 1,
    /// The tilt is constant: the faster of the two.
    TOYTOP_FAST_PRECESSION = 2,
    /// The axis is upright, and a small push causes a small nutation.
    TOYTOP_SLEEPING_STABLE = 3,
    /// The axis is upright, and any push makes the top fall.
    TOYTOP_SLEEPING_UNSTABLE = 4,
    /// The centre of mass is straight below the tip.
    TOYTOP_HANGING = 5,
    /// The axis rises to the vertical in infinite time.
    TOYTOP_APERIODIC = 6,
    /// The regime has no name in this version.
    TOYTOP_OTHER_REGIME = 7,
}

/// Constants of a motion, by the paper's symbols.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct toytop_constants {
    /// Regime, a `toytop_regime`.
    pub regime: u32,
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
    let result = || -> Result<(), Refusal> {
        // SAFETY: the caller guarantees valid pointers, here and below.
        let (top, state) = unsafe { (read(top)?.checked()?, read(state)?.checked()?) };
        let launched = Motion::launch(&top, &state)?;
        // SAFETY: see above.
        unsafe { keep(motion, launched) }
    };
    // SAFETY: see above.
    unsafe { status_of(result(), error) }
}

/// Constants of a motion. The call integrates the period, as a set-up does, so it takes too long for an interrupt.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn toytop_motion_constants(
    motion: *const toytop_motion,
    constants: *mut toytop_constants,
) -> toytop_status {
    let result = || -> Result<(), Refusal> {
        // SAFETY: the caller guarantees valid pointers, here and below.
        let motion: Motion = unsafe { kept(motion)? };
        let (integrals, e) = (motion.first_integrals(), motion.branch_points());
        let found = toytop_constants {
            regime: regime(motion.regime()) as u32,
            l: integrals.l,
            n: integrals.n,
            h: integrals.h,
            e1: e.e1,
            e2: e.e2,
            e3: e.e3,
            period: motion.period_advance().map_or(f64::NAN, |advance| advance.period),
            min_normal_force: motion.min_normal_force().unwrap_or(f64::NAN),
        };
        // SAFETY: see above.
        unsafe { write(constants, found) }
    };
    result().into()
}

fn regime(regime: Regime) -> toytop_regime {
    match regime {
        Regime::Nutating => toytop_regime::TOYTOP_NUTATING,
        Regime::SlowPrecession => toytop_regime::TOYTOP_SLOW_PRECESSION,
        Regime::FastPrecession => toytop_regime::TOYTOP_FAST_PRECESSION,
        Regime::SleepingStable => toytop_regime::TOYTOP_SLEEPING_STABLE,
        Regime::SleepingUnstable => toytop_regime::TOYTOP_SLEEPING_UNSTABLE,
        Regime::Hanging => toytop_regime::TOYTOP_HANGING,
        Regime::Aperiodic => toytop_regime::TOYTOP_APERIODIC,
        _ => toytop_regime::TOYTOP_OTHER_REGIME,
    }
}
