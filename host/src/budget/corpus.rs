//! Cost of many set-ups: the firmware `corpus` launches 200 tops and counts its own instructions.

use super::{Chip, Limits};
use crate::Failure;
use crate::output::Record;
use std::collections::BTreeMap;
use std::path::Path;

/// Costs of all launches of one scalar with one result on one chip.
pub struct CorpusCost {
    pub chip: &'static str,
    pub scalar: String,
    /// Result of the launches, `ready` or `refused`.
    pub result: String,
    /// Number of launches.
    pub launches: usize,
    /// Median and greatest number of instructions of a launch, motion and table together.
    instructions: [u64; 2],
    /// Modelled cycles of the median and of the greatest launch, and of the longest slice of the launch or of the table's set-up, in
    /// proportion to those of the call `launch`; `None` where the chip has no model.
    pub cycles: [Option<u64>; 3],
}

/// Costs of the launches of an ELF on an emulated chip.
///
/// # Errors
/// [`Failure::Tool`]: there is no QEMU, the program did not end with exit code 0, or a line of its output cannot be read.
pub fn corpus(chip: &'static Chip, elf: &Path, limits: &Limits) -> Result<Vec<CorpusCost>, Failure> {
    let fail = |what: String| Failure::Tool(format!("budget: {}: {what}", chip.name));
    let ended = chip
        .qemu(elf)
        // an instruction takes one nanosecond of virtual time
        .args(["-icount", "shift=0,sleep=off"])
        .output()
        .map_err(|error| fail(format!("cannot run {} ({error}); install QEMU", chip.emulator)))?;
    if !ended.status.success() {
        return Err(fail(format!("the corpus ended with {}", ended.status)));
    }
    let text = String::from_utf8_lossy(&ended.stdout);
    let ratio = limits.of(chip.name, "launch").and_then(|cost| Some((cost.cycles?, cost.instructions)));
    let ratio = ratio.map(|(cycles, instructions)| cycles as f64 / instructions as f64);
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
        let launch = |place: usize| launches.get(place).copied().unwrap_or_default();
        let instructions @ [median, greatest] = [launch(launches.len() / 2), launch(launches.len() - 1)];
        let cycles = [median, greatest, slice].map(|count| Some((ratio? * count as f64).round() as u64));
        CorpusCost { chip: chip.name, scalar, result, launches: launches.len(), instructions, cycles }
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
    /// Median and greatest, as a row of output.
    pub fn record(&self) -> Record {
        let Self { instructions: [median, greatest], cycles, .. } = *self;
        Record::default()
            .with("chip", self.chip)
            .with("scalar", &*self.scalar)
            .with("result", &*self.result)
            .with("launches", self.launches)
            .with("median_instructions", median)
            .with("greatest_instructions", greatest)
            .with("median_cycles_model", cycles[0])
            .with("greatest_cycles_model", cycles[1])
            .with("slice_cycles_model", cycles[2])
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
