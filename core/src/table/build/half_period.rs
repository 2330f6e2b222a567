//! Half a nutation period as a table; the other half is its mirror image.

use super::error_budget::ErrorBudget;
use super::mean_rates::MeanRates;
use super::path::polynomial::Polynomial;
use super::path::{Path, PathScratch};
use super::segment::store_polynomial;
use super::set_up_error::SetUpError;
use super::tabulation::{Division, Tabulation};
use crate::body::check;
use crate::constants::Regime;
use crate::motion::Motion;
use crate::motion::ellipses::Ellipses;
use crate::motion::period::Period;
use crate::phase::Phase;
use crate::scalar::Float;
use crate::table::evaluation::TableScalar;
use crate::table::time::Phases;

/// Quantities of half a period besides its segments.
#[derive(Debug)]
pub(super) struct TabulatedHalfPeriod {
    pub(super) mean_rates: MeanRates,
    /// Nutation phase and mean phases of the launch.
    pub(super) launch_phases: Phases<Phase>,
    pub(super) division: Division,
    /// Constant orientation error, without the roundings of a tick, rad.
    pub(super) error: f64,
}

impl TabulatedHalfPeriod {
    /// Half a period before a set-up. All its bits are 0.
    pub(super) const ZERO: Self = Self {
        mean_rates: MeanRates::ZERO,
        launch_phases: Phases::from_array([Phase::ZERO; 3]),
        division: Division::ZERO,
        error: 0.0,
    };

    /// Computes the segments and stores them.
    ///
    /// * `truncation`: allowed truncation error, rad
    /// * `segments`: memory of the segments; a segment beyond it overwrites the last place. To count the segments, one place is enough
    /// * `capacity`: greatest number of segments
    ///
    /// # Errors
    /// [`SetUpError`]
    pub(super) fn compute<R: TableScalar>(
        &mut self,
        motion: &Motion,
        truncation: f64,
        scratch: &mut PathScratch,
        segments: &mut [R::Segment],
        capacity: usize,
        pause: &mut dyn FnMut(),
    ) -> Result<(), SetUpError> {
        let is_allowed = truncation > 0.0 && truncation < f64::INFINITY;
        check(is_allowed, "truncation", "positive and finite").map_err(SetUpError::Parameter)?;
        if motion.regime() == Regime::Aperiodic {
            return Err(SetUpError::Aperiodic);
        }
        *self = Self::ZERO;
        scratch.set_equations(motion);
        pause();
        // a steady motion has the period of an infinitesimal nutation, which does not count
        let equations = &scratch.equations;
        let period = if motion.is_steady() { None } else { motion.period::<R::SetUpFloat>(equations, pause) };
        self.mean_rates = MeanRates::new(motion, period.as_ref());
        pause();
        match period {
            Some(Period { time, .. }) => {
                let budget = ErrorBudget::new::<R>(truncation);
                let mut path =
                    Path::new(scratch, &budget, motion, time.halved(), self.mean_rates.rates, pause);
                Tabulation::<R>::new(&mut self.division, &mut path, segments, capacity)
                    .tabulate()
                    .ok_or(SetUpError::TableTooSmall { truncation, segments: capacity as u32 })?;
                self.launch_phases = path.launch.phases;
                let [delay, residual] = path.errors();
                let bounds = &self.division.bounds;
                self.error = f64::from(bounds.error) + bounds.error_of_delay(delay) + 2.0 * residual;
            }
            None => {
                let [alpha, beta] = motion.slow_phases;
                self.launch_phases = Phases { alpha, beta, ..self.launch_phases };
                self.store_constants::<R>(motion, segments);
            }
        }
        Ok(())
    }

    /// Stores one segment with constant a and b, for a steady motion.
    fn store_constants<R: TableScalar>(&mut self, motion: &Motion, segments: &mut [R::Segment]) {
        let Ellipses { alpha, beta } = motion.ellipses;
        let Some(first) = segments.first_mut() else { return };
        for (index, ellipse) in [alpha, beta].into_iter().enumerate() {
            let [plus, minus] = ellipse.exponentials();
            store_polynomial::<R>(first, index, &Polynomial::constant(plus + minus));
        }
        self.division.segment_count = 1;
    }
}
