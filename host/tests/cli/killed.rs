//! Processes of the program that are killed, and the files that they leave.

use super::PROGRAM;
use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

/// Files of a folder with their names, without hidden files, which are not complete.
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

/// Whether a command was still running when it was killed after a time. `look` is called repeatedly before.
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

/// Whether a picture or a page has its end.
pub(super) fn is_whole(name: &str, bytes: &[u8]) -> bool {
    let end: &[u8] = match name.rsplit('.').next() {
        Some("svg") => b"</svg>",
        Some("png") => b"IEND\xaeB`\x82",
        Some("html") => b"</html>",
        _ => return false,
    };
    bytes.trim_ascii_end().ends_with(end)
}
