//! Results of `compare` over ten periods, with one digit: for each motion, and the greatest error of each group of motions.

use super::{Table, words};
use toytop_host::Failure;
use toytop_host::cli::{CompareArgs, Format, Method, Scalar, ScalarChoice};
use toytop_host::commands::compare::{self, Row};

const KINDS: [(Method, Scalar, &str); 6] = [
    (Method::Ephemeris, Scalar::F64, "ephemeris f64"),
    (Method::Ephemeris, Scalar::F32, "f32"),
    (Method::Ephemeris, Scalar::Q31, "q31"),
    (Method::Ephemeris, Scalar::Q15, "q15"),
    (Method::Stepper, Scalar::F64, "stepper f64"),
    (Method::Stepper, Scalar::F32, "f32"),
];

/// Groups of built-in motions: beginning of their names, and name of the group.
const GROUPS: [(&str, &str); 5] = [
    ("figure", "the paper's nine curves"),
    ("toy top", "a toy top at 150 rad/s"),
    ("sleeping", "a sleeping top"),
    ("Lagrange", "a Lagrange top"),
    ("near separatrix", "near the separatrix, e₃ - e₂ = 1e-3 and 1e-6"),
];

fn rows() -> Result<Vec<Row>, Failure> {
    let arguments = CompareArgs {
        scenarios: Vec::new(),
        periods: 10,
        scalar: vec![ScalarChoice::All],
        all: true,
        format: Format::Table,
    };
    Ok(compare::rows(&arguments)?.rows)
}

fn table(rows: &[Row], groups: &[(String, String)]) -> Table {
    let worst = |start: &str, (method, scalar, _): &(Method, Scalar, &str)| {
        let of_group = rows
            .iter()
            .filter(|row| row.motion.starts_with(start) && row.method == *method && row.scalar == *scalar);
        let worst = of_group.filter_map(Row::error).reduce(f64::max);
        worst.map_or("-".to_owned(), |worst| format!("{worst:.0e}"))
    };
    let mut header = words(["greatest error over ten periods, rad"]);
    header.extend(KINDS.map(|(_, _, name)| name.to_owned()));
    let line = |(start, name): &(String, String)| {
        std::iter::once(name.clone()).chain(KINDS.iter().map(|kind| worst(start, kind))).collect()
    };
    Table { header, rows: groups.iter().map(line).collect() }
}

pub(super) fn worst() -> Result<Table, Failure> {
    Ok(table(&rows()?, &GROUPS.map(|(start, name)| (start.to_owned(), name.to_owned()))))
}

pub(super) fn all() -> Result<Table, Failure> {
    let rows = rows()?;
    let mut names: Vec<_> = rows.iter().map(|row| (row.motion.clone(), row.motion.clone())).collect();
    names.dedup();
    // "e3=1.1" and "e3=100" begin with "e3=1" too
    let mut exact = Table { header: Vec::new(), rows: Vec::new() };
    for name in names {
        let of_motion: Vec<_> = rows.iter().filter(|row| row.motion == name.0).cloned().collect();
        let Table { header, rows } = table(&of_motion, &[name]);
        exact.header = header;
        exact.rows.extend(rows);
    }
    Ok(exact)
}
