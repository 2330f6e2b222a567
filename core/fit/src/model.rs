//! Order, units and prior information of the unknowns of a fit, and the motion that they determine.

use crate::estimate::{Estimate, FreeRatio};
use crate::sensitivity::{
    COLUMNS, Coefficients, Equations, FITTED_STEP, LAUNCH_COLUMNS, LOSS_COUNT, PASS_STEP, Partials, RATIOS,
    Sensitivity, Tangent, Trajectory, log_derivatives,
};
use crate::sensors::Sensor;
use crate::square_root::{MAX_UNKNOWNS, SquareRoot, Unknowns};
use crate::vector::{UNITS, Vector, add_scaled, norm, scaled};
use toytop::internal::{check, check_item};
use toytop::scalar::Real;
use toytop::{FirstIntegrals, Motion, Orientation, ParameterError, Top};

/// Largest number of sensors.
pub const MAX_SENSORS: usize = 4;
/// Largest number of ratios that are unknowns.
pub const MAX_RATIOS: usize = RATIOS;

/// Information before the measurements, about changes of an estimate.
#[derive(Clone)]
pub(crate) struct Prior<F> {
    pub(crate) estimate: Estimate,
    pub(crate) information: SquareRoot<F>,
}

/// Changes of the unknowns at a later time, from those at the launch.
///
/// * `columns`: derivatives of the motion with respect to the unknowns; those that are left out are 0
pub(crate) fn propagated(columns: &[Tangent<f64>], change: &Unknowns) -> Unknowns {
    let add = |sum: Tangent<f64>, (column, by): (&Tangent<f64>, &f64)| sum.plus(column, *by);
    let launch = columns.iter().zip(change).fold(Tangent::ZERO, add);
    let mut propagated = *change;
    propagated.iter_mut().zip(launch.components()).for_each(|(slot, x)| *slot = x);
    propagated
}

/// Unknowns of a fit: the launch, the free ratios, the losses of rotation, and the biases.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Model {
    pub(crate) top: Top,
    free: [FreeRatio; MAX_RATIOS],
    free_count: usize,
    /// First bias of each sensor among the unknowns.
    biases: [Option<usize>; MAX_SENSORS],
    /// Prior standard deviations; infinite where there is no prior information.
    deviations: Unknowns,
    /// Number of unknowns of the motion: all but the biases.
    pub(crate) motion_count: usize,
    pub(crate) count: usize,
}

impl Model {
    /// Model of these unknowns, with the prior deviation of the losses if they are unknowns.
    pub(crate) fn new<F>(
        top: &Top,
        sensors: &[&dyn Sensor<F>],
        ratios: &[FreeRatio],
        loss_deviation: Option<f64>,
    ) -> Result<Self, ParameterError> {
        let losses = loss_deviation.into_iter().flat_map(|deviation| [deviation; LOSS_COUNT]);
        let motion_count = LAUNCH_COLUMNS + ratios.len() + losses.clone().count();
        check(sensors.len() <= MAX_SENSORS, "sensors", "at most four")?;
        check(motion_count <= COLUMNS, "ratios", "at most four, or one with losses")?;
        for (index, sensor) in sensors.iter().enumerate() {
            let allowed = "one with positive noise, and a bias that is not negative";
            check_item(sensor.noise().is_valid(), "sensors", index, allowed)?;
        }
        for (index, ratio) in ratios.iter().enumerate() {
            let allowed = "one with a finite direction other than 0, and a positive deviation";
            check_item(ratio.is_valid(), "ratios", index, allowed)?;
        }
        let mut model = Self {
            top: *top,
            free: [FreeRatio::new([0.0; RATIOS]); MAX_RATIOS],
            free_count: ratios.len(),
            motion_count,
            biases: [None; MAX_SENSORS],
            deviations: [f64::INFINITY; MAX_UNKNOWNS],
            count: motion_count,
        };
        model.free.iter_mut().zip(ratios).for_each(|(slot, ratio)| *slot = *ratio);
        let mut slots = model.deviations.iter_mut().skip(LAUNCH_COLUMNS);
        let known = ratios.iter().map(|ratio| ratio.deviation).chain(losses);
        known.zip(&mut slots).for_each(|(deviation, slot)| *slot = deviation);
        for (first, sensor) in model.biases.iter_mut().zip(sensors) {
            let deviation = sensor.noise().bias_deviation;
            if deviation > 0.0 {
                *first = Some(model.count);
                slots.by_ref().take(3).for_each(|slot| *slot = deviation);
                model.count += 3;
            }
        }
        Ok(model)
    }

    /// Free ratios.
    pub(crate) fn free(&self) -> &[FreeRatio] {
        self.free.get(..self.free_count).unwrap_or(&[])
    }

    /// Whether the losses are unknowns.
    pub(crate) fn has_losses(&self) -> bool {
        self.losses().next().is_some()
    }

    /// Places of the losses among the unknowns, and their prior standard deviations.
    pub(crate) fn losses(&self) -> impl Iterator<Item = (usize, f64)> {
        let unknowns = self.deviations.iter().copied().enumerate();
        unknowns.take(self.motion_count).skip(LAUNCH_COLUMNS + self.free_count)
    }

    /// Whether another model is of the same top, and has the same unknowns in the same order.
    pub(crate) fn has_unknowns_of(&self, other: &Self) -> bool {
        self.top == other.top
            && self.free() == other.free()
            && self.motion_count == other.motion_count
            && self.biases == other.biases
    }

    /// First bias of a sensor among the unknowns.
    pub(crate) fn bias(&self, sensor: usize) -> Option<usize> {
        self.biases.get(sensor).copied().flatten()
    }

    /// Losses of an estimate.
    pub(crate) fn losses_of(&self, estimate: &Estimate) -> [f64; LOSS_COUNT] {
        let losses = estimate.ratios_losses_and_biases.get(self.free_count..).and_then(<[f64]>::first_chunk);
        losses.copied().filter(|_| self.has_losses()).unwrap_or([0.0; LOSS_COUNT])
    }

    /// Equations of an estimate. After the launch, their columns are the free ratios and the losses.
    pub(crate) fn equations(&self, estimate: &Estimate) -> Equations<f64> {
        let mut coefficients = Coefficients::new(&self.top);
        let by = self.free.map(|free| log_derivatives(self.top.support(), free.direction));
        for (by, value) in by.iter().zip(estimate.ratios_losses_and_biases).take(self.free_count) {
            coefficients = coefficients.times(by.map(|by| libm::exp(by * value)));
        }
        let mut changes = by.map(|by| Coefficients { k_over_a: 0.0, ..coefficients.times(by) });
        coefficients.losses = self.losses_of(estimate);
        let by_losses = changes.iter_mut().skip(self.free_count).zip(self.losses());
        by_losses.zip(UNITS).for_each(|((change, _), unit)| change.losses = unit);
        Equations { coefficients, changes, column_count: self.motion_count }
    }

    /// Trajectory of an estimate for a pass.
    pub(crate) fn trajectory<F: Real>(&self, estimate: &Estimate) -> Trajectory<F> {
        Trajectory::new(&estimate.body_state(), &self.equations(estimate), PASS_STEP)
    }

    /// Derivatives of the ratios with respect to those that are free; 0 for the infinite A/C of a thin rod, whose motion does not
    /// depend on it.
    pub(crate) fn ratio_derivatives(&self, estimate: &Estimate) -> [[f64; RATIOS]; MAX_RATIOS] {
        let ratios = self.equations(estimate).coefficients.ratios(self.top.support());
        let mut shares = self.free.map(|free| free.direction);
        for (weight, ratio) in shares.iter_mut().flat_map(|direction| direction.iter_mut().zip(ratios)) {
            *weight = if ratio.is_finite() { *weight * ratio } else { 0.0 };
        }
        shares
    }

    /// Top of an estimate, with A, the rotor and the support of the model's top.
    pub(crate) fn top_of(&self, estimate: &Estimate) -> Result<Top, ParameterError> {
        if self.free_count == 0 {
            return Ok(self.top);
        }
        self.equations(estimate).coefficients.top(&self.top)
    }

    /// Motion of an estimate without losses.
    pub(crate) fn motion(&self, estimate: &Estimate) -> Result<Motion, ParameterError> {
        Motion::launch(&self.top_of(estimate)?, &estimate.state()?)
    }

    /// Derivatives of the motion of an estimate, with the columns of these equations.
    pub(crate) fn sensitivity(
        &self,
        estimate: &Estimate,
        equations: &Equations<f64>,
    ) -> Result<Sensitivity, ParameterError> {
        if self.has_losses() {
            return Ok(Sensitivity::without_period(equations, &estimate.body_state(), FITTED_STEP));
        }
        Ok(Sensitivity::with_equations(&self.motion(estimate)?, equations, FITTED_STEP))
    }

    /// Launch at a later time, with the derivatives there with respect to the unknowns.
    pub(crate) fn predicted(&self, estimate: &Estimate, span: f64) -> Option<(Estimate, Partials)> {
        let equations = self.equations(estimate);
        let at = self.sensitivity(estimate, &equations).ok()?.at(span)?;
        let orientation = at.orientation();
        let omega = at.omega();
        Some((Estimate { orientation, omega, ..*estimate }, at))
    }

    /// Mean rates of change of l, n and h between two estimates that are `span` apart: 0 where that is 0, and NaN where an estimate has
    /// no state.
    pub(crate) fn mean_rates(&self, estimates: [&Estimate; 2], span: f64) -> Vector<f64> {
        let [before, after] = estimates.map(|estimate| {
            let integrals = |top| Ok(FirstIntegrals::from_state(&top, &estimate.state()?));
            let integrals = self.top_of(estimate).and_then(integrals);
            integrals.map_or([f64::NAN; 3], |FirstIntegrals { l, n, h, .. }| [l, n, h])
        });
        scaled(add_scaled(after, before, -1.0), if span > 0.0 { 1.0 / span } else { 0.0 })
    }

    /// Information before the first measurement: losses, biases and changes of the ratios are near 0.
    pub(crate) fn prior<F: Real>(&self) -> Prior<F> {
        let mut information = SquareRoot::ZERO;
        for (index, deviation) in self.deviations.iter().enumerate() {
            information.add_unknown(index, F::from_f64(1.0 / *deviation));
        }
        Prior { estimate: Estimate::new(Orientation::IDENTITY, [0.0; 3]), information }
    }

    /// Unit of each unknown: 1 rad, a change of ω or of a ratio by its own size, and ten times a prior deviation, so that an unknown
    /// that only its prior determines counts as determined.
    pub(crate) fn units(&self, estimate: &Estimate) -> Unknowns {
        let Coefficients { p_over_a, g, .. } = self.equations(estimate).coefficients;
        let rate = norm([norm(estimate.omega), libm::sqrt(p_over_a * g), 0.0]);
        let mut units =
            self.deviations.map(|deviation| if deviation.is_finite() { 10.0 * deviation } else { 1.0 });
        units.iter_mut().take(LAUNCH_COLUMNS).skip(3).for_each(|unit| *unit = rate);
        units
    }
}
