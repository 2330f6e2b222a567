//! `toytop score`: output of an integrator, compared with the exact motion.

use super::problem_files;
use crate::arguments::options::{PICTURE, ending_in};
use crate::arguments::values::{POSITIVE, number};
use crate::drawing::{
    self,
    chart::{Chart, Curve},
};
use crate::files::whole_file;
use crate::terminal::report::Report;
use crate::terminal::table::TextTable;
use clap::Args;
use serde::Serialize;
use serde_json::json;
use std::iter::once;
use std::path::{Path, PathBuf};
use toytop::Orientation;
use toytop_host::Failure;
use toytop_host::input::scenario::Scenario;
use toytop_host::integrators::order;
use toytop_host::integrators::scorer::{Score, Scorer};
use toytop_host::integrators::trajectory::Trajectory;
use toytop_host::output::{self, Format, error_text, or_dash, significant};

/// Errors of your integrator's output against the exact motion
#[derive(Args)]
#[command(
    after_help = "RESULT.csv has a header, a row for each time, and these columns; others are ignored:\n  \
        t                                       time, s\n  \
        w,x,y,z                                 unit quaternion from body to fixed coordinates; q and -q are the same\n   \
        or alpha_re,alpha_im,beta_re,beta_im   Cayley-Klein parameters\n   \
        or r11,r12,...,r33                     matrix from body to fixed coordinates, by rows\n  \
        omega_body_x,omega_body_y,omega_body_z  for the drifts of h, l and n: rad/s in the body frame (also wx,wy,wz)\n   \
        or omega_x,omega_y,omega_z             in the fixed frame\n  \
        tip_x,tip_y                             position of the tip, m\n\
        Lines above the header may state # method = RK4, # step = 0.001, # evaluations = 40000.\n\
        Files of one method with different steps give its order of convergence.\n\n\
        Example: toytop score host/scenarios/toy_top.toml rk4_*.csv --plot rk4.svg\n         \
        toytop state TOP.toml --times 0..1/1001 --method stepper --format csv > s.csv && toytop score TOP.toml s.csv"
)]
pub struct ScoreArgs {
    /// Scenario file, then the output of integrators: one CSV file for each method and step size
    #[arg(value_names = ["SCENARIO", "RESULT.csv"], num_args = 0..)]
    files: Vec<PathBuf>,
    /// Problem of toytop benchmark in place of the scenario; the files are in the conventions of its source
    #[arg(long, value_name = "NAME")]
    benchmark: Option<String>,
    /// Step size of each file, s; by default the one that the file states, or the spacing of its rows
    #[arg(long, value_name = "H1,H2,...", value_delimiter = ',', allow_hyphen_values = true, value_parser = number(POSITIVE))]
    steps: Vec<f64>,
    /// Picture of the greatest error against the work, whose name ends in .svg or .png
    #[arg(long, value_name = "FILE", value_parser = ending_in(PICTURE))]
    plot: Option<PathBuf>,
    /// Form of the output
    #[arg(long, default_value = "table")]
    format: Format,
}

/// File with its errors. The names are the keys of JSON.
#[derive(Serialize)]
struct ScoredFile {
    name: String,
    method: Option<String>,
    /// Number of rows.
    rows: usize,
    /// Step size, s.
    step: Option<f64>,
    /// Source of the step size.
    step_from: Option<&'static str>,
    /// Evaluations of the equations.
    evaluations: Option<f64>,
    #[serde(flatten)]
    score: Score,
    /// Order of convergence of its method.
    method_order: Option<f64>,
    /// Order of convergence from the next larger step of the same method.
    order: Option<f64>,
    /// Time of the last row, s.
    #[serde(skip)]
    end: f64,
}

impl ScoredFile {
    /// Name of the method; empty if the file does not state it.
    fn method(&self) -> &str {
        self.method.as_deref().unwrap_or_default()
    }
}

/// Files of one integration method. The names are the keys of JSON.
#[derive(Serialize)]
struct MethodSummary {
    method: String,
    /// Number of its files.
    files: usize,
    /// Order of convergence.
    order: Option<f64>,
}

pub fn run(arguments: &ScoreArgs) -> Result<Report, Failure> {
    let ScoreArgs { files, benchmark, steps, plot, format } = arguments;
    let inputs: Vec<_> = files.iter().map(|path| Some(&**path)).collect();
    whole_file::require_other("--plot", plot.as_deref(), &inputs)?;
    let problem = benchmark.as_deref().map(problem_files::find).transpose();
    let problem = problem.map_err(|failure| failure.at("--benchmark"))?;
    // command that prints the state from which a run has to start
    let (scenario, start_command, results) = match (&problem, &files[..]) {
        (Some(problem), results) if !results.is_empty() => {
            let start_command = format!("toytop benchmark {} --times 0 --format csv", problem.scenario.name);
            (problem.scenario.clone(), start_command, results)
        }
        (None, [scenario, results @ ..]) if !results.is_empty() => {
            (Scenario::read(scenario)?, format!("toytop state {} --times 0", scenario.display()), results)
        }
        _ => {
            return Err(Failure::input(
                "score: needs SCENARIO RESULT.csv..., or --benchmark NAME RESULT.csv...",
            ));
        }
    };
    if !steps.is_empty() && steps.len() != results.len() {
        return Err(Failure::input(format!(
            "--steps: needs one number for each file, {} in all",
            results.len()
        )));
    }
    let scorer =
        Scorer::new(&scenario.motion, &start_command).map_err(|failure| failure.at(&scenario.name))?;
    let axes = problem.as_ref().map_or(Orientation::IDENTITY, |problem| problem.about.body_axes());
    let (mut files, mut warnings) = (Vec::new(), Vec::new());
    for (index, path) in results.iter().enumerate() {
        let trajectory = Trajectory::read(path)?.in_axes_of_core(&axes);
        let score = scorer.score(&trajectory)?;
        let spacing = trajectory.spacing();
        let Trajectory { name, method, step, evaluations, rows } = trajectory;
        warnings.extend(score.warning.iter().map(|warning| format!("warning: {name}: {warning}")));
        let given = [(steps.get(index).copied(), "option"), (step, "file"), (spacing, "rows")];
        let (step, step_from) = given.into_iter().find_map(|(step, source)| Some((step?, source))).unzip();
        let end = rows.last().map_or(0.0, |row| row.t);
        files.push(ScoredFile {
            name,
            method,
            rows: rows.len(),
            step,
            step_from,
            evaluations,
            score,
            method_order: None,
            order: None,
            end,
        });
    }
    let methods = measure_orders(&mut files, &mut warnings);
    if let Some(path) = plot {
        draw(path, &scenario, &files, &methods)?;
    }
    let order = if let [only] = &methods[..] { only.order } else { None };
    let document = json!({
        "files": files,
        "methods": methods,
        "order": order,
        "scenario": scenario.name,
        "sign": "nearest",
    });
    let text = output::render(*format, &document, &files, || tables(&files, &methods));
    Ok(Report::from(text).with_notes(warnings))
}

/// Methods by their first files. Sets the orders of convergence of each file. Files of one method that end at different times get no order
/// of convergence, and a warning states it.
fn measure_orders(files: &mut [ScoredFile], warnings: &mut Vec<String>) -> Vec<MethodSummary> {
    let mut names: Vec<String> = Vec::new();
    for file in &*files {
        if !names.iter().any(|name| name == file.method()) {
            names.push(file.method().to_owned());
        }
    }
    let summary = |method: String| {
        let mut files: Vec<_> = files.iter_mut().filter(|file| file.method() == method).collect();
        let count = files.len();
        let first = files[0].end;
        if let Some(other) = files.iter().find(|file| (file.end - first).abs() > 1e-6 * first.abs()) {
            let both = format!("{} and {}", files[0].name, other.name);
            warnings.push(format!("warning: no order: {both} end at different times"));
            return MethodSummary { method, files: count, order: None };
        }
        // files without a step come last
        files.sort_by(|a, b| b.step.unwrap_or(0.0).total_cmp(&a.step.unwrap_or(0.0)));
        let points: Vec<_> =
            files.iter().filter_map(|file| Some([file.step?, file.score.max_error_rad])).collect();
        let order = order::fitted(&points);
        files.iter_mut().for_each(|file| file.method_order = order);
        for (file, pair) in files.iter_mut().skip(1).zip(points.windows(2)) {
            file.order = order::between(pair[0], pair[1]);
        }
        MethodSummary { method, files: count, order }
    };
    names.into_iter().map(summary).collect()
}

/// Draws the greatest error against the work for each method. The work is the number of evaluations of the equations if every file states
/// it, otherwise the number of steps.
fn draw(
    path: &Path,
    scenario: &Scenario,
    files: &[ScoredFile],
    methods: &[MethodSummary],
) -> Result<(), Failure> {
    let counted = files.iter().all(|file| file.evaluations.is_some());
    let period = scenario.motion.characteristic_time();
    let point = |file: &ScoredFile| {
        let steps = file.step.map(|step| period / step);
        let work = if counted { file.evaluations } else { steps }.ok_or_else(|| {
            let needed = "needs a line # evaluations = N in every file, or --steps";
            Failure::input(format!("{needed}, because its rows are uneven")).at(&file.name).at("--plot")
        })?;
        Ok([work, file.score.max_error_rad])
    };
    let mut curves = Vec::new();
    for MethodSummary { method, order, .. } in methods {
        let order = order.map(|order| format!("measured order {order:.2}"));
        let label: Vec<_> =
            [Some(method.clone()).filter(|name| !name.is_empty()), order].into_iter().flatten().collect();
        let of_method = files.iter().filter(|file| file.method() == method);
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

/// Table of the errors, table of the phase errors and drifts, and the orders of convergence.
fn tables(files: &[ScoredFile], methods: &[MethodSummary]) -> String {
    let errors = |file: &ScoredFile| {
        let ScoredFile { name, rows, step, score, order, .. } = file;
        [
            name.clone(),
            rows.to_string(),
            or_dash(*step, |step| significant(step, 4)),
            error_text(score.max_error_rad),
            error_text(score.rms_error_rad),
            error_text(score.final_error_rad),
            error_text(score.max_u_error),
            or_dash(score.max_tip_error, error_text),
            or_dash(*order, |order| format!("{order:.2}")),
        ]
    };
    let errors = TextTable::new(
        1,
        ["", "rows", "step, s", "max, rad", "rms, rad", "final, rad", "u", "tip", "order"],
        files.iter().map(errors),
    );
    let details = |ScoredFile { name, score, .. }: &ScoredFile| {
        let phases = &score.phases;
        let [nutation, precession] = [phases.nutation_error_rad, phases.precession_error_rad];
        let numbers = [nutation, precession, phases.spin_error_rad, phases.residual_rad];
        let drifts = [score.drift_h, score.drift_l, score.drift_n];
        once(name.clone()).chain(numbers.into_iter().chain(drifts).map(|x| or_dash(x, error_text)))
    };
    let details = TextTable::new(
        1,
        ["", "nutation", "precession", "spin", "residual", "h", "l", "n"],
        files.iter().map(details),
    );
    let mut orders = String::new();
    for MethodSummary { method, order, .. } in methods {
        let of_method = if method.is_empty() { String::new() } else { format!(" of {method}") };
        orders.extend(order.map(|order| format!("Order of convergence{of_method}: {order:.2}\n")));
    }
    let bound = files.iter().map(|file| file.score.truth_bound_rad).fold(0.0, f64::max);
    format!(
        "Errors against the exact motion\n{}\nPhase errors over the last nutation period, rad (above 0: ahead), and relative drifts of h, l and n\n{}\n\
         {orders}The exact motion is within {bound:.1e} rad. Errors of the orientation are 2 sqrt(|d alpha|^2 + |d beta|^2) with the nearer\n\
         sign. Residual: what no phase error explains. Order: from the next larger step of the same method. Drifts: of h in units of max(|h|, p g), of l and n in units of\n\
         max(|l|, |n|, sqrt(2 A p g)).\n",
        errors.aligned(),
        details.aligned(),
    )
}
