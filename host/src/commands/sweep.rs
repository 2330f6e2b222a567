//! `toytop sweep`: many motions, one row for each, computed on all cores, in a file that can be continued.

use super::Report;
use crate::Failure;
use crate::cli::{SweepArgs, SweepFiles};
use crate::input::scenario::Template;
use crate::output::progress::Progress;
use crate::output::whole_file;
use crate::pictures::heat_map::HeatMap;
use crate::pictures::plot::Form;
use crate::sweep::parts::{self, Found};
use crate::sweep::{Launches, Motions, Part, Rows, Space};
use crate::thread_pool;
use rayon::ThreadPool;
use rayon::iter::{IntoParallelIterator, ParallelIterator};
use std::fs::File;
use std::io::{self, BufRead, BufReader, ErrorKind, Write};
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::time::Instant;

/// Number of rows of a block. If the program is killed, at most one block is lost.
const BLOCK: u64 = 1024;

pub(super) fn run(arguments: &SweepArgs) -> Result<Report, Failure> {
    match &arguments.files {
        Some(SweepFiles::Verify { files }) => return verify(files),
        Some(SweepFiles::Join { parts, output }) => return join(parts, output),
        None => {}
    }
    let started = Instant::now();
    let rows = rows(arguments)?;
    let cores = thread_pool::of_all_cores()?;
    let output = arguments.output();
    if arguments.recompute {
        return recompute(output, &rows, &cores, arguments.shard.0);
    }
    let in_columns = is_parquet(output);
    let to_stdout = output.as_os_str() == "-";
    let map = match &arguments.plot {
        Some(_) if to_stdout || in_columns || arguments.shard.0 != [1, 1] => {
            return Err(Failure::Input("--plot: needs a whole CSV file, no shard".to_owned()));
        }
        Some(text) => Some(HeatMap::new(text, &rows.motions, &rows.header())?),
        None => None,
    };
    let Added { len, before, refused } = if to_stdout {
        print(&rows, &cores, arguments)?
    } else if in_columns {
        parquet(&rows, &cores, arguments)?
    } else {
        let (added, _) = append(output, &rows, &cores, arguments)?;
        added
    };
    if let Some(map) = map {
        let csv = whole_file::read("--output", output, LARGEST_PLOTTED)?;
        whole_file::write("--plot", &output.with_extension("svg"), &map.draw(&csv)?.encoded(Form::Svg)?)?;
    }
    let (seconds, motions) = (started.elapsed().as_secs_f64(), len - before);
    let already = if before > 0 { format!(" ({before} existed)") } else { String::new() };
    let refused = refused.summary(&rows);
    let text = format!(
        "{}: {motions} motions{already}{refused} in {seconds:.1} s on {} cores, {:.0} a minute\n",
        if to_stdout { "stdout".into() } else { output.to_string_lossy() },
        cores.current_num_threads(),
        60.0 * motions as f64 / seconds,
    );
    if to_stdout {
        return Ok(Report { notes: vec![text.trim_end().to_owned()], ..Report::default() });
    }
    Ok(Report { text, ..Report::default() })
}

/// Size of the largest file that is drawn, MiB.
const LARGEST_PLOTTED: u64 = 4096;

/// Number of rows of a file after a run, and before it.
struct Added {
    len: u64,
    before: u64,
    /// Rows of this run that are no motions.
    refused: Refused,
}

/// Rows without a motion.
#[derive(Default)]
struct Refused {
    count: u64,
    /// Index of the first one in the sweep.
    first: Option<u64>,
}

impl Refused {
    /// Part of the summary: the number of these rows, and the reason for the first one.
    fn summary(&self, rows: &Rows) -> String {
        let Self { count, first } = self;
        first.map_or_else(String::new, |index| {
            let reason = rows.motions.refusal(index).unwrap_or_default();
            format!(", {count} of them refused (first: row {index}, {reason}),")
        })
    }
}

/// Computes rows of a shard, block by block and in order. `take` receives the lines of each block and their number. The result are the
/// rows that are no motions.
fn compute(
    rows: &Rows,
    cores: &ThreadPool,
    shard: [u64; 2],
    range: Range<u64>,
    mut take: impl FnMut(&str, u64) -> Result<(), Failure>,
) -> Result<Refused, Failure> {
    let mut refused = Refused::default();
    let mut progress = Progress::logged(range.end - range.start, "motions");
    for start in range.clone().step_by(BLOCK as usize) {
        let block = start..range.end.min(start + BLOCK);
        let count = block.end - block.start;
        let line = |row| {
            let index = Part::index_in(row, shard);
            let (line, is_refused) = rows.row_or_refusal(index);
            (line, is_refused.then_some(index))
        };
        let (lines, indices): (Vec<String>, Vec<Option<u64>>) =
            cores.install(|| block.into_par_iter().map(line).unzip());
        take(&lines.concat(), count)?;
        refused.count += indices.iter().flatten().count() as u64;
        refused.first = refused.first.or(indices.into_iter().flatten().next());
        progress.add(count);
    }
    Ok(refused)
}

/// Compares the rows of each file with their checksums.
fn verify(files: &[PathBuf]) -> Result<Report, Failure> {
    let mut text = String::new();
    for path in files {
        let Found { rows, motions } = parts::verify(path)?;
        text +=
            &format!("{}: {rows} rows of a sweep of {motions}, all match their checksums\n", path.display());
    }
    Ok(Report { text, ..Report::default() })
}

/// Joins shards in one file.
fn join(files: &[PathBuf], output: &Path) -> Result<Report, Failure> {
    let Found { rows, .. } =
        if is_parquet(output) { join_parquet(files, output)? } else { parts::join(files, output)? };
    Ok(Report {
        text: format!("{}: {rows} rows of {} files\n", output.display(), files.len()),
        ..Report::default()
    })
}

/// Joins shards in a Parquet file, by a temporary CSV file beside it.
#[cfg(feature = "parquet")]
fn join_parquet(files: &[PathBuf], output: &Path) -> Result<Found, Failure> {
    use crate::sweep::columnar;
    let csv = output.with_extension("parquet.csv");
    let found = parts::join(files, &csv)?;
    columnar::write(&csv, output, columnar::version(), found.rows)?;
    std::fs::remove_file(&csv).map_err(|error| whole_file::refused("--output", &csv, error))?;
    Ok(found)
}

#[cfg(not(feature = "parquet"))]
fn join_parquet(_: &[PathBuf], output: &Path) -> Result<Found, Failure> {
    Err(without_parquet(output))
}

fn is_parquet(path: &Path) -> bool {
    path.extension().is_some_and(|ending| ending == "parquet")
}

/// Compares every line of a CSV file with the row that the sweep computes.
fn recompute(path: &Path, rows: &Rows, cores: &ThreadPool, shard: [u64; 2]) -> Result<Report, Failure> {
    let name = path.display().to_string();
    let refuse = |reason: String| Failure::Input(format!("{name}: {reason}"));
    let open = |path| File::open(path).and_then(|file| Ok((file.metadata()?.is_file(), file)));
    let (regular, file) = open(path).map_err(|error| refuse(error.to_string()))?;
    if !regular {
        return Err(refuse("must be a regular file".to_owned()));
    }
    let mut lines = BufReader::new(file).split(b'\n');
    let mut number = 0_u64;
    let mut expect = |expected: &str| {
        number += 1;
        let found = lines.next().transpose().map_err(|error| refuse(error.to_string()))?;
        let reason = match found {
            Some(found) if found == expected.as_bytes() => return Ok(()),
            Some(_) => "differs from the computed row",
            None => "missing: the file ends here; --resume continues it",
        };
        Err(refuse(format!("line {number}: {reason}")))
    };
    expect(rows.header().trim_end())?;
    let len = Part::rows_of(rows, shard);
    compute(rows, cores, shard, 0..len, |block, _| block.lines().try_for_each(&mut expect))?;
    if lines.next().is_some() {
        return Err(refuse(format!("line {}: must be the end of the file", len + 2)));
    }
    Ok(Report { text: format!("{name}: {len} rows, all equal to the computed ones\n"), ..Report::default() })
}

/// Appends the rows that a CSV file lacks. The file is locked until the returned part is dropped.
fn append(
    path: &Path,
    rows: &Rows,
    cores: &ThreadPool,
    arguments: &SweepArgs,
) -> Result<(Added, Part), Failure> {
    let shard = arguments.shard.0;
    let mut part = Part::open(path, rows, shard, arguments.resume)?;
    let (len, before) = (part.total(), part.done());
    let refused = compute(rows, cores, shard, before..len, |lines, count| part.append(lines, count))?;
    Ok((Added { len, before, refused }, part))
}

/// Prints the header and each block of rows when it is computed. A reader that closes the pipe (`| head`) is no
/// failure.
fn print(rows: &Rows, cores: &ThreadPool, arguments: &SweepArgs) -> Result<Added, Failure> {
    if arguments.resume {
        return Err(Failure::Input("--resume: needs a file to continue; --output is stdout".into()));
    }
    let shard = arguments.shard.0;
    let len = Part::rows_of(rows, shard);
    let mut done = 0;
    let mut stdout = io::stdout().lock();
    let mut put =
        |text: &str| stdout.write_all(text.as_bytes()).and_then(|()| stdout.flush()).map_err(Failure::Output);
    let printed = put(&rows.header()).and_then(|()| {
        compute(rows, cores, shard, 0..len, |lines, count| {
            done += count;
            put(lines)
        })
    });
    let refused = match printed {
        Err(Failure::Output(error)) if error.kind() == ErrorKind::BrokenPipe => Refused::default(),
        other => other?,
    };
    Ok(Added { len: done, before: 0, refused })
}

/// Writes the rows as Parquet, by a CSV file beside it. An interrupted run continues the CSV file.
#[cfg(feature = "parquet")]
fn parquet(rows: &Rows, cores: &ThreadPool, arguments: &SweepArgs) -> Result<Added, Failure> {
    use crate::sweep::columnar;
    let (output, shard) = (arguments.output(), arguments.shard.0);
    let csv = output.with_extension("parquet.csv");
    if let Some(len) = columnar::rows_there(output, rows, shard, arguments.resume)?
        && !csv.exists()
    {
        return Ok(Added { len, before: len, refused: Refused::default() });
    }
    // the CSV file is locked until the Parquet file is complete
    let (added, _part) = append(&csv, rows, cores, arguments)?;
    columnar::write(&csv, output, columnar::metadata(rows, shard), added.len)?;
    std::fs::remove_file(&csv)
        .map_err(|error| crate::output::whole_file::refused("--output", &csv, error))?;
    Ok(added)
}

#[cfg(not(feature = "parquet"))]
fn parquet(_: &Rows, _: &ThreadPool, arguments: &SweepArgs) -> Result<Added, Failure> {
    Err(without_parquet(arguments.output()))
}

#[cfg(not(feature = "parquet"))]
fn without_parquet(output: &Path) -> Failure {
    Failure::Input(format!(
        "--output: {}: this program was built without Parquet (cargo build --features parquet); name a .csv file",
        output.display()
    ))
}

fn rows(arguments: &SweepArgs) -> Result<Rows, Failure> {
    let SweepArgs { e1, e2, e3, a_over_ps, c_over_a, .. } = arguments;
    let sample = arguments.motions.map(|motions| (motions, arguments.seed));
    let motions = if let Some(path) = &arguments.scenario {
        Motions::Scenario(Launches::new(Template::read(path)?, &arguments.varied(), sample)?)
    } else {
        let axes = [e1, e2, e3, a_over_ps, c_over_a].map(Clone::clone);
        let space = Space { axes, signs: arguments.signs, sample };
        space.check()?;
        Motions::BranchPoints(space)
    };
    let mut columns = arguments.columns.clone();
    let mut seen = Vec::new();
    columns.retain(|column| {
        !seen.contains(column) && {
            seen.push(*column);
            true
        }
    });
    Ok(Rows { motions, columns, ticks: arguments.ticks, periods: arguments.periods })
}
