//! Page core/closed-forms/docs/paper.md is compared with the labels of the paper and with the tests: every label has a row, every named test exists.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

/// Labels of the paper's LaTeX source.
const LABELS: &str =
    "eqn:omega eqn:Omega eqn:inerse-stereo-proj eqn:Moeb eqn:kinetic eqn:lagrange eqn:motion eqn:reduced
    eqn:reduced2 eqn:eineq eqn:e4 eqn:constants eqn:tint0 fig:curve1 eqn:R(u)-with-l-n-h eqn:t
    prop:abgdints eqn:abgdints tab:anaprop eqn:up1um1 eqn:du eqn:du-plus-iOmegas-dt eqn:omegasum
    eqn:dphi fig:tiptop-samesign fig:tiptop-diffrentsign eqn:loopcondition eqn:degtint eqn:zander eqn:x
    eqn:uofx eqn:wofx fig:curve2 eqn:degabgd eqn:ks eqn:ls eqn:alphaasymp eqn:flunder eqn:diffquot
    eqn:apertint eqn:aperabgdints fig:curve3 eqn:tpolydiv eqn:I1 eqn:I2 eqn:aperform tab:aperpoles";

fn read(path: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(path);
    fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// Text of each test file by its name, whatever its folder.
fn suite() -> BTreeMap<String, String> {
    let suite = Path::new(env!("CARGO_MANIFEST_DIR")).join("suite");
    let folders =
        fs::read_dir(suite).unwrap().map(|entry| entry.unwrap().path()).filter(|path| path.is_dir());
    let files = folders.flat_map(|folder| fs::read_dir(folder).unwrap()).map(|entry| entry.unwrap().path());
    files
        .map(|file| {
            (file.file_stem().unwrap().to_string_lossy().into_owned(), fs::read_to_string(&file).unwrap())
        })
        .collect()
}

/// Cells of each row: label, what, item, tests.
fn rows() -> Vec<[String; 4]> {
    let page = read("../core/closed-forms/docs/paper.md");
    let cells = |line: &str| line.trim_matches('|').split(" | ").map(|cell| cell.trim().to_owned()).collect();
    let rows = page.lines().filter(|line| line.starts_with("| ") && !line.starts_with("| label"));
    let rows: Vec<Vec<String>> = rows.map(cells).collect();
    rows.into_iter().map(|row| row.try_into().unwrap_or_else(|row| panic!("four cells: {row:?}"))).collect()
}

#[test]
fn every_label_has_a_row() {
    let rows = rows();
    for label in LABELS.split_whitespace() {
        assert_eq!(rows.iter().filter(|[found, ..]| found == label).count(), 1, "{label}");
    }
    let known = |label: &str| label.starts_with("section ") || label.starts_with("Proposition ");
    for [label, ..] in &rows {
        assert!(known(label) || LABELS.split_whitespace().any(|known| known == label), "{label}");
    }
}

#[test]
fn every_test_that_is_named_exists() {
    let suite = suite();
    let mut count = 0;
    for [label, _, item, tests] in rows() {
        // items without a link belong to the tests
        let mut sources = read("support/hyperelliptic_curve.rs");
        for test in tests.split(", ") {
            let path = test.trim_matches('`');
            let (file, function) = path.rsplit_once("::").unwrap_or_else(|| panic!("{label}: {test}"));
            let source = suite.get(file).unwrap_or_else(|| panic!("{label}: no file {file}"));
            let heads = [format!("#[test]\nfn {function}("), format!("#[test]\n    fn {function}(")];
            assert!(heads.iter().any(|head| source.contains(head)), "{label}: no test {path}");
            count += 1;
            sources += source;
        }
        for name in item.split('`').skip(1).step_by(2) {
            let linked =
                item.contains(&format!("`{name}`](crate::")) || item.contains(&format!("`{name}`](toytop::"));
            let (_, last) = name.rsplit_once("::").unwrap_or(("", name));
            assert!(linked || sources.contains(last), "{label}: no item {name}");
        }
    }
    assert!(count > 60, "{count}");
}
