//! Files, each of which is written completely or not at all.

use std::fs::{self, File};
use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};
use tempfile::NamedTempFile;
use toytop_host::Failure;

/// Writes a file under a temporary name and then renames it, so that no reader sees half a file and no other file is touched. A device or a
/// pipe is written to directly. A link is followed to its target.
///
/// # Errors
/// The failures of [`refused`], which name `option` and the file; the temporary file is then removed.
pub fn write(option: &str, path: &Path, bytes: &[u8]) -> Result<(), Failure> {
    write_by(option, path, |file| file.write_all(bytes))
}

/// Writes a file by a function, for content that is not completely in memory.
///
/// # Errors
/// The failures of [`write()`], and those that `fill` returns.
pub fn write_by(
    option: &str,
    path: &Path,
    fill: impl FnOnce(&mut File) -> io::Result<()>,
) -> Result<(), Failure> {
    write_temporary(path, fill).and_then(give_name).map_err(|error| refused(option, path, error))
}

/// Writes files as [`write()`] does, and names them after all are written. If naming one fails, those before it stay.
///
/// # Errors
/// The failures of [`write()`].
pub fn write_all(files: &[(&str, &Path, Vec<u8>)]) -> Result<(), Failure> {
    let mut written = Vec::new();
    for (option, path, bytes) in files {
        let file = write_temporary(path, |file| file.write_all(bytes));
        written.push(file.map_err(|error| refused(option, path, error))?);
    }
    for (file, (option, path, _)) in written.into_iter().zip(files) {
        give_name(file).map_err(|error| refused(option, path, error))?;
    }
    Ok(())
}

/// Complete file under a temporary name, with its path; `None` for a device or a pipe, which is written to directly.
type TemporaryFile = Option<(NamedTempFile, PathBuf)>;

fn write_temporary(path: &Path, fill: impl FnOnce(&mut File) -> io::Result<()>) -> io::Result<TemporaryFile> {
    let path = link_target(path);
    let old = fs::metadata(&path);
    if old.as_ref().is_ok_and(|old| !old.is_file() && !old.is_dir()) {
        return fill(&mut File::create(path)?).map(|()| None);
    }
    path.file_name().ok_or(ErrorKind::InvalidInput)?;
    let folder = path.with_file_name(".");
    // without this, the message for a missing folder would name the temporary file
    fs::metadata(&folder)?;
    let mut builder = tempfile::Builder::new();
    builder.prefix(".toytop");
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    let mut file = builder.tempfile_in(folder)?;
    fill(file.as_file_mut())?;
    // the new file has the permissions of the old one
    old.map_or(Ok(()), |old| file.as_file().set_permissions(old.permissions()))?;
    Ok(Some((file, path)))
}

/// Gives a file its name.
fn give_name(file: TemporaryFile) -> io::Result<()> {
    let Some((file, path)) = file else { return Ok(()) };
    file.persist(path).map(drop).map_err(|error| error.error)
}

/// Target of a path, which may not exist yet.
fn link_target(path: &Path) -> PathBuf {
    fs::canonicalize(path).unwrap_or_else(|_| match fs::read_link(path) {
        Ok(target) => path.with_file_name(".").join(target),
        Err(_) => path.to_owned(),
    })
}

/// Refuses an output that is one of the inputs.
///
/// # Errors
/// [`Failure::input`].
pub fn require_other(option: &str, output: Option<&Path>, inputs: &[Option<&Path>]) -> Result<(), Failure> {
    let existing = |path: &Path| fs::canonicalize(path).ok().filter(|path| path.is_file());
    let Some(target) = output.and_then(existing) else { return Ok(()) };
    if inputs.iter().flatten().any(|input| existing(input).as_ref() == Some(&target)) {
        let name = target.display().to_string();
        return Err(Failure::input("must not be a file that the command reads").at(name).at(option));
    }
    Ok(())
}

/// Failure of a file: bad input for a wrong path, otherwise an output that cannot be written.
pub fn refused(option: &str, path: &Path, error: io::Error) -> Failure {
    let message = format!("{option}: {}: {error}", path.display());
    // `Other`: of threads or of an encoder, never of the operating system
    let is_of_the_system = matches!(
        error.kind(),
        ErrorKind::StorageFull
            | ErrorKind::QuotaExceeded
            | ErrorKind::FileTooLarge
            | ErrorKind::WriteZero
            | ErrorKind::BrokenPipe
            | ErrorKind::Other
    );
    if is_of_the_system || (cfg!(unix) && error.raw_os_error() == Some(EIO)) {
        Failure::output(io::Error::new(error.kind(), message))
    } else {
        Failure::input(message)
    }
}

/// Error number of Unix for a device that failed.
const EIO: i32 = 5;

#[cfg(test)]
mod tests {
    use super::*;
    #[cfg(unix)]
    use std::os::unix::fs::{PermissionsExt, symlink};

    /// Threads that do not start and an encoder that fails are not bad input, and leave no file.
    #[test]
    fn a_failure_of_the_content_is_one_of_the_system() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("out.csv");
        let failure = write_by("-o", &path, |_| Err(io::Error::other("no threads"))).unwrap_err();
        assert_eq!(failure.kind as i32, 1);
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 0);
    }

    /// A link to a missing file creates its target, and the permissions of a file are kept.
    #[cfg(unix)]
    #[test]
    fn links_and_modes_are_kept() {
        let folder = tempfile::tempdir().unwrap();
        let [target, link] = ["target", "link"].map(|name| folder.path().join(name));
        symlink("target", &link).unwrap();
        write("-o", &link, b"one").unwrap();
        assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
        assert_eq!(fs::read(&target).unwrap(), b"one");
        fs::set_permissions(&target, fs::Permissions::from_mode(0o600)).unwrap();
        write("-o", &link, b"two").unwrap();
        assert_eq!(fs::read(&target).unwrap(), b"two");
        assert_eq!(fs::metadata(&target).unwrap().permissions().mode() & 0o777, 0o600);
    }
}
