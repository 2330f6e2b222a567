//! The reading rule of core, checked: a stage uses earlier stages, never later ones; and nothing in it can panic by name.

mod source;

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use anyhow::{Context, Result, bail};

use crate::process::root;
use source::{Code, Use};

/// Core's modules in reading order. Those on one line may know each other; so may the files of a folder, unless they are
/// listed one by one.
const ORDER: &[&[&str]] = &[
    &["real", "turns", "cycle"],
    &["complex"],
    &["su2"],
    &["error"],
    &["top"],
    &["launch/state"],
    &["launch/first_integrals"],
    &["launch/branch_points"],
    &["launch/regime"],
    &["nutation"],
    &["cayley_klein"],
    &["launch/normal_force"],
    &["exact/jacobi"],
    &["launch/averages"],
    &["launch/start"],
    &["launch/motion"],
    &["launch/rates"],
    &["launch/seek"],
    &["launch/cell", "launch/economise"],
    &["launch/tabulate"],
    &["tick"],
    &["exact/elementary", "exact/agm"],
    &["exact/theta"],
    &["exact/tall_lattice"],
    &["exact/weierstrass"],
    &["exact/sigma_quotient"],
    &["exact/orientation", "exact/periods"],
    &["exact/e3_equals_e4", "exact/aperiodic", "exact/lagrange", "exact/precession"],
    &["exact/closed_form"],
    &["exact/hyperelliptic", "exact/lagrangian", "exact/moebius", "exact/tip_curve"],
    &["interop"],
];

/// Files that only gather what others define. To use one as a whole is to use the last of its files.
const FACADES: &[&str] = &["", "launch", "exact"];

/// What core's code must not contain, tests apart.
const BANNED: &[&str] =
    &["std::", "mul_add", ".unwrap()", ".expect(", "panic!", "unreachable!", "todo!", "unimplemented!"];

/// Checks core/src.
pub(crate) fn check() -> Result<String> {
    let mut modules = BTreeMap::new();
    read(&root().join("core/src"), "", &mut modules)?;
    let complaints = complaints(&modules);
    if !complaints.is_empty() {
        bail!("{}", complaints.join("\n"));
    }
    Ok(format!("{} files of core", modules.len()))
}

/// Modules by path: "" is lib.rs, "launch" launch.rs, "launch/state" launch/state.rs.
type Modules = BTreeMap<String, Code>;

fn read(folder: &Path, prefix: &str, modules: &mut Modules) -> Result<()> {
    for entry in fs::read_dir(folder).with_context(|| format!("{}", folder.display()))? {
        let path = entry?.path();
        let Some(stem) = path.file_stem().and_then(|stem| stem.to_str()) else { continue };
        let name = format!("{prefix}{stem}");
        if path.is_dir() {
            read(&path, &format!("{name}/"), modules)?;
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            let name = if name == "lib" { String::new() } else { name };
            modules.insert(name, Code::new(&fs::read_to_string(&path)?));
        }
    }
    Ok(())
}

fn complaints(modules: &Modules) -> Vec<String> {
    let mut complaints = Vec::new();
    for (name, code) in modules {
        let file = if name.is_empty() { "core/src/lib.rs".into() } else { format!("core/src/{name}.rs") };
        for banned in BANNED {
            complaints.extend(code.lines_with(banned).map(|line| format!("{file}:{line}: {banned}")));
        }
        if FACADES.contains(&name.as_str()) {
            continue;
        }
        let Some(rank) = rank(name) else {
            complaints
                .push(format!("{file}: has no place in the reading order (ORDER in xtask/src/chain.rs)"));
            continue;
        };
        for Use { line, path } in code.uses() {
            let Some(used) = resolve(modules, name, &path) else { continue };
            let allowed = self::rank(&used).map_or(last_below(&used) < rank, |used_rank| used_rank <= rank);
            if !allowed {
                complaints.push(format!("{file}:{line}: {name} uses {used}, which does not come before it"));
            }
        }
    }
    complaints
}

/// A module's place in ORDER.
fn rank(name: &str) -> Option<usize> {
    let belongs =
        |entry: &&str| name.strip_prefix(entry).is_some_and(|rest| rest.is_empty() || rest.starts_with('/'));
    ORDER.iter().position(|entries| entries.iter().any(belongs))
}

/// The rank of the last module below a facade.
fn last_below(facade: &str) -> usize {
    let below = |entries: &&[&str]| entries.iter().any(|entry| parent(entry) == facade);
    ORDER.iter().rposition(below).unwrap_or(ORDER.len())
}

/// The module that a path of the form `crate::...`, `super::...` or `self::...` leads to; `None` for other crates.
fn resolve(modules: &Modules, from: &str, path: &[String]) -> Option<String> {
    let mut segments = path.iter().map(String::as_str).peekable();
    let mut module = match segments.next()? {
        "crate" => String::new(),
        "self" => from.to_owned(),
        "super" => parent(from),
        _ => return None,
    };
    while segments.next_if_eq(&"super").is_some() {
        module = parent(&module);
    }
    for segment in segments {
        let child = join(&module, segment);
        if modules.contains_key(&child) {
            module = child;
        } else if let Some(path) = modules.get(&module)?.reexport(segment) {
            // `pub use child::Name` in a module leads on to the child
            let rest: Vec<_> = ["self".to_owned()].into_iter().chain(path).collect();
            return resolve(modules, &module, &rest);
        } else {
            break;
        }
    }
    Some(module)
}

fn parent(module: &str) -> String {
    module.rsplit_once('/').map_or(String::new(), |(parent, _)| parent.to_owned())
}

fn join(module: &str, child: &str) -> String {
    if module.is_empty() { child.to_owned() } else { format!("{module}/{child}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What is said of a small core with this launch/regime.rs.
    fn said_of(regime: &str) -> Vec<String> {
        let files = [
            ("", "mod launch; mod tick; mod turns; pub use launch::{Motion, Regime};"),
            ("launch", "mod motion; mod regime; pub use motion::Motion; pub use regime::Regime;"),
            ("launch/motion", "use super::Regime; pub struct Motion;"),
            ("launch/regime", regime),
            ("tick", "mod stepper; pub use stepper::Stepper;"),
            ("tick/stepper", "use crate::launch::Motion; use crate::turns::Turns;"),
            ("turns", ""),
        ];
        let modules = files.into_iter().map(|(name, text)| (name.to_owned(), Code::new(text))).collect();
        complaints(&modules)
    }

    #[test]
    fn earlier_stages_may_be_used() {
        assert_eq!(said_of("use crate::turns::Turns;\nuse core::fmt;"), Vec::<String>::new());
    }

    #[test]
    fn later_stages_may_not_be_used_by_whatever_name() {
        for text in [
            "use crate::tick::Stepper;",
            "use crate::{turns::Turns, tick::{self, Stepper}};",
            "fn f() { let x = crate::tick::Stepper::new(); }",
            "use crate::tick;",
            "use super::Motion;",
            "use super::motion::Motion;",
            "use crate::Motion;",
            "use super::super::launch::{motion::Motion};",
            "use crate::launch;",
        ] {
            let said = said_of(text);
            assert!(
                !said.is_empty() && said.iter().all(|line| line.contains("launch/regime uses")),
                "{text}: {said:?}"
            );
        }
    }

    #[test]
    fn banned_words_count_in_code_only() {
        let quoted = "/// x.unwrap()\nconst A: &str = \"panic!\"; // std::\n#[cfg(test)]\nmod tests { fn f() { x.unwrap() } }";
        assert_eq!(said_of(quoted), Vec::<String>::new());
        for text in ["fn f() { x.unwrap() }", "use std::fmt;", "fn f<'a>(x: &'a u8) { panic!(\"{x}\") }"] {
            assert_eq!(said_of(text).len(), 1, "{text}");
        }
    }

    #[test]
    fn every_file_needs_a_place() {
        let modules = [("new".to_owned(), Code::new(""))].into();
        assert!(complaints(&modules)[0].contains("no place"));
    }
}
