//! Heat map of one column of a sweep over two of its axes.

use super::drawing::{frame, label_above, text};
use crate::Failure;
use crate::commands::studies::sweep::Sweep;
use crate::input::axis::Axis;
use kuva::plot::colormap::ColorMap;
use kuva::plot::heatmap::Heatmap;
use kuva::render::plots::Plot;
use kuva::render::render::{Scene, TextAnchor, render_multiple};
use std::sync::Arc;

/// Choice of a heat map: the keys along x and y, with their axes, and the column shown.
pub struct HeatMap<'a> {
    keys: [(String, &'a Axis); 2],
    column: String,
}

/// Colour of a cell without a value.
const ABSENT: &str = "#c8c8c8";

impl<'a> HeatMap<'a> {
    /// Heat map of `X,Y,COLUMN` over the grid of a scenario.
    ///
    /// # Errors
    /// [`Failure::Input`]: there is no such key or column, or one of the keys has no grid of even steps.
    pub fn new(text: &str, sweep: &'a Sweep) -> Result<Self, Failure> {
        let refuse = |reason: &str| Failure::Input(format!("--plot: {text}: {reason}"));
        let names: Vec<_> =
            text.split(',').map(|name| if name == "tilt" { "tilt_deg" } else { name }).collect();
        let &[x, y, column] = &names[..] else { return Err(refuse("must be X,Y,COLUMN")) };
        let key = |name: &str| match sweep.axis(name) {
            Some(axis) if axis.is_grid() => Ok((name.to_owned(), axis)),
            _ => Err(refuse(&format!("{name}: must be a key that varies as LOW..HIGH/PLACES"))),
        };
        let keys = [key(x)?, key(y)?];
        if x == y || !sweep.header().trim_end().split(',').any(|name| name == column) {
            return Err(refuse(&format!("{column}: must be one of the table's columns, and X not Y")));
        }
        Ok(Self { keys, column: column.to_owned() })
    }

    /// Draws the rows of the table of a sweep. If several rows have the same X and Y, the first is drawn.
    ///
    /// # Errors
    /// [`Failure::Input`]: the column contains no numbers.
    pub fn draw(&self, sweep: &Sweep, csv: &str) -> Result<Scene, Failure> {
        let refuse = |reason: &str| Failure::Input(format!("--plot: {}: {reason}", self.column));
        let mut reader = csv::Reader::from_reader(csv.as_bytes());
        let header = reader.headers().map_err(|error| refuse(&error.to_string()))?;
        let place = header.iter().position(|name| name == self.column).ok_or_else(|| refuse("missing"))?;
        let [(x, across), (y, up)] = &self.keys;
        let mut cells = vec![vec![f64::NAN; across.size() as usize]; up.size() as usize];
        for record in reader.records() {
            let record = record.map_err(|error| refuse(&error.to_string()))?;
            let index = record.get(0).and_then(|index| index.parse().ok());
            let at = |name: &str| Some(sweep.place(name, index?)? as usize);
            let number = record.get(place).and_then(|text| text.parse::<f64>().ok());
            if let (Some(i), Some(j), Some(number)) = (at(x), at(y), number)
                && cells[j][i].is_nan()
            {
                cells[j][i] = number;
            }
        }
        if cells.iter().flatten().all(|cell| cell.is_nan()) {
            return Err(refuse("must be a column of numbers"));
        }
        Ok(self.picture(cells))
    }

    fn picture(&self, cells: Vec<Vec<f64>>) -> Scene {
        let color =
            |share: f64| if share.is_nan() { ABSENT.to_owned() } else { ColorMap::Viridis.map(share) };
        let absent = cells.iter().flatten().any(|cell| cell.is_nan());
        let [x, y] = [0, 1].map(|key| self.keys[key].1.drawn_ends());
        let map = Heatmap::new()
            .with_data(cells)
            .with_color_map(ColorMap::Custom(Arc::new(color)))
            .with_x_range(x[0], x[1])
            .with_y_range(y[0], y[1])
            .with_cell_size(1.0);
        let plots: Vec<Plot> = vec![map.into()];
        let [x_label, y_label] = self.keys.each_ref().map(|(name, axis)| {
            if axis.is_log() { format!("log₁₀ of {}", named(name)) } else { named(name) }
        });
        let layout = frame(&plots, &named(&self.column), &x_label, [x, y])
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
