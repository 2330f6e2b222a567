//! Requirements on a tabulation, and its result besides the polynomials.

use crate::ephemeris::cell::{CELLS, Cell};
use crate::ephemeris::speeds::Speeds;
use crate::law::series::in_units;
use crate::phase::Phase;

/// Requirements on a tabulation.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Requirements {
    /// Number of coefficients of a polynomial.
    pub(crate) terms: usize,
    /// Largest truncation error allowed, as an orientation error in rad.
    pub(crate) allowed: f64,
    /// Rounding of the scalar.
    rounding: f64,
    /// Part of `allowed` that the steps from span to span may have, rad.
    steps: f64,
    /// Part that the polynomials may have, in units of 2^-62 rad.
    polynomials: f32,
    /// Sum of terms that may be left out of a series, in units of 2^-61: see [`Requirements::negligible`].
    negligible: i64,
    /// Largest number of segments.
    pub(crate) most: usize,
}

/// Truncation error of a table unless another one is chosen, in roundings of the scalar.
pub(crate) const ROUNDINGS_ALLOWED: f64 = 4.0;

/// Fraction of the allowed error that the steps from span to span may use.
const STEPPING_SHARE: f64 = 0.125;

/// Change of α or of β by the terms that are left out at the halvings of a span, over the allowed error, at most. Fewer terms make set-up
/// faster.
const LEFT_OUT_SHARE: f32 = 1.0 / 512.0;

/// Fraction of the allowed error that a segment of two cells may have. Its derivative, from which the angular velocity is
/// computed, is then no less accurate than on the shorter segments of other motions.
const PAIR_SHARE: f32 = 0.125;

impl Requirements {
    /// Requirements that no table meets.
    pub(crate) const NONE: Self =
        Self { terms: 0, allowed: 0.0, rounding: 0.0, steps: 0.0, polynomials: 0.0, negligible: 0, most: 0 };

    /// Requirements of a scalar with this rounding.
    pub(crate) fn new(terms: usize, allowed: f64, rounding: f64, most: usize) -> Self {
        let requirements = Self { terms, allowed, rounding, most, ..Self::NONE };
        let polynomials = |error: f64| in_units((1.0 - STEPPING_SHARE) * error);
        Self {
            steps: STEPPING_SHARE * allowed,
            polynomials: polynomials(allowed),
            negligible: (0.5 * LEFT_OUT_SHARE * polynomials(requirements.of_series())) as i64,
            ..requirements
        }
    }

    /// Error, rad, a fraction of which the terms have that a series omits or that are left out: the allowed one, but no more than a table
    /// has unless another error is chosen.
    pub(crate) fn of_series(&self) -> f64 {
        self.allowed.min(ROUNDINGS_ALLOWED * self.rounding)
    }

    /// Requirements with another allowed error.
    pub(crate) fn within(&self, allowed: f64) -> Self {
        Self::new(self.terms, allowed, self.rounding, self.most)
    }

    /// Truncation error that all steps from span to span may have together.
    pub(crate) fn of_steps(&self) -> f64 {
        self.steps
    }

    /// Truncation error that the polynomials may have, in units of 2^-62 rad.
    pub(crate) fn of_polynomials(&self) -> f32 {
        self.polynomials
    }

    /// Sum of terms that may be left out of a series before it is restricted to parts of its interval, in units of 2^-61.
    pub(crate) fn negligible(&self) -> i64 {
        self.negligible
    }

    /// Truncation error that a segment may have, if its pair of cells is halved `level` times, in units of 2^-62 rad.
    pub(crate) fn of_segment(&self, level: u32) -> f32 {
        if level == 0 { PAIR_SHARE * self.polynomials } else { self.polynomials }
    }
}

/// Result of a tabulation besides its polynomials.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Tabulated {
    /// Cells with their segments.
    pub(crate) cells: [Cell; CELLS],
    /// Number of segments.
    pub(crate) segments: usize,
    /// Nutation phase at t = 0 (one turn a period, 0 at u = e₁), and the mean slow phases of α and β at t = 0.
    pub(crate) start: [Phase; 3],
    /// Estimated truncation error, as an orientation error in rad: of the reduced polynomials and of the series of
    /// sixteen terms.
    pub(crate) truncation: f64,
    /// Part of the truncation error that the stepping causes, rad.
    pub(crate) stepping: f64,
    /// Distance of the last point from the upper turning point, at which it must be, as an orientation error in rad.
    pub(crate) defect: f64,
    /// Upper bounds on the speeds.
    pub(crate) speeds: Speeds,
    /// Delay caused by a relative rounding of the start's χ, over that rounding, in units of half a period.
    pub(crate) start_share: f64,
    /// Sums of the squares of the terms that the steps add up: of χ as delays, in units of half a period, and of θ,
    /// rad.
    pub(crate) squares: [f64; 2],
}

impl Tabulated {
    pub(crate) const EMPTY: Self = Self {
        cells: [Cell::new(0, 0, 0); CELLS],
        segments: 1,
        start: [Phase::ZERO; 3],
        truncation: 0.0,
        stepping: 0.0,
        defect: 0.0,
        speeds: Speeds::ZERO,
        start_share: 0.0,
        squares: [0.0; 2],
    };
}
