//! `toytop animate`: a motion as a GIF or a film.

use super::{Report, unreal};
use crate::Failure;
use crate::cli::AnimateArgs;
use crate::input::scenario::Scenario;
use crate::output::progress::Progress;
use crate::output::whole_file;
use crate::pictures::animation::Film;
use crate::pictures::span::{Span, require_at_most};
use std::io::{BufWriter, ErrorKind, Write};
use std::path::Path;
use std::process::{Command, Stdio};

pub(super) fn run(arguments: &AnimateArgs) -> Result<Report, Failure> {
    let path = &arguments.output;
    let ending = path.extension().unwrap_or_default().to_string_lossy().to_lowercase();
    if !["gif", "webm", "mp4"].contains(&ending.as_str()) {
        let message = format!("--output: {}: must end in .gif, .webm or .mp4", path.display());
        return Err(Failure::Input(message));
    }
    let scenario = Scenario::read(&arguments.scenario)?;
    let rate = if ending == "gif" { GIF_RATE } else { FILM_RATE };
    let frames = (arguments.seconds * f64::from(rate)).round().max(2.0) as u64;
    if let Some(times) = arguments.times {
        let most = (frames / FRAMES_PER_CYCLE) as u32;
        require_at_most(most, &scenario, times, &format!(" with --seconds {}", arguments.seconds))?;
    }
    let span = Span::new(&scenario.motion, arguments.times).map_err(|failure| match failure {
        Failure::Method(_) => failure.of(&scenario.name),
        other => other,
    })?;
    let film = Film::new(&scenario, &span, frames, arguments.size);
    let mut progress = Progress::new(frames, "frames");
    if ending == "gif" {
        whole_file::write_by("--output", path, |file| {
            film.gif((100 / GIF_RATE) as u16, BufWriter::new(file), || progress.add(1))
        })?;
    } else {
        by_ffmpeg(&film, path, || progress.add(1))?;
    }
    Ok(Report::default().with_remarks(unreal(&[scenario]), false))
}

/// Frames of a GIF in a second. A frame lasts a whole number of hundredths of a second.
const GIF_RATE: u32 = 25;
const FILM_RATE: u32 = 30;
/// Least number of frames in a cycle of the motion; fewer would show an alias of it.
const FRAMES_PER_CYCLE: u64 = 2;

/// Film that ffmpeg makes of the frames in a temporary file, which becomes the output when it is complete.
fn by_ffmpeg(film: &Film<'_>, path: &Path, mut done: impl FnMut()) -> Result<(), Failure> {
    let failed = |what: &str| Failure::Tool(format!("ffmpeg: {what}"));
    let ending = path.extension().unwrap_or_default();
    let beside = std::env::temp_dir().join(format!("toytop_{}", std::process::id())).with_extension(ending);
    let rate = FILM_RATE.to_string();
    let started = Command::new("ffmpeg")
        .args(["-loglevel", "error", "-y", "-f", "image2pipe", "-framerate", &rate, "-i", "-"])
        .args(["-pix_fmt", "yuv420p"])
        .arg(&beside)
        .stdin(Stdio::piped())
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn();
    let mut ffmpeg = started.map_err(|error| match error.kind() {
        ErrorKind::NotFound => failed("not installed, but needed for .webm and .mp4 (a .gif needs nothing)"),
        _ => failed(&error.to_string()),
    })?;
    let mut pipe = ffmpeg.stdin.take();
    let written = (0..film.frames()).try_for_each(|frame| {
        let png = film.png(frame)?;
        pipe.as_mut().map_or(Ok(()), |pipe| pipe.write_all(&png))?;
        done();
        Ok::<(), std::io::Error>(())
    });
    drop(pipe);
    let good = ffmpeg.wait().is_ok_and(|status| status.success()) && written.is_ok();
    let bytes = std::fs::read(&beside);
    // the file may not exist
    let _ = std::fs::remove_file(&beside);
    match bytes {
        Ok(bytes) if good => whole_file::write("--output", path, &bytes),
        _ => Err(failed("failed to make a film of the frames")),
    }
}
