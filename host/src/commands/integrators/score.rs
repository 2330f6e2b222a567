//! `toytop score`: output of an integrator, compared with the exact motion.

use super::problems;
use crate::commands::drawing;
use crate::commands::drawing::chart::{Chart, Curve};
use crate::commands::options::{PICTURE, ending_in, positive};
use crate::files::whole_file;
use crate::input::scenario::Scenario;
use crate::motion::propagate::period_or_natural_time;
use crate::output::table::{Column, TextTable};
use crate::output::{self, Format, short, two_digits};
use crate::score::errors::{ExactReference, Score};
use crate::score::order;
use crate::score::trajectory::Trajectory;
use crate::{Failure, Report};
use clap::Args;
use serde_json::{Value, json};
use std::path::{Path, PathBuf};

/// Errors of your integrator's output against the exact motion
#[derive(Args)]
#[command(
    after_help = "A RESULT has a header, and a row for each time: t in s, and w,x,y,z (unit quaternion from body to fixed coordinates), or\n\
        alpha_re,alpha_im,beta_re,beta_im, or r11,r12,...,r33 (matrix by rows, body to fixed). The drifts of h, l and n need\n\
        wx,wy,wz (rad/s, body frame) or omega_x,omega_y,omega_z (fixed frame). Other columns are\n\
        ignored. The two signs of a quaternion are one rotation. Lines above the header may state: # method = RK4, # step = 0.001,\n\
        # evaluations = 40000. Files of one method with different steps give its order of convergence.\n\n\
        Example: toytop score host/scenarios/toy_top.toml rk4_*.csv --plot rk4.svg\n         \
        toytop state TOP.toml --times 0..1/1001 --method stepper --format csv > s.csv && toytop score TOP.toml s.csv"
)]
pub struct ScoreArgs {
    /// Scenario file, and CSV files with the output of integrators for it: one file for each step size and method
    #[arg(value_names = ["SCENARIO", "RESULT.csv"], num_args = 0..)]
    files: Vec<PathBuf>,
    /// Problem of `toytop benchmark` in place of the scenario; the files are in the conventions of its source
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

/// Trajectory of a file with its errors.
struct ScoredFile {
    trajectory: Trajectory,
    score: Score,
    /// Step size, s, and its source.
    step: Option<(f64, &'static str)>,
    /// Order of convergence from the next larger step of the same method.
    order: Option<f64>,
}

impl ScoredFile {
    /// Name of the method; empty if the file does not state it.
    fn method(&self) -> &str {
        self.trajectory.method.as_deref().unwrap_or_default()
    }

    fn end(&self) -> f64 {
        self.trajectory.rows.last().map_or(0.0, |row| row.t)
    }

    /// Step size and greatest error.
    fn point(&self) -> Option<[f64; 2]> {
        self.step.map(|(step, _)| [step, self.score.max_error])
    }
}

/// Integration method with its number of files and its order of convergence.
struct Integrator {
    name: String,
    files: usize,
    order: Option<f64>,
}

pub fn run(arguments: &ScoreArgs) -> Result<Report, Failure> {
    let ScoreArgs { files, benchmark, steps, plot, format } = arguments;
    let inputs: Vec<_> = files.iter().map(|path| Some(&**path)).collect();
    whole_file::require_other("--plot", plot.as_deref(), &inputs)?;
    let problem = benchmark.as_deref().map(problems::named).transpose();
    let problem = problem.map_err(|failure| failure.with_context("--benchmark"))?;
    // command that prints the state from which a run has to start
    let (scenario, start, results) = match (&problem, &files[..]) {
        (Some(problem), results) if !results.is_empty() => {
            let start = format!("toytop benchmark {} --times 0 --format csv", problem.scenario.name);
            (problem.scenario.clone(), start, results)
        }
        (None, [scenario, results @ ..]) if !results.is_empty() => {
            (Scenario::read(scenario)?, format!("toytop state {} --times 0", scenario.display()), results)
        }
        _ => {
            return Err(Failure::Input(
                "score: needs SCENARIO RESULT.csv..., or --benchmark NAME RESULT.csv...".into(),
            ));
        }
    };
    if !steps.is_empty() && steps.len() != results.len() {
        return Err(Failure::Input(format!("--steps: must be {} numbers, one for each file", results.len())));
    }
    let reference = ExactReference::new(&scenario, &start)?;
    let (mut files, mut warnings) = (Vec::new(), Vec::new());
    for (index, path) in results.iter().enumerate() {
        let axis = problem.as_ref().map_or(3, |problem| problem.about.symmetry_axis);
        let trajectory = Trajectory::read(path)?.with_symmetry_axis(axis);
        let score = reference.score(&trajectory)?;
        warnings
            .extend(score.warning.iter().map(|warning| format!("warning: {}: {warning}", trajectory.name)));
        let steps = [
            (steps.get(index).copied(), "option"),
            (trajectory.step, "file"),
            (trajectory.spacing(), "rows"),
        ];
        let step = steps.into_iter().find_map(|(step, source)| Some((step?, source)));
        files.push(ScoredFile { trajectory, score, step, order: None });
    }
    let integrators = integrators(&mut files, &mut warnings);
    if let Some(path) = plot {
        draw(path, &scenario, &files, &integrators)?;
    }
    let records: Vec<_> = files.iter().map(|file| record(file, &integrators)).collect();
    let summary = |Integrator { name, files, order }: &Integrator| json!({ "method": name, "files": files, "order": order });
    let summaries: Vec<_> = integrators.iter().map(summary).collect();
    let order = if let [only] = &integrators[..] { only.order } else { None };
    let document = json!({
        "files": records,
        "methods": summaries,
        "order": order,
        "scenario": scenario.name,
        "sign": "nearest",
    });
    let text = output::render(*format, &document, || tables(&files, &records, &integrators));
    Ok(Report::from(text).with_notes(warnings))
}

/// Methods by their first files. Sets the order of convergence of each file. Files of one method that end at different times get no order
/// of convergence, and a warning states it.
fn integrators(files: &mut [ScoredFile], warnings: &mut Vec<String>) -> Vec<Integrator> {
    let mut names: Vec<String> = Vec::new();
    for file in &*files {
        if !names.iter().any(|name| name == file.method()) {
            names.push(file.method().to_owned());
        }
    }
    let mut integrator = |name: String| {
        let mut files: Vec<_> = files.iter_mut().filter(|file| file.method() == name).collect();
        let count = files.len();
        let first = files[0].end();
        if let Some(other) = files.iter().find(|file| (file.end() - first).abs() > 1e-6 * first.abs()) {
            let names = [&files[0].trajectory.name, &other.trajectory.name];
            warnings.push(format!("warning: no order: {} and {} end at different times", names[0], names[1]));
            return Integrator { name, files: count, order: None };
        }
        files.retain(|file| file.step.is_some());
        let step = |file: &ScoredFile| file.step.map_or(0.0, |(step, _)| step);
        files.sort_by(|a, b| step(b).total_cmp(&step(a)));
        let points: Vec<_> = files.iter().filter_map(|file| file.point()).collect();
        for (file, pair) in files.iter_mut().skip(1).zip(points.windows(2)) {
            file.order = order::between(pair[0], pair[1]);
        }
        Integrator { name, files: count, order: order::fitted(&points) }
    };
    names.into_iter().map(&mut integrator).collect()
}

/// Draws the greatest error against the work for each method. The work is the number of evaluations of the equations if every file states
/// it, otherwise the number of steps.
fn draw(
    path: &Path,
    scenario: &Scenario,
    files: &[ScoredFile],
    integrators: &[Integrator],
) -> Result<(), Failure> {
    let counted = files.iter().all(|file| file.trajectory.evaluations.is_some());
    let period = period_or_natural_time(&scenario.motion);
    let point = |file: &ScoredFile| {
        let steps = file.step.map(|(step, _)| period / step);
        let work = if counted { file.trajectory.evaluations } else { steps }.ok_or_else(|| {
            let needed = "needs a line # evaluations = N in every file, or --steps";
            let name = &file.trajectory.name;
            Failure::Input(format!("--plot: {name}: {needed}, because its rows are uneven"))
        })?;
        Ok([work, file.score.max_error])
    };
    let mut curves = Vec::new();
    for Integrator { name, order, .. } in integrators {
        let order = order.map(|order| format!("measured order {order:.2}"));
        let label: Vec<_> =
            [Some(name.clone()).filter(|name| !name.is_empty()), order].into_iter().flatten().collect();
        let of_method = files.iter().filter(|file| file.method() == name);
        let mut points = of_method.map(point).collect::<Result<Vec<_>, Failure>>()?;
        points.sort_by(|[a, _], [b, _]| a.total_cmp(b));
        curves.push(Curve::marked(label.join(", "), points));
    }
    let work = if counted { "evaluations of the equations" } else { "steps in a nutation period" };
    let chart = Chart {
        title: &format!("Work and precision: {}", scenario.name),
        labels: [work, "greatest error of the orientation, rad"],
        logarithmic: true,
    };
    drawing::write("--plot", path, &chart.draw(&curves), None)
}

fn record(file: &ScoredFile, integrators: &[Integrator]) -> Value {
    let ScoredFile { trajectory, score, step, order } = file;
    let method = integrators.iter().find(|integrator| integrator.name == file.method());
    let phases = &score.phases;
    json!({
        "name": trajectory.name,
        "method": trajectory.method,
        "rows": trajectory.rows.len(),
        "step": step.map(|(step, _)| step),
        "step_from": step.map(|(_, source)| source),
        "evaluations": trajectory.evaluations,
        "max_error_rad": score.max_error,
        "rms_error_rad": score.rms_error,
        "final_error_rad": score.final_error,
        "max_u_error": score.max_u_error,
        "max_position_error": score.max_tip_error,
        "nutation_error_rad": phases.nutation,
        "precession_error_rad": phases.precession,
        "spin_error_rad": phases.spin,
        "residual_rad": phases.residual,
        "drift_h": score.drift.map(|drift| drift.h),
        "drift_l": score.drift.map(|drift| drift.l),
        "drift_n": score.drift.map(|drift| drift.n),
        "max_norm_error": score.norm_error,
        "truth_bound_rad": score.truth_bound,
        "method_order": method.and_then(|method| method.order),
        "order": order,
    })
}

/// Table of the errors, table of the phase errors and drifts, and the orders of convergence.
fn tables(files: &[ScoredFile], records: &[Value], integrators: &[Integrator]) -> String {
    let errors: [Column<'_>; 9] = [
        ("name", "", two_digits),
        ("rows", "rows", two_digits),
        ("step", "step, s", |step| short(step, 4)),
        ("max_error_rad", "max, rad", two_digits),
        ("rms_error_rad", "rms, rad", two_digits),
        ("final_error_rad", "final, rad", two_digits),
        ("max_u_error", "u", two_digits),
        ("max_position_error", "position", two_digits),
        ("order", "order", |order| format!("{order:.2}")),
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
    let bound = files.iter().map(|file| file.score.truth_bound).fold(0.0, f64::max);
    format!(
        "Errors against the exact motion\n{}\nPhase errors over the last nutation period, rad (above 0: ahead), and relative drifts of h, l and n\n{}\n\
         {orders}The exact motion is within {bound:.1e} rad. Errors of the orientation are 2 sqrt(|d alpha|^2 + |d beta|^2) with the nearer\n\
         sign. Residual: what no phase error explains. Order: from the next larger step of the same method. Drifts: of h in units of max(|h|, p g), of l and n in units of\n\
         max(|l|, |n|, sqrt(2 A p g)).\n",
        TextTable::new(records, &errors).aligned(),
        TextTable::new(records, &details).aligned(),
    )
}
