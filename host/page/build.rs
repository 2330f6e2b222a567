//! Writes the page of `toytop view` as one text, because a browser loads no module from a file beside a page.

use std::env::var;
use std::fs::{read_to_string, write};
use std::io::{Error, Result};
use std::path::{Path, PathBuf};

fn main() -> Result<()> {
    println!("cargo:rerun-if-changed=view");
    let script = module(Path::new("view/main.js"), &mut Vec::new())?;
    let mut names: Vec<_> = script.lines().filter_map(declared_name).collect();
    names.sort_unstable();
    if let Some(pair) = names.windows(2).find(|pair| pair[0] == pair[1]) {
        return Err(Error::other(format!(
            "view: {} is declared twice, and the page has one script",
            pair[0]
        )));
    }
    let page = read_to_string("view/page.html")?
        .replace("{{style}}", &read_to_string("view/style.css")?)
        .replace("{{script}}", &script);
    write(var("OUT_DIR").expect("cargo sets OUT_DIR") + "/page.html", page)
}

/// Name that a line of a script declares for the whole script.
fn declared_name(line: &str) -> Option<&str> {
    let line = line.strip_prefix("async ").unwrap_or(line);
    let words = ["function ", "class ", "const ", "let "];
    let declared = words.iter().find_map(|word| line.strip_prefix(word))?;
    declared.split(|c: char| !c.is_alphanumeric() && c != '_').next().filter(|name| !name.is_empty())
}

/// Source of a module and of its imports, each once, joined into one script.
///
/// # Errors
/// A file cannot be read, or an import is not `import ... from "FILE";` on one line.
fn module(file: &Path, done: &mut Vec<PathBuf>) -> Result<String> {
    let path = file.canonicalize()?;
    if done.contains(&path) {
        return Ok(String::new());
    }
    done.push(path);
    let mut script = String::new();
    for line in read_to_string(file)?.lines() {
        let Some(import) = line.strip_prefix("import") else {
            script.extend([line.strip_prefix("export ").unwrap_or(line), "\n"]);
            continue;
        };
        let unknown = || Error::other(format!("{}: no import of one line: {line}", file.display()));
        let (_, name) = import.split_once(" from ").ok_or_else(unknown)?;
        script += &module(&file.with_file_name(name.trim_matches(['"', ';'])), done)?;
    }
    Ok(script)
}
