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
use super::economise::{Polynomials, economise};
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
}

/// Hands the polynomials of each segment to `store`, which says what it cannot hold of them (an orientation error); only
/// their first `terms` coefficients count. A segment may come more than once: the last time counts. `None` where there
/// would be more segments than may be.
#[inline(never)]
pub(crate) fn tabulate(
    motion: &Motion,
    rates: &Rates,
    fineness: Fineness,
    mut store: impl FnMut(usize, &Polynomials) -> f64,
) -> Option<Tabulated> {
    let mut tabulated = Tabulated {
        cells: [Cell::default(); CELLS],
        segments: 1,
        start: [Turns::ZERO; 3],
        truncation: 0.0,
        defect: 0.0,
    };
    if motion.is_steady() {
        store(0, &constants(&motion.brackets()));
        let [alpha, beta] = motion.phases();
        tabulated.start = [Turns::ZERO, alpha, beta];
        return Some(tabulated);
    }
    let seek = Seek::new(motion, rates.half_period.to_f64());
    let law = motion.law();
    let cells = fineness.cells();
    let mut march = March {
        law: &law,
        rounded: &law.cast(),
        brackets: &motion.brackets(),
        rates,
        seek: &seek,
        fineness,
        allowed: (1.0 - FOR_THE_WAY) * fineness.allowed,
        half_cell: rates.half_period / DoubleDouble::from((2 * cells) as f64),
        least: rates.rounding / (16 * fineness.most.min(16 * cells)) as f64,
        expansion: Expansion::EMPTY,
        polynomials: [[0.0; TERMS]; 4],
        reached: Reached::default(),
    };
    let mut level = 0;
    tabulated.segments = 0;
    for (number, cell) in tabulated.cells.iter_mut().enumerate().take(cells) {
        let before = march.reached;
        loop {
            *cell = Cell::new(tabulated.segments, level);
            if level > Cell::DEEPEST || tabulated.segments + (1 << level) > fineness.most {
                return None;
            }
            if let Some(error) = march.through(number, *cell, &mut store) {
                tabulated.truncation = worse(tabulated.truncation, error);
                tabulated.segments += 1 << level;
                // twice as long they would miss the motion by about 2^terms times as much
                let coarser = error * f64::from(1_u32 << fineness.terms) < COARSENING * march.allowed;
                level -= u32::from(coarser && level > 0);
                break;
            }
            level += 1;
            march.reached = before;
        }
    }
    let Reached { found, remainder, .. } = march.reached;
    let (phase, theta) = found.unwrap_or_default();
    tabulated.start = seek.start(motion, phase, theta);
    tabulated.truncation += remainder;
    tabulated.defect = if rates.returns { march.defect() } else { 0.0 };
    Some(tabulated)
}

/// The next cell is tried with longer segments where those of the last promise to miss the motion by less than so many times
/// what is allowed: a trial costs one series, a segment too many a place in the table.
const COARSENING: f64 = 4.0;

/// The share of the error allowed that the way from segment to segment may take.
const FOR_THE_WAY: f64 = 0.125;

/// The way through the segments.
struct March<'a> {
    law: &'a Nutation<DoubleDouble>,
    rounded: &'a Nutation<f64>,
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
    expansion: Expansion,
    polynomials: Polynomials,
    reached: Reached,
}

/// How far a march has come.
#[derive(Clone, Copy, Debug, Default)]
struct Reached {
    point: Point,
    /// Phase and θ of the start, once it is behind.
    found: Option<(Turns, [Turns; 2])>,
    /// What the series left out on the way so far, judged by its last terms.
    remainder: f64,
}

impl March<'_> {
    /// From border to border of a cell; `None` where its segments miss the motion by more than is allowed, otherwise by how
    /// much they do.
    fn through(
        &mut self,
        number: usize,
        cell: Cell,
        mut store: impl FnMut(usize, &Polynomials) -> f64,
    ) -> Option<f64> {
        let (level, count) = (cell.level(), 1_usize << cell.level());
        let unit = self.half_cell * DoubleDouble::from(1.0 / count as f64);
        // what remains on the way through half a segment may add up to its share of the whole
        let share = FOR_THE_WAY * self.fineness.allowed / (2 * self.fineness.cells() * count) as f64;
        let mut error = 0.0;
        self.expand(unit);
        self.to(1.0, share)?;
        for place in 0..count {
            self.expand(unit);
            let segment = cell.first() + place;
            let missed = self.polynomials_missing();
            error = worse(error, worse(missed, store(segment, &self.polynomials)));
            if !(error <= self.allowed) {
                return None;
            }
            let last = place + 1 == count;
            let centre = 2 * (number * count + place) + 1;
            let end = last && number + 1 == self.fineness.cells();
            if self.reached.found.is_none()
                && let Some(x) = self.seek.within(&self.expansion, end)
            {
                // half a turn of the nutation over all cells
                let halves = 2 + self.fineness.cell_bits + level;
                let phase = Turns::from_bits(centre as i128 * (Turns::ONE.to_bits() >> halves))
                    + Turns::new(x / (1_u64 << halves) as f64);
                self.reached.found = Some((phase, self.expansion.theta_at(x)));
            }
            if last {
                self.to(1.0, share)?;
            } else if self.to(2.0, 2.0 * share).is_none() {
                // by the border
                self.to(1.0, share)?;
                self.expand(unit);
                self.to(1.0, share)?;
            }
        }
        Some(error)
    }

    /// Around the point that was reached.
    fn expand(&mut self, unit: DoubleDouble) {
        let slopes = self.slopes(unit);
        let Self { expansion, reached, least, .. } = self;
        self.rounded.expand(&reached.point, &slopes, unit.to_f64(), *least, expansion);
    }

    /// In double-double: a slow phase may turn by thousands of radians, and hardly from its mean.
    #[inline(never)]
    fn slopes(&self, unit: DoubleDouble) -> Slopes {
        let (sine, cosine) = self.reached.point.sine_cosine();
        let rates = self.law.rates(sine.into(), cosine.into());
        let [alpha_excess, beta_excess] = self.rates.excess;
        let slope = |rate: DoubleDouble| (unit * rate).to_f64();
        Slopes {
            psi: PhaseRates {
                nutation: slope(rates.nutation),
                alpha: slope(rates.alpha),
                beta: slope(rates.beta),
            },
            theta: [slope(rates.alpha + alpha_excess), slope(rates.beta + beta_excess)],
        }
    }

    /// The polynomials of the expansion, shortened; returns what that costs.
    #[inline(never)]
    fn polynomials_missing(&mut self) -> f64 {
        let Self { expansion, polynomials, brackets, least, .. } = self;
        let [re_alpha, im_alpha, re_beta, im_beta] = &mut *polynomials;
        expansion.turned(0, brackets.alpha.exponentials(), *least, [re_alpha, im_alpha]);
        expansion.turned(1, brackets.beta.exponentials(), *least, [re_beta, im_beta]);
        economise(polynomials, self.fineness.terms)
    }

    /// Moves on to x, unless the series leaves out more than its share there.
    fn to(&mut self, x: f64, share: f64) -> Option<()> {
        let left_out = self.expansion.left_out(x);
        if !(left_out <= share) {
            return None;
        }
        self.reached.remainder += left_out;
        self.reached.point = self.expansion.point(x);
        Some(())
    }

    /// At the upper turning point cos χ = 0, and α and β with their mean rotation taken off are real: cos θ = 0.
    fn defect(&self) -> f64 {
        let miss = |angle: Turns| Float::abs(f64::sine_cosine(angle).1);
        let Point { chi, theta } = self.reached.point;
        let [alpha, beta] = theta.map(miss);
        2.0 * (miss(chi) + alpha.max(beta))
    }
}

/// α and β where the half phase stays 0.
fn constants(brackets: &Brackets<f64>) -> Polynomials {
    let constant = |[plus, minus]: [f64; 2]| {
        let mut polynomial = [0.0; TERMS];
        polynomial[0] = plus + minus;
        polynomial
    };
    [
        constant(brackets.alpha.exponentials()),
        [0.0; TERMS],
        constant(brackets.beta.exponentials()),
        [0.0; TERMS],
    ]
}
