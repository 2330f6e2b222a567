//! `defmt::Format`, for logs that are put into words on the host (feature `defmt`).
//!
//! Most types derive it where they are declared. Here are those that would log a table, or numbers that mean nothing by
//! themselves.

use crate::complex::Complex;
use crate::cycle::Cycle;
use crate::error::LaunchError;
use crate::launch::{
    Averages, BranchPoints, FirstIntegrals, Motion, Pace, Regime, Release, Sign, Signs, Start, State,
    TipClass,
};
use crate::real::{DoubleDouble, Real};
use crate::su2::{Phi, PhiRate};
use crate::tick::{
    Cursor, Ephemeris, EphemerisF32, EphemerisF64, ErrorBound, Moment, NoFit, Place, Pose, Stepper, Tabular,
    Tick, Tip, TipAngle, TurningPoint,
};
use crate::top::{Heaviness, Support, Top};
use crate::turns::{Rate, Turns};
use defmt::{Format, Formatter, write};

/// As [`core::fmt::Display`] has it.
impl Format for LaunchError {
    fn format(&self, f: Formatter<'_>) {
        write!(f, "{=str}: must be {=str}", self.parameter(), self.allowed());
    }
}

impl Format for Turns {
    fn format(&self, f: Formatter<'_>) {
        write!(f, "{=f64} turns", self.to_f64());
    }
}

/// As [`core::fmt::Display`] has it.
#[cfg(feature = "fixed")]
impl Format for crate::tick::NoTickMap {
    fn format(&self, f: Formatter<'_>) {
        write!(f, "{}", defmt::Display2Format(self));
    }
}

#[cfg(feature = "fixed")]
impl<const SEGMENTS: usize, const TERMS: usize> Format for crate::tick::FixedStepper<SEGMENTS, TERMS> {
    fn format(&self, f: Formatter<'_>) {
        write!(f, "stepper {=usize}x{=usize} at {}", SEGMENTS, TERMS, self.phi());
    }
}

/// What kind of motion, and between which heights; the rest can be asked for.
impl Format for Motion {
    fn format(&self, f: Formatter<'_>) {
        let e = self.branch_points();
        write!(f, "{} (tip {}), u from {=f64} to {=f64}", self.regime(), self.tip_class(), e.e1, e.e2);
    }
}

impl<R: Real + Format> Format for Stepper<R> {
    fn format(&self, f: Formatter<'_>) {
        write!(f, "stepper at {}", self.phi());
    }
}

/// Its size and its error bound, not the table.
impl<R: Tabular, const SEGMENTS: usize, const TERMS: usize> Format for Ephemeris<R, SEGMENTS, TERMS> {
    fn format(&self, f: Formatter<'_>) {
        write!(f, "ephemeris {=usize}x{=usize}, {}", SEGMENTS, TERMS, self.error_bound());
    }
}

impl<R: Tabular + Format, const SEGMENTS: usize, const TERMS: usize> Format
    for Moment<'_, R, SEGMENTS, TERMS>
{
    fn format(&self, f: Formatter<'_>) {
        write!(f, "{} (nutation {})", self.phi(), self.nutation_phase());
    }
}

/// The moment it is about to give.
impl<R: Tabular + Format, const SEGMENTS: usize, const TERMS: usize> Format
    for Cursor<'_, R, SEGMENTS, TERMS>
{
    fn format(&self, f: Formatter<'_>) {
        let mut ahead = *self;
        write!(f, "cursor before {}", ahead.next());
    }
}

/// Every public type that a firmware meets (not those of [`crate::exact`], nor [`crate::Baked`], which is a table); a new one belongs
/// here.
const _: () = {
    const fn logs<T: Format>() {}
    logs::<(Complex<f32>, Cycle, DoubleDouble, Phi<f32>, PhiRate<f64>, Rate, Turns)>();
    logs::<(LaunchError, Heaviness, Support, Top, Release, Start, State)>();
    logs::<(Averages, BranchPoints, FirstIntegrals, Pace, Regime, TipClass)>();
    logs::<(Motion, Sign, Signs)>();
    logs::<(EphemerisF32, EphemerisF64, ErrorBound, NoFit, Place, Tick, TurningPoint)>();
    logs::<(Cursor<'static, f32, 2, 2>, Moment<'static, f64, 2, 2>)>();
    logs::<(Pose<f32>, Stepper<f64>, Tip<f32>, TipAngle<f64>)>();
    #[cfg(feature = "fixed")]
    logs::<(crate::FixedStepper, crate::NoTickMap, Phi<fixed::types::I2F30>, Complex<fixed::types::I2F14>)>();
};
