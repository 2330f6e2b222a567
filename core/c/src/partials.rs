//! Partial derivatives of a motion.

use crate::memory::{kept, write};
use crate::motion::toytop_motion;
use crate::status::{Refusal, toytop_status};
use toytop::Motion;
use toytop_fit::Sensitivity;

/// Partial derivatives of a motion at one time.
///
/// In each array they are with respect to: the rotation vector in the fixed frame that turns the orientation of the launch, rad (0 to
/// 2); omega of the launch in the fixed frame, rad/s (3 to 5); A/C (6); A/(p s), for a fixed tip A/p (7); the height s of the centre of
/// mass (8); gravity (9). Relative to the largest derivative of a column the error is about 1e-12.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct toytop_partials {
    /// Derivatives of the orientation: rotation vectors in the fixed frame, rad.
    pub orientation: [[f64; 3]; 10],
    /// Derivatives of the angular velocity in the fixed frame, rad/s.
    pub omega: [[f64; 3]; 10],
    /// Derivatives of the angular velocity in the body frame, rad/s.
    pub omega_body: [[f64; 3]; 10],
    /// Derivatives of the position of the tip, m; 1 for a fixed tip.
    pub tip: [[f64; 2]; 10],
}

/// Partial derivatives at a time, s from the launch. The call integrates over a nutation period, so it takes too long for an interrupt.
/// `TOYTOP_NONE` where the time is not finite, or a derivative is beyond 1e150.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn toytop_motion_partials(
    motion: *const toytop_motion,
    time: f64,
    partials: *mut toytop_partials,
) -> toytop_status {
    let result = || -> Result<(), Refusal> {
        // SAFETY: the caller guarantees valid pointers, here and below.
        let motion: Motion = unsafe { kept(motion)? };
        let now = Sensitivity::new(&motion).at(time).ok_or(toytop_status::TOYTOP_NONE)?;
        let found = toytop_partials {
            orientation: now.orientation(),
            omega: now.omega(),
            omega_body: now.omega_body(),
            tip: now.tip().map(|tip| [tip.re, tip.im]),
        };
        // SAFETY: see above.
        unsafe { write(partials, found) }
    };
    result().into()
}
