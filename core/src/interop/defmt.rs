//! Implementations of `defmt::Format`, for logs that are formatted on the host (feature `defmt`).
//!
//! Most types derive it. Here are those whose fields are a table, or numbers without meaning on their own.

use crate::scalar::Real;
use crate::{
    Cursor, Ephemeris, EphemerisScalar, EphemerisView, Motion, ParameterError, Phase, Sample, Stepper,
};
use core::ops::Deref;
use defmt::{Format, Formatter, write};

/// The text of [`core::fmt::Display`].
impl Format for ParameterError {
    fn format(&self, f: Formatter<'_>) {
        write!(f, "{=str}: must be {=str}", self.parameter(), self.allowed());
    }
}

impl Format for Phase {
    fn format(&self, f: Formatter<'_>) {
        write!(f, "{=f64} turns", self.to_f64());
    }
}

/// Regime, tip class and bounds of u; other constants have their own accessors.
impl Format for Motion {
    fn format(&self, f: Formatter<'_>) {
        let e = self.branch_points();
        write!(f, "{} (tip {}), u from {=f64} to {=f64}", self.regime(), self.tip_class(), e.e1, e.e2);
    }
}

impl<R: Real + Format> Format for Stepper<R> {
    fn format(&self, f: Formatter<'_>) {
        write!(f, "stepper at {}", self.orientation());
    }
}

/// Capacity and error bound, not the table.
impl<R: EphemerisScalar, const SEGMENTS: usize> Format for Ephemeris<R, SEGMENTS> {
    fn format(&self, f: Formatter<'_>) {
        write!(f, "ephemeris of {=usize} segments, {}", SEGMENTS, self.error_bound());
    }
}

impl<R: EphemerisScalar + Format> Format for Sample<'_, R> {
    fn format(&self, f: Formatter<'_>) {
        write!(f, "{} (nutation {})", self.orientation(), self.nutation_phase());
    }
}

/// Tick of the last sample.
impl<R: EphemerisScalar, T: Deref<Target = EphemerisView<R>>> Format for Cursor<T> {
    fn format(&self, f: Formatter<'_>) {
        write!(f, "cursor at tick {=i64}", self.tick());
    }
}

#[cfg(test)]
mod tests {
    use crate::scalar::Extended;
    use crate::su2::OrientationRate;
    use crate::*;
    use defmt::Format;

    /// Every public type for firmware implements `Format`, except [`Baked`], which is a table; otherwise this does not compile. A new type
    /// must be added here.
    #[test]
    fn every_type_can_be_logged() {
        fn logs<T: Format>() {}
        logs::<(Complex<f32>, Extended, Orientation<f32>, OrientationRate<f64>, Phase)>();
        logs::<(ParameterError, Support, Top, TopParameters, Release, InitialPhases, State)>();
        logs::<(BranchPoints, FirstIntegrals, PeriodAdvance, Regime, TipClass)>();
        logs::<(Motion, Sign, Signs, Event, Level)>();
        logs::<(EphemerisF32, EphemerisF64, ErrorBound, SetUpError, Tick)>();
        logs::<(Cursor<&EphemerisView<f64>>, Sample<'static, f64>)>();
        logs::<(AttitudeState<f32>, Stepper<f64>)>();
        #[cfg(feature = "fixed")]
        logs::<(Orientation<fixed::types::I2F30>, Complex<fixed::types::I2F14>)>();
    }
}
