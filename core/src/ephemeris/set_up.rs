//! Set-up of an ephemeris: from a motion to the table and the clock.

use crate::ephemeris::clock::Clock;
use crate::ephemeris::error_bound::ErrorBound;
use crate::ephemeris::evaluation::EphemerisScalar;
use crate::ephemeris::mean_rates::MeanRates;
use crate::ephemeris::rate_error::{MotionRates, rate_error};
use crate::ephemeris::storage::{EphemerisStorage, EphemerisView};
use crate::ephemeris::table::{TableTooSmall, fill};
use crate::ephemeris::tick::Tick;
use crate::motion::Motion;
use crate::scalar::Float;

impl<R: EphemerisScalar, const SEGMENTS: usize> EphemerisStorage<R, [R::Segment; SEGMENTS]> {
    /// Ephemeris of a motion. Cost: a series of 16 terms for each segment, of which there are at most `SEGMENTS` (a
    /// segment that is halved is computed again). If the table is too small, up to 4096 more series are computed to
    /// find the sufficient number.
    ///
    /// # Errors
    /// [`TableTooSmall`]: the truncation error would exceed four roundings of the scalar. It states how many segments
    /// are enough.
    pub fn new(motion: &Motion, tick: Tick) -> Result<Self, TableTooSmall> {
        Self::within(motion, tick, 4.0 * R::ROUNDING)
    }

    /// Ephemeris with a given truncation error, in rad: a smaller table for a larger error.
    ///
    /// # Errors
    /// [`TableTooSmall`], as for [`new`](crate::Ephemeris::new).
    pub fn within(motion: &Motion, tick: Tick, truncation: f64) -> Result<Self, TableTooSmall> {
        let mut ephemeris = Self::EMPTY;
        ephemeris.set_up(motion, tick, truncation)?;
        Ok(ephemeris)
    }
}

impl<R: EphemerisScalar> EphemerisView<R> {
    /// Sets up this ephemeris in its own memory, for a chip whose stack is too small for a table.
    ///
    /// # Errors
    /// [`TableTooSmall`]; the table must then not be used, and its error bound is infinite.
    #[inline(never)]
    pub fn set_up(&mut self, motion: &Motion, tick: Tick, truncation: f64) -> Result<(), TableTooSmall> {
        (self.error_bound, self.rate_error_bound) = (ErrorBound::INFINITE, ErrorBound::INFINITE);
        let rates = MeanRates::of(motion, R::ROUNDING);
        let tabulated = fill::<R>(&mut self.cells, &mut self.segments, motion, &rates, truncation)?;
        self.clock = Clock::new(motion, tick, &rates, &tabulated);
        self.start_tip_angle(motion, tabulated.start);
        self.error_bound =
            ErrorBound::of::<R>(&rates, &tabulated, tick.length().to_f64(), self.clock.missed());
        let [_, mean, axial] = self.clock.rates.map(Float::to_f64);
        let rotor = Float::abs(motion.top().rotor_momentum()) / motion.top().transverse_inertia();
        let of_motion = MotionRates { half_period: rates.half_period.to_f64(), mean, axial, rotor };
        self.rate_error_bound = rate_error::<R>(&self.error_bound, &of_motion, &tabulated);
        Ok(())
    }
}
