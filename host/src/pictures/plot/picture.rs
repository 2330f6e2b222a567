//! Picture of a curve as SVG or PNG, for a white page.

use super::Curve;
use crate::Failure;
use crate::input::scenario::{Scenario, Units};
use crate::pictures::span::ends_as_text;
use kuva::backend::raster::RasterBackend;
use kuva::backend::svg::SvgBackend;
use kuva::plot::scatter::ScatterPlot;
use kuva::plot::{LegendPosition, LinePlot, LineStyle};
use kuva::render::color::Color;
use kuva::render::layout::Layout;
use kuva::render::plots::Plot;
use kuva::render::render::{Primitive, Scene, TextAnchor, render_multiple};
use std::f64::consts::PI;
use std::io;
use std::path::Path;
use toytop::Support;

/// File format of a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// SVG.
    Svg,
    /// PNG with two pixels for each unit of the layout.
    Png,
    /// PDF with a page as large as the layout.
    #[cfg(feature = "pdf")]
    Pdf,
}

impl Form {
    /// Form by the extension of a file; `option` is the option that named the file.
    ///
    /// # Errors
    /// [`Failure::Input`]: the extension is another one, or pdf in a program without that feature.
    pub fn of(path: &Path, option: &str) -> Result<Self, Failure> {
        let ending = path.extension().unwrap_or_default().to_string_lossy().to_lowercase();
        let reason = match &*ending {
            "svg" => return Ok(Self::Svg),
            "png" => return Ok(Self::Png),
            #[cfg(feature = "pdf")]
            "pdf" => return Ok(Self::Pdf),
            #[cfg(not(feature = "pdf"))]
            "pdf" => {
                "this program was built without the feature pdf (cargo build --features pdf); name a .svg or .png file"
            }
            _ => "must end in one of .svg, .png, .pdf",
        };
        Err(Failure::Input(format!("{option}: {}: {reason}", path.display())))
    }
}

const CURVE: &str = "#1f4e8c";
const BOUND: &str = "#8a8a8a";
const START: &str = "#c0392b";
const CAPTION: &str = "#555555";

/// Sizes of the layout in pixels: side of the square for the curve, and margins around it.
const SIDE: f64 = 560.0;
const LEFT: f64 = 72.0;
const RIGHT: f64 = 20.0;
const ABOVE: f64 = 92.0;
const BELOW: f64 = 58.0;

/// Draws a curve; the lines of the caption are below the title.
#[must_use]
pub fn draw(scenario: &Scenario, curve: &Curve, caption: &[String]) -> Scene {
    let s = scenario.motion.top().tip_scale();
    // in mm, or in units of s where the scenario names no units
    let (name, unit, scale) = match (scenario.motion.top().support(), scenario.units) {
        (Support::Sliding, Units::Si) => ("tip", ", mm", 1e-3),
        (Support::Sliding, Units::None) => ("tip", " in units of s", s),
        (Support::Fixed | Support::Free, _) => ("axis", " of the axis (length 1)", 1.0),
    };
    let extent = extent(curve, scale);
    let mut plots = legend(curve, name);
    plots.extend(lines(curve, scale));
    let layout = square(&plots, extent)
        .with_width(LEFT + SIDE + RIGHT)
        .with_height(ABOVE + SIDE + BELOW)
        .with_force_margins(LEFT, RIGHT)
        .with_force_margins_y(ABOVE, BELOW)
        .with_title(&*scenario.name)
        .with_x_label(format!("x{unit}"))
        .with_legend_position(LegendPosition::InsideTopRight)
        .with_legend_box(false);
    let mut scene = render_multiple(plots, layout);
    for (line, y) in caption.iter().zip([51.0, 67.0]) {
        scene.add(text(line, [LEFT + 0.5 * SIDE, y], 12, CAPTION));
    }
    if curve.circles.is_empty() {
        let rests = format!("The axis is vertical for ever: the {name} rests.");
        scene.add(text(&rests, [LEFT + 0.5 * SIDE, ABOVE + 0.5 * SIDE + 30.0], 14, CAPTION));
    }
    let [from, until] = ends_as_text([curve.start, curve.start + curve.time]);
    let shown = format!("t = {from} to {until}{}", scenario.units.name(" s"));
    scene.add(text(&shown, [LEFT + 0.88 * SIDE, ABOVE + SIDE + BELOW - 12.0], 12, CAPTION));
    scene.add(Primitive::Text {
        x: 12.0,
        y: ABOVE - 8.0,
        content: format!("y{unit}"),
        size: 14,
        anchor: TextAnchor::Start,
        rotate: None,
        bold: false,
        color: Some(Color::from("black")),
    });
    scene
}

/// Picture in a form, in the size of its layout.
///
/// # Errors
/// [`Failure::Output`]: the picture cannot be encoded.
pub(crate) fn encode(scene: &Scene, form: Form) -> Result<Vec<u8>, Failure> {
    encode_at(scene, form, None)
}

/// Picture in a form with this width in pixels, or without a width in the size of its layout.
pub(crate) fn encode_at(scene: &Scene, form: Form, width: Option<u32>) -> Result<Vec<u8>, Failure> {
    let scale = width.map(|width| f64::from(width) / scene.width);
    match form {
        Form::Svg => {
            let svg = SvgBackend::default().render_scene(scene);
            let Some(scale) = scale else { return Ok(svg.into_bytes()) };
            let (head, rest) = svg.split_once('>').unwrap_or((&svg, ""));
            let [from, to] = [1.0, scale]
                .map(|by| format!("width=\"{}\" height=\"{}\"", by * scene.width, by * scene.height));
            let view = format!("{to} viewBox=\"0 0 {} {}\"", scene.width, scene.height);
            Ok(format!("{}>{rest}", head.replace(&from, &view)).into_bytes())
        }
        Form::Png => RasterBackend::new()
            .with_scale(scale.unwrap_or(2.0) as f32)
            .render_scene(scene)
            .map_err(|error| Failure::Output(io::Error::other(error))),
        #[cfg(feature = "pdf")]
        Form::Pdf => pdf(scene, scale.unwrap_or(1.0)),
    }
}

/// PDF with a page on which a unit of the layout is `scale` points.
#[cfg(feature = "pdf")]
fn pdf(scene: &Scene, scale: f64) -> Result<Vec<u8>, Failure> {
    use kuva::backend::pdf::{PageSize, PdfBackend};
    let page = PageSize::Fixed { width: scale * scene.width, height: scale * scene.height };
    let encoded = PdfBackend::new().with_page_size(page).render_scenes(std::slice::from_ref(scene));
    encoded.map_err(|error| Failure::Output(io::Error::other(error)))
}

fn text(content: &str, [x, y]: [f64; 2], size: u32, color: &str) -> Primitive {
    let (anchor, color) = (TextAnchor::Middle, Some(Color::from(color)));
    Primitive::Text { x, y, content: content.to_owned(), size, anchor, rotate: None, bold: false, color }
}

/// Equal axes from -extent to extent.
pub(crate) fn square(plots: &[Plot], extent: f64) -> Layout {
    Layout::auto_from_plots(plots)
        .with_x_axis_min(-extent)
        .with_x_axis_max(extent)
        .with_y_axis_min(-extent)
        .with_y_axis_max(extent)
        .with_equal_aspect()
        .with_box_axes()
        .with_show_grid(false)
}

/// Entries of the legend in order, without the points of their lines.
fn legend(curve: &Curve, name: &str) -> Vec<Plot> {
    let mut plots: Vec<Plot> = vec![tip().with_legend(name).into()];
    for (circle, dash) in curve.circles.iter().zip(&DASHES) {
        let named = bound().with_legend(circle.bound.to_string());
        plots.push(named.with_line_style(dash.style.clone()).into());
    }
    let start_name = if curve.circles.is_empty() { "start" } else { "start, direction" };
    plots.push(start().with_legend(start_name).into());
    plots
}

/// Head of an arrow on the curve, near its start; none where the curve is a point.
fn arrow(curve: &Curve, scale: f64) -> Option<Plot> {
    let size = 0.035 * extent(curve, scale);
    let places: Vec<[f64; 2]> = curve.points.iter().map(|point| point.map(|x| x / scale)).collect();
    let first = places.first()?;
    let away = |place: &[f64; 2]| (place[0] - first[0]).hypot(place[1] - first[1]) > 2.5 * size;
    let tip = places.iter().position(away)?;
    let ([x, y], [from_x, from_y]) = (places[tip], places[tip - 1]);
    let angle = (y - from_y).atan2(x - from_x);
    let arm = |turn: f64| (x + size * (angle + turn).cos(), y + size * (angle + turn).sin());
    Some(
        LinePlot::new()
            .with_color(START)
            .with_stroke_width(1.7)
            .with_data([arm(2.7), (x, y), arm(-2.7)])
            .into(),
    )
}

/// Circles, then the curve, then its start, each drawn over the one before; lengths in units of `scale`.
pub(crate) fn lines(curve: &Curve, scale: f64) -> Vec<Plot> {
    let place = |&[x, y]: &[f64; 2]| (x / scale, y / scale);
    let mut plots: Vec<Plot> = Vec::new();
    for (circle, dash) in curve.circles.iter().zip(&DASHES) {
        plots.extend(arcs(circle.radius / scale, dash).map(|arc| bound().with_data(arc).into()));
    }
    plots.push(tip().with_data(curve.points.iter().map(place)).into());
    plots.push(start().with_data(curve.points.first().map(place)).into());
    plots.extend(arrow(curve, scale));
    plots
}

fn tip() -> LinePlot {
    LinePlot::new().with_color(CURVE).with_stroke_width(1.7)
}

fn start() -> ScatterPlot {
    ScatterPlot::new().with_color(START).with_size(4.0)
}

fn bound() -> LinePlot {
    LinePlot::new().with_color(BOUND).with_stroke_width(1.1)
}

/// Style of a circle: a complete line, or arcs with gaps between them (the raster output has no dashes along a curve).
struct Dash {
    style: LineStyle,
    arcs: u32,
    /// Length of an arc, as a share of the distance from one arc to the next.
    share: f64,
}

const DASHES: [Dash; 3] = [
    Dash { style: LineStyle::Solid, arcs: 1, share: 1.0 },
    Dash { style: LineStyle::Dashed, arcs: 72, share: 0.6 },
    Dash { style: LineStyle::Dotted, arcs: 180, share: 0.25 },
];

fn arcs(radius: f64, dash: &Dash) -> impl Iterator<Item = Vec<(f64, f64)>> {
    let Dash { arcs, share, .. } = *dash;
    let corners = 720 / arcs;
    (0..arcs).map(move |arc| {
        let corner = |i: u32| {
            let part = f64::from(arc) + share * f64::from(i) / f64::from(corners);
            let angle = 2.0 * PI * part / f64::from(arcs);
            (radius * angle.cos(), radius * angle.sin())
        };
        (0..=corners).map(corner).collect()
    })
}

/// Half the width of the picture, which contains all points, circles and a margin, in units of `scale`.
pub(crate) fn extent(curve: &Curve, scale: f64) -> f64 {
    let points = curve.points.iter().map(|[x, y]| x.hypot(*y));
    let largest = curve.circles.iter().map(|circle| circle.radius).chain(points).fold(0.0, f64::max);
    1.18 * if largest > 0.0 { largest / scale } else { 1.0 }
}
