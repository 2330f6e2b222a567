//! Numbers of a table as one JSON object.

use super::{Coefficients, Label, Parts};
use serde_json::{Value, json};
use toytop::Clock;
use toytop::scalar::SINE_CONSTANTS;

/// JSON object on one line. Integers of more than 53 bits, which some readers of JSON round, are words of 32 bits, the least significant
/// first. A floating-point number has the shortest decimal that reads back the same bits. `sine` contains the constants of the crate's
/// sines.
#[must_use]
pub fn object(label: &Label, parts: &Parts) -> String {
    let words = |wide: u64| [wide as u32, (wide >> 32) as u32];
    let points = || json!({ "points": SINE_CONSTANTS.points, "turn": SINE_CONSTANTS.turn, "secant": SINE_CONSTANTS.secant });
    let (coefficients, sine) = match &parts.coefficients {
        Coefficients::Integers(rows) => (by_segment(rows, parts), points()),
        Coefficients::Shorts(rows) => (by_segment(rows, parts), points()),
        Coefficients::Doubles(rows) => {
            (by_segment(rows, parts), json!({ "sine": SINE_CONSTANTS.sine, "cosine": SINE_CONSTANTS.cosine }))
        }
    };
    let Clock { step, tip_scale, first, horizon, exact_step, ticks_per_time, rates, tip, turns } =
        &parts.clock;
    let object = json!({
        "name": label.name,
        "tick": label.tick,
        "format": parts.format,
        "crc32": parts.crc32,
        "scalar": parts.scalar.name(),
        "segments": parts.size[0],
        "terms": parts.size[1],
        "step": step,
        "tip_scale": tip_scale,
        "first": first.map(words),
        "horizon": horizon.map(|ticks| ticks.map(|tick| words(tick as u64))),
        "exact_step": exact_step,
        "ticks_per_time": ticks_per_time,
        "rates": rates,
        "tip": {
            "start": tip.start,
            "step": tip.step,
            "quarter": tip.quarter,
            "passes": tip.passes,
            "exists": tip.exists,
        },
        "turns": turns,
        "error_bound": [parts.error_bound.constant, parts.error_bound.per_tick],
        "rate_error_bound": [parts.rate_error_bound.constant, parts.rate_error_bound.per_tick],
        "cells": parts.cells,
        "coefficients": coefficients,
        "sine": sine,
    });
    format!("{object}\n")
}

fn by_segment<C: Copy + Into<Value>>(rows: &[[C; 4]], parts: &Parts) -> Value {
    let row = |row: &[C; 4]| row.iter().map(|&coefficient| coefficient.into()).collect::<Value>();
    rows.chunks(parts.size[1]).map(|rows| rows.iter().map(row).collect::<Value>()).collect()
}
