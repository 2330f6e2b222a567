#![doc = include_str!("../README.md")]
#![cfg_attr(not(test), no_std)]

// The numbers.
mod cycle;
pub mod real;
mod turns;

mod complex;
pub mod su2;

// What is thrown.
mod error;
mod top;

// The law that set-up integrates over a period and the stepper over a tick.
mod nutation;

mod cayley_klein;

// Once per throw; may refuse.
mod launch;

// Every tick; cannot fail.
mod tick;

// The paper's closed forms, to compare with.
pub mod exact;

#[cfg(doc)]
#[doc = include_str!("../docs/paper.md")]
pub mod paper {}
#[cfg(doc)]
#[doc = include_str!("../docs/errata.md")]
pub mod errata {}

mod interop;

pub use complex::Complex;
pub use cycle::Cycle;
pub use error::LaunchError;
#[cfg(feature = "fixed")]
pub use fixed;
pub use launch::{
    Averages, BranchPoints, FirstIntegrals, Motion, Pace, Regime, Release, Sign, Signs, Start, State,
    TipClass,
};
pub use su2::Phi;
pub use tick::{
    Bakeable, Baked, BakedError, Cursor, Ephemeris, EphemerisF32, EphemerisF64, ErrorBound, Moment, NoFit,
    Place, Pose, Stepper, Tabular, Tick, Tip, TipAngle, TurningPoint,
};
#[cfg(feature = "fixed")]
pub use tick::{FixedStepper, NoTickMap};
pub use top::{Heaviness, Support, Top};
pub use turns::{Rate, Turns};
