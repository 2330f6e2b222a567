//! The same motion by the core and by other methods, at moments that each of them can reach exactly, against the truth to thirty
//! digits: what the work-precision diagram and the figure of errors are made of.

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

/// The paper's cusp (figure 3, e₃ = 1.85) with C = 0.6 A; s = A = p = g = 1.
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

/// Moments in a period, nearly.
pub const MOMENTS: u32 = 16;

/// Who takes part, and how hard it tries.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Method {
    /// The core's ephemeris in `f64`, at any tick.
    EphemerisF64,
    /// The core's ephemeris in `f32`.
    EphemerisF32,
    /// The core's stepper in `f64`; so many steps between moments, a power of two.
    StepperF64(u32),
    /// The core's stepper in `f32`.
    StepperF32(u32),
    /// The full equations, Verner's 9(8), with this tolerance.
    FullSolver(f64),
    /// The full equations by the classical method, so many steps between moments.
    RungeKutta(u32),
    /// The same from multicalc.
    Multicalc(u32),
    /// nalgebra's quaternions and their exponential.
    Exponential(u32),
}

impl Method {
    /// Its name; methods of one name are points of one curve.
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

    /// How hard it tries, in words.
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
            | Self::Exponential(steps) => format!("{} steps", steps * MOMENTS),
        }
    }
}

/// The motion, and the truth of it.
#[derive(Debug)]
pub struct Benchmark {
    scenario: Scenario,
    /// Between moments: of so few binary digits that every multiple, and every half and quarter, is exact.
    apart: f64,
}

/// Of [`Benchmark::apart`], as parts of a unit of time.
const GRAIN: f64 = 1024.0;

impl Benchmark {
    /// Of [`NUMBERS`].
    ///
    /// # Errors
    /// None: the motion is valid.
    pub fn new() -> Result<Self, Failure> {
        Self::with_moments(MOMENTS)
    }

    /// The same, with so many moments in a period.
    ///
    /// # Errors
    /// None: the motion is valid.
    pub fn with_moments(moments: u32) -> Result<Self, Failure> {
        let motion = NUMBERS.motion().map_err(|error| Failure::Input(format!("benchmark: {error}")))?;
        let period = motion.period_advance().map_or(1.0, |averages| averages.period);
        let apart = (period / f64::from(moments) * GRAIN).round() / GRAIN;
        Ok(Self {
            scenario: Scenario { name: "benchmark".to_owned(), motion, state: None, units: Units::None },
            apart,
        })
    }

    /// The motion.
    #[must_use]
    pub fn motion(&self) -> &Motion {
        &self.scenario.motion
    }

    /// The motion, for the full solver.
    #[must_use]
    pub fn scenario(&self) -> &Scenario {
        &self.scenario
    }

    /// Time between moments.
    #[must_use]
    pub fn apart(&self) -> f64 {
        self.apart
    }

    /// The same as a fraction: so many moments in so many units of time.
    #[must_use]
    pub fn rate(&self) -> [u32; 2] {
        [GRAIN as u32, (self.apart * GRAIN) as u32]
    }

    /// Time between moments, in units of the period.
    #[must_use]
    pub fn share(&self) -> f64 {
        self.apart / self.scenario.motion.period_advance().map_or(1.0, |averages| averages.period)
    }

    /// Φ at these moments, to the rounding of `f64`.
    #[must_use]
    pub fn truth(&self, moments: &[u64]) -> Vec<Orientation<f64>> {
        let exact = Exact::new(&NUMBERS);
        moments.iter().map(|&moment| exact.at(&precise(moment as f64 * self.apart)).to_f64()).collect()
    }

    /// Φ at these moments (rising), and how long it took; an ephemeris is set up before the clock starts.
    ///
    /// # Errors
    /// [`Failure::Method`]: the full solver gave up, or a table does not fit.
    pub fn run(&self, method: Method, moments: &[u64]) -> Result<(Vec<Orientation<f64>>, Duration), Failure> {
        match method {
            Method::EphemerisF64 => self.look_up::<f64, 48>(moments),
            Method::EphemerisF32 => self.look_up::<f32, 25>(moments),
            Method::StepperF64(steps) => Ok(self.step::<f64>(steps, moments)),
            Method::StepperF32(steps) => Ok(self.step::<f32>(steps, moments)),
            Method::FullSolver(tolerance) => self.solve(tolerance, moments),
            Method::RungeKutta(steps) => Ok(self.march::<RungeKutta>(steps, moments)),
            Method::Multicalc(steps) => Ok(self.march::<Multicalc>(steps, moments)),
            Method::Exponential(steps) => Ok(self.march::<Exponential>(steps, moments)),
        }
    }

    /// How far it is from the truth at each of the moments, rad, and how long it took.
    ///
    /// # Errors
    /// As [`Benchmark::run`].
    pub fn errors(
        &self,
        method: Method,
        moments: &[u64],
        truth: &[Orientation<f64>],
    ) -> Result<(Vec<f64>, Duration), Failure> {
        let (found, time) = self.run(method, moments)?;
        Ok((found.iter().zip(truth).map(|(found, truth)| found.distance(truth)).collect(), time))
    }

    fn look_up<R: Real + EphemerisScalar<Wide = R>, const SEGMENTS: usize>(
        &self,
        moments: &[u64],
    ) -> Result<(Vec<Orientation<f64>>, Duration), Failure> {
        // one tick a grain: the moments are whole ticks
        let tick =
            Tick::hertz(GRAIN as u32).map_err(|error| Failure::Input(format!("benchmark: {error}")))?;
        let table = Ephemeris::<R, SEGMENTS>::new(&self.scenario.motion, tick);
        let table = table.map_err(|error| Failure::Method(format!("benchmark: {error}")))?;
        let ticks = (self.apart * GRAIN) as i64;
        Ok(timed(|| {
            moments.iter().map(|&moment| table.at_tick(moment as i64 * ticks).orientation()).collect()
        }))
        .map(|(phis, time): (Vec<Orientation<R>>, Duration)| {
            (phis.into_iter().map(|phi| cast::orientation(phi, R::to_f64)).collect(), time)
        })
    }

    fn step<R: Real>(&self, steps: u32, moments: &[u64]) -> (Vec<Orientation<f64>>, Duration) {
        let mut stepper = Stepper::<R>::new(&self.scenario.motion);
        let step = R::from_f64(self.apart / f64::from(steps));
        follow(
            steps,
            moments,
            &mut stepper,
            |stepper| stepper.step(step),
            |stepper| cast::orientation(stepper.orientation(), R::to_f64),
        )
    }

    fn march<S: Scheme>(&self, steps: u32, moments: &[u64]) -> (Vec<Orientation<f64>>, Duration) {
        let (top, state) = solution::start(&self.scenario);
        let mut run = EqualSteps::<S>::new(&top, &state, self.apart / f64::from(steps));
        follow(steps, moments, &mut run, EqualSteps::step, |run| phi(&run.state()))
    }

    fn solve(&self, tolerance: f64, moments: &[u64]) -> Result<(Vec<Orientation<f64>>, Duration), Failure> {
        let (top, state) = solution::start(&self.scenario);
        let mut solver = FullSolver::new(top, state, tolerance);
        let reach = |&moment: &u64| {
            let state = solver.advance_to(moment as f64 * self.apart);
            state.map(|state| phi(&state)).map_err(|error| Failure::Method(format!("benchmark: {error}")))
        };
        let (phis, time) = timed(|| moments.iter().map(reach).collect::<Result<Vec<_>, _>>());
        Ok((phis?, time))
    }
}

/// Goes from moment to moment in steps.
fn follow<T>(
    steps: u32,
    moments: &[u64],
    state: &mut T,
    mut step: impl FnMut(&mut T),
    phi: impl Fn(&T) -> Orientation<f64>,
) -> (Vec<Orientation<f64>>, Duration) {
    let mut here = 0;
    let mut reach = |&moment: &u64| {
        (0..(moment - here) * u64::from(steps)).for_each(|_| step(state));
        here = moment;
        phi(state)
    };
    timed(|| moments.iter().map(&mut reach).collect())
}

fn timed<T>(task: impl FnOnce() -> T) -> (T, Duration) {
    let started = Instant::now();
    let result = black_box(task());
    (result, started.elapsed())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The errors after 20 periods are those of the methods: each method's lies in its own range.
    #[test]
    fn every_method_has_errors_in_its_own_range() {
        let benchmark = Benchmark::new().unwrap();
        let moments: Vec<u64> = (1..=20 * u64::from(MOMENTS)).collect();
        let truth = benchmark.truth(&moments);
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
            let (errors, _) = benchmark.errors(method, &moments, &truth).unwrap();
            let worst = errors.iter().copied().fold(0.0, f64::max);
            assert!(worst > least && worst < most, "{method:?}: {worst:e}");
        }
    }
}
