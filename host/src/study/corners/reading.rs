//! The smallest table that fits, of any scalar, read in `f64`.

use crate::ephemeris::{AnySize, Sizes, free_tick, smallest_with_period, ticks_for};
use fixed::types::{I2F14, I2F30};
use toytop::real::Scalar;
use toytop::{Complex, Ephemeris, ErrorBound, Motion, NoFit, Phi, Tabular, Tick};

/// Scalars, by name and the rounding of each.
pub const SCALARS: [(&str, f64); 4] = [
    ("f64", <f64 as Scalar>::ROUNDING),
    ("f32", <f32 as Scalar>::ROUNDING),
    ("q31", <I2F30 as Scalar>::ROUNDING),
    ("q15", <I2F14 as Scalar>::ROUNDING),
];

/// A moment.
#[derive(Clone, Copy, Debug)]
pub struct Seen {
    /// Φ.
    pub phi: Phi<f64>,
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
}

impl Reading {
    /// The moment t.
    #[must_use]
    pub fn at(&self, t: f64) -> Seen {
        (self.at)(t)
    }

    /// The nutation phase at t = 0, in turns.
    #[must_use]
    pub fn phase(&self) -> f64 {
        self.phase
    }

    /// How far Φ can be from the truth then, rad.
    #[must_use]
    pub fn bound(&self, t: f64) -> f64 {
        self.bound.constant + self.bound.per_tick * (t * self.ticks_per_time).abs()
    }
}

/// The readings of a motion, in the order of [`SCALARS`]; `None`: a typed refusal, no table fits.
#[must_use]
pub fn readings(motion: &Motion, period: f64) -> [Option<Reading>; 4] {
    [
        floating::<f64>(motion, period),
        floating::<f32>(motion, period),
        fixed_point(&I2F30_SIZES, motion, period),
        fixed_point(&I2F14_SIZES, motion, period),
    ]
}

fn floating<R: Sizes>(motion: &Motion, period: f64) -> Option<Reading> {
    let table: Box<dyn AnySize<R>> = smallest_with_period(motion, period).ok()?;
    let (bound, phase) = (table.error_bound(), table.at(0.0).nutation_phase.to_f64());
    let at = move |t| {
        let pose = table.at(t).pose;
        Seen { phi: widened(pose.phi, R::to_f64), omega: Some(pose.omega().map(R::to_f64)) }
    };
    Some(Reading { bound, ticks_per_time: ticks_for(motion, period), phase, at: Box::new(at) })
}

/// Segments, and how to set up as many.
type Size = (u32, fn(&Motion, Tick, f64) -> Result<Reading, NoFit>);

const I2F30_SIZES: [Size; 4] = [
    (16, set_up::<I2F30, 16, 8>),
    (64, set_up::<I2F30, 64, 8>),
    (256, set_up::<I2F30, 256, 8>),
    (1024, set_up::<I2F30, 1024, 8>),
];
const I2F14_SIZES: [Size; 4] = [
    (16, set_up::<I2F14, 16, 4>),
    (64, set_up::<I2F14, 64, 4>),
    (256, set_up::<I2F14, 256, 4>),
    (1024, set_up::<I2F14, 1024, 4>),
];

fn fixed_point(sizes: &[Size], motion: &Motion, period: f64) -> Option<Reading> {
    let (tick, rate) = (free_tick(motion, period).ok()?, ticks_for(motion, period));
    let mut needed = 0;
    for (segments, set_up) in sizes {
        if *segments >= needed {
            match set_up(motion, tick, rate) {
                Ok(reading) => return Some(reading),
                Err(refusal) => needed = refusal.segments.unwrap_or(u32::MAX),
            }
        }
    }
    None
}

fn set_up<
    R: Tabular<Coefficient: 'static> + Into<f64> + 'static,
    const SEGMENTS: usize,
    const TERMS: usize,
>(
    motion: &Motion,
    tick: Tick,
    ticks_per_time: f64,
) -> Result<Reading, NoFit> {
    let mut table = Box::new(Ephemeris::<R, SEGMENTS, TERMS>::EMPTY);
    table.set_up(motion, tick, 4.0 * R::ROUNDING)?;
    let (bound, phase) = (table.error_bound(), table.at(0.0).nutation_phase().to_f64());
    let at = move |t| Seen { phi: widened(table.at(t).phi(), Into::into), omega: None };
    Ok(Reading { bound, ticks_per_time, phase, at: Box::new(at) })
}

fn widened<R: Copy>(phi: Phi<R>, widen: impl Fn(R) -> f64) -> Phi<f64> {
    let complex = |z: Complex<R>| Complex { re: widen(z.re), im: widen(z.im) };
    Phi { alpha: complex(phi.alpha), beta: complex(phi.beta) }
}
