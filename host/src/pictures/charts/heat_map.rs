//! Heat map of one column of a sweep over two of its axes.

use crate::Failure;
use crate::commands::studies::sweep::Sweep;
use crate::input::axis::Axis;
use crate::pictures::drawing::text;
use kuva::plot::colormap::ColorMap;
use kuva::plot::heatmap::Heatmap;
use kuva::render::layout::Layout;
use kuva::render::plots::Plot;
use kuva::render::render::{Scene, TextAnchor, render_multiple};
use std::sync::Arc;

/// Choice of a heat map: the key along x, the key along y, and the column shown.
pub struct HeatMap {
    names: [String; 3],
    axes: [Axis; 2],
}

/// Colour of a cell without a value.
const ABSENT: &str = "#c8c8c8";

impl HeatMap {
    /// Heat map of `X,Y,COLUMN` over the grid of a scenario.
    ///
    /// # Errors
    /// [`Failure::Input`]: there is no such key or column, or one of the keys has no grid of even steps.
    pub fn new(text: &str, sweep: &Sweep) -> Result<Self, Failure> {
        let refuse = |reason: &str| Failure::Input(format!("--plot: {text}: {reason}"));
        let names: Vec<_> =
            text.split(',').map(|name| if name == "tilt" { "tilt_deg" } else { name }).collect();
        let &[x, y, column] = &names[..] else { return Err(refuse("must be X,Y,COLUMN")) };
        let axis = |name: &str| match sweep.axis(name) {
            Some(axis) if axis.is_grid() => Ok(axis.clone()),
            _ => Err(refuse(&format!("{name}: must be a key that varies as LOW..HIGH/PLACES"))),
        };
        let axes = [axis(x)?, axis(y)?];
        if x == y || !sweep.header().trim_end().split(',').any(|name| name == column) {
            return Err(refuse(&format!("{column}: must be one of the table's columns, and X not Y")));
        }
        Ok(Self { names: [x, y, column].map(str::to_owned), axes })
    }

    /// Draws the rows of the table of a sweep. If several rows have the same X and Y, the first is drawn.
    ///
    /// # Errors
    /// [`Failure::Input`]: the column contains no numbers.
    pub fn draw(&self, sweep: &Sweep, csv: &str) -> Result<Scene, Failure> {
        let [x_name, y_name, column] = &self.names;
        let refuse = |reason: &str| Failure::Input(format!("--plot: {column}: {reason}"));
        let mut reader = csv::Reader::from_reader(csv.as_bytes());
        let header = reader.headers().map_err(|error| refuse(&error.to_string()))?;
        let place = header.iter().position(|name| name == column).ok_or_else(|| refuse("missing"))?;
        let [width, height] = [x_name, y_name].map(|name| sweep.axis(name).map_or(1, Axis::size) as usize);
        let mut cells = vec![vec![f64::NAN; width]; height];
        for record in reader.records() {
            let record = record.map_err(|error| refuse(&error.to_string()))?;
            let index = record.get(0).and_then(|index| index.parse().ok());
            let at = |name: &str| Some(sweep.place(name, index?)? as usize);
            let number = record.get(place).and_then(|text| text.parse::<f64>().ok());
            if let (Some(i), Some(j), Some(number)) = (at(x_name), at(y_name), number)
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
        let [x_name, y_name, column] = &self.names;
        let color =
            |share: f64| if share.is_nan() { ABSENT.to_owned() } else { ColorMap::Viridis.map(share) };
        let absent = cells.iter().flatten().any(|cell| cell.is_nan());
        let [x, y] = self.axes.clone().map(|axis| axis.drawn_ends());
        let map = Heatmap::new()
            .with_data(cells)
            .with_color_map(ColorMap::Custom(Arc::new(color)))
            .with_x_range(x[0], x[1])
            .with_y_range(y[0], y[1])
            .with_cell_size(1.0);
        let plots: Vec<Plot> = vec![map.into()];
        let label = |name: &str, axis: &Axis| {
            let name = named(name);
            if axis.is_log() { format!("log₁₀ of {name}") } else { name }
        };
        let layout = Layout::auto_from_plots(&plots)
            .with_width(820.0)
            .with_height(620.0)
            .with_force_margins_y(92.0, 62.0)
            .with_title(named(column))
            .with_title_size(18)
            .with_x_label(label(x_name, &self.axes[0]))
            .with_x_axis_min(x[0])
            .with_x_axis_max(x[1])
            .with_y_axis_min(y[0])
            .with_y_axis_max(y[1])
            .with_show_grid(false)
            .with_box_axes();
        let mut scene = render_multiple(plots, layout);
        let y_label = label(y_name, &self.axes[1]);
        text(&mut scene, &y_label, [16.0, 76.0], 14, TextAnchor::Start, "black");
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
