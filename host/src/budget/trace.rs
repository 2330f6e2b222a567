//! Log of a run by QEMU: the blocks of code that it executed, in order.
//!
//! With `-d in_asm,exec,nochain` QEMU lists the instructions of a block when it translates it, and writes a line whenever a block begins.
//! A block ends with a branch, or where QEMU ends its translation. A block is identified by the address of its translation.

use super::Chip;
use crate::Failure;
use std::collections::HashMap;
use std::io::{BufRead, BufReader, Read};
use std::path::Path;
use std::sync::Mutex;
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::thread;
use std::time::Duration;

/// Longest time of a run; the firmware of this repository takes a second.
const LONGEST_RUN: Duration = Duration::from_secs(120);

/// Consecutive instructions.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Block {
    /// Addresses of the instructions.
    pub(super) addresses: Vec<u64>,
    /// Address after the last instruction.
    pub(super) end: u64,
}

impl Block {
    /// Address of the first instruction.
    #[must_use]
    pub(super) fn start(&self) -> u64 {
        self.addresses.first().copied().unwrap_or_default()
    }
}

/// Output of an ELF that QEMU runs. `executed` is called for every executed block, with all blocks known so far and the number of this
/// one.
///
/// # Errors
/// [`Failure::Tool`]: there is no QEMU, the program did not end in time and with exit code 0, or the log cannot be read.
pub(super) fn run(
    chip: &Chip,
    elf: &Path,
    executed: impl FnMut(&[Block], usize) -> Result<(), Failure>,
) -> Result<String, Failure> {
    let fail = |what: String| Failure::Tool(format!("budget: {}: {what}", chip.name));
    let mut qemu = chip
        .qemu(elf)
        .args(["-d", "in_asm,exec,nochain"])
        .spawn()
        .map_err(|error| fail(format!("cannot run {} ({error}); install QEMU", chip.emulator)))?;
    let stdout = qemu.stdout.take();
    let printed = thread::spawn(move || {
        let mut text = String::new();
        stdout.map(|mut stdout| stdout.read_to_string(&mut text));
        text
    });
    let Some(log) = qemu.stderr.take() else { return Err(fail("no log".into())) };
    let mut reader = Reader::default();
    let qemu = Mutex::new(qemu);
    // the program may have ended before
    let kill = &|| qemu.lock().map(|mut qemu| qemu.kill());
    let (end, ended) = channel::<()>();
    let read = thread::scope(|scope| {
        let late = scope.spawn(move || {
            let late = ended.recv_timeout(LONGEST_RUN) == Err(RecvTimeoutError::Timeout);
            if late {
                let _ = kill();
            }
            late
        });
        let read = reader.read(BufReader::with_capacity(1 << 16, log), executed);
        drop(end);
        if late.join().unwrap_or_default() {
            return Err(fail(format!("the firmware did not end within {} s", LONGEST_RUN.as_secs())));
        }
        read
    });
    if read.is_err() {
        let _ = kill();
    }
    let status = match qemu.into_inner() {
        Ok(mut qemu) => qemu.wait().map_err(|error| fail(error.to_string()))?,
        Err(_) => return Err(fail("a thread was lost".into())),
    };
    let printed = printed.join().unwrap_or_default();
    read?;
    if !status.success() {
        return Err(fail(format!("the firmware ended with {status}: {printed}{}", reader.remarks.join(" "))));
    }
    Ok(printed)
}

/// Reader of the log, line by line.
#[derive(Debug, Default)]
struct Reader {
    blocks: Vec<Block>,
    /// Blocks that were translated and not yet executed, by start address.
    fresh: HashMap<u64, Block>,
    /// Numbers of blocks, by the address of their translation in QEMU's memory.
    places: HashMap<u64, usize>,
    listed: Block,
    /// Other lines, such as the message of a panic or an error of QEMU.
    remarks: Vec<String>,
}

impl Reader {
    fn read(
        &mut self,
        mut log: impl BufRead,
        mut executed: impl FnMut(&[Block], usize) -> Result<(), Failure>,
    ) -> Result<(), Failure> {
        let mut line = Vec::with_capacity(256);
        // a block is counted when the next begins, because QEMU may cancel it
        let mut begun = None;
        loop {
            line.clear();
            let end =
                log.read_until(b'\n', &mut line).map_err(|error| Failure::Tool(error.to_string()))? == 0;
            if end || line.starts_with(b"Trace ") {
                if let Some(number) = begun {
                    executed(&self.blocks, number)?;
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
        }
    }

    /// Reads an instruction of a block that is being translated, `0x00000404:  480e       ldr  r0, [pc, #0x38]`.
    fn list(&mut self, line: &[u8]) -> Option<()> {
        let (address, rest) = hexadecimal(&line[2..]);
        let digits = rest.iter().skip(1).skip_while(|byte| **byte == b' ');
        let length = code_length(&digits.copied().collect::<Vec<_>>())?;
        if self.listed.end != address {
            self.listed = Block::default();
        }
        self.listed.addresses.push(address);
        self.listed.end = address + length;
        Some(())
    }

    /// Number of the block that begins, `Trace 0: 0x7fe810000100 [00800408/00000400/00000110/ff000200] Reset`: after the colon is the address
    /// of the translation, and the second number in brackets is the program counter.
    fn begun(&mut self, line: &[u8]) -> Option<usize> {
        let at = line.iter().position(|&byte| byte == b'x')?;
        let (place, rest) = hexadecimal(&line[at + 1..]);
        let at = rest.iter().position(|&byte| byte == b'/')?;
        let (pc, _) = hexadecimal(&rest[at + 1..]);
        if !self.listed.addresses.is_empty() {
            let block = std::mem::take(&mut self.listed);
            self.fresh.insert(block.start(), block);
        }
        if let Some(block) = self.fresh.remove(&pc) {
            self.places.insert(place, self.blocks.len());
            self.blocks.push(block);
        }
        let number = *self.places.get(&place)?;
        (self.blocks.get(number)?.start() == pc).then_some(number)
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

    fn executed(log: &str) -> Result<Vec<(u64, u64, usize)>, Failure> {
        let mut seen = Vec::new();
        Reader::default().read(log.as_bytes(), |blocks, number| {
            let block = &blocks[number];
            seen.push((block.start(), block.end, block.addresses.len()));
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
