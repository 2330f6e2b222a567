//! The smallest table that fits, of any scalar, read in `f64`.

use fixed::types::{I2F14, I2F30};
use std::rc::Rc;
use toytop::scalar::Scalar as _;
use toytop::{ErrorBound, Motion, Orientation};
use toytop_host::cli::Scalar;
use toytop_host::motion::ephemeris::{AnyScalar, smallest_with_period, ticks_for};

/// Scalars, by name and the rounding of each.
pub const SCALARS: [(&str, f64); 4] =
    [("f64", f64::ROUNDING), ("f32", f32::ROUNDING), ("q31", I2F30::ROUNDING), ("q15", I2F14::ROUNDING)];

/// A moment.
#[derive(Clone, Copy, Debug)]
pub struct Seen {
    /// Φ.
    pub phi: Orientation<f64>,
    /// ω in the fixed frame, where the scalar can hold it.
    pub omega: Option<[f64; 3]>,
}

/// A table of any size and scalar.
pub struct Reading {
    bound: ErrorBound,
    ticks_per_time: f64,
    /// At t = 0, in turns.
    phase: f64,
    at: Box<dyn Fn(f64) -> Seen>,
    at_tick: Box<dyn Fn(i64) -> Orientation<f64>>,
}

impl Reading {
    /// The moment t.
    #[must_use]
    pub fn at(&self, t: f64) -> Seen {
        (self.at)(t)
    }

    /// Φ of a tick, in the scalar's own arithmetic.
    #[must_use]
    pub fn at_tick(&self, tick: i64) -> Orientation<f64> {
        (self.at_tick)(tick)
    }

    /// How far Φ of a tick can be from the truth, rad.
    #[must_use]
    pub fn bound_at(&self, tick: i64) -> f64 {
        self.bound.after(tick as f64)
    }

    /// Whether more than half of that bound comes from the number of ticks.
    #[must_use]
    pub fn counts_ticks(&self, tick: i64) -> bool {
        self.bound_at(tick) > 2.0 * self.bound_at(0)
    }

    /// The nutation phase at t = 0, in turns.
    #[must_use]
    pub fn phase(&self) -> f64 {
        self.phase
    }

    /// How far Φ can be from the truth then, rad.
    #[must_use]
    pub fn bound(&self, t: f64) -> f64 {
        self.bound.after(t * self.ticks_per_time)
    }
}

/// The readings of a motion, in the order of [`SCALARS`]; `None`: a typed refusal, no table fits.
#[must_use]
pub fn readings(motion: &Motion, period: f64) -> [Option<Reading>; 4] {
    [Scalar::F64, Scalar::F32, Scalar::Q31, Scalar::Q15].map(|scalar| reading(scalar, motion, period))
}

fn reading(scalar: Scalar, motion: &Motion, period: f64) -> Option<Reading> {
    let table: Rc<dyn AnyScalar> = smallest_with_period(scalar, motion, period).ok()?.into();
    let (bound, phase) = (table.error_bound(), table.at(0.0).nutation_phase.to_f64());
    let floating = matches!(scalar, Scalar::F64 | Scalar::F32);
    let by_tick = Rc::clone(&table);
    let at_tick = move |tick| by_tick.at_tick(tick).orientation;
    let at = move |t| {
        let sample = table.at(t).sample;
        Seen { phi: sample.orientation(), omega: floating.then_some(sample.omega) }
    };
    let ticks_per_time = ticks_for(motion, period);
    Some(Reading { bound, ticks_per_time, phase, at: Box::new(at), at_tick: Box::new(at_tick) })
}
