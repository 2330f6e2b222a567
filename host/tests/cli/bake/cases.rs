//! Motions and sizes whose tables are compiled and run in every language, with the expected bits.

use crate::motion::vectors::scenario_of;
use crate::{branch_points, sample, scenario};
use fixed::types::{I2F14, I2F30};
use std::fmt::Write as _;
use std::path::Path;
use toytop::scalar::Float;
use toytop::{Complex, Ephemeris, EphemerisScalar, Sample, Tick};
use toytop_host::input::scenario::Scenario;

/// Motion with the size of its table.
pub(crate) struct Case {
    pub(crate) file: String,
    pub(crate) scalar: &'static str,
    pub(crate) size: &'static str,
    pub(crate) tick: [u32; 2],
    /// Function that computes the samples by the crate, one line of bits for each.
    pub(crate) truth: fn(&str, [u32; 2]) -> String,
    /// Function that computes quaternion, angular velocity and next turning point at ticks, one line of bits for each.
    pub(crate) rates: fn(&str, [u32; 2]) -> String,
}

/// Function that makes the cases of a scalar and a size.
fn case<R: Bits, const S: usize>(
    scalar: &'static str,
    size: &'static str,
) -> impl Fn(String, [u32; 2]) -> Case {
    move |file, tick| Case { file, scalar, size, tick, truth: truth::<R, S>, rates: rates::<R, S> }
}

/// Cases of nutating, steady and vertical motions, and motions near the separatrix, with sliding and fixed tips.
pub(crate) fn cases() -> Vec<Case> {
    let vector = |name: &str| scenario_of(name, "bake");
    let upright = |sign: i32| {
        let text = branch_points([0.2, 1.0, 1.5], 1) + "nutation_phase = 3.141592653589793\n";
        scenario(
            &format!("bake_upright_{}", sign + 1),
            &text.replace("plus_n = 1", &format!("plus_n = {sign}")),
        )
    };
    let f32_default = case::<f32, 25>("f32", "25");
    let f32_large = case::<f32, 128>("f32", "128");
    let f64_default = case::<f64, 48>("f64", "48");
    let f64_large = case::<f64, 512>("f64", "512");
    let q31 = case::<I2F30, 32>("q31", "32");
    let q31_large = case::<I2F30, 128>("q31", "128");
    let q31_largest = case::<I2F30, 256>("q31", "256");
    let q15 = case::<I2F14, 128>("q15", "128");
    vec![
        f32_default(sample("toy_top"), [1000, 1]),
        f32_default(sample("lagrange"), [44_100, 2]),
        f32_default(sample("sleeping"), [1000, 1]),
        f32_default(vector("exact_generic_mp"), [1000, 1]),
        f32_default(vector("exact_regular_precession_pm"), [1, 3]),
        f32_large(vector("exact_near_separatrix_straddle"), [1000, 1]),
        f32_large(vector("exact_near_separatrix_e2_1"), [8000, 1]),
        f32_large(vector("exact_e1_m1"), [1000, 1]),
        // upright at tick 0, where |Re alpha| = 1 exceeds the greatest integer of 32 bits by 1
        f32_default(upright(1), [1000, 1]),
        f32_default(upright(-1), [1000, 1]),
        q31(vector("exact_fast_spin"), [44_100, 2]),
        q31_large(vector("exact_state_vertical"), [1000, 1]),
        q31_largest(vector("exact_lagrange"), [1000, 1]),
        q15(vector("exact_generic_mm"), [44_100, 2]),
        q15(vector("sleeping_unstable"), [1000, 1]),
        q15(vector("exact_generic_pp"), [8000, 1]),
        f64_default(sample("figure_3_loops"), [44_100, 2]),
        f64_default(vector("exact_generic_pm"), [1000, 1]),
        f64_default(vector("hanging"), [1000, 1]),
        f64_large(vector("exact_small_A"), [1000, 1]),
    ]
}

/// Ticks in every language: 2000 of all sizes and signs, and 40 runs of 50 ticks.
pub(crate) const RUNS: (u32, u32, u32) = (2000, 40, 50);

fn next_tick(state: &mut u64, k: u32) -> i64 {
    *state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
    (*state as i64) >> (k % 61)
}

fn table<R: Bits, const S: usize>(file: &str, [ticks, seconds]: [u32; 2]) -> Box<Ephemeris<R, S>> {
    let motion = Scenario::read(Path::new(file)).expect("a scenario").motion;
    Box::new(Ephemeris::new(&motion, Tick::ratio(ticks, seconds).expect("a tick")).expect("it fits"))
}

/// Number of ticks in [`Case::rates`].
pub(crate) const RATES: u32 = 500;

fn rates<R: Bits, const S: usize>(file: &str, tick: [u32; 2]) -> String {
    let table = table::<R, S>(file, tick);
    let [[turns_per_tick, _], ..] = table.clock().exact_step;
    let (mut state, mut text) = (1, String::new());
    for k in 0..RATES {
        let tick = next_tick(&mut state, k);
        let now = table.at_tick(tick);
        now.quaternion().into_iter().for_each(|x| text += &format!("{} ", x.hexadecimal()));
        let rates = now.omega().into_iter().chain(now.omega_body());
        rates.for_each(|x| text += &format!("{:x} ", x.to_f64().to_bits()));
        // the first tick at or after a turning point, or before it by a rounding
        let turns = table.turning_points(tick.saturating_sub(1)).take(3).filter(|_| turns_per_tick < 0.5);
        let mut turns = turns.map(|turn| {
            (turn.tick + i64::from(turn.share * turns_per_tick > 2_f64.powi(-50)), i32::from(turn.upward))
        });
        match turns.find(|(first, _)| *first >= tick) {
            Some((first, upper)) => writeln!(text, "{first} {upper}"),
            None => writeln!(text, "-"),
        }
        .expect("memory");
    }
    text
}

fn truth<R: Bits, const S: usize>(file: &str, tick: [u32; 2]) -> String {
    let table = table::<R, S>(file, tick);
    let (singles, runs, length) = RUNS;
    let (mut state, mut text) = (1, String::new());
    for k in 0..singles {
        line(&mut text, &table.at_tick(next_tick(&mut state, k)));
    }
    for k in 0..runs {
        let mut cursor = table.cursor(next_tick(&mut state, k + 20));
        for _ in 0..length {
            line(&mut text, &cursor.next());
        }
    }
    text
}

/// Scalars whose bits can be printed.
trait Bits: EphemerisScalar {
    fn hexadecimal(self) -> String;
    /// Cosine of the tilt as in the C evaluator.
    fn u(sample: &Sample<'_, Self>) -> Self {
        sample.orientation().u()
    }

    /// Tip as in the C evaluator: in units of length in floating point, of s in fixed point.
    fn tip(sample: &Sample<'_, Self>) -> Complex<Self>;
}

impl Bits for f32 {
    fn hexadecimal(self) -> String {
        format!("{:x}", self.to_bits())
    }

    fn u(sample: &Sample<'_, Self>) -> Self {
        sample.u()
    }

    fn tip(sample: &Sample<'_, Self>) -> Complex<Self> {
        sample.tip()
    }
}

impl Bits for I2F30 {
    fn hexadecimal(self) -> String {
        format!("{:x}", self.to_bits())
    }

    fn tip(sample: &Sample<'_, Self>) -> Complex<Self> {
        sample.orientation().tip_over_s()
    }
}

impl Bits for I2F14 {
    fn hexadecimal(self) -> String {
        format!("{:x}", self.to_bits())
    }

    fn tip(sample: &Sample<'_, Self>) -> Complex<Self> {
        sample.orientation().tip_over_s()
    }
}

impl Bits for f64 {
    fn hexadecimal(self) -> String {
        format!("{:x}", self.to_bits())
    }

    fn tip(sample: &Sample<'_, Self>) -> Complex<Self> {
        sample.tip()
    }
}

fn line<R: Bits>(text: &mut String, sample: &Sample<'_, R>) {
    let (phi, tip) = (sample.orientation(), R::tip(sample));
    let parts = |z: Complex<R>| [z.re, z.im];
    let [alpha, beta, tip] = [phi.alpha, phi.beta, tip].map(parts);
    let numbers = [&alpha[..], &beta, &[R::u(sample)], &tip].concat();
    let words: Vec<_> = numbers.into_iter().map(R::hexadecimal).collect();
    let nutation = sample.nutation_phase().to_bits() >> 32;
    writeln!(text, "{nutation:x} {}", words.join(" ")).expect("memory");
}

/// Comparison of the output of a program with the samples of the crate.
pub(crate) fn assert_equal(printed: &str, cases: &[Case]) {
    assert_lines(printed, cases, |case| (case.truth)(&case.file, case.tick));
}

/// Comparison of a program's output with the expected one of each case.
pub(crate) fn assert_lines(printed: &str, cases: &[Case], expected: impl Fn(&Case) -> String) {
    let mut printed = printed.lines();
    for case in cases {
        for (index, line) in expected(case).lines().enumerate() {
            assert_eq!(printed.next(), Some(line), "{} {}: sample {index}", case.file, case.scalar);
        }
    }
    assert_eq!(printed.next(), None);
}
