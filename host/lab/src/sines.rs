//! Errors of the core's sines of an integer phase over all 2^32 phases.
//!
//! The reference is the sine of `std` in `f64` of a phase that is reduced exactly in integers, without code of the core. Its error of 1e-16
//! is four million times smaller than the errors that are measured.

use fixed::types::{I2F14, I2F30};
use rayon::iter::{IntoParallelIterator, ParallelIterator};
use std::f64::consts::TAU;
use std::sync::Mutex;
use toytop::Phase;
use toytop::scalar::{Scalar, sine_cosine_q15, sine_cosine_q26, sine_cosine_q31};
use toytop_host::Failure;
use toytop_host::output::progress::Progress;
use toytop_host::thread_pool;

/// Unit of the errors, 2^-31.
pub(crate) const UNIT: f64 = 1.0 / (1_u64 << 31) as f64;

/// Routine that computes a sine and a cosine.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Routine {
    /// Name of the routine.
    pub name: &'static str,
    /// Use of the routine.
    pub what: &'static str,
    worst: fn(&[u32], &[[f64; 2]]) -> Worst,
}

/// All routines of the core except the one in `f64`, which has too many phases.
pub(crate) const ROUTINES: [Routine; 6] = [
    Routine {
        name: "q31",
        what: "integers of 32 bits",
        worst: |p, t| greatest(p, t, |phase| whole(sine_cosine_q31(phase), UNIT)),
    },
    Routine {
        name: "q26",
        what: "fewer terms, for f32",
        worst: |p, t| greatest(p, t, |phase| whole(sine_cosine_q26(phase), UNIT)),
    },
    Routine { name: "f32", what: "q31, as f32", worst: |p, t| greatest(p, t, scalar::<f32>) },
    Routine { name: "I2F30", what: "q31, with 30 bits", worst: |p, t| greatest(p, t, scalar::<I2F30>) },
    Routine {
        name: "q15",
        what: "by 16-bit products",
        worst: |p, t| greatest(p, t, |phase| whole(sine_cosine_q15(phase), 2.0 * UNIT)),
    },
    Routine { name: "I2F14", what: "q31, with 14 bits", worst: |p, t| greatest(p, t, scalar::<I2F14>) },
];

/// Greatest errors of a sine and a cosine, each with its phase in units of 2^-32 turns.
pub(crate) type Worst = [(f64, u32); 2];

fn whole((sine, cosine): (i32, i32), unit: f64) -> [f64; 2] {
    [sine, cosine].map(|x| f64::from(x) * unit)
}

fn scalar<R: Scalar + Into<f64>>(phase: u32) -> [f64; 2] {
    let (sine, cosine) = R::sine_cosine(Phase::from_bits(i128::from(phase) << 64));
    [sine, cosine].map(Into::into)
}

#[inline(always)]
fn greatest(phases: &[u32], truths: &[[f64; 2]], of: impl Fn(u32) -> [f64; 2]) -> Worst {
    let mut worst = [(0.0, 0); 2];
    for (&phase, truth) in phases.iter().zip(truths) {
        for ((worst, found), truth) in worst.iter_mut().zip(of(phase)).zip(truth) {
            let error = (found - truth).abs();
            if error > worst.0 {
                *worst = (error, phase);
            }
        }
    }
    worst
}

/// Sine and cosine of a phase in units of 2^-32 turns.
fn truth(phase: u32) -> [f64; 2] {
    let quarter = phase.wrapping_add(1 << 29) >> 30;
    let rest = phase.wrapping_sub(quarter << 30) as i32;
    let (sine, cosine) = (f64::from(rest) * (TAU / (1_u64 << 32) as f64)).sin_cos();
    match quarter {
        0 => [sine, cosine],
        1 => [cosine, -sine],
        2 => [-sine, -cosine],
        _ => [-cosine, sine],
    }
}

/// Number of phases in a block.
const BLOCK: u64 = 1 << 20;
const PART: usize = 1 << 12;

/// Greatest errors over every `every`-th phase, in the order of [`ROUTINES`].
///
/// # Errors
/// [`Failure::Output`]: the system cannot start the threads.
pub(crate) fn swept(every: u32) -> Result<[Worst; ROUTINES.len()], Failure> {
    let count = phases(every);
    let progress = Mutex::new(Progress::new(count, "phases"));
    let of_block = |block: u64| {
        let ends = [block * BLOCK, ((block + 1) * BLOCK).min(count)];
        let worst = of_range(ends, every);
        if let Ok(mut progress) = progress.lock() {
            progress.add(ends[1] - ends[0]);
        }
        worst
    };
    let blocks = (0..count.div_ceil(BLOCK)).into_par_iter();
    Ok(thread_pool::of_all_cores()?.install(|| blocks.map(of_block).reduce(nothing, greater)))
}

/// Number of phases at a distance of `every`.
#[must_use]
pub(crate) fn phases(every: u32) -> u64 {
    (1_u64 << 32).div_ceil(every.into())
}

fn of_range([from, to]: [u64; 2], every: u32) -> [Worst; ROUTINES.len()] {
    let mut worst = nothing();
    let (mut phases, mut truths) = (Vec::with_capacity(PART), Vec::with_capacity(PART));
    let mut at = from;
    while at < to {
        let next = to.min(at + PART as u64);
        phases.clear();
        phases.extend((at..next).map(|i| (i as u32).wrapping_mul(every)));
        truths.clear();
        truths.extend(phases.iter().map(|&phase| truth(phase)));
        worst = greater(worst, ROUTINES.map(|routine| (routine.worst)(&phases, &truths)));
        at = next;
    }
    worst
}

fn nothing() -> [Worst; ROUTINES.len()] {
    [[(0.0, 0); 2]; ROUTINES.len()]
}

/// Greater errors of two blocks. If two errors are equal, the one at the smaller phase is taken, so that the result does not depend on the
/// order of the blocks.
fn greater(a: [Worst; ROUTINES.len()], b: [Worst; ROUTINES.len()]) -> [Worst; ROUTINES.len()] {
    let of = |a: (f64, u32), b: (f64, u32)| {
        if b.0 > a.0 || (b.0 == a.0 && b.1 < a.1) { b } else { a }
    };
    std::array::from_fn(|routine| std::array::from_fn(|i| of(a[routine][i], b[routine][i])))
}
