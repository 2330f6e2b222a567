//! `toytop sweep`: many motions, one row for each, in one CSV file.

mod columns;
mod rows;

use crate::arguments::values::{LEAST_POSITIVE, Values, number};
use crate::files::{file_or_stdout, whole_file};
use crate::terminal::parallel::write_rows;
use crate::terminal::report::Report;
use clap::Args;
use columns::{DEFAULT_COLUMNS, SweepColumn};
use rows::{MAX_MOTIONS, Sweep};
use std::path::PathBuf;
use std::str::FromStr;
use std::sync::atomic::{AtomicU64, Ordering::Relaxed};
use std::time::Instant;
use toytop_host::Failure;
use toytop_host::input::scenario::ScenarioFile;

/// Constants and errors of many motions of a scenario, a grid or a random sample
///
/// Each motion is one row. A sweep uses all processor cores and can be divided into parts.
#[derive(Args)]
#[command(
    after_help = "Example: toytop sweep host/scenarios/toy_top.toml --spin 90..300/200 --tilt 1..60/100 -o grid.csv\n         toytop sweep host/scenarios/figure_3_loops.toml --vary e1=-0.9..0.1/41 --vary e3=log:1.01..100/33 -o grid.csv\n         toytop sweep host/scenarios/toy_top.toml --spin 90..300 --motions 1000000 --part 3/100 -o part_003.csv"
)]
pub struct SweepArgs {
    /// Scenario file whose numbers vary
    scenario: PathBuf,
    /// CSV file, which appears when it is complete; - is stdout
    #[arg(short, long, value_name = "FILE")]
    output: PathBuf,
    /// Spin of a release, rad/s: X,Y,... or LOW..HIGH/COUNT; with --motions also LOW..HIGH. log:LOW..HIGH is even in the logarithm
    #[arg(long, value_name = "VALUES", allow_hyphen_values = true)]
    spin: Option<Values>,
    /// Tilt of a release, degrees
    #[arg(long, value_name = "VALUES", allow_hyphen_values = true)]
    tilt: Option<Values>,
    /// Precession of a release, rad/s
    #[arg(long, value_name = "VALUES", allow_hyphen_values = true)]
    precession: Option<Values>,
    /// Nutation of a release, rad/s
    #[arg(long, value_name = "VALUES", allow_hyphen_values = true)]
    nutation: Option<Values>,
    /// Any number of the scenario but alpha, beta and omega, in the unit of its key: --vary com_height=0.02..0.04/21
    #[arg(long, value_name = "KEY=VALUES", value_parser = key_and_values)]
    vary: Vec<(String, Values)>,
    /// Number of random motions; without it, all combinations of the grid
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..=MAX_MOTIONS))]
    motions: Option<u64>,
    /// Seed of the random motions
    #[arg(long, value_name = "S", default_value_t = 1)]
    seed: u64,
    /// Columns: names of toytop constants; of toytop state, at every time; error_f32 (against f64), bound_f32, segments_f32
    #[arg(long, value_name = "LIST", value_delimiter = ',', default_value = DEFAULT_COLUMNS, value_parser = SweepColumn::from_str)]
    columns: Vec<SweepColumn>,
    /// Number of times at which each motion is evaluated
    #[arg(long, value_name = "N", default_value_t = 16, value_parser = clap::value_parser!(u32).range(1..=4096))]
    instants: u32,
    /// Nutation periods over which these times are spread; a motion without one has the time 2 pi sqrt((A/p + s)/g)
    #[arg(long, value_name = "X", default_value_t = 1.0, value_parser = number(LEAST_POSITIVE..=1e9), allow_hyphen_values = true)]
    periods: f64,
    /// Part I of N: motions I, I+N, I+2N, ... Only part 1 has a header, so that cat joins the parts
    #[arg(long, value_name = "I/N", default_value = "1/1", value_parser = part)]
    part: [u64; 2],
}

impl SweepArgs {
    /// Keys of the scenario that vary, each with its values.
    fn varied(&self) -> Vec<(String, Values)> {
        let Self { spin, tilt, precession, nutation, vary, .. } = self;
        let keys = ["spin", "tilt_deg", "precession", "nutation"].map(str::to_owned);
        let of_release = keys.into_iter().zip([spin, tilt, precession, nutation]);
        let given = of_release.filter_map(|(key, values)| Some((key, values.clone()?)));
        given.chain(vary.iter().cloned()).collect()
    }
}

fn key_and_values(text: &str) -> Result<(String, Values), String> {
    let (key, values) = text.split_once('=').ok_or("must be KEY=VALUES")?;
    Ok((key.to_owned(), values.parse()?))
}

fn part(text: &str) -> Result<[u64; 2], &'static str> {
    const MAX_PARTS: u64 = 1 << 32;
    let number = |text: &str| text.parse::<u64>().ok();
    let pair = text.split_once('/').and_then(|(part, parts)| Some([number(part)?, number(parts)?]));
    pair.filter(|[part, parts]| *parts <= MAX_PARTS && (1..=*parts).contains(part))
        .ok_or("must be I/N with I from 1 to N, and N at most 2^32")
}

pub fn run(arguments: &SweepArgs) -> Result<Report, Failure> {
    let started = Instant::now();
    whole_file::require_other("--output", Some(&arguments.output), &[Some(&arguments.scenario)])?;
    let sweep = Sweep::new(
        ScenarioFile::read(&arguments.scenario)?,
        arguments.varied(),
        arguments.motions.map(|motions| (motions, arguments.seed)),
        arguments.columns.clone(),
        arguments.instants,
        arguments.periods,
    )?;
    let [part, parts] = arguments.part;
    let count = (sweep.count + parts - part) / parts;
    let (refused, first) = (AtomicU64::new(0), AtomicU64::new(u64::MAX));
    let row = |row: u64, text: &mut Vec<u8>| {
        let index = row * parts + part - 1;
        if !sweep.row(index, text) {
            refused.fetch_add(1, Relaxed);
            first.fetch_min(index, Relaxed);
        }
    };
    file_or_stdout::write(Some(&arguments.output), |out| {
        // only the first part has the header, so that `cat` joins all parts
        out.write_all(if part == 1 { sweep.header() } else { String::new() }.as_bytes())?;
        write_rows(count, &row, out)
    })?;
    let refused = match refused.into_inner() {
        0 => String::new(),
        refused => {
            let row = first.into_inner();
            let reason = sweep.refusal(row).unwrap_or_default();
            format!(", {refused} of them refused (first: row {row}, {reason}),")
        }
    };
    let seconds = started.elapsed().as_secs_f64();
    let text = format!("{}: {count} motions{refused} in {seconds:.1} s", arguments.output.display());
    Ok(Report::default().with_notes([text]))
}
