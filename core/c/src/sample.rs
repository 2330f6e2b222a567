//! Reading of a table: any tick, cursors, and the quantities of a sample.

use crate::memory::{Kept, keep, kept, write};
use crate::status::{Refusal, toytop_status};
use crate::table::{Table, Tabulated, toytop_error_bounds, view};
use crate::toytop_state;
use toytop::internal::Ticks;
use toytop::{Complex, EphemerisScalar, ParameterError, Sample};

/// Bytes of a cursor.
pub const TOYTOP_EPHEMERIS_CURSOR_SIZE: usize = 64;
/// Bytes of a sample.
pub const TOYTOP_EPHEMERIS_SAMPLE_SIZE: usize = 112;
/// Phases of consecutive ticks of one table, which an interrupt keeps. It may be copied.
///
/// A cursor belongs to the table that made it, and must be made again after a set-up: any other table refuses it.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct toytop_ephemeris_cursor {
    opaque: [u64; 8],
}

/// Sample of a motion at one instant: phases, from which each quantity is computed on demand. It may be copied.
///
/// A sample refers to its table, and is refused after another set-up in the memory of the table, which must still be there.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct toytop_ephemeris_sample {
    opaque: [u64; 14],
}

/// Turning point of the cosine of the tilt, u.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct toytop_turning_point {
    /// First tick at or after the turning point.
    pub tick: i64,
    /// 1 where u = e2 is greatest, 0 where u = e1 is least.
    pub upper: u32,
}

const _: () = assert!(
    size_of::<toytop_ephemeris_cursor>() == TOYTOP_EPHEMERIS_CURSOR_SIZE
        && size_of::<toytop_ephemeris_sample>() == TOYTOP_EPHEMERIS_SAMPLE_SIZE
);

/// Cursor with the identity of its table.
struct CursorOf {
    table: u32,
    ticks: Ticks,
}

impl Kept for CursorOf {
    const TAG: u32 = 0x746f_7063;
}

/// Sample with the address and the identity of its table.
struct SampleOf<R: Tabulated> {
    sample: Sample<'static, R>,
    address: *const u8,
    table: u32,
}

impl<R: Tabulated> Kept for SampleOf<R> {
    const TAG: u32 = R::TAG | 0x7300;
}

/// Sample that the caller keeps. It is refused if its table was set up again.
///
/// # Safety
/// The pointer is null or valid for reading; and the memory of the sample's table is still there.
pub(crate) unsafe fn sample<R: Tabulated>(
    place: *const toytop_ephemeris_sample,
) -> Result<Sample<'static, R>, Refusal> {
    // SAFETY: the caller guarantees that the pointer is valid.
    let SampleOf { sample, address, table } = unsafe { kept(place)? };
    // SAFETY: see above.
    if unsafe { view::<R>(address)? }.identity != table {
        return Err(toytop_status::TOYTOP_NOT_SET_UP.into());
    }
    Ok(sample)
}

/// Keeps a sample of a table for the caller.
///
/// # Safety
/// The pointer is null or valid for writing.
unsafe fn keep_sample<R: Tabulated>(
    place: *mut toytop_ephemeris_sample,
    table: &Table<'static, R>,
    sample: Sample<'static, R>,
) -> Result<(), Refusal> {
    // SAFETY: the caller guarantees a valid pointer.
    unsafe { keep(place, SampleOf { sample, address: table.address, table: table.identity }) }
}

/// Writes a quantity of a sample to memory of the caller.
///
/// # Safety
/// As for [`sample`]; `place` is null or valid for writing a `T`.
pub(crate) unsafe fn write_quantity<R: Tabulated, T>(
    from: *const toytop_ephemeris_sample,
    place: *mut T,
    quantity: impl FnOnce(Sample<'static, R>) -> T,
) -> Result<(), Refusal> {
    // SAFETY: the caller guarantees that both pointers are valid.
    unsafe { write(place, quantity(sample(from)?)) }
}

/// Sample at a tick.
///
/// # Safety
/// The pointers are null or valid, and the table stays as long as the sample is used; here and below.
pub(crate) unsafe fn at_tick<R: Tabulated>(
    table: *const u8,
    tick: i64,
    place: *mut toytop_ephemeris_sample,
) -> Result<(), Refusal> {
    // SAFETY: the caller guarantees valid pointers and a valid table.
    unsafe {
        let table = view::<R>(table)?;
        keep_sample(place, &table, table.view.at_tick(tick))
    }
}

/// Sample at a time.
///
/// # Safety
/// As for [`at_tick`].
pub(crate) unsafe fn at<R: Tabulated>(
    table: *const u8,
    time: f64,
    place: *mut toytop_ephemeris_sample,
) -> Result<(), Refusal> {
    if !time.is_finite() {
        return Err(ParameterError::NotFinite { parameter: "time" }.into());
    }
    // SAFETY: the caller guarantees valid pointers and a valid table.
    let table = unsafe { view::<R>(table)? };
    if time.abs() >= table.view.last_time() {
        return Err(ParameterError::OutOfRange { parameter: "time", allowed: "within 2^63 ticks" }.into());
    }
    // SAFETY: see above.
    unsafe { keep_sample(place, &table, table.view.at(time)) }
}

/// Cursor whose first sample is that of tick `first`.
///
/// # Safety
/// As for [`at_tick`].
pub(crate) unsafe fn cursor<R: Tabulated>(
    table: *const u8,
    first: i64,
    place: *mut toytop_ephemeris_cursor,
) -> Result<(), Refusal> {
    // SAFETY: the caller guarantees valid pointers and a valid table.
    unsafe {
        let table = view::<R>(table)?;
        keep(place, CursorOf { table: table.identity, ticks: Ticks::new(table.view.clock(), first) })
    }
}

/// Gives the next sample of a cursor to `take`. If that refuses, the cursor stays.
///
/// # Safety
/// As for [`at_tick`].
unsafe fn advance<R: Tabulated>(
    table: *const u8,
    place: *mut toytop_ephemeris_cursor,
    take: impl FnOnce(&Table<'static, R>, Sample<'static, R>) -> Result<(), Refusal>,
) -> Result<(), Refusal> {
    // SAFETY: the caller guarantees valid pointers and a valid table.
    let (table, mut of): (_, CursorOf) = unsafe { (view::<R>(table)?, kept(place)?) };
    if of.table != table.identity {
        return Err(toytop_status::TOYTOP_NOT_SET_UP.into());
    }
    take(&table, of.ticks.next(table.view))?;
    // SAFETY: see above.
    unsafe { keep(place, of) }
}

/// Next sample of a cursor.
///
/// # Safety
/// As for [`at_tick`].
pub(crate) unsafe fn next<R: Tabulated>(
    table: *const u8,
    cursor: *mut toytop_ephemeris_cursor,
    place: *mut toytop_ephemeris_sample,
) -> Result<(), Refusal> {
    // SAFETY: the caller guarantees valid pointers and a valid table, here and inside.
    unsafe { advance::<R>(table, cursor, |table, sample| keep_sample(place, table, sample)) }
}

/// Quaternion at the next tick of a cursor.
///
/// # Safety
/// As for [`at_tick`].
pub(crate) unsafe fn next_quaternion<R: Tabulated>(
    table: *const u8,
    cursor: *mut toytop_ephemeris_cursor,
    place: *mut [R::Held; 4],
) -> Result<(), Refusal> {
    // SAFETY: the caller guarantees valid pointers and a valid table, here and inside.
    unsafe { advance::<R>(table, cursor, |_, sample| write(place, sample.quaternion().map(R::held))) }
}

/// Tick of the last sample of a cursor; before the first sample, the tick before it.
///
/// # Safety
/// Each pointer is null or points to an object of its type.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn toytop_ephemeris_cursor_tick(
    place: *const toytop_ephemeris_cursor,
    tick: *mut i64,
) -> toytop_status {
    // SAFETY: the caller guarantees valid pointers.
    unsafe { kept(place).and_then(|of: CursorOf| write(tick, of.ticks.tick())) }.into()
}

/// Next turning point.
///
/// # Safety
/// As for [`at_tick`].
pub(crate) unsafe fn turning_point<R: Tabulated>(
    table: *const u8,
    tick: i64,
    place: *mut toytop_turning_point,
) -> Result<(), Refusal> {
    // a tick within 2^-50 turns, the rounding of a start, counts as that of the turning point
    const SAME_PHASE: f64 = 1.0 / (1_u64 << 50) as f64;
    // SAFETY: the caller guarantees valid pointers and a valid table.
    let table = unsafe { view::<R>(table)? }.view;
    let [[turns_per_tick, _], ..] = table.clock().exact_step;
    let mut points = table.turning_points(tick.saturating_sub(1)).map(|event| toytop_turning_point {
        tick: event.tick.saturating_add((event.share * turns_per_tick > SAME_PHASE).into()),
        upper: event.upward.into(),
    });
    let point = points.find(|point| point.tick >= tick).ok_or(toytop_status::TOYTOP_NONE)?;
    // SAFETY: see above.
    unsafe { write(place, point) }
}

/// Tip angle of a sample, rad.
///
/// # Safety
/// As for [`write_quantity`].
pub(crate) unsafe fn tip_angle<R: Tabulated>(
    from: *const toytop_ephemeris_sample,
    place: *mut f64,
) -> Result<(), Refusal> {
    // SAFETY: the caller guarantees that both pointers are valid.
    let angle = unsafe { sample::<R>(from)? }.tip_angle().ok_or(toytop_status::TOYTOP_NONE)?;
    // SAFETY: see above.
    unsafe { write(place, angle.to_radians()) }
}

/// State to launch from.
///
/// # Safety
/// As for [`write_quantity`].
pub(crate) unsafe fn state<R: Tabulated>(
    from: *const toytop_ephemeris_sample,
    place: *mut toytop_state,
) -> Result<(), Refusal> {
    // SAFETY: the caller guarantees that both pointers are valid.
    let state = unsafe { sample::<R>(from)? }.attitude_state().state()?;
    // SAFETY: see above.
    unsafe { write(place, toytop_state::of(&state)) }
}

/// # Safety
/// As for [`at_tick`].
pub(crate) unsafe fn error_bounds<R: Tabulated>(
    table: *const u8,
    tick: i64,
    place: *mut toytop_error_bounds,
) -> Result<(), Refusal> {
    // SAFETY: the caller guarantees valid pointers and a valid table.
    let table = unsafe { view::<R>(table)? }.view;
    let [orientation, rate] = [table.error_bound_at(tick), table.rate_error_bound_at(tick)];
    // SAFETY: see above.
    unsafe { write(place, toytop_error_bounds { orientation, rate }) }
}

/// Parts of a complex number, {re, im}.
pub(crate) fn parts<R>(z: Complex<R>) -> [R; 2] {
    [z.re, z.im]
}

/// Orientation of a sample: parts of alpha, then of beta.
pub(crate) fn cayley_klein<R: Tabulated>(sample: &Sample<'_, R>) -> [R::Held; 4] {
    let orientation = sample.orientation();
    let ([a, b], [c, d]) = (parts(orientation.alpha), parts(orientation.beta));
    [a, b, c, d].map(R::held)
}

/// Type of lengths and rates of a scalar.
pub(crate) type Wide<R> = <R as EphemerisScalar>::Wide;
