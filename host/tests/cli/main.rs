//! Tests of the commands: their output, files, refusals and exit codes; the code in C and in Rust that they write; their
//! pages, in Chromium; and the scripts that their results are compared with.

mod command;
mod readme;

// The groups of `toytop --help`.

/// State, constants and events of motions, and the scenario files that they are read from; errors and sweeps; tables in C and in Rust.
mod motions {
    /// Tables in C and in Rust.
    mod bake {
        mod c;
        pub(crate) mod expected_bits;
        mod files;
        mod rust;
    }
    mod compare;
    mod constants;
    mod events;
    mod state;
    mod state_rows;
    mod sweep;
    mod units;
    pub(crate) mod vectors;
}

/// Pictures, animations and pages.
mod pictures {
    mod animate;
    pub(crate) mod plot;
    pub(crate) mod view;
}

/// Launches fitted to samples of sensors.
mod sensors {
    mod fit;
}

/// Scores of trajectories, and the problems that integrators are tested with.
mod integrators {
    mod benchmark;
    mod comparisons;
    mod score;
}

/// Checks of toytop itself.
mod checks {
    mod accuracy;
    mod errata;
    mod figures;
    mod study;
    mod timings;
}

/// Bad input, and failures while files are written.
mod errors {
    mod refusals;
    mod robustness;
    mod scenarios;
}

use command::toytop;

#[test]
fn help_and_version_are_no_failures() {
    for line in ["--help", "--version", "state --help"] {
        let run = toytop(line);
        assert!(run.err.is_empty() && !run.ok().is_empty(), "{line}");
    }
}

#[test]
fn every_command_has_help_with_an_example_and_completes() {
    let help = toytop("--help").ok();
    assert!(help.lines().count() <= 24, "one screen: {help}");
    let commands = help.lines().filter_map(|line| line.strip_prefix("  ")?.split_whitespace().next());
    let checks = help.lines().find_map(|line| line.strip_prefix("Checks of toytop itself: "));
    let commands: Vec<_> = commands.chain(checks.expect("a line").split(' ')).collect();
    assert_eq!(commands.len(), 20, "{commands:?}");
    let scripts = ["bash", "zsh", "fish"].map(|shell| toytop(format!("completions {shell}")).ok());
    for command in commands {
        let help = toytop(format!("{command} --help")).ok();
        assert!(help.contains(&format!("Example: toytop {command} ")), "{command}");
        assert!(!help.contains('\x1b'), "{command}: no colour, so none to switch off");
        assert!(scripts.iter().all(|script| script.contains(command)), "{command}");
    }
}
