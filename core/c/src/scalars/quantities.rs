//! Quantities of a sample.

use crate::sample::{self, Wide, toytop_ephemeris_sample, write_quantity};
use crate::status::toytop_status;
use crate::table::Tabulated;
use crate::toytop_state;
use toytop::fixed::types::I2F30;

macro_rules! functions {
    ($name:ident, $scalar:ty, $output:ty, $wide:ty) => { pastey::paste! {

/// Cayley-Klein parameters: four numbers Re alpha, Im alpha, Re beta, Im beta.
///
/// # Safety
/// Each pointer is null or points to an object of its type, `parameters` to four; the table of the sample is unchanged.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn [<toytop_ $name _cayley_klein>](
    sample: *const toytop_ephemeris_sample,
    parameters: *mut $output,
) -> toytop_status {
    // SAFETY: the caller guarantees valid pointers and a valid table.
    unsafe { write_quantity::<$scalar, _>(sample, parameters.cast(), |sample| sample::cayley_klein(&sample)).into() }
}

/// Unit quaternion w, x, y, z from body to fixed coordinates.
///
/// # Safety
/// Each pointer is null or points to an object of its type, `quaternion` to four; the table of the sample is unchanged.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn [<toytop_ $name _quaternion>](
    sample: *const toytop_ephemeris_sample,
    quaternion: *mut $output,
) -> toytop_status {
    // SAFETY: the caller guarantees valid pointers and a valid table.
    unsafe { write_quantity::<$scalar, _>(sample, quaternion.cast(), |sample| sample.quaternion().map(Tabulated::held)).into() }
}

/// Unit vector of three components from the tip to the centre of mass, in the fixed frame. The third is u, the cosine of the
/// tilt, which a rounding can take past 1.
///
/// # Safety
/// Each pointer is null or points to an object of its type, `axis` to three; the table of the sample is unchanged.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn [<toytop_ $name _axis>](
    sample: *const toytop_ephemeris_sample,
    axis: *mut $output,
) -> toytop_status {
    // SAFETY: the caller guarantees valid pointers and a valid table.
    unsafe { write_quantity::<$scalar, _>(sample, axis.cast(), |sample| sample.axis().map(Tabulated::held)).into() }
}

/// Angular velocity of three components in the fixed frame, rad/s.
///
/// # Safety
/// Each pointer is null or points to an object of its type, `omega` to three; the table of the sample is unchanged.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn [<toytop_ $name _omega>](
    sample: *const toytop_ephemeris_sample,
    omega: *mut $wide,
) -> toytop_status {
    // SAFETY: the caller guarantees valid pointers and a valid table.
    unsafe { write_quantity::<$scalar, _>(sample, omega.cast(), |sample| -> [Wide<$scalar>; 3] { sample.omega() }).into() }
}

/// Angular velocity of three components in the body frame, rad/s, as a gyroscope measures it.
///
/// # Safety
/// Each pointer is null or points to an object of its type, `omega` to three; the table of the sample is unchanged.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn [<toytop_ $name _omega_body>](
    sample: *const toytop_ephemeris_sample,
    omega: *mut $wide,
) -> toytop_status {
    // SAFETY: the caller guarantees valid pointers and a valid table.
    unsafe { write_quantity::<$scalar, _>(sample, omega.cast(), |sample| -> [Wide<$scalar>; 3] { sample.omega_body() }).into() }
}

/// Position x, y of the tip, m from the point of the plane below the centre of mass; for a fixed tip the horizontal part of the
/// axis with the opposite sign.
///
/// # Safety
/// Each pointer is null or points to an object of its type, `tip` to two; the table of the sample is unchanged.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn [<toytop_ $name _tip>](
    sample: *const toytop_ephemeris_sample,
    tip: *mut $wide,
) -> toytop_status {
    // SAFETY: the caller guarantees valid pointers and a valid table.
    unsafe { write_quantity::<$scalar, _>(sample, tip.cast(), |sample| -> [Wide<$scalar>; 2] { sample::parts(sample.tip()) }).into() }
}

/// Velocity x, y of the tip, m/s; 1/s for a fixed tip.
///
/// # Safety
/// Each pointer is null or points to an object of its type, `velocity` to two; the table of the sample is unchanged.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn [<toytop_ $name _tip_velocity>](
    sample: *const toytop_ephemeris_sample,
    velocity: *mut $wide,
) -> toytop_status {
    // SAFETY: the caller guarantees valid pointers and a valid table.
    unsafe { write_quantity::<$scalar, _>(sample, velocity.cast(), |sample| -> [Wide<$scalar>; 2] { sample::parts(sample.tip_velocity()) }).into() }
}

/// Angle of the tip, rad, continued in time from (-pi, pi] at the launch. `TOYTOP_NONE` if the axis is always vertical.
///
/// # Safety
/// Each pointer is null or points to an object of its type; the table of the sample is unchanged.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn [<toytop_ $name _tip_angle>](
    sample: *const toytop_ephemeris_sample,
    angle: *mut f64,
) -> toytop_status {
    // SAFETY: the caller guarantees valid pointers and a valid table.
    unsafe { sample::tip_angle::<$scalar>(sample, angle).into() }
}

/// State of a sample, from which another motion can be launched.
///
/// # Safety
/// Each pointer is null or points to an object of its type; the table of the sample is unchanged.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn [<toytop_ $name _state>](
    sample: *const toytop_ephemeris_sample,
    state: *mut toytop_state,
) -> toytop_status {
    // SAFETY: the caller guarantees valid pointers and a valid table.
    unsafe { sample::state::<$scalar>(sample, state).into() }
}

    } };
}

functions!(f32, f32, f32, f32);
functions!(f64, f64, f64, f64);
functions!(q31, I2F30, i32, f32);
