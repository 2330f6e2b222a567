//! Heat map of a quantity over two axes.

use super::drawing::{frame, label_above, text};
use crate::input::axis::Axis;
use kuva::plot::colormap::ColorMap;
use kuva::plot::heatmap::Heatmap;
use kuva::render::plots::Plot;
use kuva::render::render::{Scene, TextAnchor, render_multiple};
use std::sync::Arc;

/// Colour of a cell without a value.
const ABSENT: &str = "#c8c8c8";

/// Picture of a heat map.
///
/// * `keys`: names and axes along x and y
/// * `column`: name of the quantity shown
/// * `cells`: values by the places on the axes, those of one y in one list; NaN where there is none
pub fn picture(keys: &[(String, &Axis); 2], column: &str, cells: Vec<Vec<f64>>) -> Scene {
    let color = |share: f64| if share.is_nan() { ABSENT.to_owned() } else { ColorMap::Viridis.map(share) };
    let absent = cells.iter().flatten().any(|cell| cell.is_nan());
    let [x, y] = [0, 1].map(|key| keys[key].1.drawn_ends());
    let map = Heatmap::new()
        .with_data(cells)
        .with_color_map(ColorMap::Custom(Arc::new(color)))
        .with_x_range(x[0], x[1])
        .with_y_range(y[0], y[1])
        .with_cell_size(1.0);
    let plots: Vec<Plot> = vec![map.into()];
    let [x_label, y_label] = keys
        .each_ref()
        .map(|(name, axis)| if axis.is_log() { format!("log₁₀ of {}", named(name)) } else { named(name) });
    let layout = frame(&plots, &named(column), &x_label, [x, y])
        .with_width(820.0)
        .with_height(620.0)
        .with_force_margins_y(92.0, 62.0)
        .with_show_grid(false);
    let mut scene = render_multiple(plots, layout);
    label_above(&mut scene, &y_label, [16.0, 76.0]);
    if absent {
        text(&mut scene, "grey: no value", [16.0, 606.0], 12, TextAnchor::Start, "black");
    }
    scene
}

/// Name of a key or a column, with its unit in SI.
fn named(name: &str) -> String {
    let unit = match name {
        "spin" | "precession" | "nutation" => ", rad/s",
        "period" => ", s",
        "phi_per_period" => ", rad",
        "min_normal_force" => ", weights",
        "mass" => ", kg",
        "mass_moment" => ", kg m",
        "com_height" => ", m",
        "transverse_inertia" | "axial_inertia" => ", kg m²",
        "gravity" => ", m/s²",
        _ => "",
    };
    match name.strip_suffix("_deg") {
        Some(angle) => format!("{angle}, degrees"),
        None => name.replace('_', " ") + unit,
    }
}
