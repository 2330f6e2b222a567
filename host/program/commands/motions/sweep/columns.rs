//! Columns of a sweep, and what is computed of a motion for them.

use clap::ValueEnum;
use serde_json::Value;
use std::cell::OnceCell;
use std::str::FromStr;
use toytop::TableSettings;
use toytop_host::motion::column::SampleColumn;
use toytop_host::motion::ephemeris::MotionEphemeris;
use toytop_host::motion::errors::greater_or_infinite;
use toytop_host::motion::{Scalar, constant_as_json, spread_times};
use toytop_model::constants::{CONSTANTS, Constant};
use toytop_model::timed_motion::TimedMotion;

/// Column of a sweep.
#[derive(Clone, Copy)]
pub enum SweepColumn {
    /// Constant of the motion.
    Constant(&'static Constant),
    /// Property of the motion's ephemerides.
    Ephemeris(EphemerisColumn),
    /// Column of samples, at every time.
    Sample(SampleColumn),
}

/// Column of a motion's ephemerides: its name and its value; null where there is no ephemeris.
type EphemerisColumn = (&'static str, fn(&RowMotion) -> Option<Value>);

/// Columns of the ephemerides:
///
/// * greatest difference of the orientation between the ephemerides in `f32` and in `f64`, rad
/// * bound on the error of the ephemeris in `f32` at t = 0, rad; its growth is negligible below millions of periods
/// * number of segments of the ephemeris in `f32`
const EPHEMERIS_COLUMNS: [EphemerisColumn; 3] = [
    ("error_f32", |motion| motion.error_f32().map(Value::from)),
    ("bound_f32", |motion| Some(motion.f32_ephemeris()?.error_bound.constant.into())),
    ("segments_f32", |motion| Some(motion.f32_ephemeris()?.segments.into())),
];

/// Columns without the option.
pub const DEFAULT_COLUMNS: &str = "regime,tip_class,period,phi_per_period,min_normal_force";

impl FromStr for SweepColumn {
    type Err = String;

    fn from_str(name: &str) -> Result<Self, String> {
        let constants = CONSTANTS.iter().map(|constant| (constant.name, Self::Constant(constant)));
        let named = constants.chain(EPHEMERIS_COLUMNS.map(|column| (column.0, Self::Ephemeris(column))));
        let sample = || SampleColumn::from_str(name, false).ok().map(Self::Sample);
        let constant = named.clone().find(|(other, _)| *other == name).map(|(_, column)| column);
        constant.or_else(sample).ok_or_else(|| {
            let names: Vec<_> = named.map(|(name, _)| name).collect();
            format!("must be a column of toytop state or one of {}", names.join(", "))
        })
    }
}

impl SweepColumn {
    /// Names in the header.
    pub fn names(self, times: u32) -> Vec<String> {
        match self {
            Self::Constant(Constant { name, .. }) => vec![(*name).to_owned()],
            Self::Ephemeris((name, _)) => vec![name.to_owned()],
            Self::Sample(column) => {
                let at = |time| column.names().iter().map(move |part| format!("{part}_{time}"));
                (1..=times).flat_map(at).collect()
            }
        }
    }

    /// Values of a motion.
    pub fn values(self, motion: &RowMotion) -> Vec<Value> {
        match self {
            Self::Constant(constant) => vec![constant_as_json(constant, &motion.motion)],
            Self::Ephemeris((_, value)) => vec![value(motion).into()],
            Self::Sample(column) => {
                // a number that is not finite is an absent value
                let mut numbers = vec![f64::NAN; column.names().len() * motion.times.len()];
                if let Some(ephemeris) = motion.f64_ephemeris() {
                    ephemeris.write(column, &motion.times, &mut numbers);
                }
                numbers.into_iter().map(Value::from).collect()
            }
        }
    }

    /// Values of numbers that the scenario refuses.
    pub fn values_of_refusal(self, times: u32) -> Vec<Value> {
        match self {
            Self::Constant(Constant { name: "regime", .. }) => vec!["refused".into()],
            _ => vec![Value::Null; self.names(times).len()],
        }
    }
}

/// Motion of a row, with its ephemerides as far as columns need them.
pub struct RowMotion {
    motion: TimedMotion,
    times: Vec<f64>,
    f64_ephemeris: OnceCell<Option<MotionEphemeris>>,
    f32_ephemeris: OnceCell<Option<MotionEphemeris>>,
}

impl RowMotion {
    /// Motion with `count` times spread over this many periods.
    pub fn new(motion: TimedMotion, count: u32, periods: f64) -> Self {
        let times = spread_times(periods * motion.characteristic_time(), count);
        Self { motion, times, f64_ephemeris: OnceCell::new(), f32_ephemeris: OnceCell::new() }
    }

    fn f64_ephemeris(&self) -> Option<&MotionEphemeris> {
        /// Truncation error, rad.
        const TRUNCATION: f64 = 1e-13;
        let tick = self.motion.tick();
        let settings = TableSettings { truncation: Some(TRUNCATION), ..TableSettings::new(tick) };
        let ephemeris = || MotionEphemeris::with_settings(&self.motion, Scalar::F64, &settings).ok();
        self.f64_ephemeris.get_or_init(ephemeris).as_ref()
    }

    fn f32_ephemeris(&self) -> Option<&MotionEphemeris> {
        self.f32_ephemeris.get_or_init(|| MotionEphemeris::new(&self.motion, Scalar::F32).ok()).as_ref()
    }

    fn error_f32(&self) -> Option<f64> {
        let (single, double) = (self.f32_ephemeris()?, self.f64_ephemeris()?);
        let error = |&t: &f64| single.pose(t).orientation.distance(&double.pose(t).orientation);
        Some(self.times.iter().map(error).fold(0.0, greater_or_infinite))
    }
}
