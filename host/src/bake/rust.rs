//! A Rust module with one `static`, which does not compile if a bit of it is changed.

use super::{Coefficients, Label, Parts};
use crate::cli::Scalar;

/// The module's text. Numbers as Rust prints them: it reads back the same bits.
#[must_use]
pub fn module(label: &Label, parts: &Parts) -> String {
    let name = label.identifier().to_uppercase();
    let [segments, terms] = parts.size;
    let scalar = match parts.scalar {
        Scalar::Q31 => "toytop::fixed::types::I2F30",
        Scalar::Q15 => "toytop::fixed::types::I2F14",
        float => float.name(),
    };
    let size = format!("<{scalar}, {segments}, {terms}>");
    let [tip_scale, rates @ ..] = parts.scales;
    let scale = |x: f64| match parts.scalar {
        Scalar::F64 => format!("{x:?}"),
        // the shortest that is read as this f32
        _ => format!("{:?}", x as f32),
    };
    let rates = rates.map(scale).join(", ");
    format!(
        "// Written by `toytop bake`; a changed number does not compile.

/// {headline}.
///
/// `{name}.at_tick(n)` is any tick; `{name}.cursor(0)` goes from one to the next.
#[rustfmt::skip]
#[allow(clippy::all, clippy::pedantic)]
pub static {name}: toytop::Ephemeris{size} = match (toytop::Baked::{size} {{
    format: {format},
    checksum: {checksum:#010x},
    first: {first:?},
    step: {step:?},
    exact_step: {exact_step:?},
    ticks_per_time: {ticks_per_time:?},
    horizon: {horizon:?},
    bound: {bound:?},
    tip_scale: {tip_scale},
    rates: [{rates}],
    cells: {cells:?},
    coefficients: [
{coefficients}    ],
}})
.ephemeris()
{{
    Ok(ephemeris) => ephemeris,
    Err(toytop::BakedError::Format {{ .. }}) => panic!(\"format: written by another version of toytop\"),
    Err(_) => panic!(\"checksum: the numbers were changed\"),
}};
",
        headline = label.headline(parts),
        format = parts.format,
        checksum = parts.checksum,
        first = parts.first,
        step = parts.step,
        exact_step = parts.exact_step,
        ticks_per_time = parts.ticks_per_time,
        horizon = parts.horizon,
        bound = parts.bound,
        tip_scale = scale(tip_scale),
        cells = parts.cells,
        coefficients = match &parts.coefficients {
            Coefficients::Integers(rows) => rows_of(rows, terms),
            Coefficients::Shorts(rows) => rows_of(rows, terms),
            Coefficients::Doubles(rows) => rows_of(rows, terms),
        },
    )
}

/// A row a line, a segment in brackets.
fn rows_of(rows: &[[impl std::fmt::Debug; 4]], terms: usize) -> String {
    let line = |row: &_| format!("            {row:?},\n");
    let segment =
        |rows: &[_]| format!("        [\n{}        ],\n", rows.iter().map(line).collect::<String>());
    rows.chunks(terms).map(segment).collect()
}
