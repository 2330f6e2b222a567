//! Integrators of `host/comparisons`, which need Python 3.11, and two of them its libraries.

use crate::command::{PROGRAM, finished, folder, json, list, number, path, repository, sample};
use std::process::Command;

fn python() -> Command {
    Command::new(std::env::var_os("PYTHON").unwrap_or_else(|| "python3".into()))
}

/// Names of the files that a script writes, in order.
fn integrated(script: &str) -> String {
    let to = format!("score_{script}");
    folder(&to);
    let code = repository(&format!("host/comparisons/{script}.py"));
    finished(python().arg("-B").arg(code).args([PROGRAM, &sample("toy_top"), "0.5", &to])).ok();
    let entries =
        std::fs::read_dir(path(&to)).expect("a folder").map(|entry| entry.expect("an entry").file_name());
    let mut files: Vec<_> = entries.map(|name| format!("{to}/{}", name.to_string_lossy())).collect();
    files.sort();
    files.join(" ")
}

/// Each case is a script, its libraries, the greatest error of its best file, rad, and the range of its order. A script whose libraries are
/// missing is skipped, but none with an interpreter that `PYTHON` names.
#[test]
fn integrators_are_as_good_as_their_order() {
    let mut skipped = Vec::new();
    for (script, libraries, [least, most], order) in [
        ("lie_group", "", [1e-12, 1e-10], Some([3.9, 4.1])),
        ("scipy_dop853", "numpy, scipy", [1e-11, 1e-7], Some([6.0, 12.0])),
        ("heyoka_taylor", "numpy, heyoka", [1e-16, 1e-12], None),
    ] {
        let import = format!("import {libraries}");
        if !libraries.is_empty() && !python().args(["-c", &import]).output().expect("Python").status.success()
        {
            skipped.push(format!("{script} without {libraries}"));
            continue;
        }
        let found = json(format!("score @toy_top {}", integrated(script)));
        let scored = list(&found["files"]);
        let best = scored.iter().map(|file| number(&file["max_error_rad"])).fold(1.0, f64::min);
        assert!(best > least && best < most, "{script}: {best}");
        if let Some([low, high]) = order {
            let order = number(&found["order"]);
            assert!(order > low && order < high, "{script}: {order}");
        }
        assert!(scored.iter().all(|file| number(&file["drift_h"]) < 1e-3), "{script}: {found}");
    }
    println!("not run (PYTHON names another interpreter): {skipped:?}");
    assert!(skipped.is_empty() || std::env::var_os("PYTHON").is_none(), "{skipped:?}");
}
