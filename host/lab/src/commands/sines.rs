//! `toytop-lab sines`: greatest errors of the sines of an integer phase.

use crate::cli::SinesArgs;
use crate::sines::{ROUTINES, Routine, UNIT, Worst, phases, swept};
use toytop_host::Failure;
use toytop_host::Report;
use toytop_host::cli::Format;
use toytop_host::output::{self, Cell, Record};

pub(super) fn run(arguments: &SinesArgs) -> Result<Report, Failure> {
    let found = swept(arguments.every)?;
    let pairs = || ROUTINES.iter().zip(&found);
    let text = match arguments.format {
        Format::Table => {
            let head = ["", "", "sine, 2^-31", "cosine, 2^-31", "bits", "worst phase, 2^-32 turns"];
            let mut lines = vec![head.map(str::to_owned).into()];
            lines.extend(pairs().map(line));
            let count = phases(arguments.every);
            format!("{}\nGreatest errors over {count} phases.\n", output::columns(lines, 2))
        }
        Format::Csv => output::csv(&records(pairs())).map_err(Failure::Output)?,
        Format::Json => output::json_list("rows", &records(pairs())).map_err(Failure::Output)?,
    };
    Ok(Report { text, ..Report::default() })
}

/// Error as a number of bits after the binary point.
fn bits(error: f64) -> f64 {
    -error.log2()
}

fn line((routine, [sine, cosine]): (&Routine, &Worst)) -> Vec<String> {
    let (error, phase) = if sine.0 >= cosine.0 { *sine } else { *cosine };
    vec![
        routine.name.to_owned(),
        routine.what.to_owned(),
        format!("{:.3}", sine.0 / UNIT),
        format!("{:.3}", cosine.0 / UNIT),
        format!("{:.2}", bits(error)),
        format!("{phase:#010x}"),
    ]
}

fn records<'a>(pairs: impl Iterator<Item = (&'a Routine, &'a Worst)>) -> Vec<Record> {
    let of_way = |(routine, worst): (&Routine, &Worst)| {
        let record = |(function, (error, phase)): (&str, (f64, u32))| {
            Record(vec![
                ("table", Cell::Text(routine.name.to_owned())),
                ("function", Cell::Text(function.to_owned())),
                ("max_error", Cell::Number(error)),
                ("max_error_units", Cell::Number(error / UNIT)),
                ("bits", Cell::Number(bits(error))),
                ("phase", Cell::Count(phase.into())),
            ])
        };
        ["sine", "cosine"].into_iter().zip(*worst).map(record).collect::<Vec<_>>()
    };
    pairs.flat_map(of_way).collect()
}
