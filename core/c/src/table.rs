//! Tables in memory of the caller.

use crate::memory::{Opaque, load, opaque, read, store};
use crate::status::{Refusal, toytop_status};
use core::ptr::slice_from_raw_parts_mut;
use core::sync::atomic::{AtomicU16, Ordering::Relaxed};
use toytop::fixed::types::I2F30;
use toytop::internal::{MAX_SEGMENTS, MIN_SEGMENTS};
use toytop::{SizedTable, Table, TableMemory, TableScalar};

opaque! {
/// Bytes of a table in `f32` of the standard size, 25 segments.
TOYTOP_TABLE_F32_SIZE = 2216;

/// Table of a motion in `f32`. Memory of `TOYTOP_TABLE_F32_SIZE_OF(segments)` bytes with the same alignment may be used
/// as a larger or smaller table.
toytop_table_f32[277]
}

opaque! {
/// Bytes of a table in `f64` of the standard size, 48 segments.
TOYTOP_TABLE_F64_SIZE = 17128;

/// Table of a motion in `f64`; see `toytop_table_f32`.
toytop_table_f64[2141]
}

opaque! {
/// Bytes of a table in fixed point of the standard size, 32 segments.
TOYTOP_TABLE_Q31_SIZE = 2264;

/// Table of a motion in fixed point of 32 bits; see `toytop_table_f32`.
toytop_table_q31[283]
}

/// Alignment of the memory of a table, bytes.
pub const TOYTOP_TABLE_ALIGNMENT: usize = 8;

/// Number that the memory of a table of this scalar begins with.
const fn tag_of<R: TableScalar>() -> u32 {
    0x746f_7000 | R::CODE
}

/// Head of the memory of a table; the table follows.
#[repr(C)]
#[derive(Clone, Copy)]
struct Head {
    tag: u32,
    segments: u16,
    /// Number of the set-up, modulo 2^16.
    generation: u16,
}

/// Number of set-ups in all memory, modulo 2^16. Two set-ups at once may get one number; their addresses differ.
static SET_UPS: AtomicU16 = AtomicU16::new(0);

/// Table whose set-up has succeeded.
pub(crate) struct CheckedTable<'a, R: TableScalar> {
    pub(crate) table: &'a Table<R>,
    origin: Origin,
}

/// Set-up from which a table, or a value that belongs to it, comes: the address of the table, and the number of the set-up.
#[repr(C, packed(4))]
#[derive(Clone, Copy, PartialEq)]
struct Origin {
    address: *const u8,
    generation: u32,
}

/// Memory of the smallest table.
type SmallestMemory<R> = TableMemory<SizedTable<R, MIN_SEGMENTS>>;

/// Bytes of a table with this many segments.
const fn size_of_table<R: TableScalar>(segments: usize) -> usize {
    size_of::<Head>() + size_of::<SmallestMemory<R>>() - MIN_SEGMENTS * size_of::<R::Segment>()
        + segments * size_of::<R::Segment>()
}

// Assertions of the numbers in the header. The alignment suits the words of a table.
const _: () = {
    const fn sizes_agree<R: TableScalar>(size: usize, segments: usize, segment: usize) -> bool {
        size_of_table::<R>(segments) == size
            && size_of::<R::Segment>() == segment
            && align_of::<SmallestMemory<R>>() <= TOYTOP_TABLE_ALIGNMENT
    }
    assert!(sizes_agree::<f32>(TOYTOP_TABLE_F32_SIZE, 25, 80));
    assert!(sizes_agree::<f64>(TOYTOP_TABLE_F64_SIZE, 48, 352));
    assert!(sizes_agree::<I2F30>(TOYTOP_TABLE_Q31_SIZE, 32, 64));
};

/// Address of the head of a table; null and unaligned pointers are refused.
fn checked_head(table: *const u8) -> Result<*const Head, Refusal> {
    let head = table.cast::<Head>();
    match head.addr() {
        0 => Err(toytop_status::TOYTOP_NULL_POINTER.into()),
        address if !address.is_multiple_of(TOYTOP_TABLE_ALIGNMENT) => {
            Err(toytop_status::TOYTOP_BAD_MEMORY.into())
        }
        _ => Ok(head),
    }
}

/// Memory of a table after a head, with this many segments.
fn table_after<R: TableScalar>(head: *const Head, segments: usize) -> *mut TableMemory<Table<R>> {
    let first = head.wrapping_add(1).cast_mut().cast::<R::Segment>();
    // the pointer to a memory points to its first byte, and has the number of segments as its length
    slice_from_raw_parts_mut(first, segments) as *mut TableMemory<Table<R>>
}

/// Table that was set up in memory of the caller.
///
/// # Safety
/// The pointer is null or valid for reading a head; and if its tag is that of the scalar, [`empty_table`] wrote what follows, which
/// nobody changes as long as the reference lives.
pub(crate) unsafe fn table_at<'a, R: TableScalar>(
    address: *const u8,
) -> Result<CheckedTable<'a, R>, Refusal> {
    let head = checked_head(address)?;
    // SAFETY: any bits are a head.
    let Head { tag, segments, generation } = unsafe { read(head)? };
    if tag != tag_of::<R>() {
        return Err(toytop_status::TOYTOP_NOT_SET_UP.into());
    }
    // SAFETY: the caller guarantees valid memory; `empty_table` wrote as many segments as it says.
    let memory = unsafe { &*table_after::<R>(head, segments.into()) };
    let table = memory.get().ok_or(toytop_status::TOYTOP_NOT_SET_UP)?;
    Ok(CheckedTable { table, origin: Origin { address, generation: generation.into() } })
}

/// Value that belongs to a table, as C keeps it. It is packed, because C has 64 bytes for a cursor.
#[repr(C, packed(4))]
pub(crate) struct OfTable<T> {
    origin: Origin,
    pub(crate) value: T,
}

impl<T> OfTable<T> {
    /// Refuses the value unless it belongs to this set-up of the table.
    pub(crate) fn belongs_to<R: TableScalar>(&self, table: &CheckedTable<R>) -> Result<(), Refusal> {
        if self.origin == table.origin { Ok(()) } else { Err(toytop_status::TOYTOP_NOT_SET_UP.into()) }
    }
}

/// Keeps a value that belongs to a table in memory of the caller.
///
/// # Safety
/// The pointers are null or valid, and the table stays as long as the value is used.
pub(crate) unsafe fn store_from<R: TableScalar, P, T>(
    address: *const u8,
    place: *mut P,
    value: impl FnOnce(&'static Table<R>) -> Result<T, Refusal>,
) -> Result<(), Refusal>
where
    OfTable<T>: Opaque,
{
    // SAFETY: the caller guarantees valid pointers and a valid table.
    unsafe {
        let CheckedTable { table, origin } = table_at::<R>(address)?;
        store(place, OfTable { origin, value: value(table)? })
    }
}

/// Value that [`store_from`] kept. It is refused if its table was set up again.
///
/// # Safety
/// The pointer is null or valid, and the memory of the table is still there.
pub(crate) unsafe fn load_of<R: TableScalar, P, T>(place: *const P) -> Result<OfTable<T>, Refusal>
where
    OfTable<T>: Opaque,
{
    // SAFETY: the caller guarantees valid pointers and a valid table.
    unsafe {
        let kept: OfTable<T> = load(place)?;
        kept.belongs_to(&table_at::<R>(kept.origin.address)?)?;
        Ok(kept)
    }
}

/// Number of segments of a table in this many bytes; too few bytes are refused.
fn segments_in<R: TableScalar>(size: usize) -> Result<usize, Refusal> {
    let segments = size.saturating_sub(size_of_table::<R>(0)) / size_of::<R::Segment>();
    if segments < MIN_SEGMENTS {
        Err(toytop_status::TOYTOP_BAD_MEMORY.into())
    } else {
        Ok(segments.min(MAX_SEGMENTS))
    }
}

/// Empty table in `size` bytes of the caller, which need not be initialised. Null and unaligned pointers, and too few bytes, are refused.
///
/// # Safety
/// The pointer is null or valid for writing `size` bytes, and nobody else uses them as long as the reference lives.
pub(crate) unsafe fn empty_table<'a, R: TableScalar>(
    table: *mut u8,
    size: usize,
) -> Result<&'a mut TableMemory<Table<R>>, Refusal> {
    let head = checked_head(table)?.cast_mut();
    let segments = segments_in::<R>(size)?;
    let generation = SET_UPS.load(Relaxed).wrapping_add(1);
    SET_UPS.store(generation, Relaxed);
    // SAFETY: there is room for a head, and behind it for a table of `segments` segments, at least 8. They are initialised before a
    // reference to them is made.
    unsafe {
        head.write(Head { tag: tag_of::<R>(), segments: segments as u16, generation });
        let least = head.wrapping_add(1).cast::<SmallestMemory<R>>();
        least.write(TableMemory::new());
        let rest = least.wrapping_add(1).cast::<R::Segment>();
        (MIN_SEGMENTS..segments).zip(0..).for_each(|(_, place)| rest.add(place).write(R::ZERO_SEGMENT));
        Ok(&mut *table_after::<R>(head, segments))
    }
}

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

/// Functions of each scalar: its name in C, its type, and those of its table, of its orientations, and of its lengths and rates.
macro_rules! for_each_scalar {
    ($functions:ident) => {
        $functions!(f32, f32, toytop_table_f32, f32, f32);
        $functions!(f64, f64, toytop_table_f64, f64, f64);
        $functions!(q31, toytop::fixed::types::I2F30, toytop_table_q31, i32, f32);
    };
}
pub(crate) use {for_each_scalar, reader};

#[cfg(test)]
mod tests {
    use super::*;

    /// Memory of every number of segments that a motion may need is a table, from 8 on, in every scalar.
    #[test]
    fn a_table_may_have_eight_segments() {
        fn check<R: TableScalar>() {
            for segments in 8..=40 {
                assert_eq!(segments_in::<R>(size_of_table::<R>(segments)).ok(), Some(segments));
            }
            assert!(segments_in::<R>(size_of_table::<R>(8) - 1).is_err());
        }
        check::<f32>();
        check::<f64>();
        check::<I2F30>();
    }
}
