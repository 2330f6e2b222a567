//! `toytop-lab report`: a page with all measurements, and the tables of `host/docs/accuracy.md`, which contain only results that do not
//! depend on the machine.

mod accuracy;
mod budget;
mod page;
mod precision;
mod readme;

use crate::cli::ReportArgs;
use std::path::Path;
use toytop_host::Failure;
use toytop_host::Report;
use toytop_host::budget::Costs;
use toytop_host::cli::Scalar;
use toytop_host::measure::accuracy::measured;
use toytop_host::measure::benchmark::Benchmark;
use toytop_host::output::whole_file;
use toytop_host::pictures::figures;
use toytop_host::pictures::plot::Form;

/// Size of the largest page, or of the largest file with results of other programs, MiB.
const LARGEST_FILE: u64 = 16;

/// Table as text, for a page.
struct Table {
    header: Vec<String>,
    rows: Vec<Vec<String>>,
}

pub(super) fn run(arguments: &ReportArgs) -> Result<Report, Failure> {
    let mut report = Report::default();
    // bad input is refused before anything is written
    let budget = match &arguments.budget {
        Some(path) => budget::records(&read(path, "--budget")?, path)?,
        None => budget::allowed()?,
    };
    let others = match &arguments.others {
        Some(path) => precision::others(&read(path, "--others")?, path)?,
        None => Vec::new(),
    };
    if let Some(path) = &arguments.readme {
        let old = read(path, "--readme")?;
        let tables = [
            ("accuracy", accuracy::worst()?),
            ("scalars", scalars()?),
            ("error against time", precision::against_time()?),
        ];
        let new = readme::with(&old, &tables).map_err(|error| error.of(&path.display().to_string()))?;
        if new != old && arguments.check {
            report.missed = true;
            let name = path.display();
            report
                .notes
                .push(format!("{name}: a table is stale; toytop-lab report --readme {name} rewrites it"));
        } else if new != old {
            whole_file::write("--readme", path, new.as_bytes())?;
        }
    }
    let Some(folder) = &arguments.output else { return Ok(report) };
    std::fs::create_dir_all(folder).map_err(|error| whole_file::refused("--output", folder, error))?;
    let benchmark = Benchmark::new()?;
    let points = precision::measured(&benchmark, others)?;
    let mut pictures = vec![("Work and precision", precision::picture(&points).encoded(Form::Svg)?)];
    for picture in figures::all()? {
        pictures.push((picture.title, picture.encoded(Form::Svg)?));
    }
    let page = page::Page {
        accuracy: accuracy::all()?,
        precision: precision::table(&points),
        budget,
        measured: arguments.budget.is_some(),
        pictures,
    };
    let path = folder.join("index.html");
    whole_file::write("--output", &path, page.html().as_bytes())?;
    report.text = format!("{}\n", path.display());
    Ok(report)
}

/// Results of `toytop accuracy` for every scalar, with one digit.
fn scalars() -> Result<Table, Failure> {
    let mut rows = toytop_host::commands::accuracy::rows(&measured(&Scalar::ALL)?, &Costs::known()?, 0);
    let header = rows.remove(0);
    Ok(Table { header, rows })
}

fn read(path: &Path, option: &str) -> Result<String, Failure> {
    whole_file::read(&format!("{option}: {}", path.display()), path, LARGEST_FILE)
}

fn words<const N: usize>(words: [&str; N]) -> Vec<String> {
    words.map(str::to_owned).into()
}
