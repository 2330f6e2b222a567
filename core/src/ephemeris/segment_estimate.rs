//! Estimate of the number of segments from the rates of the phases, before any segment is computed.
//!
//! Without its mean rotation α is c₊ e^{i(θ_A + χ)} + c₋ e^{i(θ_A - χ)}, where c₊ and c₋ follow from its bracket. If the phases
//! changed at constant rates, a polynomial of n terms on a segment of half length h would have the error
//!
//! ```text
//! (|c₊| |θ_A' + χ'|^n + |c₋| |θ_A' - χ'|^n) h^n/(n! 2^{n-1})
//! ```
//!
//! The rates do change, which makes the error larger. Therefore a table is refused if already the estimate exceeds its
//! number of segments (`toytop-lab study` and a test compare such tables with the segments that they need). The estimate is computed in
//! `f32`, because it needs no more digits and soft arithmetic in `f64` would take a tenth of the time of a set-up.

use crate::ephemeris::cell::{CELLS, Cell};
use crate::ephemeris::mean_rates::MeanRates;
use crate::ephemeris::tabulated::Requirements;
use crate::law::Law;
use crate::scalar::{Extended, Float, Scalar};

/// Estimated least number of halvings of the pair of each cell: see [`Cell::level`].
#[derive(Clone, Copy, Debug)]
pub(crate) struct SegmentEstimate([u8; CELLS]);

/// Number of points on the half period, at equal distances of χ.
const POINTS: u8 = 32;

/// Factor by which an error must exceed the allowed one to count. The changes of the rates rarely make an error smaller, and not by
/// this factor.
const MARGIN: f32 = 2.0;

/// Distance of two points, rad.
const DISTANCE: f32 = core::f32::consts::FRAC_PI_2 / POINTS as f32;

/// Sine and cosine of the distance of two points, and of half of it.
const STEP: [f32; 2] = [0.049_067_674, 0.998_795_45];
const HALF_STEP: [f32; 2] = [0.024_541_229, 0.999_698_8];

impl SegmentEstimate {
    /// Estimate that excludes no table.
    pub(crate) const NONE: Self = Self([0; CELLS]);

    /// Least number of segments of the cells from this one on.
    pub(crate) fn least_segments(&self, first: usize) -> usize {
        // a cell of a pair that is not halved has half a segment
        let halves: usize = self.0.iter().skip(first).map(|level| 1 << level).sum();
        halves.div_ceil(2)
    }

    /// Estimates for each of several requirements, which differ in the allowed error only.
    ///
    /// * `exponentials`: coefficients c₊ and c₋ of α and of β
    #[inline(never)] // the stack frames of set-up must not add up
    pub(crate) fn of<const N: usize>(
        law: &Law<Extended>,
        exponentials: &[[f64; 2]; 2],
        rates: &MeanRates,
        requirements: &[Requirements; N],
    ) -> [Self; N] {
        let mut estimates = [Self::NONE; N];
        let terms = requirements.first().map_or(0, |all| all.terms);
        if !rates.is_periodic {
            return estimates;
        }
        let frequencies = Frequencies::new(law, exponentials, rates);
        let (mut place, mut angle) = (0.0, HALF_STEP);
        for _ in 0..POINTS {
            let (cells, error) = frequencies.at(angle, terms);
            place += 0.5 * cells;
            for (Self(levels), requirements) in estimates.iter_mut().zip(requirements) {
                if let Some(level) = levels.get_mut(place as usize) {
                    *level = error.level(requirements, *level);
                }
            }
            place += 0.5 * cells;
            let ([sine, cosine], [step_sine, step_cosine]) = (angle, STEP);
            angle = [sine * step_cosine + cosine * step_sine, cosine * step_cosine - sine * step_sine];
        }
        estimates
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

    /// Time between two points in cells, and the error of a polynomial on a cell, at a point with these sine and cosine of χ.
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
        (DISTANCE / nutation, CellError { frequency: greatest, size: 2.0 * Float::sqrt(squares) })
    }
}

/// Error of a polynomial on a segment of half the length of a cell or less: the size times a power of the frequency, over the
/// constants of the polynomial.
struct CellError {
    /// Greatest frequency, rad per cell.
    frequency: f32,
    /// Orientation error if the power and the constants are 1.
    size: f32,
}

impl CellError {
    /// Number of halvings after which the error is allowed, at least `least`.
    fn level(&self, requirements: &Requirements, least: u8) -> u8 {
        // n! 2^{n-1}
        let constants = (1..=requirements.terms).fold(0.5, |product, n| product * (2 * n) as f32);
        let most = |level: u8| MARGIN * requirements.of_segment(level.into()) as f32 * constants;
        let mut level = least;
        while u32::from(level) < Cell::DEEPEST {
            let half_length = self.frequency / (1_u32 << level) as f32;
            let error = (0..requirements.terms).fold(self.size, |error, _| error * half_length);
            if error <= most(level) || error.is_nan() {
                break;
            }
            level += 1;
        }
        level
    }
}
