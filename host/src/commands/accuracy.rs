//! `toytop accuracy`: error and cost of each scalar.

use super::Report;
use crate::Failure;
use crate::budget::{Costs, PLOTTED};
use crate::cli::{AccuracyArgs, Format, ScalarChoice};
use crate::measure::accuracy::{Accuracy, Errors, OCTAVES, measured};
use crate::output::whole_file;
use crate::output::{self, Cell, Record};
use crate::pictures::accuracy as picture;
use crate::pictures::plot::Form;

/// Powers of two up to which ticks are counted, for the errors over fewer ticks.
const SPANS: [u32; 4] = [10, 20, 30, 40];

pub(super) fn run(arguments: &AccuracyArgs) -> Result<Report, Failure> {
    let form = arguments.plot.as_deref().map(|path| Form::of(path, "--plot")).transpose()?;
    let costs = Costs::known()?;
    let all = measured(&ScalarChoice::chosen(&arguments.scalar))?;
    let text = match arguments.format {
        Format::Table => show(&all, &costs),
        Format::Csv => output::csv(&records(&all, &costs)).map_err(Failure::Output)?,
        Format::Json => output::json_list("rows", &records(&all, &costs)).map_err(Failure::Output)?,
    };
    if let (Some(path), Some(form)) = (&arguments.plot, form) {
        whole_file::write("--plot", path, &picture::picture(&all)?.encoded(form)?)?;
    }
    Ok(Report { text, ..Report::default() })
}

/// Row for each scalar: errors with this many digits, and costs.
#[must_use]
pub fn rows(all: &[Accuracy], costs: &Costs, digits: usize) -> Vec<Vec<String>> {
    let head = ["", "greatest error, rad", "RMS error, rad", "tip, s", "norm", "energy"];
    let mut header: Vec<_> = head.map(str::to_owned).into();
    header.extend(PLOTTED.map(|chip| chip.heading.to_owned()));
    let line = |accuracy: &Accuracy| {
        let errors = accuracy.all();
        let Errors { angle, tip, norm, energy, .. } = errors;
        let mut line = vec![accuracy.scalar.name().to_owned()];
        line.extend([angle, errors.rms(), tip, norm, energy].map(|x| format!("{x:.digits$e}")));
        let cost =
            |chip| costs.next_tick(accuracy.scalar, chip).map_or("-".to_owned(), |cost| cost.to_string());
        line.extend(PLOTTED.iter().map(cost));
        line
    };
    std::iter::once(header).chain(all.iter().map(line)).collect()
}

fn show(all: &[Accuracy], costs: &Costs) -> String {
    let mut spans = vec![vec!["greatest error, rad, up to tick".to_owned()]];
    spans[0].extend(SPANS.map(|k| format!("2^{k}")));
    spans.extend(all.iter().map(|accuracy| {
        let mut line = vec![accuracy.scalar.name().to_owned()];
        line.extend(SPANS.map(|k| format!("{:.1e}", accuracy.up_to(k).angle)));
        line
    }));
    format!(
        "{}\n{}\nThe ephemeris in each scalar, over ticks from 1 to 2^{OCTAVES}, against the truth to thirty digits. RMS: root of the\n\
         mean square. Tip: in units of s. Norm: of alpha and beta. Energy: from alpha, beta and their rates (in fixed point, f32),\n\
         relative. Cost of the next tick, at most, from firmware-examples/budgets.toml; cycles are modelled.\n",
        output::columns(rows(all, costs, 1), 1),
        output::columns(spans, 1),
    )
}

fn records(all: &[Accuracy], costs: &Costs) -> Vec<Record> {
    let of_scalar = |accuracy: &Accuracy| {
        let scalar = accuracy.scalar;
        let costs = PLOTTED.map(|chip| {
            let cost = costs.next_tick(scalar, &chip);
            (chip.column, cost.map_or(Cell::Absent, Cell::Count))
        });
        let record = |(octave, errors): (u32, &Errors)| {
            let first = 1_u64 << octave;
            let last = if octave < OCTAVES { 2 * first - 1 } else { first };
            let mut cells = vec![
                ("scalar", Cell::Text(scalar.name().to_owned())),
                ("first_tick", Cell::Count(first)),
                ("last_tick", Cell::Count(last)),
                ("max_orientation_error_rad", Cell::Number(errors.angle)),
                ("rms_orientation_error_rad", Cell::Number(errors.rms())),
                ("max_tip_error_per_s", Cell::Number(errors.tip)),
                ("max_norm_defect", Cell::Number(errors.norm)),
                ("max_energy_defect", Cell::Number(errors.energy)),
            ];
            cells.extend(costs.clone());
            Record(cells)
        };
        (0..).zip(&accuracy.octaves).map(record).collect::<Vec<_>>()
    };
    all.iter().flat_map(of_scalar).collect()
}
