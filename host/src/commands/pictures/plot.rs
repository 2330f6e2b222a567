//! `toytop plot`: the curve of the tip between its bounding circles.

use super::options::{PICTURE, ending_in, span};
use super::{Report, warnings};
use crate::Failure;
use crate::input::scenario::Scenario;
use crate::pictures::{drawing, tip};
use clap::Args;
use std::path::PathBuf;

/// `toytop plot`
#[derive(Args)]
pub struct PlotArgs {
    /// Scenario file
    scenario: PathBuf,
    /// Times to draw, s, at most 1000 nutation periods; without it, from 0 over about one turn of the tip around the centre
    #[arg(long, value_name = "LOW..HIGH", value_parser = span, allow_hyphen_values = true)]
    times: Option<[f64; 2]>,
    /// Output file, whose name ends in .svg or .png
    #[arg(short, long, value_name = "FILE", value_parser = ending_in(PICTURE))]
    output: PathBuf,
}

pub fn run(arguments: &PlotArgs) -> Result<Report, Failure> {
    let scenario = Scenario::read(&arguments.scenario)?;
    let scene = tip::draw(&scenario, arguments.times).map_err(|failure| failure.of_motion(&scenario.name))?;
    drawing::write("--output", &arguments.output, &scene)?;
    Ok(Report::default().with_remarks(warnings(&[scenario]), false))
}
