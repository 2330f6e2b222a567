//! Tabulation of half a nutation period as short polynomials; the other half is its mirror image.
//!
//! Without their mean rotation, α and β are periodic analytic functions of time, and complex conjugates on the two
//! sides of a turning point. Therefore only half a period, from u = e₁ to u = e₂, is divided into segments. The law
//! is expanded around the centre of a span ([`crate::law::series`]); the expansion is restricted to each segment of the
//! span and reduced to the degree of the table.
//!
//! A motion may be fast in one part of the period and slow in another, most of all where e₄ is close to 1. Spans are
//! therefore halved until their series are accurate, and the segments of a [`Cell`](crate::ephemeris::cell::Cell) until
//! their polynomials are.
//!
//! An aperiodic motion is tabulated in the same way, from its lowest point until 1 - u is below the rounding; a
//! steady motion is a single constant.
//!
//! The work is done in pieces of bounded length, so that a chip can do something else between them.

mod cells;

use crate::cayley_klein::Brackets;
use crate::ephemeris::cell::CELLS;
use crate::ephemeris::chebyshev::Chebyshev;
use crate::ephemeris::half_period::{HalfPeriod, Position};
use crate::ephemeris::larger_error::LargerError;
use crate::ephemeris::longer_segments::LongerSegments;
use crate::ephemeris::mean_rates::MeanRates;
use crate::ephemeris::polynomial::{Store, omitted_terms};
use crate::ephemeris::seek::StartSearch;
use crate::ephemeris::segment_errors::SegmentErrors;
use crate::ephemeris::segment_estimate::{Estimation, SegmentEstimate};
use crate::ephemeris::span::{HALF_PERIOD, Span, UpperHalf};
use crate::ephemeris::speeds::Speeds;
use crate::ephemeris::tabulated::{Requirements, Tabulated};
use crate::law::Law;
use crate::law::series::{TERMS, larger_or_nan};
use crate::motion::Motion;
use crate::phase::Phase;
use crate::scalar::{Extended, Float, RateNumber, Ring, times_power_of_two};

/// Fraction of the allowed error that the omitted terms of a span's series may cause. It is small, because these terms are
/// estimated.
const OMITTED_SHARE: f32 = 1.0 / 32.0;

/// Start of the motion on the half period.
#[derive(Clone, Copy, Debug, Default)]
struct TabulatedStart {
    phase: Phase,
    theta: [Phase; 2],
    /// Delay by a relative rounding of the start's χ: see [`Tabulated::start_share`].
    share: f64,
}

/// Next piece of the work.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Piece {
    /// Rates at the border of the span (false), or at its centre (true).
    Rates(bool),
    /// Beginning of the expansion around it.
    Expansion(bool),
    /// Rest of the expansion.
    Terms(bool),
    /// Step from the border to the centre.
    Border,
    /// Step from the centre to the end.
    End,
    /// Series of α (0) or of β (1) on the span.
    Series(usize),
    /// Start of the motion, if it is on the span.
    Start,
    /// Polynomial of α (0) or of β (1) on a segment.
    Polynomial(usize),
    /// Step to the next span.
    Step,
    /// Nothing, because the tabulation is complete.
    Complete,
}

/// State of the tabulation between two pieces of work.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Tabulation {
    /// Steps along the half period.
    path: HalfPeriod,
    /// Coefficients of e^{iχ} and e^{-iχ} in the brackets of α and of β.
    exponentials: [[f64; 2]; 2],
    seek: StartSearch,
    requirements: Requirements,
    estimate: SegmentEstimate,
    /// Length of the half period, in extended precision because the error of a span would accumulate.
    half_period: Extended,
    /// Start of the motion, once it has been passed.
    found_start: Option<TabulatedStart>,
    /// Result so far, without its speeds.
    tabulated: Tabulated,
    /// Upper bounds on the speeds up to this segment, and up to the beginning of the cell.
    speeds: Speeds<f32>,
    speeds_before: Speeds<f32>,
    piece: Piece,
    span: Span,
    /// Index of the cell, and of the segment in it.
    number: usize,
    place: usize,
    /// Number of halvings of the pair of cells: [`Cell::level`](crate::ephemeris::cell::Cell::level).
    level: u32,
    larger: LargerError,
    longer: LongerSegments,
    /// Whether the start had been found before the position marked.
    found_before: bool,
    /// Greatest truncation error of the cell's segments, in units of 2^-62 rad.
    error: f32,
    segment: SegmentErrors,
    /// Series of α and of β on the span, and the omitted terms of each, in units of 2^-62.
    series: [Chebyshev; 2],
    omitted: [f32; 2],
    /// Upper bound on |dθ/dx| on the span.
    theta_slope: f32,
    /// Series on a part of the span: on its lower half, of α or of β, and on its upper half, of both.
    lower_half: Chebyshev,
    upper_halves: [UpperHalf; 2],
}

impl Tabulation {
    /// Tabulation that has not begun.
    pub(crate) const EMPTY: Self = Self {
        path: HalfPeriod::EMPTY,
        exponentials: [[0.0; 2]; 2],
        seek: StartSearch::EMPTY,
        requirements: Requirements::NONE,
        estimate: SegmentEstimate::NONE,
        half_period: Extended::ZERO,
        found_start: None,
        tabulated: Tabulated::EMPTY,
        speeds: Speeds::ZERO,
        speeds_before: Speeds::ZERO,
        piece: Piece::Complete,
        span: Span::FIRST,
        number: 0,
        place: 0,
        level: 0,
        larger: LargerError::NONE,
        longer: LongerSegments::UNTRIED,
        found_before: false,
        error: 0.0,
        segment: SegmentErrors::NONE,
        series: [Chebyshev::ZERO; 2],
        omitted: [0.0; 2],
        theta_slope: 0.0,
        lower_half: Chebyshev::ZERO,
        upper_halves: [UpperHalf::NONE; 2],
    };

    /// Computes the law of a motion that is not steady, before its mean rates and [`Tabulation::begin`].
    pub(crate) fn find_law<N: RateNumber>(&mut self, motion: &Motion) {
        self.path.find_law::<N>(motion);
    }

    /// Law of the motion.
    pub(crate) fn law(&self) -> &Law<Extended> {
        self.path.law()
    }

    /// Begins the tabulation.
    #[inline(never)]
    pub(crate) fn begin(&mut self, motion: &Motion, rates: &MeanRates, requirements: Requirements) {
        let least = requirements.of_series() / (4 * requirements.most.min(16 * CELLS)) as f64;
        self.path.begin(rates, least);
        let Brackets { alpha, beta } = motion.brackets::<f64>();
        self.exponentials = [alpha.exponentials(), beta.exponentials()];
        self.seek = StartSearch::new(motion, self.path.law(), rates);
        self.half_period = rates.half_period;
        self.again(requirements, SegmentEstimate::NONE);
    }

    /// Continues the estimates of the segments that tables with these requirements need. Returns whether they are complete.
    pub(crate) fn estimate(
        &self,
        rates: &MeanRates,
        requirements: &[Requirements; 2],
        estimation: &mut Estimation,
    ) -> bool {
        estimation.proceed(self.path.law(), &self.exponentials, rates, requirements)
    }

    /// Begins again with other requirements on the table, and the estimate of the segments that they need.
    pub(crate) fn again(&mut self, requirements: Requirements, estimate: SegmentEstimate) {
        self.path.restart();
        (self.requirements, self.estimate) = (requirements, estimate);
        self.found_start = None;
        self.found_before = false;
        self.tabulated = Tabulated { segments: 0, ..Tabulated::EMPTY };
        (self.speeds, self.speeds_before) = (Speeds::ZERO, Speeds::ZERO);
        (self.number, self.level, self.place, self.error) = (0, 0, 0, 0.0);
        self.larger = LargerError::NONE;
        self.longer = LongerSegments::UNTRIED;
        self.span = Span::FIRST;
        self.piece = Piece::Rates(false);
    }

    /// Does the next piece of work. It passes the polynomials of each segment to `store`. A segment may be passed more than
    /// once, and the last time is valid. Returns whether the tabulation is complete.
    ///
    /// # Errors
    /// The segments would exceed the largest number allowed.
    pub(crate) fn advance(&mut self, store: &mut Store<'_>) -> Result<bool, ()> {
        let next = match self.piece {
            Piece::Rates(at_centre) => {
                self.path.prepare(self.unit());
                Some(Piece::Expansion(at_centre))
            }
            Piece::Expansion(at_centre) => {
                self.path.begin_expansion(self.share());
                Some(Piece::Terms(at_centre))
            }
            Piece::Terms(at_centre) => Some(match (self.path.proceed(), at_centre) {
                (false, _) => Piece::Terms(at_centre),
                (true, false) => Piece::Border,
                (true, true) => Piece::End,
            }),
            Piece::Border => self.path.step_to_centre(self.share()).map(|()| Piece::Rates(true)),
            Piece::End => self.path.reach_end(self.share()).map(|()| Piece::Series(0)),
            Piece::Series(which) => self.turn(which),
            Piece::Start => {
                self.theta_slope = self.path.expansion().greatest_theta_slope();
                self.note_start();
                Some(self.enter()?)
            }
            Piece::Polynomial(which) => Some(self.shorten(which, store)?),
            Piece::Step => Some(self.step()),
            Piece::Complete => return Ok(true),
        };
        self.piece = match next {
            Some(next) => next,
            None => self.halve_span()?,
        };
        Ok(false)
    }

    /// Begins the span again with one of half the length, or less.
    fn halve_span(&mut self) -> Result<Piece, ()> {
        for _ in 0..self.path.halvings(self.share()) {
            self.span = self.span.first_half().ok_or(())?;
            // a span shorter than the segments makes them shorter
            if self.level < self.span.least_level() {
                break;
            }
        }
        self.path.return_to_border();
        if self.place > 0 && self.level < self.span.least_level() {
            return self.divide(self.span.least_level());
        }
        // a cell in which it is has at least this number of segments
        self.check_capacity(self.level.max(self.span.least_level()))?;
        Ok(Piece::Rates(false))
    }

    /// Half the length of a span, as a time.
    fn unit(&self) -> Extended {
        (0..=self.span.depth()).fold(self.half_period, |length, _| length.halved())
    }

    /// Truncation error allowed for a step over half a span, so that the sum over all steps is within their fraction of
    /// the allowed error.
    fn share(&self) -> f64 {
        times_power_of_two(self.requirements.of_steps(), -1 - self.span.depth() as i32)
    }

    /// Series of α or of β on the span from those of the phases; `None` where it is not accurate.
    #[inline(never)] // its polynomial must not lie below the frames of the other pieces
    fn turn(&mut self, which: usize) -> Option<Piece> {
        let mut polynomial = [[0; TERMS]; 2];
        let [re, im] = polynomial.each_mut();
        let terms = self.path.turned(which, *self.exponentials.get(which)?, [&mut *re, &mut *im])?;
        // both parts; as an orientation error twice as much
        let omitted = 2.0 * larger_or_nan(omitted_terms(re), omitted_terms(im));
        *self.omitted.get_mut(which)? = omitted + self.path.least_term();
        (2.0 * omitted <= OMITTED_SHARE * self.requirements.of_polynomials()).then_some(())?;
        self.series.get_mut(which)?.set(&polynomial, terms);
        *self.upper_halves.get_mut(which)? = UpperHalf::NONE;
        Some(if which == 0 { Piece::Series(1) } else { Piece::Start })
    }

    /// Notes the start of the motion, if it is on this span.
    fn note_start(&mut self) {
        if self.found_start.is_some() {
            return;
        }
        let (expansion, end) = (self.path.expansion(), self.path.end_chi());
        if let Some(x) = self.seek.within(expansion, end, self.span.next().begin() == HALF_PERIOD) {
            let share = self.seek.per_rounding(expansion, x) * self.path.part();
            let theta = expansion.theta_at(x);
            self.found_start = Some(TabulatedStart { phase: self.span.phase(x), theta, share });
        }
    }

    /// Steps to the centre of the next span, which has the same or twice the length, if the series is accurate so far,
    /// otherwise to its border.
    fn step(&mut self) -> Piece {
        if self.number == CELLS {
            return Piece::Complete;
        }
        let share = self.share();
        let next = self.span.next();
        // the expected segments of the next cell may be longer than the span
        let is_short = self.level < next.least_level();
        let doubled = next.doubled().filter(|_| is_short || self.path.reaches_twice_as_far(share));
        let x = if doubled.is_some() { 3 } else { 2 };
        let at_centre = self.path.leave(x, f64::from(x) * share);
        self.span = doubled.unwrap_or(next);
        if self.place == 0 {
            self.path.mark();
            self.found_before = self.found_start.is_some();
        }
        Piece::Rates(at_centre)
    }

    /// Result of a complete tabulation.
    #[inline(never)]
    pub(crate) fn result(&self, motion: &Motion) -> Tabulated {
        let TabulatedStart { phase, theta, share } = self.found_start.unwrap_or_default();
        let Position { remainder, squares, .. } = *self.path.end();
        let speeds = self.speeds.to_f64();
        let stepping = speeds.truncation_error(remainder, self.path.fastest_per_half_period());
        Tabulated {
            start: self.seek.start(motion, phase, theta),
            start_share: share,
            speeds,
            squares: squares.map(f64::from),
            stepping,
            truncation: self.tabulated.truncation + stepping,
            defect: self.path.defect(&speeds),
            ..self.tabulated
        }
    }
}
