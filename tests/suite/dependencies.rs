//! Every dependency of every manifest is on the page that gives its reason, and core has few.

use std::fs;
use std::path::Path;

const MANIFESTS: [&str; 14] = [
    "core",
    "core/c",
    "host",
    "host/chips",
    "host/lab",
    "host/page",
    "tests",
    "tests/fuzz",
    "xtask",
    "firmware-examples",
    "firmware-examples/cost",
    "firmware-examples/decoder",
    "firmware-examples/embassy",
    "firmware-examples/nopanic",
];

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
fn every_one_has_its_reason() {
    let page = read("host/docs/dependencies.md");
    let named: Vec<&str> = page
        .lines()
        .filter_map(|line| line.strip_prefix("| ")?.split(" | ").next())
        .flat_map(|names| names.split(", "))
        .collect();
    let mut count = 0;
    for folder in MANIFESTS {
        for entry in entries(&read(&format!("{folder}/Cargo.toml")), "dependencies]") {
            let name = name(&entry);
            assert!(name.starts_with("toytop") || named.contains(&name), "{folder}: {name} has no reason");
            count += 1;
        }
    }
    assert!(count > 50, "{count} dependencies");
}

#[test]
fn core_asks_for_two_at_most() {
    let all = entries(&read("core/Cargo.toml"), "[dependencies]");
    let always: Vec<&str> =
        all.iter().filter(|entry| !entry.contains("optional = true")).map(|entry| name(entry)).collect();
    assert!(always.len() <= 2 && always.contains(&"libm"), "{always:?}");
}
