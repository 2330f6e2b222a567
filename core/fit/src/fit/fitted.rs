//! Result of a fit: the launch, its covariance, and how far both can be trusted.

use crate::estimate::Estimate;
use crate::fit::limits::SMALL_ANGLE_SINE;
use crate::fit::solver::Solver;
use crate::fit::statistics::Statistics;
use crate::fit::warning::FitWarning;
use crate::model::{Model, propagated};
use crate::sensitivity::{Equations, LAUNCH_COLUMNS, LOSS_COUNT, Partials, Sensitivity};
use crate::square_root::{MAX_UNKNOWNS, SquareRoot, inner};
use crate::vector::{UP, Vector, add_all, add_scaled, cross, scaled};
use toytop::scalar::Real;
use toytop::{Motion, ParameterError, State, Top};

/// Undetermined directions of the launch: their standard deviation is above 1 rad, or above |ω|.
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
    pub const LOSS_NAMES: [&'static str; LOSS_COUNT] = ["loss_axial", "loss_across", "loss_vertical"];

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
    /// Time of the launch: that of the first measurement, or with losses that of the last one.
    pub launch_time: f64,
    /// Launch, biases and ratios.
    pub launch: Estimate,
    /// Statistics of the best pass. Only `chi_squared` already includes the last correction of the launch.
    pub statistics: Statistics,
    /// Undetermined directions. Their standard deviation is unknown, and is given as 10 rad or 10 |ω|.
    pub unobservable: Unobservable,
    /// Reason why the launch must not be trusted; `None` if it may be.
    pub warning: Option<FitWarning>,
    /// Number of other launches that fit the first measurements equally well.
    pub other_launch_count: usize,
    /// Number of unknowns.
    pub unknown_count: usize,
    /// Drift of the first integrals, if it was fitted.
    pub drift: Option<Drift>,
    /// Model of the unknowns.
    pub(super) model: Model,
    /// Covariance of the unknowns.
    pub(super) covariance: SquareRoot<f64>,
}

impl Fitted {
    /// Result of the best estimate of a fit, for measurements between two times.
    pub(super) fn new<F: Real>(
        solver: &mut Solver<F>,
        [first, last]: [f64; 2],
        warning: Option<FitWarning>,
    ) -> Self {
        let mut fitted = Self {
            launch_time: first,
            launch: solver.best.estimate,
            statistics: solver.best.statistics,
            unobservable: Unobservable::default(),
            warning,
            other_launch_count: 0,
            unknown_count: solver.model.count,
            model: solver.model,
            drift: None,
            covariance: SquareRoot::ZERO,
        };
        let rows = solver.damped(0.0).inverse_rows();
        fitted.covariance = rows.map(|row| row.map(F::to_f64)).collect();
        fitted.unobservable = unobservable(&fitted);
        if fitted.model.has_losses() && fitted.propagate_to(last).is_none() {
            fitted.warning = fitted.warning.or(Some(FitWarning::NotConverged));
        }
        fitted
    }

    /// Whether the fit has no warning. Other launches may still explain the readings as well (`other_launch_count`), or some of its directions
    /// be undetermined (`unobservable`).
    #[must_use]
    pub fn is_trusted(&self) -> bool {
        self.warning.is_none()
    }

    /// State of the launch.
    ///
    /// # Errors
    /// The errors of [`State::new`].
    pub fn state(&self) -> Result<State, ParameterError> {
        self.launch.state()
    }

    /// Top of the fit, with the fitted ratios.
    ///
    /// # Errors
    /// The errors of [`Top::sliding`], [`Top::fixed`] or [`Top::free`], by the support.
    pub fn top(&self) -> Result<Top, ParameterError> {
        self.model.top_of(&self.launch)
    }

    /// Motion of the launch, also of one that must not be trusted: see [`Fitted::warning`].
    ///
    /// # Errors
    /// The errors of [`Fitted::state`], [`Fitted::top`] and [`Motion::launch`].
    pub fn motion(&self) -> Result<Motion, ParameterError> {
        self.model.motion(&self.launch)
    }

    /// Derivatives of the fitted motion from the launch on, with errors below 1e-9 of the largest value of a column. With losses the motion includes
    /// the losses, and the measurements are at t <= 0.
    ///
    /// # Errors
    /// The errors of [`Fitted::motion`].
    pub fn sensitivity(&self) -> Result<Sensitivity, ParameterError> {
        let mut equations = Equations::new(&self.top()?);
        equations.coefficients.losses = self.model.losses_of(&self.launch);
        self.model.sensitivity(&self.launch, &equations)
    }

    /// Covariance of two unknowns, counted from 0; `None` if one of them is not an unknown of this fit. The unknowns are: rotation vector δ of
    /// Φ in the fixed frame, change η of ω in the frame that δ turns, logarithms of the free ratios, losses of rotation if they are unknowns,
    /// biases. The true launch is exp(δ) Φ and exp(δ) (ω + η).
    ///
    /// Errors are normally distributed in δ and η. In ω they are not, if the rotation about the vertical is poorly known.
    #[must_use]
    pub fn covariance(&self, i: usize, j: usize) -> Option<f64> {
        (i.max(j) < self.unknown_count).then(|| self.covariance.entry(i, j))
    }

    /// Standard deviations of the unknowns, in the coordinates of [`Fitted::covariance`]. Those after the first
    /// [`Fitted::unknown_count`] are 0, and belong to no unknown.
    #[must_use]
    pub fn deviations(&self) -> [f64; MAX_UNKNOWNS] {
        core::array::from_fn(|index| libm::sqrt(self.covariance.entry(index, index)))
    }

    /// Covariance of the rotation vector of a predicted orientation.
    #[must_use]
    pub fn orientation_covariance(&self, at: &Partials) -> [Vector<f64>; 3] {
        let columns = at.d_orientation();
        let (by_launch, by_ratios) = columns.split_at(LAUNCH_COLUMNS);
        let shares = self.model.ratio_derivatives(&self.launch);
        let free = shares.map(|shares| add_all([0.0; 3], by_ratios.iter().copied().zip(shares)));
        let mut columns = by_launch.iter().copied().chain(free);
        self.covariance_of(&core::array::from_fn(|_| columns.next().unwrap_or([0.0; 3])))
    }

    /// Covariance of a vector with these derivatives with respect to the unknowns.
    fn covariance_of(&self, columns: &[Vector<f64>; MAX_UNKNOWNS]) -> [Vector<f64>; 3] {
        let mut covariance = [[0.0; 3]; 3];
        for row in self.covariance.rows() {
            let error = add_all([0.0; 3], columns.iter().copied().zip(row));
            covariance.iter_mut().zip(error).for_each(|(line, x)| *line = add_scaled(*line, error, x));
        }
        covariance
    }

    /// Moves the launch to the last measurement, and adds the drift. `None` where the motion cannot be followed.
    ///
    /// [`Fitted::motion`] goes on from there without losses: see [partials](crate::partials).
    #[inline(never)] // stack
    fn propagate_to(&mut self, end: f64) -> Option<()> {
        let model = &self.model;
        let span = end - self.launch_time;
        let (launch, at) = model.predicted(&self.launch, span)?;
        let rates = model.mean_rates([&self.launch, &launch], span);
        // a change of a loss does not change the launch; it changes the integrals at the end by gradient times tangent
        let gradients = at.equations.gradients(&at.state);
        let c_over_a = at.equations.coefficients.c_over_a;
        let per_time = model.top.transverse_inertia() / span;
        let mut rates_by = [[0.0; 3]; MAX_UNKNOWNS];
        for (index, _) in model.losses() {
            let (Some(slot), Some(tangent)) = (rates_by.get_mut(index), at.tangents.get(index)) else {
                continue;
            };
            let [l, spin, h] = gradients.map(|by| by.inner(tangent));
            *slot = scaled([l, c_over_a * spin, h], per_time);
        }
        let covariance = self.covariance_of(&rates_by);
        self.drift = Some(Drift { rates, covariance, losses: model.losses_of(&launch) });
        self.covariance = self.covariance.rows().map(|row| propagated(&at.tangents, &row)).collect();
        (self.launch_time, self.launch) = (end, launch);
        Some(())
    }
}

/// Directions of the launch that the measurements do not determine to one unit.
///
/// Let C be the covariance in these units. A direction of variance c counts as c/(1 + c): nearly 0 if it is well determined, nearly 1 if not.
/// The number of undetermined directions is the sum, the trace of 1 - (1 + C)⁻¹.
///
/// A named direction d is undetermined if d (ε² + C)⁻¹ d < |d|², for the C of the launch. The small ε makes a direction undetermined that is
/// at an angle below ε from an undetermined one, as yaw and roll are from each other at a small tilt.
#[inline(never)] // stack
fn unobservable(fitted: &Fitted) -> Unobservable {
    let Fitted { launch, unknown_count: count, model, .. } = fitted;
    let (units, count) = (&model.units(launch), *count);
    let in_units = |mut row: [f64; MAX_UNKNOWNS], count: usize| {
        row.iter_mut().zip(units).for_each(|(x, unit)| *x /= unit);
        row.iter_mut().skip(count).for_each(|x| *x = 0.0);
        row
    };
    let with_noise = |deviation: f64, count: usize| {
        let mut sum: SquareRoot<f64> = fitted.covariance.rows().map(|row| in_units(row, count)).collect();
        (0..count).for_each(|index| sum.add_unknown(index, deviation));
        sum
    };
    let determined: f64 = with_noise(1.0, count).inverse_rows().flatten().map(|x| x * x).sum();
    let undetermined = libm::round((count as f64 - determined).max(0.0)) as usize;
    let sum = with_noise(SMALL_ANGLE_SINE, LAUNCH_COLUMNS);
    let axis = launch.orientation.axis();
    let none = [0.0; 3];
    let [yaw, roll, spin] = [[UP, none], [axis, cross(launch.omega, axis)], [none, axis]].map(|direction| {
        let mut along = [0.0; LAUNCH_COLUMNS];
        let components = direction.as_flattened().iter().zip(units);
        along.iter_mut().zip(components).for_each(|(slot, (x, unit))| *slot = x / unit);
        let information: f64 = sum.inverse_rows().map(|row| inner(&along, &row)).map(|x| x * x).sum();
        information < inner(&along, &along)
    });
    Unobservable { yaw, roll, spin, count: undetermined }
}
