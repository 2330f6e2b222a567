//! `cargo xtask size`: tokens of Rust by room, without comments, whitespace and unit tests, compared with their caps.

use std::fs;
use std::path::Path;

use anyhow::{Context, Result, bail};
use regex_lite::Regex;

use crate::process::root;

/// Comments; strings and characters; names, numbers and operators of one or two characters. Each alternative is one token. A quote is
/// \x22, so that this file is counted right too.
const TOKEN: &str = r"(?s)(//[^\n]*|/\*.*?\*/)|b?r#+\x22.*?\x22#+|b?r\x22.*?\x22|b?\x22(?:\\.|[^\x22\\])*\x22|'(?:\\.|[^\\'])'|'?[A-Za-z_][A-Za-z_0-9]*!?|\d[\w.]*|::|->|=>|\.\.=?|[-+*/%&|^<>=!]=|&&|\|\||<<|>>|\S";
/// Start of a module of unit tests, which is the end of the file.
const UNIT_TESTS: &str = "#[cfg(test)]\nmod tests";
/// Greatest number of words in the comments of core/src.
const MAX_WORDS: usize = 20_000;

/// Part of the repository with its greatest number of tokens.
struct Room {
    /// Folder. A file belongs to the last room that contains it.
    folder: &'static str,
    cap: usize,
}

const fn room(folder: &'static str, cap: usize) -> Room {
    Room { folder, cap }
}

const ROOMS: &[Room] = &[
    room("core/src/", 75_000),
    room("core/fit/", 30_000),
    room("core/closed-forms/", 17_000),
    room("core/c/", 14_000),
    room("host/", 118_000),
    room("host/tests/", 36_000),
    room("host/xtask/", 12_000),
    room("tests/", 80_000),
    room("firmware-examples/", 28_000),
];

/// Tokens of code and of unit tests, and words of comments outside of the latter.
#[derive(Default)]
struct Size {
    files: usize,
    code: usize,
    tests: usize,
    words: usize,
}

impl Size {
    fn add(&mut self, text: &str, token: &Regex) {
        let (code, tests) = text.split_at(text.find(UNIT_TESTS).unwrap_or(text.len()));
        self.files += 1;
        for found in token.captures_iter(code) {
            match found.get(1) {
                Some(comment) => self.words += comment.as_str().split_whitespace().count() - 1,
                None => self.code += 1,
            }
        }
        self.tests += token.captures_iter(tests).filter(|found| found.get(1).is_none()).count();
    }
}

/// Prints the table, and refuses a room above its cap.
pub(crate) fn check() -> Result<String> {
    let token = Regex::new(TOKEN).expect("a regular expression");
    let mut files = Vec::new();
    for folder in ["core", "host", "tests", "firmware-examples"] {
        collect(folder, &mut files)?;
    }
    let mut table = format!(
        "{:18}{:>9}{:>9}{:>12}{:>7}{:>10}\n",
        "room", "tokens", "cap", "unit tests", "files", "comments"
    );
    let mut above = Vec::new();
    // a room inside another one stands after it; the tests of a crate in host/ count with the tests of the binary
    let room_of = |path: &str| {
        let path = if path.starts_with("host/") && path.contains("/tests/") { "host/tests/" } else { path };
        ROOMS.iter().rposition(|room| path.starts_with(room.folder))
    };
    for (index, room) in ROOMS.iter().enumerate() {
        let mut size = Size::default();
        for path in files.iter().filter(|path| room_of(path) == Some(index)) {
            size.add(&fs::read_to_string(root().join(path)).with_context(|| path.clone())?, &token);
        }
        let Size { files, code, tests, words } = size;
        let cap = room.cap;
        table += &format!("{:18}{code:9}{cap:9}{tests:12}{files:7}{words:10}\n", room.folder);
        if code > cap {
            above.push(format!("{}: {code} tokens, at most {cap}", room.folder));
        }
        if room.folder == "core/src/" && words > MAX_WORDS {
            above.push(format!("{}: {words} words of comments, at most {MAX_WORDS}", room.folder));
        }
    }
    if above.is_empty() { Ok(table) } else { bail!("{table}{}", above.join("\n")) }
}

/// Paths of the Rust files below a folder, from the root of the repository.
fn collect(folder: &str, files: &mut Vec<String>) -> Result<()> {
    for entry in fs::read_dir(root().join(folder))? {
        let entry = entry?;
        let name = entry.file_name().to_string_lossy().into_owned();
        let path = format!("{folder}/{name}");
        if entry.file_type()?.is_dir() {
            if name != "target" && !name.starts_with('.') {
                collect(&path, files)?;
            }
        } else if Path::new(&name).extension().is_some_and(|ending| ending == "rs") {
            files.push(path);
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn comments_and_unit_tests_count_apart() {
        let text = "/// Two words.\nfn f<'a>(x: &'a str) -> bool { x != \"// none\" } // one\n#[cfg(test)]\nmod tests {}\n";
        let mut size = Size::default();
        size.add(text, &Regex::new(TOKEN).expect("a regular expression"));
        assert_eq!((size.code, size.tests, size.words), (19, 11, 3));
    }
}
