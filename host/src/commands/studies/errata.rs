//! `toytop errata`: errors of the printed paper.

use super::Report;
use super::options::FormatArgs;
use crate::Failure;
use crate::errata::{ERRATA, Erratum};
use crate::output::{self, Record};

pub fn run(arguments: &FormatArgs) -> Result<Report, Failure> {
    let record = |(number, erratum): (u64, Erratum)| {
        let Erratum { place, against, printed, corrected, residuals } = erratum;
        Record::default()
            .with("number", number)
            .with("place", place)
            .with("against", against)
            .with("printed", printed)
            .with("corrected", corrected)
            .with("residual_printed", residuals[0])
            .with("residual_corrected", residuals[1])
    };
    let records: Vec<_> = (1..).zip(ERRATA).map(record).collect();
    Ok(output::render(arguments.format, &output::list("slips", &records), table)?.into())
}

/// Table with four lines for each erratum: its place, the quantity that it is compared with, and the two versions with their residuals.
fn table() -> String {
    let line = |cells: [&str; 4]| cells.map(str::to_owned).to_vec();
    let mut lines = vec![line(["", "", "", "residual"])];
    for (number, erratum) in (1..).zip(ERRATA) {
        let [printed, corrected] = erratum.residuals;
        let corrected = if corrected == 0.0 { "0".to_owned() } else { format!("< {corrected:e}") };
        lines.push(line([&format!("{number:2}"), "", erratum.place, ""]));
        lines.push(line(["", "against", erratum.against, ""]));
        lines.push(line(["", "printed", erratum.printed, &format!("{printed:.2}")]));
        lines.push(line(["", "corrected", erratum.corrected, &corrected]));
    }
    output::columns(lines, 3)
}
