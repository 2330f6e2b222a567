//! Set-up of a table, and the number of segments that it needs.

use crate::memory::{load, opaque, read};
use crate::motion::{call_of, toytop_motion, toytop_pause};
use crate::status::{Refusal, status_of, toytop_error, toytop_status};
use crate::table::*;
use core::ffi::c_void;
use toytop::{Motion, TableScalar, TableSettings, Tick, Workspace};
use toytop_c_set_up::{F32, F64, Q31, SetUp};

opaque! {
/// Bytes of the workspace of a set-up.
TOYTOP_WORKSPACE_SIZE = 3432;

/// Workspace of a set-up, which need not be initialised, and which a program may use for something else afterwards.
toytop_workspace[429]
}

const _: () = assert!(
    size_of::<Workspace>() + align_of::<Workspace>() - TOYTOP_TABLE_ALIGNMENT <= TOYTOP_WORKSPACE_SIZE
);

/// Length of a tick, as an exact fraction of a second: `ticks` ticks in `seconds` seconds.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct toytop_tick {
    /// Number of ticks, at least 1.
    pub ticks: u32,
    /// Number of seconds, at least 1.
    pub seconds: u32,
}

/// Settings of a table. The default of each one but the tick is 0 or null.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct toytop_settings {
    /// Length of a tick, such as {1000, 1} for 1 kHz.
    pub tick: toytop_tick,
    /// Tick of the launch on a running counter.
    pub epoch: i64,
    /// Allowed truncation error, rad: a smaller table for a larger error. 0 stands for the default of the scalar.
    pub truncation: f64,
    /// Workspace of the set-up; null for one on the stack.
    pub workspace: *mut toytop_workspace,
    /// Function that the set-up calls; null for none.
    pub pause: toytop_pause,
    /// Argument of `pause`.
    pub context: *mut c_void,
}

/// Truncation error; 0 stands for the default of the scalar.
fn truncation_of<R: TableScalar>(given: f64) -> f64 {
    if given == 0.0 { R::TRUNCATION } else { given }
}

/// Sets up a table in memory of the caller, which need not be initialised.
///
/// # Safety
/// `table` is null or valid for writing `size` bytes, and nobody else uses it until this returns. The motion and the settings are null or
/// valid for reading, and so is each pointer of the settings for its purpose.
unsafe fn set_up<R: TableScalar>(
    table: *mut u8,
    size: usize,
    motion: *const toytop_motion,
    settings: *const toytop_settings,
    compiled: &SetUp<R>,
) -> Result<(), Refusal> {
    // SAFETY: the caller guarantees valid pointers.
    let (table, motion, settings): (_, Motion, _) =
        unsafe { (empty_table::<R>(table, size)?, load(motion)?, read(settings)?) };
    let toytop_settings { tick, epoch, truncation, workspace, pause, context } = settings;
    let tick = Tick::ratio(tick.ticks, tick.seconds)?;
    let settings = TableSettings { tick, epoch, truncation: Some(truncation_of::<R>(truncation)) };
    // SAFETY: the caller guarantees that the pause may be called.
    let mut pause = unsafe { call_of(pause, context) };
    let mut set_up = |workspace: &mut Workspace| -> Result<(), Refusal> {
        (compiled.set_up)(table, workspace, &motion, settings, &mut pause)?;
        Ok(())
    };
    if workspace.is_null() {
        return with_workspace_on_stack(set_up);
    }
    if !workspace.is_aligned() {
        return Err(toytop_status::TOYTOP_BAD_MEMORY.into());
    }
    // a computer may align the numbers of a set-up to more bytes, for which there is room
    let bytes = workspace.cast::<u8>();
    let workspace = bytes.wrapping_add(bytes.align_offset(align_of::<Workspace>())).cast::<Workspace>();
    // SAFETY: the pointer is neither null nor unaligned, and the memory is large enough.
    let workspace = unsafe {
        workspace.write(Workspace::new());
        &mut *workspace
    };
    set_up(workspace)
}

// apart, so that a set-up in the caller's workspace does not reserve stack for another one
#[inline(never)]
fn with_workspace_on_stack(
    set_up: impl FnOnce(&mut Workspace) -> Result<(), Refusal>,
) -> Result<(), Refusal> {
    set_up(&mut Workspace::new())
}

macro_rules! functions {
    ($name:ident, $scalar:ty, $table:ty, $orientation:ty, $rate:ty) => { pastey::paste! {

/// Sets up a table in memory of the caller, which need not be initialised. It takes too long for an interrupt.
///
/// Refusals name `tick` or `truncation`, or say that the segments are not enough for this motion, or that it is aperiodic. After a refusal
/// every function that reads the table returns `TOYTOP_NOT_SET_UP`. A refusal of `table` or `size` changes nothing. `error` may be null.
///
/// * `size`: bytes of the memory, `sizeof *table`, or the size for another number of segments (from 8 to 4096)
#[unsafe(no_mangle)]
pub unsafe extern "C" fn [<toytop_ $name _set_up>](
    table: *mut $table,
    size: usize,
    motion: *const toytop_motion,
    settings: *const toytop_settings,
    error: *mut toytop_error,
) -> toytop_status {
    // SAFETY: the caller guarantees valid pointers.
    unsafe { status_of(error, || set_up(table.cast(), size, motion, settings, &[<$name:upper>])) }
}

/// Number of segments of a table that is enough for a motion; 0 if 4096, the largest number, are not, or if `set_up` would refuse. A
/// table has at least 8. The call costs what a set-up costs, and has no pauses.
///
/// * `truncation`: allowed truncation error, rad; 0 stands for the default of the scalar
#[unsafe(no_mangle)]
pub unsafe extern "C" fn [<toytop_ $name _segments_needed>](motion: *const toytop_motion, truncation: f64) -> u32 {
    let truncation = truncation_of::<$scalar>(truncation);
    let needed = |motion| ([<$name:upper>].segments_needed)(&motion, truncation).ok();
    // SAFETY: the caller guarantees a valid pointer.
    unsafe { load(motion) }.ok().and_then(needed).unwrap_or(0)
}

    } };
}

for_each_scalar!(functions);
