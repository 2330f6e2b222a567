//! `toytop benchmark`: reference values of the problems that other integrators are tested with.

use super::Report;
use crate::Failure;
use crate::benchmarks::conventions::Values;
use crate::benchmarks::{self, Problem, compare};
use crate::cli::times;
use crate::cli::{BenchmarkArgs, Format, Scalar, TimesArgs};
use crate::motion::ephemeris::{furthest_time, smallest};
use crate::output::{self, Cell, Record, doc_markers};

/// Marker of a page above the tables that this command writes.
fn mark(name: Option<&str>) -> String {
    format!("toytop benchmark: {}", name.unwrap_or("catalogue"))
}

pub(super) fn run(arguments: &BenchmarkArgs) -> Result<Report, Failure> {
    let text = match &arguments.name {
        None => {
            let problems = benchmarks::all()?;
            if let Some(page) = &arguments.page {
                doc_markers::write(page, "--page", &mark(None), &catalogue(&problems))?;
                return Ok(Report::default());
            }
            match arguments.format {
                Format::Table => list(&problems),
                Format::Csv => output::csv(&summaries(&problems)).map_err(Failure::Output)?,
                Format::Json => {
                    output::json_list("problems", &summaries(&problems)).map_err(Failure::Output)?
                }
            }
        }
        Some(name) => {
            let problem = benchmarks::named(name).map_err(|failure| failure.of("benchmark"))?;
            if arguments.scenario {
                benchmarks::scenario(name)?.to_owned()
            } else if let Some(page) = &arguments.page {
                doc_markers::write(page, "--page", &mark(Some(name)), &tables(&problem))?;
                return Ok(Report::default());
            } else {
                of_problem(&problem, arguments)?
            }
        }
    };
    Ok(Report { text, ..Report::default() })
}

fn of_problem(problem: &Problem, arguments: &BenchmarkArgs) -> Result<String, Failure> {
    let records = match &arguments.times {
        Some(times) => computed(problem, times)?,
        None => references(problem),
    };
    Ok(match arguments.format {
        Format::Table => {
            let mut text = heading(problem) + &rows(&records);
            if arguments.times.is_none() && !problem.printed.is_empty() {
                text += &format!("\n{}", printed(problem));
            }
            text
        }
        Format::Csv => output::csv(&records).map_err(Failure::Output)?,
        Format::Json => {
            let rest = Record(vec![
                ("benchmark", Cell::Text(problem.name().to_owned())),
                ("source", Cell::Text(problem.source.clone())),
                ("symmetry_axis", Cell::Count(problem.conventions.symmetry_axis as u64)),
            ]);
            output::json_lists(&[("samples", &records)], &rest).map_err(Failure::Output)?
        }
    })
}

/// Names of the columns of a time. `toytop score` reads the time, the orientation and the rates by these names.
const COLUMNS: [&str; 11] = ["t", "x_com", "y_com", "z_com", "w", "x", "y", "z", "wx", "wy", "wz"];

fn record(cells: impl Iterator<Item = Cell>) -> Record {
    Record(COLUMNS.into_iter().zip(cells).collect())
}

/// Reference values at the source's times, with 30 digits.
fn references(problem: &Problem) -> Vec<Record> {
    let of = |reference: &benchmarks::Reference| {
        let values = [&reference.position[..], &reference.quaternion, &reference.omega_body].concat();
        record(std::iter::once(&reference.t).chain(&values).map(|text| Cell::Text(text.clone())))
    };
    problem.references.iter().map(of).collect()
}

/// Values of the ephemeris at any times, with 17 digits.
fn computed(problem: &Problem, times: &str) -> Result<Vec<Record>, Failure> {
    let motion = &problem.scenario.motion;
    let arguments = TimesArgs { times: Some(times.to_owned()), times_file: None, ticks: None };
    let instants = times::read(&arguments, [1000, 1])?;
    let reach = furthest_time(motion);
    let furthest = instants.furthest();
    if furthest.abs() > reach {
        return Err(Failure::Input(format!("--times: {furthest:e} must be within ±{reach:.1e}")));
    }
    let table = smallest(Scalar::F64, motion).map_err(|failure| failure.of(problem.name()))?;
    let of = |t: &f64| {
        let Values { position, quaternion, omega_body } = problem.conventions.values(&table.at(*t).sample);
        let values = [&[*t][..], &position, &quaternion, &omega_body].concat();
        record(values.into_iter().map(Cell::Number))
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

/// Table with one line for each number.
fn rows(records: &[Record]) -> String {
    const NAMES: [(&str, usize); 3] = [("position", 3), ("quaternion", 4), ("omega_body", 3)];
    let mut lines = Vec::new();
    for Record(cells) in records {
        let texts: Vec<_> = cells.iter().map(|(_, cell)| shown(cell)).collect();
        let mut values = texts.iter().skip(1);
        for (name, count) in NAMES {
            for (index, value) in values.by_ref().take(count).enumerate() {
                let what = if index == 0 {
                    vec![format!("t = {}", texts[0]), name.to_owned()]
                } else {
                    vec![String::new(); 2]
                };
                lines.push([what, vec![value.clone()]].concat());
            }
        }
    }
    output::columns(lines, 2)
}

fn shown(cell: &Cell) -> String {
    match cell {
        Cell::Text(text) => text.clone(),
        Cell::Number(x) => output::number(*x),
        _ => String::new(),
    }
}

/// Table of the values that others printed, with their errors.
fn printed(problem: &Problem) -> String {
    let mut lines = vec![["printed by", "t", "quantity", "off by"].map(str::to_owned).to_vec()];
    for printed in &problem.printed {
        let off = compare::off(problem, printed).map_or("-".to_owned(), |off| format!("{off:.1e}"));
        lines.push(vec![printed.by.clone(), printed.t.clone(), printed.quantity.name().to_owned(), off]);
    }
    output::columns(lines, 3)
}

fn list(problems: &[Problem]) -> String {
    let row = |problem: &Problem| vec![problem.name().to_owned(), problem.title.clone()];
    output::columns(problems.iter().map(row).collect(), 2)
        + "\ntoytop benchmark NAME prints 30 digits; --scenario its scenario file; toytop score --benchmark NAME judges a run.\n"
}

/// Time and height of the centre of mass at the last of the source's times.
fn last(problem: &Problem) -> [String; 2] {
    problem.references.last().map_or([String::new(), String::new()], |reference| {
        [reference.t.clone(), reference.position.last().cloned().unwrap_or_default()]
    })
}

fn summaries(problems: &[Problem]) -> Vec<Record> {
    let of = |problem: &Problem| {
        let [t, height] = last(problem);
        Record(vec![
            ("benchmark", Cell::Text(problem.name().to_owned())),
            ("title", Cell::Text(problem.title.clone())),
            ("seconds", Cell::Number(problem.seconds)),
            ("t", Cell::Text(t)),
            ("height", Cell::Text(height)),
            ("used_by", Cell::Text(problem.used_by.join("; "))),
        ])
    };
    problems.iter().map(of).collect()
}

/// Tables of the page of one problem: 30 digits, and what others printed.
fn tables(problem: &Problem) -> String {
    let mut lines = vec![["t", "quantity", "value"].map(str::to_owned).to_vec()];
    for reference in &problem.references {
        let quantities = [
            ("position", &reference.position),
            ("quaternion", &reference.quaternion),
            ("omega_body", &reference.omega_body),
        ];
        for (name, values) in quantities {
            lines.push(vec![reference.t.clone(), name.to_owned(), values.join("<br>")]);
        }
    }
    let mut text = doc_markers::table(&lines);
    if !problem.printed.is_empty() {
        let mut lines =
            vec![["printed by", "t", "quantity", "printed", "off by"].map(str::to_owned).to_vec()];
        for printed in &problem.printed {
            let values: Vec<_> = printed.values.iter().map(f64::to_string).collect();
            let off = compare::off(problem, printed).map_or("-".to_owned(), |off| format!("{off:.1e}"));
            lines.push(vec![
                printed.by.clone(),
                printed.t.clone(),
                printed.quantity.name().to_owned(),
                values.join("<br>"),
                off,
            ]);
        }
        text += &format!("\n{}", doc_markers::table(&lines));
    }
    text
}

/// Table of the page: problem, reference value, what others printed, who used it.
fn catalogue(problems: &[Problem]) -> String {
    let mut lines = vec![
        ["problem", "height of the centre of mass above the tip", "printed elsewhere: off by", "used by"]
            .map(str::to_owned)
            .to_vec(),
    ];
    for problem in problems {
        let [t, height] = last(problem);
        let off = |printed: &benchmarks::Printed| {
            let off = compare::off(problem, printed).map_or("-".to_owned(), |off| format!("{off:.1e}"));
            format!("{}, {} at {}: {off}", printed.by, printed.quantity.name(), printed.t)
        };
        let printed: Vec<_> = problem.printed.iter().map(off).collect();
        let printed = if printed.is_empty() { "no value".to_owned() } else { printed.join("<br>") };
        lines.push(vec![
            format!("[{}]({}/README.md), `{}`", problem.title, problem.name(), problem.name()),
            format!("{height} at t = {t}"),
            printed,
            problem.used_by.join("; "),
        ]);
    }
    doc_markers::table(&lines)
}
