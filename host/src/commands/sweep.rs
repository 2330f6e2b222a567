//! `toytop sweep`: many motions, a row each, on all cores, in a file that can be gone on with.

use super::Report;
use crate::cli::SweepArgs;
use crate::progress::Progress;
use crate::sweep::{Part, Rows, Space};
use crate::{Failure, cores};
use rayon::iter::{IntoParallelIterator, ParallelIterator};
use std::time::Instant;

/// Rows of a block: what is lost at most when the program is killed.
const BLOCK: u64 = 1024;

pub(super) fn run(arguments: &SweepArgs) -> Result<Report, Failure> {
    let started = Instant::now();
    let rows = rows(arguments)?;
    let cores = cores::all()?;
    let mut part = Part::open(&arguments.output, &rows, arguments.shard.0, arguments.resume)?;
    let before = part.done();
    let mut progress = Progress::new(part.len() - before, "motions");
    while part.done() < part.len() {
        let block = part.done()..part.len().min(part.done() + BLOCK);
        let count = block.end - block.start;
        let lines: Vec<String> =
            cores.install(|| block.into_par_iter().map(|row| rows.row(part.index(row))).collect());
        part.append(&lines.concat(), count)?;
        progress.add(count);
    }
    drop(progress);
    let (seconds, motions) = (started.elapsed().as_secs_f64(), part.done() - before);
    let already = if before > 0 { format!(" ({before} were there)") } else { String::new() };
    let text = format!(
        "{}: {motions} motions{already} in {seconds:.1} s on {} cores, {:.0} a minute\n",
        arguments.output.display(),
        cores.current_num_threads(),
        60.0 * motions as f64 / seconds,
    );
    Ok(Report { text, ..Report::default() })
}

fn rows(arguments: &SweepArgs) -> Result<Rows, Failure> {
    let SweepArgs { e1, e2, e3, a_over_ps, c_over_a, .. } = arguments;
    let space = Space {
        axes: [e1, e2, e3, a_over_ps, c_over_a].map(Clone::clone),
        signs: arguments.signs,
        sample: arguments.motions.map(|motions| (motions, arguments.seed)),
    };
    space.check()?;
    let mut columns = arguments.columns.clone();
    let mut seen = Vec::new();
    columns.retain(|column| {
        !seen.contains(column) && {
            seen.push(*column);
            true
        }
    });
    Ok(Rows { space, columns, ticks: arguments.ticks, periods: arguments.periods })
}
