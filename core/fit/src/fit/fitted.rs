//! Result of a fit: the launch, its covariance, and how far both can be trusted.

use crate::fit::statistics::Statistics;
use crate::least_squares::{Columns, Covariance, MOST_UNKNOWNS};
use crate::model::{Estimate, MOST_RATIOS};
use crate::sensitivity::{
    COLUMNS, Coefficients, Equations, LAUNCH, LOSSES, Partials, RATIOS, Sensitivity, with_coefficients,
};
use crate::vector::{UNITS, Vector, add_scaled, cross};
use core::fmt;
use toytop::{Motion, ParameterError, State, Top};

/// Input that a fit refuses. `index` counts the measurements from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum FitError {
    /// A time or a value is NaN or infinite.
    NotFinite {
        /// Index of the measurement.
        index: usize,
    },
    /// A measurement is earlier than the one before.
    OutOfOrder {
        /// Index of the measurement.
        index: usize,
    },
    /// A measurement names a sensor that is not in the list.
    UnknownSensor {
        /// Index of the measurement.
        index: usize,
    },
    /// There is no measurement.
    NoMeasurements,
    /// There are more than four sensors, or more than four free ratios, or more than one with a drift.
    TooManyUnknowns,
    /// The deviation of a drift is not a positive number.
    DriftDeviation,
}

impl fmt::Display for FitError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (index, what) = match self {
            Self::NotFinite { index } => (index, "must be finite"),
            Self::OutOfOrder { index } => (index, "must not be earlier than the one before"),
            Self::UnknownSensor { index } => (index, "must be of a sensor in the list"),
            Self::NoMeasurements => return f.write_str("measurements: must not be empty"),
            Self::TooManyUnknowns => {
                return f.write_str("sensors, ratios: must be at most four each, and one ratio with a drift");
            }
            Self::DriftDeviation => return f.write_str("drift: must be a positive number"),
        };
        write!(f, "measurement {index}: {what}")
    }
}

impl core::error::Error for FitError {}

/// Reason why a launch must not be trusted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Reason {
    /// The corrections did not become small.
    NotSettled,
    /// The residuals of a sensor are far larger than the noise: the model, a unit, the noise or the solution is wrong.
    Misfit,
    /// The residuals become small when the rates are read as degrees per second.
    RatesInDegrees,
    /// All rates are below 0.1 per unit time, and the residuals are large: the top does not move freely.
    AtRest,
    /// Every component of every measurement was at the end of its range.
    AllSaturated,
    /// Fewer observations than unknowns of a launch.
    TooFew,
    /// The top is upright, and no measurement determines its rate about the axis.
    SpinUnknown,
    /// The measurements contain neither an orientation, nor an axis, nor rates within the range.
    NoBeginning,
}

impl fmt::Display for Reason {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::NotSettled => "the corrections did not become small",
            Self::Misfit => "the residuals are far larger than the noise",
            Self::RatesInDegrees => "the rates seem to be in degrees per second: the residuals then are small",
            Self::AtRest => "the top is at rest, held by something that the model does not know",
            Self::AllSaturated => "every component is at the end of its range",
            Self::TooFew => "there are fewer observations than unknowns",
            Self::SpinUnknown => "the top stands upright, and nothing tells its rate about the axis",
            Self::NoBeginning => {
                "the measurements do not say where to begin: they need an orientation, an axis, or rates within the range"
            }
        })
    }
}

/// Directions of the launch that the measurements do not determine to 1 rad, or to a change of ω by its own size.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Unobservable {
    /// Rotation of the whole motion about the vertical.
    pub yaw: bool,
    /// Rotation of the body about its axis.
    pub roll: bool,
    /// Angular velocity about the axis.
    pub spin: bool,
    /// Number of independent directions, including the named ones.
    pub count: usize,
}

/// Drift of the first integrals, averaged over the time of the measurements.
#[derive(Clone, Copy, Debug)]
pub struct Drift {
    /// Rates of change of l, n and h, per unit time.
    pub rates: Vector<f64>,
    /// Covariance of the rates.
    pub covariance: [Vector<f64>; 3],
    /// Losses of rotation about the axis, across it, and about the vertical: shares of the rotation per unit time.
    pub losses: Vector<f64>,
}

impl Drift {
    /// Names of the losses, in order.
    pub const LOSSES: [&'static str; LOSSES] = ["loss_axial", "loss_across", "loss_vertical"];

    /// Standard deviations of the rates.
    #[must_use]
    pub fn deviations(&self) -> Vector<f64> {
        let [[l, ..], [_, n, _], [.., h]] = self.covariance;
        [l, n, h].map(libm::sqrt)
    }
}

/// Result of a fit.
#[derive(Clone, Copy, Debug)]
pub struct Fitted {
    /// Time of the launch: that of the first measurement, or with a drift that of the last one.
    pub epoch: f64,
    /// Launch, biases and ratios.
    pub launch: Estimate,
    /// Covariance of the unknowns: rotation vector δ of Φ in the fixed frame, change η of ω in the frame that δ turns, logarithms of the
    /// free ratios, losses of rotation if there is a drift, biases. The true launch is exp(δ) Φ and exp(δ) (ω + η).
    ///
    /// In these coordinates the errors are normally distributed. Those of ω itself are not where the rotation about the vertical is
    /// poorly known.
    pub covariance: Covariance,
    /// Residuals.
    pub statistics: Statistics,
    /// Directions that the measurements do not determine. Their standard deviations are 10 rad, or ten times ω.
    pub unobservable: Unobservable,
    /// Reason why the launch must not be trusted; `None` where it may be.
    pub reason: Option<Reason>,
    /// Number of first guesses that lead to another launch, which fits the first measurements equally well.
    pub alternatives: usize,
    /// Number of unknowns.
    pub count: usize,
    /// Drift of the first integrals, if it was fitted.
    pub drift: Option<Drift>,
    /// Coefficients of the top, if a ratio is free.
    pub(super) coefficients: Option<Coefficients>,
    /// Derivatives of the ratios with respect to those that are free.
    pub(super) ratio_shares: [[f64; RATIOS]; MOST_RATIOS],
}

impl Fitted {
    /// Whether the launch may be trusted.
    #[must_use]
    pub fn converged(&self) -> bool {
        self.reason.is_none()
    }

    /// State of the launch.
    ///
    /// # Errors
    /// The errors of [`State::new`].
    pub fn state(&self) -> Result<State, ParameterError> {
        self.launch.state()
    }

    /// Top with the fitted ratios and the given A.
    ///
    /// # Errors
    /// The errors of [`Top::sliding`].
    pub fn top(&self, given: &Top) -> Result<Top, ParameterError> {
        match &self.coefficients {
            Some(coefficients) => with_coefficients(given, coefficients),
            None => Ok(*given),
        }
    }

    /// Motion of the launch.
    ///
    /// # Errors
    /// The errors of [`Fitted::state`], [`Fitted::top`] and [`Motion::launch`].
    pub fn motion(&self, given: &Top) -> Result<Motion, ParameterError> {
        Motion::launch(&self.top(given)?, &self.state()?)
    }

    /// Derivatives of the fitted motion from the epoch on. With a drift the motion includes the losses, and the
    /// measurements are at t <= 0.
    ///
    /// # Errors
    /// The errors of [`Fitted::motion`].
    pub fn sensitivity(&self, given: &Top) -> Result<Sensitivity, ParameterError> {
        let Some(Drift { losses, .. }) = self.drift else {
            return Ok(Sensitivity::new(&self.motion(given)?));
        };
        let (top, state) = (self.top(given)?, self.state()?);
        let mut equations = Equations { lossy: true, ..Equations::new(&top) };
        let [.., axial, across, vertical] = &mut equations.coefficients;
        [*axial, *across, *vertical] = losses;
        Ok(Sensitivity::launched(equations, top.tip_scale(), &state.orientation(), state.omega()))
    }

    /// Standard deviations of the unknowns, in the coordinates of [`Fitted::covariance`].
    #[must_use]
    pub fn deviations(&self) -> [f64; MOST_UNKNOWNS] {
        core::array::from_fn(|index| libm::sqrt(self.covariance.get(index, index)))
    }

    /// Covariance of the rotation vector of a predicted orientation.
    #[must_use]
    pub fn orientation_covariance(&self, at: &Partials) -> [Vector<f64>; 3] {
        self.covariance.of_vector(&self.columns(&at.orientation()))
    }

    /// Derivatives with respect to the unknowns, from those with respect to the launch and the ratios.
    fn columns(&self, by: &[Vector<f64>; COLUMNS]) -> Columns {
        let [_, _, _, by_omega @ .., _, _, _, _] = by;
        let (_, ratios) = by.split_at(LAUNCH);
        let mut columns = [[0.0; 3]; MOST_UNKNOWNS];
        columns.iter_mut().zip(by).take(LAUNCH).for_each(|(slot, column)| *slot = *column);
        // ω turns with the orientation
        for (slot, unit) in columns.iter_mut().zip(UNITS) {
            for (column, share) in by_omega.iter().zip(cross(unit, self.launch.omega)) {
                *slot = add_scaled(*slot, *column, share);
            }
        }
        for (slot, shares) in columns.iter_mut().skip(LAUNCH).zip(self.ratio_shares) {
            for (column, share) in ratios.iter().zip(shares) {
                *slot = add_scaled(*slot, *column, share);
            }
        }
        columns
    }
}
