//! Passes over the measurements, and the correction of the launch after each.

use crate::fit::Fit;
use crate::fit::launch::{LAUNCH, Launch};
use crate::fit::outcome::{Fitted, Reason, Statistics};
use crate::fit::sensor::{Hint, Measurement};
use crate::fit::triangle::{MOST_UNKNOWNS, Triangle, Unknowns};
use crate::sensitivity::{COLUMNS, Equations, Flow, Partials, advance};

/// Error of a step of the integration from one measurement to the next.
const TOLERANCE: f64 = 1e-9;
/// Largest number of steps between two measurements.
const MOST_STEPS: u32 = 500;
/// Size of a correction, in standard deviations, below which the fit has converged.
const SETTLED: f64 = 0.01;
/// Change of the sum of squares that may come from the error of the integration.
const ROUNDING: f64 = 0.05;
/// Passes that one window of measurements may take.
const MOST_PASSES: u32 = 30;
/// Standard deviations of the sum of squares beyond which the residuals are larger than the noise explains.
const MISFIT: f64 = 5.0;

/// One pass over the measurements.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pass {
    pub(super) launch: Launch,
    pub(super) information: Triangle,
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
}

impl Pass {
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

impl Fit<'_> {
    /// Begins from a guess, with nothing known.
    pub(super) fn start(&mut self, guess: Launch) {
        let launch = self.model.moved(&guess, &[0.0; MOST_UNKNOWNS]);
        self.best = Pass { launch, cost: f64::INFINITY, ..self.best };
        self.restart();
    }

    /// Begins anew from the best launch, on another set of measurements.
    fn restart(&mut self) {
        self.best.cost = f64::INFINITY;
        self.damping = 1e-3;
        self.begin_pass(self.best.launch);
    }

    fn begin_pass(&mut self, launch: Launch) {
        let (information, cost) = match &self.prior {
            Some(prior) => prior.information(&launch, self.model.count),
            None => self.model.prior(&launch),
        };
        self.current = Pass { information, cost, ..Pass::new(launch, self.model.count) };
        self.current.statistics.prior = cost;
        self.equations = self.model.equations(&launch);
        self.flow = None;
    }

    /// Passes over the measurements until the launch does not change any more.
    pub(super) fn settle<I>(&mut self, measurements: I) -> Progress
    where
        I: Iterator<Item = Measurement> + Clone,
    {
        self.restart();
        for _ in 0..MOST_PASSES {
            self.pass_over(measurements.clone());
            match self.improve() {
                Progress::Again => {}
                done => return done,
            }
        }
        Progress::Stuck
    }

    /// One pass over the measurements with a launch.
    pub(super) fn pass(&mut self, launch: Launch, measurements: impl Iterator<Item = Measurement>) {
        self.begin_pass(launch);
        self.pass_over(measurements);
    }

    fn pass_over(&mut self, measurements: impl Iterator<Item = Measurement>) {
        for measurement in measurements {
            self.add(&measurement);
            if !self.current.cost.is_finite() {
                return;
            }
        }
    }

    /// Adds one measurement to the pass that is under way.
    fn add(&mut self, measurement: &Measurement) {
        let Measurement { time, sensor: index, mut values } = *measurement;
        let Some(sensor) = self.sensors.get(index) else { return };
        let Some(partials) = self.partials_at(time) else {
            self.current.cost = f64::INFINITY;
            return;
        };
        if self.rate_unit != 1.0 && matches!(sensor.hint(&values), Hint::Rate { .. }) {
            values = values.map(|x| x * self.rate_unit);
        }
        let prediction = sensor.predict(&partials, &values);
        let bias = self.model.bias_of(index);
        for component in 0..3 {
            let [difference, deviation] = [prediction.difference, prediction.deviation]
                .map(|vector| vector.get(component).copied().unwrap_or(0.0));
            if !deviation.is_finite() {
                self.current.statistics.unused += 1;
                continue;
            }
            let mut row = [0.0; MOST_UNKNOWNS];
            let mut difference = difference;
            let column = |k: usize| {
                prediction.columns.get(k).and_then(|column| column.get(component)).copied().unwrap_or(0.0)
            };
            self.model.fill(&mut row, &self.current.launch, column);
            if let Some(place) = bias.map(|first| first + component)
                && let (Some(slot), Some(known)) = (row.get_mut(place), self.current.launch.rest.get(place))
            {
                *slot = 1.0;
                difference -= known;
            }
            self.weigh(&mut row, difference / deviation, 1.0 / deviation);
        }
    }

    /// Adds a row, with the weight that its residual allows.
    fn weigh(&mut self, row: &mut Unknowns, residual: f64, per_deviation: f64) {
        let size = libm::fabs(residual);
        let weight = if size > self.huber { libm::sqrt(self.huber / size) } else { 1.0 };
        for slot in row.iter_mut() {
            *slot *= weight * per_deviation;
        }
        let cost =
            if size > self.huber { self.huber * (2.0 * size - self.huber) } else { residual * residual };
        self.current.cost += cost;
        self.current.statistics.add(residual, self.huber);
        self.current.information.add(row, weight * residual);
    }

    /// State and derivatives at a time.
    fn partials_at(&mut self, time: f64) -> Option<Partials> {
        let next = match &self.flow {
            Some((last, partials)) if *last == time => return Some(*partials),
            Some((last, partials)) if self.model.has_free_ratios() => {
                carried(&self.equations, &partials.flow, time - last)?
            }
            Some((last, partials)) => {
                // the columns of the ratios are not needed
                let launch = partials.flow.resized::<LAUNCH>();
                carried(&self.equations, &launch, time - last)?.resized()
            }
            None => {
                let Launch { orientation, omega, .. } = self.current.launch;
                Flow::<f64, COLUMNS>::launched(&orientation, omega)
            }
        };
        let partials = Partials::new(&self.equations, next, self.model.tip_scale);
        self.flow = Some((time, partials));
        Some(partials)
    }

    /// Corrects the launch after a pass.
    fn improve(&mut self) -> Progress {
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
        let information = self.best.information;
        let deviations = self.model.damping(&self.best.launch, &information, self.damping, 1000.0);
        let change = information.damped(&deviations).solution();
        if change.iter().any(|x| !x.is_finite()) {
            return Progress::Stuck;
        }
        let next = self.model.moved(&self.best.launch, &change);
        if information.size(&change) < SETTLED {
            self.best.launch = next;
            return Progress::Settled;
        }
        self.begin_pass(next);
        Progress::Again
    }

    pub(super) fn fitted(&self, epoch: f64, progress: Progress) -> Fitted {
        let Pass { launch, information, statistics, .. } = self.best;
        let unobservable = self.model.unobservable(&launch, &information);
        let reason = if statistics.used == 0 && statistics.unused > 0 {
            Some(Reason::AllSaturated)
        } else if statistics.used < 6 {
            Some(Reason::TooFew)
        } else if statistics.is_misfit(self.model.count, MISFIT, self.huber) {
            Some(Reason::Misfit)
        } else if progress == Progress::SpinUnknown {
            Some(Reason::SpinUnknown)
        } else if progress != Progress::Settled {
            Some(Reason::NotSettled)
        } else {
            None
        };
        // not larger, so that the covariance keeps the digits of what is determined
        let floor = self.model.damping(&launch, &information, 0.0, 10.0);
        Fitted {
            epoch,
            launch,
            covariance: information.damped(&floor).covariance(),
            statistics,
            unobservable,
            reason,
            rivals: 0,
            count: self.model.count,
            ratios: self.model.ratios(&launch),
        }
    }
}

/// State and derivatives after a time.
pub(super) fn carried<const N: usize>(
    equations: &Equations<f64>,
    flow: &Flow<f64, N>,
    span: f64,
) -> Option<Flow<f64, N>> {
    advance(equations, flow, span, TOLERANCE, MOST_STEPS)
}
