//! Cost of many set-ups: the firmware `corpus` launches 200 tops and counts its own instructions.

use super::budgets::Budgets;
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::io;
use std::path::Path;
use toytop_chips::chip::{Chip, REPEATABLE};
use toytop_chips::trace;

/// Costs of the launches of an ELF on an emulated chip: a row for each scalar and each result, `ready` or `refused`. Cycles are in
/// proportion to the call `launch`. A slice is the longest time between two calls of the set-up's function.
///
/// # Errors
/// There is no QEMU, the program did not end with exit code 0, or a line of its output cannot be read.
pub fn costs_of_launches(chip: &Chip, elf: &Path, budgets: &Budgets) -> io::Result<Vec<Value>> {
    let text = trace::emulate(chip, elf, &REPEATABLE, |_| Ok(()))?;
    let launch = budgets.budget(chip.name, "launch");
    let ratio = launch
        .cycles
        .zip(launch.instructions)
        .map(|(cycles, instructions)| cycles as f64 / instructions as f64);
    let mut groups: BTreeMap<[&str; 2], (Vec<u64>, u64)> = BTreeMap::new();
    for line in text.lines() {
        let unknown = || io::Error::other(format!("not a line of the corpus: {line}"));
        let (key, [motion, table, slice]) = parsed(line).ok_or_else(unknown)?;
        let (launches, greatest) = groups.entry(key).or_default();
        launches.push(motion + table);
        *greatest = slice.max(*greatest);
    }
    let cycles = |instructions: u64| Some((ratio? * instructions as f64).round() as u64);
    let row = |([scalar, result], (mut launches, slice)): ([&str; 2], (Vec<u64>, u64))| {
        launches.sort_unstable();
        let launch = |index: usize| launches.get(index).copied().unwrap_or_default();
        let [median, greatest] = [launch(launches.len() / 2), launch(launches.len() - 1)];
        json!({
            "chip": chip.name,
            "scalar": scalar,
            "result": result,
            "launches": launches.len(),
            "median_instructions": median,
            "greatest_instructions": greatest,
            "median_cycles_model": cycles(median),
            "greatest_cycles_model": cycles(greatest),
            "slice_cycles_model": cycles(slice),
        })
    };
    Ok(groups.into_iter().map(row).collect())
}

/// Scalar and result of a line, and the instructions of the motion, of the table and of the longest slice.
fn parsed(line: &str) -> Option<([&str; 2], [u64; 3])> {
    let words: Vec<_> = line.split_whitespace().collect();
    let [scalar, _, result, "motion", motion, "table", table, "slice", slice] = words[..] else {
        return None;
    };
    let number = |word: &str| word.parse().ok();
    Some(([scalar, result], [number(motion)?, number(table)?, number(slice)?]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_has_a_launch() {
        let launch = (["q31", "ready"], [40, 80, 9]);
        assert_eq!(parsed("q31 7 ready motion 40 table 80 slice 9"), Some(launch));
        assert_eq!(parsed("q31 7 ready motion 40"), None);
        assert_eq!(parsed("panicked at the corpus"), None);
    }
}
