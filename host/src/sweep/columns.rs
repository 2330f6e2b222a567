//! Columns of a sweep, and what is computed of a motion for them.

use crate::commands::motion::constants;
use crate::full_equations;
use crate::input::scenario::{Scenario, Units};
use crate::motion::Scalar;
use crate::motion::ephemeris::{AnyEphemeris, approximate, smallest};
use crate::motion::propagate::Sample;
use crate::output::text;
use crate::samples::column::Column as Quantity;
use crate::samples::spread_times;
use clap::ValueEnum;
use serde_json::Value;
use std::cell::OnceCell;
use std::str::FromStr;
use toytop::{Motion, Orientation};
use toytop_model::constants::MotionConstants;

/// Column of a sweep, or the columns of a quantity at every time.
#[derive(Clone, Copy)]
pub enum Column {
    /// Constant of the motion or figure of its tables, by its name.
    Named(&'static str),
    /// Quantity of a sample, at every time.
    Sample(Quantity),
}

/// Figures of the tables of a motion over the times: greatest error of the f32 ephemeris against the f64 ephemeris, rad; error bound
/// that the f32 ephemeris states, rad; segments of the f32 table; greatest errors of both against the full solver, rad.
const FIGURES: [&str; 5] = ["error_f32", "bound_f32", "segments_f32", "full_error_f64", "full_error_f32"];

/// Columns without the option.
pub const DEFAULT_COLUMNS: &str = "regime,tip_class,period,phi_per_period,min_normal_force";

impl FromStr for Column {
    type Err = String;

    fn from_str(name: &str) -> Result<Self, String> {
        let constants = constants::ALL.map(|(name, _)| name);
        let mut named = constants.into_iter().chain(FIGURES);
        let named = named.find(|known| *known == name).map(Self::Named);
        let sample = || Quantity::from_str(name, false).ok().map(Self::Sample);
        named.or_else(sample).ok_or_else(|| {
            let (constants, figures) = (constants.join(", "), FIGURES.join(", "));
            format!("must be a column of toytop state, {constants}, {figures}")
        })
    }
}

impl Column {
    /// Names in the header.
    pub fn header(self, times: u32) -> Vec<String> {
        match self {
            Self::Named(name) => vec![name.to_owned()],
            Self::Sample(quantity) => {
                let at = |time| quantity.names().1.iter().map(move |part| format!("{part}_{time}"));
                (1..=times).flat_map(at).collect()
            }
        }
    }

    /// Fields of a row whose numbers the scenario refuses.
    pub fn refused(self, times: u32) -> Vec<String> {
        match self {
            Self::Named("regime") => vec!["refused".to_owned()],
            _ => vec![String::new(); self.header(times).len()],
        }
    }
}

/// Motion of a row, with its tables and the full solver as far as columns need them.
pub struct Measured {
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
    pub fn new(motion: Motion, count: u32, periods: f64) -> Self {
        let motion = MotionConstants::new(motion);
        let times = spread_times(periods * motion.nutation_period(), count);
        let (double, single, full) = (OnceCell::new(), OnceCell::new(), OnceCell::new());
        Self { motion, times, double, single, full }
    }

    fn run(&self, table: &dyn AnyEphemeris) -> Run {
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
            let states = full_equations::states(&scenario, &self.times).ok()?;
            Some(states.iter().map(|state| state.orientation()).collect())
        };
        self.full.get_or_init(solved).as_ref()
    }

    /// Fields of a column; an absent value is an empty field. A number has the shortest decimal that reads back the same `f64`.
    pub fn fields(&self, column: Column) -> Vec<String> {
        let number = |x: f64| if x.is_nan() { String::new() } else { format!("{x:?}") };
        match column {
            Column::Named(name) => vec![text(&self.value(name), number).unwrap_or_default()],
            Column::Sample(quantity) => {
                let Some(run) = self.double() else { return column.refused(self.times.len() as u32) };
                run.samples.iter().flat_map(|sample| quantity.numbers(sample)).map(number).collect()
            }
        }
    }

    fn value(&self, name: &str) -> Value {
        let exact = || self.double().map(|run| run.samples.iter().map(Sample::orientation));
        let against_full = |run: Option<&Run>| Some(run?.error(self.full()?.iter().copied()));
        match name {
            "error_f32" => self.single().zip(exact()).map(|(run, exact)| run.error(exact)).into(),
            "bound_f32" => self.single().map(|run| run.bound).into(),
            "segments_f32" => self.single().map(|run| run.segments).into(),
            "full_error_f64" => against_full(self.double()).into(),
            "full_error_f32" => against_full(self.single()).into(),
            _ => constants::value(&self.motion, name),
        }
    }
}
