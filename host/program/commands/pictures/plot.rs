//! `toytop plot`: pictures of a motion.
//!
//! | module | kinds of picture |
//! |---|---|
//! | `tip` | curve of the tip |
//! | `sphere` | curve of the axis on its sphere |
//! | `angles` | tilt and precession against time |
//! | `potential` | effective potential against the tilt |

mod angles;
mod potential;
mod sphere;
pub mod tip;

use crate::arguments::options::{PICTURE, ending_in, time_range};
use crate::commands::warnings::warnings;
use crate::drawing;
use crate::terminal::report::Report;
use clap::{Args, ValueEnum};
use kuva::render::render::Scene;
use std::path::PathBuf;
use toytop_host::Failure;
use toytop_host::input::scenario::Scenario;
use toytop_host::motion::evaluator::MotionEvaluator;
use toytop_host::pictures::{MAX_CYCLES, MotionSpan};

/// Picture of a motion: curve of the tip or axis, tilt, precession, potential
///
/// For a held tip, --kind tip draws the axis instead.
#[derive(Args)]
#[command(after_help = "Symbols:\n  \
        u     cosine of the tilt, e1 <= u <= e2\n  \
        e3    third root of the cubic of the nutation\n  \
        rho   distance of the tip from the centre, s sqrt(1 - u^2)\n  \
        l, n  angular momenta about the vertical and about the axis of the top\n\n\
        Example: toytop plot host/scenarios/figure_3_loops.toml -o tip.svg\n         \
        toytop plot host/scenarios/toy_top.toml --kind tilt --span 0..0.5 --size 1200 -o tilt.png")]
pub struct PlotArgs {
    /// Scenario file
    scenario: PathBuf,
    /// Kind of picture
    #[arg(long, default_value = "tip")]
    kind: PlotKind,
    /// First and last time to draw, s, at most 1000 nutation periods; by default about one turn of the tip around the centre
    #[arg(long, value_name = "LOW..HIGH", value_parser = time_range, allow_hyphen_values = true)]
    span: Option<[f64; 2]>,
    /// Width of the picture, pixels
    #[arg(long, value_name = "PIXELS", value_parser = clap::value_parser!(u32).range(100..=10_000))]
    size: Option<u32>,
    /// Output file, whose name ends in .svg or .png
    #[arg(short, long, value_name = "FILE", value_parser = ending_in(PICTURE))]
    output: PathBuf,
}

/// Kind of picture that `plot` draws.
#[derive(Clone, Copy, PartialEq, ValueEnum)]
enum PlotKind {
    /// Curve of the tip between its two bounding circles, from above; for a held tip, the curve of the axis
    Tip,
    /// Curve of the axis on the unit sphere
    Axis,
    /// Tilt of the axis against time
    Tilt,
    /// Azimuth of the axis against time
    Precession,
    /// Effective potential of the nutation against the tilt, without --span
    Potential,
}

pub fn run(arguments: &PlotArgs) -> Result<Report, Failure> {
    let scenario = Scenario::read(&arguments.scenario)?;
    let scene = scene(arguments, &scenario)?;
    drawing::write("--output", &arguments.output, &scene, arguments.size)?;
    Ok(Report::default().with_notes(warnings(&[scenario])))
}

fn scene(arguments: &PlotArgs, scenario: &Scenario) -> Result<Scene, Failure> {
    let ends = arguments.span;
    if arguments.kind == PlotKind::Potential {
        if ends.is_some() {
            return Err(Failure::input("--span: not for --kind potential"));
        }
        return Ok(potential::draw(scenario));
    }
    let evaluator = MotionEvaluator::of_scenario(scenario)?;
    let span = MotionSpan::new(evaluator, ends, MAX_CYCLES).map_err(|failure| failure.at("--span"))?;
    Ok(match arguments.kind {
        PlotKind::Tilt => angles::tilt(scenario, &span),
        PlotKind::Precession => angles::precession(scenario, &span)?,
        PlotKind::Axis => sphere::draw(scenario, &span),
        _ => tip::draw(scenario, &span),
    })
}
