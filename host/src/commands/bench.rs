//! `toytop bench`: what a state of the top costs, and what it costs elsewhere. On this machine, of this build.

mod contest;
mod ticks;
mod timing;

use super::Report;
use crate::Failure;
use crate::cli::{BenchArgs, Format};
use crate::output::{self, Cell, Record};
use crate::progress::Progress;

/// One line of a table: what was timed, and the rest in cells.
struct Line {
    what: String,
    /// Of the whole task, or of one tick, s.
    seconds: f64,
    /// Of the orientation, rad.
    error: Option<f64>,
    rest: Vec<String>,
}

impl Line {
    fn record(&self) -> Record {
        Record(vec![
            ("what", Cell::Text(self.what.trim().to_owned())),
            ("seconds", Cell::Number(self.seconds)),
            ("error_rad", self.error.into()),
        ])
    }
}

pub(super) fn run(arguments: &BenchArgs) -> Result<Report, Failure> {
    let scenario = contest::scenario()?;
    let mut progress = Progress::new(contest::TASKS + ticks::TASKS, "tasks");
    let contest = contest::run(&scenario, &mut progress)?;
    let ticks = ticks::run(&scenario.motion, &mut progress)?;
    drop(progress);
    let records = || contest.iter().chain(&ticks).map(Line::record).collect::<Vec<_>>();
    let text = match arguments.format {
        Format::Table => tables(&contest, &ticks),
        Format::Csv => output::csv(&records()).map_err(Failure::Output)?,
        Format::Json => output::json_list("rows", &records()).map_err(Failure::Output)?,
    };
    Ok(Report { text, ..Report::default() })
}

fn tables(contest: &[Line], ticks: &[Line]) -> String {
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    let build = if cfg!(debug_assertions) { "UNOPTIMISED build" } else { "release build" };
    format!(
        "{} samples over {} periods (s = A = p = 1, C = 0.6, e = 0.7, 0.9, 1.85), orientation within {:.0e} rad:\n\n{}\n\
         One state at a time:\n\n{}\n\
         (This processor may work on several ticks at once where the numbers are given; the next tick waits for the one before.)\n\
         Least of {} runs on one core of {cores}; {build}.\n",
        contest::SAMPLES,
        contest::PERIODS,
        contest::ACCURACY,
        columns(&["", "time", "error, rad", "times as fast"], contest),
        columns(&["", "time", "million a second"], ticks),
        timing::RUNS,
    )
}

fn columns(header: &[&str], lines: &[Line]) -> String {
    let row = |line: &Line| {
        let mut row = vec![line.what.clone(), timing::in_words(line.seconds)];
        row.extend(line.rest.iter().cloned());
        row
    };
    let header = header.iter().map(|&name| name.to_owned()).collect();
    output::columns(std::iter::once(header).chain(lines.iter().map(row)).collect(), 1)
}
