//! Estimate of the number of segments from the rates of the phases, before any segment is computed.
//!
//! Without its mean rotation α is c₊ e^{i(θ_A + χ)} + c₋ e^{i(θ_A - χ)}, where c₊ and c₋ follow from its bracket. If the phases
//! changed at constant rates, a polynomial of n terms on a segment of half length h would have the error
//!
//! ```text
//! (|c₊| |θ_A' + χ'|^n + |c₋| |θ_A' - χ'|^n) h^n/(n! 2^{n-1})
//! ```
//!
//! Where χ' grows or decreases at a relative rate κ above these frequencies, as near the separatrix, the error is about χ' κ^{n-1} h^n/(n!
//! 2^{n-1}) instead. Other changes of the rates make the error larger. Therefore a table with fewer segments than the estimate is refused
//! (the test `a_table_that_cannot_fit_is_refused_early` compares such refusals with the segments that are needed). The estimate is
//! computed in `f32`: it needs no more digits, and emulated `f64` would take a tenth of the time of a set-up.

use crate::ephemeris::cell::{CELLS, Cell};
use crate::ephemeris::mean_rates::MeanRates;
use crate::ephemeris::tabulated::Requirements;
use crate::law::Law;
use crate::law::series::UNIT;
use crate::scalar::{Extended, Float, Scalar};

/// Estimated least number of halvings of the pair of each cell: see [`Cell::level`].
#[derive(Clone, Copy, Debug)]
pub(crate) struct SegmentEstimate([u8; CELLS]);

/// Factor by which an error must exceed the allowed error to count, and a further factor for an error from the growth of χ'. The changes
/// of the rates may make an error a little smaller, and a table that fits must not be refused.
const MARGIN: f32 = 2.0;
const GROWTH_MARGIN: f32 = 2.0;

/// Points on the half period: at equal distances of χ, and then at distances that halve towards χ = π/2, because a motion near the
/// separatrix spends most of its time there. An item contains sine and cosine of χ, and the length of the interval of χ that the
/// point represents, rad.
#[derive(Clone, Copy, Debug)]
struct Points {
    angle: [f32; 2],
    number: u8,
}

/// Length of an equal part of the half period, rad.
const DISTANCE: f32 = core::f32::consts::FRAC_PI_2 / 32.0;

/// Shortest time, in cells, that a point near χ = π/2 may represent; the points after it are left out.
const SHORTEST: f32 = 0.125;

impl Points {
    /// Points from the middle of the first part on.
    const FIRST: Self = Self { angle: [0.024_541_229, 0.999_698_8], number: 0 };
    /// Sine and cosine of the length of a part.
    const STEP: [f32; 2] = [0.049_067_674, 0.998_795_45];
    /// Number of points at equal distances: all parts but the last.
    const EQUAL: u8 = 31;
    const MOST: u8 = Self::EQUAL + 16;
}

impl Iterator for Points {
    type Item = ([f32; 2], f32);

    fn next(&mut self) -> Option<Self::Item> {
        use core::f32::consts::FRAC_1_SQRT_2;
        let ([sine, cosine], [step_sine, step_cosine]) = (self.angle, Self::STEP);
        let is_equal = self.number < Self::EQUAL;
        self.number += 1;
        self.angle = match self.number {
            ..Self::EQUAL => {
                [sine * step_cosine + cosine * step_sine, cosine * step_cosine - sine * step_sine]
            }
            Self::EQUAL => [1.0, FRAC_1_SQRT_2 * DISTANCE],
            _ => [1.0, 0.5 * cosine],
        };
        let distance = if is_equal { DISTANCE } else { FRAC_1_SQRT_2 * cosine };
        (self.number <= Self::MOST).then_some(([sine, cosine], distance))
    }
}

impl SegmentEstimate {
    /// Estimate that excludes no table.
    pub(crate) const NONE: Self = Self([0; CELLS]);

    /// Least number of segments of the cells from this one on.
    pub(crate) fn least_segments(&self, first: usize) -> usize {
        // a cell of a pair that is not halved has half a segment
        let halves: usize = self.0.iter().skip(first).map(|level| 1 << level).sum();
        halves.div_ceil(2)
    }
}

/// Four points at equal distances of χ: sine and cosine.
const FEW_POINTS: [[f32; 2]; 4] = [
    [0.195_090_32, 0.980_785_3],
    [0.555_570_24, 0.831_469_6],
    [0.831_469_6, 0.555_570_24],
    [0.980_785_3, 0.195_090_32],
];

/// Estimates for two requirements, which differ in the allowed error only, in slices of bounded work.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Estimation {
    estimates: [SegmentEstimate; 2],
    points: Points,
    /// Time reached, in cells, and the rate of χ at the point before, rad per cell.
    place: f32,
    before: Option<f32>,
}

impl Estimation {
    pub(crate) const BEGINNING: Self =
        Self { estimates: [SegmentEstimate::NONE; 2], points: Points::FIRST, place: 0.0, before: None };

    pub(crate) fn estimates(&self) -> &[SegmentEstimate; 2] {
        &self.estimates
    }

    /// Includes some points. Returns whether the estimates are complete. A motion that seems to need less than half of the segments
    /// keeps estimates that exclude no table.
    ///
    /// * `exponentials`: coefficients c₊ and c₋ of α and of β
    #[inline(never)] // the stack frames of set-up must not add up
    pub(crate) fn proceed(
        &mut self,
        law: &Law<Extended>,
        exponentials: &[[f64; 2]; 2],
        rates: &MeanRates,
        requirements: &[Requirements; 2],
    ) -> bool {
        /// Number of points in a slice of a set-up.
        const POINTS: usize = 8;
        if !rates.is_periodic {
            return true;
        }
        let frequencies = Frequencies::new(law, exponentials, rates);
        let allowed = requirements.each_ref().map(AllowedErrors::new);
        if self.before.is_none() && frequencies.need_few_segments(&allowed, requirements) {
            return true;
        }
        for _ in 0..POINTS {
            let Some((angle, distance)) = self.points.next() else { return true };
            if !self.include(&frequencies, &allowed, angle, distance) {
                return true;
            }
        }
        false
    }

    /// Includes a point. Returns whether there may be another.
    fn include(
        &mut self,
        frequencies: &Frequencies,
        allowed: &[AllowedErrors; 2],
        angle: [f32; 2],
        distance: f32,
    ) -> bool {
        let [AllowedErrors { terms, .. }, _] = *allowed;
        let (nutation, error) = frequencies.at(angle, terms);
        let cells = distance / nutation;
        if distance < DISTANCE && cells < SHORTEST {
            return false;
        }
        let growth = self.before.map_or(0.0, |before| Float::abs(nutation - before) / distance);
        self.before = Some(nutation);
        self.place += 0.5 * cells;
        for (SegmentEstimate(levels), allowed) in self.estimates.iter_mut().zip(allowed) {
            if let Some(level) = levels.get_mut(self.place as usize) {
                *level = allowed.level(&error, *level);
                if growth > error.frequency {
                    let of_growth =
                        CellError { frequency: growth, size: nutation / (GROWTH_MARGIN * growth) };
                    *level = allowed.level(&of_growth, *level);
                }
            }
        }
        self.place += 0.5 * cells;
        true
    }
}

/// Law of a motion with the sizes of its exponentials, from which the frequencies of α and β at a point follow.
struct Frequencies {
    law: Law<f32>,
    /// Length of a cell, as a time.
    cell: f32,
    /// Constant rates of θ_A and θ_B besides ψ_A' and ψ_B', rad per unit time.
    theta_offset: [f32; 2],
    /// Magnitudes of c₊ and c₋ of α and of β.
    sizes: [[f32; 2]; 2],
}

impl Frequencies {
    fn new(law: &Law<Extended>, exponentials: &[[f64; 2]; 2], rates: &MeanRates) -> Self {
        let narrow = |x: Extended| x.to_f64() as f32;
        Self {
            law: law.cast(),
            cell: narrow(rates.half_period) / CELLS as f32,
            theta_offset: rates.theta_offset.map(narrow),
            sizes: exponentials.map(|both| both.map(|c| Float::abs(c) as f32)),
        }
    }

    /// Whether half of the allowed segments are enough for errors like those at a few points.
    fn need_few_segments(&self, allowed: &[AllowedErrors; 2], requirements: &[Requirements; 2]) -> bool {
        let ([_, fine], [_, Requirements { terms, most, .. }]) = (allowed, requirements);
        FEW_POINTS.iter().all(|angle| {
            let (_, error) = self.at(*angle, *terms);
            CELLS << fine.level(&error, 0) <= *most
        })
    }

    /// Rate of χ, rad per cell, and the error of a polynomial on a cell, at a point with these sine and cosine of χ.
    fn at(&self, [sine, cosine]: [f32; 2], terms: usize) -> (f32, CellError) {
        let rates = self.law.rates(sine, cosine);
        let nutation = rates.nutation * self.cell;
        let mut all = [[0.0; 2]; 2];
        let offsets = [rates.alpha, rates.beta].into_iter().zip(self.theta_offset);
        for (both, (psi, offset)) in all.iter_mut().zip(offsets) {
            let theta = (psi + offset) * self.cell;
            // the two almost cancel where a slow phase hardly differs from its mean
            let rounding = 4.0 * <f32 as Scalar>::ROUNDING as f32 * Float::abs(offset * self.cell);
            let size = |frequency: f32| (Float::abs(frequency) - rounding).max(0.0);
            *both = [size(theta + nutation), size(theta - nutation)];
        }
        let greatest = all.iter().flatten().fold(0.0, |greatest: f32, frequency| greatest.max(*frequency));
        let powers = self.sizes.iter().zip(&all).map(|(sizes, frequencies)| {
            let power = |frequency: f32| {
                let ratio = frequency / greatest;
                (0..terms).fold(1.0, |power, _| power * ratio)
            };
            sizes.iter().zip(frequencies).map(|(size, frequency)| size * power(*frequency)).sum::<f32>()
        });
        let squares = powers.map(|power| power * power).sum::<f32>();
        (nutation, CellError { frequency: greatest, size: 2.0 * Float::sqrt(squares) })
    }
}

/// Error of a polynomial on a segment whose half length is a cell or less: the size times a power of the frequency, over the
/// constants of the polynomial.
struct CellError {
    /// Greatest frequency, rad per cell.
    frequency: f32,
    /// Orientation error if the power and the constants are 1.
    size: f32,
}

/// Errors that a polynomial of `terms` terms may have, times n! 2^{n-1}.
struct AllowedErrors {
    terms: usize,
    /// Error allowed on a pair of cells, and on a shorter segment.
    of_pair: f32,
    of_shorter: f32,
}

impl AllowedErrors {
    fn new(requirements: &Requirements) -> Self {
        let constants = (1..=requirements.terms).fold(0.5, |product, n| product * (2 * n) as f32);
        let most = |level: u32| MARGIN * UNIT as f32 * requirements.of_segment(level) * constants;
        Self { terms: requirements.terms, of_pair: most(0), of_shorter: most(1) }
    }

    /// Number of halvings after which an error is allowed, at least `least`.
    fn level(&self, error: &CellError, least: u8) -> u8 {
        let mut level = least;
        let mut half_length = error.frequency / (1_u32 << level) as f32;
        while u32::from(level) < Cell::DEEPEST {
            let most = if level == 0 { self.of_pair } else { self.of_shorter };
            let value = (0..self.terms).fold(error.size, |value, _| value * half_length);
            if value <= most || value.is_nan() {
                break;
            }
            (level, half_length) = (level + 1, 0.5 * half_length);
        }
        level
    }
}
