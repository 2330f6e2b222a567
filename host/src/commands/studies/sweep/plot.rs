//! Heat map of one column of a sweep over two of its axes.

use super::table::Sweep;
use crate::Failure;
use crate::input::axis::Axis;
use crate::pictures::heat_map;
use kuva::render::render::Scene;

/// Choice of a heat map: the keys along x and y, with their axes, and the column shown.
pub struct HeatMap<'a> {
    keys: [(String, &'a Axis); 2],
    column: String,
}

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
        Ok(heat_map::picture(&self.keys, &self.column, cells))
    }
}
