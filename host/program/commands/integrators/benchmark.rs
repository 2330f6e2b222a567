//! `toytop benchmark`: reference values of the problems that other integrators are tested with.

use super::problem_files::{self, Problem, ReferenceSample};
use crate::arguments::times::Times;
use crate::arguments::values::{Values, counted_values};
use crate::terminal::stdout::Report;
use crate::terminal::table::{Column, TextTable};
use clap::Args;
use serde::{Serialize, Serializer};
use serde_json::{Value, json};
use std::iter::once;
use toytop_host::Failure;
use toytop_host::motion::Scalar;
use toytop_host::motion::ephemeris::MotionEphemeris;
use toytop_host::output::{self, Format};

/// Reference values of the heavy tops that integrators are tested with
#[derive(Args)]
#[command(
    after_help = "The values have 30 digits, which two integrations confirm. The conventions are those of the problem's source.\n\n\
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

/// Numbers at one time, by [`COLUMNS`]: texts of 30 digits, or numbers of the ephemeris.
struct BenchmarkRow(Vec<Value>);

impl Serialize for BenchmarkRow {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(COLUMNS.iter().zip(&self.0))
    }
}

/// Problem of the list. The names are the keys of JSON.
#[derive(Serialize)]
struct ListedProblem {
    benchmark: String,
    title: String,
    /// Last time, s.
    seconds: Option<f64>,
    /// Last time with all its digits.
    t: String,
    /// Height of the centre of mass at the last time.
    height: String,
    used_by: String,
}

pub fn run(arguments: &BenchmarkArgs) -> Result<Report, Failure> {
    let BenchmarkArgs { name, times, scenario, format } = arguments;
    let Some(name) = name else { return list_problems(*format) };
    let problem = problem_files::find(name).map_err(|failure| failure.with_context("benchmark"))?;
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
        for BenchmarkRow(numbers) in &rows {
            let named = COLUMNS.into_iter().zip(numbers).skip(1);
            lines.extend(
                named.map(
                    |(quantity, value)| json!({ "t": numbers[0], "quantity": quantity, "value": value }),
                ),
            );
        }
        format!(
            "{}\n{}\n\nThe third fixed axis points up, body axis {} from the tip to the centre of mass. x_com, y_com, z_com: of the\n\
             centre of mass relative to the tip; w, x, y, z: quaternion from body to fixed axes; wx, wy, wz: angular velocity along\n\
             the body axes.\n\n{}",
            about.title,
            about.source,
            about.symmetry_axis,
            TextTable::from_rows(&lines, 8).aligned()
        )
    };
    Ok(output::render(*format, &document, &rows, table).into())
}

/// List of all problems, each with the height of the centre of mass at its last time.
fn list_problems(format: Format) -> Result<Report, Failure> {
    let listed = |Problem { scenario, about, samples, .. }: &Problem| {
        let ReferenceSample { t, position: [_, _, height], .. } = samples.last()?;
        Some(ListedProblem {
            benchmark: scenario.name.clone(),
            title: about.title.clone(),
            seconds: t.parse().ok(),
            t: t.clone(),
            height: height.clone(),
            used_by: about.used_by.join("; "),
        })
    };
    let rows: Vec<_> = problem_files::all().iter().filter_map(listed).collect();
    let table = || {
        let columns: [Column<ListedProblem>; 2] =
            [("", |problem| problem.benchmark.clone()), ("", |problem| problem.title.clone())];
        TextTable::new(2, &columns, &rows).aligned()
            + "\ntoytop benchmark NAME prints 30 digits; --scenario its scenario file; toytop score --benchmark NAME judges a run.\n"
    };
    Ok(output::render(format, &json!({ "problems": rows }), &rows, table).into())
}

/// Values of a sample with 30 digits.
fn reference_row(sample: &ReferenceSample) -> BenchmarkRow {
    let ReferenceSample { t, position, quaternion, omega_body } = sample;
    let texts = once(t).chain(position).chain(quaternion).chain(omega_body);
    BenchmarkRow(texts.map(|text| Value::from(&**text)).collect())
}

/// Values of the ephemeris at any times, with 17 digits.
fn computed_rows(problem: &Problem, times: &Values) -> Result<Vec<BenchmarkRow>, Failure> {
    let Problem { scenario, about, .. } = problem;
    let times = Times::new("--times".to_owned(), times)?;
    let ephemeris = MotionEphemeris::new(&scenario.motion, Scalar::F64)
        .map_err(|failure| failure.with_context(&scenario.name))?;
    times.require_within(ephemeris.furthest_time(), "")?;
    let row = |t: &f64| {
        let sample = ephemeris.at(*t);
        let orientation = sample.pose.orientation.compose(&about.body_axes());
        let position = sample.pose.orientation.axis().map(|x| about.length * x);
        let omega_body = orientation.inverse().adjoint(sample.rates.omega);
        let numbers = once(*t).chain(position).chain(orientation.quaternion()).chain(omega_body);
        BenchmarkRow(numbers.map(Value::from).collect())
    };
    Ok(times.seconds.iter().map(row).collect())
}
