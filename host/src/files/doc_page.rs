//! Parts of a page that a command writes, between the lines `<!-- toytop COMMAND: NAME -->` and `<!-- end of NAME -->`. The rest of the
//! page does not change.

use super::whole_file;
use crate::Failure;
use crate::input::text_file;
use std::path::{Path, PathBuf};

/// Page with a part that a command writes.
pub struct DocPage {
    path: PathBuf,
    /// Text up to the first line of the mark, and from the last one on.
    around: [String; 2],
}

impl DocPage {
    /// Page of a file, with a part at a mark `toytop COMMAND: NAME`.
    ///
    /// # Errors
    /// [`Failure::Input`], with `--accept` in front: the page cannot be read, is larger than 16 MiB, or does not contain the lines.
    pub fn read(path: &Path, mark: &str) -> Result<Self, Failure> {
        let page = format!("--accept: {}", path.display());
        let text = text_file::read(&page, path, 16)?;
        let name = mark.split_once(": ").map_or(mark, |(_, name)| name);
        let [begin, end] = [format!("<!-- {mark} -->\n"), format!("<!-- end of {name} -->\n")];
        let found = text.split_once(&begin).and_then(|(before, rest)| Some((before, rest.split_once(&end)?)));
        let (before, (_, after)) = found.ok_or_else(|| {
            Failure::Input(format!("{page}: must hold the lines {} and {}", begin.trim(), end.trim()))
        })?;
        Ok(Self { path: path.to_owned(), around: [before.to_owned() + &begin, end + after] })
    }

    /// Writes the page with this part.
    ///
    /// # Errors
    /// The failures of [`whole_file::write`].
    pub fn write(&self, part: &str) -> Result<(), Failure> {
        let [before, after] = &self.around;
        whole_file::write("--accept", &self.path, [before, part, after].concat().as_bytes())
    }
}
