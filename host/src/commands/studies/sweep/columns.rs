//! Columns of a sweep, and what is computed of a motion for them.

use crate::motion::constants::CONSTANTS;
use crate::motion::ephemeris::{AnyEphemeris, approximate, smallest_ephemeris};
use crate::motion::propagate::Sample;
use crate::motion::quantity::Quantity;
use crate::motion::{Scalar, spread_times};
use crate::output::text;
use clap::ValueEnum;
use serde_json::Value;
use std::cell::OnceCell;
use std::str::FromStr;
use toytop::Motion;
use toytop_model::constants::MotionConstants;

/// Column of a sweep, or the columns of a quantity at every time.
#[derive(Clone, Copy)]
pub enum Column {
    /// Constant of the motion, by its name and function.
    Constant(&'static str, fn(&MotionConstants) -> Value),
    /// Figure of the motion's tables, by its name and function.
    Figure(&'static str, fn(&Measured) -> Value),
    /// Quantity of a sample, at every time.
    Sample(Quantity),
}

/// Figure of a motion's tables: its name and its value; null where there is no table.
type Figure = (&'static str, fn(&Measured) -> Value);

/// Figures of the tables of a motion over the times: greatest error of the f32 ephemeris against the f64 ephemeris, rad; error bound
/// that the f32 ephemeris states, rad; segments of the f32 table.
const FIGURES: [Figure; 3] = [
    ("error_f32", |motion| {
        motion.single().and_then(|single| motion.double().map(|double| single.error(double))).into()
    }),
    ("bound_f32", |motion| motion.single().map(|single| single.bound).into()),
    ("segments_f32", |motion| motion.single().map(|single| single.segments).into()),
];

/// Columns without the option.
pub const DEFAULT_COLUMNS: &str = "regime,tip_class,period,phi_per_period,min_normal_force";

impl FromStr for Column {
    type Err = String;

    fn from_str(name: &str) -> Result<Self, String> {
        let constants = CONSTANTS.map(|(name, _, value)| (name, Self::Constant(name, value)));
        let figures = FIGURES.map(|(name, value)| (name, Self::Figure(name, value)));
        let named = constants.into_iter().chain(figures).find(|(known, _)| *known == name);
        let sample = || Quantity::from_str(name, false).ok().map(Self::Sample);
        named.map(|(_, column)| column).or_else(sample).ok_or_else(|| {
            let (constants, figures) = (constants.map(|(name, _)| name), figures.map(|(name, _)| name));
            let (constants, figures) = (constants.join(", "), figures.join(", "));
            format!("must be a column of toytop state, {constants}, {figures}")
        })
    }
}

impl Column {
    /// Names in the header.
    pub fn names(self, times: u32) -> Vec<String> {
        match self {
            Self::Constant(name, _) | Self::Figure(name, _) => vec![name.to_owned()],
            Self::Sample(quantity) => {
                let at = |time| quantity.names().1.iter().map(move |part| format!("{part}_{time}"));
                (1..=times).flat_map(at).collect()
            }
        }
    }

    /// Fields of a motion, or of numbers that the scenario refuses; an absent value is an empty field. A number has the shortest decimal
    /// that reads back the same `f64`.
    pub fn fields(self, motion: Option<&Measured>, times: u32) -> Vec<String> {
        let number = |x: f64| if x.is_nan() { String::new() } else { format!("{x:?}") };
        let absent = || vec![String::new(); self.names(times).len()];
        let value = match (self, motion) {
            (Self::Constant(_, value), Some(motion)) => value(&motion.motion),
            (Self::Figure(_, value), Some(motion)) => value(motion),
            (Self::Constant("regime", _), None) => "refused".into(),
            (Self::Sample(quantity), Some(motion)) => match motion.double() {
                Some(table) => {
                    let numbers = table.samples.iter().flat_map(|sample| quantity.numbers(sample));
                    return numbers.map(number).collect();
                }
                None => return absent(),
            },
            _ => return absent(),
        };
        vec![text(&value, number).unwrap_or_default()]
    }
}

/// Motion of a row, with its tables as far as columns need them.
pub struct Measured {
    motion: MotionConstants,
    times: Vec<f64>,
    double: OnceCell<Option<Evaluated>>,
    single: OnceCell<Option<Evaluated>>,
}

/// Samples of an ephemeris at the times.
struct Evaluated {
    samples: Vec<Sample>,
    segments: usize,
    /// Error bound at t = 0, rad; the part per tick is negligible below millions of periods.
    bound: f64,
}

impl Evaluated {
    /// Greatest distance of the orientations of two tables, rad.
    fn error(&self, truth: &Self) -> f64 {
        let pairs = self.samples.iter().zip(&truth.samples);
        pairs.map(|(x, y)| x.orientation().distance(&y.orientation())).fold(0.0, f64::max)
    }
}

impl Measured {
    /// Motion with `count` times spread over this many periods.
    pub fn new(motion: Motion, count: u32, periods: f64) -> Self {
        let motion = MotionConstants::new(motion);
        let times = spread_times(periods * motion.nutation_period(), count);
        Self { motion, times, double: OnceCell::new(), single: OnceCell::new() }
    }

    fn evaluated(&self, table: &dyn AnyEphemeris) -> Evaluated {
        let samples = self.times.iter().map(|&t| table.at(t).sample).collect();
        Evaluated { samples, segments: table.size()[0], bound: table.error_bound().constant }
    }

    fn double(&self) -> Option<&Evaluated> {
        /// Truncation error, rad.
        const WITHIN: f64 = 1e-13;
        let table = || approximate(&self.motion, WITHIN).ok().map(|table| self.evaluated(&*table));
        self.double.get_or_init(table).as_ref()
    }

    fn single(&self) -> Option<&Evaluated> {
        let table =
            || smallest_ephemeris(Scalar::F32, &self.motion).ok().map(|table| self.evaluated(&*table));
        self.single.get_or_init(table).as_ref()
    }
}
