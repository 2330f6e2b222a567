//! Log of a run by QEMU: the blocks of code that it executed, in order.
//!
//! With `-d in_asm,exec,nochain` QEMU lists the instructions of a block when it translates it, and writes a line whenever a block begins.
//! A block ends with a branch, or where QEMU ends its translation. A block is identified by the address of its translation.

use crate::chip::Chip;
use std::collections::HashMap;
use std::io::{self, BufRead, BufReader};
use std::path::Path;
use std::process::{ChildStderr, ChildStdout};
use std::thread;

/// Consecutive instructions.
#[derive(Clone, Copy, Default, PartialEq, Eq, Hash)]
pub struct Block {
    /// Address of the first instruction.
    pub start: u64,
    /// Address after the last instruction.
    pub end: u64,
    /// Number of instructions.
    pub count: u64,
}

/// Output of an ELF that QEMU runs with these arguments. `executed` is called for every executed block that QEMU logs.
///
/// # Errors
/// There is no QEMU, the program did not end in time and with exit code 0, or the log cannot be read.
pub fn emulate(
    chip: &Chip,
    elf: &Path,
    arguments: &[&str],
    executed: impl FnMut(Block) -> io::Result<()>,
) -> io::Result<String> {
    let mut reader = Reader::default();
    let read = |stdout: ChildStdout, stderr: ChildStderr| {
        // in a thread, because a full pipe would stop the program
        let printed = thread::spawn(move || io::read_to_string(stdout));
        reader.read(BufReader::with_capacity(1 << 16, stderr), executed)?;
        printed.join().unwrap_or_else(|_| Err(io::Error::other("no output")))
    };
    let (status, text) = chip.emulate(elf, arguments, read)?;
    let text = text?;
    if !status.success() {
        let notes = reader.notes.join(" ");
        return Err(io::Error::other(format!("the firmware ended with {status}: {text}{notes}")));
    }
    Ok(text)
}

/// State of the reader of QEMU's log.
#[derive(Default)]
struct Reader {
    /// Blocks that were translated and not yet executed, by start address.
    fresh: HashMap<u64, Block>,
    /// Blocks by the address of their translation in QEMU's memory.
    translated: HashMap<u64, Block>,
    listed: Block,
    /// Other lines, such as the message of a panic or an error of QEMU.
    notes: Vec<String>,
}

impl Reader {
    fn read(
        &mut self,
        log: impl BufRead,
        mut executed: impl FnMut(Block) -> io::Result<()>,
    ) -> io::Result<()> {
        // a block is counted when the next begins, because QEMU may cancel it
        let mut begun = None;
        for line in log.lines() {
            let line = line?;
            let unknown = || io::Error::other(format!("QEMU's log is not as expected: {line}"));
            if line.starts_with("Trace ") {
                begun.take().map_or(Ok(()), &mut executed)?;
                begun = Some(self.read_block(&line).ok_or_else(unknown)?);
            } else if line.starts_with("Stopped execution of TB") {
                begun = None;
            } else if let Some(listed) = line.strip_prefix("0x") {
                self.read_instruction(listed).ok_or_else(unknown)?;
            } else if self.notes.len() < 20
                && !(line.starts_with("----") || line.starts_with("IN:") || line.is_empty())
            {
                self.notes.push(line);
            }
        }
        begun.map_or(Ok(()), executed)
    }

    /// Reads an instruction of a block that is being translated, `00000404:  480e       ldr  r0, [pc, #0x38]`. Its code is one or two
    /// groups of digits.
    fn read_instruction(&mut self, line: &str) -> Option<()> {
        let (address, rest) = line.split_once(':')?;
        let address = u64::from_str_radix(address, 16).ok()?;
        let is_code = |group: &&str| {
            matches!(group.len(), 4 | 8) && group.bytes().all(|digit| digit.is_ascii_hexdigit())
        };
        let digits: usize = rest.trim_start().split(' ').take_while(is_code).map(str::len).sum();
        if self.listed.end != address || self.listed.count == 0 {
            self.listed = Block { start: address, end: address, count: 0 };
        }
        self.listed.count += 1;
        self.listed.end += digits as u64 / 2;
        (digits > 0).then_some(())
    }

    /// Block that begins, `Trace 0: 0x7fe810000100 [00800408/00000400/00000110/ff000200] Reset`: after the colon is the address of the
    /// translation, and the second number in brackets is the program counter.
    fn read_block(&mut self, line: &str) -> Option<Block> {
        let (_, rest) = line.split_once("0x")?;
        let (translation, rest) = rest.split_once(' ')?;
        let [translation, pc] =
            [translation, rest.split('/').nth(1)?].map(|text| u64::from_str_radix(text, 16));
        let (translation, pc) = (translation.ok()?, pc.ok()?);
        let listed = std::mem::take(&mut self.listed);
        if listed.count > 0 {
            self.fresh.insert(listed.start, listed);
        }
        if let Some(block) = self.fresh.remove(&pc) {
            self.translated.insert(translation, block);
        }
        self.translated.get(&translation).filter(|block| block.start == pc).copied()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const LOG: &str = "----------------\nIN: f\n0x00000400:  f017 fa94  bl       #0x500\n\n\
        Trace 0: 0x7f00 [00800408/00000400/00000110/ff000200] f\n----------------\nIN: g\n\
        0x00000500:  b580       push     {r7, lr}\n0x00000502:  bdb0       pop      {r7, pc}\n\n\
        Trace 0: 0x7f40 [00800408/00000500/00000110/ff000200] g\n\
        Trace 0: 0x7f00 [00800408/00000400/00000110/ff000200] f\n";

    fn executed(log: &str) -> io::Result<Vec<(u64, u64, u64)>> {
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
