//! Time of a task as the least of several runs, because other processes can only make a run longer.

use crate::output::progress::Progress;
use std::time::Instant;

/// Number of runs of a task.
pub const RUNS: u32 = 9;

/// Least time of several runs, s, and the result of the last run.
pub fn least<T>(progress: &mut Progress, mut task: impl FnMut() -> T) -> (f64, T) {
    let mut timed = || {
        let started = Instant::now();
        let result = std::hint::black_box(task());
        (started.elapsed().as_secs_f64(), result)
    };
    let first = timed();
    let best = (1..RUNS).map(|_| timed()).fold(first, |best, run| (best.0.min(run.0), run.1));
    progress.add(1);
    best
}

/// Time of a long task, s, as the sum of the least times of its parts, because other processes would interrupt every run of the whole task.
/// `start` begins a run, `go_on` does one part of it.
pub fn least_in_parts<S>(
    progress: &mut Progress,
    parts: usize,
    start: impl Fn() -> S,
    mut go_on: impl FnMut(&mut S, usize),
) -> f64 {
    let mut best = vec![f64::INFINITY; parts];
    for _ in 0..RUNS {
        let mut state = std::hint::black_box(start());
        for (part, best) in best.iter_mut().enumerate() {
            let started = Instant::now();
            go_on(&mut state, part);
            *best = best.min(started.elapsed().as_secs_f64());
        }
        std::hint::black_box(state);
    }
    progress.add(1);
    best.iter().sum()
}

/// Time as text: three digits and a unit.
pub fn in_words(seconds: f64) -> String {
    let (scale, unit) = match seconds {
        x if x < 1e-6 => (1e9, "ns"),
        x if x < 1e-3 => (1e6, "µs"),
        x if x < 1.0 => (1e3, "ms"),
        _ => (1.0, "s"),
    };
    let value = scale * seconds;
    let digits = if value < 10.0 { 2 } else { usize::from(value < 100.0) };
    format!("{value:.digits$} {unit}")
}
