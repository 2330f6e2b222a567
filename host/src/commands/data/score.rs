//! `toytop score`: output of an integrator, compared with the exact motion.

mod methods;

use super::Report;
use super::options::{PICTURE, ending_in, positive};
use crate::Failure;
use crate::input::scenario::Scenario;
use crate::motion::propagate::period;
use crate::output::{self, Column, Format, Lists, Record, short, two_digits};
use crate::pictures::chart::Chart;
use crate::pictures::drawing;
use crate::score::benchmarks;
use crate::score::exact_reference::ExactReference;
use crate::score::trajectory::Trajectory;
use clap::Args;
use methods::{Method, Run, work};
use std::collections::BTreeMap;
use std::path::PathBuf;

/// `toytop score`
#[derive(Args)]
pub struct ScoreArgs {
    /// Scenario file; with --benchmark, the first CSV file
    scenario: PathBuf,
    /// CSV files with the output of integrators for this scenario: one file for each step size and method
    #[arg(value_name = "RESULT.csv", required_unless_present = "benchmark")]
    results: Vec<PathBuf>,
    /// Problem of `toytop benchmark` that replaces the scenario; the files are in the conventions of its source
    #[arg(long, value_name = "NAME")]
    benchmark: Option<String>,
    /// Step size of each file, s; without it, the step size that the file states, or the spacing of its rows
    #[arg(long, value_name = "H1,H2,...", value_delimiter = ',', allow_hyphen_values = true, value_parser = positive)]
    steps: Vec<f64>,
    /// Picture of the greatest error against the work, whose name ends in .svg or .png
    #[arg(long, value_name = "FILE", value_parser = ending_in(PICTURE))]
    plot: Option<PathBuf>,
    /// Form of the output
    #[arg(long, default_value = "table")]
    format: Format,
}

pub fn run(arguments: &ScoreArgs) -> Result<Report, Failure> {
    let ScoreArgs { scenario: first, results, benchmark, steps, plot, format } = arguments;
    let problem = benchmark.as_deref().map(benchmarks::named).transpose();
    let problem = problem.map_err(|failure| failure.of("--benchmark"))?;
    // command that prints the state from which a run has to start
    let (scenario, start) = match &problem {
        Some(problem) => {
            (problem.scenario.clone(), format!("toytop benchmark {} --times 0 --format csv", problem.name()))
        }
        None => (Scenario::read(first)?, format!("toytop state {} --times 0", first.display())),
    };
    let files: Vec<_> = problem.iter().map(|_| first).chain(results).collect();
    if !steps.is_empty() && steps.len() != files.len() {
        return Err(Failure::Input(format!("--steps: must be {} numbers, one for each file", files.len())));
    }
    let mut reference = ExactReference::new(&scenario, &start)?;
    if let Some(problem) = &problem {
        reference.length = problem.about.length;
    }
    let (mut methods, mut warnings) = (Vec::<Vec<Run>>::new(), Vec::new());
    for (file, path) in files.into_iter().enumerate() {
        let mut trajectory = Trajectory::read(path)?;
        if let Some(problem) = &problem {
            trajectory = trajectory.in_body_axes(&problem.to_core());
        }
        let score = reference.score(&trajectory)?;
        warnings
            .extend(score.warning.iter().map(|warning| format!("warning: {}: {warning}", trajectory.name)));
        let run = Run::new(file, trajectory, score, steps.get(file).copied());
        match methods.iter_mut().find(|runs| runs[0].method == run.method) {
            Some(runs) => runs.push(run),
            None => methods.push(vec![run]),
        }
    }
    let methods: Vec<_> = methods.into_iter().map(Method::new).collect();
    if let Some(path) = plot {
        let (unit, curves) = work(&methods, period(&scenario.motion))?;
        let chart = Chart {
            title: &format!("Work and precision: {}", scenario.name),
            labels: [unit, "greatest error of the orientation, rad"],
            powers: [true; 2],
        };
        drawing::write("--plot", path, &chart.draw(&curves), None)?;
    }
    warnings.extend(methods.iter().flat_map(|method| method.warnings.clone()));
    let mut ranked = Vec::new();
    for Method { runs, order, .. } in &methods {
        ranked.extend(runs.iter().map(|run| (run.file, record(run, *order))));
    }
    let by_file: Vec<_> = BTreeMap::from_iter(ranked.clone()).into_values().collect();
    let ranked: Vec<_> = ranked.into_iter().map(|(_, record)| record).collect();
    let summary = |Method { name, runs, order, .. }: &Method| {
        Record::default().with("method", &**name).with("files", runs.len()).with("order", *order)
    };
    let summaries: Vec<_> = methods.iter().map(summary).collect();
    let order = if let [only] = &methods[..] { only.order } else { None };
    let rest =
        Record::default().with("order", order).with("scenario", &*scenario.name).with("sign", "nearest");
    let object = Lists(vec![("files", &by_file), ("methods", &summaries)], rest);
    let text = output::render(*format, &object, || tables(&ranked, &methods));
    Ok(Report::from(text).with_remarks(warnings, *format == Format::Table))
}

fn record(run: &Run, method_order: Option<f64>) -> Record {
    let Run { score, order, .. } = run;
    let (phases, drift) = (&score.phases, &score.drift);
    let [l, n, h] = [0, 1, 2].map(|i| drift.integrals.map(|drifts| drifts[i]));
    Record::default()
        .with("name", &*run.name)
        .with("method", Some(&*run.method).filter(|name| !name.is_empty()))
        .with("rows", run.rows)
        .with("step", run.step.map(|(step, _)| step))
        .with("step_from", run.step.map(|(_, from)| from))
        .with("evaluations", run.evaluations)
        .with("max_error_rad", score.max_error)
        .with("rms_error_rad", score.rms_error)
        .with("final_error_rad", score.final_error)
        .with("max_u_error", score.max_u_error)
        .with("max_position_error", score.max_position_error)
        .with("nutation_error_rad", phases.nutation)
        .with("precession_error_rad", phases.precession)
        .with("spin_error_rad", phases.spin)
        .with("residual_rad", phases.residual)
        .with("drift_h", h)
        .with("drift_l", l)
        .with("drift_n", n)
        .with("drift_from", drift.from)
        .with("drift_uncertainty", drift.uncertainty)
        .with("max_norm_error", score.norm_error)
        .with("truth_bound_rad", score.truth_bound)
        .with("method_order", method_order)
        .with("order", *order)
}

/// Table of the errors, table of the phase errors and drifts, and the orders of convergence.
fn tables(records: &[Record], methods: &[Method]) -> String {
    let two = |x| format!("{x:.2}");
    let errors: [Column<'_>; 9] = [
        ("name", "", two),
        ("rows", "rows", two),
        ("step", "step, s", |step| short(step, 4)),
        ("max_error_rad", "max, rad", two_digits),
        ("rms_error_rad", "rms, rad", two_digits),
        ("final_error_rad", "final, rad", two_digits),
        ("max_u_error", "u", two_digits),
        ("max_position_error", "position", two_digits),
        ("order", "order", two),
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
    for Method { name, order, .. } in methods {
        let of = if name.is_empty() { String::new() } else { format!(" of {name}") };
        orders.extend(order.map(|order| format!("Order of convergence{of}: {order:.2}\n")));
    }
    let scores = || methods.iter().flat_map(|method| &method.runs).map(|run| &run.score);
    let by = if scores().any(|score| score.drift.from == Some("differences")) {
        ", for files without angular velocity computed from differences of the error"
    } else {
        ""
    };
    let bound = scores().map(|score| score.truth_bound).fold(0.0, f64::max);
    format!(
        "Errors against the exact motion\n{}\nPhase errors over the last nutation period, rad (above 0: ahead), and relative drifts of h, l and n\n{}\n\
         {orders}The exact motion is within {bound:.1e} rad. Errors of the orientation are 2 sqrt(|d alpha|^2 + |d beta|^2) with the nearer\n\
         sign. Residual: what no phase error explains. Order: from the next larger step of the same method. Drifts: of h in units of\n\
         max(|h|, p g), of l and n in units of max(|l|, |n|, sqrt(2 A p g)){by}.\n",
        output::aligned(records, &errors),
        output::aligned(records, &details),
    )
}
