//! Columns of a sweep, and what is computed of a motion for them.

use clap::ValueEnum;
use serde_json::Value;
use std::cell::OnceCell;
use std::str::FromStr;
use toytop::TableSettings;
use toytop_host::motion::Scalar;
use toytop_host::motion::column::SampleColumn;
use toytop_host::motion::errors::greater_or_infinite;
use toytop_host::motion::evaluator::MotionEvaluator;
use toytop_host::motion::times::spread_times;
use toytop_host::output::constant_as_json;
use toytop_model::constants::{CONSTANTS, Constant};
use toytop_model::motion_with_period::MotionWithPeriod;

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

/// Columns of the tables:
///
/// * greatest difference of the orientation between the tables in `f32` and in `f64`, rad
/// * bound on the error of the table in `f32` at t = 0, rad; its growth is negligible below millions of periods
/// * number of segments of the table in `f32`
const TABLE_COLUMNS: [TableColumn; 3] = [
    ("error_f32", |motion| motion.error_f32().map(Value::from)),
    ("bound_f32", |motion| Some(motion.f32_table()?.error_bound.constant.into())),
    ("segments_f32", |motion| Some(motion.f32_table()?.size?[0].into())),
];

/// Columns without the option.
pub const DEFAULT_COLUMNS: &str = "regime,tip_class,period,phi_per_period,min_normal_force";

impl FromStr for SweepColumn {
    type Err = String;

    fn from_str(name: &str) -> Result<Self, String> {
        let constants = CONSTANTS.iter().map(|constant| (constant.name, Self::Constant(constant)));
        let named = constants.chain(TABLE_COLUMNS.map(|column| (column.0, Self::Table(column))));
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
            Self::Table((name, _)) => vec![name.to_owned()],
            Self::Sample(column) => {
                let at = |time| column.names().iter().map(move |part| format!("{part}_{time}"));
                (1..=times).flat_map(at).collect()
            }
        }
    }

    /// Values of a motion; without one, of numbers that the scenario refuses.
    pub fn values(self, motion: Option<&RowMotion>, times: u32) -> Vec<Value> {
        match (self, motion) {
            (Self::Constant(Constant { name: "regime", .. }), None) => vec!["refused".into()],
            (_, None) => vec![Value::Null; self.names(times).len()],
            (Self::Constant(constant), Some(motion)) => vec![constant_as_json(constant, &motion.motion)],
            (Self::Table((_, value)), Some(motion)) => vec![value(motion).into()],
            (Self::Sample(column), Some(motion)) => {
                // a number that is not finite is an absent value
                let mut numbers = vec![f64::NAN; column.names().len() * motion.times.len()];
                if let Some(evaluator) = motion.f64_evaluator() {
                    evaluator.write(column, &motion.times, &mut numbers);
                }
                numbers.into_iter().map(Value::from).collect()
            }
        }
    }
}

/// Motion of a row, with its tables as far as columns need them.
pub struct RowMotion {
    motion: MotionWithPeriod,
    times: Vec<f64>,
    f64_evaluator: OnceCell<Option<MotionEvaluator>>,
    f32_table: OnceCell<Option<MotionEvaluator>>,
}

impl RowMotion {
    /// Motion with `count` times spread over this many periods.
    pub fn new(motion: MotionWithPeriod, count: u32, periods: f64) -> Self {
        let times = spread_times(periods * motion.characteristic_time(), count);
        Self { motion, times, f64_evaluator: OnceCell::new(), f32_table: OnceCell::new() }
    }

    fn f64_evaluator(&self) -> Option<&MotionEvaluator> {
        /// Truncation error, rad.
        const TRUNCATION: f64 = 1e-13;
        let tick = self.motion.tick();
        let settings = TableSettings { truncation: Some(TRUNCATION), ..TableSettings::new(tick) };
        let evaluator = || MotionEvaluator::with_settings(&self.motion, Scalar::F64, &settings).ok();
        self.f64_evaluator.get_or_init(evaluator).as_ref()
    }

    fn f32_table(&self) -> Option<&MotionEvaluator> {
        self.f32_table.get_or_init(|| MotionEvaluator::new(&self.motion, Scalar::F32).ok()).as_ref()
    }

    fn error_f32(&self) -> Option<f64> {
        let (single, double) = (self.f32_table()?, self.f64_evaluator()?);
        let error = |&t: &f64| single.orientation(t).distance(&double.orientation(t));
        Some(self.times.iter().map(error).fold(0.0, greater_or_infinite))
    }
}
