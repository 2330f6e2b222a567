//! Set-up and reading of a table.

use crate::motion::toytop_motion;
use crate::sample::{self, toytop_ephemeris_cursor, toytop_ephemeris_sample, toytop_event};
use crate::set_up::{self, Launched, toytop_pause, toytop_workspace};
use crate::status::{status_of, toytop_error, toytop_status};
use crate::table::*;
use core::ffi::c_void;
use toytop::Level;
use toytop::fixed::types::I2F30;

/// Function that reads a table.
macro_rules! reader {
    ($(#[$doc:meta])* $function:ident(table: $table:ty; $($argument:ident: $type:ty),*) $read:expr) => {
$(#[$doc])*
#[unsafe(no_mangle)]
pub unsafe extern "C" fn $function(table: *const $table, $($argument: $type),*) -> toytop_status {
    // SAFETY: the caller guarantees valid pointers and a valid table.
    unsafe { $read(table.cast(), $($argument),*).into() }
}
    };
}

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
    unsafe { status_of(error, || set_up::set_up_on_stack::<$scalar>((table.cast(), size), launched)) }
}

/// Sets up a table with the workspace of the caller instead of one on the stack, and with pauses for other work.
///
/// * `pause`: function that is called again and again with `context`, or null
#[unsafe(no_mangle)]
pub unsafe extern "C" fn [<toytop_ $name _set_up_with_pauses>](
    table: *mut $table,
    size: usize,
    workspace: *mut toytop_workspace,
    motion: *const toytop_motion,
    tick: toytop_tick,
    epoch: i64,
    truncation: f64,
    pause: toytop_pause,
    context: *mut c_void,
    error: *mut toytop_error,
) -> toytop_status {
    let launched = Launched { motion, tick, epoch, truncation };
    // SAFETY: the caller guarantees valid pointers.
    unsafe {
        status_of(error, || set_up::set_up_in::<$scalar>((table.cast(), size), workspace, launched, (pause, context)))
    }
}

/// Number of segments of a table that is enough for a motion; 0 if 4096, the largest number, are not, or if an argument is
/// refused. A table has at least 8. The call takes much longer than a set-up, and is meant for a PC.
///
/// * `truncation`: greatest truncation error, rad; 0 stands for that of the scalar
#[unsafe(no_mangle)]
pub unsafe extern "C" fn [<toytop_ $name _segments_needed>](motion: *const toytop_motion, truncation: f64) -> u32 {
    // SAFETY: the caller guarantees a valid pointer.
    unsafe { set_up::segments_needed::<$scalar>(motion, truncation) }
}

reader! {
/// Error bounds of a table at a tick.
[<toytop_ $name _error_bounds>](table: $table; tick: i64, bounds: *mut toytop_error_bounds)
    |table, tick, bounds| {
        write_from::<$scalar, _>(table, bounds, |table| {
            Ok(toytop_error_bounds { orientation: table.error_bound_at(tick), rate: table.rate_error_bound_at(tick) })
        })
    }
}

reader! {
/// Sample at any tick, of either sign, always at the same cost.
[<toytop_ $name _at_tick>](table: $table; tick: i64, sample: *mut toytop_ephemeris_sample)
    |table, tick, place| sample::store_sample::<$scalar>(table, place, |table| Ok(table.at_tick(tick)))
}

reader! {
/// Sample at any time, s from tick 0.
[<toytop_ $name _at>](table: $table; time: f64, sample: *mut toytop_ephemeris_sample)
    |table, time, place| sample::store_sample::<$scalar>(table, place, |table| sample::at(table, time))
}

reader! {
/// Cursor whose first sample is that of tick `first`.
[<toytop_ $name _cursor>](table: $table; first: i64, cursor: *mut toytop_ephemeris_cursor)
    sample::cursor::<$scalar>
}

reader! {
/// Next sample of a cursor. The sequence has no end.
[<toytop_ $name _next>](table: $table; cursor: *mut toytop_ephemeris_cursor, sample: *mut toytop_ephemeris_sample)
    sample::next::<$scalar>
}

reader! {
/// Quaternion, four numbers w, x, y, z, at the next tick of a cursor, from body to fixed coordinates, without a sample.
[<toytop_ $name _next_quaternion>](table: $table; cursor: *mut toytop_ephemeris_cursor, quaternion: *mut $output)
    |table, cursor, place: *mut $output| sample::next_quaternion::<$scalar>(table, cursor, place.cast())
}

reader! {
/// First turning point of u at tick `from` or later; `upward` is 1 where u = e2. `TOYTOP_NONE` where there is none. The next one is
/// found from `tick + 1` of this one, here and below.
[<toytop_ $name _turning_point>](table: $table; from: i64, event: *mut toytop_event)
    |table, from, event| write_from::<$scalar, _>(table, event, |table| sample::first_event(table.turning_points(from)))
}

reader! {
/// First instant at tick `from` or later at which the axis has a tilt, the angle to the upward vertical in rad; `upward` is 1 where
/// the axis rises. `TOYTOP_NONE` where the motion does not reach it.
[<toytop_ $name _tilt_reached>](table: $table; tilt: f64, from: i64, event: *mut toytop_event)
    |table, tilt, from, event| {
        write_from::<$scalar, _>(table, event, |table| sample::first_event(table.crossings(Level::of_tilt(tilt)?, from)))
    }
}

reader! {
/// First instant at tick `from` or later at which the tip is in a direction, an angle from the x axis in rad; `upward` is 1 where the
/// angle of the tip increases. `TOYTOP_NONE` where the axis is always vertical or the direction is not reached.
[<toytop_ $name _direction_reached>](table: $table; direction: f64, from: i64, event: *mut toytop_event)
    |table, angle, from, event| {
        write_from::<$scalar, _>(table, event, |table| sample::first_event(table.tip_angles(sample::direction(angle)?, from)))
    }
}

    } };
}

functions!(f32, f32, toytop_ephemeris_f32, f32);
functions!(f64, f64, toytop_ephemeris_f64, f64);
functions!(q31, I2F30, toytop_ephemeris_q31, i32);
