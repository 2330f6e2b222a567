//! A file that is either there as a whole or not at all, and one that is not read without end.

use crate::Failure;
use std::ffi::{OsStr, OsString};
use std::fs::{self, File};
use std::io::{self, ErrorKind, Read, Write};
use std::path::{Path, PathBuf};
use std::time::Duration;

/// Writes beside the file, then renames: who reads it never sees a half. What is no file (a device, a pipe) is written to as
/// it is, and stays; a link is followed.
///
/// # Errors
/// [`refused`], with `option` and the file in front; nothing is left behind. Who is killed on the way leaves a hidden file, which
/// the next to write the same file removes.
pub fn write(option: &str, path: &Path, bytes: &[u8]) -> Result<(), Failure> {
    write_by(option, path, |file| file.write_all(bytes))
}

/// Writes a file from a function, for content that is not held in memory as a whole.
///
/// # Errors
/// As [`write()`], and what `fill` returns.
pub fn write_by(
    option: &str,
    path: &Path,
    fill: impl FnOnce(&mut File) -> io::Result<()>,
) -> Result<(), Failure> {
    write_whole(path, fill).map_err(|error| refused(option, path, error))
}

fn write_whole(path: &Path, fill: impl FnOnce(&mut File) -> io::Result<()>) -> io::Result<()> {
    let path = followed(path);
    let there = fs::metadata(&path);
    if there.as_ref().is_ok_and(|there| !there.is_file() && !there.is_dir()) {
        return fill(&mut File::create(path)?);
    }
    let name = path.file_name().ok_or(ErrorKind::InvalidInput)?;
    let mut hidden = OsString::from(".");
    hidden.push(name);
    hidden.push(".");
    remove_leftovers(&path, &hidden);
    hidden.push(std::process::id().to_string());
    let beside = path.with_file_name(hidden);
    let written = File::create(&beside).and_then(|mut file| {
        fill(&mut file)?;
        // who may read and write the new file is who might the old one
        there.map_or(Ok(()), |there| fs::set_permissions(&beside, there.permissions()))?;
        fs::rename(&beside, &path)
    });
    if written.is_err() {
        // it may not exist at all
        let _ = fs::remove_file(&beside);
    }
    written
}

/// Target of a path, also where it does not exist yet.
fn followed(path: &Path) -> PathBuf {
    fs::canonicalize(path).unwrap_or_else(|_| match fs::read_link(path) {
        Ok(target) => path.with_file_name(".").join(target),
        Err(_) => path.to_owned(),
    })
}

/// What others have begun and not ended: such a file lives for as long as its bytes take to be written. Who cannot remove it, or
/// look, can still write.
fn remove_leftovers(path: &Path, hidden: &OsStr) {
    let beside = fs::read_dir(path.with_file_name(".")).into_iter().flatten().flatten();
    for entry in beside {
        let name = entry.file_name();
        let process = name.as_encoded_bytes().strip_prefix(hidden.as_encoded_bytes());
        let age = entry.metadata().and_then(|metadata| metadata.modified()).map(|time| time.elapsed());
        if process.is_some_and(|process| process.iter().all(u8::is_ascii_digit))
            && age.is_ok_and(|age| age.is_ok_and(|age| age > LONGEST_WRITE))
        {
            let _ = fs::remove_file(entry.path());
        }
    }
}

/// No writer takes as long between two of its bytes.
const LONGEST_WRITE: Duration = Duration::from_secs(60);

/// A path that is wrong is bad input; a disk that is full, or fails, is not.
pub fn refused(option: &str, path: &Path, error: io::Error) -> Failure {
    let message = format!("{option}: {}: {error}", path.display());
    match error.kind() {
        ErrorKind::StorageFull
        | ErrorKind::QuotaExceeded
        | ErrorKind::FileTooLarge
        | ErrorKind::WriteZero
        | ErrorKind::BrokenPipe => Failure::Output(io::Error::new(error.kind(), message)),
        _ if error.raw_os_error() == Some(EIO) => Failure::Output(io::Error::new(error.kind(), message)),
        _ => Failure::Input(message),
    }
}

/// The device failed.
const EIO: i32 = 5;

/// The text of a file of at most so many MiB.
///
/// # Errors
/// [`Failure::Input`] with `name` in front: it cannot be read, is larger, or is not UTF-8.
pub fn read(name: &str, path: &Path, most_mebibytes: u64) -> Result<String, Failure> {
    let refuse = |reason: String| Failure::Input(format!("{name}: {reason}"));
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

#[cfg(all(test, unix))]
mod tests {
    use super::*;
    use std::os::unix::fs::{PermissionsExt, symlink};

    /// A link to nothing gets its target; a file that only its owner may read stays so.
    #[test]
    fn links_and_modes_are_kept() {
        let folder = std::env::temp_dir().join(format!("toytop_whole_file_{}", std::process::id()));
        fs::create_dir_all(&folder).unwrap();
        let [target, link] = ["target", "link"].map(|name| folder.join(name));
        symlink("target", &link).unwrap();
        write("-o", &link, b"one").unwrap();
        assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
        assert_eq!(fs::read(&target).unwrap(), b"one");
        fs::set_permissions(&target, fs::Permissions::from_mode(0o600)).unwrap();
        write("-o", &link, b"two").unwrap();
        assert_eq!(fs::read(&target).unwrap(), b"two");
        assert_eq!(fs::metadata(&target).unwrap().permissions().mode() & 0o777, 0o600);
        fs::remove_dir_all(&folder).unwrap();
    }
}
