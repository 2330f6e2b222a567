//! Picture of error against cost: a curve for each chip, with a mark for each scalar.

use super::chart::{Chart, Curve};
use crate::budget::{CHIPS, Chip, Limits, Model};
use crate::measure::accuracy::Accuracy;
use kuva::render::render::Scene;

/// Picture of all scalars.
pub(crate) fn picture(all: &[Accuracy], limits: &Limits) -> Scene {
    let curve = |chip: &Chip| {
        let point = |accuracy: &Accuracy| {
            Some([limits.next_tick(accuracy.scalar.name(), chip)? as f64, accuracy.all().angle])
        };
        let unit = if Model::of(chip).is_some() { "cycles" } else { "instructions" };
        let name = format!("{}, {unit}", chip.core);
        Curve { name, points: all.iter().filter_map(point).collect(), marked: true }
    };
    let names: Vec<_> = all
        .iter()
        .map(|accuracy| format!("{} {:.0e}", accuracy.scalar.name(), accuracy.all().angle))
        .collect();
    let chart = Chart {
        title: "What an orientation costs, and how exact it is",
        labels: [
            "cost of the next tick: modelled cycles, or instructions executed",
            &format!("greatest error over ticks 1 to 2⁴⁰, rad: {}", names.join(", ")),
        ],
        powers: [true; 2],
    };
    chart.draw_marks(&CHIPS.iter().map(curve).collect::<Vec<_>>())
}
