//! The sources are compared with their rules: a module uses none that is declared later, files are short, folders have few files, and core has
//! few dependencies.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

/// Crates of core without a C interface.
const IN_SAFE_RUST: [&str; 3] = ["core/src", "core/fit/src", "core/closed-forms/src"];

/// File of a crate: the modules that it declares, in order, and its code without tests and comments.
struct Module {
    children: Vec<String>,
    code: String,
}

/// Modules by their paths, such as ["table", "cell"].
type Modules = BTreeMap<Vec<String>, Module>;

/// All modules of a crate.
fn modules(source: &str) -> Modules {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(source);
    let (mut found, mut open) = (Modules::new(), vec![Vec::new()]);
    while let Some(path) = open.pop() {
        let name = if path.is_empty() { "lib".to_owned() } else { path.join("/") };
        let file = root.join(name).with_extension("rs");
        let text = fs::read_to_string(&file).unwrap_or_else(|error| panic!("{}: {error}", file.display()));
        let code = text.split("#[cfg(test)]\nmod tests").next().unwrap_or_default();
        let lines = code.lines().filter(|line| !line.trim_start().starts_with("//"));
        let code = lines.collect::<Vec<_>>().join("\n");
        let declared = |line: &str| match line.split_whitespace().collect::<Vec<_>>()[..] {
            [.., "mod", name] => name.strip_suffix(';').map(str::to_owned),
            _ => None,
        };
        let children: Vec<String> = code.lines().filter_map(declared).collect();
        open.extend(children.iter().map(|child| [&path[..], std::slice::from_ref(child)].concat()));
        found.insert(path, Module { children, code });
    }
    found
}

/// Whether a statement re-exports items.
fn is_export(statement: &str) -> bool {
    let words: Vec<_> = statement.split_whitespace().collect();
    words.windows(2).any(|pair| pair[0].starts_with("pub") && pair[1] == "use")
}

fn is_in_name(c: char) -> bool {
    c.is_alphanumeric() || c == '_'
}

/// Module that defines the item of a path, through every re-export.
fn defining(mut at: Vec<String>, path: &str, modules: &Modules) -> Vec<String> {
    for part in path.split("::").filter(|part| !part.is_empty()) {
        if part == "super" {
            at.pop();
            continue;
        }
        loop {
            let Module { children, code } = &modules[&at];
            if children.iter().any(|child| child == part) {
                at.push(part.to_owned());
                break;
            }
            let exports = |child: &&String| {
                let mut exports = code.split(';').filter(|statement| is_export(statement));
                exports.any(|statement| {
                    statement.contains(&format!("use {child}::"))
                        && statement.split(|c| !is_in_name(c)).any(|word| word == part)
                })
            };
            let Some(child) = children.iter().find(exports) else { return at };
            at.push(child.clone());
        }
    }
    at
}

/// Modules whose items the code of a module names; a re-export is no use.
fn used(path: &[String], modules: &Modules) -> Vec<Vec<String>> {
    let Module { children, code } = &modules[path];
    let mut found = Vec::new();
    for statement in code.split(';') {
        for (end, _) in statement.match_indices("::") {
            let head = statement[..end].rsplit(|c| !is_in_name(c) && c != ':').next().unwrap_or_default();
            let base = match head {
                "crate" => &[],
                "super" => &path[..path.len() - 1],
                child if children.iter().any(|name| name == child) && !is_export(statement) => path,
                _ => continue,
            };
            let start = if base.len() == path.len() { end - head.len() } else { end };
            let rest = &statement[start..];
            let lead = rest.split(|c| !is_in_name(c) && c != ':').next().unwrap_or_default();
            let list = rest[lead.len()..].strip_prefix('{').and_then(|list| list.split('}').next());
            for name in list.unwrap_or_default().split(',') {
                found.push(defining(base.to_vec(), &format!("{lead}{}", name.trim()), modules));
            }
        }
    }
    found
}

/// Uses of a later module by a crate, and the number of uses.
///
/// The file of a folder and a module in it must not use each other.
fn later_uses(modules: &Modules) -> (Vec<String>, usize) {
    let (mut later, mut count) = (Vec::new(), 0);
    for (folder, Module { children, .. }) in modules {
        let place = |path: &[String]| {
            let child = path.strip_prefix(&folder[..])?.first()?;
            children.iter().position(|name| name == child)
        };
        let (mut last_used, mut first_user) = (None, None);
        for path in modules.keys().filter(|path| path.starts_with(folder)) {
            for other in used(path, modules).iter().filter(|other| other.starts_with(folder)) {
                match (place(path), place(other)) {
                    (None, theirs) => last_used = last_used.max(theirs),
                    (mine, None) if path.len() == folder.len() + 1 => {
                        first_user = first_user.min(mine).or(mine)
                    }
                    (mine, Some(theirs)) if Some(theirs) > mine => {
                        later.push(format!("{path:?} uses {other:?}"))
                    }
                    _ => {}
                }
                count += 1;
            }
        }
        if first_user.is_some() && last_used >= first_user {
            later.push(format!("{folder:?} uses {last_used:?}, and {first_user:?} uses it"));
        }
    }
    (later, count)
}

#[test]
fn no_module_uses_a_later_one() {
    for source in IN_SAFE_RUST.into_iter().chain(["core/c/src", "host/src"]) {
        let (later, count) = later_uses(&modules(source));
        assert!(later.is_empty(), "{} stand below what uses them:\n{}", later.len(), later.join("\n"));
        assert!(count > 10, "{source}: {count} uses");
    }
}

/// Greatest number of lines of a file.
const LINES: usize = 300;
/// Greatest number of files of Rust beside each other in a folder.
const FILES: usize = 12;

/// Texts of all files of Rust below core and host, by their paths.
fn files() -> BTreeMap<String, String> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let (mut open, mut found) = (vec!["core".to_owned(), "host".to_owned()], BTreeMap::new());
    while let Some(folder) = open.pop() {
        for entry in fs::read_dir(root.join(&folder)).expect("a folder").map(|entry| entry.expect("an entry"))
        {
            let path = format!("{folder}/{}", entry.file_name().to_string_lossy());
            if entry.path().is_dir() {
                if !path.ends_with("/target") && !path.contains("/.") {
                    open.push(path);
                }
            } else if path.ends_with(".rs") {
                found.insert(path, fs::read_to_string(entry.path()).expect("text"));
            }
        }
    }
    found
}

/// Folder and name of a file.
fn split(path: &str) -> (&str, &str) {
    path.rsplit_once('/').unwrap_or_default()
}

#[test]
fn files_are_short_and_folders_have_few() {
    let (mut large, mut counts) = (Vec::new(), BTreeMap::new());
    for (path, text) in files() {
        *counts.entry(split(&path).0.to_owned()).or_insert(0) += 1;
        if text.lines().count() > LINES {
            large.push(path);
        }
    }
    large.extend(counts.into_iter().filter(|(_, count)| *count > FILES).map(|(folder, _)| folder));
    assert!(large.is_empty(), "above {LINES} lines or {FILES} files: {large:#?}");
}

/// A file that no `mod` declares, in its folder or in one above, is never compiled.
#[test]
fn every_file_is_a_module() {
    let files = files();
    let is_root = |path: &str| {
        let (folder, name) = split(path);
        ["lib.rs", "main.rs", "build.rs"].contains(&name) || ["tests", "examples"].contains(&split(folder).1)
    };
    let is_declared = |path: &str| {
        let (folder, name) = split(path);
        let declaration = format!("mod {}", name.replace(".rs", ";"));
        files.iter().any(|(other, text)| folder.starts_with(split(other).0) && text.contains(&declaration))
    };
    let forgotten: Vec<_> = files.keys().filter(|path| !is_root(path) && !is_declared(path)).collect();
    assert!(forgotten.is_empty(), "without a `mod`: {forgotten:#?}");
}

/// No operation of core may be rounded differently on another machine.
#[test]
fn core_uses_neither_std_nor_fused_products() {
    for (path, Module { code, .. }) in IN_SAFE_RUST.into_iter().flat_map(modules) {
        for banned in ["std::", "mul_add", "unsafe "] {
            assert!(!code.contains(banned), "{}: {banned}", path.join("::"));
        }
    }
}

/// Core asks for libm, and for one other crate at most.
#[test]
fn core_has_few_dependencies() {
    let manifest =
        fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("../core/Cargo.toml")).unwrap();
    let (_, table) = manifest.split_once("\n[dependencies]\n").unwrap();
    let table = table.split("\n[").next().unwrap_or_default();
    let entries = table.lines().filter(|line| line.contains('=') && !line.starts_with(['#', ' ']));
    let always: Vec<&str> = entries.filter(|entry| !entry.contains("optional = true")).collect();
    assert!(always.len() <= 2 && always.iter().any(|entry| entry.starts_with("libm")), "{always:?}");
}
