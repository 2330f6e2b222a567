//! `toytop bench`: computing times of states, by the core and by other methods, on this machine with this build.

use super::Report;
use crate::Failure;
use crate::cli::{BenchArgs, Format};
use crate::measure::speed::{Row, methods, ticks, timing};
use crate::output;
use crate::output::progress::Progress;

pub(super) fn run(arguments: &BenchArgs) -> Result<Report, Failure> {
    let scenario = methods::scenario()?;
    let mut progress = Progress::new(methods::TASKS + ticks::TASKS, "tasks");
    let methods = methods::run(&scenario, &mut progress)?;
    let ticks = ticks::run(&scenario.motion, &mut progress)?;
    drop(progress);
    let records = || methods.iter().chain(&ticks).map(Row::record).collect::<Vec<_>>();
    let text = match arguments.format {
        Format::Table => tables(&methods, &ticks),
        Format::Csv => output::csv(&records()).map_err(Failure::Output)?,
        Format::Json => output::json_list("rows", &records()).map_err(Failure::Output)?,
    };
    Ok(Report { text, ..Report::default() })
}

fn tables(methods: &[Row], ticks: &[Row]) -> String {
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    let build = if cfg!(debug_assertions) { "UNOPTIMISED build" } else { "release build" };
    format!(
        "{} samples over {} periods (s = A = p = 1, C = 0.6, e = 0.7, 0.9, 1.85), orientation within {:.0e} rad:\n\n{}\n\
         One state at a time:\n\n{}\n\
         (This processor may work on several ticks at once where the numbers are given; the next tick waits for the one before.)\n\
         Least of {} runs on one core of {cores}; {build}.\n",
        methods::SAMPLES,
        methods::PERIODS,
        methods::ACCURACY,
        columns(&["", "time", "error, rad", "times as fast"], methods),
        columns(&["", "time", "million a second"], ticks),
        timing::RUNS,
    )
}

fn columns(header: &[&str], lines: &[Row]) -> String {
    let row = |line: &Row| {
        let mut row = vec![line.what.clone(), timing::in_words(line.seconds)];
        row.extend(line.rest.iter().cloned());
        row
    };
    let header = header.iter().map(|&name| name.to_owned()).collect();
    output::columns(std::iter::once(header).chain(lines.iter().map(row)).collect(), 1)
}
