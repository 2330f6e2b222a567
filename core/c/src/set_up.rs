//! Set-up of a table, at once or in slices, and the number of segments that it needs.

use crate::memory::{Kept, keep, kept, kept_mut};
use crate::motion::toytop_motion;
use crate::status::{Refusal, status_of, toytop_error, toytop_status};
use crate::table::{Memory, TOYTOP_EPHEMERIS_ALIGNMENT, Tabulated, toytop_tick};
use core::task::Poll;
use toytop::{EphemerisView, Motion, ParameterError, SetUp, TableTooSmall, Tick};

/// Bytes of a set-up.
pub const TOYTOP_SET_UP_SIZE: usize = 6400;

/// Set-up of one table in slices, which is needed until the table is ready. A program must not use its words.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct toytop_set_up {
    opaque: [u64; 800],
}

// cbindgen accepts only a number as a length
const _: () = assert!(
    size_of::<toytop_set_up>() == TOYTOP_SET_UP_SIZE
        && align_of::<toytop_set_up>() == TOYTOP_EPHEMERIS_ALIGNMENT
);

/// Set-up with the table that it belongs to.
struct Slices {
    set_up: SetUp,
    table: Option<Claim>,
    /// Result of the last slice.
    ended: Option<Result<(), TableTooSmall>>,
}

/// Memory that the first slice was given, and the tag of its scalar.
type Claim = (Memory, u32);

impl Kept for Slices {
    const TAG: u32 = 0x746f_7075;
}

/// Truncation error that a caller gives, rad, or `None` for four roundings of the scalar.
fn given(truncation: f64) -> Result<Option<f64>, Refusal> {
    match truncation {
        0.0 => Ok(None),
        given if given.is_finite() && given > 0.0 => Ok(Some(given)),
        _ => {
            let allowed = "positive, or 0 for four roundings of the scalar";
            Err(ParameterError::OutOfRange { parameter: "truncation", allowed }.into())
        }
    }
}

/// Sets up a table in memory of the caller, which need not be initialised.
///
/// * `truncation`: greatest truncation error, rad; 0 stands for four roundings of the scalar
///
/// # Safety
/// `table` is null or valid for writing `size` bytes, and nobody else uses them until this returns. `motion` is null or
/// valid for reading.
pub(crate) unsafe fn at_once<R: Tabulated>(
    table: *mut u8,
    size: usize,
    motion: *const toytop_motion,
    tick: toytop_tick,
    truncation: f64,
) -> Result<(), Refusal> {
    let memory = Memory::of::<R>(table, size)?;
    // SAFETY: the caller guarantees valid memory.
    let view = unsafe { memory.clear::<R>() };
    // SAFETY: the caller guarantees a valid pointer.
    let motion: Motion = unsafe { kept(motion)? };
    let tick = Tick::ratio(tick.ticks, tick.seconds)?;
    view.set_up(&motion, tick, given(truncation)?.unwrap_or(4.0 * R::ROUNDING))?;
    // SAFETY: see above.
    unsafe { memory.ready::<R>() };
    Ok(())
}

/// Performs the next slice of a set-up.
///
/// # Safety
/// `set_up` is null or valid for reading and writing; `table` is as for [`at_once`], until the last slice returns.
pub(crate) unsafe fn poll<R: Tabulated>(
    set_up: *mut toytop_set_up,
    table: *mut u8,
    size: usize,
) -> Result<(), Refusal> {
    let refused = |allowed| ParameterError::OutOfRange { parameter: "table", allowed };
    // SAFETY: the caller guarantees a valid pointer.
    let slices: &mut Slices = unsafe { kept_mut(set_up)? };
    let memory = Memory::of::<R>(table, size)?;
    let claim = (memory, R::TAG);
    if slices.table.is_some_and(|first| first != claim) {
        return Err(refused("that of the first slice, and of the same size").into());
    }
    if let Some(result) = slices.ended {
        return Ok(result?);
    }
    let begun = match slices.table.replace(claim) {
        // SAFETY: the caller guarantees valid memory.
        None => Some(unsafe { memory.clear::<R>() }),
        // SAFETY: the first slice, of the same scalar, cleared the same memory.
        Some(_) => unsafe { memory.begun::<R>() },
    };
    let view = begun.ok_or(refused("left alone until its set-up ends"))?;
    let Poll::Ready(result) = slices.set_up.poll(view) else {
        return Err(toytop_status::TOYTOP_PENDING.into());
    };
    slices.ended = Some(result);
    result?;
    // SAFETY: see above.
    unsafe { memory.ready::<R>() };
    Ok(())
}

/// Number of segments that is enough; 0 where no number is, or a parameter is refused.
///
/// # Safety
/// `motion` is null or valid for reading.
pub(crate) unsafe fn segments_needed<R: Tabulated>(motion: *const toytop_motion, truncation: f64) -> u32 {
    // SAFETY: the caller guarantees a valid pointer.
    let motion: Result<Motion, Refusal> = unsafe { kept(motion) };
    let (Ok(motion), Ok(truncation)) = (motion, given(truncation)) else {
        return 0;
    };
    let allowed = truncation.unwrap_or(4.0 * R::ROUNDING);
    EphemerisView::<R>::segments_needed(&motion, allowed).unwrap_or_default()
}

/// Begins a set-up in slices, for a program that has other work in between, such as feeding a watchdog. The slices are computed by
/// `toytop_f32_set_up_poll`, or the function of another scalar, which must be called until it no longer returns `TOYTOP_PENDING`.
///
/// Refusals name `tick` or `truncation`. `error` may be null. The motion is copied.
///
/// * `truncation`: greatest truncation error, rad; 0 stands for four roundings of the scalar
///
/// # Safety
/// Each pointer is null or points to an object of its type.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn toytop_set_up_begin(
    set_up: *mut toytop_set_up,
    motion: *const toytop_motion,
    tick: toytop_tick,
    truncation: f64,
    error: *mut toytop_error,
) -> toytop_status {
    let result = || -> Result<(), Refusal> {
        if !set_up.is_aligned() {
            return Err(toytop_status::TOYTOP_BAD_MEMORY.into());
        }
        // SAFETY: the caller guarantees valid pointers, here and below.
        let motion: Motion = unsafe { kept(motion)? };
        let tick = Tick::ratio(tick.ticks, tick.seconds)?;
        let begun = match given(truncation)? {
            None => SetUp::new(&motion, tick),
            Some(truncation) => SetUp::within(&motion, tick, truncation),
        };
        // SAFETY: see above.
        unsafe { keep(set_up, Slices { set_up: begun, table: None, ended: None }) }
    };
    // SAFETY: see above.
    unsafe { status_of(result(), error) }
}
