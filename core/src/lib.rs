#![doc = include_str!("../README.md")]
#![cfg_attr(not(test), no_std)]

// Modules in the order of dependence: each one uses only those above it.

// Numbers: products of integers, phases, scalars, complex numbers, SU(2).
mod numbers;

pub mod su2;

// Input: a top and its state.
mod body;

// Constants of the motion.
mod constants;

// Motion as a function of time. Set-up may be refused; after it nothing fails.
mod motion;

mod stepper;

mod table;

mod events;

mod interop;

#[cfg(doc)]
#[doc = include_str!("../docs/error_bound.md")]
pub mod error_bound {}
#[cfg(doc)]
#[doc = include_str!("../docs/other_tops.md")]
pub mod other_tops {}
#[cfg(doc)]
#[doc = include_str!("../docs/table_format.md")]
pub mod table_format {}

/// Parts of toytop that its sibling crates share; not covered by semantic versioning.
#[doc(hidden)]
pub mod internal;

pub use body::error::ParameterError;
pub use body::state::{Release, State};
pub use body::top::{Support, Top, TopParameters};
pub use constants::{BranchPoints, FirstIntegrals, Regime, Sign, Signs, TipClass};
pub use events::{Event, Events, Level};
#[cfg(feature = "fixed")]
pub use fixed;
pub use motion::attitude_state::AttitudeState;
pub use motion::period::PeriodAdvance;
pub use motion::{InitialPhases, Motion};
pub use numbers::complex::Complex;
pub use numbers::phase::Phase;
pub use numbers::scalar;
pub use stepper::Stepper;
pub use su2::Orientation;
pub use table::{
    Baked, BakedError, Clock, Cursor, Ephemeris, EphemerisF32, EphemerisF64, EphemerisMemory,
    EphemerisScalar, EphemerisView, ErrorBound, Pose, ReadyEphemeris, Sample, SetUp, SetUpError, Tick,
};
#[cfg(feature = "fixed")]
pub use table::{EphemerisQ15, EphemerisQ31};

// Shorter paths inside the crate.
pub(crate) use body::{error, state, top};
pub(crate) use motion::{attitude_state, cayley_klein, landen, period, tip};
pub(crate) use numbers::{complex, phase, product};

#[cfg(test)]
mod tests {
    use super::*;

    /// What an interrupt or a resource of a scheduler holds may move there and be shared; otherwise this does not compile.
    #[test]
    fn an_interrupt_may_hold_everything() {
        fn held<T: Send + Sync>() {}
        held::<(Top, State, Motion, Stepper<f32>, Stepper<f64>, Tick, Phase)>();
        held::<(EphemerisF32, EphemerisF64, SetUpError, ParameterError, ErrorBound)>();
        held::<(Orientation<f32>, AttitudeState<f32>, Event, Level)>();
        held::<(Cursor<&'static EphemerisView<f32>>, Cursor<ReadyEphemeris<'static, f32>>)>();
        #[cfg(feature = "fixed")]
        held::<(EphemerisQ31, EphemerisQ15)>();
    }
}
