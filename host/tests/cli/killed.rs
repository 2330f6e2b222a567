//! The program killed on its way, and what it left.

use super::PROGRAM;
use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

/// Files by name, without those still being written, whose names begin with a dot.
pub(super) fn files(folder: &Path) -> Vec<(String, Vec<u8>)> {
    let entries = fs::read_dir(folder).expect("the folder").map(|entry| entry.expect("an entry"));
    let mut files: Vec<_> = entries
        .map(|entry| (entry.file_name().into_string().expect("UTF-8"), entry.path()))
        .filter(|(name, _)| !name.starts_with('.'))
        .map(|(name, path)| (name, fs::read(path).expect("a file")))
        .collect();
    files.sort();
    files
}

/// Starts a command and kills it after a while, looking all the time at what is there; whether it was still running.
pub(super) fn killed(arguments: &[&str], after: Duration, look: impl Fn()) -> bool {
    let started = Instant::now();
    let mut child = Command::new(PROGRAM)
        .args(arguments)
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .expect("the program runs");
    while started.elapsed() < after {
        look();
        sleep(Duration::from_micros(100));
    }
    child.kill().expect("it can be killed");
    let whole = child.wait().expect("it ends").success();
    look();
    !whole
}

/// What a picture or a page ends with.
pub(super) fn is_whole(name: &str, bytes: &[u8]) -> bool {
    let end: &[u8] = match name.rsplit('.').next() {
        Some("svg") => b"</svg>",
        Some("png") => b"IEND\xaeB`\x82",
        Some("html") => b"</html>",
        _ => return false,
    };
    bytes.trim_ascii_end().ends_with(end)
}
