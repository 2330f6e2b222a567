//! Passes over the measurements.

use crate::fit::Fit;
use crate::fit::beginning::Beginning;
use crate::fit::launch::Launch;
use crate::fit::outcome::Statistics;
use crate::fit::sensor::{Hint, Measurement, Prediction};
use crate::fit::sums::Sums;
use crate::fit::triangle::Triangle;
use crate::fit::window::Part;
use crate::scalar::Real;
use crate::su2::Vector;

/// Size of a correction, in standard deviations, below which the fit has converged. The next correction would be about
/// its square.
pub(super) const SETTLED: f64 = 0.05;
/// Largest number of passes over one window of measurements.
const MOST_PASSES: u32 = 30;
/// Marquardt's damping at the beginning.
pub(super) const FIRST_DAMPING: f64 = 1e-3;

/// One pass over the measurements.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pass<F> {
    pub(super) launch: Launch,
    pub(super) information: Triangle<F>,
    pub(super) statistics: Statistics,
    pub(super) cost: f64,
}

/// Result of a correction.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Progress {
    Again,
    Settled,
    Stuck,
    /// The top stands upright, and its spin is not determined.
    SpinUnknown,
    /// Too few measurements are later than the epoch.
    TooFew,
    /// There is no first guess.
    NoBeginning,
}

impl<F: Real> Pass<F> {
    /// Pass from a launch, without measurements.
    pub(super) fn new(launch: Launch, count: usize) -> Self {
        Self {
            launch,
            information: Triangle::new(count),
            statistics: Statistics::default(),
            cost: f64::INFINITY,
        }
    }
}

impl<F: Real> Fit<'_, F> {
    /// Begins without information, from the guess with this number, or from a top at rest.
    #[inline(never)] // its launch is on the stack only here
    pub(super) fn start(&mut self, guess: Option<(&Beginning, u32)>) {
        let launch = guess.map_or_else(Launch::default, |(beginning, number)| beginning.guess(number));
        self.start_from(&launch);
    }

    /// Begins without information, from a launch.
    pub(super) fn start_from(&mut self, launch: &Launch) {
        self.best.information.clear();
        self.best.statistics = Statistics::default();
        self.best.launch = *launch;
        self.best.launch.orientation = launch.orientation.normalised();
        self.damping = FIRST_DAMPING;
        self.curvature = f64::INFINITY;
        self.restart();
    }

    /// Begins anew from the best launch, on another set of measurements. A large damping of the last ones would make the first correction
    /// so small that the fit would end with it.
    fn restart(&mut self) {
        self.best.cost = f64::INFINITY;
        if self.damping > FIRST_DAMPING {
            self.damping = FIRST_DAMPING;
        }
        self.last_change = None;
        self.current.launch = self.best.launch;
        self.begin_pass();
    }

    /// Begins a pass with the current launch.
    #[inline(never)] // its matrices are on the stack between passes only
    fn begin_pass(&mut self) {
        let Pass { launch, information, statistics, cost } = &mut self.current;
        information.clear();
        *cost = match &self.prior {
            Some(prior) => prior.add_to(launch, information),
            None => self.model.add_prior(launch, information),
        };
        *statistics = Statistics { prior: *cost, ..Statistics::default() };
        self.path.begin(launch, || self.model.equations(launch));
        self.rows.clear();
        self.shares = self.model.shares(launch);
        for (slot, bias) in self.biases.iter_mut().zip(launch.rest.iter().skip(self.model.common())) {
            *slot = F::from_f64(*bias);
        }
        self.epoch = None;
        self.now = None;
    }

    /// Passes over the measurements until the launch does not change any more.
    ///
    /// * `settled`: size of a correction, in standard deviations, below which the launch counts as unchanged
    #[inline(never)] // its copies would take more stack
    pub(super) fn settle<I>(&mut self, measurements: &I, part: Part, settled: f64) -> Progress
    where
        I: Iterator<Item = Measurement> + Clone,
    {
        self.restart();
        for _ in 0..MOST_PASSES {
            self.pass_over(measurements, part);
            match self.improve(settled) {
                Progress::Again => self.begin_pass(),
                done => return done,
            }
        }
        Progress::Stuck
    }

    /// One pass over the measurements with a launch.
    pub(super) fn pass<I>(&mut self, launch: &Launch, measurements: &I, part: Part)
    where
        I: Iterator<Item = Measurement> + Clone,
    {
        self.current.launch = *launch;
        self.begin_pass();
        self.pass_over(measurements, part);
    }

    #[inline(never)] // its measurements are on the stack during a pass only
    fn pass_over<I>(&mut self, measurements: &I, part: Part)
    where
        I: Iterator<Item = Measurement> + Clone,
    {
        let mut sums = Sums::default();
        let huber = F::from_f64(self.huber);
        for measurement in part.of(measurements.clone()) {
            if self.move_to(measurement.time).is_none() || self.add(&measurement, huber, &mut sums).is_none()
            {
                self.current.cost = f64::INFINITY;
                return;
            }
        }
        let Pass { information, statistics, cost, .. } = &mut self.current;
        *cost += sums.cost.to_f64();
        statistics.chi_squared += sums.squares.to_f64();
        statistics.largest = sums.largest.to_f64();
        (statistics.used, statistics.unused, statistics.outliers) = (sums.used, sums.unused, sums.outliers);
        self.rows.add_to(information);
    }

    /// Adds one measurement to the current pass, at the time to which the path was moved. `None` where there is no such
    /// sensor.
    #[inline(never)] // the prediction and the motion of the path must not be on the stack together
    fn add(&mut self, measurement: &Measurement, huber: F, sums: &mut Sums<F>) -> Option<()> {
        let Measurement { sensor: index, ref values, .. } = *measurement;
        let sensor = *self.sensors.get(index)?;
        let converted;
        let values = match self.rate_unit {
            Some(unit) if matches!(sensor.hint(values), Hint::Rate { .. }) => {
                converted = values.map(|x| x * unit);
                &converted
            }
            _ => values,
        };
        let prediction = sensor.predict(self.path.now(), values);
        let bias = self.model.bias_of(index);
        self.add_component::<0>(&prediction, bias, huber, sums);
        self.add_component::<1>(&prediction, bias, huber, sums);
        self.add_component::<2>(&prediction, bias, huber, sums);
        Some(())
    }

    /// Adds component `K` of a prediction. `K` is a constant, so that the selection takes no time.
    ///
    /// * `bias`: first bias of the sensor
    #[inline(always)]
    fn add_component<const K: usize>(
        &mut self,
        Prediction { difference, deviation, columns }: &Prediction<F>,
        bias: Option<usize>,
        huber: F,
        sums: &mut Sums<F>,
    ) {
        let component = |[x, y, z]: Vector<F>| match K {
            0 => x,
            1 => y,
            _ => z,
        };
        let per_deviation = F::ONE / component(*deviation);
        if per_deviation == F::ZERO {
            sums.unused += 1;
            return;
        }
        let mut residual = component(*difference) * per_deviation;
        let bias = bias.map(|first| first + K);
        if let Some(known) = bias.and_then(|bias| self.biases.get(bias)) {
            residual = residual - *known * per_deviation;
        }
        let weight = sums.add(residual, huber);
        let scale = weight * per_deviation;
        if let Some(row) = self.rows.next(bias, scale, weight * residual) {
            let entries = columns.map(|column| scale * component(column));
            self.model.fill(row, &self.shares, &entries);
        }
    }

    /// Computes the state and the derivatives at a time.
    #[inline(never)] // as above
    fn move_to(&mut self, time: f64) -> Option<()> {
        // the bits are compared, which is faster on a chip without a unit for `f64`
        if self.now.map(f64::to_bits) == Some(time.to_bits()) {
            return Some(());
        }
        let epoch = *self.epoch.get_or_insert(time);
        let (model, launch) = (&self.model, &self.current.launch);
        self.path.move_to(time - epoch, || model.turns_in_period(launch))?;
        self.now = Some(time);
        Some(())
    }
}
