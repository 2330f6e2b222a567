//! The raw parts as one JSON object.

use super::{Coefficients, Label, Parts};
use serde_json::{Value, json};
use toytop::real::SINE_CONSTANTS;

/// The object, on one line. Integers of more than 53 bits, which not every reader of JSON keeps, are words of 32 bits, the least
/// significant first; floating point has the shortest digits that read back the same bits. `sine` is what the crate's sines
/// are made of.
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
    let [tip_scale, rates @ ..] = parts.scales;
    let object = json!({
        "name": label.name,
        "tick": label.tick,
        "format": parts.format,
        "checksum": parts.checksum,
        "scalar": parts.scalar.name(),
        "segments": parts.size[0],
        "terms": parts.size[1],
        "first": parts.first.map(words),
        "step": parts.step,
        "exact_step": parts.exact_step,
        "ticks_per_time": parts.ticks_per_time,
        "horizon": parts.horizon.map(|ticks| ticks.map(|tick| words(tick as u64))),
        "bound": parts.bound,
        "tip_scale": tip_scale,
        "rates": rates,
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
