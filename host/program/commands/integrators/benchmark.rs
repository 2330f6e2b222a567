//! `toytop benchmark`: reference values of the problems that other integrators are tested with.

use super::problems::{self, Problem};
use clap::Args;
use serde_json::{Value, json};
use toytop_host::input::times::Times;
use toytop_host::motion::Scalar;
use toytop_host::motion::ephemeris::smallest_ephemeris;
use toytop_host::output::table::TextTable;
use toytop_host::output::{self, Format, eight_digits};
use toytop_host::score::trajectory::to_symmetry_axis;
use toytop_host::{Failure, Report};

/// Reference values of the heavy tops that integrators are tested with
#[derive(Args)]
#[command(
    after_help = "The values have 30 digits, and two integrations confirm each of them. The conventions are those of the problem's source.\n\n\
        Example: toytop benchmark bruls_cardona --format json\n         \
        toytop benchmark bruls_cardona --times 0..2/2001 --format csv > run.csv && toytop score --benchmark bruls_cardona run.csv"
)]
pub struct BenchmarkArgs {
    /// Name of a problem; without it, all problems are listed
    name: Option<String>,
    /// Times, s, in place of the source's, with 17 digits in place of 30: T1,T2,... or LOW..HIGH/COUNT
    #[arg(long, value_name = "T1,T2,...", allow_hyphen_values = true, requires = "name")]
    times: Option<String>,
    /// Print the scenario file of the problem
    #[arg(long, requires = "name", conflicts_with_all = ["times", "format"])]
    scenario: bool,
    /// Form of the output
    #[arg(long, default_value = "table")]
    format: Format,
}

/// Names of the columns. `toytop score` reads the time, the orientation and the rates by these names.
const COLUMNS: [&str; 11] = ["t", "x_com", "y_com", "z_com", "w", "x", "y", "z", "wx", "wy", "wz"];

pub fn run(arguments: &BenchmarkArgs) -> Result<Report, Failure> {
    let BenchmarkArgs { name, times, scenario, format } = arguments;
    let Some(name) = name else { return list_problems(*format) };
    let problem = problems::find(name).map_err(|failure| failure.with_context("benchmark"))?;
    if *scenario {
        return Ok(problem.text.to_owned().into());
    }
    let rows = match times {
        Some(times) => computed_rows(&problem, times)?,
        None => problem.samples.iter().map(reference_row).collect(),
    };
    let record = |row: &Vec<Value>| COLUMNS.into_iter().zip(row.iter().cloned()).collect::<Value>();
    let records: Vec<_> = rows.iter().map(record).collect();
    let about = &problem.about;
    let document = json!({
        "samples": records,
        "benchmark": name,
        "source": about.source,
        "symmetry_axis": about.symmetry_axis,
    });
    let table = || {
        let line = |row: &Vec<Value>, (name, value): (&str, &Value)| json!({ "t": row[0], "quantity": name, "value": value });
        let lines_of = |row| COLUMNS.into_iter().zip(row).skip(1).map(move |value| line(row, value));
        let lines: Vec<_> = rows.iter().flat_map(lines_of).collect();
        format!(
            "{}\n{}\n\nThe third fixed axis points up, body axis {} from the tip to the centre of mass. x_com, y_com, z_com: of the\n\
             centre of mass relative to the tip; w, x, y, z: quaternion from body to fixed axes; wx, wy, wz: angular velocity along\n\
             the body axes.\n\n{}",
            about.title,
            about.source,
            about.symmetry_axis,
            TextTable::of_all(&lines, eight_digits).aligned()
        )
    };
    Ok(output::render(*format, &document, table).into())
}

/// List of all problems, each with the height of the centre of mass at its last time.
fn list_problems(format: Format) -> Result<Report, Failure> {
    let summary = |Problem { scenario, about, samples, .. }: &Problem| {
        let last = samples.last().unwrap_or(&Value::Null);
        let seconds = last["t"].as_str().and_then(|t| t.parse::<f64>().ok());
        json!({
            "benchmark": scenario.name,
            "title": about.title,
            "seconds": seconds,
            "t": last["t"],
            "height": last["position"][2],
            "used_by": about.used_by.join("; "),
        })
    };
    let problems: Vec<_> = problems::all().iter().map(summary).collect();
    let table = || {
        TextTable::new(&problems, &[("benchmark", "", eight_digits), ("title", "", eight_digits)]).aligned()
            + "\ntoytop benchmark NAME prints 30 digits; --scenario its scenario file; toytop score --benchmark NAME judges a run.\n"
    };
    Ok(output::render(format, &json!({ "problems": problems }), table).into())
}

/// Values of a sample with 30 digits, by [`COLUMNS`].
fn reference_row(sample: &Value) -> Vec<Value> {
    let lists = ["position", "quaternion", "omega_body"].map(|key| sample[key].as_array().cloned());
    std::iter::once(sample["t"].clone()).chain(lists.into_iter().flatten().flatten()).collect()
}

/// Values of the ephemeris at any times, with 17 digits, by [`COLUMNS`].
fn computed_rows(problem: &Problem, times: &str) -> Result<Vec<Vec<Value>>, Failure> {
    let Problem { scenario, about, .. } = problem;
    let times = Times::parse(times)?;
    let table = smallest_ephemeris(Scalar::F64, &scenario.motion)
        .map_err(|failure| failure.with_context(&scenario.name))?;
    times.require_within(table.furthest_time(), "")?;
    let values = |t: &f64| {
        let sample = table.at(*t);
        let orientation = sample.pose.orientation.compose(&to_symmetry_axis(about.symmetry_axis));
        let position = sample.pose.orientation.axis().map(|x| about.length * x);
        let omega = orientation.inverse().adjoint(sample.rates.omega);
        let numbers = [&[*t][..], &position, &orientation.quaternion(), &omega].concat();
        numbers.into_iter().map(Value::from).collect()
    };
    Ok(times.seconds.iter().map(values).collect())
}
