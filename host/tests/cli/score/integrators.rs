//! Tests of the integrators of `host/docs/score`, which need Python and their libraries.

use super::{number, score};
use crate::{PROGRAM, folder, sample};
use std::path::{Path, PathBuf};
use std::process::Command;

/// Interpreter of the environment variable `PYTHON`, or `python3`.
fn python() -> Command {
    Command::new(std::env::var_os("PYTHON").unwrap_or_else(|| "python3".into()))
}

/// Files that a script writes, in the order of their names; `None` if a module is missing, which is printed.
fn integrated(script: &str, modules: &str) -> Option<Vec<PathBuf>> {
    let there = python().args(["-c", &format!("import {modules}")]).output();
    if !there.is_ok_and(|output| output.status.success()) {
        println!("missing, so {script} is not run: Python with {modules} (PYTHON names another interpreter)");
        return None;
    }
    let to = folder(&format!("score_{script}"));
    let scripts = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/score");
    let output = python()
        .arg("-B")
        .arg(scripts.join(format!("{script}.py")))
        .args([PROGRAM, &sample("toy_top"), "0.5"])
        .arg(&to)
        .output()
        .expect("it runs");
    assert!(output.status.success(), "{script}: {}", super::stderr(&output));
    let mut files: Vec<_> =
        std::fs::read_dir(&to).expect("a folder").map(|entry| entry.expect("an entry").path()).collect();
    files.sort();
    Some(files)
}

/// Each case is a script, its modules, the greatest error of its best file, rad, and the range of its order.
#[test]
fn integrators_are_as_good_as_their_order() {
    let cases = [
        ("lie_group", "tomllib", [1e-12, 1e-10], Some([3.9, 4.1])),
        ("scipy_dop853", "tomllib, numpy, scipy", [1e-11, 1e-7], Some([6.0, 12.0])),
        ("heyoka_taylor", "tomllib, numpy, heyoka", [1e-16, 1e-12], None),
    ];
    for (script, modules, [least, most], order) in cases {
        let Some(files) = integrated(script, modules) else { continue };
        let found = score(&sample("toy_top"), &files, &[]);
        let scored = found["files"].as_array().expect("files");
        let best = scored.iter().map(|file| number(file, "max_error_rad")).fold(1.0, f64::min);
        assert!(best > least && best < most, "{script}: {best}");
        if let Some([low, high]) = order {
            let order = number(&found, "order");
            assert!(order > low && order < high, "{script}: {order}");
        }
        assert!(scored.iter().all(|file| file["drift_from"] == "columns" && number(file, "drift_h") < 1e-3));
    }
}
