//! `toytop errata`: errors of the printed paper, from `errata.toml`. `tests/reference/errata.py` evaluates each formula as printed
//! and as corrected, and a test compares the residuals.

use crate::terminal::report::Report;
use clap::Args;
use serde::{Deserialize, Serialize};
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
    let document = document();
    Ok(output::render(arguments.format, &document, &document.errata, || table(&document.errata)).into())
}

fn document() -> Errata {
    toml::from_str(include_str!("errata.toml")).expect("the file of this program")
}

/// Heading, then four lines for each erratum.
fn table(errata: &[Erratum]) -> String {
    let mut text = "               residual\n".to_owned();
    for erratum in errata {
        let Erratum { number, place, against, printed, corrected, residual_printed, residual_corrected } =
            erratum;
        let bound =
            if *residual_corrected > 0.0 { format!("< {residual_corrected:e}") } else { "0".to_owned() };
        text += &format!(
            "{number:2}  {place}\n    against              {against}\n    printed    {residual_printed:8.2}  {printed}\n    \
             corrected  {bound:>8}  {corrected}\n"
        );
    }
    text
}

/// Wrong formula of the paper with its correction. The names are the keys of JSON.
#[derive(Deserialize, Serialize)]
struct Erratum {
    /// Number on the page.
    number: usize,
    /// Place in the paper: a label or a section.
    place: String,
    /// Quantity that the formula is compared with; a residual is their largest difference.
    against: String,
    /// Formula as printed.
    printed: String,
    /// Corrected formula.
    corrected: String,
    /// Residual of the printed formula, to two decimals.
    residual_printed: f64,
    /// Power of ten above the residual of the corrected formula; 0 where it is exact.
    residual_corrected: f64,
}

/// Errors with a formula that can be evaluated, in the order of the paper.
#[derive(Deserialize, Serialize)]
struct Errata {
    errata: Vec<Erratum>,
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::files::doc_page::DocPage;

    #[test]
    fn the_page_has_the_table() {
        let table = format!("```text\n{}```\n", table(&document().errata));
        DocPage::assert_current("core/closed-forms/docs/errata.md", "toytop errata: errors", &table);
    }
}
