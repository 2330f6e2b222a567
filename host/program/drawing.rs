//! Frames, colours, texts, dots and lines of pictures, and their files.

pub mod camera;
pub mod chart;

use crate::files::whole_file;
use kuva::backend::raster::RasterBackend;
use kuva::backend::svg::SvgBackend;
use kuva::render::color::Color;
use kuva::render::layout::Layout;
use kuva::render::plots::Plot;
use kuva::render::render::{Primitive, Scene, TextAnchor};
use std::io;
use std::path::Path;
use toytop_host::Failure;

/// Colour of the curve of the tip or axis.
pub const CURVE_COLOR: &str = "#1f4e8c";
/// Colour of the bounds of the curve.
pub const BOUND_COLOR: &str = "#8a8a8a";
/// Colour of what must be seen first: the start of a curve, and a mark on the disc of a film.
pub const ACCENT_COLOR: &str = "#c0392b";
/// Colour of captions.
pub const CAPTION_COLOR: &str = "#555555";

/// Frame with a title, a label below it, and these ranges of x and y.
pub fn frame(plots: &[Plot], title: &str, label: &str, [x, y]: [[f64; 2]; 2]) -> Layout {
    Layout::auto_from_plots(plots)
        .with_title(title)
        .with_x_label(label)
        .with_x_axis_min(x[0])
        .with_x_axis_max(x[1])
        .with_y_axis_min(y[0])
        .with_y_axis_max(y[1])
        .with_box_axes()
        .with_legend_box(false)
}

/// Writes a picture, encoded as by [`encoded`].
///
/// # Errors
/// The failures of [`whole_file::write`], or [`Failure::output`]: the picture cannot be encoded.
pub fn write(option: &str, path: &Path, scene: &Scene, width: Option<u32>) -> Result<(), Failure> {
    let bytes = encoded(path, scene, width).map_err(Failure::output)?;
    whole_file::write(option, path, &bytes)
}

/// Picture as SVG or PNG, by the ending of the file's name. `width` is in pixels; without it an SVG has the size of its layout, and a PNG
/// two pixels for each of its units.
///
/// # Errors
/// The picture cannot be encoded.
pub fn encoded(path: &Path, scene: &Scene, width: Option<u32>) -> io::Result<Vec<u8>> {
    let scale = width.map(|width| f64::from(width) / scene.width);
    if path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("png")) {
        return raster(scene, scale.unwrap_or(2.0));
    }
    let svg = SvgBackend::default().render_scene(scene);
    let Some(scale) = scale else { return Ok(svg.into_bytes()) };
    let size = |scale: f64| format!("width=\"{}\" height=\"{}\"", scale * scene.width, scale * scene.height);
    let scaled = format!("{} viewBox=\"0 0 {} {}\"", size(scale), scene.width, scene.height);
    Ok(svg.replacen(&size(1.0), &scaled, 1).into_bytes())
}

/// PNG with `scale` pixels for each unit of the layout.
pub fn raster(scene: &Scene, scale: f64) -> io::Result<Vec<u8>> {
    RasterBackend::new().with_scale(scale as f32).render_scene(scene).map_err(io::Error::other)
}

/// Adds a line of text.
pub fn text(scene: &mut Scene, content: &str, [x, y]: [f64; 2], size: u32, anchor: TextAnchor, color: &str) {
    let (content, color) = (content.to_owned(), Some(Color::from(color)));
    scene.add(Primitive::Text { x, y, content, size, anchor, rotate: None, bold: false, color });
}

/// Adds the label of the vertical axis, horizontally above the frame, because rotated text is not sharp in a raster picture.
pub fn label_above(scene: &mut Scene, content: &str, place: [f64; 2]) {
    text(scene, content, place, 14, TextAnchor::Start, "black");
}

/// Adds a disc, with an outline of another colour if there is one.
pub fn disc(scene: &mut Scene, (cx, cy): (f64, f64), r: f64, fill: &str, outline: Option<&str>) {
    let (fill, stroke) = (Color::from(fill), outline.map(Color::from));
    let stroke_width = outline.map(|_| 1.0);
    scene.add(Primitive::Circle { cx, cy, r, fill, fill_opacity: None, stroke, stroke_width });
}

/// Adds a line through points.
pub fn line(scene: &mut Scene, points: Vec<(f64, f64)>, color: &str, stroke_width: f64) {
    let stroke = Color::from(color);
    scene.add(Primitive::PolyLine { points, stroke, stroke_width, stroke_dasharray: None });
}
