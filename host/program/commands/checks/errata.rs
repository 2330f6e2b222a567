//! `toytop errata`: errors of the printed paper, from the page of the errata. `tests/reference/errata.py` evaluates each formula as printed
//! and as corrected, and a test compares the residuals.

use crate::terminal::stdout::Report;
use clap::Args;
use serde::Serialize;
use serde_json::json;
use std::array::from_fn;
use toytop_host::Failure;
use toytop_host::output::{self, Format};

/// Errors of the printed paper and their corrections
#[derive(Args)]
#[command(after_help = "Example: toytop errata --format csv")]
pub struct ErrataArgs {
    /// Form of the output
    #[arg(long, default_value = "table")]
    format: Format,
}

pub fn run(arguments: &ErrataArgs) -> Result<Report, Failure> {
    let errata = errata();
    Ok(output::render(arguments.format, &json!({ "errata": errata }), &errata, || table().to_owned()).into())
}

/// Page whose first block of text is the table.
const PAGE: &str = include_str!("../../../../core/closed-forms/docs/errata.md");

/// Table of the page: a heading, then four lines for each erratum.
fn table() -> &'static str {
    PAGE.split("```").nth(1).map_or("", |block| block.trim_start_matches("text\n"))
}

/// Wrong formula of the paper with its correction. The names are the keys of JSON.
#[derive(Serialize)]
struct Erratum {
    /// Number on the page.
    number: usize,
    /// Place in the paper: a label or a section.
    place: &'static str,
    /// Quantity that the formula is compared with; a residual is their largest difference.
    against: &'static str,
    /// Formula as printed.
    printed: &'static str,
    /// Corrected formula.
    corrected: &'static str,
    /// Residual of the printed formula, to two decimals.
    residual_printed: f64,
    /// Power of ten above the residual of the corrected formula; 0 where it is exact.
    residual_corrected: f64,
}

/// All errors with a formula that can be evaluated, in the order of the paper.
fn errata() -> Vec<Erratum> {
    let lines: Vec<_> = table().lines().skip(1).collect();
    lines.as_chunks().0.iter().map(erratum).collect()
}

/// Erratum of four lines, whose fields are apart by two spaces or more.
fn erratum([heading, against, printed, corrected]: &[&'static str; 4]) -> Erratum {
    fn fields<const N: usize>(line: &'static str) -> [&'static str; N] {
        let mut fields = line.split("  ").map(str::trim).filter(|field| !field.is_empty());
        from_fn(|_| fields.next().unwrap_or_default())
    }
    let residual = |text: &str| text.trim_start_matches("< ").parse().unwrap_or(f64::NAN);
    let [number, place] = fields(heading);
    let [_, against] = fields(against);
    let [_, residual_printed, printed] = fields(printed);
    let [_, residual_corrected, corrected] = fields(corrected);
    Erratum {
        number: number.parse().unwrap_or_default(),
        place,
        against,
        printed,
        corrected,
        residual_printed: residual(residual_printed),
        residual_corrected: residual(residual_corrected),
    }
}
