//! Reading order of core: its modules are declared in the order of dependence, none uses a later one, and folders have no circles. Files are short,
//! folders have few of them, and core has few dependencies.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

/// File of core: the modules that it declares, in order, the names that it re-exports from them, and its code without tests.
struct Module {
    children: Vec<String>,
    passes_on: BTreeMap<String, String>,
    code: String,
}

/// Sources of the crates whose order is checked; those that are not there are left out.
fn crates() -> Vec<BTreeMap<Vec<String>, Module>> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../core");
    let sources = ["src", "fit/src", "closed-forms/src"].map(|source| folder.join(source));
    sources.iter().filter(|source| source.exists()).map(|source| modules(source)).collect()
}

/// All modules of a crate by their paths, such as ["table", "cell"].
fn modules(root: &Path) -> BTreeMap<Vec<String>, Module> {
    let mut found = BTreeMap::new();
    let mut open: Vec<(Vec<String>, PathBuf)> = vec![(Vec::new(), root.join("lib.rs"))];
    while let Some((path, file)) = open.pop() {
        let text = fs::read_to_string(&file).unwrap_or_else(|error| panic!("{}: {error}", file.display()));
        let code: String = text
            .split("#[cfg(test)]\nmod tests")
            .next()
            .unwrap_or_default()
            .lines()
            .filter(|line| !line.trim_start().starts_with("//"))
            .map(|line| format!("{line}\n"))
            .collect();
        let mut module = Module { children: Vec::new(), passes_on: BTreeMap::new(), code: code.clone() };
        for statement in code.split([';', '}']).map(str::trim) {
            let words: Vec<_> = statement.split_whitespace().collect();
            if let [.., "mod", name] = words[..]
                && !statement.contains('{')
            {
                module.children.push(name.to_owned());
                let folder = path.iter().fold(root.to_owned(), |folder, part| folder.join(part));
                open.push(([&path[..], &[name.to_owned()]].concat(), folder.join(format!("{name}.rs"))));
            }
            if let Some((_, list)) =
                statement.split_once("pub use ").or(statement.split_once("pub(crate) use "))
                && let Some((from, names)) = list.split_once("::")
            {
                for name in names.split([',', '{', ' ', '\n']).filter(|name| !name.is_empty()) {
                    module.passes_on.insert(name.to_owned(), from.to_owned());
                }
            }
        }
        found.insert(path, module);
    }
    found
}

/// Modules that the code of a file names by `crate::` or `super::`; a re-exported name counts for the module that defines it.
fn used(path: &[String], modules: &BTreeMap<Vec<String>, Module>) -> Vec<Vec<String>> {
    let code = &modules[path].code;
    let mut found = Vec::new();
    for (start, from) in code.match_indices("crate::").chain(code.match_indices("super::")) {
        let before = code[..start].chars().next_back();
        if before.is_some_and(|c| c.is_alphanumeric() || "_:".contains(c)) {
            continue;
        }
        let base = if from == "crate::" { Vec::new() } else { path[..path.len().saturating_sub(1)].to_vec() };
        let rest = code[start + from.len()..].split(';').next().unwrap_or_default();
        let lead: String = rest.chars().take_while(|c| c.is_alphanumeric() || "_:".contains(*c)).collect();
        let names: Vec<String> = match rest[lead.len()..].strip_prefix('{') {
            Some(list) => {
                let list = list.split('}').next().unwrap_or_default();
                list.split(',').map(|name| format!("{lead}{}", name.trim())).collect()
            }
            None => vec![lead],
        };
        for name in names {
            let mut at = base.clone();
            'parts: for part in name.split("::").filter(|part| !part.is_empty()) {
                if part == "super" {
                    at.pop();
                    continue;
                }
                // through every re-export, to the file that defines the item
                loop {
                    let here = &modules[&at];
                    let is_child = |name: &String| here.children.contains(name);
                    match here.passes_on.get(part) {
                        _ if is_child(&part.to_owned()) => {
                            at.push(part.to_owned());
                            break;
                        }
                        Some(from) if is_child(from) => at.push(from.clone()),
                        _ => break 'parts,
                    }
                }
            }
            found.push(at);
        }
    }
    found
}

#[test]
fn no_module_uses_a_later_one() {
    let (mut compared, mut later) = (0, Vec::new());
    for modules in crates() {
        for path in modules.keys() {
            for other in used(path, &modules) {
                let common = path.iter().zip(&other).take_while(|(a, b)| a == b).count();
                // a module and its submodules have a test of their own
                let (Some(mine), Some(theirs)) = (path.get(common), other.get(common)) else { continue };
                let order = &modules[&path[..common]].children;
                let place = |name: &String| order.iter().position(|child| child == name);
                if place(theirs) >= place(mine) {
                    later.push(format!("{} uses {}", path.join("::"), other.join("::")));
                }
                compared += 1;
            }
        }
    }
    assert!(later.is_empty(), "{} stand below what uses them:\n{}", later.len(), later.join("\n"));
    assert!(compared > 150, "{compared} uses");
}

/// Modules that each module uses by name.
fn uses(modules: &BTreeMap<Vec<String>, Module>) -> BTreeMap<Vec<String>, BTreeSet<Vec<String>>> {
    let all =
        |path: &Vec<String>| used(path, modules).into_iter().chain(used_children(path, modules)).collect();
    modules.keys().map(|path| (path.clone(), all(path))).collect()
}

/// Children that the code of a file uses, beyond declaring them and re-exporting their items.
fn used_children(path: &[String], modules: &BTreeMap<Vec<String>, Module>) -> Vec<Vec<String>> {
    let Module { children, code, .. } = &modules[path];
    let exports = |text: &str| {
        let words: Vec<_> = text.rsplit(';').next().unwrap_or_default().split_whitespace().collect();
        words.windows(2).any(|pair| pair[0].starts_with("pub") && pair[1] == "use")
    };
    let uses = |child: &&String| {
        code.match_indices(&format!("{child}::")).any(|(start, _)| {
            let before = &code[..start];
            !before.ends_with(|c: char| c.is_alphanumeric() || "_:".contains(c)) && !exports(before)
        })
    };
    children.iter().filter(uses).map(|child| [path, std::slice::from_ref(child)].concat()).collect()
}

/// The file of a folder comes before its modules, or after them.
#[test]
fn no_folder_has_a_circle() {
    let mut circles = BTreeSet::new();
    for uses in crates().iter().map(uses) {
        for path in uses.keys() {
            for above in uses[path].iter().filter(|above| above.len() < path.len() && path.starts_with(above))
            {
                let (mut open, mut seen) = (vec![above], BTreeSet::from([above]));
                while let Some(next) = open.pop() {
                    let inside = uses[next].iter().filter(|module| module.starts_with(above));
                    open.extend(inside.filter(|module| seen.insert(module)));
                }
                if seen.contains(path) {
                    circles.insert(format!("{} uses {}", path.join("::"), above.join("::")));
                }
            }
        }
    }
    assert!(circles.is_empty(), "{} circles: {circles:#?}", circles.len());
}

/// Greatest number of lines of a file.
const LINES: usize = 300;
/// Greatest number of files of Rust beside each other in a folder.
const FILES: usize = 12;

#[test]
fn files_are_short_and_folders_have_few() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let mut open = vec!["core".to_owned(), "host".to_owned()];
    let mut large = BTreeSet::new();
    while let Some(folder) = open.pop() {
        let mut files = 0;
        for entry in fs::read_dir(root.join(&folder)).expect("a folder").map(|entry| entry.expect("an entry"))
        {
            let path = format!("{folder}/{}", entry.file_name().to_string_lossy());
            if entry.path().is_dir() {
                if !path.ends_with("/target") && !path.contains("/.") {
                    open.push(path);
                }
            } else if path.ends_with(".rs") {
                files += 1;
                if fs::read_to_string(entry.path()).expect("text").lines().count() > LINES {
                    large.insert(path);
                }
            }
        }
        if files > FILES {
            large.insert(folder);
        }
    }
    assert!(large.is_empty(), "above {LINES} lines or {FILES} files: {large:#?}");
}

/// No operation of core may be rounded differently on another machine.
#[test]
fn core_uses_neither_std_nor_fused_products() {
    for (path, module) in crates().into_iter().flatten() {
        for banned in ["std::", "mul_add", "unsafe "] {
            assert!(!module.code.contains(banned), "{}: {banned}", path.join("::"));
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
