//! Rust module with one `static`, which does not compile if one of its bits was changed.

use super::TableTitle;
use crate::motion::Scalar;
use crate::motion::ephemeris::TableData;
use toytop::{Clock, ErrorBound};

/// Text of the module. Numbers are printed by Rust, which reads back the same bits.
pub fn module(title: &TableTitle, data: &TableData) -> String {
    let name = title.identifier().to_uppercase();
    let [segments, _] = data.size;
    let scalar = match data.scalar {
        Scalar::Q31 => "toytop::fixed::types::I2F30",
        Scalar::Q15 => "toytop::fixed::types::I2F14",
        float => float.name(),
    };
    let size = format!("<{scalar}, {segments}>");
    let scale = |x: f64| match data.scalar {
        Scalar::F64 => format!("{x:?}"),
        // the shortest decimal that is read as this f32
        _ => format!("{:?}", x as f32),
    };
    let Clock { step, tip_start_quarter_turns, tip_sign_changes, tip_exists, .. } = &data.clock;
    let Clock { has_turning_points, first_phases, exact_step, ticks_per_time, .. } = &data.clock;
    let Clock { tip_start, tip_step, epoch, .. } = &data.clock;
    let bound = |ErrorBound { constant, per_tick }: ErrorBound| {
        format!("toytop::ErrorBound {{ constant: {constant:?}, per_tick: {per_tick:?} }}")
    };
    format!(
        "// Written by `toytop bake`; a changed number does not compile.

/// {headline}.
///
/// `{name}.at_tick(n)` is any tick; `{name}.cursor(0)` goes from one to the next.
#[rustfmt::skip]
#[allow(clippy::all, clippy::pedantic)]
pub static {name}: toytop::Ephemeris{size} = match (toytop::Baked::{size} {{
    format: {format},
    crc32: {crc32:#010x},
    clock: toytop::Clock {{
        step: {step:?},
        tip_start_quarter_turns: {tip_start_quarter_turns},
        tip_sign_changes: {tip_sign_changes},
        tip_exists: {tip_exists},
        has_turning_points: {has_turning_points},
        twice_tip_scale: {twice_tip_scale},
        x_rate: {x_rate},
        slow_sum_rate: {slow_sum_rate},
        axial_rate: {axial_rate},
        first_phases: {first_phases:?},
        exact_step: {exact_step:?},
        ticks_per_time: {ticks_per_time:?},
        tip_start: {tip_start:?},
        tip_step: {tip_step:?},
        epoch: {epoch},
    }},
    error_bound: {error_bound},
    rate_error_bound: {rate_error_bound},
    cells: {cells:?},
    segments: [
{segments}    ],
}})
.ephemeris()
{{
    Ok(ephemeris) => ephemeris,
    Err(toytop::BakedError::Format {{ .. }}) => panic!(\"format: written by another version of toytop\"),
    Err(toytop::BakedError::Checksum {{ .. }}) => panic!(\"crc32: the numbers were changed\"),
    Err(_) => panic!(\"a number is out of range\"),
}};
",
        headline = title.headline(data),
        format = data.format,
        crc32 = data.crc32,
        twice_tip_scale = scale(data.clock.twice_tip_scale),
        x_rate = scale(data.clock.x_rate),
        slow_sum_rate = scale(data.clock.slow_sum_rate),
        axial_rate = scale(data.clock.axial_rate),
        error_bound = bound(data.error_bound),
        rate_error_bound = bound(data.rate_error_bound),
        cells = data.cells,
        segments = rows(data),
    )
}

/// Coefficients with one row in each line, and brackets around each segment.
fn rows(data: &TableData) -> String {
    let line = |row: &[f64; 4]| match data.scalar {
        Scalar::F64 => format!("            {row:?},\n"),
        _ => format!("            {:?},\n", row.map(|x| x as i32)),
    };
    let segment =
        |rows: &[_]| format!("        [\n{}        ],\n", rows.iter().map(line).collect::<String>());
    data.coefficients.chunks(data.size[1]).map(segment).collect()
}
