//! `toytop benchmark`: reference values of the problems that other integrators are tested with.

use super::Report;
use super::times::Instants;
use crate::Failure;
use crate::benchmarks::{self, Printed, Problem};
use crate::motion::Scalar;
use crate::motion::ephemeris::{furthest_time, smallest};
use crate::output::doc_markers::{self, Page};
use crate::output::{self, Format, Lists, Record, eight};
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
    let name = arguments.name.as_deref();
    let problem = name.map(benchmarks::named).transpose().map_err(|failure| failure.of("benchmark"))?;
    if let Some(problem) = problem.as_ref().filter(|_| arguments.scenario) {
        return Ok(problem.text.to_owned().into());
    }
    if let Some(page) = &arguments.accept {
        let page = Page::read(page, &format!("toytop benchmark: {}", name.unwrap_or("catalogue")))?;
        page.write(&match &problem {
            Some(problem) => tables(problem, &references(problem), "<br>", |rows| doc_markers::table(&rows)),
            None => catalogue(&benchmarks::all()?),
        })?;
        return Ok(Report::default());
    }
    let Some(problem) = problem else {
        let summaries: Vec<_> = benchmarks::all()?.iter().map(summary).collect();
        let table = || {
            output::aligned(&summaries, &[("benchmark", "", eight), ("title", "", eight)])
                + "\ntoytop benchmark NAME prints 30 digits; --scenario its scenario file; toytop score --benchmark NAME judges a run.\n"
        };
        let object = output::list("problems", &summaries);
        return Ok(output::render(arguments.format, &object, table)?.into());
    };
    let records = match &arguments.times {
        Some(times) => computed(&problem, times)?,
        None => references(&problem),
    };
    let rest = Record::default()
        .with("benchmark", problem.name())
        .with("source", &*problem.source)
        .with("symmetry_axis", problem.conventions.symmetry_axis as u64);
    let object = Lists(vec![("samples", &records)], rest);
    let table = || heading(&problem) + &tables(&problem, &records, "\n", |rows| output::columns(rows, 3));
    Ok(output::render(arguments.format, &object, table)?.into())
}

/// Values at the times of records and, at the times of the source, the published values; `line` separates the numbers of a quantity.
fn tables(
    problem: &Problem,
    records: &[Record],
    line: &str,
    table: fn(Vec<Vec<String>>) -> String,
) -> String {
    let text = table(values(records, line));
    let of_source = records.iter().all(|Record(cells)| cells[0].1.is_string());
    if !of_source || problem.printed.is_empty() {
        return text;
    }
    text + "\n" + &table(printed(problem, line))
}

/// Names of the columns of a time. `toytop score` reads the time, the orientation and the rates by these names.
const COLUMNS: [&str; 11] = ["t", "x_com", "y_com", "z_com", "w", "x", "y", "z", "wx", "wy", "wz"];

fn record(cells: impl Iterator<Item = Value>) -> Record {
    Record(COLUMNS.into_iter().zip(cells).collect())
}

/// Reference values at the source's times, with 30 digits.
fn references(problem: &Problem) -> Vec<Record> {
    let of = |reference: &benchmarks::Reference| {
        let values = [&reference.position[..], &reference.quaternion, &reference.omega_body].concat();
        record(std::iter::once(&reference.t).chain(&values).map(|text| Value::from(text.as_str())))
    };
    problem.references.iter().map(of).collect()
}

/// Values of the ephemeris at any times, with 17 digits.
fn computed(problem: &Problem, times: &str) -> Result<Vec<Record>, Failure> {
    let motion = &problem.scenario.motion;
    let instants = Instants::parse(times)?;
    instants.require_within(furthest_time(motion), "")?;
    let table = smallest(Scalar::F64, motion).map_err(|failure| failure.of(problem.name()))?;
    let of = |t: &f64| {
        let values = problem.conventions.values(&table.at(*t).sample);
        record(std::iter::once(*t).chain(values).map(Value::from))
    };
    Ok(instants.times()?.iter().map(of).collect())
}

fn heading(problem: &Problem) -> String {
    let axis = problem.conventions.symmetry_axis;
    format!(
        "{}\n{}\n\nThe third fixed axis points up, body axis {axis} from the tip to the centre of mass. position: of the centre of mass\n\
         relative to the tip; quaternion w, x, y, z: from body to fixed axes; omega_body: along the body axes.\n\n",
        problem.title, problem.source
    )
}

fn words<const N: usize>(words: [&str; N]) -> Vec<String> {
    words.map(str::to_owned).to_vec()
}

/// Rows of a table with the quantities of each time; `line` is between the numbers of one quantity.
fn values(records: &[Record], line: &str) -> Vec<Vec<String>> {
    let mut rows = vec![words(["t", "quantity", "value"])];
    for record in records {
        let numbers: Vec<_> = output::flat(record).into_iter().map(|(_, number)| number).collect();
        for (name, range) in [("position", 1..4), ("quaternion", 4..8), ("omega_body", 8..11)] {
            rows.push(words([&numbers[0], name, &numbers[range].join(line)]));
        }
    }
    rows
}

/// Rows of a table with the values that others printed, and their errors.
fn printed(problem: &Problem, line: &str) -> Vec<Vec<String>> {
    let row = |printed: &Printed| {
        let values: Vec<_> = printed.values.iter().map(f64::to_string).collect();
        let (quantity, off) = (&printed.quantity, off(problem, printed));
        words([&printed.by, &printed.t, quantity, &values.join(line), &off])
    };
    let header = words(["printed by", "t", "quantity", "printed", "off by"]);
    std::iter::once(header).chain(problem.printed.iter().map(row)).collect()
}

fn off(problem: &Problem, printed: &Printed) -> String {
    problem.off(printed).map_or("-".to_owned(), output::error)
}

/// Time and height of the centre of mass at the last of the source's times.
fn last(problem: &Problem) -> [String; 2] {
    problem.references.last().map_or([String::new(), String::new()], |reference| {
        [reference.t.clone(), reference.position.last().cloned().unwrap_or_default()]
    })
}

fn summary(problem: &Problem) -> Record {
    let [t, height] = last(problem);
    Record::default()
        .with("benchmark", problem.name())
        .with("title", &*problem.title)
        .with("seconds", problem.seconds)
        .with("t", &*t)
        .with("height", &*height)
        .with("used_by", &*problem.used_by.join("; "))
}

/// Table of the page: problem, reference value, what others printed, who used it.
fn catalogue(problems: &[Problem]) -> String {
    let row = |problem: &Problem| {
        let ([t, height], name) = (last(problem), problem.name());
        let one = |printed: &Printed| {
            let Printed { by, t, quantity, .. } = printed;
            format!("{by}, {quantity} at {t}: {}", off(problem, printed))
        };
        let printed = problem.printed.iter().map(one).collect::<Vec<_>>().join("<br>");
        words([
            &format!("[{}]({name}/README.md), `{name}`", problem.title),
            &format!("{height} at t = {t}"),
            if printed.is_empty() { "no value" } else { &printed },
            &problem.used_by.join("; "),
        ])
    };
    let header =
        ["problem", "height of the centre of mass above the tip", "printed elsewhere: off by", "used by"];
    doc_markers::table(&std::iter::once(words(header)).chain(problems.iter().map(row)).collect::<Vec<_>>())
}
