//! Runs of other programs with a time limit and with their output in memory.

use std::io::{Read, pipe};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::mpsc::channel;
use std::time::Duration;
use std::{env, thread};

use anyhow::{Context, Result, bail};

/// Root of the repository, from the environment of `cargo run`, because the folder may have been renamed after the binary was built.
pub(crate) fn root() -> PathBuf {
    let xtask =
        env::var_os("CARGO_MANIFEST_DIR").map_or_else(|| env!("CARGO_MANIFEST_DIR").into(), PathBuf::from);
    xtask.ancestors().nth(2).map(Path::to_owned).expect("xtask is in a folder of the host")
}

/// Target folder of the workspace.
pub(crate) fn target_dir() -> PathBuf {
    root().join(env::var_os("CARGO_TARGET_DIR").unwrap_or_else(|| "target".into()))
}

/// Target folder of the firmware workspace.
pub(crate) fn firmware_target_dir() -> PathBuf {
    toytop_chips::chip::target_dir(&root())
}

/// Command from words, in a folder of the repository.
pub(crate) fn command(folder: &str, words: &str) -> Command {
    let mut words = words.split_whitespace();
    let mut command = Command::new(words.next().unwrap_or_default());
    command.current_dir(root().join(folder)).args(words);
    command
}

/// Argument of cargo in CI, where the lock files must be right.
pub(crate) fn locked() -> Option<&'static str> {
    env::var("CI").is_ok_and(|value| !value.is_empty() && value != "false").then_some("--locked")
}

/// Command that runs cargo in a folder of the repository.
pub(crate) fn cargo(folder: &str, words: &str) -> Command {
    let (own, passed_on) = words.split_at(words.find(" -- ").unwrap_or(words.len()));
    command(folder, &format!("cargo {own} {}{passed_on}", locked().unwrap_or_default()))
}

/// Entry of a list by its name; the error lists all names.
pub(crate) fn named<'a, T>(
    what: &str,
    name: &str,
    entries: impl Iterator<Item = &'a T> + Clone,
    name_of: fn(&T) -> &'static str,
) -> Result<&'a T> {
    entries.clone().find(|entry| name_of(entry) == name).with_context(|| {
        format!("no {what} {name}; there are: {}", entries.map(name_of).collect::<Vec<_>>().join(" "))
    })
}

/// Command as text.
fn typed(command: &Command) -> String {
    let words = std::iter::once(command.get_program()).chain(command.get_args());
    words.map(|word| word.to_string_lossy()).collect::<Vec<_>>().join(" ")
}

/// Result of a command: whether it succeeded, and its output to both streams in order.
pub(crate) struct Ended {
    pub(crate) success: bool,
    pub(crate) output: String,
}

/// Result of a command, whose output must end within `limit`.
pub(crate) fn run_within(command: &mut Command, limit: Duration) -> Result<Ended> {
    let name = typed(command);
    let (mut reader, writer) = pipe()?;
    command.stdout(writer.try_clone()?).stderr(writer);
    let mut child = command.spawn().with_context(|| format!("cannot run {name}"))?;
    command.stdout(Stdio::null()).stderr(Stdio::null()); // drops this process's ends of the pipe
    let (sender, receiver) = channel();
    thread::spawn(move || {
        let mut bytes = Vec::new();
        let read = reader.read_to_end(&mut bytes);
        sender.send(read.map(|_| String::from_utf8_lossy(&bytes).into_owned()))
    });
    let Ok(output) = receiver.recv_timeout(limit) else {
        child.kill()?;
        child.wait()?;
        bail!("{name}: not done after {} s", limit.as_secs());
    };
    Ok(Ended { success: child.wait()?.success(), output: output? })
}

/// Output of a command that must succeed; if it fails, its output is the error.
pub(crate) fn run(command: &mut Command) -> Result<String> {
    let ended = run_within(command, Duration::from_secs(1800))?;
    if !ended.success {
        bail!("{}\nfailed: {}", ended.output.trim_end(), typed(command));
    }
    Ok(ended.output)
}
