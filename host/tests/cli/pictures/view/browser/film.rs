//! GIF of the page: a decoder that is not ours reads from it the pictures that the page draws.

use super::probe;
use crate::command::{list, sample};
use crate::pictures::view::{folder, view};
use serde_json::Value;

/// Saves a GIF by its button, and draws some of its frames again.
const FILMED: &str = "
play(false);
go(0.5);
await settled();
let file;
// reading a real one waits for another process, and Chromium's time does not wait for that
window.Blob = class { constructor([bytes], { type }) { Object.assign(this, { bytes, type }); } };
window.download = (name, blob) => { file = { name, blob }; };
const digits = Array.from({ length: 256 }, (_, byte) => byte.toString(16).padStart(2, '0'));
const hexadecimal = (bytes) => Array.from(bytes, (byte) => digits[byte]).join('');
const button = element('gif');
button.click();
await new Promise((done) => setTimeout(done, 0));
const progress = button.textContent;
for (let waited = 0; waited < 150 && !file; waited++) await settled();
const canvas = filmCanvas(element('scene-picture'), FILM.width);
const drawn = [0, 1, 50, 99].map((i) => pixelsOf(canvas, frameAt(0.5 + 0.06 * i * state.speed)).slice());
const whole = file;
// a change of the motion ends a film, and nothing is saved
file = undefined;
button.click();
await set('spin-field', '123', 'change');
await settled();
return {
  progress, name: whole.name, type: whole.blob.type, label: button.textContent, isSaved: file !== undefined,
  size: [canvas.width, canvas.height], bytes: hexadecimal(whole.blob.bytes), drawn: drawn.map(hexadecimal),
};
";

/// Greatest mean difference of a channel between a picture and its picture in 255 colours, of 255.
const MEAN: f64 = 1.0;

fn bytes_of(hexadecimal: &Value) -> Vec<u8> {
    let digits = hexadecimal.as_str().expect("a text").as_bytes();
    let byte =
        |two: &[u8]| u8::from_str_radix(std::str::from_utf8(two).expect("digits"), 16).expect("a byte");
    digits.chunks(2).map(byte).collect()
}

/// Mean difference of the colour channels of two pictures in RGBA.
fn difference(a: &[u8], b: &[u8]) -> f64 {
    assert_eq!(a.len(), b.len());
    let sum: u64 = a.iter().zip(b).map(|(a, b)| u64::from(a.abs_diff(*b))).sum();
    sum as f64 / (0.75 * a.len() as f64)
}

#[test]
#[ignore = "a browser: cargo xtask test --only browser"]
fn a_gif_has_the_pictures_of_the_page() {
    let page = folder("view_film").join("film.html");
    view(&[&sample("toy_top")], &page);
    let filmed = probe(&page, FILMED, 1200, "");
    for (key, expected) in [("name", "toy_top_film.gif"), ("type", "image/gif"), ("label", "GIF")] {
        assert_eq!(filmed[key], expected, "{key}");
    }
    assert!(filmed["progress"].as_str().expect("a text").ends_with(" %"), "{}", filmed["progress"]);
    assert_eq!(filmed["isSaved"], false);
    let bytes = bytes_of(&filmed["bytes"]);
    println!("a GIF of {} bytes", bytes.len());
    let mut options = gif::DecodeOptions::new();
    options.set_color_output(gif::ColorOutput::Indexed);
    let mut film = options.read_info(&*bytes).expect("a GIF");
    assert_eq!(serde_json::json!([film.width(), film.height()]), filmed["size"]);
    assert_eq!(film.width(), 480);
    let palette = film.global_palette().expect("a palette").to_vec();
    let mut picture = vec![0; 4 * usize::from(film.width()) * usize::from(film.height())];
    let mut pictures = Vec::new();
    while let Some(frame) = film.read_next_frame().expect("a frame") {
        assert_eq!((frame.delay, frame.dispose), (6, gif::DisposalMethod::Keep));
        for (pixel, place) in picture.chunks_exact_mut(4).zip(&*frame.buffer) {
            if frame.transparent != Some(*place) {
                let place = 3 * usize::from(*place);
                pixel.copy_from_slice(&[palette[place], palette[place + 1], palette[place + 2], 255]);
            }
        }
        pictures.push(picture.clone());
    }
    assert_eq!(pictures.len(), 100);
    for (drawn, at) in list(&filmed["drawn"]).iter().zip([0, 1, 50, 99]) {
        let drawn = bytes_of(drawn);
        let own = difference(&drawn, &pictures[at]);
        println!("frame {at}: {own:.2} of 255 from what is drawn");
        assert!(own > 0.0 && own < MEAN, "{at}: {own}");
        let other = difference(&drawn, &pictures[(at + 50) % 100]);
        assert!(other > own, "{at}: {own} {other}");
    }
}
