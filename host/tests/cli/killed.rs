//! Commands that are killed while they write.

use crate::command::command;
use std::process::Stdio;
use std::thread::sleep;
use std::time::{Duration, Instant};

/// Whether a command was still running when it was killed after a time. `look` is called repeatedly before.
pub(crate) fn killed(line: &str, after: Duration, look: impl Fn()) -> bool {
    let started = Instant::now();
    let mut child =
        command(line).stdout(Stdio::null()).stderr(Stdio::null()).spawn().expect("the program runs");
    while started.elapsed() < after {
        look();
        sleep(Duration::from_micros(100));
    }
    child.kill().expect("it can be killed");
    let is_whole = child.wait().expect("it ends").success();
    look();
    !is_whole
}
