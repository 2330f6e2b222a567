//! Workspace of a set-up, and from a motion to the segments of its table.

use super::expansion::CayleyKleinSeries;
use super::launch_place::LaunchPlace;
use super::limits::Limits;
use super::mean_rates::MeanRates;
use super::path::{HALF_PERIOD, Path};
use super::polynomial::Polynomial;
use super::segmentation::{SegmentStore, Segmentation};
use crate::motion::Motion;
use crate::motion::cayley_klein::Ellipses;
use crate::scalar::{Extended, Float, Ring};

/// Workspace of a set-up, 4 KiB, with its truncation error.
///
/// A program with a small stack keeps it in a static. [`Cursor`](crate::Cursor) shows its use.
#[derive(Debug)]
pub struct Workspace {
    /// Truncation error, rad; `None` for that of the scalar.
    pub(super) truncation: Option<f64>,
    pub(super) limits: Limits,
    pub(super) mean_rates: MeanRates,
    pub(super) launch: LaunchPlace,
    path: Path,
    series: CayleyKleinSeries,
    polynomials: [Polynomial; 2],
    pub(super) segmentation: Segmentation,
    /// Orientation error that does not grow, without that of a tick, rad.
    pub(super) error: f64,
}

impl Default for Workspace {
    fn default() -> Self {
        Self::new()
    }
}

impl Workspace {
    /// Workspace for [`EphemerisScalar::TRUNCATION`](crate::EphemerisScalar::TRUNCATION). A static of it takes no flash.
    #[must_use]
    pub const fn new() -> Self {
        Self {
            truncation: None,
            limits: Limits::ZERO,
            mean_rates: MeanRates::ZERO,
            launch: LaunchPlace::ZERO,
            path: Path::ZERO,
            series: CayleyKleinSeries::ZERO,
            polynomials: [Polynomial::ZERO; 2],
            segmentation: Segmentation::ZERO,
            error: 0.0,
        }
    }

    /// Workspace for another truncation error > 0, rad: a smaller table for a larger error.
    #[must_use]
    pub const fn with_truncation(truncation: f64) -> Self {
        Self { truncation: Some(truncation), ..Self::new() }
    }

    /// Computes mean rates and all segments, from rates in numbers of this many words; `None` if the segments are too many.
    pub(super) fn compute<const WORDS: usize>(
        &mut self,
        motion: &Motion,
        store: &mut dyn SegmentStore,
        pause: &mut dyn FnMut(),
    ) -> Option<()> {
        self.begin::<WORDS>(motion, pause);
        self.build::<WORDS>(motion, store, pause)
    }

    /// Computes the equations and the mean rates, and begins at u = e₁.
    #[inline(never)]
    fn begin<const WORDS: usize>(&mut self, motion: &Motion, pause: &mut dyn FnMut()) {
        let mut period = None;
        if !motion.is_steady() {
            self.path.equations = motion.equations();
            pause();
            period = motion.period::<WORDS>(&self.path.equations, pause);
        }
        self.mean_rates = MeanRates::new(motion, period.as_ref());
        pause();
        let half_period = period.as_ref().map_or(Extended::ZERO, |period| period.time.halved());
        self.path.begin(motion, half_period, &self.mean_rates, &self.limits);
        self.launch = LaunchPlace::new(motion);
        self.segmentation = Segmentation::ZERO;
    }

    /// Computes all segments; `None` if they are too many.
    #[inline(never)]
    fn build<const WORDS: usize>(
        &mut self,
        motion: &Motion,
        store: &mut dyn SegmentStore,
        pause: &mut dyn FnMut(),
    ) -> Option<()> {
        let Ellipses { alpha, beta } = motion.ellipses::<f64>();
        let ellipses = [alpha, beta].map(|ellipse| ellipse.exponentials());
        if motion.is_steady() {
            self.segmentation.store_constants(ellipses.map(|[plus, minus]| plus + minus), store);
            self.error = 0.0;
            return Some(());
        }
        let mut position = 0;
        while position < HALF_PERIOD {
            self.segmentation.enter_span(&mut self.path, position);
            while self.expand_span::<WORDS>(&ellipses, pause).is_none() {
                self.path.shorten_span()?;
            }
            let Self { limits, launch, path, polynomials, segmentation, .. } = self;
            launch.search(&path.expansion, path.end.phases.chi, path.span);
            position = segmentation.segment_span(path, polynomials, limits, store, pause)?;
        }
        let Segmentation { truncation, speeds, .. } = &self.segmentation;
        self.error = truncation + self.path.error(speeds);
        Some(())
    }

    /// Expands the motion on the span and computes the polynomials of a and b; `None` if they are not accurate.
    fn expand_span<const WORDS: usize>(
        &mut self,
        ellipses: &[[f64; 2]; 2],
        pause: &mut dyn FnMut(),
    ) -> Option<()> {
        let Self { limits, path, series, polynomials, .. } = self;
        path.expand::<WORDS>(pause)?;
        for (index, (polynomial, ellipse)) in polynomials.iter_mut().zip(ellipses).enumerate() {
            pause();
            *polynomial = Polynomial::ZERO;
            let sums = polynomial.parts.each_mut().map(|part| &mut part.coefficients);
            let terms = series.compute(&path.expansion, index, *ellipse, limits.negligible_term(), sums)?;
            pause();
            polynomial.finish(terms, limits)?;
        }
        Some(())
    }
}
