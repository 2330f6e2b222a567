//! `toytop benchmark`: reference values of the problems that other integrators are tested with.

use super::Report;
use super::times::Times;
use crate::Failure;
use crate::motion::Scalar;
use crate::motion::ephemeris::{furthest_time, smallest_ephemeris};
use crate::output::doc_markers::{self, Page};
use crate::output::{self, Format, Lists, Record};
use crate::score::benchmarks::{self, Printed, Problem, Reference};
use clap::Args;
use serde_json::Value;
use std::path::PathBuf;

/// `toytop benchmark`
#[derive(Args)]
pub struct BenchmarkArgs {
    /// Name of a problem; without it, all problems are listed
    name: Option<String>,
    /// Times, s, in place of the source's, with 17 digits in place of 30: T1,T2,... or LOW..HIGH/PLACES
    #[arg(long, value_name = "T1,T2,...", allow_hyphen_values = true, requires = "name")]
    times: Option<String>,
    /// Print the scenario file of the problem
    #[arg(long, requires = "name", conflicts_with_all = ["times", "format", "accept"])]
    scenario: bool,
    /// Page whose tables are rewritten: the page of the problem, or without NAME that of the catalogue
    #[arg(long, value_name = "FILE", conflicts_with_all = ["times", "format"])]
    accept: Option<PathBuf>,
    /// Form of the output
    #[arg(long, default_value = "table")]
    format: Format,
}

pub fn run(arguments: &BenchmarkArgs) -> Result<Report, Failure> {
    let BenchmarkArgs { name, times, scenario, accept, format } = arguments;
    let problem = name.as_deref().map(benchmarks::named).transpose();
    let problem = problem.map_err(|failure| failure.of("benchmark"))?;
    if let Some(page) = accept {
        let page =
            Page::read(page, &format!("toytop benchmark: {}", name.as_deref().unwrap_or("catalogue")))?;
        page.write(&match &problem {
            Some(problem) => {
                tables(problem, &references(problem), true, "<br>", |rows| doc_markers::table(&rows))
            }
            None => catalogue(),
        })?;
        return Ok(Report::default());
    }
    let Some(problem) = problem else {
        let summaries: Vec<_> = benchmarks::all().iter().map(summary).collect();
        let table = || {
            let line = |problem: &Problem| vec![problem.name().to_owned(), problem.about.title.clone()];
            output::columns(benchmarks::all().iter().map(line).collect(), 2)
                + "\ntoytop benchmark NAME prints 30 digits; --scenario its scenario file; toytop score --benchmark NAME judges a run.\n"
        };
        return Ok(output::render(*format, &output::list("problems", &summaries), table).into());
    };
    if *scenario {
        return Ok(problem.text.to_owned().into());
    }
    let records = match times {
        Some(times) => computed(&problem, times)?,
        None => references(&problem),
    };
    let about = &problem.about;
    let rest = Record::default()
        .with("benchmark", problem.name())
        .with("source", &*about.source)
        .with("symmetry_axis", about.symmetry_axis);
    let table = || {
        let tables = tables(&problem, &records, times.is_none(), "\n", |rows| output::columns(rows, 3));
        format!(
            "{}\n{}\n\nThe third fixed axis points up, body axis {} from the tip to the centre of mass. position: of the centre of mass\n\
             relative to the tip; quaternion w, x, y, z: from body to fixed axes; omega_body: along the body axes.\n\n{tables}",
            about.title, about.source, about.symmetry_axis
        )
    };
    Ok(output::render(*format, &Lists(vec![("samples", &records)], rest), table).into())
}

/// Names of the columns of a time. `toytop score` reads the time, the orientation and the rates by these names.
const COLUMNS: [&str; 11] = ["t", "x_com", "y_com", "z_com", "w", "x", "y", "z", "wx", "wy", "wz"];

fn record(t: Value, values: impl IntoIterator<Item = Value>) -> Record {
    Record(COLUMNS.into_iter().zip(std::iter::once(t).chain(values)).collect())
}

/// Reference values at the source's times, with 30 digits.
fn references(problem: &Problem) -> Vec<Record> {
    let digits = |Reference { t, position, quaternion, omega_body }: &Reference| {
        let values = position.iter().chain(quaternion).chain(omega_body);
        record(t.as_str().into(), values.map(|digits| digits.as_str().into()))
    };
    problem.references.iter().map(digits).collect()
}

/// Values of the ephemeris at any times, with 17 digits.
fn computed(problem: &Problem, times: &str) -> Result<Vec<Record>, Failure> {
    let motion = &problem.scenario.motion;
    let times = Times::parse(times)?;
    times.require_within(furthest_time(motion), "")?;
    let table = smallest_ephemeris(Scalar::F64, motion).map_err(|failure| failure.of(problem.name()))?;
    let values = |t: &f64| problem.values(&table.at(*t).sample).into_iter().map(Value::from);
    Ok(times.seconds.iter().map(|t| record((*t).into(), values(t))).collect())
}

fn words<const N: usize>(words: [&str; N]) -> Vec<String> {
    words.map(str::to_owned).into()
}

/// Table of the quantities of each record, and, with `others`, one of the values that others printed with their errors; `line`
/// separates the numbers of a quantity.
fn tables(
    problem: &Problem,
    records: &[Record],
    others: bool,
    line: &str,
    table: fn(Vec<Vec<String>>) -> String,
) -> String {
    let mut rows = vec![words(["t", "quantity", "value"])];
    for record in records {
        let numbers: Vec<_> =
            record.0.iter().filter_map(|(_, value)| output::text(value, output::number)).collect();
        for (name, range) in [("position", 1..4), ("quaternion", 4..8), ("omega_body", 8..11)] {
            rows.push(words([&numbers[0], name, &numbers[range].join(line)]));
        }
    }
    let text = table(rows);
    if !others || problem.about.printed.is_empty() {
        return text;
    }
    let mut rows = vec![words(["printed by", "t", "quantity", "printed", "off by"])];
    for printed in &problem.about.printed {
        let values: Vec<_> = printed.values.iter().map(f64::to_string).collect();
        let Printed { by, t, quantity, .. } = printed;
        rows.push(words([by, t, quantity, &values.join(line), &off(problem, printed)]));
    }
    text + "\n" + &table(rows)
}

fn off(problem: &Problem, printed: &Printed) -> String {
    problem.off(printed).map_or("-".to_owned(), output::two_digits)
}

/// Time and height of the centre of mass at the last of the source's times.
fn last(problem: &Problem) -> [&str; 2] {
    problem.references.last().map_or([""; 2], |Reference { t, position: [.., height], .. }| [t, height])
}

fn summary(problem: &Problem) -> Record {
    let [t, height] = last(problem);
    Record::default()
        .with("benchmark", problem.name())
        .with("title", &*problem.about.title)
        .with("seconds", problem.about.seconds)
        .with("t", t)
        .with("height", height)
        .with("used_by", problem.about.used_by.join("; "))
}

/// Table of the page: problem, reference value, what others printed, who used it.
fn catalogue() -> String {
    let mut rows = vec![words([
        "problem",
        "height of the centre of mass above the tip",
        "printed elsewhere: off by",
        "used by",
    ])];
    for problem in &benchmarks::all() {
        let ([t, height], name, about) = (last(problem), problem.name(), &problem.about);
        let one = |printed: &Printed| {
            let Printed { by, t, quantity, .. } = printed;
            format!("{by}, {quantity} at {t}: {}", off(problem, printed))
        };
        let printed = about.printed.iter().map(one).collect::<Vec<_>>().join("<br>");
        rows.push(words([
            &format!("[{}]({name}/README.md), `{name}`", about.title),
            &format!("{height} at t = {t}"),
            if printed.is_empty() { "no value" } else { &printed },
            &about.used_by.join("; "),
        ]));
    }
    doc_markers::table(&rows)
}
