//! Result of a fit: the launch, its covariance, and how far both can be trusted.

use crate::error::ParameterError;
use crate::fit::MOST_RATIOS;
use crate::fit::covariance::Covariance;
use crate::fit::drift::Drift;
use crate::fit::launch::{LAUNCH, Launch};
use crate::fit::triangle::MOST_UNKNOWNS;
use crate::motion::Motion;
use crate::sensitivity::{COLUMNS, Equations, Flow, Partials, Sensitivity, total};
use crate::state::State;
use crate::su2::Vector;
use crate::top::{Support, Top, TopParameters};
use core::fmt;

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
        match self {
            Self::NotFinite { index } => write!(f, "measurement {index}: must be finite"),
            Self::OutOfOrder { index } => {
                write!(f, "measurement {index}: must not be earlier than the one before")
            }
            Self::UnknownSensor { index } => {
                write!(f, "measurement {index}: must be of a sensor in the list")
            }
            Self::NoMeasurements => write!(f, "measurements: must not be empty"),
            Self::TooManyUnknowns => {
                write!(f, "sensors, ratios: must be at most four each, and one ratio with a drift")
            }
            Self::DriftDeviation => write!(f, "drift: must be a positive number"),
        }
    }
}

impl core::error::Error for FitError {}

/// Reason why a launch must not be trusted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Reason {
    /// The corrections did not become small.
    NotSettled,
    /// The residuals are far larger than the noise: the model, a unit or the noise is wrong, or the fit found a wrong
    /// solution.
    Misfit,
    /// The residuals are far larger than the noise, and become small when the rates are read as degrees per second.
    RatesInDegrees,
    /// The residuals are far larger than the noise, and all rates are below 0.1 per unit time: the top does not move freely.
    AtRest,
    /// Every component of every measurement was at the end of its range.
    AllSaturated,
    /// Fewer observations than unknowns of a launch.
    TooFew,
    /// The top is upright to within the noise, and no measurement determines its rate about the axis.
    SpinUnknown,
    /// The measurements determine no first guess: they contain neither an orientation, nor the axis, nor a direction
    /// with rates.
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
                "the measurements do not say where to begin: they need an orientation, an axis, or a direction and rates"
            }
        })
    }
}

/// Residuals of a fit.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Statistics {
    /// Number of components that were used.
    pub used: u32,
    /// Number of components that are not used, because they are at the end of their range.
    pub unused: u32,
    /// Number of components whose weight was reduced.
    pub outliers: u32,
    /// Sum of the squares of all residuals in standard deviations; the residual of an outlier counts as the limit.
    pub chi_squared: f64,
    /// Largest residual in standard deviations.
    pub largest: f64,
    /// Sum of the squares of the differences from prior values, such as those of biases, in standard deviations.
    pub prior: f64,
}

impl Statistics {
    /// Sum of squares over the number of degrees of freedom, observations minus unknowns: about 1 where model and noise
    /// are right.
    #[must_use]
    pub fn reduced_chi_squared(&self, unknowns: usize) -> f64 {
        let freedom = f64::from(self.used) - unknowns as f64;
        self.chi_squared / freedom.max(1.0)
    }

    /// Whether the sum of squares of the residuals that are not outliers exceeds its mean n by `deviations` standard
    /// deviations √(2 n), that of the prior exceeds 60, or more than ten and a fifth of all residuals are outliers.
    pub(crate) fn is_misfit(&self, unknowns: usize, deviations: f64, huber: f64) -> bool {
        let (used, outliers) = (f64::from(self.used), f64::from(self.outliers));
        let inliers =
            if outliers > 0.0 { self.chi_squared - huber * huber * outliers } else { self.chi_squared };
        let freedom = (used - outliers - unknowns as f64).max(1.0);
        // a known bias may differ by some standard deviations, and there are at most a dozen
        self.prior > 60.0
            || inliers > freedom + deviations * libm::sqrt(2.0 * freedom)
            || outliers > 0.2 * used + 10.0
    }
}

/// Directions of the launch that the measurements do not determine to one unit: one radian, or a change of ω by its own
/// size.
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

/// Result of a fit.
#[derive(Clone, Copy, Debug)]
pub struct Fitted {
    /// Time of the launch: that of the first measurement. With a drift it is that of the last one, because the exact
    /// motion from there on is the best prediction.
    pub epoch: f64,
    /// Launch, biases and ratios.
    pub launch: Launch,
    /// Covariance of the unknowns: rotation vector of Φ (fixed frame), ω, logarithms of the free ratios, losses of
    /// rotation if there is a drift, biases.
    pub covariance: Covariance,
    /// Residuals.
    pub statistics: Statistics,
    /// Directions that the measurements do not determine. Their standard deviations in the covariance are 10 rad, or ten
    /// times ω.
    pub unobservable: Unobservable,
    /// Reason why the launch must not be trusted; `None` where it may be.
    pub reason: Option<Reason>,
    /// Number of first guesses that lead to another launch which fits the first measurements equally well.
    pub alternatives: usize,
    /// Number of unknowns.
    pub count: usize,
    /// Drift of the first integrals, if it was fitted.
    pub drift: Option<Drift>,
    pub(crate) ratios: [f64; 4],
    /// Directions of the free ratios; 0 for the others.
    pub(crate) directions: [[f64; 4]; MOST_RATIOS],
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
        State::new(self.launch.orientation.normalised(), self.launch.omega)
    }

    /// Top with the fitted ratios, and with the A of the top that was given.
    ///
    /// # Errors
    /// The errors of [`Top::sliding`]; the name is that of the parameter which the fit took beyond its range.
    pub fn top(&self, given: &Top) -> Result<Top, ParameterError> {
        if self.directions == [[0.0; 4]; MOST_RATIOS] { Ok(*given) } else { with_ratios(given, &self.ratios) }
    }

    /// Derivatives of the fitted motion, whose t = 0 is the epoch. With a drift the motion includes the losses, and the
    /// measurements are at t <= 0.
    ///
    /// # Errors
    /// The errors of [`Fitted::motion`].
    pub fn sensitivity(&self, given: &Top) -> Result<Sensitivity, ParameterError> {
        let Some(drift) = &self.drift else { return Ok(Sensitivity::of(&self.motion(given)?)) };
        let (top, state) = (self.top(given)?, self.state()?);
        let equations = Equations::of(&top).with_losses(drift.losses);
        let start = Flow::launched(&state.orientation(), state.omega());
        Ok(Sensitivity::losing(&equations, start, top.tip_scale()))
    }

    /// Motion of the launch.
    ///
    /// # Errors
    /// The errors of [`Fitted::state`], [`Fitted::top`] and [`Motion::launch`].
    pub fn motion(&self, given: &Top) -> Result<Motion, ParameterError> {
        Motion::launch(&self.top(given)?, &self.state()?)
    }

    /// Standard deviations of the unknowns.
    #[must_use]
    pub fn deviations(&self) -> [f64; MOST_UNKNOWNS] {
        let mut deviations = [0.0; MOST_UNKNOWNS];
        for (index, slot) in deviations.iter_mut().enumerate() {
            *slot = libm::sqrt(self.covariance.of(index, index));
        }
        deviations
    }

    /// Derivatives with respect to the unknowns, from those with respect to the launch and the four ratios.
    pub(crate) fn columns(&self, by: &[Vector<f64>; COLUMNS]) -> [Vector<f64>; MOST_UNKNOWNS] {
        let (launch, ratios) = by.split_at(LAUNCH);
        let mut columns = [[0.0; 3]; MOST_UNKNOWNS];
        for (slot, column) in columns.iter_mut().zip(launch) {
            *slot = *column;
        }
        for (slot, direction) in columns.iter_mut().skip(LAUNCH).zip(&self.directions) {
            for ((column, share), ratio) in ratios.iter().zip(direction).zip(&self.ratios) {
                *slot = total(*slot, *column, share_of(*share, *ratio));
            }
        }
        columns
    }

    /// Covariance of the rotation vector of the predicted orientation, from the uncertainty of the launch and of the
    /// ratios.
    #[must_use]
    pub fn orientation_covariance(&self, at: &Partials) -> [Vector<f64>; 3] {
        let columns = self.columns(&at.orientation());
        let mut covariance = [[0.0; 3]; 3];
        for (i, a) in columns.iter().enumerate() {
            for (j, b) in columns.iter().enumerate() {
                let entry = self.covariance.of(i, j);
                for (line, x) in covariance.iter_mut().zip(a) {
                    for (slot, y) in line.iter_mut().zip(b) {
                        *slot += entry * x * y;
                    }
                }
            }
        }
        covariance
    }
}

/// Share of a ratio in a direction, times the ratio; 0 for the infinite A/C of a thin rod, whose motion does not depend on it.
pub(super) fn share_of(share: f64, ratio: f64) -> f64 {
    if ratio.is_finite() { share * ratio } else { 0.0 }
}

/// Top with other ratios, and with the same A.
pub(super) fn with_ratios(given: &Top, ratios: &[f64; 4]) -> Result<Top, ParameterError> {
    let [inertia, support, height, gravity] = *ratios;
    let a = given.transverse_inertia();
    let parameters = TopParameters {
        transverse_inertia: a,
        axial_inertia: a / inertia,
        gravity,
        rotor_momentum: given.rotor_momentum(),
        ..TopParameters::default()
    };
    match given.support() {
        Support::Sliding => Top::sliding(&TopParameters {
            com_height: height,
            mass_moment: a / (support * height),
            ..parameters
        }),
        Support::Fixed => Top::fixed(&TopParameters { mass_moment: a / support, ..parameters }),
        Support::Free => Top::free(&parameters),
    }
}
