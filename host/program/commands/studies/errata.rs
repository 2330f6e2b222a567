//! `toytop errata`: errors of the printed paper, from the page of the errata. `tests/reference/errata.py` evaluates each formula as printed
//! and as corrected, and a test compares the residuals.

use clap::Args;
use serde_json::json;
use toytop_host::output::{self, Format};
use toytop_host::{Failure, Report};

/// Errors of the printed paper and their corrections
#[derive(Args)]
#[command(after_help = "Example: toytop errata --format csv")]
pub struct ErrataArgs {
    /// Form of the output
    #[arg(long, default_value = "table")]
    format: Format,
}

pub fn run(arguments: &ErrataArgs) -> Result<Report, Failure> {
    let record = |(number, erratum): (u64, Erratum)| {
        let Erratum { place, against, printed, corrected, residuals } = erratum;
        json!({
            "number": number,
            "place": place,
            "against": against,
            "printed": printed,
            "corrected": corrected,
            "residual_printed": residuals[0],
            "residual_corrected": residuals[1],
        })
    };
    let records: Vec<_> = (1..).zip(errata()).map(record).collect();
    Ok(output::render(arguments.format, &json!({ "errata": records }), &records, || table().to_owned())
        .into())
}

/// Page whose first block of text is the table.
const PAGE: &str = include_str!("../../../../core/closed-forms/docs/errata.md");

/// Table of the page: a heading, then four lines for each erratum.
fn table() -> &'static str {
    PAGE.split("```").nth(1).map_or("", |block| block.trim_start_matches("text\n"))
}

/// Wrong formula of the paper with its correction.
struct Erratum {
    /// Place in the paper: a label or a section.
    place: &'static str,
    /// Quantity that the formula is compared with; a residual is their largest difference.
    against: &'static str,
    /// Formula as printed.
    printed: &'static str,
    /// Corrected formula.
    corrected: &'static str,
    /// Residual of the printed formula, to two decimals, and a power of ten above that of the corrected one; 0 where it is exact.
    residuals: [f64; 2],
}

/// All errors with a formula that can be evaluated, in the order of the paper.
fn errata() -> impl Iterator<Item = Erratum> {
    let lines: Vec<_> = table().lines().skip(1).map(|line| field(line, " ")).collect();
    let erratum = |[(_, place), (_, against), (_, printed), (_, corrected)]: [(_, _); 4]| {
        let [(wrong, printed), (right, corrected)] = [printed, corrected].map(|text| field(text, "  "));
        let residuals = [wrong, right].map(|text| text.trim_start_matches("< ").parse().unwrap_or(f64::NAN));
        Erratum { place, against, printed, corrected, residuals }
    };
    lines.as_chunks().0.to_vec().into_iter().map(erratum)
}

/// First field of a line, and the rest of it after a separator.
fn field(line: &'static str, separator: &str) -> (&'static str, &'static str) {
    let (first, rest) = line.trim_start().split_once(separator).unwrap_or((line, ""));
    (first, rest.trim_start())
}
