//! `toytop score`: output of an integrator, compared with the exact motion.

use super::Report;
use crate::Failure;
use crate::input::scenario::Scenario;
use crate::output::{self, Column, Format, Lists, Record, short, two_digits};
use crate::score::exact_reference::{ExactReference, Score};
use crate::score::order;
use crate::score::trajectory::Trajectory;
use clap::Args;
use std::path::PathBuf;

/// `toytop score`
#[derive(Args)]
pub struct ScoreArgs {
    /// Scenario file
    scenario: PathBuf,
    /// CSV files with the output of integrators for this scenario: one file for each step size and method
    #[arg(value_name = "RESULT.csv", required = true)]
    results: Vec<PathBuf>,
    /// Body axis of the files that is the axis of symmetry, from the tip to the centre of mass
    #[arg(long, value_name = "N", default_value_t = 3, value_parser = clap::value_parser!(u8).range(1..=3))]
    symmetry_axis: u8,
    /// Form of the output
    #[arg(long, default_value = "table")]
    format: Format,
}

/// Trajectory of a file with its errors.
struct Scored {
    trajectory: Trajectory,
    score: Score,
}

/// Integration method with its order of convergence.
struct Integrator<'a> {
    name: &'a str,
    files: Vec<&'a Scored>,
    order: Option<f64>,
}

pub fn run(arguments: &ScoreArgs) -> Result<Report, Failure> {
    let ScoreArgs { scenario, results, symmetry_axis, format } = arguments;
    let start = format!("toytop state {} --times 0", scenario.display());
    let scenario = Scenario::read(scenario)?;
    let reference = ExactReference::new(&scenario, &start)?;
    let (mut files, mut warnings) = (Vec::new(), Vec::new());
    for path in results {
        let trajectory = Trajectory::read(path)?.with_symmetry_axis(*symmetry_axis);
        let score = reference.score(&trajectory)?;
        warnings
            .extend(score.warning.iter().map(|warning| format!("warning: {}: {warning}", trajectory.name)));
        files.push(Scored { trajectory, score });
    }
    let integrators = integrators(&files, &mut warnings);
    let order =
        |name: &str| integrators.iter().find(|other| other.name == name).and_then(|found| found.order);
    let records: Vec<_> = files.iter().map(|file| record(file, order(method(file)))).collect();
    let summary = |Integrator { name, files, order }: &Integrator<'_>| {
        Record::default().with("method", *name).with("files", files.len()).with("order", *order)
    };
    let summaries: Vec<_> = integrators.iter().map(summary).collect();
    let order = if let [only] = &integrators[..] { only.order } else { None };
    let rest =
        Record::default().with("order", order).with("scenario", &*scenario.name).with("sign", "nearest");
    let object = Lists(vec![("files", &records), ("methods", &summaries)], rest);
    let text = output::render(*format, &object, || tables(&records, &integrators))?;
    Ok(Report::from(text).with_remarks(warnings, *format == Format::Table))
}

/// Name of the method of a file; empty if the file does not state it.
fn method(file: &Scored) -> &str {
    file.trajectory.method.as_deref().unwrap_or_default()
}

/// Methods in the order of their first files. Files of one method over different times have no order, which a warning states.
fn integrators<'a>(files: &'a [Scored], warnings: &mut Vec<String>) -> Vec<Integrator<'a>> {
    let mut integrators: Vec<Integrator<'a>> = Vec::new();
    for file in files {
        match integrators.iter_mut().find(|integrator| integrator.name == method(file)) {
            Some(integrator) => integrator.files.push(file),
            None => integrators.push(Integrator { name: method(file), files: vec![file], order: None }),
        }
    }
    for Integrator { files, order, .. } in &mut integrators {
        let end = |file: &Scored| file.trajectory.rows.last().map_or(0.0, |row| row.t);
        let first = files[0];
        let other = files.iter().find(|file| (end(file) - end(first)).abs() > 1e-6 * end(first).abs());
        if let Some(other) = other {
            let names = [first, other].map(|file| &*file.trajectory.name);
            warnings.push(format!("warning: no order: {} end at different times", names.join(" and ")));
            continue;
        }
        let point = |file: &&Scored| Some([file.trajectory.step?, file.score.max_error]);
        *order = order::fitted(&files.iter().filter_map(point).collect::<Vec<_>>());
    }
    integrators
}

fn record(Scored { trajectory, score }: &Scored, order: Option<f64>) -> Record {
    let phases = &score.phases;
    let [l, n, h] = [0, 1, 2].map(|i| score.drift.map(|drift| drift[i]));
    Record::default()
        .with("name", &*trajectory.name)
        .with("method", trajectory.method.clone())
        .with("rows", trajectory.rows.len())
        .with("step", trajectory.step)
        .with("evaluations", trajectory.evaluations)
        .with("max_error_rad", score.max_error)
        .with("rms_error_rad", score.rms_error)
        .with("final_error_rad", score.final_error)
        .with("max_u_error", score.max_u_error)
        .with("max_position_error", score.max_tip_error)
        .with("nutation_error_rad", phases.nutation)
        .with("precession_error_rad", phases.precession)
        .with("spin_error_rad", phases.spin)
        .with("residual_rad", phases.residual)
        .with("drift_h", h)
        .with("drift_l", l)
        .with("drift_n", n)
        .with("max_norm_error", score.norm_error)
        .with("truth_bound_rad", score.truth_bound)
        .with("method_order", order)
}

/// Table of the errors, table of the phase errors and drifts, and the orders of convergence.
fn tables(records: &[Record], integrators: &[Integrator<'_>]) -> String {
    let errors: [Column<'_>; 8] = [
        ("name", "", two_digits),
        ("rows", "rows", two_digits),
        ("step", "step, s", |step| short(step, 4)),
        ("max_error_rad", "max, rad", two_digits),
        ("rms_error_rad", "rms, rad", two_digits),
        ("final_error_rad", "final, rad", two_digits),
        ("max_u_error", "u", two_digits),
        ("max_position_error", "position", two_digits),
    ];
    let details = [
        ("name", ""),
        ("nutation_error_rad", "nutation"),
        ("precession_error_rad", "precession"),
        ("spin_error_rad", "spin"),
        ("residual_rad", "residual"),
        ("drift_h", "h"),
        ("drift_l", "l"),
        ("drift_n", "n"),
    ];
    let details: [Column<'_>; 8] = details.map(|(name, heading)| (name, heading, two_digits as _));
    let mut orders = String::new();
    for Integrator { name, order, .. } in integrators {
        let of = if name.is_empty() { String::new() } else { format!(" of {name}") };
        orders.extend(order.map(|order| format!("Order of convergence{of}: {order:.2}\n")));
    }
    let files = integrators.iter().flat_map(|integrator| &integrator.files);
    let bound = files.map(|file| file.score.truth_bound).fold(0.0, f64::max);
    format!(
        "Errors against the exact motion\n{}\nPhase errors over the last nutation period, rad (above 0: ahead), and relative drifts of h, l and n\n{}\n\
         {orders}The exact motion is within {bound:.1e} rad. Errors of the orientation are 2 sqrt(|d alpha|^2 + |d beta|^2) with the nearer\n\
         sign. Residual: what no phase error explains. Drifts: of h in units of max(|h|, p g), of l and n in units of\n\
         max(|l|, |n|, sqrt(2 A p g)).\n",
        output::aligned(records, &errors),
        output::aligned(records, &details),
    )
}
