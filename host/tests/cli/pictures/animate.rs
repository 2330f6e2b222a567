//! `toytop animate`: a GIF.

use crate::command::{count, folder, path, toytop};

#[test]
fn a_gif_shows_the_top_in_motion() {
    folder("animate_gif");
    let line = "animate @toy_top --span 0..0.1 --duration 0.4 --size 96 -o animate_gif/top.gif";
    assert_eq!(toytop(line).ok(), "");
    let mut options = gif::DecodeOptions::new();
    options.set_color_output(gif::ColorOutput::RGBA);
    let file = std::fs::File::open(path("animate_gif/top.gif")).expect("the film");
    let mut film = options.read_info(file).expect("a GIF");
    assert_eq!((film.width(), film.height()), (96, 96));
    let mut frames: Vec<Vec<u8>> = Vec::new();
    while let Some(frame) = film.read_next_frame().expect("a frame") {
        assert_eq!(frame.delay, 4, "hundredths of a second");
        frames.push(frame.buffer.to_vec());
    }
    assert_eq!(frames.len(), 10);
    let is_red = |pixel: &&[u8]| pixel[0] > 150 && pixel[1] < 110 && pixel[2] < 110;
    assert!(
        frames.iter().all(|frame| frame.chunks(4).filter(is_red).count() > 5),
        "the marked spoke is seen"
    );
    assert!(frames.windows(2).all(|pair| pair[0] != pair[1]), "every frame is another");
}

#[test]
fn a_refused_film_leaves_no_file() {
    folder("animate_refused");
    for (name, part) in [
        ("top.avi", "must end in .gif"),
        ("top.gif --duration 0", "must be a number from 0.1 to 600"),
        ("top.gif --span 1..1", "must be LOW..HIGH"),
        ("top.gif --span 0..1e6", "--span: 0..1e6: must span at most 5.697 (75 nutation periods or turns)"),
        ("no/folder/top.gif --duration 0.1", "no/folder/top.gif"),
    ] {
        toytop(format!("animate @toy_top -o animate_refused/{name}")).refused(2, part);
    }
    assert_eq!(count("animate_refused"), 0);
}
