//! Pages of host/docs with figures that a command writes between two marks.

use std::fs;

use anyhow::{Context, Result};

use crate::process::root;

/// Rewrites the text between the marks of a page, by a function of the old text.
pub(crate) fn rewrite(page: &str, [begin, end]: [&str; 2], new: impl FnOnce(&str) -> String) -> Result<()> {
    let path = root().join(page);
    let text = fs::read_to_string(&path)?;
    let (before, rest) = text.split_once(begin).with_context(|| format!("{page}: no {begin}"))?;
    let (old, after) = rest.split_once(end).with_context(|| format!("{page}: no {end}"))?;
    fs::write(path, format!("{before}{begin}{}{end}{after}", new(old)))?;
    Ok(())
}
