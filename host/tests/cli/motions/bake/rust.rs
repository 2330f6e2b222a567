//! Tests of tables in Rust by `toytop bake`, compiled by cargo: they are the tables of the crate.

use super::expected_bits::{Case, assert_lines, cases};
use crate::command::{finished, folder, read, toytop, write};
use std::path::Path;
use std::process::Command;

/// Writes the table of a case.
pub(super) fn bake(case: &Case, lang: &str, to: &str) {
    let Case { scalar, size, .. } = case;
    let run = toytop(format!("bake {} --lang {lang} -o {to}", case.arguments()));
    let note = run.err.lines().next().unwrap_or_default();
    assert!(note.contains(&format!(": {size}x")) && note.contains(&format!(" in {scalar}, ")), "{note}");
    assert_eq!(run.ok(), "");
}

pub(super) fn name(case: &Case) -> String {
    Path::new(&case.file).file_stem().expect("a name").to_str().expect("UTF-8").to_lowercase()
}

#[test]
fn rust_gives_the_same_table_and_a_changed_number_does_not_compile() {
    let (folder, cases) = (folder("bake_rust"), cases());
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    std::fs::create_dir(folder.join("src")).expect("a folder");
    let core = root.join("core").canonicalize().expect("core");
    write(
        "bake_rust/Cargo.toml",
        format!(
            "[package]\nname = \"baked\"\nedition = \"2024\"\n[dependencies]\ntoytop = {{ path = {core:?}, features = [\"fixed\"] }}\n[workspace]\n"
        ),
    );
    // the versions of dependencies that this workspace uses
    std::fs::copy(root.join("Cargo.lock"), folder.join("Cargo.lock")).expect("the lock file");
    let (mut modules, mut main) = (String::new(), String::new());
    for case in &cases {
        let name = name(case);
        bake(case, "rust", &format!("bake_rust/src/{name}.rs"));
        modules += &format!("mod {name};\n");
        main += &format!("    println!(\"{{:?}}\", {name}::{});\n", name.to_uppercase());
    }
    write("bake_rust/src/main.rs", format!("{modules}fn main() {{\n{main}}}\n"));
    let cargo = |command: &str| {
        let mut cargo = Command::new(env!("CARGO"));
        cargo.args([command, "--quiet", "--offline", "--manifest-path", "bake_rust/Cargo.toml"]);
        cargo.env("CARGO_TARGET_DIR", folder.join("target")).env("RUSTFLAGS", "-D warnings");
        cargo.env("CARGO_PROFILE_DEV_DEBUG", "0").env("CARGO_INCREMENTAL", "0");
        finished(&mut cargo)
    };
    assert_lines(&cargo("run").ok(), &cases, |case| case.expected().table);

    let text = read("bake_rust/src/toy_top.rs");
    let (head, rows) = text.split_once("segments: [").expect("the table");
    write("bake_rust/src/toy_top.rs", format!("{head}segments: [{}", rows.replacen(", ", ", 1", 1)));
    // not `check`, which evaluates a static only where a type depends on it, and would need the dependencies once more
    let refused = cargo("build");
    assert_ne!(refused.code, Some(0));
    assert!(refused.err.contains("crc32: the numbers were changed"), "{}", refused.err);
}
