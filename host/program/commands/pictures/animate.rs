//! `toytop animate`: a motion as a GIF.

mod film;

use crate::arguments::options::{ending_in, time_range};
use crate::arguments::values::number;
use crate::commands::warnings::warnings;
use crate::files::whole_file;
use crate::terminal::parallel::Progress;
use crate::terminal::report::Report;
use clap::Args;
use film::Film;
use std::io::BufWriter;
use std::path::PathBuf;
use toytop_host::Failure;
use toytop_host::input::scenario::Scenario;
use toytop_host::motion::evaluator::MotionEvaluator;
use toytop_host::pictures::MotionSpan;

/// Animation of a motion, as a GIF
#[derive(Args)]
#[command(
    after_help = "Each frame shows the top at one exact time. A red spoke of the disc turns with the body.\n\
        A fast spin needs slow motion: --span 0..0.2 shows a fifth of a second over the whole film.\n\n\
        Example: toytop animate host/scenarios/toy_top.toml --span 0..0.2 -o top.gif"
)]
pub struct AnimateArgs {
    /// Scenario file
    scenario: PathBuf,
    /// First and last time to show, s; by default about one turn of the tip around the centre
    #[arg(long, value_name = "LOW..HIGH", value_parser = time_range, allow_hyphen_values = true)]
    span: Option<[f64; 2]>,
    /// Length of the film, s
    #[arg(long, value_name = "S", default_value_t = 6.0, value_parser = number(0.1..=600.0))]
    duration: f64,
    /// Width and height of the film, pixels
    #[arg(long, value_name = "PIXELS", default_value_t = 480, value_parser = clap::value_parser!(u16).range(64..=2160))]
    size: u16,
    /// Output file, whose name ends in .gif
    #[arg(short, long, value_name = "FILE", value_parser = ending_in(&[".gif"]))]
    output: PathBuf,
}

/// Time of a frame, hundredths of a second.
const HUNDREDTHS: u16 = 4;

/// Least number of frames in a cycle of the motion; fewer would show an alias of it.
const FRAMES_PER_CYCLE: u64 = 2;

pub fn run(arguments: &AnimateArgs) -> Result<Report, Failure> {
    let AnimateArgs { scenario, span, duration, size, output } = arguments;
    let scenario = Scenario::read(scenario)?;
    let frames = (100.0 * duration / f64::from(HUNDREDTHS)).round().max(2.0) as u64;
    let evaluator = MotionEvaluator::of_scenario(&scenario)?;
    let span = MotionSpan::new(evaluator, *span, (frames / FRAMES_PER_CYCLE) as f64)
        .map_err(|failure| failure.at("--span"))?;
    let film = Film { scenario: &scenario, span: &span, frames, size: *size };
    let progress = Progress::new(frames, "frames");
    whole_file::write_by("--output", output, |file| film.gif(HUNDREDTHS, BufWriter::new(file), &progress))?;
    Ok(Report::default().with_notes(warnings(&[scenario])))
}
