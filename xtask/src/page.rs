//! Pages of host/docs, whose figures a command writes between two marks.

use std::fs;

use anyhow::{Context, Result};

use crate::process::root;

/// What stands between a page's marks, by a function of what stood there.
pub(crate) fn rewrite(page: &str, [begin, end]: [&str; 2], new: impl FnOnce(&str) -> String) -> Result<()> {
    let path = root().join(page);
    let text = fs::read_to_string(&path)?;
    let (before, rest) = text.split_once(begin).with_context(|| format!("{page}: no {begin}"))?;
    let (old, after) = rest.split_once(end).with_context(|| format!("{page}: no {end}"))?;
    fs::write(path, format!("{before}{begin}{}{end}{after}", new(old)))?;
    Ok(())
}
