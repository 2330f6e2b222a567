//! One motion by the core and by other methods, at times that each of them can reach exactly, against the truth to thirty digits. The
//! work-precision diagram and the figure of errors show the results.

use crate::Failure;
use crate::full_equations::baseline::{EqualSteps, Exponential, Multicalc, RungeKutta, Scheme};
use crate::full_equations::full_solver::FullSolver;
use crate::full_equations::solution::{self, phi};
use crate::input::scenario::{Scenario, Units};
use crate::motion::cast;
use crate::truth::exact::Exact;
use crate::truth::motions::Numbers;
use crate::truth::precise::precise;
use std::hint::black_box;
use std::time::{Duration, Instant};
use toytop::scalar::Real;
use toytop::{Ephemeris, EphemerisScalar, Motion, Orientation, Sign, Signs, Start, Stepper, Tick};

/// Motion of the paper's curve with cusps (figure 3, e₃ = 1.85) with C = 0.6 A; s = A = p = g = 1.
pub const NUMBERS: Numbers = Numbers {
    a: 1.0,
    c: 0.6,
    s: 1.0,
    p: 1.0,
    g: 1.0,
    e: [0.7, 0.9, 1.85],
    signs: Signs { l_plus_n: Sign::Plus, l_minus_n: Sign::Minus },
    start: Start { theta: 0.0, arg_alpha: 0.0, arg_beta: 0.0 },
};

/// Number of samples in a period, approximately.
pub const SAMPLES: u32 = 16;

/// Method with the parameter that determines its accuracy.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Method {
    /// Ephemeris of the core in `f64`.
    EphemerisF64,
    /// Ephemeris of the core in `f32`.
    EphemerisF32,
    /// Stepper of the core in `f64` with this number of steps between samples, a power of two.
    StepperF64(u32),
    /// Stepper of the core in `f32`, as [`Method::StepperF64`].
    StepperF32(u32),
    /// Full equations by Verner's 9(8) method with this tolerance.
    FullSolver(f64),
    /// Full equations by the classical Runge-Kutta method with this number of steps between samples.
    RungeKutta(u32),
    /// Runge-Kutta method of the crate multicalc with this number of steps between samples.
    Multicalc(u32),
    /// Exponential of nalgebra's quaternions with this number of steps between samples.
    Exponential(u32),
}

impl Method {
    /// Name; methods of one name are points of one curve.
    #[must_use]
    pub fn name(&self) -> &'static str {
        match self {
            Self::EphemerisF64 => "ephemeris f64",
            Self::EphemerisF32 => "ephemeris f32",
            Self::StepperF64(_) => "stepper f64",
            Self::StepperF32(_) => "stepper f32",
            Self::FullSolver(_) => "full solver, 9(8)",
            Self::RungeKutta(_) => "RK4",
            Self::Multicalc(_) => "RK4, multicalc",
            Self::Exponential(_) => "nalgebra, exponential",
        }
    }

    /// Tolerance or number of steps, as text.
    #[must_use]
    pub fn effort(&self) -> String {
        match self {
            Self::EphemerisF64 => "48x11".to_owned(),
            Self::EphemerisF32 => "25x5".to_owned(),
            Self::FullSolver(tolerance) => format!("tolerance {tolerance:.0e}"),
            Self::StepperF64(steps)
            | Self::StepperF32(steps)
            | Self::RungeKutta(steps)
            | Self::Multicalc(steps)
            | Self::Exponential(steps) => format!("{} steps", steps * SAMPLES),
        }
    }
}

/// Motion of the benchmark, with its exact solution.
#[derive(Debug)]
pub struct Benchmark {
    scenario: Scenario,
    /// Time between samples, with so few binary digits that every multiple, half and quarter of it is exact.
    apart: f64,
}

/// Number of parts of a unit of time, of which [`Benchmark::apart`] is a multiple.
const GRAIN: f64 = 1024.0;

impl Benchmark {
    /// Benchmark of [`NUMBERS`] with [`SAMPLES`] in a period.
    ///
    /// # Errors
    /// None: the motion is valid.
    pub fn new() -> Result<Self, Failure> {
        Self::with_samples(SAMPLES)
    }

    /// Benchmark of [`NUMBERS`] with this number of samples in a period, approximately.
    ///
    /// # Errors
    /// None: the motion is valid.
    pub fn with_samples(samples: u32) -> Result<Self, Failure> {
        let motion = NUMBERS.motion().map_err(|error| Failure::Input(format!("benchmark: {error}")))?;
        let period = motion.period_advance().map_or(1.0, |averages| averages.period);
        let apart = (period / f64::from(samples) * GRAIN).round() / GRAIN;
        Ok(Self {
            scenario: Scenario { name: "benchmark".to_owned(), motion, state: None, units: Units::None },
            apart,
        })
    }

    /// Motion of the benchmark.
    #[must_use]
    pub fn motion(&self) -> &Motion {
        &self.scenario.motion
    }

    /// Scenario of the motion, for the full solver.
    #[must_use]
    pub fn scenario(&self) -> &Scenario {
        &self.scenario
    }

    /// Time between samples.
    #[must_use]
    pub fn apart(&self) -> f64 {
        self.apart
    }

    /// Rate of the samples as a fraction: number of samples, and units of time in which they are.
    #[must_use]
    pub fn rate(&self) -> [u32; 2] {
        [GRAIN as u32, (self.apart * GRAIN) as u32]
    }

    /// Time between samples, in units of the period.
    #[must_use]
    pub fn share(&self) -> f64 {
        self.apart / self.scenario.motion.period_advance().map_or(1.0, |averages| averages.period)
    }

    /// Exact Φ at these samples, rounded to `f64`.
    #[must_use]
    pub fn truth(&self, samples: &[u64]) -> Vec<Orientation<f64>> {
        let exact = Exact::new(&NUMBERS);
        samples.iter().map(|&sample| exact.at(&precise(sample as f64 * self.apart)).to_f64()).collect()
    }

    /// Φ at these samples (in ascending order) by a method, and the computing time, without the set-up of an ephemeris.
    ///
    /// # Errors
    /// [`Failure::Method`]: the full solver gave up, or a table does not fit.
    pub fn run(&self, method: Method, samples: &[u64]) -> Result<(Vec<Orientation<f64>>, Duration), Failure> {
        match method {
            Method::EphemerisF64 => self.look_up::<f64, 48>(samples),
            Method::EphemerisF32 => self.look_up::<f32, 25>(samples),
            Method::StepperF64(steps) => Ok(self.step::<f64>(steps, samples)),
            Method::StepperF32(steps) => Ok(self.step::<f32>(steps, samples)),
            Method::FullSolver(tolerance) => self.solve(tolerance, samples),
            Method::RungeKutta(steps) => Ok(self.march::<RungeKutta>(steps, samples)),
            Method::Multicalc(steps) => Ok(self.march::<Multicalc>(steps, samples)),
            Method::Exponential(steps) => Ok(self.march::<Exponential>(steps, samples)),
        }
    }

    /// Errors of a method at each of these samples, rad, and its computing time.
    ///
    /// # Errors
    /// As [`Benchmark::run`].
    pub fn errors(
        &self,
        method: Method,
        samples: &[u64],
        truth: &[Orientation<f64>],
    ) -> Result<(Vec<f64>, Duration), Failure> {
        let (found, time) = self.run(method, samples)?;
        Ok((found.iter().zip(truth).map(|(found, truth)| found.distance(truth)).collect(), time))
    }

    fn look_up<R: Real + EphemerisScalar<Wide = R>, const SEGMENTS: usize>(
        &self,
        samples: &[u64],
    ) -> Result<(Vec<Orientation<f64>>, Duration), Failure> {
        // the samples are at whole ticks
        let tick =
            Tick::hertz(GRAIN as u32).map_err(|error| Failure::Input(format!("benchmark: {error}")))?;
        let table = Ephemeris::<R, SEGMENTS>::new(&self.scenario.motion, tick);
        let table = table.map_err(|error| Failure::Method(format!("benchmark: {error}")))?;
        let ticks = (self.apart * GRAIN) as i64;
        Ok(timed(|| {
            samples.iter().map(|&sample| table.at_tick(sample as i64 * ticks).orientation()).collect()
        }))
        .map(|(phis, time): (Vec<Orientation<R>>, Duration)| {
            (phis.into_iter().map(|phi| cast::orientation(phi, R::to_f64)).collect(), time)
        })
    }

    fn step<R: Real>(&self, steps: u32, samples: &[u64]) -> (Vec<Orientation<f64>>, Duration) {
        let mut stepper = Stepper::<R>::new(&self.scenario.motion);
        let step = R::from_f64(self.apart / f64::from(steps));
        follow(
            steps,
            samples,
            &mut stepper,
            |stepper| stepper.step(step),
            |stepper| cast::orientation(stepper.orientation(), R::to_f64),
        )
    }

    fn march<S: Scheme>(&self, steps: u32, samples: &[u64]) -> (Vec<Orientation<f64>>, Duration) {
        let (top, state) = solution::start(&self.scenario);
        let mut run = EqualSteps::<S>::new(&top, &state, self.apart / f64::from(steps));
        follow(steps, samples, &mut run, EqualSteps::step, |run| phi(&run.state()))
    }

    fn solve(&self, tolerance: f64, samples: &[u64]) -> Result<(Vec<Orientation<f64>>, Duration), Failure> {
        let (top, state) = solution::start(&self.scenario);
        let mut solver = FullSolver::new(top, state, tolerance);
        let reach = |&sample: &u64| {
            let state = solver.advance_to(sample as f64 * self.apart);
            state.map(|state| phi(&state)).map_err(|error| Failure::Method(format!("benchmark: {error}")))
        };
        let (phis, time) = timed(|| samples.iter().map(reach).collect::<Result<Vec<_>, _>>());
        Ok((phis?, time))
    }
}

/// Φ at these samples in steps, and the computing time.
fn follow<T>(
    steps: u32,
    samples: &[u64],
    state: &mut T,
    mut step: impl FnMut(&mut T),
    phi: impl Fn(&T) -> Orientation<f64>,
) -> (Vec<Orientation<f64>>, Duration) {
    let mut here = 0;
    let mut reach = |&sample: &u64| {
        (0..(sample - here) * u64::from(steps)).for_each(|_| step(state));
        here = sample;
        phi(state)
    };
    timed(|| samples.iter().map(&mut reach).collect())
}

fn timed<T>(task: impl FnOnce() -> T) -> (T, Duration) {
    let started = Instant::now();
    let result = black_box(task());
    (result, started.elapsed())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The error of each method after 20 periods lies in a range of its own.
    #[test]
    fn every_method_has_errors_in_its_own_range() {
        let benchmark = Benchmark::new().unwrap();
        let samples: Vec<u64> = (1..=20 * u64::from(SAMPLES)).collect();
        let truth = benchmark.truth(&samples);
        for (method, least, most) in [
            (Method::EphemerisF64, 1e-16, 3e-15),
            (Method::EphemerisF32, 1e-8, 5e-7),
            (Method::StepperF64(256), 3e-16, 1e-13),
            (Method::StepperF32(32), 1e-7, 1e-4),
            (Method::FullSolver(1e-15), 1e-15, 1e-11),
            (Method::RungeKutta(16), 1e-8, 1e-3),
            (Method::Multicalc(16), 1e-8, 1e-3),
            (Method::Exponential(16), 1e-4, 1.0),
        ] {
            let (errors, _) = benchmark.errors(method, &samples, &truth).unwrap();
            let worst = errors.iter().copied().fold(0.0, f64::max);
            assert!(worst > least && worst < most, "{method:?}: {worst:e}");
        }
    }
}
