//! Integrators of `host/problems/comparisons`, which need Python and their libraries.

use crate::command::{PROGRAM, finished, folder, json, list, number, path, repository, sample};
use std::process::Command;

/// Names of the files that a script writes, in order; `None` if a module is missing, which is printed.
fn integrated(script: &str, modules: &str) -> Option<String> {
    let python = || Command::new(std::env::var_os("PYTHON").unwrap_or_else(|| "python3".into()));
    let import = python().args(["-c", &format!("import {modules}")]).output();
    if !import.is_ok_and(|output| output.status.success()) {
        println!("missing, so {script} is not run: Python with {modules} (PYTHON names another interpreter)");
        return None;
    }
    let to = format!("score_{script}");
    folder(&to);
    let code = repository(&format!("host/problems/comparisons/{script}.py"));
    finished(python().arg("-B").arg(code).args([PROGRAM, &sample("toy_top"), "0.5", &to])).ok();
    let entries =
        std::fs::read_dir(path(&to)).expect("a folder").map(|entry| entry.expect("an entry").file_name());
    let mut files: Vec<_> = entries.map(|name| format!("{to}/{}", name.to_string_lossy())).collect();
    files.sort();
    Some(files.join(" "))
}

/// Each case is a script, its modules, the greatest error of its best file, rad, and the range of its order.
#[test]
fn integrators_are_as_good_as_their_order() {
    for (script, modules, [least, most], order) in [
        ("lie_group", "tomllib", [1e-12, 1e-10], Some([3.9, 4.1])),
        ("scipy_dop853", "tomllib, numpy, scipy", [1e-11, 1e-7], Some([6.0, 12.0])),
        ("heyoka_taylor", "tomllib, numpy, heyoka", [1e-16, 1e-12], None),
    ] {
        let Some(files) = integrated(script, modules) else { continue };
        let found = json(format!("score @toy_top {files}"));
        let scored = list(&found["files"]);
        let best = scored.iter().map(|file| number(&file["max_error_rad"])).fold(1.0, f64::min);
        assert!(best > least && best < most, "{script}: {best}");
        if let Some([low, high]) = order {
            let order = number(&found["order"]);
            assert!(order > low && order < high, "{script}: {order}");
        }
        assert!(scored.iter().all(|file| number(&file["drift_h"]) < 1e-3), "{script}: {found}");
    }
}
