//! Passes over the measurements, and the correction of the launch after each.

use crate::fit::Fit;
use crate::fit::launch::Launch;
use crate::fit::model::Model;
use crate::fit::outcome::{Fitted, Reason, Statistics, Unobservable};
use crate::fit::sensor::{Hint, Measurement};
use crate::fit::triangle::{MOST_UNKNOWNS, Triangle};
use crate::fit::window::Part;
use crate::scalar::Real;

/// Size of a correction, in standard deviations, below which the fit has converged. The next one would be about its
/// square.
pub(super) const SETTLED: f64 = 0.05;
/// Estimated size of the next correction, in standard deviations, below which the fit has converged without a pass that
/// confirms it.
const NEXT_SETTLED: f64 = 0.1;
/// Largest correction, in standard deviations, after which the fit converges without such a pass.
const MOST_UNCONFIRMED: f64 = 10.0;
/// Least sine of the tilt at which the fit converges without such a pass.
const LEAST_TILT: f64 = 0.1;
/// Change of the sum of squares that may come from the error of the integration.
const ROUNDING: f64 = 0.05;
/// Passes that one window of measurements may take.
const MOST_PASSES: u32 = 30;
/// Standard deviations of the sum of squares beyond which the residuals are larger than the noise explains.
const MISFIT: f64 = 5.0;

/// One pass over the measurements.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pass<F> {
    pub(super) launch: Launch,
    pub(super) information: Triangle<F>,
    pub(super) statistics: Statistics,
    pub(super) cost: f64,
}

/// Sums over the residuals of a pass.
#[derive(Clone, Copy)]
struct Sums<F> {
    cost: Sum<F>,
    squares: Sum<F>,
    largest: F,
}

impl<F: Real> Default for Sums<F> {
    fn default() -> Self {
        let zero = Sum { high: F::ZERO, low: F::ZERO };
        Self { cost: zero, squares: zero, largest: F::ZERO }
    }
}

/// Sum of many numbers in two parts, so that it keeps the digits of each: a chip without `f64` takes longer for an
/// addition in it.
#[derive(Clone, Copy)]
struct Sum<F> {
    high: F,
    low: F,
}

impl<F: Real> Sum<F> {
    /// Adds a number, which is not negative; the rounding error of the high part goes to the low one.
    fn add(&mut self, x: F) {
        let high = self.high + x;
        let taken = high - self.high;
        self.low = self.low + ((self.high - (high - taken)) + (x - taken));
        self.high = high;
    }

    fn to_f64(self) -> f64 {
        self.high.to_f64() + self.low.to_f64()
    }
}

/// Result of a correction.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Progress {
    Again,
    Settled,
    Stuck,
    /// The top stands upright, and its spin is not determined.
    SpinUnknown,
    /// There are fewer than three instants.
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
    /// Begins from a guess, with nothing known.
    #[inline(never)]
    pub(super) fn start(&mut self, guess: &Launch) {
        self.best.launch = *guess;
        self.best.launch.orientation = guess.orientation.normalised();
        self.damping = 1e-3;
        self.curvature = f64::INFINITY;
        self.restart();
    }

    /// Begins anew from the best launch, on another set of measurements.
    fn restart(&mut self) {
        self.best.cost = f64::INFINITY;
        self.last_change = None;
        let launch = self.best.launch;
        self.begin_pass(&launch);
    }

    #[inline(never)] // its matrices are on the stack between passes only
    fn begin_pass(&mut self, launch: &Launch) {
        let Pass { information, statistics, cost, .. } = &mut self.current;
        information.clear();
        *cost = match &self.prior {
            Some(prior) => prior.add_to(launch, information),
            None => self.model.add_prior(launch, information),
        };
        *statistics = Statistics { prior: *cost, ..Statistics::default() };
        self.current.launch = *launch;
        self.path.begin(&self.model.equations(launch), launch);
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
    /// * `settled`: size of a correction, in standard deviations, below which this is so
    #[inline(never)] // its copies would take more stack
    pub(super) fn settle<I>(&mut self, measurements: &I, part: Part, settled: f64) -> Progress
    where
        I: Iterator<Item = Measurement> + Clone,
    {
        self.restart();
        for _ in 0..MOST_PASSES {
            self.pass_over(measurements, part);
            match self.improve(settled) {
                Progress::Again => {}
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
        self.begin_pass(launch);
        self.pass_over(measurements, part);
    }

    #[inline(never)] // its measurement and prediction are on the stack during a pass only
    fn pass_over<I>(&mut self, measurements: &I, part: Part)
    where
        I: Iterator<Item = Measurement> + Clone,
    {
        let mut sums = Sums::default();
        let huber = F::from_f64(self.huber);
        for measurement in part.of(measurements.clone()) {
            if self.add(&measurement, huber, &mut sums).is_none() {
                self.current.cost = f64::INFINITY;
                return;
            }
        }
        self.current.cost += sums.cost.to_f64();
        self.current.statistics.chi_squared += sums.squares.to_f64();
        self.current.statistics.largest = sums.largest.to_f64();
        self.rows.add_to(&mut self.current.information);
    }

    /// Adds one measurement to the pass that is under way. `None` where its time cannot be reached.
    fn add(&mut self, measurement: &Measurement, huber: F, sums: &mut Sums<F>) -> Option<()> {
        let Measurement { time, sensor: index, mut values } = *measurement;
        let sensor = self.sensors.get(index)?;
        self.move_to(time)?;
        if let Some(unit) = self.rate_unit
            && matches!(sensor.hint(&values), Hint::Rate { .. })
        {
            values = values.map(|x| x * unit);
        }
        let prediction = sensor.predict(self.path.now(), &values);
        let bias = self.model.bias_of(index);
        let statistics = &mut self.current.statistics;
        let components = prediction.difference.into_iter().zip(prediction.deviation).enumerate();
        for (component, (difference, deviation)) in components {
            let per_deviation = F::ONE / deviation;
            if per_deviation == F::ZERO {
                statistics.unused += 1;
                continue;
            }
            let mut residual = difference * per_deviation;
            let bias = bias.map(|first| first + component);
            if let Some(known) = bias.and_then(|bias| self.biases.get(bias)) {
                residual = residual - *known * per_deviation;
            }
            let size = residual.abs();
            let outlier = size > huber;
            // square root of the weight
            let weight = if outlier { (huber / size).sqrt() } else { F::ONE };
            let limited = if outlier { huber } else { size };
            sums.cost.add(limited * (size.doubled() - limited));
            sums.squares.add(limited.squared());
            sums.largest = if size > sums.largest { size } else { sums.largest };
            statistics.used += 1;
            statistics.outliers += u32::from(outlier);
            let scale = weight * per_deviation;
            let Some(row) = self.rows.next(bias, scale, weight * residual) else { continue };
            let column = |k: usize| {
                let entry = prediction.columns.get(k).and_then(|column| column.get(component));
                scale * entry.copied().unwrap_or(F::ZERO)
            };
            self.model.fill(row, &self.shares, column);
        }
        Some(())
    }

    /// Computes the state and the derivatives at a time.
    fn move_to(&mut self, time: f64) -> Option<()> {
        // the same bits, which a chip without `f64` compares faster
        if self.now.map(f64::to_bits) == Some(time.to_bits()) {
            return Some(());
        }
        let epoch = *self.epoch.get_or_insert(time);
        let (model, launch) = (&self.model, &self.current.launch);
        self.path.move_to(time - epoch, || model.turns_in_period(launch))?;
        self.now = Some(time);
        Some(())
    }

    /// Corrects the launch after a pass.
    #[inline(never)] // its triangles are on the stack between passes only
    fn improve(&mut self, settled: f64) -> Progress {
        let previous = self.best.cost;
        let improved = self.current.cost <= previous && self.current.cost.is_finite();
        if !improved && self.current.cost - previous < ROUNDING {
            return Progress::Settled;
        }
        // a bad fit that hardly becomes better
        let Statistics { used, outliers, .. } = self.current.statistics;
        if improved && outliers > used / 5 + 10 && previous - self.current.cost < 1e-3 * previous {
            self.best = self.current;
            return Progress::Stuck;
        }
        if improved {
            self.best = self.current;
            self.damping *= 0.1;
        } else {
            self.damping = (10.0 * self.damping).max(1e-3);
            if self.damping > 1e9 || !self.best.cost.is_finite() {
                return Progress::Stuck;
            }
        }
        // the information of the current pass is not needed any more
        let (information, scratch) = (&self.best.information, &mut self.current.information);
        let deviations = self.model.damping(&self.best.launch, information, self.damping, 1000.0);
        scratch.clone_from(information);
        scratch.damp(&deviations);
        let change = scratch.solution();
        if change.iter().any(|x| !x.to_f64().is_finite()) {
            return Progress::Stuck;
        }
        let next = self.model.moved(&self.best.launch, &change);
        let size = information.size(&change).to_f64();
        let last_change = self.last_change.replace(size).filter(|_| improved);
        if let Some(last) = last_change {
            self.curvature = size / (last * last);
        }
        // near the vertical the derivatives themselves depend on the launch
        let [x, y, _] = next.orientation.axis();
        let near = x * x + y * y > LEAST_TILT * LEAST_TILT
            && size < MOST_UNCONFIRMED
            && self.curvature * size * size < NEXT_SETTLED;
        if size < settled || near {
            scratch.clear();
            Model::carry(information, &self.best.launch, &change, &next, scratch);
            self.best.information.clone_from(scratch);
            self.best.launch = next;
            // the correction lowers the sum of squares by this amount, as far as the equations are linear
            self.best.cost -= size * size;
            let statistics = &mut self.best.statistics;
            statistics.chi_squared = (statistics.chi_squared - size * size).max(0.0);
            return Progress::Settled;
        }
        self.begin_pass(&next);
        Progress::Again
    }

    /// Reason why the best launch must not be trusted.
    pub(super) fn reason(&self, progress: Progress) -> Option<Reason> {
        let statistics = &self.best.statistics;
        match progress {
            Progress::TooFew => Some(Reason::TooFew),
            Progress::NoBeginning => Some(Reason::NoBeginning),
            _ if statistics.used == 0 && statistics.unused > 0 => Some(Reason::AllSaturated),
            _ if statistics.used < 6 => Some(Reason::TooFew),
            _ if statistics.is_misfit(self.model.count, MISFIT, self.huber) => Some(Reason::Misfit),
            Progress::SpinUnknown => Some(Reason::SpinUnknown),
            Progress::Settled => None,
            Progress::Again | Progress::Stuck => Some(Reason::NotSettled),
        }
    }

    /// Directions that the measurements do not determine.
    #[inline(never)] // its matrices are on the stack without those of the result
    pub(super) fn unobservable(&self) -> Unobservable {
        self.model.unobservable(&self.best.launch, &self.best.information)
    }

    #[inline(never)] // its matrices are on the stack at the end only
    pub(super) fn fitted(
        &mut self,
        times: [f64; 2],
        reason: Option<Reason>,
        alternatives: usize,
        unobservable: Unobservable,
    ) -> Fitted {
        let Pass { launch, information, statistics, .. } = &self.best;
        let (launch, statistics) = (*launch, *statistics);
        // not larger, so that the covariance keeps the digits of what is determined
        let floor = self.model.damping(&launch, information, 0.0, 10.0);
        let [epoch, end] = times;
        let scratch = &mut self.current.information;
        scratch.clone_from(information);
        scratch.damp(&floor);
        let mut fitted = Fitted {
            epoch,
            launch,
            covariance: [[0.0; MOST_UNKNOWNS]; MOST_UNKNOWNS],
            statistics,
            unobservable,
            reason,
            alternatives,
            count: self.model.count,
            ratios: self.model.ratios(&launch),
            directions: self.model.directions(),
            drift: None,
        };
        scratch.covariance(&mut fitted.covariance);
        if self.model.has_losses() && self.carry_to_end(&mut fitted, end).is_none() {
            fitted.reason = fitted.reason.or(Some(Reason::NotSettled));
        }
        fitted
    }
}
