//! Launch and the other unknowns of a fit.

use crate::fit::triangle::{MOST_UNKNOWNS, Unknowns};
use crate::sensitivity::total;
use crate::su2::{Orientation, Vector, dot};

/// Number of unknowns of a launch.
pub(super) const LAUNCH: usize = 6;

/// Ratio of the top that is an unknown: a direction in the space of log A/C, log A/(ps), log s and log g, of which the
/// unknown is the factor. For a fixed tip the length A/p takes the place of A/(ps).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FreeRatio {
    /// Direction.
    pub direction: [f64; 4],
    /// Prior standard deviation of the unknown; infinite where there is no prior information.
    pub deviation: f64,
}

impl FreeRatio {
    /// Direction in which only the axial inertia C changes.
    pub const AXIAL_INERTIA: Self = Self::of([-1.0, 0.0, 0.0, 0.0]);
    /// Direction in which only the transverse inertia A changes.
    pub const TRANSVERSE_INERTIA: Self = Self::of([1.0, 1.0, 0.0, 0.0]);
    /// Direction in which only the mass moment p changes.
    pub const MASS_MOMENT: Self = Self::of([0.0, -1.0, 0.0, 0.0]);
    /// Direction in which only the length s of a sliding top changes, while p is kept.
    pub const COM_HEIGHT: Self = Self::of([0.0, -1.0, 1.0, 0.0]);
    /// Direction in which only gravity g changes.
    pub const GRAVITY: Self = Self::of([0.0, 0.0, 0.0, 1.0]);

    /// Unknown without prior information.
    #[must_use]
    pub const fn of(direction: [f64; 4]) -> Self {
        Self { direction, deviation: f64::INFINITY }
    }
}

/// Launch that a fit has found, and the other unknowns; [`crate::Launch`] computes the motion from a state.
#[derive(Clone, Copy, Debug)]
pub struct Launch {
    /// Orientation Φ at the epoch.
    pub orientation: Orientation<f64>,
    /// Angular velocity ω at the epoch in the fixed frame.
    pub omega: Vector<f64>,
    /// Values of the other unknowns, in the places from the seventh on: changes of the logarithms of the free ratios, losses,
    /// and biases.
    pub(crate) rest: Unknowns,
}

impl Default for Launch {
    fn default() -> Self {
        Self::new(Orientation::IDENTITY, [0.0; 3])
    }
}

impl Launch {
    /// Launch without biases, and with the ratios of the top.
    #[must_use]
    pub fn new(orientation: Orientation<f64>, omega: Vector<f64>) -> Self {
        Self { orientation, omega, rest: [0.0; MOST_UNKNOWNS] }
    }

    /// Values of the unknowns after those of the launch: changes of the logarithms of the free ratios, then the three losses
    /// if there is a drift, then the biases of the sensors that have one, in the order of the sensors.
    #[must_use]
    pub fn other_unknowns(&self) -> &[f64] {
        self.rest.get(LAUNCH..).unwrap_or(&[])
    }

    /// Distance of two launches: the angle between the orientations, and the relative difference of ω.
    pub(crate) fn distance(&self, other: &Self) -> f64 {
        let angle = self.orientation.distance(&other.orientation);
        let minus = Orientation { alpha: -other.orientation.alpha, beta: -other.orientation.beta };
        let off = total(self.omega, other.omega, -1.0);
        let rate = libm::sqrt(
            dot(off, off) / (dot(self.omega, self.omega) + dot(other.omega, other.omega) + 1e-300),
        );
        angle.min(self.orientation.distance(&minus)).max(rate)
    }
}
