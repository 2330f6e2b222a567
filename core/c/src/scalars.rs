//! Functions of each scalar, by one macro: their names are `toytop_f32_...`, `toytop_f64_...` and `toytop_q31_...`.

use crate::motion::toytop_motion;
use crate::sample::{
    self, Wide, toytop_ephemeris_cursor, toytop_ephemeris_sample, toytop_turning_point, write_quantity,
};
use crate::set_up::{self, toytop_set_up};
use crate::status::{status_of, toytop_error, toytop_status};
use crate::table::{
    Tabulated, toytop_ephemeris_f32, toytop_ephemeris_f64, toytop_ephemeris_q31, toytop_error_bounds,
    toytop_tick,
};
use crate::toytop_state;
use core::ptr::null_mut;
use toytop::Sample;
use toytop::fixed::types::I2F30;

macro_rules! functions {
    ($name:ident, $scalar:ty, $table:ty, $output:ty, $wide:ty) => { pastey::paste! {

/// Sets up a table in memory of the caller, which need not be initialised. It takes too long for an interrupt.
///
/// Refusals name `tick` or `truncation`, or say that the segments are not enough for this motion. After a refusal the
/// table must not be used, and every function that reads it returns `TOYTOP_NOT_SET_UP`. `error` may be null.
///
/// * `size`: bytes of the memory, `sizeof *table` or that of more or fewer segments (from 8 to 4096)
/// * `truncation`: greatest truncation error, rad; 0 stands for four roundings of the scalar
///
/// # Safety
/// `table` is null or points to `size` bytes, and nobody else uses them meanwhile.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn [<toytop_ $name _set_up>](
    table: *mut $table,
    size: usize,
    motion: *const toytop_motion,
    tick: toytop_tick,
    truncation: f64,
    error: *mut toytop_error,
) -> toytop_status {
    // SAFETY: the caller guarantees valid pointers.
    unsafe { status_of(set_up::at_once::<$scalar>(table.cast(), size, motion, tick, truncation), error) }
}

/// Performs the next slice of a set-up that `toytop_set_up_begin` began. Returns `TOYTOP_PENDING` until the table is ready or refused;
/// later calls return the same status and change nothing.
///
/// The first slice may have any memory for a table, and the others must have the same memory. Refusals name `table` if it is another one
/// or was set up in another way meanwhile, or say that the segments are not enough for this motion. `error` may be null.
///
/// * `size`: bytes of the memory of the table
///
/// # Safety
/// Each pointer is null or points to an object of its type, `table` to `size` bytes, and nobody else uses them until the last slice
/// returns.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn [<toytop_ $name _set_up_poll>](
    set_up: *mut toytop_set_up,
    table: *mut $table,
    size: usize,
    error: *mut toytop_error,
) -> toytop_status {
    // SAFETY: the caller guarantees valid pointers.
    unsafe { status_of(set_up::poll::<$scalar>(set_up, table.cast(), size), error) }
}

/// Number of segments of a table that is enough for a motion; 0 if 4096, the largest number, are not, or if an argument is
/// refused. A table has at least 8. The call takes much longer than a set-up, and is meant for a PC.
///
/// * `truncation`: greatest truncation error, rad; 0 stands for four roundings of the scalar
///
/// # Safety
/// The pointer is null or points to an object of its type.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn [<toytop_ $name _segments_needed>](motion: *const toytop_motion, truncation: f64) -> u32 {
    // SAFETY: the caller guarantees a valid pointer.
    unsafe { set_up::segments_needed::<$scalar>(motion, truncation) }
}

/// Error bounds of a table.
///
/// # Safety
/// Each pointer is null or points to an object of its type.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn [<toytop_ $name _error_bounds>](
    table: *const $table,
    bounds: *mut toytop_error_bounds,
) -> toytop_status {
    // SAFETY: the caller guarantees valid pointers.
    unsafe { status_of(sample::error_bounds::<$scalar>(table.cast(), bounds), null_mut()) }
}

/// Delays the motion of a table by a number of ticks, which may be fractional: the instant of tick 0 becomes that of tick `ticks`.
///
/// # Safety
/// The pointer is null or points to a table that nobody reads meanwhile.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn [<toytop_ $name _delay>](table: *mut $table, ticks: f64) -> toytop_status {
    // SAFETY: the caller guarantees a valid pointer.
    unsafe { status_of(sample::delay::<$scalar>(table.cast(), ticks), null_mut()) }
}

/// Changes the length of a tick of a table; tick 0 remains the same instant.
///
/// # Safety
/// The pointer is null or points to a table that nobody reads meanwhile.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn [<toytop_ $name _set_tick>](table: *mut $table, tick: toytop_tick) -> toytop_status {
    // SAFETY: the caller guarantees a valid pointer.
    unsafe { status_of(sample::set_tick::<$scalar>(table.cast(), tick), null_mut()) }
}

/// Sample at any tick, of either sign, always at the same cost.
///
/// # Safety
/// Each pointer is null or points to an object of its type. The table stays as it is while the sample is used.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn [<toytop_ $name _at_tick>](
    table: *const $table,
    tick: i64,
    sample: *mut toytop_ephemeris_sample,
) -> toytop_status {
    // SAFETY: the caller guarantees valid pointers and a valid table.
    unsafe { status_of(sample::at_tick::<$scalar>(table.cast(), tick, sample), null_mut()) }
}

/// Sample at any time, s from tick 0.
///
/// # Safety
/// Each pointer is null or points to an object of its type. The table stays as it is while the sample is used.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn [<toytop_ $name _at>](
    table: *const $table,
    time: f64,
    sample: *mut toytop_ephemeris_sample,
) -> toytop_status {
    // SAFETY: the caller guarantees valid pointers and a valid table.
    unsafe { status_of(sample::at::<$scalar>(table.cast(), time, sample), null_mut()) }
}

/// Cursor whose first sample is that of tick `first`.
///
/// # Safety
/// Each pointer is null or points to an object of its type.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn [<toytop_ $name _cursor>](
    table: *const $table,
    first: i64,
    cursor: *mut toytop_ephemeris_cursor,
) -> toytop_status {
    // SAFETY: the caller guarantees valid pointers and a valid table.
    unsafe { status_of(sample::cursor::<$scalar>(table.cast(), first, cursor), null_mut()) }
}

/// Next sample of a cursor. The sequence has no end.
///
/// # Safety
/// Each pointer is null or points to an object of its type. The table made the cursor, and stays as it is while the sample is
/// used.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn [<toytop_ $name _next>](
    table: *const $table,
    cursor: *mut toytop_ephemeris_cursor,
    sample: *mut toytop_ephemeris_sample,
) -> toytop_status {
    // SAFETY: the caller guarantees valid pointers and a valid table.
    unsafe { status_of(sample::next::<$scalar>(table.cast(), cursor, sample), null_mut()) }
}

/// Quaternion w, x, y, z at the next tick of a cursor, from body to fixed coordinates, without a sample.
///
/// # Safety
/// Each pointer is null or points to an object of its type, `quaternion` to four. The table made the cursor.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn [<toytop_ $name _next_quaternion>](
    table: *const $table,
    cursor: *mut toytop_ephemeris_cursor,
    quaternion: *mut $output,
) -> toytop_status {
    // SAFETY: the caller guarantees valid pointers and a valid table.
    unsafe { status_of(sample::next_quaternion::<$scalar>(table.cast(), cursor, quaternion.cast()), null_mut()) }
}

/// Next turning point of u at tick `from` or later. `TOYTOP_NONE` where there is none, or more than one in a tick.
///
/// # Safety
/// Each pointer is null or points to an object of its type.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn [<toytop_ $name _turning_point>](
    table: *const $table,
    from: i64,
    point: *mut toytop_turning_point,
) -> toytop_status {
    // SAFETY: the caller guarantees valid pointers and a valid table.
    unsafe { status_of(sample::turning_point::<$scalar>(table.cast(), from, point), null_mut()) }
}

/// Cayley-Klein parameters: four numbers Re alpha, Im alpha, Re beta, Im beta.
///
/// # Safety
/// Each pointer is null or points to an object of its type, `parameters` to four; the table of the sample is unchanged.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn [<toytop_ $name _cayley_klein>](
    sample: *const toytop_ephemeris_sample,
    parameters: *mut $output,
) -> toytop_status {
    let quantity = |sample: Sample<'_, $scalar>| sample::cayley_klein(&sample);
    // SAFETY: the caller guarantees valid pointers and a valid table.
    unsafe { status_of(write_quantity(sample, parameters.cast(), quantity), null_mut()) }
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
    let quantity = |sample: Sample<'_, $scalar>| sample.quaternion().map(Tabulated::held);
    // SAFETY: the caller guarantees valid pointers and a valid table.
    unsafe { status_of(write_quantity(sample, quaternion.cast(), quantity), null_mut()) }
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
    let quantity = |sample: Sample<'_, $scalar>| sample.axis().map(Tabulated::held);
    // SAFETY: the caller guarantees valid pointers and a valid table.
    unsafe { status_of(write_quantity(sample, axis.cast(), quantity), null_mut()) }
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
    let quantity = |sample: Sample<'_, $scalar>| -> [Wide<$scalar>; 3] { sample.omega() };
    // SAFETY: the caller guarantees valid pointers and a valid table.
    unsafe { status_of(write_quantity(sample, omega.cast(), quantity), null_mut()) }
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
    let quantity = |sample: Sample<'_, $scalar>| -> [Wide<$scalar>; 3] { sample.omega_body() };
    // SAFETY: the caller guarantees valid pointers and a valid table.
    unsafe { status_of(write_quantity(sample, omega.cast(), quantity), null_mut()) }
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
    let quantity = |sample: Sample<'_, $scalar>| -> [Wide<$scalar>; 2] { sample::parts(sample.tip()) };
    // SAFETY: the caller guarantees valid pointers and a valid table.
    unsafe { status_of(write_quantity(sample, tip.cast(), quantity), null_mut()) }
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
    let quantity = |sample: Sample<'_, $scalar>| -> [Wide<$scalar>; 2] { sample::parts(sample.tip_velocity()) };
    // SAFETY: the caller guarantees valid pointers and a valid table.
    unsafe { status_of(write_quantity(sample, velocity.cast(), quantity), null_mut()) }
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
    unsafe { status_of(sample::tip_angle::<$scalar>(sample, angle), null_mut()) }
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
    unsafe { status_of(sample::state::<$scalar>(sample, state), null_mut()) }
}

    } };
}

functions!(f32, f32, toytop_ephemeris_f32, f32, f32);
functions!(f64, f64, toytop_ephemeris_f64, f64, f64);
functions!(q31, I2F30, toytop_ephemeris_q31, i32, f32);
