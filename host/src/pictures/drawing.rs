//! Frame of a picture, texts in it, and its file.

use crate::Failure;
use crate::output::whole_file;
use kuva::backend::raster::RasterBackend;
use kuva::backend::svg::SvgBackend;
use kuva::render::color::Color;
use kuva::render::layout::Layout;
use kuva::render::plots::Plot;
use kuva::render::render::{Primitive, Scene, TextAnchor};
use std::io;
use std::path::Path;

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

/// Writes a picture as SVG or PNG, by the ending of the file's name. A PNG has two pixels for each unit of the layout.
///
/// # Errors
/// The failures of [`whole_file::write`], or [`Failure::Output`]: the picture cannot be encoded.
pub fn write(option: &str, path: &Path, scene: &Scene) -> Result<(), Failure> {
    let is_png = path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("png"));
    let bytes = match is_png {
        true => RasterBackend::new().with_scale(2.0).render_scene(scene).map_err(io::Error::other)?,
        false => SvgBackend::default().render_scene(scene).into_bytes(),
    };
    whole_file::write(option, path, &bytes)
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
