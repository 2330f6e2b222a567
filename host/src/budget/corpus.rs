//! Cost of many set-ups: the firmware `corpus` launches 200 tops and counts its own instructions.

use super::{Chip, Limits};
use crate::Failure;
use crate::output::{Cell, Record};
use std::collections::BTreeMap;
use std::io::Read as _;
use std::path::Path;

/// Costs of all launches of one scalar with one result on one chip.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct CorpusCost {
    pub(super) chip: &'static str,
    pub(super) scalar: String,
    /// Result of the launches, `ready` or `refused`.
    pub(super) result: String,
    /// Instructions of each launch, motion and table together, in ascending order.
    pub(super) launches: Vec<u64>,
    /// Instructions of the longest slice of the launch or of the table's set-up.
    slice: u64,
    /// Modelled cycles per instruction, equal to those of the call `launch`; `None` where the chip has no model.
    cycles_per_instruction: Option<f64>,
}

/// Costs of the launches of an ELF on an emulated chip.
///
/// # Errors
/// [`Failure::Tool`]: there is no QEMU, the program did not end with exit code 0, or a line of its output cannot be read.
pub(crate) fn corpus(chip: &'static Chip, elf: &Path, limits: &Limits) -> Result<Vec<CorpusCost>, Failure> {
    let fail = |what: String| Failure::Tool(format!("budget: {}: {what}", chip.name));
    let mut qemu = chip
        .qemu(elf)
        // an instruction takes one nanosecond of virtual time
        .args(["-icount", "shift=0,sleep=off"])
        .spawn()
        .map_err(|error| fail(format!("cannot run {} ({error}); install QEMU", chip.emulator)))?;
    let mut text = String::new();
    let read = qemu.stdout.take().map_or(Ok(0), |mut stdout| stdout.read_to_string(&mut text));
    let ended = qemu.wait().map_err(|error| fail(error.to_string()))?;
    if read.is_err() || !ended.success() {
        return Err(fail(format!("the corpus ended with {ended}")));
    }
    let ratio = limits.of(chip.name, "launch").and_then(|cost| Some((cost.cycles?, cost.instructions)));
    let cycles_per_instruction = ratio.map(|(cycles, instructions)| cycles as f64 / instructions as f64);
    let mut groups: BTreeMap<(String, String), (Vec<u64>, u64)> = BTreeMap::new();
    for line in text.lines() {
        let (key, [motion, table, slice]) =
            parsed(line).ok_or_else(|| fail(format!("not a line of the corpus: {line}")))?;
        let (launches, greatest) = groups.entry(key).or_default();
        launches.push(motion + table);
        *greatest = slice.max(*greatest);
    }
    let cost = |((scalar, result), (mut launches, slice)): (_, (Vec<u64>, u64))| {
        launches.sort_unstable();
        CorpusCost { chip: chip.name, scalar, result, launches, slice, cycles_per_instruction }
    };
    Ok(groups.into_iter().map(cost).collect())
}

/// Scalar and result of a line, and the instructions of the motion, of the table and of the longest slice.
fn parsed(line: &str) -> Option<((String, String), [u64; 3])> {
    let words: Vec<_> = line.split_whitespace().collect();
    let [scalar, _, result, "motion", motion, "table", table, "slice", slice] = words[..] else {
        return None;
    };
    let number = |word: &str| word.parse().ok();
    Some(((scalar.into(), result.into()), [number(motion)?, number(table)?, number(slice)?]))
}

impl CorpusCost {
    fn cycles(&self, instructions: u64) -> Option<u64> {
        self.cycles_per_instruction.map(|cycles| (cycles * instructions as f64).round() as u64)
    }

    /// Median and greatest number of instructions of a launch.
    fn median_and_greatest(&self) -> [u64; 2] {
        let median = self.launches.get(self.launches.len() / 2).copied().unwrap_or_default();
        [median, self.launches.last().copied().unwrap_or_default()]
    }

    /// Modelled cycles of the median and of the greatest launch, and of the longest slice; `None` without a model of the chip.
    pub(super) fn modelled_cycles(&self) -> [Option<u64>; 3] {
        let [median, greatest] = self.median_and_greatest();
        [median, greatest, self.slice].map(|instructions| self.cycles(instructions))
    }

    /// Median and greatest, as a row of output.
    #[must_use]
    pub(crate) fn record(&self) -> Record {
        let ([median, greatest], cycles) = (self.median_and_greatest(), self.modelled_cycles());
        let cell = |cycles: Option<u64>| cycles.map_or(Cell::Absent, Cell::Count);
        Record(vec![
            ("chip", Cell::Text(self.chip.to_owned())),
            ("scalar", Cell::Text(self.scalar.clone())),
            ("result", Cell::Text(self.result.clone())),
            ("launches", Cell::Count(self.launches.len() as u64)),
            ("median_instructions", Cell::Count(median)),
            ("greatest_instructions", Cell::Count(greatest)),
            ("median_cycles_model", cell(cycles[0])),
            ("greatest_cycles_model", cell(cycles[1])),
            ("slice_cycles_model", cell(cycles[2])),
        ])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_has_a_launch() {
        let key = ("q31".to_owned(), "ready".to_owned());
        assert_eq!(parsed("q31 7 ready motion 40 table 80 slice 9"), Some((key, [40, 80, 9])));
        assert_eq!(parsed("q31 7 ready motion 40"), None);
        assert_eq!(parsed("panicked at the corpus"), None);
    }
}
