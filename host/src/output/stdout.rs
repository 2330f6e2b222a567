//! Standard output, which may be closed.

use std::io;
use std::sync::atomic::{AtomicBool, Ordering::Relaxed};

/// Whether stdout was closed when the process began. The standard library then opens a device in its place, which accepts everything.
static CLOSED: AtomicBool = AtomicBool::new(false);

#[cfg(target_os = "linux")]
#[used]
// SAFETY: the system calls the functions of this section before `main`, and ignores nothing that this one returns
#[unsafe(link_section = ".init_array")]
static BEFORE_MAIN: extern "C" fn() = look;

#[cfg(target_os = "linux")]
extern "C" fn look() {
    CLOSED.store(std::fs::symlink_metadata("/proc/self/fd/1").is_err(), Relaxed);
}

/// Refuses a stdout that was closed.
///
/// # Errors
/// It was closed.
pub fn require_open() -> io::Result<()> {
    if CLOSED.load(Relaxed) { Err(io::Error::other("stdout is closed")) } else { Ok(()) }
}
