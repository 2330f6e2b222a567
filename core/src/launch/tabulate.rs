//! Half a nutation period as short polynomials: the other half is its mirror image.
//!
//! With their mean rotation taken off, α and β are periodic and analytic in time, and conjugate on the two sides of a
//! turning point. So half a period, from u = e₁ to u = e₂, is cut into segments; around the centre of each the law
//! is expanded ([`crate::nutation::series`]) and the expansion shortened to the degree wanted.
//!
//! The motion may hurry in one place and rest in another, most where e₄ is close to 1, so segments differ in length: those of
//! a [`Cell`] are halved until they fit.
//!
//! An aperiodic motion is tabulated in the same way, from its lowest point until u = 1 to rounding; a steady one is a
//! single constant.

use super::Motion;
use super::cell::{CELLS, Cell};
use super::economise::{Polynomial, economise};
use super::rates::Rates;
use super::seek::Seek;
use crate::cayley_klein::Brackets;
use crate::nutation::series::{Expansion, Point, Slopes, TERMS, worse};
use crate::nutation::{Nutation, PhaseRates};
use crate::real::{DoubleDouble, Float, Scalar};
use crate::turns::Turns;

/// What is asked of a tabulation.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Fineness {
    /// Half a period is cut into 2^cell_bits cells.
    pub(crate) cell_bits: u32,
    /// Coefficients of a polynomial.
    pub(crate) terms: usize,
    /// How far the table may be from the motion, as an orientation error in rad.
    pub(crate) allowed: f64,
    /// How many segments there may be.
    pub(crate) most: usize,
}

impl Fineness {
    fn cells(&self) -> usize {
        1 << self.cell_bits
    }
}

/// What a tabulation says besides its polynomials.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Tabulated {
    /// Which segments are where.
    pub(crate) cells: [Cell; CELLS],
    /// How many there are.
    pub(crate) segments: usize,
    /// Nutation phase at t = 0 (one turn a period, 0 at u = e₁), and the mean slow phases of α and β there.
    pub(crate) start: [Turns; 3],
    /// Bound, as an orientation error in rad, of what shortening the series costs, and of what sixteen terms leave.
    pub(crate) truncation: f64,
    /// How far the march through the segments misses the upper turning point, where it must end, rad.
    pub(crate) defect: f64,
    /// How far α and β would turn in half a period as fast as they ever do, rad: roundings on the way delay what follows.
    pub(crate) haste: f64,
}

impl Tabulated {
    const EMPTY: Self = Self {
        cells: [Cell::new(0, 0); CELLS],
        segments: 1,
        start: [Turns::ZERO; 3],
        truncation: 0.0,
        defect: 0.0,
        haste: 0.0,
    };
}

/// Hands the polynomials of each segment to `store`: its number, 0 for α or 1 for β, and the coefficients, of which the
/// first `terms` count. `store` says what it cannot hold of them (an orientation error). A segment may come more than once:
/// the last time counts. `None` where there would be more segments than may be.
#[inline(never)]
pub(crate) fn tabulate(
    motion: &Motion,
    rates: &Rates,
    fineness: Fineness,
    mut store: impl FnMut(usize, usize, Polynomial<'_>) -> f64,
) -> Option<Tabulated> {
    if motion.is_steady() {
        return Some(constant(motion, store));
    }
    let law = motion.law();
    let seek = Seek::new(motion, &law, rates.half_period.to_f64());
    let cells = fineness.cells();
    let mut expansion = Expansion::EMPTY;
    let mut march = March {
        law: &law,
        brackets: &motion.brackets(),
        rates,
        seek: &seek,
        fineness,
        allowed: (1.0 - FOR_THE_WAY) * fineness.allowed,
        half_cell: rates.half_period / DoubleDouble::from((2 * cells) as f64),
        least: rates.rounding / (16 * fineness.most.min(16 * cells)) as f64,
        expansion: &mut expansion,
        reached: Reached::default(),
        border: Reached::default(),
        found: None,
        fastest: 0.0,
    };
    march.fastest = worse(march.speed(0.0, 1.0), march.speed(1.0, 0.0));
    let mut tabulated = Tabulated { segments: 0, ..Tabulated::EMPTY };
    let (mut level, mut at_centre) = (0, false);
    for (number, cell) in tabulated.cells.iter_mut().enumerate().take(cells) {
        let found_before = march.found.is_some();
        let error = loop {
            *cell = Cell::new(tabulated.segments, level);
            if level > Cell::DEEPEST || tabulated.segments + (1 << level) > fineness.most {
                return None;
            }
            if let Some(error) = march.through(number, *cell, at_centre, &mut store) {
                break error;
            }
            (level, at_centre) = (level + 1, false);
            march.reached = march.border;
            march.found = march.found.filter(|_| found_before);
        };
        tabulated.truncation = worse(tabulated.truncation, error);
        tabulated.segments += 1 << level;
        // twice as long they would miss the motion by about 2^terms times as much
        let coarser = level > 0 && error * f64::from(1_u32 << fineness.terms) < COARSENING * march.allowed;
        at_centre = march.cross(level, coarser);
        level -= u32::from(coarser);
    }
    let (phase, theta) = march.found.unwrap_or_default();
    tabulated.start = seek.start(motion, phase, theta);
    tabulated.truncation += march.border.remainder;
    tabulated.defect = if rates.returns { march.defect() } else { 0.0 };
    tabulated.haste = march.fastest * rates.half_period.to_f64();
    Some(tabulated)
}

/// A steady motion: α and β where the half phase stays 0, for all time.
#[inline(never)]
fn constant(motion: &Motion, mut store: impl FnMut(usize, usize, Polynomial<'_>) -> f64) -> Tabulated {
    let brackets: Brackets<f64> = motion.brackets();
    for (which, bracket) in [&brackets.alpha, &brackets.beta].into_iter().enumerate() {
        let [plus, minus] = bracket.exponentials();
        let mut re = [0.0; TERMS];
        re[0] = plus + minus;
        store(0, which, [&mut re, &mut [0.0; TERMS]]);
    }
    let [alpha, beta] = motion.phases();
    Tabulated { start: [Turns::ZERO, alpha, beta], ..Tabulated::EMPTY }
}

/// The next cell is tried with longer segments where those of the last promise to miss the motion by less than so many times
/// what is allowed: a trial costs one series, a segment too many a place in the table.
const COARSENING: f64 = 4.0;

/// The share of the error allowed that the way from segment to segment may take.
const FOR_THE_WAY: f64 = 0.125;

/// The way through the segments.
struct March<'a> {
    law: &'a Nutation<DoubleDouble>,
    brackets: &'a Brackets<f64>,
    rates: &'a Rates,
    seek: &'a Seek,
    fineness: Fineness,
    /// The error that shortening the series of a segment may cost.
    allowed: f64,
    /// Half the length of a cell. An error here would add up over them.
    half_cell: DoubleDouble,
    /// Terms below this change nothing.
    least: f64,
    /// Around a border or a centre.
    expansion: &'a mut Expansion,
    reached: Reached,
    /// Where the cell begins.
    border: Reached,
    /// How fast α and β change, their mean rotation taken off, at the faster of the turning points: hardly less than anywhere.
    fastest: f64,
    /// Phase and θ of the start, once it is behind.
    found: Option<(Turns, [Turns; 2])>,
}

/// How far a march has come.
#[derive(Clone, Copy, Debug, Default)]
struct Reached {
    point: Point,
    /// What the series left out on the way so far, judged by its last terms.
    remainder: f64,
}

impl March<'_> {
    /// Through a cell from its border, or from its first centre, to its last centre and border; `None` where its segments miss
    /// the motion by more than is allowed, otherwise by how much they do.
    fn through(
        &mut self,
        number: usize,
        cell: Cell,
        at_centre: bool,
        mut store: impl FnMut(usize, usize, Polynomial<'_>) -> f64,
    ) -> Option<f64> {
        let (level, count) = (cell.level(), 1_usize << cell.level());
        let unit = self.half_cell * DoubleDouble::from(1.0 / count as f64);
        let share = self.share(level);
        let mut error = 0.0;
        if !at_centre {
            self.expand(unit);
            self.to(1.0, share)?;
        }
        for place in 0..count {
            self.expand(unit);
            let segment = cell.first() + place;
            error = worse(error, self.shorten(segment, &mut store));
            if !error.is_finite() || error > self.allowed {
                return None;
            }
            let last = place + 1 == count;
            let centre = 2 * (number * count + place) + 1;
            let end = last && number + 1 == self.fineness.cells();
            if self.found.is_none()
                && let Some(x) = self.seek.within(self.expansion, end)
            {
                // half a turn of the nutation over all cells
                let halves = 2 + self.fineness.cell_bits + level;
                let phase = Turns::from_bits(centre as i128 * (Turns::ONE.to_bits() >> halves))
                    + Turns::new(x / (1_u64 << halves) as f64);
                self.found = Some((phase, self.expansion.theta_at(x)));
            }
            if last {
                self.border = self.after(1.0, share)?;
            } else if self.to(2.0, 2.0 * share).is_none() {
                // by the border
                self.to(1.0, share)?;
                self.expand(unit);
                self.to(1.0, share)?;
            }
        }
        Some(error)
    }

    /// From the last centre of a cell to the first of the next, whose segments are as long, or twice as long, if the series
    /// carries so far, otherwise to the border; tells which.
    fn cross(&mut self, level: u32, coarser: bool) -> bool {
        let x = if coarser { 3.0 } else { 2.0 };
        let carries = self.to(x, x * self.share(level)).is_some();
        if !carries {
            self.reached = self.border;
        }
        carries
    }

    /// What may remain on the way through half a segment, so that it adds up to its share of the whole.
    fn share(&self, level: u32) -> f64 {
        FOR_THE_WAY * self.fineness.allowed / ((2 * self.fineness.cells()) << level) as f64
    }

    /// Around the point that was reached.
    fn expand(&mut self, unit: DoubleDouble) {
        let slopes = self.slopes(unit);
        self.expand_along(&slopes, unit);
    }

    #[inline(never)] // the law rounded to f64 shall not lie below what follows
    fn expand_along(&mut self, slopes: &Slopes, unit: DoubleDouble) {
        let Self { law, expansion, reached, least, .. } = self;
        law.cast().expand(&reached.point, slopes, unit.to_f64(), *least, expansion);
    }

    /// In double-double: a slow phase may turn by thousands of radians, and hardly from its mean.
    #[inline(never)]
    fn slopes(&self, unit: DoubleDouble) -> Slopes {
        let (sine, cosine) = self.reached.point.sine_cosine();
        let rates = self.law.rates(sine.into(), cosine.into());
        let [alpha_excess, beta_excess] = self.rates.excess;
        let slope = |rate: DoubleDouble| (unit * rate).to_f64();
        let weight = self.fastest * unit.to_f64() / Float::abs(slope(rates.nutation));
        Slopes {
            psi: PhaseRates {
                nutation: slope(rates.nutation),
                alpha: slope(rates.alpha),
                beta: slope(rates.beta),
            },
            theta: [slope(rates.alpha + alpha_excess), slope(rates.beta + beta_excess)],
            weight: if weight > 1.0 { weight } else { 1.0 },
        }
    }

    /// How fast α and β change where sin χ and cos χ are these, rad per unit time.
    #[inline(never)] // the frames of a set-up should not add up
    fn speed(&self, sine: f64, cosine: f64) -> f64 {
        let rates = self.law.cast().rates(sine, cosine);
        let [alpha_excess, beta_excess] = self.rates.excess.map(Float::to_f64);
        let slow = Float::abs(rates.alpha + alpha_excess) + Float::abs(rates.beta + beta_excess);
        Float::abs(rates.nutation) + slow
    }

    /// Stores the expansion as short polynomials; returns what that costs, as an orientation error.
    #[inline(never)]
    fn shorten(&mut self, segment: usize, mut store: impl FnMut(usize, usize, Polynomial<'_>) -> f64) -> f64 {
        let brackets = [&self.brackets.alpha, &self.brackets.beta];
        let (mut squares, mut excess) = (0.0, 0.0);
        for (which, bracket) in brackets.into_iter().enumerate() {
            let [re, im] = self.expansion.turned(which, bracket.exponentials(), self.least);
            let beyond = [&*re, &*im].map(beyond_the_last).into_iter().fold(0.0, worse);
            let dropped = economise([&mut *re, &mut *im], self.fineness.terms) + 2.0 * beyond;
            squares += dropped * dropped;
            excess = worse(excess, store(segment, which, [re, im]));
        }
        worse(2.0 * Float::sqrt(squares), excess)
    }

    /// Moves on to x, unless the series leaves out more than its share there.
    fn to(&mut self, x: f64, share: f64) -> Option<()> {
        self.reached = self.after(x, share)?;
        Some(())
    }

    #[inline(never)]
    fn after(&self, x: f64, share: f64) -> Option<Reached> {
        let left_out = self.expansion.left_out(x);
        (left_out <= share)
            .then(|| Reached { point: self.expansion.point(x), remainder: self.reached.remainder + left_out })
    }

    /// At the upper turning point cos χ = 0, and α and β with their mean rotation taken off are real: cos θ = 0.
    fn defect(&self) -> f64 {
        let miss = |angle: Turns| Float::abs(f64::sine_cosine(angle).1);
        let Point { chi, theta } = self.border.point;
        let [alpha, beta] = theta.map(miss);
        2.0 * (miss(chi) + alpha.max(beta))
    }
}

/// What a series leaves out beyond its last term: as if it went on as its last four terms do. Infinite where these do not
/// fall.
fn beyond_the_last(part: &[f64; TERMS]) -> f64 {
    /// Below it terms are rounding, and need not fall.
    const NEGLIGIBLE: f64 = 3e-17;
    let [.., c12, c13, c14, c15] = part.map(Float::abs);
    // by pairs, since a series may be even or odd
    let (before, last) = (c12 + c13, c14 + c15);
    let ratio = last / before;
    match last > NEGLIGIBLE {
        true if ratio < 1.0 => last * ratio / (1.0 - ratio),
        true => f64::INFINITY,
        false => 0.0,
    }
}
