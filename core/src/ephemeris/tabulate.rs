//! Tabulation of half a nutation period as short polynomials; the other half is its mirror image.
//!
//! Without their mean rotation, α and β are periodic analytic functions of time, and complex conjugates on the two
//! sides of a turning point. Therefore only half a period, from u = e₁ to u = e₂, is divided into segments. The law
//! is expanded around the centre of each segment ([`crate::law::series`]), and the expansion is reduced to the degree
//! of the table.
//!
//! A motion may be fast in one part of the period and slow in another, most of all where e₄ is close to 1. Segments
//! therefore differ in length: those of a [`Cell`] are halved until the error is small enough.
//!
//! An aperiodic motion is tabulated in the same way, from its lowest point until 1 - u is below the rounding; a
//! steady motion is a single constant.
//!
//! The work is done in pieces of bounded length, so that a chip can do something else between them.

use crate::cayley_klein::Brackets;
use crate::ephemeris::cell::{CELLS, Cell, PAIR_BITS, PAIRS, cells_covered, segments_per_cell};
use crate::ephemeris::economise::Polynomial;
use crate::ephemeris::half_period::{HalfPeriod, Position};
use crate::ephemeris::larger_error::LargerError;
use crate::ephemeris::mean_rates::MeanRates;
use crate::ephemeris::seek::StartSearch;
use crate::ephemeris::segment_errors::SegmentErrors;
use crate::ephemeris::speeds::Speeds;
use crate::ephemeris::tabulated::{Requirements, Tabulated};
use crate::law::series::{TERMS, larger_or_nan};
use crate::motion::Motion;
use crate::phase::Phase;
use crate::scalar::{Extended, Ring};

/// Receiver of polynomials: see [`Tabulation::advance`]. A reference, so that set-up is compiled once for all scalars.
pub(crate) type Store<'a> = dyn FnMut(usize, usize, Polynomial<'_>) -> [f64; 2] + 'a;

/// Factor by which the expected error of longer segments may exceed the allowed error and they are still tried in the
/// next cell. A failed trial costs one series; an unnecessary segment takes memory in the table.
const COARSENING: f64 = 4.0;

/// Fraction of the allowed error that a segment of two cells may have. Its derivative, from which the angular velocity is
/// computed, is then no worse than on the shorter segments of other motions.
const PAIR_SHARE: f64 = 0.125;

/// Fraction of the allowed error that the steps from segment to segment may use.
const STEPPING_SHARE: f64 = 0.125;

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
    /// Number of halvings of a cell, or the end.
    Cell,
    /// Rates at the border of the cell or of two segments (false), or at the centre of a segment (true).
    Rates(bool),
    /// Beginning of the expansion around it.
    Expansion(bool),
    /// Rest of the expansion.
    Terms(bool),
    /// Step from the border to the next centre.
    Border,
    /// Series of α (0) or of β (1) on the segment.
    Series(usize),
    /// Polynomial made from that series.
    Polynomial(usize),
    /// Start of the motion, if it is on the segment.
    Start,
    /// Step to the next centre or border.
    Step,
    /// Result.
    Result,
}

/// State of the tabulation between two pieces of work.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Tabulation {
    /// Steps along the half period.
    path: HalfPeriod,
    brackets: Brackets<f64>,
    seek: StartSearch,
    requirements: Requirements,
    /// Truncation error that the reduction of a segment's series may cause.
    allowed: f64,
    /// Half the length of a pair of cells, in extended precision because its error would accumulate.
    half_pair: Extended,
    /// Start of the motion, once it has been passed.
    found_start: Option<TabulatedStart>,
    /// Result so far; its speeds and its start at the beginning of the cell.
    tabulated: Tabulated,
    /// Upper bounds on the speeds up to this position.
    speeds: Speeds,
    piece: Piece,
    /// Index of the cell, and of the segment in it.
    number: usize,
    place: usize,
    /// Number of halvings of the pair of cells: [`Cell::level`].
    level: u32,
    larger: LargerError,
    /// Whether the start had been found before this cell.
    found_before: bool,
    /// Whether the position is the first centre of the cell, not its border.
    at_centre: bool,
    /// Greatest truncation error of the cell's segments.
    error: f64,
    segment: SegmentErrors,
    /// Real and imaginary part of the series of α or β, in units of 2^-62.
    series: [[i64; TERMS]; 2],
}

impl Tabulation {
    /// Tabulation that has not begun.
    pub(crate) const EMPTY: Self = Self {
        path: HalfPeriod::EMPTY,
        brackets: Brackets::ZERO,
        seek: StartSearch::EMPTY,
        requirements: Requirements { terms: 0, allowed: 0.0, most: 0 },
        allowed: 0.0,
        half_pair: Extended::ZERO,
        found_start: None,
        tabulated: Tabulated::EMPTY,
        speeds: Speeds::ZERO,
        piece: Piece::Result,
        number: 0,
        place: 0,
        level: 0,
        larger: LargerError::NONE,
        found_before: false,
        at_centre: false,
        error: 0.0,
        segment: SegmentErrors::NONE,
        series: [[0; TERMS]; 2],
    };

    /// Begins the tabulation of a motion that is not steady.
    #[inline(never)]
    pub(crate) fn begin(&mut self, motion: &Motion, rates: &MeanRates, requirements: Requirements) {
        let least = rates.rounding / (16 * requirements.most.min(16 * CELLS)) as f64;
        self.path.begin(motion, rates, least);
        self.brackets = motion.brackets();
        self.seek = StartSearch::new(motion, self.path.law(), rates);
        self.half_pair = rates.half_period / Extended::from((2 * PAIRS) as f64);
        self.again(requirements);
    }

    /// Begins again with other requirements on the table.
    pub(crate) fn again(&mut self, requirements: Requirements) {
        self.path.restart();
        self.requirements = requirements;
        self.allowed = (1.0 - STEPPING_SHARE) * requirements.allowed;
        self.found_start = None;
        self.tabulated = Tabulated { segments: 0, ..Tabulated::EMPTY };
        self.speeds = Speeds::ZERO;
        (self.number, self.level, self.at_centre) = (0, 0, false);
        self.larger = LargerError::NONE;
        self.begin_cell();
    }

    fn begin_cell(&mut self) {
        self.piece = Piece::Cell;
        self.found_before = self.found_start.is_some();
        self.tabulated.speeds = self.speeds;
    }

    /// Does the next piece of work. It passes the polynomials of each segment to `store`: the index of the segment, 0
    /// for α or 1 for β, and the coefficients, of which the first `terms` are used. `store` returns the orientation
    /// error and the error of the derivative from rounding them. A segment may be passed more than once, and the last
    /// time is valid. The result is the tabulation's, once it is complete.
    ///
    /// # Errors
    /// The segments would exceed the largest number allowed.
    pub(crate) fn advance(
        &mut self,
        motion: &Motion,
        store: &mut Store<'_>,
    ) -> Result<Option<Tabulated>, ()> {
        let next = match self.piece {
            Piece::Cell => Some(self.divide()?),
            Piece::Rates(at_centre) => {
                self.path.prepare(self.unit());
                Some(Piece::Expansion(at_centre))
            }
            Piece::Expansion(at_centre) => {
                self.path.begin_expansion();
                Some(Piece::Terms(at_centre))
            }
            Piece::Terms(at_centre) => Some(match (self.path.proceed(), at_centre) {
                (false, _) => Piece::Terms(at_centre),
                (true, false) => Piece::Border,
                (true, true) => Piece::Series(0),
            }),
            Piece::Border => self.path.to(1, self.share()).map(|()| Piece::Rates(true)),
            Piece::Series(which) => self.turn(which),
            Piece::Polynomial(which) => self.shorten(which, store),
            Piece::Start => {
                self.note_start();
                Some(Piece::Step)
            }
            Piece::Step => self.step(),
            Piece::Result => return Ok(Some(self.result(motion))),
        };
        match next {
            Some(next) => self.piece = next,
            None => self.refine(),
        }
        Ok(None)
    }

    /// Divides the cell into segments.
    fn divide(&mut self) -> Result<Piece, ()> {
        let segments = self.tabulated.segments;
        if self.level > Cell::DEEPEST || segments + self.least_rest(self.level) > self.requirements.most {
            return Err(());
        }
        let cells = self.tabulated.cells.iter_mut().enumerate();
        for (number, cell) in cells.skip(self.number).take(cells_covered(self.level)) {
            *cell = Cell::new(number, segments, self.level);
        }
        (self.place, self.error) = (0, 0.0);
        Ok(Piece::Rates(self.at_centre))
    }

    /// Least number of segments of the cell at a level and of those after it.
    fn least_rest(&self, level: u32) -> usize {
        let rest = CELLS.saturating_sub(self.number + cells_covered(level));
        segments_per_cell(level) + rest.div_ceil(2)
    }

    /// Whether a refused table might have fitted with the larger error: an estimate from the errors of the cells so far.
    pub(crate) fn may_fit_with_larger_error(&self) -> bool {
        self.larger.may_fit(self.level, |level| self.least_rest(level), self.requirements.most)
    }

    /// Begins the cell again with segments of half the length.
    fn refine(&mut self) {
        (self.level, self.at_centre) = (self.level + 1, false);
        self.path.return_to_border();
        self.found_start = self.found_start.filter(|_| self.found_before);
        self.speeds = self.tabulated.speeds;
        self.piece = Piece::Cell;
    }

    /// Truncation error that a segment may have.
    fn allowed(&self, level: u32) -> f64 {
        if level == 0 { PAIR_SHARE * self.allowed } else { self.allowed }
    }

    /// Half the length of a segment.
    fn unit(&self) -> Extended {
        self.half_pair * Extended::from(1.0 / f64::from(1_u32 << self.level))
    }

    /// Truncation error allowed for a step over half a segment, so that the sum over all steps is within their
    /// fraction of the allowed error.
    fn share(&self) -> f64 {
        STEPPING_SHARE * self.requirements.allowed / ((2 * PAIRS) << self.level) as f64
    }

    /// Series of α or of β from those of the phases.
    fn turn(&mut self, which: usize) -> Option<Piece> {
        let bracket = if which == 0 { &self.brackets.alpha } else { &self.brackets.beta };
        let [re, im] = &mut self.series;
        self.path.turned(which, bracket.exponentials(), [re, im])?;
        Some(Piece::Polynomial(which))
    }

    /// Stores the series of α or of β as a polynomial of reduced degree.
    #[inline(never)]
    fn shorten(&mut self, which: usize, store: &mut Store<'_>) -> Option<Piece> {
        let ([mut re, mut im], segment) = (self.series, self.tabulated.segments + self.place);
        if which == 0 {
            self.segment = SegmentErrors::NONE;
        }
        let store = |parts: Polynomial<'_>| store(segment, which, parts);
        self.segment.shorten([&mut re, &mut im], self.requirements.terms, store);
        if which == 0 { Some(Piece::Series(1)) } else { self.judge() }
    }

    /// Next piece after a segment; `None` where its error is too large.
    fn judge(&mut self) -> Option<Piece> {
        let theta_slope = self.path.expansion().greatest_theta_slope();
        self.speeds.note(self.segment.speeds(), theta_slope, self.path.part());
        self.error = larger_or_nan(self.error, self.segment.error());
        self.larger.note(self.error <= LargerError::FACTOR * self.allowed(self.level), self.level);
        let piece = if self.found_start.is_none() { Piece::Start } else { Piece::Step };
        (self.error <= self.allowed(self.level)).then_some(piece)
    }

    fn is_last(&self) -> bool {
        self.place + 1 == segments_per_cell(self.level)
    }

    /// Notes the start of the motion, if it is on this segment.
    fn note_start(&mut self) {
        let end = self.is_last() && self.number + cells_covered(self.level) == CELLS;
        let expansion = self.path.expansion();
        if let Some(x) = self.seek.within(expansion, end) {
            // half a turn of the nutation phase over all pairs
            let halvings = 2 + PAIR_BITS + self.level;
            let centre = 2 * (((self.number << self.level) >> 1) + self.place) + 1;
            let phase = Phase::from_bits(centre as i128 * (Phase::ONE.to_bits() >> halvings))
                + Phase::new(x / (1_u64 << halvings) as f64);
            let share = self.seek.per_rounding(expansion, x) * self.path.part();
            self.found_start = Some(TabulatedStart { phase, theta: expansion.theta_at(x), share });
        }
    }

    /// Steps to the centre of the next segment, or to the end of the cell.
    fn step(&mut self) -> Option<Piece> {
        let share = self.share();
        if self.is_last() {
            self.path.move_border(share)?;
            return Some(self.leave());
        }
        self.place += 1;
        if self.path.to(2, 2.0 * share).is_some() {
            return Some(Piece::Rates(true));
        }
        // by way of the border between the two segments
        self.path.to(1, share)?;
        Some(Piece::Rates(false))
    }

    /// Leaves a complete cell: to the first centre of the next, whose segments have the same or twice the length, if
    /// the series is accurate so far, otherwise to the border.
    fn leave(&mut self) -> Piece {
        let level = self.level;
        // segments of twice the length would have about 2^terms times the error
        let longer_error = self.error * f64::from(1_u32 << self.requirements.terms);
        let next = self.number + cells_covered(level);
        let longest = u32::from(next % 2 == 1);
        let coarser = level > longest && longer_error < COARSENING * self.allowed(level - 1);
        self.tabulated.truncation = larger_or_nan(self.tabulated.truncation, self.error);
        self.tabulated.segments += segments_per_cell(level);
        self.larger.leave(level, coarser);
        self.number = next;
        if self.number == CELLS {
            self.path.return_to_border();
            return Piece::Result;
        }
        let x = if coarser { 3 } else { 2 };
        self.at_centre = self.path.to(x, x as f64 * self.share()).is_some();
        if !self.at_centre {
            self.path.return_to_border();
        }
        self.level -= u32::from(coarser);
        self.begin_cell();
        Piece::Cell
    }

    #[inline(never)]
    fn result(&self, motion: &Motion) -> Tabulated {
        let TabulatedStart { phase, theta, share } = self.found_start.unwrap_or_default();
        let Position { remainder, squares, .. } = *self.path.position();
        let stepping = self.speeds.truncation_error(remainder, self.path.fastest_per_half_period());
        Tabulated {
            start: self.seek.start(motion, phase, theta),
            start_share: share,
            speeds: self.speeds,
            squares,
            stepping,
            truncation: self.tabulated.truncation + stepping,
            defect: self.path.defect(&self.speeds),
            ..self.tabulated
        }
    }
}
