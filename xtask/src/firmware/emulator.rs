//! Runs of QEMU, whose log is decoded.

use std::io::{BufRead, BufReader, Read};
use std::path::Path;
use std::process::{Command, Stdio};
use std::thread;
use std::time::Duration;

use anyhow::{Context, Result, bail};

use super::Chip;
use crate::process::wait;

/// Longest time of a run; a program that takes longer is killed.
const LIMIT: Duration = Duration::from_secs(60);

/// Result of a run.
pub(crate) struct Run {
    /// Decoded log.
    pub(crate) log: String,
    /// Other text, such as the message of a panic or an error of QEMU.
    pub(crate) errors: String,
    pub(crate) exit_code: i32,
}

/// Result of the run of an ELF. One instruction takes one virtual nanosecond, and a sleeping processor continues immediately at its next
/// interrupt, so that a run is repeatable.
pub(crate) fn run(chip: &Chip, elf: &Path, decoder: &Path, show: bool) -> Result<Run> {
    let mut qemu = chip
        .qemu(elf)
        .args(["-icount", "shift=0,sleep=off"])
        .spawn()
        .with_context(|| format!("cannot run {}", chip.emulator))?;
    let frames = qemu.stdout.take().expect("piped");
    let mut errors = qemu.stderr.take().expect("piped");
    let mut decode = Command::new(decoder)
        .arg(elf)
        .stdin(frames)
        .stdout(Stdio::piped())
        .spawn()
        .with_context(|| format!("cannot run {}", decoder.display()))?;
    let lines = BufReader::new(decode.stdout.take().expect("piped"));

    let log = thread::spawn(move || -> std::io::Result<String> {
        let mut log = String::new();
        for line in lines.lines() {
            let line = line?;
            if show {
                println!("{line}");
            }
            log += &line;
            log.push('\n');
        }
        Ok(log)
    });
    let errors = thread::spawn(move || {
        let mut text = Vec::new();
        errors.read_to_end(&mut text).map(|_| String::from_utf8_lossy(&text).into_owned())
    });

    let status = wait(&mut qemu, LIMIT)?;
    let decoded = decode.wait()?.success();
    let log = log.join().expect("the reader does not panic")?;
    let errors = errors.join().expect("the reader does not panic")?;
    let Some(status) = status else {
        bail!("{}: no end after {} s\n{log}{errors}", chip.name, LIMIT.as_secs());
    };
    if !decoded {
        bail!("{}: the log cannot be decoded\n{log}{errors}", chip.name);
    }
    let exit_code =
        status.code().with_context(|| format!("{}: QEMU was killed\n{log}{errors}", chip.name))?;
    Ok(Run { log, errors, exit_code })
}
