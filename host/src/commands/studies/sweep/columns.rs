//! Columns of a sweep, and what is computed of a motion for them.

use crate::input::times::spread_times;
use crate::motion::ephemeris::{AnyEphemeris, approximate, smallest_ephemeris};
use crate::motion::propagate::Sample;
use crate::motion::quantity::Quantity;
use crate::motion::{Scalar, value};
use clap::ValueEnum;
use serde_json::Value;
use std::cell::OnceCell;
use std::str::FromStr;
use toytop::Motion;
use toytop_model::constants::{CONSTANTS, Constant, MotionConstants};

/// Column of a sweep, or the columns of a quantity at every time.
#[derive(Clone, Copy)]
pub enum SweepColumn {
    /// Constant of the motion.
    Constant(&'static Constant),
    /// Measurement of the motion's tables, by its name and function.
    Measured(&'static str, fn(&Measured) -> Value),
    /// Quantity of a sample, at every time.
    Sample(Quantity),
}

/// Column of a motion's tables: its name and its value; null where there is no table.
type MeasuredColumn = (&'static str, fn(&Measured) -> Value);

/// Columns of the tables: greatest error of the f32 ephemeris against the f64 ephemeris, rad; bound that the f32 ephemeris states, rad; its
/// number of segments.
const MEASURED: [MeasuredColumn; 3] = [
    ("error_f32", |motion| {
        motion.f32_table().and_then(|table| motion.f64_table().map(|exact| table.error(exact))).into()
    }),
    ("bound_f32", |motion| motion.f32_table().map(|table| table.bound).into()),
    ("segments_f32", |motion| motion.f32_table().map(|table| table.segments).into()),
];

/// Columns without the option.
pub const DEFAULT_COLUMNS: &str = "regime,tip_class,period,phi_per_period,min_normal_force";

impl FromStr for SweepColumn {
    type Err = String;

    fn from_str(name: &str) -> Result<Self, String> {
        let constants = CONSTANTS.iter().map(|constant| (constant.name, Self::Constant(constant)));
        let named = constants.chain(MEASURED.map(|(name, value)| (name, Self::Measured(name, value))));
        let sample = || Quantity::from_str(name, false).ok().map(Self::Sample);
        let known = named.clone().find(|(known, _)| *known == name).map(|(_, column)| column);
        known.or_else(sample).ok_or_else(|| {
            let names: Vec<_> = named.map(|(name, _)| name).collect();
            format!("must be a column of toytop state, {}", names.join(", "))
        })
    }
}

impl SweepColumn {
    /// Names in the header.
    pub fn names(self, times: u32) -> Vec<String> {
        match self {
            Self::Constant(Constant { name, .. }) => vec![(*name).to_owned()],
            Self::Measured(name, _) => vec![name.to_owned()],
            Self::Sample(quantity) => {
                let at = |time| quantity.names().1.iter().map(move |part| format!("{part}_{time}"));
                (1..=times).flat_map(at).collect()
            }
        }
    }

    /// Values of a motion, or of numbers that the scenario refuses.
    pub fn values(self, motion: Option<&Measured>, times: u32) -> Vec<Value> {
        match (self, motion) {
            (Self::Constant(constant), Some(motion)) => vec![value(constant, &motion.motion)],
            (Self::Measured(_, value), Some(motion)) => vec![value(motion)],
            (Self::Constant(Constant { name: "regime", .. }), None) => vec!["refused".into()],
            (Self::Sample(quantity), Some(motion)) => match motion.f64_table() {
                Some(table) => {
                    let numbers = table.samples.iter().flat_map(|sample| quantity.numbers(sample));
                    numbers.map(Value::from).collect()
                }
                None => vec![Value::Null; self.names(times).len()],
            },
            _ => vec![Value::Null; self.names(times).len()],
        }
    }
}

/// Motion of a row, with its tables as far as columns need them.
pub struct Measured {
    motion: MotionConstants,
    times: Vec<f64>,
    f64_table: OnceCell<Option<TableSamples>>,
    f32_table: OnceCell<Option<TableSamples>>,
}

/// Samples of an ephemeris at the times.
struct TableSamples {
    samples: Vec<Sample>,
    segments: usize,
    /// Error bound at t = 0, rad; the part per tick is negligible below millions of periods.
    bound: f64,
}

impl TableSamples {
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
        Self { motion, times, f64_table: OnceCell::new(), f32_table: OnceCell::new() }
    }

    fn samples_of(&self, table: &dyn AnyEphemeris) -> TableSamples {
        let samples = self.times.iter().map(|&t| table.at(t).sample).collect();
        TableSamples { samples, segments: table.size()[0], bound: table.error_bound().constant }
    }

    fn f64_table(&self) -> Option<&TableSamples> {
        /// Truncation error, rad.
        const WITHIN: f64 = 1e-13;
        let table = || approximate(&self.motion, WITHIN).ok().map(|table| self.samples_of(&*table));
        self.f64_table.get_or_init(table).as_ref()
    }

    fn f32_table(&self) -> Option<&TableSamples> {
        let table =
            || smallest_ephemeris(Scalar::F32, &self.motion).ok().map(|table| self.samples_of(&*table));
        self.f32_table.get_or_init(table).as_ref()
    }
}
