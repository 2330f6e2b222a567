//! Tests of the program `toytop-lab` by its command line.

mod study;

use std::process::Command;

/// Exit code, stdout and stderr of a command, in the folder for its files.
fn lab(words: &[&str]) -> (Option<i32>, String, String) {
    lab_in(env!("CARGO_TARGET_TMPDIR"), words)
}

/// Exit code, stdout and stderr of a command in a folder.
fn lab_in(folder: &str, words: &[&str]) -> (Option<i32>, String, String) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_toytop-lab"));
    let output = command.args(words).current_dir(folder).output().expect("it runs");
    let text = |bytes| String::from_utf8(bytes).expect("UTF-8");
    (output.status.code(), text(output.stdout), text(output.stderr))
}

#[test]
fn every_command_has_help_with_an_example() {
    for command in ["corners", "fit"] {
        let (_, help, _) = lab(&[command, "--help"]);
        assert!(help.contains(&format!("Example: toytop-lab {command} ")), "{command}");
    }
}
