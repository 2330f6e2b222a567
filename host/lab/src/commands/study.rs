//! `toytop-lab study`: errors and bounds of the ephemeris for random motions of every regime.

mod corners;
mod fit;

use crate::cli::StudyArgs;
use crate::study::tally::{Case, Side, Spread, Tally};
use crate::study::trial::{self, Worst};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::time::Instant;
use toytop_host::Failure;
use toytop_host::Report;
use toytop_host::cli::Format;
use toytop_host::input::random::Random;
use toytop_host::output::names::regime;
use toytop_host::output::{self, Cell, Record};
use toytop_host::thread_pool;

pub(super) fn run(arguments: &StudyArgs) -> Result<Report, Failure> {
    if arguments.corners {
        return corners::run(arguments);
    }
    if arguments.fit {
        return fit::run(arguments);
    }
    if arguments.docs.is_some() {
        return Err(Failure::Input("--docs: needs --corners or --fit".to_owned()));
    }
    let started = Instant::now();
    let cores = thread_pool::of_all_cores()?;
    let add = |tally: &mut Tally, stream| add(tally, arguments, stream);
    let mut tally = thread_pool::tally(&cores, (arguments.count(), "motions"), add, Tally::merged);
    tally.finish();
    let time = started.elapsed().as_secs_f64();
    let threads = cores.current_num_threads();
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

fn add(tally: &mut Tally, arguments: &StudyArgs, stream: u64) {
    let mut random = Random::new(arguments.seed, stream);
    match catch_unwind(AssertUnwindSafe(|| trial::run(&mut random))) {
        Ok(Ok(trial)) => tally.add(&trial),
        Ok(Err(refused)) => tally.failures.push(format!("motion {stream}: {refused}")),
        Err(_) => tally.failures.push(format!("motion {stream}: panicked")),
    }
}

/// Value in the table.
#[derive(Clone, Copy)]
enum Value {
    Count(u64),
    Error(f64),
    Ratio(f64),
    Share(f64),
}

impl Value {
    fn text(self) -> String {
        match self {
            Self::Count(count) => count.to_string(),
            Self::Error(error) => format!("{error:.1e}"),
            Self::Ratio(ratio) => format!("{ratio:.2}"),
            Self::Share(share) => format!("{:.1} %", 100.0 * share),
        }
    }

    fn cell(self) -> Cell {
        match self {
            Self::Count(count) => Cell::Count(count),
            Self::Error(x) | Self::Ratio(x) | Self::Share(x) => Cell::Number(x),
        }
    }
}

/// Records of the table.
fn records(tally: &Tally) -> Vec<Record> {
    let record = |(name, values): (String, [Value; 2])| {
        let values = NAMES.into_iter().zip(values.map(Value::cell));
        Record(std::iter::once(("what", Cell::Text(name))).chain(values).collect())
    };
    lines(tally).into_iter().map(record).collect()
}

const NAMES: [&str; 2] = ["f64", "f32"];

fn show(tally: &Tally) -> String {
    let regimes: Vec<_> =
        tally.regimes.iter().map(|(name, count)| format!("{count} {}", name.replace('_', " "))).collect();
    let mut text = format!("{}\n\n{}\n", regimes.join("; "), output::columns(rows(tally), 1));
    for (name, side) in NAMES.iter().zip(&tally.scalars) {
        text.push_str(&format!("{name}, closest to the bound:\n{}", worst(side)));
    }
    for failure in &tally.failures {
        text.push_str(&format!("FAILURE: {failure}\n"));
    }
    text + "Truth: the paper's integrals by quadrature in 192 bits. Near: 16 places in the first period;\n\
            far: 8, up to 10^9 periods away. Rates: of angular velocity and u', near and far, as shares of the greatest rate.\n"
}

fn rows(tally: &Tally) -> Vec<Vec<String>> {
    let header = ["", NAMES[0], NAMES[1]].map(str::to_owned).to_vec();
    let row =
        |(name, values): (String, [Value; 2])| std::iter::once(name).chain(values.map(Value::text)).collect();
    std::iter::once(header).chain(lines(tally).into_iter().map(row)).collect()
}

/// Name of each row, with the values for f64 and f32.
fn lines(tally: &Tally) -> Vec<(String, [Value; 2])> {
    let sides = &tally.scalars;
    let mut lines = Vec::new();
    let mut line = |name: &str, value: &dyn Fn(&Side) -> Value| {
        lines.push((name.to_owned(), sides.each_ref().map(value)));
    };
    let mut sizes: Vec<_> = sides.iter().flat_map(|side| side.fits.keys().copied()).collect();
    sizes.sort_unstable();
    sizes.dedup();
    for size in sizes {
        let count = |side: &Side| Value::Count(side.fits.get(&size).copied().unwrap_or(0));
        line(&format!("fit {size} segments"), &count);
    }
    line("do not fit", &|side| Value::Count(side.no_fit));
    line("BOUND VIOLATED", &|side| Value::Count(side.violated));
    let kinds: [(&str, &str, Part); 3] = [
        ("near", "rad", |side| &side.near),
        ("far", "rad", |side| &side.far),
        ("rates", "of the greatest", |side| &side.rates),
    ];
    for (kind, unit, spread) in kinds {
        for (quantile, share) in [("median", 0.5), ("99 %", 0.99), ("greatest", 1.0)] {
            line(&format!("{kind}: error, {quantile}, {unit}"), &|side| {
                Value::Error(spread(side).error(share))
            });
        }
        for (quantile, share) in RATIOS {
            line(&format!("{kind}: bound / error, {quantile}"), &|side| {
                Value::Ratio(spread(side).ratio(share))
            });
        }
        line(&format!("{kind}: bound at most 10 times the error"), &|side| {
            Value::Share(spread(side).within(10.0))
        });
    }
    lines
}

/// Quantiles of the ratios of all motions in the table.
const RATIOS: [(&str, f64); 7] = [
    ("least", 0.0),
    ("1 %", 0.01),
    ("10 %", 0.1),
    ("median", 0.5),
    ("90 %", 0.9),
    ("99 %", 0.99),
    ("greatest", 1.0),
];

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

/// Function that selects a spread of a side.
type Part = fn(&Side) -> &Spread;
