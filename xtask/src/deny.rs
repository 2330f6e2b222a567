//! `cargo xtask deny`: licences, duplicates, sources and advisories of every dependency, by cargo-deny.

use std::process::Command;

use anyhow::Result;

use crate::process::root;
use crate::subcommand::{provide, show, succeeds};

/// Workspaces, each with a lock file of its own.
const WORKSPACES: [&str; 3] = [".", "firmware-examples", "tests/fuzz"];

/// Checks all workspaces. Advisories are checked if their list can be fetched, otherwise a message is printed.
pub(crate) fn check() -> Result<()> {
    provide("deny")?;
    let advisories = succeeds(deny(".").args(["fetch", "db"]));
    for workspace in WORKSPACES {
        println!("{workspace}:");
        let mut command = deny(workspace);
        // one configuration for three workspaces, of which none uses all entries
        command.args(["check", "--allow=unmatched-skip", "--allow=unnecessary-skip"]);
        command.args(["--allow=license-exception-not-encountered", "licenses", "bans", "sources"]);
        if advisories {
            command.arg("advisories");
        }
        show(&mut command)?;
    }
    if !advisories {
        println!("advisories not checked: their list cannot be fetched from here");
    }
    Ok(())
}

fn deny(workspace: &str) -> Command {
    let mut command = Command::new("cargo");
    command.arg("deny").arg("--manifest-path").arg(root().join(workspace).join("Cargo.toml"));
    command.arg("--config").arg(root().join(".cargo/deny.toml"));
    command
}
