//! Text of a file.

use crate::Failure;
use std::fs::File;
use std::io::Read;
use std::path::Path;

/// Text of a file of at most `most_mebibytes` MiB.
///
/// # Errors
/// [`Failure::input`] with `name` in front: it cannot be read, is larger, or is not UTF-8.
pub fn read(name: &str, path: &Path, most_mebibytes: u64) -> Result<String, Failure> {
    let refuse = |reason: String| Failure::input(reason).at(name);
    let most = most_mebibytes << 20;
    let mut bytes = Vec::new();
    File::open(path)
        .and_then(|open| open.take(most + 1).read_to_end(&mut bytes))
        .map_err(|error| refuse(error.to_string()))?;
    if bytes.len() as u64 > most {
        return Err(refuse(format!("must be at most {most_mebibytes} MiB")));
    }
    String::from_utf8(bytes).map_err(|_| refuse("must be UTF-8".to_owned()))
}
