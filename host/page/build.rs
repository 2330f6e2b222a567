//! Writes the page of `toytop view` as one text, because a browser loads no module from a file beside a page.

use std::env::var_os;
use std::fs;
use std::path::{Path, PathBuf};

fn main() {
    println!("cargo:rerun-if-changed=view");
    let style = ["style.css", "layout.css"].map(|name| read(&Path::new("view").join(name))).concat();
    let mut script = Script::default();
    script.add(Path::new("view/main.js"));
    let page =
        read(Path::new("view/page.html")).replace("{{style}}", &style).replace("{{script}}", &script.text);
    let folder = PathBuf::from(var_os("OUT_DIR").expect("cargo sets OUT_DIR"));
    fs::write(folder.join("page.html"), page).expect("the folder of build output is writable");
}

fn read(file: &Path) -> String {
    fs::read_to_string(file).unwrap_or_else(|error| panic!("{}: {error}", file.display()))
}

/// Modules as one script.
#[derive(Default)]
struct Script {
    text: String,
    files: Vec<PathBuf>,
}

impl Script {
    /// Adds a module after those that it imports, each once, without `import` and `export`.
    ///
    /// # Panics
    /// A module does not export what another imports.
    fn add(&mut self, file: &Path) -> String {
        let module = read(file);
        let path = file.canonicalize().expect("a path");
        if !self.files.contains(&path) {
            self.files.push(path);
            for import in module.lines().filter_map(|line| line.strip_prefix("import { ")) {
                let (names, from) = import.split_once(" } from ").expect("import { NAMES } from FILE");
                let imported = self.add(&file.with_file_name(from.trim_matches(['"', ';'])));
                for name in names.split(", ") {
                    let exports =
                        |line: &str| line.starts_with("export ") && words(line).any(|word| word == name);
                    assert!(imported.lines().any(exports), "{}: {from} exports no {name}", file.display());
                }
            }
            for line in module.lines().filter(|line| !line.starts_with("import ")) {
                self.text += line.strip_prefix("export ").unwrap_or(line);
                self.text.push('\n');
            }
        }
        module
    }
}

fn words(line: &str) -> impl Iterator<Item = &str> {
    line.split(|c: char| !c.is_alphanumeric() && c != '_')
}
