//! Tests of the program `toytop-lab` by its command line.

mod fixed_point;
#[path = "../../../tests/cli/killed.rs"]
mod killed;
#[path = "../../../tests/cli/program.rs"]
mod program;
mod report;
mod study;

use program::{folder, json, run, stderr, stdout};

const PROGRAM: &str = env!("CARGO_BIN_EXE_toytop-lab");

#[test]
fn every_command_has_help_with_an_example() {
    for command in ["study", "longrun", "sines", "overflow", "report"] {
        let help = run(&[command, "--help"]);
        assert!(stdout(&help).contains(&format!("Example: toytop-lab {command} ")), "{command}");
    }
}
