//! Long runs: steppers and cursors tick by tick over millions of periods, against the truth to thirty digits at the powers of
//! ten; there and back; and the full solver against itself.

use crate::Failure;
use crate::full_solver::{FULL_SOLVER_TOLERANCE, FullSolver};
use crate::progress::Progress;
use crate::race::Race;
use crate::truth::{self, distance, phi};
use fixed::types::I2F30;
use rayon::iter::{IntoParallelRefIterator, ParallelIterator};
use std::hint::black_box;
use std::sync::Mutex;
use toytop::real::Real;
use toytop::{Complex, Cursor, Ephemeris, ErrorBound, FixedStepper, Motion, Phi, Stepper, Tabular, Tick};

/// Who runs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Runner {
    StepperF64,
    StepperF32,
    FixedStepper,
    CursorF64,
    CursorF32,
    CursorQ31,
}

const RUNNERS: [(&str, Runner); 6] = [
    ("stepper f64", Runner::StepperF64),
    ("stepper f32", Runner::StepperF32),
    ("fixed-point stepper", Runner::FixedStepper),
    ("ephemeris cursor f64", Runner::CursorF64),
    ("ephemeris cursor f32", Runner::CursorF32),
    ("ephemeris cursor q31", Runner::CursorQ31),
];

/// Ticks in a period, nearly.
pub const TICKS_PER_PERIOD: u32 = 1024;

/// The first power of ten that is looked at.
const FIRST: u64 = 1000;
/// Ticks forward, and as many back.
const THERE: u64 = 1_000_000;
/// The full solver's tolerances, and how far it is followed, ticks: its budget is some thirty thousand periods.
const TOLERANCES: [f64; 2] = [FULL_SOLVER_TOLERANCE, 1e-13];
const FURTHEST_SOLVED: u64 = 10_000_000;

/// One line of the result.
#[derive(Clone, Debug)]
pub struct Line {
    /// Who, against what.
    pub who: String,
    /// Ticks, and the error after them, rad.
    pub errors: Vec<(u64, f64)>,
    /// What is left after 10^6 ticks forward and as many back, rad.
    pub back: Option<f64>,
    /// The greatest error as a share of the bound that the runner states.
    pub of_bound: Option<f64>,
}

/// Where a runner came to.
struct Way {
    /// Φ at the decades.
    phi: Vec<Phi<f64>>,
    back: Option<f64>,
    bound: Option<ErrorBound>,
}

/// The powers of ten from 10^3 to `ticks`, and `ticks` itself.
#[must_use]
pub fn decades(ticks: u64) -> Vec<u64> {
    let powers = std::iter::successors(Some(FIRST), |power| power.checked_mul(10));
    let mut decades: Vec<_> = powers.take_while(|power| *power < ticks).collect();
    decades.push(ticks);
    decades
}

/// Runs all.
///
/// # Errors
/// [`Failure::Method`]: the full solver gave up, which it should not.
pub fn run(ticks: u64) -> Result<Vec<Line>, Failure> {
    let race = Race::with_moments(TICKS_PER_PERIOD)?;
    let decades = decades(ticks);
    let truth = race.truth(&decades);
    let progress = Mutex::new(Progress::new(RUNNERS.len() as u64 * ticks, "ticks"));
    let line = |(who, runner): &(&str, Runner)| {
        let track = Track { race: &race, decades: &decades, progress: &progress };
        let Way { phi, back, bound } = track.run(*runner)?;
        let errors = phi.iter().zip(&truth).map(|(found, truth)| distance(found, truth));
        let errors: Vec<_> = decades.iter().copied().zip(errors).collect();
        let of_bound = bound.map(|bound| {
            // what is no number is beyond every bound
            let share = |(tick, error): &(u64, f64)| {
                if error.is_nan() { f64::INFINITY } else { error / bound.after(*tick as f64) }
            };
            errors.iter().map(share).fold(0.0, f64::max)
        });
        Ok(Line { who: format!("{who}, against the truth"), errors, back, of_bound })
    };
    let mut lines = RUNNERS.par_iter().map(line).collect::<Result<Vec<_>, Failure>>()?;
    drop(progress);
    lines.extend(full_solvers(&race, &decades, &truth)?);
    Ok(lines)
}

/// One runner's way.
struct Track<'a> {
    race: &'a Race,
    decades: &'a [u64],
    progress: &'a Mutex<Progress>,
}

impl Track<'_> {
    fn run(&self, runner: Runner) -> Result<Way, Failure> {
        match runner {
            Runner::StepperF64 => Ok(self.step::<f64>()),
            Runner::StepperF32 => Ok(self.step::<f32>()),
            Runner::FixedStepper => self.step_fixed(),
            Runner::CursorF64 => self.look_up::<f64, 48, 11>(f64::from),
            Runner::CursorF32 => self.look_up::<f32, 25, 5>(f64::from),
            Runner::CursorQ31 => self.look_up::<I2F30, 32, 6>(f64::from),
        }
    }

    fn motion(&self) -> &Motion {
        self.race.motion()
    }

    fn tick(&self) -> Result<Tick, Failure> {
        let [ticks, seconds] = self.race.rate();
        Tick::ratio(ticks, seconds).map_err(|error| Failure::Method(error.to_string()))
    }

    fn step<R: Real>(&self) -> Way {
        let (start, dt) = (Stepper::<R>::new(self.motion()), R::from_f64(self.race.apart()));
        let widen = |stepper: &Stepper<R>| widened(stepper.phi(), R::to_f64);
        let mut there = start;
        (0..THERE).for_each(|_| there.step(dt));
        (0..THERE).for_each(|_| there.step(-dt));
        let back = distance(&widen(&there), &widen(&start));
        Way { phi: self.follow(start, |stepper| stepper.step(dt), widen), back: Some(back), bound: None }
    }

    fn step_fixed(&self) -> Result<Way, Failure> {
        let start = <FixedStepper>::new(self.motion(), self.tick()?);
        let start = start.map_err(|error| Failure::Method(error.to_string()))?;
        let widen = |stepper: &FixedStepper| widened(stepper.phi(), f64::from);
        let mut there = start;
        (0..THERE).for_each(|_| there.step());
        (0..THERE).for_each(|_| there.step_back());
        let back = distance(&widen(&there), &widen(&start));
        let phi = self.follow(start, FixedStepper::step, widen);
        Ok(Way { phi, back: Some(back), bound: Some(start.error_bound()) })
    }

    fn look_up<R: Tabular, const SEGMENTS: usize, const TERMS: usize>(
        &self,
        widen: fn(R) -> f64,
    ) -> Result<Way, Failure> {
        let table = Ephemeris::<R, SEGMENTS, TERMS>::new(self.motion(), self.tick()?);
        let table = table.map_err(|error| Failure::Method(error.to_string()))?;
        let step = |cursor: &mut Cursor<'_, R, SEGMENTS, TERMS>| {
            black_box(cursor.next().phi());
        };
        // the cursor stands before the tick that it has counted to
        let phi = self.follow(table.cursor(0), step, |cursor| widened(cursor.clone().next().phi(), widen));
        Ok(Way { phi, back: None, bound: Some(table.error_bound()) })
    }

    fn follow<T>(
        &self,
        mut traveller: T,
        step: impl Fn(&mut T),
        phi: impl Fn(&T) -> Phi<f64>,
    ) -> Vec<Phi<f64>> {
        const BATCH: u64 = 1 << 20;
        let mut here = 0;
        let mut reach = |&tick: &u64| {
            while here < tick {
                let batch = BATCH.min(tick - here);
                (0..batch).for_each(|_| step(&mut traveller));
                here += batch;
                if let Ok(mut progress) = self.progress.lock() {
                    progress.add(batch);
                }
            }
            phi(&traveller)
        };
        self.decades.iter().map(&mut reach).collect()
    }
}

fn widened<R: Copy>(phi: Phi<R>, widen: impl Fn(R) -> f64) -> Phi<f64> {
    let complex = |z: Complex<R>| Complex { re: widen(z.re), im: widen(z.im) };
    Phi { alpha: complex(phi.alpha), beta: complex(phi.beta) }
}

/// At two tolerances: each against the truth, and one against the other.
fn full_solvers(race: &Race, decades: &[u64], truth: &[Phi<f64>]) -> Result<Vec<Line>, Failure> {
    let decades: Vec<_> = decades.iter().copied().filter(|tick| *tick <= FURTHEST_SOLVED).collect();
    let follow = |tolerance: f64| -> Result<Vec<Phi<f64>>, Failure> {
        let (top, state) = truth::start(race.scenario());
        let mut solver = FullSolver::new(top, state, tolerance);
        let reach = |&tick: &u64| {
            let state = solver.advance_to(tick as f64 * race.apart());
            state.map(|state| phi(&state)).map_err(|error| Failure::Method(error.to_string()))
        };
        decades.iter().map(reach).collect()
    };
    let [fine, coarse] = [follow(TOLERANCES[0])?, follow(TOLERANCES[1])?];
    let line = |who: String, a: &[Phi<f64>], b: &[Phi<f64>]| {
        let errors = a.iter().zip(b).map(|(a, b)| distance(a, b));
        Line { who, errors: decades.iter().copied().zip(errors).collect(), back: None, of_bound: None }
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

    /// Each runner's error lies in its own range: a run that did not step, or a truth that is not one, would not.
    #[test]
    fn a_short_run() {
        let lines = run(10_000).unwrap();
        let ranges = [
            (1e-14, 1e-10),
            (1e-6, 1e-3),
            (1e-10, 1e-7),
            (1e-17, 3e-15),
            (1e-9, 5e-7),
            (1e-11, 3e-8),
            (1e-16, 1e-12),
            (1e-16, 1e-9),
            (1e-17, 1e-9),
        ];
        assert_eq!(lines.len(), ranges.len());
        for (Line { who, errors, back, of_bound }, (least, most)) in lines.iter().zip(ranges) {
            let (ticks, last) = errors[1];
            assert_eq!((ticks, errors.len()), (10_000, 2), "{who}");
            assert!(last > least && last < most, "{who}: {last:e}");
            assert_eq!(back.is_some(), who.contains("stepper"), "{who}");
            let stated = who.contains("cursor") || who.contains("fixed-point");
            assert_eq!(of_bound.is_some(), stated, "{who}");
            assert!(of_bound.is_none_or(|share| share > 0.01 && share <= 1.0), "{who}: {of_bound:?}");
        }
    }
}
