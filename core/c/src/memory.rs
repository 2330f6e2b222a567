//! Memory of the caller: plain values, and values of the crate that C holds as opaque words.

use crate::status::{Refusal, toytop_status};
use core::mem::MaybeUninit;

/// Value behind a pointer.
///
/// # Safety
/// The pointer is null or valid for reading, and any bits are a `T`.
pub(crate) unsafe fn read<T: Copy>(pointer: *const T) -> Result<T, Refusal> {
    if pointer.is_null() {
        return Err(toytop_status::TOYTOP_NULL_POINTER.into());
    }
    // SAFETY: the caller passes a valid pointer that is not null. It need not be aligned.
    Ok(unsafe { pointer.read_unaligned() })
}

/// Writes a value behind a pointer.
///
/// # Safety
/// The pointer is null or valid for writing.
pub(crate) unsafe fn write<T>(pointer: *mut T, value: T) -> Result<(), Refusal> {
    if pointer.is_null() {
        return Err(toytop_status::TOYTOP_NULL_POINTER.into());
    }
    // SAFETY: as in `read`.
    unsafe { pointer.write_unaligned(value) };
    Ok(())
}

/// Value of the crate as C keeps it: a tag of the type, and the words of the value. Words with another tag, such as zeros, are refused.
#[repr(C)]
struct Tagged<T> {
    tag: u32,
    value: MaybeUninit<T>,
}

/// Value of type `T` in a C structure of at least its size, `P`.
///
/// # Safety
/// The pointer is null or valid for reading a `P`. If the words have the tag of `T`, they are as [`store`] wrote them.
pub(crate) unsafe fn load<P, T: Opaque>(place: *const P) -> Result<T, Refusal> {
    const { assert!(size_of::<Tagged<T>>() <= size_of::<P>()) };
    let words = place.cast::<Tagged<T>>();
    // SAFETY: the tag is at the start of the place; any bits are a `u32`.
    let tag = unsafe { read(words.cast::<u32>())? };
    if tag != T::TAG {
        return Err(toytop_status::TOYTOP_NOT_SET_UP.into());
    }
    // SAFETY: the pointer was not null, and the tag tells that `store` wrote the value.
    Ok(unsafe { words.read_unaligned().value.assume_init() })
}

/// Keeps a value in a C structure of at least its size.
///
/// # Safety
/// The pointer is null or valid for writing a `P`.
pub(crate) unsafe fn store<P, T: Opaque>(place: *mut P, value: T) -> Result<(), Refusal> {
    const { assert!(size_of::<Tagged<T>>() <= size_of::<P>()) };
    // SAFETY: the place is at least as large as what is written.
    unsafe { write(place.cast(), Tagged { tag: T::TAG, value: MaybeUninit::new(value) }) }
}

/// Rust type that C holds as opaque bytes.
pub(crate) trait Opaque: Sized {
    /// Number that identifies the type. Memory of another use is unlikely to begin with it.
    const TAG: u32;
}

/// Structure of plain words in which C keeps a value, and the constant of its size in bytes.
macro_rules! opaque {
    ($(#[$size_doc:meta])* $size:ident = $bytes:literal; $(#[$doc:meta])* $name:ident[$words:literal]) => {
$(#[$size_doc])*
pub const $size: usize = $bytes;

$(#[$doc])*
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct $name {
    opaque: [u64; $words],
}

// cbindgen accepts only a number as a length
const _: () = assert!(size_of::<$name>() == $size);
    };
}
pub(crate) use opaque;
