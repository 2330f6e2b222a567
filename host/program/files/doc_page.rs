//! Generated part of a page, between the lines `<!-- toytop COMMAND: NAME -->` and `<!-- end of NAME -->`.
//!
//! A part that takes long is written by its command with `--accept`. Any other is compared by a unit test, which writes it if the
//! environment variable `TOYTOP_ACCEPT` is set.

use super::whole_file;
use std::path::PathBuf;
use toytop_host::Failure;
use toytop_host::input::text_file;

/// Page with a part that a command writes.
pub struct DocPage {
    path: PathBuf,
    /// Page before and after the part.
    around: [String; 2],
}

impl DocPage {
    /// Page of the repository, with a part at a mark `toytop COMMAND: NAME`.
    ///
    /// # Errors
    /// [`Failure::input`], with `--accept` in front: the page is not found, is larger than 16 MiB, or does not contain the lines.
    pub fn read(page: &str, mark: &str) -> Result<Self, Failure> {
        let accept = |failure: Failure| failure.at("--accept");
        let path = repository(page).map_err(accept)?.join(page);
        let text = text_file::read(page, &path, 16).map_err(accept)?;
        let name = mark.split_once(": ").map_or(mark, |(_, name)| name);
        let [begin, end] = [format!("<!-- {mark} -->\n"), format!("<!-- end of {name} -->\n")];
        let parts = text.split_once(&begin).and_then(|(before, rest)| Some((before, rest.split_once(&end)?)));
        let (before, (_, after)) = parts.ok_or_else(|| {
            let reason = format!("must hold the lines {} and {}", begin.trim(), end.trim());
            accept(Failure::input(reason).at(page))
        })?;
        Ok(Self { path, around: [before.to_owned() + &begin, end + after] })
    }

    /// Writes the page with this part.
    ///
    /// # Errors
    /// The failures of [`whole_file::write`].
    pub fn write(&self, part: &str) -> Result<(), Failure> {
        let [before, after] = &self.around;
        whole_file::write("--accept", &self.path, [before, part, after].concat().as_bytes())
    }

    /// Asserts that a page has this part, or with the environment variable `TOYTOP_ACCEPT` writes it.
    #[cfg(test)]
    pub fn assert_current(page: &str, mark: &str, part: &str) {
        let read = Self::read(page, mark).expect(page);
        if std::env::var_os("TOYTOP_ACCEPT").is_some() {
            read.write(part).expect(page);
        }
        let text = std::fs::read_to_string(&read.path).expect(page);
        let is_current = text == [&read.around[0], part, &read.around[1]].concat();
        assert!(is_current, "{page}: stale; with TOYTOP_ACCEPT=1 this test writes it anew:\n{part}");
    }
}

/// Root of the repository: the current folder, or the nearest one above it, that has this file or folder.
///
/// # Errors
/// [`Failure::input`]: there is none.
pub fn repository(path: &str) -> Result<PathBuf, Failure> {
    let folder =
        std::env::current_dir().map_err(|error| Failure::input(format!("current folder: {error}")))?;
    let root = folder.ancestors().find(|root| root.join(path).exists());
    root.map(PathBuf::from)
        .ok_or_else(|| Failure::input(format!("needs {path} in the current folder or one above")))
}
