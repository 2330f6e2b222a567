//! Set-up and reading of a table.

use crate::motion::toytop_motion;
use crate::sample::{self, toytop_ephemeris_cursor, toytop_ephemeris_sample, toytop_turning_point};
use crate::set_up::{self, Launched, toytop_between, toytop_set_up};
use crate::status::{status_of, toytop_error, toytop_status};
use crate::table::{
    toytop_ephemeris_f32, toytop_ephemeris_f64, toytop_ephemeris_q31, toytop_error_bounds, toytop_tick,
};
use core::ffi::c_void;
use toytop::fixed::types::I2F30;

macro_rules! functions {
    ($name:ident, $scalar:ty, $table:ty, $output:ty) => { pastey::paste! {

/// Sets up a table in memory of the caller, which need not be initialised. It takes too long for an interrupt.
///
/// Refusals name `tick` or `truncation`, or say that the segments are not enough for this motion, or that it is aperiodic. After a refusal
/// every function that reads the table returns `TOYTOP_NOT_SET_UP`. A refusal of `table` or `size` changes nothing. `error` may be null.
///
/// * `size`: bytes of the memory, `sizeof *table` or that of more or fewer segments (from 8 to 4096)
/// * `epoch`: tick of the launch on a running counter
/// * `truncation`: greatest truncation error, rad; 0 stands for that of the scalar
///
/// # Safety
/// `table` is null or points to `size` bytes, and nobody else uses them meanwhile.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn [<toytop_ $name _set_up>](
    table: *mut $table,
    size: usize,
    motion: *const toytop_motion,
    tick: toytop_tick,
    epoch: i64,
    truncation: f64,
    error: *mut toytop_error,
) -> toytop_status {
    let launched = Launched { motion, tick, epoch, truncation };
    // SAFETY: the caller guarantees valid pointers.
    unsafe { status_of(set_up::on_stack::<$scalar>((table.cast(), size), launched), error) }
}

/// Sets up a table as the function without `_between` does, with its memory in a static instead of on the stack, and with other work in between.
///
/// * `between`: function that is called again and again with `context`, or null
///
/// # Safety
/// Each pointer is null or points to an object of its type, `table` to `size` bytes, and nobody else uses them meanwhile.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn [<toytop_ $name _set_up_between>](
    table: *mut $table,
    size: usize,
    set_up: *mut toytop_set_up,
    motion: *const toytop_motion,
    tick: toytop_tick,
    epoch: i64,
    truncation: f64,
    between: toytop_between,
    context: *mut c_void,
    error: *mut toytop_error,
) -> toytop_status {
    let launched = Launched { motion, tick, epoch, truncation };
    // SAFETY: the caller guarantees valid pointers.
    unsafe {
        status_of(set_up::run::<$scalar>((table.cast(), size), set_up, launched, (between, context)), error)
    }
}

/// Number of segments of a table that is enough for a motion; 0 if 4096, the largest number, are not, or if an argument is
/// refused. A table has at least 8. The call takes much longer than a set-up, and is meant for a PC.
///
/// * `truncation`: greatest truncation error, rad; 0 stands for that of the scalar
///
/// # Safety
/// The pointer is null or points to an object of its type.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn [<toytop_ $name _segments_needed>](motion: *const toytop_motion, truncation: f64) -> u32 {
    // SAFETY: the caller guarantees a valid pointer.
    unsafe { set_up::segments_needed::<$scalar>(motion, truncation) }
}

/// Error bounds of a table at a tick.
///
/// # Safety
/// Each pointer is null or points to an object of its type.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn [<toytop_ $name _error_bounds>](
    table: *const $table,
    tick: i64,
    bounds: *mut toytop_error_bounds,
) -> toytop_status {
    // SAFETY: the caller guarantees valid pointers.
    unsafe { sample::error_bounds::<$scalar>(table.cast(), tick, bounds).into() }
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
    unsafe { sample::at_tick::<$scalar>(table.cast(), tick, sample).into() }
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
    unsafe { sample::at::<$scalar>(table.cast(), time, sample).into() }
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
    unsafe { sample::cursor::<$scalar>(table.cast(), first, cursor).into() }
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
    unsafe { sample::next::<$scalar>(table.cast(), cursor, sample).into() }
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
    unsafe { sample::next_quaternion::<$scalar>(table.cast(), cursor, quaternion.cast()).into() }
}

/// Next turning point of u at tick `from` or later. `TOYTOP_NONE` where there is none.
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
    unsafe { sample::turning_point::<$scalar>(table.cast(), from, point).into() }
}

    } };
}

functions!(f32, f32, toytop_ephemeris_f32, f32);
functions!(f64, f64, toytop_ephemeris_f64, f64);
functions!(q31, I2F30, toytop_ephemeris_q31, i32);
