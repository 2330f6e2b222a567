//! Columns of a sweep, and what is computed of a motion for them.

use crate::input::scenario::{Scenario, Units};
use crate::motion::ephemeris::{AnyEphemeris, approximate, smallest_ephemeris};
use crate::motion::propagate::Sample;
use crate::motion::quantity::Quantity;
use crate::motion::{Scalar, spread_times, value};
use crate::truth::full_equations;
use clap::ValueEnum;
use serde_json::Value;
use std::cell::OnceCell;
use std::str::FromStr;
use toytop::{Motion, Orientation};
use toytop_model::constants::{CONSTANTS, Constant, MotionConstants};

/// Column of a sweep, or the columns of a quantity at every time.
#[derive(Clone, Copy)]
pub enum Column {
    /// Constant of the motion.
    Constant(&'static Constant),
    /// Figure of the motion's tables, by its name and function.
    Figure(&'static str, fn(&Measured) -> Value),
    /// Quantity of a sample, at every time.
    Sample(Quantity),
}

/// Figure of a motion's tables: its name and its value; null where a table or the solver has none.
type Figure = (&'static str, fn(&Measured) -> Value);

/// Figures of the tables of a motion over the times: greatest error of the f32 ephemeris against the f64 ephemeris, rad; error bound
/// that the f32 ephemeris states, rad; segments of the f32 table; greatest errors of both against the full solver, rad.
const FIGURES: [Figure; 5] = [
    ("error_f32", |motion| {
        let exact = motion.double().map(|run| run.samples.iter().map(Sample::orientation));
        motion.single().zip(exact).map(|(run, exact)| run.error(exact)).into()
    }),
    ("bound_f32", |motion| motion.single().map(|run| run.bound).into()),
    ("segments_f32", |motion| motion.single().map(|run| run.segments).into()),
    ("full_error_f64", |motion| motion.full_error(motion.double()).into()),
    ("full_error_f32", |motion| motion.full_error(motion.single()).into()),
];

/// Columns without the option.
pub const DEFAULT_COLUMNS: &str = "regime,tip_class,period,phi_per_period,min_normal_force";

impl FromStr for Column {
    type Err = String;

    fn from_str(name: &str) -> Result<Self, String> {
        let constants = CONSTANTS.iter().map(|constant| (constant.name, Self::Constant(constant)));
        let figures = FIGURES.map(|(name, value)| (name, Self::Figure(name, value)));
        let named = constants.chain(figures);
        let sample = || Quantity::from_str(name, false).ok().map(Self::Sample);
        named.clone().find(|(known, _)| *known == name).map(|(_, column)| column).or_else(sample).ok_or_else(
            || {
                let names: Vec<_> = named.map(|(name, _)| name).collect();
                format!("must be a column of toytop state, {}", names.join(", "))
            },
        )
    }
}

impl Column {
    /// Names in the header.
    pub fn names(self, times: u32) -> Vec<String> {
        match self {
            Self::Constant(Constant { name, .. }) => vec![(*name).to_owned()],
            Self::Figure(name, _) => vec![name.to_owned()],
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
            (Self::Figure(_, value), Some(motion)) => vec![value(motion)],
            (Self::Constant(Constant { name: "regime", .. }), None) => vec!["refused".into()],
            (Self::Sample(quantity), _) if motion.is_some_and(|motion| motion.double().is_some()) => {
                let run = motion.and_then(Measured::double);
                let samples = run.iter().flat_map(|run| &run.samples);
                samples.flat_map(|sample| quantity.numbers(sample)).map(Value::from).collect()
            }
            _ => vec![Value::Null; self.names(times).len()],
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
        let run = || approximate(&self.motion, WITHIN).ok().map(|table| self.run(&*table));
        self.double.get_or_init(run).as_ref()
    }

    fn single(&self) -> Option<&Run> {
        let run = || smallest_ephemeris(Scalar::F32, &self.motion).ok().map(|table| self.run(&*table));
        self.single.get_or_init(run).as_ref()
    }

    /// Greatest distance of a run from the full solver, rad.
    fn full_error(&self, run: Option<&Run>) -> Option<f64> {
        let solved = || {
            let scenario =
                Scenario { name: String::new(), motion: *self.motion, given: None, units: Units::None };
            let states = full_equations::states(&scenario, &self.times).ok()?;
            Some(states.iter().map(|state| state.orientation()).collect())
        };
        let truth = self.full.get_or_init(solved).as_ref()?;
        Some(run?.error(truth.iter().copied()))
    }
}
