//! Set-up of a table, and the number of segments that it needs.

use crate::memory::load;
use crate::motion::toytop_motion;
use crate::status::{Refusal, toytop_status};
use crate::table::{Memory, TOYTOP_EPHEMERIS_ALIGNMENT, toytop_tick};
use core::ffi::c_void;
use toytop::{EphemerisScalar, EphemerisView, Motion, TableSettings, Tick, Workspace};

/// Bytes of the workspace of a set-up.
pub const TOYTOP_WORKSPACE_SIZE: usize = 3432;

/// Workspace of a set-up, which need not be initialised, and which a program may use for something else afterwards.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct toytop_workspace {
    opaque: [u64; 429],
}

/// Function that a set-up calls again and again, at least every 50 000 cycles of a Cortex-M4F: to feed a watchdog, or to read another table.
pub type toytop_pause = Option<unsafe extern "C" fn(context: *mut c_void)>;

// cbindgen accepts only a number as a length
const _: () = assert!(
    size_of::<toytop_workspace>() == TOYTOP_WORKSPACE_SIZE
        && size_of::<Workspace>() + align_of::<Workspace>() - TOYTOP_EPHEMERIS_ALIGNMENT
            <= TOYTOP_WORKSPACE_SIZE
);

/// Launch that a table is set up for.
pub(crate) struct Launched {
    pub(crate) motion: *const toytop_motion,
    pub(crate) tick: toytop_tick,
    pub(crate) epoch: i64,
    /// Greatest truncation error, rad; 0 stands for that of the scalar.
    pub(crate) truncation: f64,
}

/// Sets up a table in memory of the caller, which need not be initialised.
///
/// # Safety
/// `table` is null or valid for writing `size` bytes, `workspace` is null or valid for writing, and nobody else uses them until this returns.
/// The motion is null or valid for reading. `pause` may be called with `context`.
pub(crate) unsafe fn set_up_in<R: EphemerisScalar>(
    (table, size): (*mut u8, usize),
    workspace: *mut toytop_workspace,
    launched: Launched,
    (pause, context): (toytop_pause, *mut c_void),
) -> Result<(), Refusal> {
    let memory = Memory::new::<R>(table, size)?;
    // SAFETY: the caller guarantees valid memory.
    let cleared = unsafe { memory.clear::<R>() };
    if workspace.is_null() {
        return Err(toytop_status::TOYTOP_NULL_POINTER.into());
    }
    if !workspace.is_aligned() {
        return Err(toytop_status::TOYTOP_BAD_MEMORY.into());
    }
    // a computer may align the numbers of a set-up to more bytes, for which there is room
    let bytes = workspace.cast::<u8>();
    let workspace = bytes.wrapping_add(bytes.align_offset(align_of::<Workspace>())).cast::<Workspace>();
    // SAFETY: the caller guarantees a valid pointer.
    let motion: Motion = unsafe { load(launched.motion)? };
    let tick = Tick::ratio(launched.tick.ticks, launched.tick.seconds)?;
    // SAFETY: the pointer is neither null nor unaligned, and the memory is large enough.
    let workspace = unsafe {
        workspace.write(Workspace::new());
        &mut *workspace
    };
    let truncation = (launched.truncation != 0.0).then_some(launched.truncation);
    let settings = TableSettings { tick, epoch: launched.epoch, truncation };
    let mut call = || {
        if let Some(pause) = pause {
            // SAFETY: the caller guarantees that it may be called.
            unsafe { pause(context) };
        }
    };
    cleared.set_up(workspace, &motion, &settings, &mut call)?;
    // SAFETY: `clear` was called on this memory before.
    unsafe { memory.ready::<R>() };
    Ok(())
}

/// Sets up a table with the workspace on the stack: see [`set_up_in`].
///
/// # Safety
/// The conditions are those of [`set_up_in`].
#[inline(never)]
pub(crate) unsafe fn set_up_on_stack<R: EphemerisScalar>(
    table: (*mut u8, usize),
    launched: Launched,
) -> Result<(), Refusal> {
    let mut workspace = core::mem::MaybeUninit::uninit();
    // SAFETY: as the caller guarantees, and the workspace is a local variable.
    unsafe { set_up_in::<R>(table, workspace.as_mut_ptr(), launched, (None, core::ptr::null_mut())) }
}

/// Number of segments that is enough; 0 where no number is, or a parameter is refused.
///
/// # Safety
/// `motion` is null or valid for reading.
pub(crate) unsafe fn segments_needed<R: EphemerisScalar>(
    motion: *const toytop_motion,
    truncation: f64,
) -> u32 {
    // SAFETY: the caller guarantees a valid pointer.
    let motion: Result<Motion, Refusal> = unsafe { load(motion) };
    let truncation = if truncation == 0.0 { R::TRUNCATION } else { truncation };
    motion.ok().and_then(|motion| EphemerisView::<R>::segments_needed(&motion, truncation)).unwrap_or(0)
}
