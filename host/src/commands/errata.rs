//! `toytop errata`: errors of the printed paper; the printed and the corrected formulas are evaluated.

use super::Report;
use crate::Failure;
use crate::cli::{ErrataArgs, Format};
use crate::errata::{Erratum, RIGHT, WRONG, errata};
use crate::output::{self, Cell, Record};

pub(super) fn run(arguments: &ErrataArgs) -> Result<Report, Failure> {
    let evaluate = |erratum: Erratum| match (erratum.residuals)() {
        Ok(residuals) => Ok((erratum, residuals)),
        Err(error) => Err(Failure::Method(format!("{}: {error}", erratum.place))),
    };
    let found = errata().into_iter().map(evaluate).collect::<Result<Vec<_>, _>>()?;
    let confirmed = |[printed, corrected]: [f64; 2]| printed > WRONG && corrected < RIGHT;
    let missed = !found.iter().all(|&(_, residuals)| confirmed(residuals));
    let text = match arguments.format {
        Format::Table => table(&found),
        Format::Csv => output::csv(&records(&found)).map_err(Failure::Output)?,
        Format::Json => output::json_list("slips", &records(&found)).map_err(Failure::Output)?,
    };
    Ok(Report { text, missed, ..Report::default() })
}

fn records(found: &[(Erratum, [f64; 2])]) -> Vec<Record> {
    let record = |(number, (erratum, [printed, corrected])): (u64, &(Erratum, [f64; 2]))| {
        let text = |text: &str| Cell::Text(text.to_owned());
        Record(vec![
            ("number", Cell::Count(number)),
            ("place", text(erratum.place)),
            ("against", text(erratum.against)),
            ("printed", text(erratum.printed)),
            ("corrected", text(erratum.corrected)),
            ("residual_printed", Cell::Number(*printed)),
            ("residual_corrected", Cell::Number(*corrected)),
        ])
    };
    (1..).zip(found).map(record).collect()
}

/// Table with four lines for each erratum: its place, the quantity that it is compared with, and the two versions with their residuals.
fn table(found: &[(Erratum, [f64; 2])]) -> String {
    let line = |cells: [&str; 4]| cells.map(str::to_owned).to_vec();
    let mut lines = vec![line(["", "", "", "residual"])];
    for (number, (erratum, [printed, corrected])) in (1..).zip(found) {
        lines.push(line([&format!("{number:2}"), "", erratum.place, ""]));
        lines.push(line(["", "against", erratum.against, ""]));
        lines.push(line(["", "printed", erratum.printed, &format!("{printed:.2}")]));
        lines.push(line(["", "corrected", erratum.corrected, &bound(*corrected)]));
    }
    output::columns(lines, 3)
}

/// Power of ten well above the residual, from 1e-15, because the digits of a rounding error depend on the machine's sine.
fn bound(residual: f64) -> String {
    if residual == 0.0 {
        return "0".to_owned();
    }
    format!("< 1e{}", (2.0 * residual).log10().ceil().max(-15.0))
}
