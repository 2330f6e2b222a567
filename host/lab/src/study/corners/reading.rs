//! Smallest table of a motion in any scalar, evaluated as `f64`.

use fixed::types::{I2F14, I2F30};
use toytop::scalar::Scalar as _;
use toytop::{ErrorBound, Motion, Orientation};
use toytop_host::cli::Scalar;
use toytop_host::motion::ephemeris::{AnyScalar, RateSample, approximate, smallest_with_period, ticks_for};

/// Scalars, each with its name and its rounding.
pub(crate) const SCALARS: [(&str, f64); 4] =
    [("f64", f64::ROUNDING), ("f32", f32::ROUNDING), ("q31", I2F30::ROUNDING), ("q15", I2F14::ROUNDING)];

/// Motion at one time.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Seen {
    /// Orientation Φ.
    pub phi: Orientation<f64>,
    /// Angular velocity ω in the fixed frame; `None` in fixed point, which cannot represent it.
    pub omega: Option<[f64; 3]>,
}

/// Table of any size and scalar.
pub(crate) struct Reading {
    table: Box<dyn AnyScalar>,
    bound: ErrorBound,
    ticks_per_time: f64,
    /// Nutation phase at t = 0, in turns.
    phase: f64,
    /// Whether the scalar can represent ω.
    floating: bool,
}

impl Reading {
    /// Motion at time t.
    #[must_use]
    pub(crate) fn at(&self, t: f64) -> Seen {
        let sample = self.table.at(t).sample;
        Seen { phi: sample.orientation(), omega: self.floating.then_some(sample.omega) }
    }

    /// Orientation Φ at a tick, in the arithmetic of the scalar.
    #[must_use]
    pub(crate) fn at_tick(&self, tick: i64) -> Orientation<f64> {
        self.table.at_tick(tick).orientation
    }

    /// Rates at a tick.
    #[must_use]
    pub(crate) fn rates_at_tick(&self, tick: i64) -> RateSample {
        self.table.rates_at_tick(tick)
    }

    /// Upper bound on the error of the rates at a tick, rad per unit time.
    #[must_use]
    pub(crate) fn rate_bound_at(&self, tick: i64) -> f64 {
        self.table.rate_error_bound().after(tick as f64)
    }

    /// Upper bound on the distance of Φ at a tick from the truth, rad.
    #[must_use]
    pub(crate) fn bound_at(&self, tick: i64) -> f64 {
        self.bound.after(tick as f64)
    }

    /// Whether more than half of the bound at a tick comes from the number of ticks.
    #[must_use]
    pub(crate) fn counts_ticks(&self, tick: i64) -> bool {
        self.bound_at(tick) > 2.0 * self.bound_at(0)
    }

    /// Nutation phase at t = 0, in turns.
    #[must_use]
    pub(crate) fn phase(&self) -> f64 {
        self.phase
    }

    /// Upper bound on the distance of Φ at time t from the truth, rad.
    #[must_use]
    pub(crate) fn bound(&self, t: f64) -> f64 {
        self.bound.after(t * self.ticks_per_time)
    }
}

/// Tables of a motion, launched for `f64` and for `f32`, in the order of [`SCALARS`]; `None` where no table is large enough.
#[must_use]
pub(crate) fn readings([for_f64, for_f32]: [&Motion; 2], period: f64) -> [Option<Reading>; 4] {
    [(Scalar::F64, for_f64), (Scalar::F32, for_f32), (Scalar::Q31, for_f32), (Scalar::Q15, for_f32)]
        .map(|(scalar, motion)| reading(scalar, motion, period))
}

/// Table in `f64` whose truncation error is far below the rounding; `None` where no table is large enough.
#[must_use]
pub(crate) fn finer(motion: &Motion, period: f64) -> Option<Box<dyn AnyScalar>> {
    const TRUNCATION: f64 = 1e-18;
    approximate(motion, period, TRUNCATION).ok()
}

fn reading(scalar: Scalar, motion: &Motion, period: f64) -> Option<Reading> {
    let table = smallest_with_period(scalar, motion, period).ok()?;
    let (bound, phase) = (table.error_bound(), table.at(0.0).nutation_phase.to_f64());
    let floating = matches!(scalar, Scalar::F64 | Scalar::F32);
    Some(Reading { table, bound, ticks_per_time: ticks_for(motion, period), phase, floating })
}
