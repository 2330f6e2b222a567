//! Tests of `toytop animate`: a GIF, and films by ffmpeg.

use super::{folder, run, sample, stderr, stdout};
use std::process::Command;

#[test]
fn a_gif_shows_the_top_in_motion() {
    let folder = folder("animate_gif");
    let to = folder.join("top.gif");
    let output = run(&[
        "animate",
        &sample("toy_top"),
        "--times",
        "0..0.1",
        "--seconds",
        "0.4",
        "--size",
        "96",
        "-o",
        to.to_str().expect("UTF-8"),
    ]);
    assert_eq!((output.status.code(), stdout(&output)), (Some(0), ""), "{}", stderr(&output));
    let mut options = gif::DecodeOptions::new();
    options.set_color_output(gif::ColorOutput::RGBA);
    let mut film = options.read_info(std::fs::File::open(&to).expect("the film")).expect("a GIF");
    assert_eq!((film.width(), film.height()), (96, 96));
    let mut frames: Vec<Vec<u8>> = Vec::new();
    while let Some(frame) = film.read_next_frame().expect("a frame") {
        assert_eq!(frame.delay, 4, "hundredths of a second");
        frames.push(frame.buffer.to_vec());
    }
    assert_eq!(frames.len(), 10);
    let red = |frame: &Vec<u8>| {
        let is_red = |pixel: &&[u8]| pixel[0] > 150 && pixel[1] < 110 && pixel[2] < 110;
        frame.chunks(4).filter(is_red).count()
    };
    assert!(frames.iter().all(|frame| red(frame) > 5), "the marked spoke is seen");
    assert!(frames.windows(2).all(|pair| pair[0] != pair[1]), "every frame is another");
}

#[test]
fn invalid_film_arguments_are_refused() {
    let folder = folder("animate_refused");
    for (name, more, part) in [
        ("top.avi", &[][..], "must end in .gif, .webm or .mp4"),
        ("top.gif", &["--seconds", "0"], "must be a number from 0.1 to 600"),
        ("top.gif", &["--times", "1..1"], "must be LOW..HIGH"),
        ("top.gif", &["--times", "0..1e6"], "--times: 0..1e6: must span at most 75 nutation periods"),
        ("no/folder/top.gif", &["--seconds", "0.1"], "no/folder/top.gif"),
    ] {
        let to = folder.join(name);
        let output =
            run(&[&["animate", &sample("toy_top"), "-o", to.to_str().expect("UTF-8")], more].concat());
        assert_eq!((output.status.code(), stdout(&output)), (Some(2), ""), "{name}: {}", stderr(&output));
        assert!(
            stderr(&output).contains(part) && stderr(&output).matches('\n').count() == 1,
            "{}",
            stderr(&output)
        );
    }
    assert_eq!(std::fs::read_dir(&folder).expect("a folder").count(), 0);
}

/// A program with the name of ffmpeg keeps its input, and another one fails.
#[cfg(unix)]
#[test]
fn films_are_made_by_ffmpeg() {
    use std::os::unix::fs::PermissionsExt;
    let folder = folder("animate_ffmpeg");
    let to = folder.join("top.webm");
    let film = |path: &str| {
        let mut command = Command::new(super::PROGRAM);
        command.args(["animate", &sample("toy_top"), "--seconds", "0.2", "--size", "64", "-o"]);
        command.arg(&to).env("PATH", path).output().expect("it runs")
    };
    let none = film("");
    assert_eq!((none.status.code(), stdout(&none)), (Some(1), ""));
    assert!(
        stderr(&none).contains("ffmpeg: not installed, but needed for .webm and .mp4"),
        "{}",
        stderr(&none)
    );
    let ffmpeg = folder.join("ffmpeg");
    let path = format!("{}:/usr/bin:/bin", folder.display());
    for (script, code) in [("for last; do :; done; cat > \"$last\"", 0), ("cat > /dev/null; exit 1", 1)] {
        std::fs::write(&ffmpeg, format!("#!/bin/sh\n{script}\n")).expect("writable");
        std::fs::set_permissions(&ffmpeg, std::fs::Permissions::from_mode(0o755)).expect("executable");
        let _ = std::fs::remove_file(&to);
        let output = film(&path);
        assert_eq!(output.status.code(), Some(code), "{}", stderr(&output));
        assert_eq!(to.exists(), code == 0);
        if code == 0 {
            let bytes = std::fs::read(&to).expect("the film");
            let pictures = bytes.windows(8).filter(|eight| eight == b"\x89PNG\r\n\x1a\n").count();
            assert_eq!(pictures, 6, "30 frames a second");
        }
    }
}
