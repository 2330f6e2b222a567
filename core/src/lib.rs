#![doc = include_str!("../README.md")]
#![cfg_attr(not(test), no_std)]

// Modules in the order of dependence: each one uses only those above it.

// Numbers: products of integers, phases, scalars, complex numbers, SU(2).
mod product;

mod phase;

pub mod scalar;

mod complex;

pub mod su2;

// Input: a top and its state.
mod error;

mod top;

mod state;

// Constants of the motion.
mod constants;

pub mod elliptic;

mod law;

mod cayley_klein;

mod mean_motion;

mod motion;

// Motion as a function of time. Set-up may be refused; after it nothing fails.
mod attitude_state;

mod tip;

mod stepper;

mod ephemeris;

mod events;
// Partial derivatives, and a launch fitted to measurements.
mod sensitivity;

pub mod fit;

// Closed forms of the paper, for comparison.
pub mod exact;

mod interop;

#[cfg(doc)]
#[doc = include_str!("../docs/paper.md")]
pub mod paper {}
#[cfg(doc)]
#[doc = include_str!("../docs/errata.md")]
pub mod errata {}
#[cfg(doc)]
#[doc = include_str!("../docs/error_bound.md")]
pub mod error_bound {}
#[cfg(doc)]
#[doc = include_str!("../docs/other_tops.md")]
pub mod other_tops {}
#[cfg(doc)]
#[doc = include_str!("../docs/table_format.md")]
pub mod table_format {}
#[cfg(doc)]
#[doc = include_str!("../docs/partials.md")]
pub mod partials {}

pub use attitude_state::AttitudeState;
pub use complex::Complex;
pub use constants::{BranchPoints, FirstIntegrals, Regime, Sign, Signs, TipClass};
#[cfg(feature = "micromath")]
pub use ephemeris::Micromath;
pub use ephemeris::{
    Baked, BakedError, Clock, Cursor, Ephemeris, EphemerisF32, EphemerisF64, EphemerisScalar,
    EphemerisStorage, EphemerisView, ErrorBound, Sample, Sampler, Samples, SegmentPoint, SetUp, TableData,
    TableTooSmall, Tick, TipClock, TurningPoint,
};
#[cfg(feature = "fixed")]
pub use ephemeris::{EphemerisQ15, EphemerisQ31};
pub use error::ParameterError;
pub use events::{Crossings, Event, Level, TipAngles};
#[cfg(feature = "fixed")]
pub use fixed;
pub use mean_motion::PeriodAdvance;
pub use motion::{Launch, Motion, Start};
pub use phase::Phase;
pub use sensitivity::{Partials, Sensitivity, SensitivityCursor};
pub use state::{Release, State};
pub use stepper::Stepper;
pub use su2::Orientation;
pub use top::{Support, Top, TopParameters};
