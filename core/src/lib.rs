#![doc = include_str!("../README.md")]
#![cfg_attr(not(test), no_std)]
#![cfg_attr(docsrs, feature(doc_cfg))]

// Modules in the order of dependence: each one uses only those above it.
//
// `#[inline(never)]` keeps a frame off the stack of the caller, or code in flash only once. `#[inline(always)]` marks the path of a tick,
// where a call costs more than most of the functions, and parts of a set-up whose frames would add up on the stack.

// Numbers.
mod integer;

mod phase;

pub mod scalar;

mod complex;

pub mod su2;

// Input: a top and its state.
mod body;

// Constants of the motion.
mod constants;

// Motion as a function of time. Set-up may be refused; evaluating a table never fails.
mod motion;

mod stepper;

mod table;

mod events;

#[cfg(doc)]
#[doc = include_str!("../docs/error_bound.md")]
pub mod error_bound {}
#[cfg(doc)]
#[doc = include_str!("../docs/other_tops.md")]
pub mod other_tops {}
#[cfg(doc)]
#[doc = include_str!("../docs/table_format.md")]
pub mod table_format {}

/// Parts for `toytop-fit`, `toytop-closed-forms`, `toytop-c` and the host only; any version may change them.
#[doc(hidden)]
pub mod internal {
    pub use crate::body::{check, check_finite, check_item};
    pub use crate::motion::internals::*;
    pub use crate::scalar::sine::{
        COSINE, CUBIC, LINEAR, SINE, SINES, SMALL_SINE, VERSINE, exact_sine_cosine, rotate_quarter_turns,
        sine_cosine_series,
    };
    pub use crate::table::{MAX_SEGMENTS, MIN_SEGMENTS};
}

pub use body::{ParameterError, PointImpulse, Release, State, Support, Top, TopParameters};
pub use complex::Complex;
pub use constants::{BranchPoints, FirstIntegrals, Regime, Sign, Signs, TipClass};
pub use events::{Event, Events, Level};
#[cfg(feature = "fixed")]
pub use fixed;
pub use motion::period::PeriodAdvance;
pub use motion::{InitialAngles, Motion};
pub use phase::Phase;
pub use stepper::Stepper;
pub use su2::{AttitudeState, Orientation};
pub use table::{
    Baked, BakedError, Clock, Cursor, ErrorBound, Sample, SetUpError, SizedTable, Table, TableF32, TableF64,
    TableMemory, TableScalar, TableSettings, Tick, Workspace,
};
#[cfg(feature = "fixed")]
pub use table::{TableQ15, TableQ31};

#[cfg(test)]
mod tests {
    use super::*;

    /// Every type that an interrupt or a scheduler holds is `Send` and `Sync`; otherwise this does not compile.
    #[test]
    fn an_interrupt_may_hold_everything() {
        fn held<T: Send + Sync>() {}
        held::<(Top, State, Motion, Stepper<f32>, Stepper<f64>, Tick, Phase)>();
        held::<(TableF32, TableF64, SetUpError, ParameterError, ErrorBound)>();
        held::<(Orientation<f32>, AttitudeState<f32>, Event, Level)>();
        held::<(&Table<f32>, Cursor<f32>, Sample<'static, f32>, Events<'static, f32>)>();
        held::<(TableMemory<TableF32>, Workspace)>();
        #[cfg(feature = "fixed")]
        held::<(TableQ31, TableQ15)>();
    }

    /// Public types whose values a program may log have a format for logs; the memory of a set-up has none.
    #[cfg(feature = "defmt")]
    #[test]
    fn firmware_may_log_everything() {
        fn logged<T: defmt::Format>() {}
        logged::<(Complex<f32>, scalar::Extended, Orientation<f32>, su2::OrientationRate<f64>, Phase)>();
        logged::<(ParameterError, PointImpulse, Support, Top, TopParameters, Release, InitialAngles, State)>(
        );
        logged::<(BranchPoints, FirstIntegrals, PeriodAdvance, Regime, TipClass)>();
        logged::<(Motion, Sign, Signs)>();
        logged::<(TableF32, TableF64, ErrorBound, SetUpError, TableSettings, Event, Level)>();
        logged::<(Cursor<f32>, Sample<'static, f64>, AttitudeState<f32>, Stepper<f64>)>();
        #[cfg(feature = "fixed")]
        logged::<(Orientation<fixed::types::I2F30>, Complex<fixed::types::I2F14>)>();
    }
}
