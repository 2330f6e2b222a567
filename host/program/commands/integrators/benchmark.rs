//! `toytop benchmark`: reference values of the problems that other integrators are tested with.

use super::problem_files::{self, Problem, ReferenceSample};
use crate::arguments::times::Times;
use crate::arguments::values::{Values, counted_values};
use crate::terminal::report::Report;
use crate::terminal::table::TextTable;
use clap::Args;
use serde_json::{Value, json};
use std::iter::once;
use toytop_host::Failure;
use toytop_host::motion::evaluator::MotionEvaluator;
use toytop_host::output::{self, Format};

/// Reference values of the tops that integrators are tested with
#[derive(Args)]
#[command(
    after_help = "The values have 30 digits, which a second computation confirms. The conventions are those of the problem's source.\n\n\
        Example: toytop benchmark bruls_cardona --format json\n         \
        toytop benchmark bruls_cardona --times 0..2/2001 --format csv > run.csv && toytop score --benchmark bruls_cardona run.csv"
)]
pub struct BenchmarkArgs {
    /// Name of a problem; without it, all problems are listed
    name: Option<String>,
    /// Times in place of the source's, s: T1,T2,... or LOW..HIGH/COUNT; the values then have 17 digits
    #[arg(long, value_name = "T1,T2,...", value_parser = counted_values, allow_hyphen_values = true, requires = "name")]
    times: Option<Values>,
    /// Print the scenario file of the problem
    #[arg(long, requires = "name", conflicts_with_all = ["times", "format"])]
    scenario: bool,
    /// Form of the output
    #[arg(long, default_value = "table")]
    format: Format,
}

/// Names of the columns. `toytop score` reads the time, the orientation and the rates by these names.
const COLUMNS: [&str; 11] = ["t", "x_com", "y_com", "z_com", "w", "x", "y", "z", "wx", "wy", "wz"];

/// Values at one time by [`COLUMNS`]: texts of 30 digits, or numbers of the table.
fn row<T: Into<Value>>(values: impl Iterator<Item = T>) -> Value {
    COLUMNS.into_iter().zip(values.map(T::into)).collect()
}

pub fn run(arguments: &BenchmarkArgs) -> Result<Report, Failure> {
    let BenchmarkArgs { name, times, scenario, format } = arguments;
    let Some(name) = name else { return list_problems(*format) };
    let problem = problem_files::find(name).map_err(|failure| failure.at("benchmark"))?;
    if *scenario {
        return Ok(problem.text.to_owned().into());
    }
    let rows = match times {
        Some(times) => computed_rows(&problem, times)?,
        None => problem.samples.iter().map(reference_row).collect(),
    };
    let about = &problem.about;
    let document = json!({
        "samples": rows,
        "benchmark": name,
        "source": about.source,
        "symmetry_axis": about.symmetry_axis,
    });
    let table = || {
        let mut lines = Vec::new();
        for row in &rows {
            let line = |name| json!({ "t": row["t"], "quantity": name, "value": row[name] });
            lines.extend(COLUMNS.into_iter().skip(1).map(line));
        }
        format!(
            "{}\n{}\n\nThe third fixed axis points up, body axis {} from the tip to the centre of mass. x_com, y_com, z_com: of the\n\
             centre of mass relative to the tip; w, x, y, z: quaternion from body to fixed axes; wx, wy, wz: angular velocity along\n\
             the body axes.\n\n{}",
            about.title,
            about.source,
            about.symmetry_axis,
            TextTable::of_fields(&lines, 8).aligned()
        )
    };
    Ok(output::render(*format, &document, &rows, table).into())
}

/// List of all problems, each with the height of the centre of mass at its last time.
fn list_problems(format: Format) -> Result<Report, Failure> {
    let problems = problem_files::all();
    let listed = |Problem { scenario, about, samples, .. }: &Problem| {
        let ReferenceSample { t, position: [_, _, height], .. } = samples.last()?;
        Some(json!({
            "benchmark": scenario.name,
            "title": about.title,
            "seconds": t.parse::<f64>().ok(),
            "t": t,
            "height": height,
            "used_by": about.used_by.join("; "),
        }))
    };
    let rows: Vec<_> = problems.iter().filter_map(listed).collect();
    let table = || {
        let line = |problem: &Problem| [problem.scenario.name.clone(), problem.about.title.clone()];
        TextTable::new(2, [""; 2], problems.iter().map(line)).aligned()
            + "\ntoytop benchmark NAME prints 30 digits; --scenario its scenario file; toytop score --benchmark NAME judges a run.\n"
    };
    Ok(output::render(format, &json!({ "problems": rows }), &rows, table).into())
}

/// Values of a sample with 30 digits.
fn reference_row(sample: &ReferenceSample) -> Value {
    let ReferenceSample { t, position, quaternion, omega_body } = sample;
    row(once(t).chain(position).chain(quaternion).chain(omega_body).map(String::as_str))
}

/// Values of the table at any times, with 17 digits.
fn computed_rows(problem: &Problem, times: &Values) -> Result<Vec<Value>, Failure> {
    let Problem { scenario, about, .. } = problem;
    let times = Times::new("--times".to_owned(), times)?;
    let evaluator = MotionEvaluator::of_scenario(scenario)?;
    times.require_within(evaluator.furthest_time(), "")?;
    let computed = |t: &f64| {
        let sample = evaluator.at(*t);
        let orientation = sample.orientation.compose(&about.body_axes());
        let position = sample.orientation.axis().map(|x| about.length * x);
        let omega_body = orientation.inverse().adjoint(sample.rates.omega);
        row(once(*t).chain(position).chain(orientation.quaternion()).chain(omega_body))
    };
    Ok(times.seconds.iter().map(computed).collect())
}
