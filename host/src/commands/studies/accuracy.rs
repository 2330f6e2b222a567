//! `toytop accuracy`: error and cost of each scalar.

use super::Report;
use super::options::{PICTURE, ScalarChoice, ending_in};
use crate::Failure;
use crate::accuracy::{Accuracy, Errors, OCTAVES, measured};
use crate::budget::{CHIPS, Chip, Limits, Model};
use crate::output::doc_markers::{self, Page};
use crate::output::{self, Column, Format, Record};
use crate::pictures::charts::chart::{Chart, Curve};
use crate::pictures::drawing;
use clap::Args;
use kuva::render::render::Scene;
use micromath::F32Ext;
use std::path::PathBuf;

/// `toytop accuracy`
#[derive(Args)]
pub struct AccuracyArgs {
    /// Scalar types
    #[arg(long, value_name = "LIST", value_delimiter = ',', default_value = "all")]
    scalar: Vec<ScalarChoice>,
    /// Picture of error against cost, whose name ends in .svg or .png
    #[arg(long, value_name = "FILE", value_parser = ending_in(PICTURE))]
    plot: Option<PathBuf>,
    /// Markdown page whose table is rewritten
    #[arg(long, value_name = "FILE")]
    accept: Option<PathBuf>,
    /// Form of the output
    #[arg(long, default_value = "table")]
    format: Format,
}

pub fn run(arguments: &AccuracyArgs) -> Result<Report, Failure> {
    let page = arguments.accept.as_deref().map(|path| Page::read(path, "toytop accuracy: scalars"));
    let page = page.transpose()?;
    let limits = Limits::built_in()?;
    let all = measured(&ScalarChoice::chosen(&arguments.scalar))?;
    let scalars: Vec<_> = all.iter().map(|one| record(one, &one.all(), &limits)).collect();
    let octaves: Vec<_> = all.iter().flat_map(|one| of_octaves(one, &limits)).collect();
    let micromath =
        format!("The sine of micromath, an approximation for f32, is off by up to {:.0e}.\n", micromath());
    let table = || {
        format!(
            "{}\nThe ephemeris in each scalar, over ticks from 1 to 2^{OCTAVES}, against the truth to thirty digits. RMS: root of the\n\
             mean square. Tip: in units of s. Norm: of alpha and beta. Energy: from alpha, beta and their rates (in fixed point, f32),\n\
             relative. Cost of the next tick, at most, from firmware-examples/budgets.toml; cycles are modelled. CSV and JSON have the\n\
             errors over each octave of ticks. {micromath}",
            output::aligned(&scalars, &columns(output::error)),
        )
    };
    let text = output::render(arguments.format, &output::list("rows", &octaves), table)?;
    if let Some(path) = &arguments.plot {
        drawing::write("--plot", path, &picture(&all, &limits), None)?;
    }
    if let Some(page) = page {
        let rows = output::rows(&scalars, &columns(|x| format!("{x:.0e}")));
        page.write(&format!("{}\n{micromath}", doc_markers::table(&rows)))?;
    }
    Ok(text.into())
}

/// Columns of the costs, in the order of the chips, each with its heading.
const COSTS: [(&str, &str); 5] = [
    ("m0plus_cycles", "M0+ cycles"),
    ("m4f_cycles", "M4F cycles"),
    ("m7_instructions", "M7 instr."),
    ("m33_instructions", "M33 instr."),
    ("riscv_instructions", "RISC-V instr."),
];

fn columns(of_number: fn(f64) -> String) -> Vec<Column<'static>> {
    let errors = [
        ("scalar", ""),
        ("max_orientation_error_rad", "greatest error, rad"),
        ("rms_orientation_error_rad", "RMS error, rad"),
        ("max_tip_error_per_s", "tip, s"),
        ("max_norm_defect", "norm"),
        ("max_energy_defect", "energy"),
    ];
    errors.into_iter().chain(COSTS).map(|(name, heading)| (name, heading, of_number)).collect()
}

fn record(accuracy: &Accuracy, errors: &Errors, limits: &Limits) -> Record {
    let name = accuracy.scalar.name();
    let record = Record::default()
        .with("scalar", name)
        .with("max_orientation_error_rad", errors.angle)
        .with("rms_orientation_error_rad", errors.rms())
        .with("max_tip_error_per_s", errors.tip)
        .with("max_norm_defect", errors.norm)
        .with("max_energy_defect", errors.energy);
    let costs = CHIPS.iter().zip(COSTS);
    costs.fold(record, |record, (chip, (column, _))| record.with(column, limits.next_tick(name, chip)))
}

fn of_octaves(accuracy: &Accuracy, limits: &Limits) -> Vec<Record> {
    let record = |(first, errors): (u64, &Errors)| {
        let last = if first < 1 << OCTAVES { 2 * first - 1 } else { first };
        record(accuracy, errors, limits).with("first_tick", first).with("last_tick", last)
    };
    (0..=OCTAVES).map(|octave| 1 << octave).zip(&accuracy.octaves).map(record).collect()
}

/// Greatest error of micromath's sine over one turn.
fn micromath() -> f64 {
    let error = |x: f32| (f64::from(F32Ext::sin(x)) - f64::from(x).sin()).abs();
    (0..=u16::MAX).map(|i| error(1e-4 * f32::from(i))).fold(0.0, f64::max)
}

/// Picture of error against cost: a curve for each chip, with a mark for each scalar.
fn picture(all: &[Accuracy], limits: &Limits) -> Scene {
    let curve = |chip: &Chip| {
        let point = |accuracy: &Accuracy| {
            Some([limits.next_tick(accuracy.scalar.name(), chip)? as f64, accuracy.all().angle])
        };
        let unit = if Model::of(chip).is_some() { "cycles" } else { "instructions" };
        let points = all.iter().filter_map(point).collect();
        Curve { width: 0.0, ..Curve::marked(format!("{}, {unit}", chip.core), points) }
    };
    let name = |accuracy: &Accuracy| format!("{} {:.0e}", accuracy.scalar.name(), accuracy.all().angle);
    let names: Vec<_> = all.iter().map(name).collect();
    let chart = Chart {
        title: "What an orientation costs, and how exact it is",
        labels: [
            "cost of the next tick: modelled cycles, or instructions executed",
            &format!("greatest error over ticks 1 to 2⁴⁰, rad: {}", names.join(", ")),
        ],
        powers: [true; 2],
    };
    chart.draw(&CHIPS.iter().map(curve).collect::<Vec<_>>())
}
