//! Estimate of the unknowns of a fit: a launch, free ratios of the top, losses and biases.

use crate::sensitivity::{BodyState, LAUNCH_COLUMNS, RATIOS};
use crate::square_root::{MAX_UNKNOWNS, Unknowns};
use crate::vector::{Vector, add_scaled, rotation_vector};
use toytop::su2::Orientation;
use toytop::{ParameterError, State};

/// Unknown ratio of the top: a direction in the space of log A/C, log A/(ps) (A/p for a fixed tip), log s and log g.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FreeRatio {
    /// Direction in that space. The unknown times the direction is the change of the four logarithms.
    pub direction: [f64; RATIOS],
    /// Prior standard deviation of the unknown; infinite where there is no prior information.
    pub deviation: f64,
}

impl FreeRatio {
    /// Direction in which only the axial inertia C changes.
    pub const AXIAL_INERTIA: Self = Self::new([-1.0, 0.0, 0.0, 0.0]);
    /// Direction in which only the transverse inertia A changes.
    pub const TRANSVERSE_INERTIA: Self = Self::new([1.0, 1.0, 0.0, 0.0]);
    /// Direction in which only the mass moment p changes.
    pub const MASS_MOMENT: Self = Self::new([0.0, -1.0, 0.0, 0.0]);
    /// Direction in which only the length s of a sliding top changes, while p is kept.
    pub const COM_HEIGHT: Self = Self::new([0.0, -1.0, 1.0, 0.0]);
    /// Direction in which only gravity g changes.
    pub const GRAVITY: Self = Self::new([0.0, 0.0, 0.0, 1.0]);

    /// Whether the direction is finite and not 0, and the deviation is positive.
    pub(crate) fn is_valid(&self) -> bool {
        let size: f64 = self.direction.iter().map(|x| x.abs()).sum();
        size > 0.0 && size.is_finite() && self.deviation > 0.0
    }

    /// Unknown without prior information.
    #[must_use]
    pub const fn new(direction: [f64; RATIOS]) -> Self {
        Self { direction, deviation: f64::INFINITY }
    }
}

/// Launch and other unknowns that a fit has found, or begins from.
#[derive(Clone, Copy, Debug)]
pub struct Estimate {
    /// Orientation Φ at the launch.
    pub orientation: Orientation<f64>,
    /// Angular velocity ω at the launch in the fixed frame, rad per unit time.
    pub omega: Vector<f64>,
    /// Changes of the logarithms of the free ratios, losses, and biases.
    pub(crate) ratios_losses_and_biases: [f64; MAX_UNKNOWNS - LAUNCH_COLUMNS],
}

impl Estimate {
    /// Estimate without biases, and with the ratios of the top.
    #[must_use]
    pub fn new(orientation: Orientation<f64>, omega: Vector<f64>) -> Self {
        Self { orientation, omega, ratios_losses_and_biases: [0.0; MAX_UNKNOWNS - LAUNCH_COLUMNS] }
    }

    /// Values of the other unknowns: changes of the logarithms of the free ratios, the three losses, if they are unknowns, and the biases
    /// of the sensors that have one. 0 after the last unknown.
    #[must_use]
    pub fn ratios_losses_and_biases(&self) -> &[f64] {
        &self.ratios_losses_and_biases
    }

    /// Value of an unknown that is no part of the launch.
    pub(crate) fn unknown(&self, index: usize) -> Option<f64> {
        self.ratios_losses_and_biases.get(index.checked_sub(LAUNCH_COLUMNS)?).copied()
    }

    /// State of the launch.
    pub(crate) fn state(&self) -> Result<State, ParameterError> {
        State::new(self.orientation.normalised(), self.omega)
    }

    /// State of the launch. Its orientation is not normalised.
    pub(crate) fn body_state(&self) -> BodyState<f64> {
        BodyState::new(self.orientation, self.omega)
    }

    /// Estimate after a change of the unknowns: a rotation vector δ of the fixed frame, a change η of ω in the frame that δ turns, and
    /// changes of the others.
    pub(crate) fn corrected(&self, change: &Unknowns) -> Self {
        let [d1, d2, d3, w1, w2, w3, others @ ..] = *change;
        let turn = Orientation::exp([d1, d2, d3]);
        let mut ratios_losses_and_biases = self.ratios_losses_and_biases;
        ratios_losses_and_biases.iter_mut().zip(others).for_each(|(slot, by)| *slot += by);
        Self {
            orientation: turn.compose(&self.orientation).normalised(),
            omega: turn.adjoint(add_scaled(self.omega, [w1, w2, w3], 1.0)),
            ratios_losses_and_biases,
        }
    }

    /// Change of the unknowns from another estimate to this one.
    pub(crate) fn change_from(&self, from: &Self) -> Unknowns {
        let turn = self.orientation.compose(&from.orientation.inverse());
        let rate = add_scaled(turn.inverse().adjoint(self.omega), from.omega, -1.0);
        let others =
            self.ratios_losses_and_biases.iter().zip(from.ratios_losses_and_biases).map(|(x, y)| x - y);
        let mut change = rotation_vector(&turn).into_iter().chain(rate).chain(others);
        core::array::from_fn(|_| change.next().unwrap_or(0.0))
    }
}
