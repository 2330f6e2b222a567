//! Core has few dependencies.

use std::fs;
use std::path::Path;

fn read(path: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(path);
    fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// Lines of the dependency tables of a manifest: the tables whose title contains `table`.
fn entries(manifest: &str, table: &str) -> Vec<String> {
    let mut inside = false;
    let mut lines = Vec::new();
    for line in manifest.lines() {
        if line.starts_with('[') {
            inside = line.contains(table) && !line.contains("workspace");
        } else if inside && line.contains('=') && !line.starts_with(['#', ' ']) {
            lines.push(line.to_owned());
        }
    }
    lines
}

fn name(entry: &str) -> &str {
    entry.split(['.', ' ', '=']).next().unwrap_or_default()
}

#[test]
fn core_asks_for_two_at_most() {
    let all = entries(&read("core/Cargo.toml"), "[dependencies]");
    let always: Vec<&str> =
        all.iter().filter(|entry| !entry.contains("optional = true")).map(|entry| name(entry)).collect();
    assert!(always.len() <= 2 && always.contains(&"libm"), "{always:?}");
}
