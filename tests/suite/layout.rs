//! Reading order of core: its modules are declared in the order of dependence, and none uses a later one.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

/// File of core: the modules that it declares, in order, the names that it re-exports from them, and its code without tests.
struct Module {
    children: Vec<String>,
    passes_on: BTreeMap<String, String>,
    code: String,
}

/// All modules by their paths from the crate, such as ["ephemeris", "cell"].
fn modules() -> BTreeMap<Vec<String>, Module> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../core/src");
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
                let folder = path.iter().fold(root.clone(), |folder, part| folder.join(part));
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
            for part in name.split("::").filter(|part| !part.is_empty()) {
                let here = &modules[&at];
                let next = if here.children.iter().any(|child| child == part) { Some(part) } else { None };
                match next.or(here.passes_on.get(part).map(String::as_str)) {
                    Some(next) if here.children.iter().any(|child| child == next) => at.push(next.to_owned()),
                    _ => break,
                }
            }
            found.push(at);
        }
    }
    found
}

#[test]
fn no_module_uses_a_later_one() {
    let modules = modules();
    assert!(modules.len() > 60, "{} modules", modules.len());
    let (mut compared, mut later) = (0, Vec::new());
    for path in modules.keys() {
        for other in used(path, &modules) {
            let common = path.iter().zip(&other).take_while(|(a, b)| a == b).count();
            // a module and its submodules may use each other
            let (Some(mine), Some(theirs)) = (path.get(common), other.get(common)) else { continue };
            let order = &modules[&path[..common]].children;
            let place = |name: &String| order.iter().position(|child| child == name);
            if place(theirs) >= place(mine) {
                later.push(format!("{} uses {}", path.join("::"), other.join("::")));
            }
            compared += 1;
        }
    }
    assert!(later.is_empty(), "{} stand below what uses them:\n{}", later.len(), later.join("\n"));
    assert!(compared > 300, "{compared} uses");
}

/// No operation of core may be rounded differently on another machine.
#[test]
fn core_uses_neither_std_nor_fused_products() {
    for (path, module) in modules() {
        for banned in ["std::", "mul_add", "unsafe "] {
            assert!(!module.code.contains(banned), "{}: {banned}", path.join("::"));
        }
    }
}
