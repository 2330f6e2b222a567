//! Columns of a sweep, and what is computed of a motion for them.

use crate::input::times::spread_times;
use crate::motion::column::SampleColumn;
use crate::motion::ephemeris::{DynEphemeris, ephemeris_with_truncation, smallest_ephemeris};
use crate::motion::errors::greater;
use crate::motion::{Scalar, value};
use clap::ValueEnum;
use serde_json::Value;
use std::cell::OnceCell;
use std::str::FromStr;
use toytop::Motion;
use toytop_model::constants::{CONSTANTS, Constant, MotionConstants};

/// Column of a sweep.
#[derive(Clone, Copy)]
pub enum SweepColumn {
    /// Constant of the motion.
    Constant(&'static Constant),
    /// Property of the motion's tables.
    Table(TableColumn),
    /// Column of samples, at every time.
    Sample(SampleColumn),
}

/// Column of a motion's tables: its name and its value; null where there is no table.
type TableColumn = (&'static str, fn(&RowMotion) -> Option<Value>);

/// Columns of the tables: greatest error of the f32 ephemeris against the f64 ephemeris, rad; bound that the f32 ephemeris states at t = 0,
/// rad (its part per tick is negligible below millions of periods); number of segments of the f32 ephemeris.
const TABLE_COLUMNS: [TableColumn; 3] = [
    ("error_f32", |motion| motion.error_f32().map(Value::from)),
    ("bound_f32", |motion| Some(motion.f32_table()?.error_bound().constant.into())),
    ("segments_f32", |motion| Some(motion.f32_table()?.size()[0].into())),
];

/// Columns without the option.
pub const DEFAULT_COLUMNS: &str = "regime,tip_class,period,phi_per_period,min_normal_force";

impl FromStr for SweepColumn {
    type Err = String;

    fn from_str(name: &str) -> Result<Self, String> {
        let constants = CONSTANTS.iter().map(|constant| (constant.name, Self::Constant(constant)));
        let named = constants.chain(TABLE_COLUMNS.map(|column| (column.0, Self::Table(column))));
        let sample = || SampleColumn::from_str(name, false).ok().map(Self::Sample);
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
            Self::Table((name, _)) => vec![name.to_owned()],
            Self::Sample(column) => {
                let at = |time| column.names().iter().map(move |part| format!("{part}_{time}"));
                (1..=times).flat_map(at).collect()
            }
        }
    }

    /// Values of a motion, or of numbers that the scenario refuses.
    pub fn values(self, motion: Option<&RowMotion>, times: u32) -> Vec<Value> {
        match (self, motion) {
            (Self::Constant(constant), Some(motion)) => vec![value(constant, &motion.motion)],
            (Self::Table((_, value)), Some(motion)) => vec![value(motion).into()],
            (Self::Constant(Constant { name: "regime", .. }), None) => vec!["refused".into()],
            (Self::Sample(column), Some(motion)) => match motion.f64_table() {
                Some(table) => {
                    let mut numbers = vec![f64::NAN; column.names().len() * motion.times.len()];
                    table.fill(column, &motion.times, &mut numbers);
                    numbers.into_iter().map(Value::from).collect()
                }
                None => vec![Value::Null; self.names(times).len()],
            },
            _ => vec![Value::Null; self.names(times).len()],
        }
    }
}

/// Motion of a row, with its tables as far as columns need them.
pub struct RowMotion {
    motion: MotionConstants,
    times: Vec<f64>,
    f64_table: OnceCell<Option<Box<dyn DynEphemeris>>>,
    f32_table: OnceCell<Option<Box<dyn DynEphemeris>>>,
}

impl RowMotion {
    /// Motion with `count` times spread over this many periods.
    pub fn new(motion: Motion, count: u32, periods: f64) -> Self {
        let motion = MotionConstants::new(motion);
        let times = spread_times(periods * motion.period_or_natural_time(), count);
        Self { motion, times, f64_table: OnceCell::new(), f32_table: OnceCell::new() }
    }

    fn f64_table(&self) -> Option<&dyn DynEphemeris> {
        /// Truncation error, rad.
        const WITHIN: f64 = 1e-13;
        self.f64_table.get_or_init(|| ephemeris_with_truncation(&self.motion, WITHIN).ok()).as_deref()
    }

    fn f32_table(&self) -> Option<&dyn DynEphemeris> {
        self.f32_table.get_or_init(|| smallest_ephemeris(Scalar::F32, &self.motion).ok()).as_deref()
    }

    fn error_f32(&self) -> Option<f64> {
        let (table, exact) = (self.f32_table()?, self.f64_table()?);
        let error = |&t: &f64| table.at(t).pose.orientation.distance(&exact.at(t).pose.orientation);
        Some(self.times.iter().map(error).fold(0.0, greater))
    }
}
