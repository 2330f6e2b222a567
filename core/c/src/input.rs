//! Top and state, the input of a launch.

use crate::memory::{read, write};
use crate::status::{Refusal, status_of, toytop_error, toytop_status};
use toytop::{Complex, Orientation, ParameterError, PointImpulse, Release, State, Top, TopParameters};

/// Support of a tip that slides on a horizontal plane without friction: Springborn's toy top.
pub const TOYTOP_SLIDING: u32 = 0;
/// Support of a tip that is held at a point: the Lagrange top.
pub const TOYTOP_FIXED: u32 = 1;

/// No support: a body that is thrown, floats or is in orbit.
pub const TOYTOP_FREE: u32 = 2;

/// Standard gravity, m/s^2.
pub const TOYTOP_STANDARD_GRAVITY: f64 = 9.80665;

/// Top, in SI or any consistent units. Exactly one of `mass` and `mass_moment` is given; the other is 0. For a free body only the
/// two moments of inertia and the rotor enter the motion; the other fields must be finite, and have no effect.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct toytop_top {
    /// Support of the tip: `TOYTOP_SLIDING`, `TOYTOP_FIXED` or `TOYTOP_FREE`.
    pub support: u32,
    /// Transverse moment of inertia A, kg m^2: about the tip for a fixed one, otherwise about the centre of mass.
    pub transverse_inertia: f64,
    /// Axial moment of inertia C <= 2A, kg m^2; 0 is a thin rod.
    pub axial_inertia: f64,
    /// Distance s of the centre of mass from the tip, m; for a fixed tip it is used only together with `mass`.
    pub com_height: f64,
    /// Mass M, kg, or 0.
    pub mass: f64,
    /// Mass moment p = M s, kg m, or 0.
    pub mass_moment: f64,
    /// Gravity g, m/s^2: `TOYTOP_STANDARD_GRAVITY`, or 1 in the units of the paper; 0 only for a fixed tip or a free body.
    pub gravity: f64,
    /// Angular momentum K of a rotor inside, relative to the body and along its axis, kg m^2/s, of either sign and constant; 0
    /// without one. The body's mass and inertia include the rotor's.
    pub rotor_momentum: f64,
}

/// Release of a top by angles and rates.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct toytop_release {
    /// Tilt of the axis from the upward vertical, rad, between 0 and pi.
    pub tilt: f64,
    /// Direction in which the axis leans, rad, from the first fixed axis.
    pub azimuth: f64,
    /// Rotation of the body about its axis, rad.
    pub roll: f64,
    /// Whole axial component of the angular velocity, rad/s, precession included.
    pub spin: f64,
    /// Rate of the azimuth, rad/s.
    pub precession: f64,
    /// Rate of the tilt, rad/s.
    pub nutation: f64,
}

/// State: orientation and angular velocity at one instant.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct toytop_state {
    /// Cayley-Klein parameter alpha, {re, im}.
    pub alpha: [f64; 2],
    /// Cayley-Klein parameter beta, {re, im}; |alpha|^2 + |beta|^2 = 1 to within 1e-6.
    pub beta: [f64; 2],
    /// Angular velocity in the fixed frame, rad/s.
    pub omega: [f64; 3],
}

impl toytop_top {
    pub(crate) fn checked(&self) -> Result<Top, Refusal> {
        let parameters = TopParameters {
            transverse_inertia: self.transverse_inertia,
            axial_inertia: self.axial_inertia,
            com_height: self.com_height,
            mass: self.mass,
            mass_moment: self.mass_moment,
            gravity: self.gravity,
            rotor_momentum: self.rotor_momentum,
        };
        Ok(match self.support {
            TOYTOP_SLIDING => Top::sliding(&parameters)?,
            TOYTOP_FIXED => Top::fixed(&parameters)?,
            TOYTOP_FREE => Top::free(&parameters)?,
            _ => {
                let allowed = "TOYTOP_SLIDING, TOYTOP_FIXED or TOYTOP_FREE";
                return Err(ParameterError::new("support", allowed).into());
            }
        })
    }
}

impl toytop_state {
    pub(crate) fn checked(&self) -> Result<State, ParameterError> {
        let complex = |[re, im]: [f64; 2]| Complex::new(re, im);
        State::new(Orientation { alpha: complex(self.alpha), beta: complex(self.beta) }, self.omega)
    }

    pub(crate) fn from_state(state: &State) -> Self {
        let Orientation { alpha, beta } = state.orientation();
        let omega = state.omega();
        Self { alpha: [alpha.re, alpha.im], beta: [beta.re, beta.im], omega }
    }
}

/// State of a release.
///
/// Refusals name `tilt`, `azimuth`, `roll`, `spin`, `precession` or `nutation`. `error` may be null.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn toytop_state_from_release(
    release: *const toytop_release,
    state: *mut toytop_state,
    error: *mut toytop_error,
) -> toytop_status {
    // SAFETY: the caller guarantees valid pointers.
    unsafe {
        status_of(error, || {
            let toytop_release { tilt, azimuth, roll, spin, precession, nutation } = read(release)?;
            let released = State::from_release(&Release { tilt, azimuth, roll, spin, precession, nutation })?;
            write(state, toytop_state::from_state(&released))
        })
    }
}

/// State from sensors.
///
/// Refusals name `quaternion` or `gyro`. `error` may be null.
///
/// * `quaternion`: four numbers w, x, y, z of unit norm to within 1e-6, from body to fixed coordinates
/// * `gyro`: three rates in the body frame, rad/s
#[unsafe(no_mangle)]
pub unsafe extern "C" fn toytop_state_from_quaternion_and_gyro(
    quaternion: *const f64,
    gyro: *const f64,
    state: *mut toytop_state,
    error: *mut toytop_error,
) -> toytop_status {
    // SAFETY: the caller guarantees valid pointers.
    unsafe {
        status_of(error, || {
            let quaternion = read(quaternion.cast())?;
            let gyro = read(gyro.cast())?;
            let measured = State::from_quaternion_and_gyro(quaternion, gyro)?;
            write(state, toytop_state::from_state(&measured))
        })
    }
}

/// State after an impulse and the reaction of the support. `before` and `after` may be the same object.
///
/// Refusals name a parameter of the top or of the state, `impulse` or `point`. `error` may be null.
///
/// * `impulse`: three components in the fixed frame, N s
/// * `point`: three body coordinates of the point at which it acts, m from the tip, or from the centre of mass of a
///   free body
#[unsafe(no_mangle)]
pub unsafe extern "C" fn toytop_impulse(
    top: *const toytop_top,
    before: *const toytop_state,
    impulse: *const f64,
    point: *const f64,
    after: *mut toytop_state,
    error: *mut toytop_error,
) -> toytop_status {
    // SAFETY: the caller guarantees valid pointers.
    unsafe {
        status_of(error, || {
            let (top, before, impulse) = impulse_arguments(top, before, impulse, point)?;
            write(after, toytop_state::from_state(&before.with_impulse(&top, &impulse)?))
        })
    }
}

/// Arguments of an impulse.
///
/// # Safety
/// See [`toytop_impulse`].
unsafe fn impulse_arguments(
    top: *const toytop_top,
    before: *const toytop_state,
    impulse: *const f64,
    point: *const f64,
) -> Result<(Top, State, PointImpulse), Refusal> {
    // SAFETY: the caller guarantees valid pointers.
    unsafe {
        let top = read(top)?.checked()?;
        let before = read(before)?.checked()?;
        Ok((top, before, PointImpulse { impulse: read(impulse.cast())?, point: read(point.cast())? }))
    }
}

/// Reaction impulse of the support, N s in the fixed frame. If its vertical part is negative, a real top leaves
/// the plane.
///
/// It has the arguments and refusals of `toytop_impulse`.
///
/// * `reaction`: memory for three numbers
#[unsafe(no_mangle)]
pub unsafe extern "C" fn toytop_reaction_impulse(
    top: *const toytop_top,
    before: *const toytop_state,
    impulse: *const f64,
    point: *const f64,
    reaction: *mut f64,
    error: *mut toytop_error,
) -> toytop_status {
    // SAFETY: the caller guarantees valid pointers.
    unsafe {
        status_of(error, || {
            let (top, before, impulse) = impulse_arguments(top, before, impulse, point)?;
            write(reaction.cast(), before.reaction_impulse(&top, &impulse)?)
        })
    }
}
