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

use crate::cayley_klein::Brackets;
use crate::ephemeris::cell::{CELL_BITS, CELLS, Cell};
use crate::ephemeris::economise::{Polynomial, beyond_the_last, economise};
use crate::ephemeris::mean_rates::MeanRates;
use crate::ephemeris::seek::StartSearch;
use crate::ephemeris::speeds::{SegmentSpeeds, Speeds, greatest_slopes};
use crate::ephemeris::tabulated::{Requirements, Tabulated};
use crate::law::series::{Expansion, PhasePoint, Slopes, TERMS, UNIT, larger_or_nan};
use crate::law::{Law, PhaseRates};
use crate::motion::Motion;
use crate::phase::Phase;
use crate::scalar::{Extended, Float, Scalar};

/// Receiver of polynomials: see [`tabulate`]. A reference, so that set-up is compiled once for all scalars.
pub(crate) type Store<'a> = dyn FnMut(usize, usize, Polynomial<'_>) -> [f64; 2] + 'a;

/// Tabulates a motion. It passes the polynomials of each segment to `store`: the index of the segment, 0 for α or 1
/// for β, and the coefficients, of which the first `terms` are used. `store` returns the orientation error and the
/// error of the derivative from rounding them. A segment may be passed more than once, and the last time is valid.
/// The result is `None` where the segments would exceed the largest number allowed.
#[inline(never)]
pub(crate) fn tabulate(
    motion: &Motion,
    rates: &MeanRates,
    requirements: Requirements,
    store: &mut Store<'_>,
) -> Option<Tabulated> {
    if motion.is_steady() {
        return Some(constant(motion, store));
    }
    let law = motion.law();
    let seek = StartSearch::new(motion, &law, rates.half_period.to_f64());
    let mut expansion = Expansion::EMPTY;
    let mut tabulation = Tabulation {
        law: &law,
        brackets: &motion.brackets(),
        rates,
        seek: &seek,
        requirements,
        allowed: (1.0 - STEPPING_SHARE) * requirements.allowed,
        half_cell: rates.half_period / Extended::from((2 * CELLS) as f64),
        least: rates.rounding / (16 * requirements.most.min(16 * CELLS)) as f64,
        expansion: &mut expansion,
        part: 0.0,
        current: Position::default(),
        border: Position::default(),
        found_start: None,
        fastest: 0.0,
        speeds: Speeds::ZERO,
    };
    tabulation.fastest = larger_or_nan(tabulation.speed(0.0, 1.0), tabulation.speed(1.0, 0.0));
    let mut tabulated = Tabulated { segments: 0, ..Tabulated::EMPTY };
    let (mut level, mut at_centre) = (0, false);
    for (number, cell) in tabulated.cells.iter_mut().enumerate() {
        let (found_before, speeds) = (tabulation.found_start.is_some(), tabulation.speeds);
        let error = loop {
            *cell = Cell::new(tabulated.segments, level);
            if level > Cell::DEEPEST || tabulated.segments + (1 << level) > requirements.most {
                return None;
            }
            if let Some(error) = tabulation.through(number, *cell, at_centre, store) {
                break error;
            }
            (level, at_centre) = (level + 1, false);
            tabulation.current = tabulation.border;
            tabulation.found_start = tabulation.found_start.filter(|_| found_before);
            tabulation.speeds = speeds;
        };
        tabulated.truncation = larger_or_nan(tabulated.truncation, error);
        tabulated.segments += 1 << level;
        // segments of twice the length would have about 2^terms times the error
        let coarser =
            level > 0 && error * f64::from(1_u32 << requirements.terms) < COARSENING * tabulation.allowed;
        at_centre = tabulation.cross(level, coarser);
        level -= u32::from(coarser);
    }
    let TabulatedStart { phase, theta, share } = tabulation.found_start.unwrap_or_default();
    tabulated.start = seek.start(motion, phase, theta);
    tabulated.start_share = share;
    tabulated.speeds = tabulation.speeds;
    tabulated.squares = tabulation.border.squares;
    let fastest = tabulation.fastest * rates.half_period.to_f64();
    tabulated.stepping = tabulation.speeds.left_out(tabulation.border.remainder, fastest);
    tabulated.truncation += tabulated.stepping;
    tabulated.defect = if rates.returns { tabulation.defect() } else { 0.0 };
    Some(tabulated)
}

/// Tabulation of a steady motion: α and β at χ = 0, which are constant.
#[inline(never)]
fn constant(motion: &Motion, store: &mut Store<'_>) -> Tabulated {
    let brackets: Brackets<f64> = motion.brackets();
    for (which, bracket) in [&brackets.alpha, &brackets.beta].into_iter().enumerate() {
        let [plus, minus] = bracket.exponentials();
        let mut re = [0; TERMS];
        re[0] = libm::round((plus + minus) / UNIT) as i64;
        store(0, which, [&mut re, &mut [0; TERMS]]);
    }
    let [alpha, beta] = motion.phases();
    Tabulated { start: [Phase::ZERO, alpha, beta], ..Tabulated::EMPTY }
}

/// Factor by which the expected error of longer segments may exceed the allowed error and they are still tried in the
/// next cell. A failed trial costs one series; an unnecessary segment takes memory in the table.
const COARSENING: f64 = 4.0;

/// Fraction of the allowed error that the steps from segment to segment may use.
const STEPPING_SHARE: f64 = 0.125;

/// State of the steps through the segments of the half period.
struct Tabulation<'a> {
    law: &'a Law<Extended>,
    brackets: &'a Brackets<f64>,
    rates: &'a MeanRates,
    seek: &'a StartSearch,
    requirements: Requirements,
    /// Truncation error that the reduction of a segment's series may cause.
    allowed: f64,
    /// Half the length of a cell, in extended precision because its error would accumulate over the cells.
    half_cell: Extended,
    /// Magnitude below which a term of the series is negligible.
    least: f64,
    /// Expansion around the border of a cell or the centre of a segment.
    expansion: &'a mut Expansion,
    /// Unit of x in the expansion, in units of half a period.
    part: f64,
    current: Position,
    /// Position at the beginning of the cell.
    border: Position,
    /// Sum of the rates of χ, θ_A and θ_B at the turning point where it is greater; the weight of an error of χ.
    fastest: f64,
    /// Upper bounds on the speeds up to this position.
    speeds: Speeds,
    /// Start of the motion, once it has been passed.
    found_start: Option<TabulatedStart>,
}

/// Start of the motion on the half period.
#[derive(Clone, Copy, Debug, Default)]
struct TabulatedStart {
    phase: Phase,
    theta: [Phase; 2],
    /// Delay by a relative rounding of the start's χ: see [`Tabulated::start_share`].
    share: f64,
}

/// Position reached by the steps, with the errors so far.
#[derive(Clone, Copy, Debug, Default)]
struct Position {
    point: PhasePoint,
    /// Truncation error of the series so far, estimated from their last terms.
    remainder: f64,
    /// Sums of the squares of the terms that the steps add up: of χ as delays, in units of half a period, and of θ,
    /// rad.
    squares: [f64; 2],
}

impl Tabulation<'_> {
    /// Steps through a cell, from its border or its first centre to its last centre and border. Returns the
    /// truncation error of its segments, or `None` where it exceeds the allowed error.
    fn through(&mut self, number: usize, cell: Cell, at_centre: bool, store: &mut Store<'_>) -> Option<f64> {
        let (level, count) = (cell.level(), 1_usize << cell.level());
        let unit = self.half_cell * Extended::from(1.0 / count as f64);
        let share = self.share(level);
        let mut error = 0.0;
        if !at_centre {
            self.expand(unit);
            self.to(1, share)?;
        }
        for place in 0..count {
            self.expand(unit);
            let segment = cell.first() + place;
            error = larger_or_nan(error, self.shorten(segment, store));
            if !error.is_finite() || error > self.allowed {
                return None;
            }
            let last = place + 1 == count;
            let centre = 2 * (number * count + place) + 1;
            let end = last && number + 1 == CELLS;
            if self.found_start.is_none()
                && let Some(x) = self.seek.within(self.expansion, end)
            {
                // half a turn of the nutation phase over all cells
                let halvings = 2 + CELL_BITS + level;
                let phase = Phase::from_bits(centre as i128 * (Phase::ONE.to_bits() >> halvings))
                    + Phase::new(x / (1_u64 << halvings) as f64);
                let share = self.seek.per_rounding(self.expansion, x) * self.part;
                self.found_start = Some(TabulatedStart { phase, theta: self.expansion.theta_at(x), share });
            }
            if last {
                self.border = self.after(1, share)?;
            } else if self.to(2, 2.0 * share).is_none() {
                // by way of the border
                self.to(1, share)?;
                self.expand(unit);
                self.to(1, share)?;
            }
        }
        Some(error)
    }

    /// Steps from the last centre of a cell to the first centre of the next, whose segments have the same or twice
    /// the length, if the series is accurate so far, otherwise to the border. Returns whether it reached the centre.
    fn cross(&mut self, level: u32, coarser: bool) -> bool {
        let x = if coarser { 3 } else { 2 };
        let carries = self.to(x, x as f64 * self.share(level)).is_some();
        if !carries {
            self.current = self.border;
        }
        carries
    }

    /// Truncation error allowed for a step over half a segment, so that the sum over all steps is within their
    /// fraction of the allowed error.
    fn share(&self, level: u32) -> f64 {
        STEPPING_SHARE * self.requirements.allowed / ((2 * CELLS) << level) as f64
    }

    /// Expands the law around the position reached.
    fn expand(&mut self, unit: Extended) {
        self.part = unit.to_f64() / self.rates.half_period.to_f64();
        let slopes = self.slopes(unit);
        self.expand_along(&slopes, unit);
    }

    #[inline(never)] // the frame with the law in f64 must not remain on the stack below the following calls
    fn expand_along(&mut self, slopes: &Slopes, unit: Extended) {
        let Self { law, expansion, current, least, .. } = self;
        law.cast().expand(&current.point, slopes, unit.to_f64(), *least, expansion);
    }

    /// Derivatives of the phases, in extended precision: a slow phase may turn by thousands of radians and hardly differ
    /// from its mean.
    #[inline(never)]
    fn slopes(&self, unit: Extended) -> Slopes {
        let sine_cosine = self.current.point.sine_cosine();
        let (sine, cosine) = sine_cosine;
        let rates = self.law.rates(sine.into(), cosine.into());
        let [alpha_offset, beta_offset] = self.rates.theta_offset;
        let slope = |rate: Extended| (unit * rate).to_f64();
        let weight = self.fastest * unit.to_f64() / Float::abs(slope(rates.nutation));
        Slopes {
            sine_cosine,
            psi: PhaseRates {
                nutation: slope(rates.nutation),
                alpha: slope(rates.alpha),
                beta: slope(rates.beta),
            },
            theta: [slope(rates.alpha + alpha_offset), slope(rates.beta + beta_offset)],
            weight: if weight > 1.0 { weight } else { 1.0 },
        }
    }

    /// Speed of α and β at given sin χ and cos χ, rad per unit time.
    #[inline(never)] // the stack frames of set-up must not add up
    fn speed(&self, sine: f64, cosine: f64) -> f64 {
        let rates = self.law.cast().rates(sine, cosine);
        let [alpha_offset, beta_offset] = self.rates.theta_offset.map(Float::to_f64);
        let slow = Float::abs(rates.alpha + alpha_offset) + Float::abs(rates.beta + beta_offset);
        Float::abs(rates.nutation) + slow
    }

    /// Stores the expansion as polynomials of reduced degree. Returns the truncation and rounding error, as an
    /// orientation error in rad.
    #[inline(never)]
    fn shorten(&mut self, segment: usize, store: &mut Store<'_>) -> f64 {
        let brackets = [&self.brackets.alpha, &self.brackets.beta];
        let (mut squares, mut stored_error) = (0.0, 0.0);
        let mut slopes = [0.0; 3];
        for (which, bracket) in brackets.into_iter().enumerate() {
            let (mut re, mut im) = ([0; TERMS], [0; TERMS]);
            let converges =
                self.expansion.turned(which, bracket.exponentials(), self.least, [&mut re, &mut im]);
            if converges.is_none() {
                return f64::INFINITY;
            }
            let beyond = [&re, &im].map(beyond_the_last).into_iter().fold(0.0, larger_or_nan);
            let [dropped, dropped_slope] = economise([&mut re, &mut im], self.requirements.terms);
            let dropped = dropped + 2.0 * beyond;
            squares += dropped * dropped;
            let [[re_slope, re_curvature], [im_slope, im_curvature]] = [&re, &im].map(greatest_slopes);
            let of_beyond = 2.0 * TERMS as f64 * beyond;
            let [error, rounded_slope] = store(segment, which, [&mut re, &mut im]);
            stored_error = larger_or_nan(stored_error, error);
            let slope_error = dropped_slope + of_beyond + rounded_slope;
            let each = [[re_slope, im_slope], [slope_error, 0.0], [re_curvature, im_curvature]];
            slopes.iter_mut().zip(each).for_each(|(sum, [x, y])| *sum += x * x + y * y);
        }
        let [slope, slope_error, curvature] = slopes.map(|squares| 2.0 * Float::sqrt(squares));
        let speeds = SegmentSpeeds { slope, slope_error, curvature };
        self.speeds.note(speeds, self.expansion.greatest_theta_slope(), self.part);
        larger_or_nan(2.0 * Float::sqrt(squares), stored_error)
    }

    /// Moves to x; `None` where the truncation error there exceeds `share`.
    fn to(&mut self, x: i64, share: f64) -> Option<()> {
        self.current = self.after(x, share)?;
        Some(())
    }

    #[inline(never)]
    fn after(&self, x: i64, share: f64) -> Option<Position> {
        let left_out = self.expansion.left_out(x);
        (left_out <= share).then(|| {
            let [chi, theta] = self.expansion.sizes(x);
            let delay = self.part * chi / self.expansion.chi_slope(x);
            let [delays, angles] = self.current.squares;
            Position {
                point: self.expansion.point(x),
                remainder: self.current.remainder + left_out,
                squares: [delays + delay * delay, angles + theta * theta],
            }
        })
    }

    /// Error at the upper turning point, as an orientation error in rad. There cos χ = 0, and α and β without their
    /// mean rotation are real, so cos θ = 0. An error of χ is a delay, which is multiplied by the greatest speed.
    fn defect(&self) -> f64 {
        let miss = |angle: Phase| Float::abs(f64::sine_cosine(angle).1);
        let PhasePoint { chi, theta } = self.border.point;
        let [alpha, beta] = theta.map(miss);
        let at_the_end = self.law.cast::<f64>().rates(1.0, 0.0).nutation * self.rates.half_period.to_f64();
        self.speeds.delay(miss(chi) / at_the_end) + 2.0 * alpha.max(beta)
    }
}
