//! The arithmetic of a table: what a scalar's coefficients are, and how they become α and β.

#[cfg(feature = "fixed")]
mod fixed_point;
mod float;
mod integer;
#[cfg(feature = "fixed")]
mod narrow;

use crate::complex::Complex;
use crate::real::{Real, Scalar};
use core::fmt::Debug;

/// A point of the motion as a table is asked for it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Place {
    /// The place on the segment, x·2^63 with x in [-1, 1).
    pub x: i64,
    /// The same times 2^31, rounded down to 2^-36 of half a period.
    pub short_x: i32,
    /// Whether u is falling: α and β, their mean rotation taken off, are then the conjugates of the tabulated ones.
    pub mirrored: bool,
    /// The mean rotations of α and β: the 64 leading bits of a share of a turn.
    pub slow: [u64; 2],
}

/// A scalar that an ephemeris can be read in.
///
/// `f64` by floating point. `f32` and fixed point by 32-bit integers, which are four times as exact as `f32`, as fast as its
/// unit where there is one, and several times as fast as its emulation where there is none.
pub trait Tabular: Scalar {
    /// A coefficient as the table holds it.
    type Coefficient: Copy + Debug + PartialEq;
    /// What lengths and rates are in: the scalar itself, or `f32` where they are beyond its range.
    type Wide: Real;

    /// The coefficient 0.
    const NOTHING: Self::Coefficient;
    /// What a tick rounds off, as an orientation error in rad.
    const TICK_ERROR: f64;
    /// What it rounds off of the place in a cell, as a share of the cell: of a motion in a hurry that is more.
    const PLACE_ROUNDING: f64;

    /// The nearest coefficient of x^power.
    fn coefficient(value: f64, power: usize) -> Self::Coefficient;
    /// What the coefficients of a polynomial cannot hold of it, infinite where a sum could overflow; 0 in floating point.
    fn excess(polynomial: &[f64]) -> f64;
    /// The coefficient of x^power as a number.
    fn number(coefficient: Self::Coefficient, power: usize) -> Self::Wide;
    /// The same value.
    fn widened(self) -> Self::Wide;

    /// α and β from the coefficients of a segment, lowest power first: those of Re α, Im α, Re β and Im β side by side.
    fn alpha_beta(terms: &[[Self::Coefficient; 4]], place: Place) -> [Complex<Self>; 2];

    /// The tip from αβ: in units of length, with 2s for a scale; in fixed point in units of s, whatever the scale.
    fn tip(product: Complex<Self>, scale: Self::Wide) -> Complex<Self>;
}
