//! `toytop animate`: a motion as a GIF or a film.

use super::options::{ending_in, span};
use super::{Report, warnings};
use crate::Failure;
use crate::input::scenario::Scenario;
use crate::output::progress::Progress;
use crate::output::whole_file;
use crate::pictures::space::Film;
use crate::pictures::span::{Span, require_at_most};
use clap::Args;
use std::fs;
use std::io::{BufWriter, ErrorKind, Write};
use std::path::{Path, PathBuf};
use std::process::{ChildStdin, Command, Stdio};

/// `toytop animate`
#[derive(Args)]
pub struct AnimateArgs {
    /// Scenario file
    scenario: PathBuf,
    /// Times to show, s; without it, from 0 over about one turn of the tip around the centre
    #[arg(long, value_name = "LOW..HIGH", value_parser = span, allow_hyphen_values = true)]
    times: Option<[f64; 2]>,
    /// Length of the film, s
    #[arg(long, value_name = "S", default_value_t = 6.0, value_parser = length)]
    seconds: f64,
    /// Width and height of the film, pixels
    #[arg(long, value_name = "PIXELS", default_value_t = 480, value_parser = clap::value_parser!(u32).range(64..=2160))]
    size: u32,
    /// Output file, whose name ends in .gif, or in .webm or .mp4, which need ffmpeg
    #[arg(short, long, value_name = "FILE", value_parser = ending_in(".gif, .webm or .mp4"))]
    output: PathBuf,
}

fn length(text: &str) -> Result<f64, &'static str> {
    text.parse().ok().filter(|x| (0.1..=600.0).contains(x)).ok_or("must be a number from 0.1 to 600")
}

pub fn run(arguments: &AnimateArgs) -> Result<Report, Failure> {
    let path = &arguments.output;
    let scenario = Scenario::read(&arguments.scenario)?;
    let is_gif = path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("gif"));
    let rate = if is_gif { GIF_RATE } else { FILM_RATE };
    let frames = (arguments.seconds * f64::from(rate)).round().max(2.0) as u64;
    if let Some(times) = arguments.times {
        let most = (frames / FRAMES_PER_CYCLE) as u32;
        require_at_most(most, &scenario, times, &format!(" with --seconds {}", arguments.seconds))?;
    }
    let span =
        Span::new(&scenario.motion, arguments.times).map_err(|failure| failure.of_motion(&scenario.name))?;
    let film = Film { scenario: &scenario, span: &span, frames, size: arguments.size };
    let progress = Progress::new(frames, "frames");
    if is_gif {
        let delay = (100 / GIF_RATE) as u16;
        whole_file::write_by("--output", path, |file| film.gif(delay, BufWriter::new(file), &progress))?;
    } else {
        by_ffmpeg(&film, path, &progress)?;
    }
    Ok(Report::default().with_remarks(warnings(&[scenario]), false))
}

/// Frames of a GIF in a second. A frame lasts a whole number of hundredths of a second.
const GIF_RATE: u32 = 25;
const FILM_RATE: u32 = 30;
/// Least number of frames in a cycle of the motion; fewer would show an alias of it.
const FRAMES_PER_CYCLE: u64 = 2;

/// Film that ffmpeg makes of the frames in a temporary file, which becomes the output when it is complete.
fn by_ffmpeg(film: &Film<'_>, path: &Path, progress: &Progress) -> Result<(), Failure> {
    let failed = |what: &str| Failure::Tool(format!("ffmpeg: {what}"));
    let ending = format!(".{}", path.extension().unwrap_or_default().display());
    let beside = tempfile::Builder::new().suffix(&ending).tempfile()?;
    let mut ffmpeg = Command::new("ffmpeg")
        .args(["-loglevel", "error", "-y", "-f", "image2pipe", "-framerate", &FILM_RATE.to_string()])
        .args(["-i", "-", "-pix_fmt", "yuv420p"])
        .arg(beside.path())
        .stdin(Stdio::piped())
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .map_err(|error| match error.kind() {
            ErrorKind::NotFound => {
                failed("not installed, but needed for .webm and .mp4 (a .gif needs nothing)")
            }
            _ => failed(&error.to_string()),
        })?;
    let write = |mut pipe: ChildStdin| {
        (0..film.frames).try_for_each(|frame| {
            progress.add(1);
            pipe.write_all(&film.png(frame)?)
        })
    };
    let written = ffmpeg.stdin.take().map(write);
    let good = ffmpeg.wait().is_ok_and(|status| status.success()) && matches!(written, Some(Ok(())));
    match fs::read(beside.path()) {
        Ok(bytes) if good => whole_file::write("--output", path, &bytes),
        _ => Err(failed("failed to make a film of the frames")),
    }
}
