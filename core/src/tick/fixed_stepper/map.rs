//! The tick as a table in integers: what the three phases turn by in one tick, from where χ is at its start.
//!
//! An increment is a mean, exact to 2^-96 turns, and a rest, of which the table holds the polynomials as shares of a power
//! of two that is common to all segments. A coefficient of x^k is held as c·2^(31+k), so that a step of Horner's rule is one
//! upper-word product and one sum. The power of two is chosen so that the sum of the |c_j| from j = k on stays below 2^-k for
//! every k: then no partial sum leaves 32 bits, whatever the place.

use super::flow::{Fit, Flow, Increments};
use crate::nutation::series::worse;
use crate::real::{Float, high_product};
use crate::turns::Turns;

/// What the increments hold besides their mean, on `SEGMENTS` parts of half a turn of χ.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct TickMap<const SEGMENTS: usize, const TERMS: usize> {
    /// Lowest power first: χ, A and B side by side.
    segments: [[[i32; 3]; TERMS]; SEGMENTS],
    /// By how many bits a sum is shifted to count in 2^-64 turns: 1 to 31.
    shifts: [u32; 3],
    means: [Turns; 3],
}

/// What the polynomials of a motion are like, in turns a tick.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Survey {
    pub(super) lowest: Increments,
    pub(super) highest: Increments,
    /// The largest 2^k (|c_k| + |c_{k+1}| + ...) for k >= 1.
    steepest: Increments,
    pub(super) missed: Increments,
}

impl Survey {
    /// Of a motion on so many segments.
    pub(super) fn of(flow: &Flow, segments: usize, terms: usize) -> Self {
        let mut survey = Self {
            lowest: [f64::INFINITY; 3],
            highest: [f64::NEG_INFINITY; 3],
            steepest: [0.0; 3],
            missed: [0.0; 3],
        };
        for segment in 0..segments {
            survey.include(&flow.fit(segment, segments, terms));
        }
        survey
    }

    fn include(&mut self, fit: &Fit) {
        let extremes = self.lowest.iter_mut().zip(&mut self.highest).zip(&mut self.steepest);
        for ((polynomial, missed), (((lowest, highest), steepest), worst)) in
            fit.polynomials.iter().zip(fit.missed).zip(extremes.zip(&mut self.missed))
        {
            let mut sum = 0.0;
            for (power, value) in polynomial.iter().enumerate().skip(1).rev() {
                sum += Float::abs(*value);
                *steepest = worse(*steepest, sum * (1_u64 << power) as f64);
            }
            let [constant, ..] = polynomial;
            *lowest = -worse(-*lowest, sum - constant);
            *highest = worse(*highest, sum + constant);
            *worst = worse(*worst, missed);
        }
    }

    /// Half of what an increment varies by.
    fn swings(&self) -> Increments {
        let mut swings = self.highest;
        swings.iter_mut().zip(self.lowest).for_each(|(high, low)| *high = 0.5 * (*high - low));
        swings
    }

    pub(super) fn means(&self) -> Increments {
        let mut means = self.highest;
        means.iter_mut().zip(self.lowest).for_each(|(high, low)| *high = 0.5 * (*high + low));
        means
    }

    /// The largest increments of χ, and of A or B, which turn by `drift` and its negative besides, in turns.
    fn largest(&self, drift: f64) -> [f64; 2] {
        let size = |low: f64, high: f64| worse(Float::abs(low), Float::abs(high));
        let ([chi_low, a_low, b_low], [chi_high, a_high, b_high]) = (self.lowest, self.highest);
        let slow = worse(size(a_low + drift, a_high + drift), size(b_low - drift, b_high - drift));
        [size(chi_low, chi_high), slow]
    }

    /// The most that the orientation turns in a tick, rad.
    pub(super) fn turned(&self, drift: f64) -> f64 {
        let [chi, slow] = self.largest(drift);
        2.0 * TURN * (chi + slow)
    }

    /// How far the orientation goes astray in a tick, rad, if the increments are wrong by so many turns: by each of them.
    ///
    /// An error of χ is one of time: what follows comes early or late, while A and B turn on as if it had not.
    pub(super) fn astray(&self, [chi, alpha, beta]: Increments, drift: f64) -> Increments {
        let ([largest, slow], [slowest, ..]) = (self.largest(drift), self.lowest);
        let late = if slowest > 0.0 { chi / slowest } else { f64::INFINITY };
        [late * (largest + 2.0 * slow), alpha, beta].map(|error| 2.0 * TURN * error)
    }

    /// The bits a sum is to be shifted by: the least that keep all sums in range. `None` for a phase whose increment varies by
    /// a quarter of a turn, or is no number.
    pub(super) fn shifts(&self) -> [Option<u32>; 3] {
        /// Room for the rounding of the coefficients.
        const MARGIN: f64 = 1.0 + 1e-6;
        let mut largest = self.swings();
        largest.iter_mut().zip(self.steepest).for_each(|(swing, steep)| *swing = worse(*swing, steep));
        largest.map(|largest| (1..32).find(|&shift| largest * MARGIN <= full_scale(shift)))
    }
}

const TURN: f64 = 2.0 * core::f64::consts::PI;

/// What a sum of 2^31 stands for, in turns.
pub(super) fn full_scale(shift: u32) -> f64 {
    (1_u64 << shift) as f64 / (1_u64 << 33) as f64
}

impl<const SEGMENTS: usize, const TERMS: usize> TickMap<SEGMENTS, TERMS> {
    const BITS: u32 = SEGMENTS.trailing_zeros();

    /// Checked when the type is used.
    const SIZE_IS_VALID: () = assert!(
        SEGMENTS.is_power_of_two() && SEGMENTS >= 2 && SEGMENTS <= 1 << 16 && TERMS >= 2 && TERMS <= 16
    );

    /// Increments that are what they are everywhere.
    pub(super) fn constant(means: [Turns; 3]) -> Self {
        let () = Self::SIZE_IS_VALID;
        Self { segments: [[[0; 3]; TERMS]; SEGMENTS], shifts: [1; 3], means }
    }

    /// Fills the table, with the means a survey gave (and what turns besides the law), scaled by its shifts.
    pub(super) fn put(&mut self, flow: &Flow, means: Increments, shifts: [u32; 3], besides: [Turns; 3]) {
        self.shifts = shifts;
        for ((ours, mean), besides) in self.means.iter_mut().zip(means).zip(besides) {
            *ours = Turns::new(mean) + besides;
        }
        for (segment, terms) in self.segments.iter_mut().enumerate() {
            let mut fit = flow.fit(segment, SEGMENTS, TERMS);
            for ([constant, ..], mean) in fit.polynomials.iter_mut().zip(means) {
                *constant -= mean;
            }
            for (power, three) in terms.iter_mut().enumerate() {
                for ((held, polynomial), shift) in three.iter_mut().zip(&fit.polynomials).zip(shifts) {
                    let share = polynomial.get(power).copied().unwrap_or(0.0) / full_scale(shift);
                    // half a unit makes up for the product that will be added, rounded down
                    let rounding = if power + 1 < TERMS { 1.0 } else { 0.5 };
                    *held = libm::floor(share * (1_u64 << (31 + power)) as f64 + rounding) as i32;
                }
            }
        }
    }

    /// What the phases turn by in the tick that starts at χ.
    #[inline(always)]
    pub(super) fn increments(&self, chi: Turns) -> [Turns; 3] {
        let share = chi.fraction() << 1;
        let segment = (share >> (64 - Self::BITS)) as usize;
        // [0, 1) to [-1, 1): the upper bit changes sides
        let x = ((share >> (32 - Self::BITS)) as u32 ^ (1 << 31)) as i32;
        let mut sums = [0; 3];
        let mut backwards = self.segments.get(segment).map_or(&[][..], |terms| terms).iter().rev();
        if let Some(&highest) = backwards.next() {
            sums = highest;
        }
        for coefficients in backwards {
            for (sum, &c) in sums.iter_mut().zip(coefficients) {
                *sum = c + high_product(*sum, x);
            }
        }
        let mut increments = self.means;
        for ((increment, sum), shift) in increments.iter_mut().zip(sums).zip(self.shifts) {
            *increment += shifted(sum, shift);
        }
        increments
    }
}

/// sum · 2^(shift - 64) turns, 1 <= shift <= 31, without a shift wider than a word.
#[inline(always)]
fn shifted(sum: i32, shift: u32) -> Turns {
    let (upper, lower) = (sum.wrapping_shr(32 - shift), (sum as u32).wrapping_shl(shift));
    Turns::from_bits((i128::from(upper) << 64) | (i128::from(lower) << 32))
}
