//! Cursors, which go from tick to tick of a table.

use crate::memory::{Opaque, load, opaque, store, write};
use crate::sample::toytop_sample;
use crate::status::{Refusal, toytop_status};
use crate::table::*;
use toytop::{Cursor, Sample, TableScalar};

opaque! {
/// Bytes of a cursor.
TOYTOP_CURSOR_SIZE = 64;

/// Phases of consecutive ticks of one table, which an interrupt keeps. It may be copied.
///
/// Make the cursor again after each set-up of its table: an older cursor, and one of another table, is refused. The count of set-ups repeats after
/// 65 536.
toytop_cursor[8]
}

impl<R> Opaque for OfTable<Cursor<R>> {
    /// Tag of a cursor of any scalar: all have one layout.
    const TAG: u32 = 0x746f_7063;
}

/// Gives the next sample of a cursor to `take`. If that refuses, the cursor stays.
///
/// # Safety
/// See [`store_from`].
unsafe fn advance<R: TableScalar>(
    table: *const u8,
    place: *mut toytop_cursor,
    take: impl FnOnce(Sample<'static, R>) -> Result<(), Refusal>,
) -> Result<(), Refusal> {
    // SAFETY: the caller guarantees valid pointers and a valid table.
    let (checked, mut kept): (_, OfTable<Cursor<R>>) = unsafe { (table_at::<R>(table)?, load(place)?) };
    kept.belongs_to(&checked)?;
    let mut cursor = kept.value;
    take(cursor.next(checked.table))?;
    kept.value = cursor;
    // SAFETY: the caller guarantees a valid pointer.
    unsafe { store(place, kept) }
}

/// Next sample of a cursor.
///
/// # Safety
/// See [`store_from`].
unsafe fn next<R: TableScalar>(
    table: *const u8,
    cursor: *mut toytop_cursor,
    place: *mut toytop_sample,
) -> Result<(), Refusal> {
    // SAFETY: the caller guarantees valid pointers and a valid table, here and inside.
    unsafe { advance::<R>(table, cursor, |sample| store_from::<R, _, _>(table, place, |_| Ok(sample))) }
}

/// Quaternion at the next tick of a cursor.
///
/// # Safety
/// See [`store_from`].
unsafe fn next_quaternion<R: TableScalar>(
    table: *const u8,
    cursor: *mut toytop_cursor,
    quaternion: *mut [R; 4],
) -> Result<(), Refusal> {
    // SAFETY: the caller guarantees valid pointers and a valid table, here and inside.
    unsafe { advance::<R>(table, cursor, |sample| write(quaternion, sample.quaternion())) }
}

/// Tick of the last sample of a cursor; before the first sample, the tick before it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn toytop_cursor_tick(place: *const toytop_cursor, tick: *mut i64) -> toytop_status {
    // SAFETY: the caller guarantees valid pointers. The layout is the same for every scalar.
    unsafe { load(place).and_then(|OfTable::<Cursor<f32>> { value, .. }| write(tick, value.tick())) }.into()
}

macro_rules! functions {
    ($name:ident, $scalar:ty, $table:ty, $orientation:ty, $rate:ty) => { pastey::paste! {

reader! {
/// Cursor whose first sample is at tick `first`.
[<toytop_ $name _cursor>](table: $table; first: i64, cursor: *mut toytop_cursor)
    |table, first, place| store_from::<$scalar, _, _>(table, place, |table| Ok(table.cursor(first)))
}

reader! {
/// Next sample of a cursor. The sequence has no end.
[<toytop_ $name _next>](table: $table; cursor: *mut toytop_cursor, sample: *mut toytop_sample)
    next::<$scalar>
}

reader! {
/// Quaternion, four numbers w, x, y, z, at the next tick of a cursor, from body to fixed coordinates, without a sample.
[<toytop_ $name _next_quaternion>](table: $table; cursor: *mut toytop_cursor, quaternion: *mut $orientation)
    |table, cursor, place: *mut $orientation| next_quaternion::<$scalar>(table, cursor, place.cast())
}

    } };
}

for_each_scalar!(functions);
