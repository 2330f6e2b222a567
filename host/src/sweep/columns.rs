//! Columns of a sweep, and what is computed of a motion for them.

use crate::constants;
use crate::full_equations::solution;
use crate::input::scenario::{Scenario, Units};
use crate::motion::Scalar;
use crate::motion::ephemeris::{AnyScalar, approximate, smallest};
use crate::motion::propagate::Sample;
use crate::output::text;
use crate::samples::column::Column as Quantity;
use crate::samples::spread_times;
use clap::ValueEnum;
use std::cell::OnceCell;
use std::str::FromStr;
use toytop::{Motion, Orientation};
use toytop_page::constants::MotionConstants;

/// Column of a sweep, or the columns of a quantity at every time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Column {
    /// Constant of the motion, by its name.
    Constant(&'static str),
    /// Quantity of a sample, at every time.
    Sample(Quantity),
    /// Property of the tables of the motion.
    Table(Figure),
}

/// Property of the tables of a motion over the times.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
#[value(rename_all = "snake_case")]
pub enum Figure {
    /// Greatest error of the f32 ephemeris against the f64 ephemeris, rad
    ErrorF32,
    /// Error bound that the f32 ephemeris states, rad
    BoundF32,
    /// Segments of the f32 table
    SegmentsF32,
    /// Greatest error of the f64 ephemeris against the full solver, rad
    FullErrorF64,
    /// Greatest error of the f32 ephemeris against the full solver, rad
    FullErrorF32,
}

/// Columns without the option.
pub const DEFAULT_COLUMNS: &str = "regime,tip_class,period,phi_per_period,min_normal_force";

impl FromStr for Column {
    type Err = String;

    fn from_str(name: &str) -> Result<Self, String> {
        let constant = constants::ALL.iter().find(|(known, _)| *known == name);
        let constant = constant.map(|(name, _)| Self::Constant(name));
        let sample = || Quantity::from_str(name, false).ok().map(Self::Sample);
        let figure = || Figure::from_str(name, false).ok().map(Self::Table);
        constant.or_else(sample).or_else(figure).ok_or_else(|| {
            let constants = constants::ALL.map(|(name, _)| name).join(", ");
            let figures: Vec<_> = Figure::value_variants().iter().map(|figure| name_of(*figure)).collect();
            format!("must be a column of toytop state, {constants}, {}", figures.join(", "))
        })
    }
}

fn name_of(figure: Figure) -> String {
    figure.to_possible_value().map(|value| value.get_name().to_owned()).unwrap_or_default()
}

impl Column {
    /// Names in the header.
    pub(super) fn header(self, times: u32) -> Vec<String> {
        match self {
            Self::Constant(name) => vec![name.to_owned()],
            Self::Table(figure) => vec![name_of(figure)],
            Self::Sample(quantity) => {
                let at = |time| quantity.names().1.iter().map(move |part| format!("{part}_{time}"));
                (1..=times).flat_map(at).collect()
            }
        }
    }

    /// Fields of a row whose numbers the scenario refuses.
    pub(super) fn refused(self, times: u32) -> Vec<String> {
        match self {
            Self::Constant("regime") => vec!["refused".to_owned()],
            _ => vec![String::new(); self.header(times).len()],
        }
    }
}

/// Motion of a row, with its tables and the full solver as far as columns need them.
pub(super) struct Measured {
    motion: MotionConstants,
    times: Vec<f64>,
    double: OnceCell<Option<Run>>,
    single: OnceCell<Option<Run>>,
    full: OnceCell<Option<Vec<Orientation<f64>>>>,
}

/// Values of an ephemeris at the times.
struct Run {
    samples: Vec<Sample>,
    segments: usize,
    /// Error bound at t = 0, rad; the part per tick is negligible below millions of periods.
    bound: f64,
}

impl Run {
    /// Greatest distance from the truth, rad.
    fn error(&self, truth: impl IntoIterator<Item = Orientation<f64>>) -> f64 {
        let pairs = self.samples.iter().zip(truth);
        pairs.map(|(sample, truth)| sample.orientation().distance(&truth)).fold(0.0, f64::max)
    }
}

impl Measured {
    /// Motion with `count` times spread over this many periods.
    pub(super) fn new(motion: Motion, count: u32, periods: f64) -> Self {
        let motion = MotionConstants::new(motion);
        let times = spread_times(periods * motion.nutation_period(), count);
        let (double, single, full) = (OnceCell::new(), OnceCell::new(), OnceCell::new());
        Self { motion, times, double, single, full }
    }

    fn run(&self, table: &dyn AnyScalar) -> Run {
        let samples = self.times.iter().map(|&t| table.at(t).sample).collect();
        Run { samples, segments: table.size()[0], bound: table.error_bound().constant }
    }

    fn double(&self) -> Option<&Run> {
        /// Truncation error, rad.
        const WITHIN: f64 = 1e-13;
        let table = || approximate(&self.motion, WITHIN).ok();
        self.double.get_or_init(|| table().map(|table| self.run(&*table))).as_ref()
    }

    fn single(&self) -> Option<&Run> {
        let table = || smallest(Scalar::F32, &self.motion).ok();
        self.single.get_or_init(|| table().map(|table| self.run(&*table))).as_ref()
    }

    fn full(&self) -> Option<&Vec<Orientation<f64>>> {
        let solved = || {
            let scenario =
                Scenario { name: String::new(), motion: *self.motion, given: None, units: Units::None };
            let states = solution::states(&scenario, &self.times).ok()?;
            Some(states.iter().map(solution::phi).collect())
        };
        self.full.get_or_init(solved).as_ref()
    }

    /// Fields of a column; an absent value is an empty field. A number has the shortest decimal that reads back the same `f64`.
    pub(super) fn fields(&self, column: Column) -> Vec<String> {
        let number = |x: f64| if x.is_nan() { String::new() } else { format!("{x:?}") };
        match column {
            Column::Constant(name) => {
                vec![text(&constants::value(&self.motion, name), number).unwrap_or_default()]
            }
            Column::Sample(quantity) => {
                let Some(run) = self.double() else { return column.refused(self.times.len() as u32) };
                run.samples.iter().flat_map(|sample| quantity.numbers(sample)).map(number).collect()
            }
            Column::Table(Figure::SegmentsF32) => {
                vec![self.single().map(|run| run.segments.to_string()).unwrap_or_default()]
            }
            Column::Table(figure) => vec![number(self.figure(figure).unwrap_or(f64::NAN))],
        }
    }

    fn figure(&self, figure: Figure) -> Option<f64> {
        Some(match figure {
            Figure::BoundF32 | Figure::SegmentsF32 => self.single()?.bound,
            Figure::ErrorF32 => self.single()?.error(self.double()?.samples.iter().map(Sample::orientation)),
            Figure::FullErrorF64 => self.double()?.error(self.full()?.iter().copied()),
            Figure::FullErrorF32 => self.single()?.error(self.full()?.iter().copied()),
        })
    }
}
