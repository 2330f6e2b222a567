//! Rust module with one `static`, which does not compile if one of its bits was changed.

use super::TableTitle;
use toytop::{Baked, Table, TableScalar};
use toytop_host::motion::Scalar;

/// Lines with fields of a struct, as Rust writes them.
macro_rules! fields {
    ($from:expr; $($name:ident),*) => {
        [$(format!("        {}: {:?},\n", stringify!($name), $from.$name)),*].concat()
    };
}

/// Text of the module. Numbers are printed by Rust, which reads back the same bits.
pub fn module<R: TableScalar>(title: &TableTitle, table: &Table<R>, crc32: u32) -> String {
    let name = title.identifier().to_uppercase();
    let scalar = match title.scalar {
        Scalar::Q31 => "toytop::fixed::types::I2F30",
        Scalar::Q15 => "toytop::fixed::types::I2F14",
        float => float.name(),
    };
    let size = format!("<{scalar}, {}>", table.capacity());
    format!(
        "// Written by `toytop bake`; a changed number does not compile.

/// {headline}.
///
/// `{name}.at_tick(n)` is any tick; `{name}.cursor(0)` goes from one to the next.
#[rustfmt::skip]
#[allow(clippy::all, clippy::pedantic)]
pub static {name}: toytop::SizedTable{size} = match (toytop::Baked::{size} {{
    format: {format},
    crc32: {crc32:#010x},
    clock: toytop::Clock {{
{clock}    }},
    error_bound: toytop::{error_bound:?},
    rate_error_bound: toytop::{rate_error_bound:?},
    cells: {cells:?},
    segments: [
{segments}    ],
}})
.table()
{{
    Ok(table) => table,
    Err(toytop::BakedError::Format {{ .. }}) => panic!(\"format: written by another version of toytop\"),
    Err(toytop::BakedError::Checksum {{ .. }}) => panic!(\"crc32: the numbers were changed\"),
    Err(_) => panic!(\"a number is out of range\"),
}};
",
        headline = title.headline(table),
        format = Baked::<R, 16>::FORMAT,
        clock = fields!(
            table.clock();
            increments, ab_quarter_turns_at_e1, tip_passages, tip_exists, has_turning_points, twice_tip_scale, x_rate,
            mean_sum_rate, spin, first_phases, ticks_per_time, mean_tip_at_tick_0, epoch
        ),
        error_bound = table.error_bound(),
        rate_error_bound = table.rate_error_bound(),
        cells = table.cells(),
        segments = table.segments().iter().map(|segment| rows::<R>(segment.as_ref())).collect::<String>(),
    )
}

/// Coefficients of a segment in brackets, with one row in each line.
fn rows<R: TableScalar>(segment: &[[R::Coefficient; 4]]) -> String {
    let lines: String = segment.iter().map(|row| format!("            {row:?},\n")).collect();
    format!("        [\n{lines}        ],\n")
}
