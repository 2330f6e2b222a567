//! `toytop-firmware-decoder ELF`: defmt frames on standard input become lines on standard output, as they come.
//!
//! The program is not part of xtask, because its dependencies switch on features of `serde_json` that the root
//! workspace must not have.

use std::io::{Read, Write, stdin, stdout};
use std::{env, fs};

use anyhow::{Context, Result, bail};
use defmt_decoder::{DecodeError, Table};

fn main() -> Result<()> {
    let path = env::args_os().nth(1).context("usage: toytop-firmware-decoder ELF")?;
    let elf = fs::read(&path).with_context(|| format!("cannot read {}", path.display()))?;
    let table = Table::parse(&elf)?.context("no defmt data in this ELF")?;
    let mut decoder = table.new_stream_decoder();
    let mut bytes = [0; 4096];
    loop {
        let count = stdin().read(&mut bytes)?;
        if count == 0 {
            return Ok(());
        }
        decoder.received(&bytes[..count]);
        loop {
            match decoder.decode() {
                Ok(frame) => {
                    let level = frame.level().map_or("", |level| level.as_str()).to_uppercase();
                    let line = format!("{level:5} {}", frame.display_message());
                    let line = if level.is_empty() { line.trim_start() } else { &line };
                    writeln!(stdout(), "{line}")?;
                }
                Err(DecodeError::UnexpectedEof) => break,
                Err(DecodeError::Malformed) => {
                    bail!("not a defmt frame (does anything else print to stdout?)")
                }
            }
        }
    }
}
