//! `toytop study`: random motions of every regime, and how the ephemeris and its bound do on them.

mod corners;

use super::Report;
use crate::Failure;
use crate::cli::{Format, StudyArgs};
use crate::cores::STACK;
use crate::output::{self, Cell, Record};
use crate::progress::Progress;
use crate::study::gauss::Rule;
use crate::study::random::Random;
use crate::study::tally::{Case, Side, Spread, Tally, regime};
use crate::study::trial::{self, Worst};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::{AtomicU64, Ordering};
use std::thread::{self, Builder};
use std::time::{Duration, Instant};

pub(super) fn run(arguments: &StudyArgs) -> Result<Report, Failure> {
    if arguments.corners {
        return corners::run(arguments);
    }
    let started = Instant::now();
    let threads = thread::available_parallelism().map_or(1, usize::from);
    let next = AtomicU64::new(0);
    let work = || worker(arguments, &next);
    let mut tally = Tally::default();
    thread::scope(|scope| {
        let spawn = |_| Builder::new().stack_size(STACK).spawn_scoped(scope, work);
        let workers = (0..threads).map(spawn).collect::<Result<Vec<_>, _>>().map_err(Failure::Output)?;
        watch(&next, arguments.count());
        for worker in workers {
            match worker.join() {
                Ok(part) => tally.merge(part),
                Err(_) => tally.failures.push("a thread was lost".to_owned()),
            }
        }
        Ok::<(), Failure>(())
    })?;
    tally.finish();
    let time = started.elapsed().as_secs_f64();
    let head =
        format!("{} motions, seed {}: {time:.0} s on {threads} cores\n", arguments.count(), arguments.seed);
    let missed = !tally.failures.is_empty() || tally.scalars.iter().any(|side| side.violated > 0);
    let records = || records(&tally);
    let text = match arguments.format {
        Format::Table => head + &show(&tally),
        Format::Csv => output::csv(&records()).map_err(Failure::Output)?,
        Format::Json => output::json_list("rows", &records()).map_err(Failure::Output)?,
    };
    let below = arguments.format == Format::Table;
    let failures = tally.failures.iter().map(|failure| format!("FAILURE: {failure}"));
    let remarks = failures.filter(|_| !below);
    Ok(Report { text, missed, ..Report::default() }.with_remarks(remarks, below))
}

/// Takes motion after motion until there are no more.
fn worker(arguments: &StudyArgs, next: &AtomicU64) -> Tally {
    let rule = Rule::new();
    let mut tally = Tally::default();
    loop {
        let stream = next.fetch_add(1, Ordering::Relaxed);
        if stream >= arguments.count() {
            return tally;
        }
        let mut random = Random::new(arguments.seed, stream);
        match catch_unwind(AssertUnwindSafe(|| trial::run(&mut random, &rule))) {
            Ok(Ok(trial)) => tally.add(&trial),
            Ok(Err(refused)) => tally.failures.push(format!("motion {stream}: {refused}")),
            Err(_) => tally.failures.push(format!("motion {stream}: panicked")),
        }
    }
}

/// Shows how far the workers are.
fn watch(next: &AtomicU64, motions: u64) {
    let mut progress = Progress::new(motions, "motions");
    let mut seen = 0;
    while seen < motions {
        thread::sleep(Duration::from_millis(20));
        let now = next.load(Ordering::Relaxed).min(motions);
        progress.add(now - seen);
        seen = now;
    }
}

/// The lines of the table.
fn records(tally: &Tally) -> Vec<Record> {
    let record = |row: Vec<String>| {
        let cells = ["what", "f64", "f32"].into_iter().zip(row);
        Record(cells.map(|(name, cell)| (name, Cell::Text(cell))).collect())
    };
    rows(tally).into_iter().skip(1).map(record).collect()
}

const NAMES: [&str; 2] = ["f64", "f32"];

fn show(tally: &Tally) -> String {
    let regimes: Vec<_> = tally.regimes.iter().map(|(name, count)| format!("{count} {name}")).collect();
    let mut text = format!("{}\n\n{}\n", regimes.join("; "), output::columns(rows(tally), 1));
    for (name, side) in NAMES.iter().zip(&tally.scalars) {
        text.push_str(&format!("{name}, closest to the bound:\n{}", worst(side)));
    }
    for failure in &tally.failures {
        text.push_str(&format!("FAILURE: {failure}\n"));
    }
    text + "Truth: the paper's integrals by quadrature in double-double. Near: 16 places in the first period;\n\
            far: 8, up to 10^9 periods away.\n"
}

/// A name, and what is said of f64 and of f32.
fn rows(tally: &Tally) -> Vec<Vec<String>> {
    let sides = &tally.scalars;
    let mut rows = vec![vec![String::new(), NAMES[0].to_owned(), NAMES[1].to_owned()]];
    let mut row = |name: &str, value: &dyn Fn(&Side) -> String| {
        rows.push(vec![name.to_owned(), value(&sides[0]), value(&sides[1])]);
    };
    let mut sizes: Vec<_> = sides.iter().flat_map(|side| side.fits.keys().copied()).collect();
    sizes.sort_unstable();
    sizes.dedup();
    for size in sizes {
        row(&format!("fit {size} segments"), &|side| side.fits.get(&size).copied().unwrap_or(0).to_string());
    }
    row("do not fit", &|side| side.no_fit.to_string());
    row("BOUND VIOLATED", &|side| side.violated.to_string());
    let kinds: [(&str, Part); 2] = [("near", |side| &side.near), ("far", |side| &side.far)];
    for (kind, spread) in kinds {
        for (quantile, share) in [("median", 0.5), ("99 %", 0.99), ("greatest", 1.0)] {
            row(&format!("{kind}: error, {quantile}, rad"), &|side| {
                format!("{:.1e}", spread(side).error(share))
            });
        }
        for (quantile, share) in [
            ("least", 0.0),
            ("1 %", 0.01),
            ("10 %", 0.1),
            ("median", 0.5),
            ("90 %", 0.9),
            ("99 %", 0.99),
            ("greatest", 1.0),
        ] {
            row(&format!("{kind}: bound / error, {quantile}"), &|side| {
                format!("{:.2}", spread(side).ratio(share))
            });
        }
        row(&format!("{kind}: bound at most 10 times the error"), &|side| {
            format!("{:.1} %", 100.0 * spread(side).within(10.0))
        });
    }
    rows
}

fn worst(side: &Side) -> String {
    let line = |case: &Case| {
        let Case { worst: Worst { error, bound, t }, segments, trial } = case;
        let regime = regime(trial.regime);
        format!(
            "  error {error:.2e}, bound {bound:.2e} at t = {t:.3e}, {segments} segments, {regime}: {}\n",
            trial.numbers
        )
    };
    side.worst.iter().map(line).collect()
}

/// One of the two spreads of a side.
type Part = fn(&Side) -> &Spread;
