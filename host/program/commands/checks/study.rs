//! `toytop study`: two studies of random launches, which check the core.

mod corners;
mod fit;

use crate::files::doc_page::DocPage;
use crate::terminal::report::Report;
use crate::terminal::table::TextTable;
use clap::{Args, Subcommand};
use serde::Serialize;
use serde_json::json;
use toytop_host::Failure;
use toytop_host::output::{self, Format};

/// Random launches near degenerate cases, and fits, against the truth
#[derive(Args)]
#[command(after_help = "Example: toytop study corners --motions 20000 --truths 400 --accept")]
pub struct StudyArgs {
    #[command(subcommand)]
    study: Study,
}

/// Study with its arguments.
#[derive(Subcommand)]
enum Study {
    /// Errors of tables near every degenerate case, in four scalars, beside their bounds
    ///
    /// The exit code is 1 if a bound is exceeded.
    #[command(after_help = "Example: toytop study corners --motions 20000 --truths 400 --accept")]
    Corners {
        #[command(flatten)]
        options: StudyOptions,
        /// Number of launches that are compared with the truth
        #[arg(long, value_name = "N", default_value_t = 1000, value_parser = clap::value_parser!(u64).range(1..))]
        truths: u64,
    },
    /// Launches fitted to simulated samples of three sets of sensors
    ///
    /// The exit code is 1 if a wrong launch is not refused.
    #[command(after_help = "Example: toytop study fit --motions 1000 --seed 2")]
    Fit(StudyOptions),
}

/// Arguments of both studies.
#[derive(Args)]
struct StudyOptions {
    /// Number of launches; in a study of fits, for each set of sensors
    #[arg(long, value_name = "N", default_value_t = 10_000, value_parser = clap::value_parser!(u64).range(1..=100_000_000))]
    motions: u64,
    /// Seed of the random launches
    #[arg(long, value_name = "S", default_value_t = 1)]
    seed: u64,
    /// Rewrite the table of the study's page in host/docs
    #[arg(long)]
    accept: bool,
    /// Form of the output
    #[arg(long, default_value = "table")]
    format: Format,
}

pub fn run(arguments: &StudyArgs) -> Result<Report, Failure> {
    match &arguments.study {
        Study::Corners { options, truths } => {
            options.run("host/docs/accuracy.md", "toytop study corners: corners", || {
                corners::run(options, *truths)
            })
        }
        Study::Fit(options) => {
            options.run("host/docs/fit.md", "toytop study fit: launches", || fit::run(options))
        }
    }
}

/// Result of a study.
struct Summary<T> {
    headline: String,
    rows: Vec<T>,
    /// Launches that must not occur.
    failures: Vec<String>,
}

impl StudyOptions {
    /// Report of a study, whose table belongs to a page at this mark.
    fn run<T: Serialize>(
        &self,
        page: &str,
        mark: &str,
        study: impl FnOnce() -> Result<Summary<T>, Failure>,
    ) -> Result<Report, Failure> {
        /// Largest number of failures in a report.
        const REPORTED: usize = 20;
        // a missing place in the page is reported before the computation
        let page = self.accept.then(|| DocPage::read(page, mark)).transpose()?;
        let Summary { headline, rows, failures } = study()?;
        let mut table = TextTable::of_fields(&rows, 2);
        for heading in &mut table.lines[0] {
            *heading = heading.replace('_', " ");
        }
        if let Some(page) = page {
            page.write(&format!("{headline}\n\n{}", table.markdown()))?;
        }
        let aligned = || format!("{headline}\n{}", table.aligned());
        let text = output::render(self.format, &json!({ "rows": rows }), &rows, aligned);
        let first = failures.iter().take(REPORTED).map(|failure| format!("FAILURE: {failure}"));
        Ok(Report { text, notes: first.collect(), check_failed: !failures.is_empty() })
    }
}
