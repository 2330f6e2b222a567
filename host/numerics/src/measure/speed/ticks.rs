//! Time of one tick of each propagator.

use super::Row;
use super::timing::least;
use crate::Failure;
use crate::output::progress::Progress;
use std::hint::black_box;
use toytop::scalar::Real;
use toytop::{
    EphemerisF32, EphemerisF64, EphemerisScalar, EphemerisView, Motion, Orientation, Stepper, TableTooSmall,
    Tick,
};

/// Number of tasks that are timed here.
pub const TASKS: u64 = 8;

/// Ticks of a run: enough for the clock, and few enough for the cache.
const TICKS: u32 = 4096;
/// First tick of a run.
const FIRST: i64 = 1 << 40;

/// Rows of all propagators.
///
/// # Errors
/// [`Failure::Method`]: the motion needs a larger table, which a test excludes.
pub fn run(motion: &Motion, progress: &mut Progress) -> Result<Vec<Row>, Failure> {
    let tick = Tick::hertz(1000).map_err(|error| Failure::Input(format!("bench: {error}")))?;
    let no_fit = |error: TableTooSmall| Failure::Method(format!("bench: {error}"));
    let single = EphemerisF32::new(motion, tick).map_err(no_fit)?;
    let double = EphemerisF64::new(motion, tick).map_err(no_fit)?;
    let mut lines = Vec::new();
    lines.extend(ephemeris("f32", &single, progress));
    lines.extend(ephemeris("f64", &double, progress));
    lines.push(stepper::<f32>("f32", motion, progress));
    lines.push(stepper::<f64>("f64", motion, progress));
    Ok(lines)
}

fn per_tick(what: String, progress: &mut Progress, task: impl FnMut()) -> Row {
    let (whole, ()) = least(progress, task);
    let seconds = whole / f64::from(TICKS);
    Row { what, seconds, error: None, rest: vec![format!("{:.1}", 1e-6 / seconds)] }
}

fn ephemeris<R: EphemerisScalar>(
    name: &str,
    ephemeris: &EphemerisView<R>,
    progress: &mut Progress,
) -> [Row; 3] {
    let name = format!("{name}, {}x{}", ephemeris.capacity(), R::TERMS);
    let mut out = vec![Orientation::<R>::IDENTITY; TICKS as usize];
    let batch = per_tick(format!("ephemeris {name}: in a batch"), progress, || {
        ephemeris.fill(black_box(FIRST), &mut out);
        black_box(&mut out);
    });
    let next = per_tick(format!("ephemeris {name}: the next tick"), progress, || {
        let mut cursor = ephemeris.cursor(black_box(FIRST));
        for _ in 0..TICKS {
            black_box(cursor.next(ephemeris).orientation());
        }
    });
    let any = per_tick(format!("ephemeris {name}: any tick"), progress, || {
        for n in 0..TICKS {
            black_box(ephemeris.at_tick(black_box(FIRST + i64::from(n))).orientation());
        }
    });
    [batch, next, any]
}

fn stepper<R: Real>(name: &str, motion: &Motion, progress: &mut Progress) -> Row {
    let mut stepper = Stepper::<R>::new(motion);
    let dt = R::from_f64(1e-3);
    per_tick(format!("stepper {name}: a step"), progress, || {
        for _ in 0..TICKS {
            stepper.step(dt);
            black_box(stepper.orientation());
        }
    })
}
