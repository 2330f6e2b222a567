//! Columns of a sweep, and the row of a motion.

use super::Motions;
use super::sealed::{CHECKSUM, sealed};
use crate::full_equations::solution;
use crate::input::scenario::{Scenario, Units};
use crate::motion::Scalar;
use crate::motion::ephemeris::{AnyScalar, approximate, smallest_with_period};
use crate::motion::propagate::natural_time;
use crate::output::names;
use std::fmt::{self, Write as _};
use toytop::{Complex, Motion, Orientation, PeriodAdvance, Regime};

/// Truncation error of the table in `f64`, rad.
const WITHIN: f64 = 1e-13;

/// Quantity of a motion, which is one column, or one or more columns for each tick.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
#[value(rename_all = "snake_case")]
pub enum Column {
    /// Kind of motion; refused where no motion has these numbers, such as e1 > e2
    Regime,
    /// Class of the curve that the tip draws
    TipClass,
    /// First integral l
    L,
    /// First integral n
    N,
    /// Energy h
    H,
    /// Nutation period
    Period,
    /// Turns of α in a period
    AlphaTurns,
    /// Turns of β in a period
    BetaTurns,
    /// Advance of the tip angle in a period, rad
    PhiPerPeriod,
    /// Least normal force, in units of the weight
    MinNormalForce,
    /// Cosine of the tilt at every tick
    U,
    /// Orientation (α and β) at every tick
    #[value(name = "phi", alias = "orientation")]
    Orientation,
    /// Tip at every tick, in units of s, or with a scenario in m
    Tip,
    /// Greatest error of the f32 ephemeris over the ticks, against the f64 ephemeris, rad
    #[value(name = "error_f32")]
    ErrorF32,
    /// Error bound that the f32 ephemeris states, rad
    #[value(name = "bound_f32")]
    BoundF32,
    /// Segments of the f32 table
    #[value(name = "segments_f32")]
    SegmentsF32,
    /// Greatest error of the f64 ephemeris against the full solver, rad (slow)
    #[value(name = "full_error_f64")]
    FullErrorF64,
    /// Greatest error of the f32 ephemeris against the full solver, rad (slow)
    #[value(name = "full_error_f32")]
    FullErrorF32,
}

/// Columns without the option.
pub const DEFAULT_COLUMNS: &str = "regime,tip_class,period,phi_per_period,min_normal_force";

impl Column {
    /// Names in the header.
    fn header(self, ticks: u32) -> Vec<String> {
        let parts: &[&str] = match self {
            Self::U => &["u"],
            Self::Orientation => &["alpha_re", "alpha_im", "beta_re", "beta_im"],
            Self::Tip => &["tip_x", "tip_y"],
            _ => return vec![self.name()],
        };
        let of_tick = |tick| parts.iter().map(move |part| format!("{part}_{tick}"));
        (1..=ticks).flat_map(of_tick).collect()
    }

    /// Name on the command line.
    fn name(self) -> String {
        let value = clap::ValueEnum::to_possible_value(&self);
        value.map(|value| value.get_name().to_owned()).unwrap_or_default()
    }

    fn of_ticks(self) -> bool {
        !matches!(
            self,
            Self::Regime
                | Self::TipClass
                | Self::L
                | Self::N
                | Self::H
                | Self::Period
                | Self::AlphaTurns
                | Self::BetaTurns
                | Self::PhiPerPeriod
                | Self::MinNormalForce
        )
    }

    fn of_f32(self) -> bool {
        matches!(self, Self::ErrorF32 | Self::BoundF32 | Self::SegmentsF32 | Self::FullErrorF32)
    }

    fn of_the_full_solver(self) -> bool {
        matches!(self, Self::FullErrorF64 | Self::FullErrorF32)
    }
}

/// Table of a sweep: a header, and a row for every motion.
#[derive(Clone, Debug, PartialEq)]
pub struct Rows {
    /// Motions of the sweep.
    pub motions: Motions,
    /// Columns of each motion.
    pub columns: Vec<Column>,
    /// Number of times at which each motion is evaluated.
    pub ticks: u32,
    /// Number of nutation periods over which these times are spread.
    pub periods: f64,
}

/// First columns of every table.
pub(super) const KEYS: &str = "index,motions,version,seed";

impl Rows {
    /// Names of the columns, with a line break.
    #[must_use]
    pub fn header(&self) -> String {
        let names = self.columns.iter().flat_map(|column| column.header(self.ticks));
        names.fold(format!("{KEYS},{}", self.motions.keys()), |line, name| line + "," + &name)
            + &format!(",{CHECKSUM}\n")
    }

    /// Row with this index, with a line break. A number has the shortest decimal that reads back the same `f64`; no
    /// field needs quotes.
    #[must_use]
    pub fn row(&self, number: u64) -> String {
        self.row_or_refusal(number).0
    }

    /// Row with this index, as [`Rows::row`], and whether no motion has its numbers.
    #[must_use]
    pub fn row_or_refusal(&self, number: u64) -> (String, bool) {
        let (fields, motion) = self.motions.at(number);
        let seed = self.motions.seed().map(|seed| seed.to_string()).unwrap_or_default();
        let (motions, version) = (self.motions.count(), env!("CARGO_PKG_VERSION"));
        let mut row = format!("{number},{motions},{version},{seed},{fields}");
        let is_refused = motion.is_none();
        let measured = motion.map(|motion| self.measure(motion));
        for &column in &self.columns {
            put(&mut row, column, self.ticks, &measured);
        }
        (sealed(&row), is_refused)
    }

    fn measure(&self, motion: Motion) -> Measured {
        let wants = |need: fn(Column) -> bool| self.columns.iter().any(|&column| need(column));
        let averages = motion.period_advance();
        let mut measured = Measured { motion, averages, double: None, single: None, full: None };
        if !wants(Column::of_ticks) {
            return measured;
        }
        let nutation = averages.filter(|_| motion.regime() == Regime::Nutating);
        let period = nutation.map_or_else(|| natural_time(&motion), |averages| averages.period);
        let times = times(self.periods * period, self.ticks);
        measured.double = approximate(&motion, period, WITHIN).ok().map(|table| Run::of(&*table, &times));
        if wants(Column::of_f32) {
            let table = smallest_with_period(Scalar::F32, &motion, period).ok();
            measured.single = table.map(|table| Run::of(&*table, &times));
        }
        if wants(Column::of_the_full_solver) {
            let scenario = Scenario { name: String::new(), motion, state: None, units: Units::None };
            let states = solution::states(&scenario, &times).ok();
            measured.full = states.map(|states| states.iter().map(solution::phi).collect());
        }
        measured
    }
}

/// Options of `toytop sweep` that write this table.
impl fmt::Display for Rows {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} --ticks {} --periods {:?} --columns ", self.motions, self.ticks, self.periods)?;
        let names: Vec<_> = self.columns.iter().map(|column| column.name()).collect();
        f.write_str(&names.join(","))
    }
}

/// `count` times from 0 to `whole`: one in each of `count` equal parts, at a place in its part that is a multiple of
/// the golden section modulo 1.
fn times(whole: f64, count: u32) -> Vec<f64> {
    const GOLDEN_SECTION: f64 = 0.618_033_988_749_894_9;
    let part = whole / f64::from(count);
    (0..count).map(|i| part * (f64::from(i) + (f64::from(i + 1) * GOLDEN_SECTION).fract())).collect()
}

/// Quantities of one motion from which the columns follow.
struct Measured {
    motion: Motion,
    averages: Option<PeriodAdvance>,
    double: Option<Run>,
    single: Option<Run>,
    full: Option<Vec<Orientation<f64>>>,
}

/// Values of an ephemeris at the ticks.
struct Run {
    phis: Vec<Orientation<f64>>,
    tips: Vec<Complex<f64>>,
    segments: usize,
    /// Constant part of the error bound, rad. The part per tick is negligible below millions of periods.
    bound: f64,
}

impl Run {
    fn of(table: &dyn AnyScalar, times: &[f64]) -> Self {
        let samples = times.iter().map(|&t| table.at(t).sample);
        let (phis, tips) = samples.map(|sample| (sample.orientation(), sample.tip)).unzip();
        let bound = table.error_bound().constant;
        Self { phis, tips, segments: table.size()[0], bound }
    }

    /// Greatest distance from the truth, rad.
    fn error(&self, truth: &[Orientation<f64>]) -> f64 {
        let pairs = self.phis.iter().zip(truth);
        pairs.map(|(phi, truth_phi)| phi.distance(truth_phi)).fold(0.0, f64::max)
    }
}

/// Appends a column to a row; an absent value is an empty field.
fn put(row: &mut String, column: Column, ticks: u32, measured: &Option<Measured>) {
    let Some(measured) = measured else {
        let refused = if column == Column::Regime { "refused" } else { "" };
        row.push(',');
        row.push_str(refused);
        let more = column.header(ticks).len() - 1;
        row.extend(std::iter::repeat_n(',', more));
        return;
    };
    let Measured { motion, averages, double, single, full } = measured;
    let integrals = motion.first_integrals();
    let averages = averages.as_ref();
    let mut number = |x: Option<f64>| {
        row.push(',');
        if let Some(x) = x {
            // writing to a String cannot fail
            let _ = write!(row, "{x:?}");
        }
    };
    match column {
        Column::Regime => word(row, names::regime(motion.regime())),
        Column::TipClass => word(row, names::tip_class(motion.tip_class())),
        Column::L => number(Some(integrals.l)),
        Column::N => number(Some(integrals.n)),
        Column::H => number(Some(integrals.h)),
        Column::Period => number(averages.map(|averages| averages.period)),
        Column::AlphaTurns => number(averages.map(|averages| averages.alpha_turns)),
        Column::BetaTurns => number(averages.map(|averages| averages.beta_turns)),
        Column::PhiPerPeriod => {
            let moving = averages.filter(|_| !motion.regime().is_vertical());
            number(moving.map(PeriodAdvance::phi_per_period));
        }
        Column::MinNormalForce => number(motion.min_normal_force()),
        Column::U | Column::Orientation | Column::Tip => {
            for tick in 0..ticks as usize {
                let of_tick =
                    double.as_ref().and_then(|run| Some((*run.phis.get(tick)?, *run.tips.get(tick)?)));
                let parts = of_tick.map(|(phi, tip)| match column {
                    Column::U => vec![phi.clamped_u()],
                    Column::Orientation => vec![phi.alpha.re, phi.alpha.im, phi.beta.re, phi.beta.im],
                    _ => vec![tip.re, tip.im],
                });
                match parts {
                    Some(parts) => parts.into_iter().for_each(|part| number(Some(part))),
                    None => (0..column.header(1).len()).for_each(|_| number(None)),
                }
            }
        }
        Column::ErrorF32 => {
            number(single.as_ref().zip(double.as_ref()).map(|(single, double)| single.error(&double.phis)));
        }
        Column::BoundF32 => number(single.as_ref().map(|run| run.bound)),
        Column::SegmentsF32 => match single {
            Some(run) => word(row, &run.segments.to_string()),
            None => number(None),
        },
        Column::FullErrorF64 => number(double.as_ref().zip(full.as_ref()).map(|(run, full)| run.error(full))),
        Column::FullErrorF32 => number(single.as_ref().zip(full.as_ref()).map(|(run, full)| run.error(full))),
    }
}

fn word(row: &mut String, word: &str) {
    row.push(',');
    row.push_str(word);
}
