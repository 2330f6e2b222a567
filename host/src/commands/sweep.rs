//! `toytop sweep`: many motions, a row each, on all cores, in a file that can be gone on with.

use super::Report;
use crate::cli::SweepArgs;
use crate::progress::Progress;
use crate::sweep::{Part, Rows, Space};
use crate::{Failure, cores};
use rayon::ThreadPool;
use rayon::iter::{IntoParallelIterator, ParallelIterator};
use std::path::Path;
use std::time::Instant;

/// Rows of a block: what is lost at most when the program is killed.
const BLOCK: u64 = 1024;

pub(super) fn run(arguments: &SweepArgs) -> Result<Report, Failure> {
    let started = Instant::now();
    let rows = rows(arguments)?;
    let cores = cores::all()?;
    let output = &arguments.output;
    let in_columns = output.extension().is_some_and(|ending| ending == "parquet");
    let Added { len, before } = if in_columns {
        parquet(&rows, &cores, arguments)?
    } else {
        append(output, &rows, &cores, arguments)?
    };
    let (seconds, motions) = (started.elapsed().as_secs_f64(), len - before);
    let already = if before > 0 { format!(" ({before} were there)") } else { String::new() };
    let text = format!(
        "{}: {motions} motions{already} in {seconds:.1} s on {} cores, {:.0} a minute\n",
        output.display(),
        cores.current_num_threads(),
        60.0 * motions as f64 / seconds,
    );
    Ok(Report { text, ..Report::default() })
}

/// How many rows a file has, and how many it had.
struct Added {
    len: u64,
    before: u64,
}

/// The rows that a CSV file lacks.
fn append(path: &Path, rows: &Rows, cores: &ThreadPool, arguments: &SweepArgs) -> Result<Added, Failure> {
    let mut part = Part::open(path, rows, arguments.shard.0, arguments.resume)?;
    let (len, before) = (part.len(), part.done());
    let mut progress = Progress::new(len - before, "motions");
    while part.done() < len {
        let block = part.done()..len.min(part.done() + BLOCK);
        let count = block.end - block.start;
        let lines: Vec<String> =
            cores.install(|| block.into_par_iter().map(|row| rows.row(part.index(row))).collect());
        part.append(&lines.concat(), count)?;
        progress.add(count);
    }
    Ok(Added { len, before })
}

/// The same by way of a CSV file beside it, which alone can be gone on with.
#[cfg(feature = "parquet")]
fn parquet(rows: &Rows, cores: &ThreadPool, arguments: &SweepArgs) -> Result<Added, Failure> {
    use crate::sweep::columnar;
    let (output, shard) = (&arguments.output, arguments.shard.0);
    let csv = output.with_extension("parquet.csv");
    if let Some(len) = columnar::rows_there(output, rows, shard, arguments.resume)?
        && !csv.exists()
    {
        return Ok(Added { len, before: len });
    }
    let added = append(&csv, rows, cores, arguments)?;
    columnar::write(&csv, output, rows, shard, added.len)?;
    std::fs::remove_file(&csv).map_err(|error| crate::whole_file::refused("--output", &csv, error))?;
    Ok(added)
}

#[cfg(not(feature = "parquet"))]
fn parquet(_: &Rows, _: &ThreadPool, arguments: &SweepArgs) -> Result<Added, Failure> {
    Err(Failure::Input(format!(
        "--output: {}: this program was built without Parquet (cargo build --features parquet); name a .csv file",
        arguments.output.display()
    )))
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
