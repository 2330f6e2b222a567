//! Fixed point for random motions at random ticks, in arithmetic that detects overflows.
//!
//! In a build with overflow checks every sum, difference, product and shift of the core panics if it overflows. Such checks do not detect
//! bits that a conversion or a shift drops. Therefore the result is also compared with the table in `f64`, within the bounds of both.

use std::fmt::Write as _;
use std::hint::black_box;
use std::panic::{self, AssertUnwindSafe};
use toytop::Motion;
use toytop::scalar::Scalar as _;
use toytop_host::cli::Scalar;
use toytop_host::input::random::Random;
use toytop_host::motion::ephemeris::smallest;
use toytop_host::truth::motions::Numbers;

/// Counts and greatest errors of all trials.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Tally {
    /// Number of motions, of every regime.
    pub motions: u64,
    /// Number of refused tables, which are no failures.
    pub refused: u64,
    /// Number of ticks that were evaluated in 32 and in 16 bits.
    pub ticks: u64,
    /// Greatest error as a share of its stated bound, of the ephemeris in 32 and in 16 bits.
    pub of_bound: [f64; 2],
    /// Panics and errors beyond their bounds, with the numbers of the motion.
    pub failures: Vec<String>,
}

impl Tally {
    /// Sum of two tallies.
    #[must_use]
    pub fn and(mut self, other: Self) -> Self {
        self.motions += other.motions;
        self.refused += other.refused;
        self.ticks += other.ticks;
        self.of_bound
            .iter_mut()
            .zip(other.of_bound)
            .for_each(|(of_bound, other)| *of_bound = of_bound.max(other));
        self.failures.extend(other.failures);
        self
    }
}

/// Whether an overflow panics in this build.
#[must_use]
pub fn is_checked() -> bool {
    let loud = panic::take_hook();
    panic::set_hook(Box::new(|_| {}));
    let checked = panic::catch_unwind(|| black_box(i32::MAX) + black_box(1)).is_err();
    panic::set_hook(loud);
    checked
}

/// Result for a random motion at this many random ticks in each scalar.
#[must_use]
pub fn tried(seed: u64, stream: u64, ticks: u32) -> Tally {
    let mut random = Random::new(seed, stream);
    let numbers = Numbers::random(&mut random);
    let mut tally = Tally { motions: 1, ..Tally::default() };
    let Ok(motion) = numbers.motion() else {
        tally.failures.push(format!("refused: {numbers}"));
        return tally;
    };
    let mut said = String::new();
    let run = panic::catch_unwind(AssertUnwindSafe(|| {
        look_up(&motion, &mut random, ticks, &mut tally, &mut said);
    }));
    if run.is_err() {
        said.push_str("panicked; ");
    }
    if !said.is_empty() {
        tally.failures.push(format!("{said}{numbers}"));
    }
    tally
}

fn look_up(motion: &Motion, random: &mut Random, ticks: u32, tally: &mut Tally, said: &mut String) {
    let truth = smallest(Scalar::F64, motion).ok();
    for (index, (scalar, rounding)) in
        [(Scalar::Q31, fixed::types::I2F30::ROUNDING), (Scalar::Q15, fixed::types::I2F14::ROUNDING)]
            .into_iter()
            .enumerate()
    {
        let Ok(table) = smallest(scalar, motion) else {
            tally.refused += 1;
            continue;
        };
        for _ in 0..ticks {
            // ticks of every size and both signs
            let n = ((2.0 * random.share() - 1.0) * 2_f64.powf(random.between(1.0, 62.0))) as i64;
            let found = table.at_tick(n);
            tally.ticks += 1;
            let Some(truth) = &truth else { continue };
            let exact = truth.at_tick(n);
            let bound = table.error_bound().after(n as f64) + truth.error_bound().after(n as f64);
            let error = found.orientation.distance(&exact.orientation);
            let derived = (found.u - exact.u).abs();
            let derived = derived.max((found.tip_over_s - exact.tip_over_s).norm_squared().sqrt());
            // a product in 32 bits is rounded down to 2^-28, and a part of the tip is twice the difference of two
            let more = bound + 24.0 * rounding;
            note(&mut tally.of_bound[index], (error / bound).max(derived / more), scalar.name(), n, said);
        }
    }
}

/// Updates the greatest quotient of error and bound, and reports one that exceeds 1 or is no number.
fn note(greatest: &mut f64, of_bound: f64, way: &str, n: i64, said: &mut String) {
    *greatest = greatest.max(of_bound);
    let held = of_bound <= 1.0;
    if !held && said.len() < 200 {
        // writing to a String cannot fail
        let _ = write!(said, "{way}, tick {n}: {of_bound:.2} of its bound; ");
    }
}
