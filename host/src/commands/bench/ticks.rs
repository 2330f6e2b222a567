//! One tick of each propagator.

use super::Line;
use super::timing::least;
use crate::Failure;
use crate::progress::Progress;
use std::hint::black_box;
use toytop::real::Real;
use toytop::{Ephemeris, EphemerisF32, EphemerisF64, Motion, NoFit, Phi, Stepper, Tabular, Tick};

/// What is timed here.
pub(super) const TASKS: u64 = 8;

/// Ticks of a run: enough to time, few enough to stay in the cache.
const TICKS: u32 = 4096;
/// The first of them.
const FIRST: i64 = 1 << 40;

pub(super) fn run(motion: &Motion, progress: &mut Progress) -> Result<Vec<Line>, Failure> {
    let tick = Tick::hertz(1000).map_err(|error| Failure::Input(format!("bench: {error}")))?;
    let no_fit = |error: NoFit| Failure::Method(format!("bench: {error}"));
    let single = EphemerisF32::new(motion, tick).map_err(no_fit)?;
    let double = EphemerisF64::new(motion, tick).map_err(no_fit)?;
    let mut lines = Vec::new();
    lines.extend(ephemeris("f32", &single, progress));
    lines.extend(ephemeris("f64", &double, progress));
    lines.push(stepper::<f32>("f32", motion, progress));
    lines.push(stepper::<f64>("f64", motion, progress));
    Ok(lines)
}

fn per_tick(what: String, progress: &mut Progress, task: impl FnMut()) -> Line {
    let (whole, ()) = least(progress, task);
    let seconds = whole / f64::from(TICKS);
    Line { what, seconds, error: None, rest: vec![format!("{:.1}", 1e-6 / seconds)] }
}

fn ephemeris<R: Tabular, const SEGMENTS: usize, const TERMS: usize>(
    name: &str,
    ephemeris: &Ephemeris<R, SEGMENTS, TERMS>,
    progress: &mut Progress,
) -> [Line; 3] {
    let name = format!("{name}, {SEGMENTS}x{TERMS}");
    let mut out = vec![Phi::<R>::IDENTITY; TICKS as usize];
    let batch = per_tick(format!("ephemeris {name}: in a batch"), progress, || {
        ephemeris.fill(black_box(FIRST), &mut out);
        black_box(&mut out);
    });
    let next = per_tick(format!("ephemeris {name}: the next tick"), progress, || {
        let mut cursor = ephemeris.cursor(black_box(FIRST));
        for _ in 0..TICKS {
            black_box(cursor.next().phi());
        }
    });
    let any = per_tick(format!("ephemeris {name}: any tick"), progress, || {
        for n in 0..TICKS {
            black_box(ephemeris.at_tick(black_box(FIRST + i64::from(n))).phi());
        }
    });
    [batch, next, any]
}

fn stepper<R: Real>(name: &str, motion: &Motion, progress: &mut Progress) -> Line {
    let mut stepper = Stepper::<R>::new(motion);
    let dt = R::from_f64(1e-3);
    per_tick(format!("stepper {name}: a step"), progress, || {
        for _ in 0..TICKS {
            stepper.step(dt);
            black_box(stepper.phi());
        }
    })
}
