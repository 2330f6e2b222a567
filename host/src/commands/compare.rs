//! `toytop compare`: how far the core is from the full 3-D equations, motion by motion and scalar by scalar.

mod bounds;
mod measure;

use super::{Report, lift_off};
use crate::cli::{CompareArgs, Format, Scalar, ScalarChoice};
use crate::output::{self, Cell, Record};
use crate::scenario::Scenario;
use crate::{Failure, builtin};
use bounds::{bound, horizon, steps_per_period};
use measure::{Measured, SAMPLES, measure};
use std::time::Duration;

/// One motion in one scalar.
struct Row {
    motion: String,
    scalar: Scalar,
    measured: Measured,
    /// On the error of the orientation, rad.
    bound: f64,
}

impl Row {
    /// A NaN is a miss.
    fn within_bound(&self) -> bool {
        self.measured.errors.orientation <= self.bound
    }

    fn verdict(&self) -> &'static str {
        if self.within_bound() { "ok" } else { "MISS" }
    }
}

pub(super) fn run(arguments: &CompareArgs) -> Result<Report, Failure> {
    let built_in = arguments.scenarios.is_empty();
    let scenarios = if built_in {
        builtin::scenarios()?
    } else {
        arguments.scenarios.iter().map(|path| Scenario::read(path)).collect::<Result<_, _>>()?
    };
    let scalars = ScalarChoice::chosen(&arguments.scalar);
    let mut remarks = Vec::new();
    let mut rows = Vec::new();
    for scenario in &scenarios {
        let own = built_in.then(|| builtin::own_bounds(scenario)).flatten();
        let span = horizon(&scenario.motion, arguments.periods);
        remarks.extend(span.remark.map(|remark| format!("{}: {remark}", scenario.name)));
        for &scalar in &scalars {
            let step = span.period / f64::from(steps_per_period(scalar));
            let measured = match scalar {
                Scalar::F64 => measure::<f64>(scenario, step, span.time, arguments.periods)?,
                Scalar::F32 => measure::<f32>(scenario, step, span.time, arguments.periods)?,
            };
            let bound = bound(&scenario.motion, scalar, arguments.periods, own);
            rows.push(Row { motion: scenario.name.clone(), scalar, measured, bound });
        }
    }
    let below = arguments.format == Format::Table;
    let text = match arguments.format {
        Format::Table => table(&rows, arguments.periods, &scalars),
        Format::Csv => output::csv(&records(&rows)).map_err(Failure::Output)?,
        Format::Json => output::json_list("rows", &records(&rows)).map_err(Failure::Output)?,
    };
    remarks.extend(lift_off(&scenarios));
    let missed = rows.iter().any(|row| !row.within_bound());
    Ok(Report { text, missed, ..Report::default() }.with_remarks(remarks, below))
}

/// Only the stepper is there to be compared.
const METHOD: &str = "stepper";

fn records(rows: &[Row]) -> Vec<Record> {
    let record = |row: &Row| {
        let errors = row.measured.errors;
        let [l, n, h] = errors.integrals;
        Record(vec![
            ("motion", Cell::Text(row.motion.clone())),
            ("scalar", Cell::Text(row.scalar.name().to_owned())),
            ("method", Cell::Text(METHOD.to_owned())),
            ("max_orientation_error_rad", Cell::Number(errors.orientation)),
            ("max_u_error", Cell::Number(errors.u)),
            ("max_tip_error_per_s", Cell::Number(errors.tip)),
            ("h_drift", Cell::Number(h)),
            ("l_drift", Cell::Number(l)),
            ("n_drift", Cell::Number(n)),
            ("steps", Cell::Count(row.measured.steps)),
            ("wall_time_s", Cell::Number(row.measured.wall.as_secs_f64())),
            ("bound_rad", Cell::Number(row.bound)),
            ("verdict", Cell::Text(row.verdict().to_owned())),
        ])
    };
    rows.iter().map(record).collect()
}

const HEADER: [&str; 13] =
    ["motion", "type", "method", "angle", "u", "tip", "h", "l", "n", "steps", "time", "bound", ""];

fn table(rows: &[Row], periods: u32, scalars: &[Scalar]) -> String {
    let line = |row: &Row| {
        let errors = row.measured.errors;
        let [l, n, h] = errors.integrals;
        let mut cells = vec![shortened(&row.motion), row.scalar.name().to_owned(), METHOD.to_owned()];
        cells.extend([errors.orientation, errors.u, errors.tip, h, l, n].map(|x| format!("{x:.1e}")));
        cells.extend([row.measured.steps.to_string(), milliseconds(row.measured.wall)]);
        cells.extend([format!("{:.0e}", row.bound), row.verdict().to_owned()]);
        cells
    };
    let header = HEADER.iter().map(|&name| name.to_owned()).collect();
    let lines = std::iter::once(header).chain(rows.iter().map(line)).collect();
    let steps: Vec<_> =
        scalars.iter().map(|&scalar| format!("{} in {}", steps_per_period(scalar), scalar.name())).collect();
    format!(
        "{}\nThe core against the full 3-D equations: greatest differences at {SAMPLES} moments a period over {periods} periods.\n\
         angle: 2 sqrt(|d alpha|^2 + |d beta|^2) in rad, not to exceed the bound; tip: in units of s; h, l, n: as recomputed\n\
         from alpha, beta and their rates, against their constants, relative. Steps a period: {}.\n",
        output::columns(lines, 3),
        steps.join(", ")
    )
}

fn milliseconds(time: Duration) -> String {
    format!("{:.1} ms", 1e3 * time.as_secs_f64())
}

/// A name that keeps the table within 120 columns.
fn shortened(name: &str) -> String {
    const LONGEST: usize = 20;
    if name.chars().count() <= LONGEST {
        return name.to_owned();
    }
    name.chars().take(LONGEST - 1).chain(['…']).collect()
}
