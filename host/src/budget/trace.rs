//! Log of a run by QEMU: the blocks of code that it executed, in order.
//!
//! With `-d in_asm,exec,nochain` QEMU lists the instructions of a block when it translates it, and writes a line whenever a block begins.
//! A block ends with a branch, or where QEMU ends its translation. A block is identified by the address of its translation.

use super::Chip;
use crate::Failure;
use std::collections::HashMap;
use std::io::{BufRead, BufReader, Read, Seek};
use std::path::Path;
use std::time::{Duration, Instant};

/// Longest time of a run; the firmware of this repository takes seconds.
const LONGEST_RUN: Duration = Duration::from_secs(120);

/// Consecutive instructions.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub(super) struct Block {
    /// Address of the first instruction.
    pub(super) start: u64,
    /// Address after the last instruction.
    pub(super) end: u64,
    /// Number of instructions.
    pub(super) count: u64,
}

/// Output of an ELF that QEMU runs. `executed` is called for every executed block.
///
/// # Errors
/// [`Failure::Tool`]: there is no QEMU, the program did not end in time and with exit code 0, or the log cannot be read.
pub(super) fn run(
    chip: &Chip,
    elf: &Path,
    executed: impl FnMut(Block) -> Result<(), Failure>,
) -> Result<String, Failure> {
    let fail = |what: String| Failure::Tool(format!("budget: {}: {what}", chip.name));
    // a file, because a full pipe would stop the program
    let mut printed = tempfile::tempfile()?;
    let mut qemu = chip
        .qemu(elf)
        .args(["-d", "in_asm,exec,nochain"])
        .stdout(printed.try_clone()?)
        .spawn()
        .map_err(|error| fail(format!("cannot run {} ({error}); install QEMU", chip.emulator)))?;
    let log = qemu.stderr.take().ok_or_else(|| fail("no log".into()))?;
    let mut reader = Reader::default();
    let read = reader.read(BufReader::with_capacity(1 << 16, log), executed);
    if read.is_err() {
        // the program may have ended before
        let _ = qemu.kill();
    }
    let status = qemu.wait()?;
    read?;
    let mut text = String::new();
    printed.rewind()?;
    printed.read_to_string(&mut text)?;
    if !status.success() {
        return Err(fail(format!("the firmware ended with {status}: {text}{}", reader.remarks.join(" "))));
    }
    Ok(text)
}

/// Reader of the log, line by line.
#[derive(Debug, Default)]
struct Reader {
    /// Blocks that were translated and not yet executed, by start address.
    fresh: HashMap<u64, Block>,
    /// Blocks by the address of their translation in QEMU's memory.
    translated: HashMap<u64, Block>,
    listed: Block,
    /// Other lines, such as the message of a panic or an error of QEMU.
    remarks: Vec<String>,
}

impl Reader {
    fn read(
        &mut self,
        mut log: impl BufRead,
        mut executed: impl FnMut(Block) -> Result<(), Failure>,
    ) -> Result<(), Failure> {
        let started = Instant::now();
        let mut line = Vec::with_capacity(256);
        // a block is counted when the next begins, because QEMU may cancel it
        let mut begun = None;
        loop {
            line.clear();
            let end = log.read_until(b'\n', &mut line)? == 0;
            if end || line.starts_with(b"Trace ") {
                if let Some(block) = begun {
                    executed(block)?;
                }
                if end {
                    return Ok(());
                }
                begun = Some(self.begun(&line).ok_or_else(|| unknown(&line))?);
            } else if line.starts_with(b"Stopped execution of TB") {
                begun = None;
            } else if line.starts_with(b"0x") {
                self.list(&line).ok_or_else(|| unknown(&line))?;
            } else if self.remarks.len() < 20
                && !(line.starts_with(b"----") || line.starts_with(b"IN:") || line == b"\n")
            {
                self.remarks.push(String::from_utf8_lossy(&line).trim().to_owned());
            }
            if started.elapsed() > LONGEST_RUN {
                let limit = LONGEST_RUN.as_secs();
                return Err(Failure::Tool(format!("budget: the firmware did not end within {limit} s")));
            }
        }
    }

    /// Reads an instruction of a block that is being translated, `0x00000404:  480e       ldr  r0, [pc, #0x38]`.
    fn list(&mut self, line: &[u8]) -> Option<()> {
        let (address, rest) = hexadecimal(&line[2..]);
        let digits = rest.iter().skip(1).skip_while(|byte| **byte == b' ');
        let length = code_length(&digits.copied().collect::<Vec<_>>())?;
        if self.listed.end != address || self.listed.count == 0 {
            self.listed = Block { start: address, end: address, count: 0 };
        }
        self.listed.count += 1;
        self.listed.end += length;
        Some(())
    }

    /// Block that begins, `Trace 0: 0x7fe810000100 [00800408/00000400/00000110/ff000200] Reset`: after the colon is the address of the
    /// translation, and the second number in brackets is the program counter.
    fn begun(&mut self, line: &[u8]) -> Option<Block> {
        let at = line.iter().position(|&byte| byte == b'x')?;
        let (place, rest) = hexadecimal(&line[at + 1..]);
        let at = rest.iter().position(|&byte| byte == b'/')?;
        let (pc, _) = hexadecimal(&rest[at + 1..]);
        let listed = std::mem::take(&mut self.listed);
        if listed.count > 0 {
            self.fresh.insert(listed.start, listed);
        }
        if let Some(block) = self.fresh.remove(&pc) {
            self.translated.insert(place, block);
        }
        self.translated.get(&place).filter(|block| block.start == pc).copied()
    }
}

fn unknown(line: &[u8]) -> Failure {
    let line = String::from_utf8_lossy(line);
    Failure::Tool(format!("budget: QEMU's log is not as expected: {}", line.trim()))
}

/// Hexadecimal number at the beginning of a text, and the rest.
fn hexadecimal(text: &[u8]) -> (u64, &[u8]) {
    let mut value = 0;
    for (index, &byte) in text.iter().enumerate() {
        match char::from(byte).to_digit(16) {
            Some(digit) => value = value << 4 | u64::from(digit),
            None => return (value, &text[index..]),
        }
    }
    (value, &[])
}

/// Length of an instruction in bytes, from its groups of hexadecimal digits: `f017 fa94  bl ...`.
fn code_length(text: &[u8]) -> Option<u64> {
    let mut length = 0;
    for group in text.split(|&byte| byte == b' ') {
        let digits = group.len();
        if !matches!(digits, 4 | 8) || !group.iter().all(u8::is_ascii_hexdigit) {
            break;
        }
        length += digits as u64 / 2;
    }
    (length > 0).then_some(length)
}

#[cfg(test)]
mod tests {
    use super::*;

    const LOG: &str = "----------------\nIN: f\n0x00000400:  f017 fa94  bl       #0x500\n\n\
        Trace 0: 0x7f00 [00800408/00000400/00000110/ff000200] f\n----------------\nIN: g\n\
        0x00000500:  b580       push     {r7, lr}\n0x00000502:  bdb0       pop      {r7, pc}\n\n\
        Trace 0: 0x7f40 [00800408/00000500/00000110/ff000200] g\n\
        Trace 0: 0x7f00 [00800408/00000400/00000110/ff000200] f\n";

    fn executed(log: &str) -> Result<Vec<(u64, u64, u64)>, Failure> {
        let mut seen = Vec::new();
        Reader::default().read(log.as_bytes(), |Block { start, end, count }| {
            seen.push((start, end, count));
            Ok(())
        })?;
        Ok(seen)
    }

    #[test]
    fn blocks_are_known_by_their_translation() {
        assert_eq!(executed(LOG).unwrap(), [(0x400, 0x404, 1), (0x500, 0x504, 2), (0x400, 0x404, 1)]);
    }

    #[test]
    fn a_block_translated_anew_replaces_the_old_one() {
        let again = "0x00000500:  b580       push     {r7, lr}\n\nTrace 0: 0x7f40 [0/00000500/0/0] g\n";
        assert_eq!(executed(&format!("{LOG}{again}")).unwrap()[3], (0x500, 0x502, 1));
    }

    #[test]
    fn a_cancelled_block_does_not_count() {
        let stopped = "Stopped execution of TB chain before 0x7f00 [00000400] f\n";
        assert_eq!(executed(&format!("{LOG}{stopped}")).unwrap().len(), 2);
    }

    #[test]
    fn a_block_that_was_never_listed_is_refused() {
        assert!(executed("Trace 0: 0x7f40 [0/00000500/0/0] g\n").is_err());
        assert!(executed("0x00000500:  OBJD\n").is_err());
    }
}
