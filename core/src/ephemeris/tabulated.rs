//! Requirements on a tabulation, and its result besides the polynomials.

use crate::ephemeris::cell::{CELLS, Cell};
use crate::ephemeris::speeds::Speeds;
use crate::phase::Phase;

/// Requirements on a tabulation.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Requirements {
    /// Number of coefficients of a polynomial.
    pub(crate) terms: usize,
    /// Largest truncation error allowed, as an orientation error in rad.
    pub(crate) allowed: f64,
    /// Largest number of segments.
    pub(crate) most: usize,
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
    /// Delay by a relative rounding of the start's χ, over that rounding, in units of half a period.
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
