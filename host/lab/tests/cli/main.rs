//! Tests of the program `toytop-lab` by its command line.

mod study;

use std::process::Command;

/// Exit code, stdout and stderr of a command.
fn lab(words: &[&str]) -> (Option<i32>, String, String) {
    let output = Command::new(env!("CARGO_BIN_EXE_toytop-lab")).args(words).output().expect("it runs");
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
