//! Writes the page of `toytop view` as one text, because a browser loads no module from a file beside a page.

use std::env::var;
use std::fs::{read_to_string, write};
use std::io::Result;
use std::path::{Path, PathBuf};

fn main() -> Result<()> {
    println!("cargo:rerun-if-changed=view");
    let script = module(Path::new("view/main.js"), &mut Vec::new())?;
    let page = read_to_string("view/page.html")?
        .replace("{{style}}", &read_to_string("view/style.css")?)
        .replace("{{script}}", &script);
    write(var("OUT_DIR").expect("cargo sets OUT_DIR") + "/page.html", page)
}

/// Module after those that it imports, each once, without the words `import` and `export`.
fn module(file: &Path, done: &mut Vec<PathBuf>) -> Result<String> {
    let path = file.canonicalize()?;
    if done.contains(&path) {
        return Ok(String::new());
    }
    done.push(path);
    let mut script = String::new();
    for line in read_to_string(file)?.lines() {
        match line.strip_prefix("import ").and_then(|import| import.split_once(" from ")) {
            Some((_, name)) => script += &module(&file.with_file_name(name.trim_matches(['"', ';'])), done)?,
            None => script.extend([line.strip_prefix("export ").unwrap_or(line), "\n"]),
        }
    }
    Ok(script)
}
