//! Reading of a table: any tick, cursors, the quantities of a sample, and events.

use crate::memory::{Opaque, load, store, write};
use crate::status::{Refusal, toytop_status};
use crate::table::{Table, table_at};
use toytop::{Complex, Cursor, EphemerisScalar, EphemerisView, Event, Events, ParameterError, Phase, Sample};

/// Bytes of a cursor.
pub const TOYTOP_EPHEMERIS_CURSOR_SIZE: usize = 64;
/// Bytes of a sample.
pub const TOYTOP_EPHEMERIS_SAMPLE_SIZE: usize = 112;
/// Phases of consecutive ticks of one table, which an interrupt keeps. It may be copied.
///
/// A cursor belongs to the table that made it, and must be made again after a set-up. A number of 32 bits identifies a table, by which other
/// tables almost always refuse the cursor.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct toytop_ephemeris_cursor {
    opaque: [u64; 8],
}

/// Sample of a motion at one instant: phases, from which each quantity is computed on demand. It may be copied.
///
/// A sample refers to its table, whose memory must still be there. After another set-up in this memory the sample is refused.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct toytop_ephemeris_sample {
    opaque: [u64; 14],
}

// cbindgen accepts only a number as a length
const _: () = assert!(
    size_of::<toytop_ephemeris_cursor>() == TOYTOP_EPHEMERIS_CURSOR_SIZE
        && size_of::<toytop_ephemeris_sample>() == TOYTOP_EPHEMERIS_SAMPLE_SIZE
);

/// Cursor with the identity of its table.
struct TableCursor {
    table: u32,
    cursor: Cursor,
}

impl Opaque for TableCursor {
    const TAG: u32 = 0x746f_7063;
}

/// Sample with the address and the identity of its table.
struct TableSample<R: EphemerisScalar> {
    sample: Sample<'static, R>,
    address: *const u8,
    table: u32,
}

impl<R: EphemerisScalar> Opaque for TableSample<R> {
    const TAG: u32 = 0x746f_7300 | R::CODE;
}

/// Writes a quantity of a sample to memory of the caller. The sample is refused if its table was set up again. A number in fixed point is
/// written as its integer, which has the same layout.
///
/// # Safety
/// The pointers are null or valid, and the memory of the sample's table is still there.
pub(crate) unsafe fn write_quantity<R: EphemerisScalar, T>(
    from: *const toytop_ephemeris_sample,
    place: *mut T,
    quantity: impl FnOnce(Sample<'static, R>) -> Result<T, Refusal>,
) -> Result<(), Refusal> {
    // SAFETY: the caller guarantees valid pointers and a valid table.
    unsafe {
        let TableSample { sample, address, table } = load(from)?;
        if table_at::<R>(address)?.identity != table {
            return Err(toytop_status::TOYTOP_NOT_SET_UP.into());
        }
        write(place, quantity(sample)?)
    }
}

/// Stores a sample of a table in memory of the caller.
///
/// # Safety
/// The pointers are null or valid, and the table stays as long as the sample is used.
pub(crate) unsafe fn store_sample<R: EphemerisScalar>(
    table: *const u8,
    place: *mut toytop_ephemeris_sample,
    sample: impl FnOnce(&'static EphemerisView<R>) -> Result<Sample<'static, R>, Refusal>,
) -> Result<(), Refusal> {
    // SAFETY: the caller guarantees valid pointers and a valid table.
    unsafe {
        let Table { table, address, identity } = table_at::<R>(table)?;
        store(place, TableSample { sample: sample(table)?, address, table: identity })
    }
}

/// Sample at a time.
pub(crate) fn at<R: EphemerisScalar>(table: &EphemerisView<R>, time: f64) -> Result<Sample<'_, R>, Refusal> {
    if !time.is_finite() {
        return Err(ParameterError::NotFinite { parameter: "time" }.into());
    }
    if time.abs() >= table.last_time() {
        return Err(ParameterError::OutOfRange { parameter: "time", allowed: "within 2^63 ticks" }.into());
    }
    Ok(table.at(time))
}

/// Cursor whose first sample is that of tick `first`.
///
/// # Safety
/// The conditions are those of [`store_sample`].
pub(crate) unsafe fn cursor<R: EphemerisScalar>(
    table: *const u8,
    first: i64,
    place: *mut toytop_ephemeris_cursor,
) -> Result<(), Refusal> {
    // SAFETY: the caller guarantees valid pointers and a valid table.
    unsafe {
        let Table { table, identity, .. } = table_at::<R>(table)?;
        store(place, TableCursor { table: identity, cursor: table.cursor(first) })
    }
}

/// Gives the next sample of a cursor to `take`. If that refuses, the cursor stays.
///
/// # Safety
/// The conditions are those of [`store_sample`].
unsafe fn advance<R: EphemerisScalar>(
    table: *const u8,
    place: *mut toytop_ephemeris_cursor,
    take: impl FnOnce(Sample<'static, R>) -> Result<(), Refusal>,
) -> Result<(), Refusal> {
    // SAFETY: the caller guarantees valid pointers and a valid table.
    let (Table { table, identity, .. }, mut kept): (_, TableCursor) =
        unsafe { (table_at::<R>(table)?, load(place)?) };
    if kept.table != identity {
        return Err(toytop_status::TOYTOP_NOT_SET_UP.into());
    }
    take(kept.cursor.next(table))?;
    // SAFETY: the caller guarantees a valid pointer.
    unsafe { store(place, kept) }
}

/// Next sample of a cursor.
///
/// # Safety
/// The conditions are those of [`store_sample`].
pub(crate) unsafe fn next<R: EphemerisScalar>(
    table: *const u8,
    cursor: *mut toytop_ephemeris_cursor,
    place: *mut toytop_ephemeris_sample,
) -> Result<(), Refusal> {
    // SAFETY: the caller guarantees valid pointers and a valid table, here and inside.
    unsafe { advance::<R>(table, cursor, |sample| store_sample(table, place, |_| Ok(sample))) }
}

/// Quaternion at the next tick of a cursor.
///
/// # Safety
/// The conditions are those of [`store_sample`].
pub(crate) unsafe fn next_quaternion<R: EphemerisScalar>(
    table: *const u8,
    cursor: *mut toytop_ephemeris_cursor,
    quaternion: *mut [R; 4],
) -> Result<(), Refusal> {
    // SAFETY: the caller guarantees valid pointers and a valid table, here and inside.
    unsafe { advance::<R>(table, cursor, |sample| write(quaternion, sample.quaternion())) }
}

/// Tick of the last sample of a cursor; before the first sample, the tick before it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn toytop_ephemeris_cursor_tick(
    place: *const toytop_ephemeris_cursor,
    tick: *mut i64,
) -> toytop_status {
    // SAFETY: the caller guarantees valid pointers.
    unsafe { load(place).and_then(|kept: TableCursor| write(tick, kept.cursor.tick())) }.into()
}

/// Parts of a complex number, {re, im}.
pub(crate) fn re_im<R>(z: Complex<R>) -> [R; 2] {
    [z.re, z.im]
}

/// Event of a motion: its instant in ticks, and the sense of the change.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct toytop_event {
    /// Last tick at or before the event.
    pub tick: i64,
    /// Fraction of the following tick that passes before the event, in [0, 1).
    pub fraction: f64,
    /// 1 or 0: see the function that found the event.
    pub upward: u32,
}

/// First event of an iterator.
pub(crate) fn first_event<R: EphemerisScalar>(mut events: Events<'_, R>) -> Result<toytop_event, Refusal> {
    let Event { tick, fraction, upward } = events.next().ok_or(toytop_status::TOYTOP_NONE)?;
    Ok(toytop_event { tick, fraction, upward: upward.into() })
}

/// Direction of the tip, from an angle in rad.
pub(crate) fn direction(angle: f64) -> Result<Phase, Refusal> {
    if !angle.is_finite() {
        return Err(ParameterError::NotFinite { parameter: "direction" }.into());
    }
    Ok(Phase::from_radians(angle))
}
