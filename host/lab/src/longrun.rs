//! Long runs: steppers and cursors tick by tick over millions of periods, compared with the truth to thirty digits after each power of ten
//! of ticks, and after a run forward and back; and the full solver, also against itself.

use fixed::types::I2F30;
use rayon::iter::{IntoParallelRefIterator, ParallelIterator};
use std::hint::black_box;
use std::sync::Mutex;
use toytop::scalar::Real;
use toytop::{Cursor, Ephemeris, EphemerisScalar, ErrorBound, Motion, Orientation, Stepper, Tick};
use toytop_host::Failure;
use toytop_host::full_equations::full_solver::{FULL_SOLVER_TOLERANCE, FullSolver};
use toytop_host::full_equations::solution::{self, phi};
use toytop_host::measure::benchmark::Benchmark;
use toytop_host::motion::cast;
use toytop_host::output::progress::Progress;

/// Method of a long run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Method {
    StepperF64,
    StepperF32,
    CursorF64,
    CursorF32,
    CursorQ31,
}

const METHODS: [(&str, Method); 5] = [
    ("stepper f64", Method::StepperF64),
    ("stepper f32", Method::StepperF32),
    ("ephemeris cursor f64", Method::CursorF64),
    ("ephemeris cursor f32", Method::CursorF32),
    ("ephemeris cursor q31", Method::CursorQ31),
];

/// Number of ticks in a period, approximately.
pub(crate) const TICKS_PER_PERIOD: u32 = 1024;

/// First power of ten at which errors are computed.
const FIRST: u64 = 1000;
/// Number of ticks forward, and of ticks back.
const THERE: u64 = 1_000_000;
/// Tolerances of the full solver.
const TOLERANCES: [f64; 2] = [FULL_SOLVER_TOLERANCE, 1e-13];
/// Number of ticks of the full solver, whose limit on evaluations is reached after some thirty thousand periods.
const FURTHEST_SOLVED: u64 = 10_000_000;

/// Row of the result.
#[derive(Clone, Debug)]
pub(crate) struct Row {
    /// Method and reference.
    pub name: String,
    /// Numbers of ticks, each with the error after them, rad.
    pub errors: Vec<(u64, f64)>,
    /// Error after 10^6 ticks forward and 10^6 ticks back, rad.
    pub back: Option<f64>,
    /// Greatest quotient of an error and the bound that the method states.
    pub of_bound: Option<f64>,
}

/// Results of one method.
struct Followed {
    /// Orientations Φ after each number of ticks.
    phi: Vec<Orientation<f64>>,
    back: Option<f64>,
    bound: Option<ErrorBound>,
}

/// Powers of ten from 10^3 to `ticks`, and `ticks` itself.
#[must_use]
pub(crate) fn decades(ticks: u64) -> Vec<u64> {
    let powers = std::iter::successors(Some(FIRST), |power| power.checked_mul(10));
    let mut decades: Vec<_> = powers.take_while(|power| *power < ticks).collect();
    decades.push(ticks);
    decades
}

/// Rows of all methods.
///
/// # Errors
/// [`Failure::Method`]: the full solver failed, which is not expected.
pub(crate) fn run(ticks: u64) -> Result<Vec<Row>, Failure> {
    let benchmark = Benchmark::with_samples(TICKS_PER_PERIOD)?;
    let decades = decades(ticks);
    let truth = benchmark.truth(&decades);
    let progress = Mutex::new(Progress::new(METHODS.len() as u64 * ticks, "ticks"));
    let line = |(name, method): &(&str, Method)| {
        let track = Track { benchmark: &benchmark, decades: &decades, progress: &progress };
        let Followed { phi, back, bound } = track.run(*method)?;
        let errors = phi.iter().zip(&truth).map(|(found, truth)| found.distance(truth));
        let errors: Vec<_> = decades.iter().copied().zip(errors).collect();
        let of_bound = bound.map(|bound| {
            // an error that is no number exceeds every bound
            let share = |(tick, error): &(u64, f64)| {
                if error.is_nan() { f64::INFINITY } else { error / bound.after(*tick as f64) }
            };
            errors.iter().map(share).fold(0.0, f64::max)
        });
        Ok(Row { name: format!("{name}, against the truth"), errors, back, of_bound })
    };
    let mut lines = METHODS.par_iter().map(line).collect::<Result<Vec<_>, Failure>>()?;
    drop(progress);
    lines.extend(full_solvers(&benchmark, &decades, &truth)?);
    Ok(lines)
}

/// Run of one method.
struct Track<'a> {
    benchmark: &'a Benchmark,
    decades: &'a [u64],
    progress: &'a Mutex<Progress>,
}

impl Track<'_> {
    fn run(&self, method: Method) -> Result<Followed, Failure> {
        match method {
            Method::StepperF64 => Ok(self.step::<f64>()),
            Method::StepperF32 => Ok(self.step::<f32>()),
            Method::CursorF64 => self.look_up::<f64, 48>(f64::from),
            Method::CursorF32 => self.look_up::<f32, 25>(f64::from),
            Method::CursorQ31 => self.look_up::<I2F30, 64>(f64::from),
        }
    }

    fn motion(&self) -> &Motion {
        self.benchmark.motion()
    }

    fn tick(&self) -> Result<Tick, Failure> {
        let [ticks, seconds] = self.benchmark.rate();
        Tick::ratio(ticks, seconds).map_err(|error| Failure::Method(error.to_string()))
    }

    fn step<R: Real>(&self) -> Followed {
        let (start, dt) = (Stepper::<R>::new(self.motion()), R::from_f64(self.benchmark.apart()));
        let widen = |stepper: &Stepper<R>| cast::orientation(stepper.orientation(), R::to_f64);
        let mut there = start;
        (0..THERE).for_each(|_| there.step(dt));
        (0..THERE).for_each(|_| there.step(-dt));
        let back = widen(&there).distance(&widen(&start));
        Followed { phi: self.follow(start, |stepper| stepper.step(dt), widen), back: Some(back), bound: None }
    }

    fn look_up<R: EphemerisScalar, const SEGMENTS: usize>(
        &self,
        widen: fn(R) -> f64,
    ) -> Result<Followed, Failure> {
        let table = Ephemeris::<R, SEGMENTS>::new(self.motion(), self.tick()?);
        let table = table.map_err(|error| Failure::Method(error.to_string()))?;
        let step = |cursor: &mut Cursor| {
            black_box(cursor.next(&table).orientation());
        };
        // the next sample of the cursor is that of the next tick
        let phi = self.follow(table.cursor(0), step, |cursor| {
            cast::orientation(cursor.clone().next(&table).orientation(), widen)
        });
        Ok(Followed { phi, back: None, bound: Some(table.error_bound()) })
    }

    fn follow<T>(
        &self,
        mut state: T,
        step: impl Fn(&mut T),
        phi: impl Fn(&T) -> Orientation<f64>,
    ) -> Vec<Orientation<f64>> {
        const BATCH: u64 = 1 << 20;
        let mut here = 0;
        let mut reach = |&tick: &u64| {
            while here < tick {
                let batch = BATCH.min(tick - here);
                (0..batch).for_each(|_| step(&mut state));
                here += batch;
                if let Ok(mut progress) = self.progress.lock() {
                    progress.add(batch);
                }
            }
            phi(&state)
        };
        self.decades.iter().map(&mut reach).collect()
    }
}

/// Rows of the full solver at two tolerances: each against the truth, and one against the other.
fn full_solvers(
    benchmark: &Benchmark,
    decades: &[u64],
    truth: &[Orientation<f64>],
) -> Result<Vec<Row>, Failure> {
    let decades: Vec<_> = decades.iter().copied().filter(|tick| *tick <= FURTHEST_SOLVED).collect();
    let follow = |tolerance: f64| -> Result<Vec<Orientation<f64>>, Failure> {
        let (top, state) = solution::start(benchmark.scenario());
        let mut solver = FullSolver::new(top, state, tolerance);
        let reach = |&tick: &u64| {
            let state = solver.advance_to(tick as f64 * benchmark.apart());
            state.map(|state| phi(&state)).map_err(|error| Failure::Method(error.to_string()))
        };
        decades.iter().map(reach).collect()
    };
    let [fine, coarse] = [follow(TOLERANCES[0])?, follow(TOLERANCES[1])?];
    let line = |name: String, a: &[Orientation<f64>], b: &[Orientation<f64>]| {
        let errors = a.iter().zip(b).map(|(a, b)| a.distance(b));
        Row { name, errors: decades.iter().copied().zip(errors).collect(), back: None, of_bound: None }
    };
    let [fine_name, coarse_name] = TOLERANCES.map(|tolerance| format!("full solver at {tolerance:.0e}"));
    Ok(vec![
        line(format!("{fine_name}, against the truth"), &fine, truth),
        line(format!("{coarse_name}, against the truth"), &coarse, truth),
        line(format!("{fine_name}, against itself at {:.0e}", TOLERANCES[1]), &fine, &coarse),
    ])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn decades_end_where_the_run_ends() {
        assert_eq!(decades(1000), [1000]);
        assert_eq!(decades(100_000), [1000, 10_000, 100_000]);
        assert_eq!(decades(2500), [1000, 2500]);
    }

    /// The error of each method lies in its own range. That of a run without steps, or against a wrong truth, would not.
    #[test]
    fn a_short_run() {
        let lines = run(10_000).unwrap();
        let ranges = [
            (1e-14, 1e-10),
            (1e-6, 1e-3),
            (1e-17, 3e-15),
            (1e-9, 5e-7),
            (1e-11, 3e-8),
            (1e-16, 1e-12),
            (1e-16, 1e-9),
            (1e-17, 1e-9),
        ];
        assert_eq!(lines.len(), ranges.len());
        for (Row { name, errors, back, of_bound }, (least, most)) in lines.iter().zip(ranges) {
            let (ticks, last) = errors[1];
            assert_eq!((ticks, errors.len()), (10_000, 2), "{name}");
            assert!(last > least && last < most, "{name}: {last:e}");
            assert_eq!(back.is_some(), name.contains("stepper"), "{name}");
            assert_eq!(of_bound.is_some(), name.contains("cursor"), "{name}");
            assert!(of_bound.is_none_or(|share| share > 0.003 && share <= 1.0), "{name}: {of_bound:?}");
        }
    }
}
