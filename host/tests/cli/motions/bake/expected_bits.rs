//! Motions and sizes whose tables are compiled and run in every language, with the expected bits.

use crate::command::{RELEASE, TOP, branch_points, sample, scenario};
use crate::motions::vectors::scenario_of;
use fixed::types::{I2F14, I2F30};
use std::fmt::{Debug, Write as _};
use std::path::Path;
use toytop::scalar::Float;
use toytop::{Complex, Sample, SizedTable, TableScalar, Tick};
use toytop_host::input::scenario::Scenario;

/// Motion with the size of its table.
pub(crate) struct Case {
    pub(crate) file: String,
    pub(crate) scalar: &'static str,
    pub(crate) size: usize,
    tick: [u32; 2],
    expected: fn(&str, [u32; 2]) -> Expected,
}

/// Table of a case by the crate.
pub(crate) struct Expected {
    /// All fields of the table.
    pub(crate) table: String,
    /// Bits of its numbers, a line for each tick: samples, then quaternions, angular velocities and turning points.
    pub(crate) lines: String,
}

impl Case {
    /// Arguments of `toytop bake`.
    pub(crate) fn arguments(&self) -> String {
        let Self { file, scalar, size, tick: [hertz, per], .. } = self;
        format!("{file} --scalar {scalar} --segments {size} --hertz {hertz}/{per}")
    }

    pub(crate) fn expected(&self) -> Expected {
        (self.expected)(&self.file, self.tick)
    }
}

fn case<R: Printed, const S: usize>(file: String, tick: [u32; 2]) -> Case {
    Case { file, scalar: R::NAME, size: S, tick, expected: expected::<R, S> }
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
    let unstable = RELEASE.replace("40", "0").replace("3.5", "0.5").replace("precession = 0.3", "");
    let unstable = TOP.to_owned() + &unstable;
    let f32_default = case::<f32, 25>;
    let f32_large = case::<f32, 128>;
    let f64_default = case::<f64, 48>;
    let f64_large = case::<f64, 512>;
    let q31 = case::<I2F30, 32>;
    let q31_large = case::<I2F30, 128>;
    let q31_largest = case::<I2F30, 256>;
    let q15 = case::<I2F14, 128>;
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
        q15(scenario("bake_unstable", &unstable), [1000, 1]),
        q15(vector("exact_generic_pp"), [8000, 1]),
        f64_default(sample("figure_3_loops"), [44_100, 2]),
        f64_default(vector("exact_generic_pm"), [1000, 1]),
        f64_default(vector("hanging"), [1000, 1]),
        f64_large(vector("exact_small_A"), [1000, 1]),
    ]
}

/// Ticks: 2000 of all sizes and signs, and 40 runs of 50 ticks.
pub(crate) const RUNS: (u32, u32, u32) = (2000, 40, 50);

fn next_tick(state: &mut u64, k: u32) -> i64 {
    *state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
    (*state as i64) >> (k % 61)
}

/// Number of ticks of quaternions, angular velocities and turning points.
pub(crate) const RATES: u32 = 500;

fn expected<R: Printed, const S: usize>(file: &str, [ticks, seconds]: [u32; 2]) -> Expected {
    let motion = Scenario::read(Path::new(file)).expect("a scenario").motion;
    let tick = Tick::ratio(ticks, seconds).expect("a tick");
    let table: Box<SizedTable<R, S>> = Box::new(SizedTable::new(&motion, tick).expect("it fits"));
    let (singles, runs, length) = RUNS;
    let (mut state, mut lines) = (1, String::new());
    for k in 0..singles {
        line(&mut lines, &table.at_tick(next_tick(&mut state, k)));
    }
    for k in 0..runs {
        let mut cursor = table.cursor(next_tick(&mut state, k + 20));
        for _ in 0..length {
            line(&mut lines, &cursor.next(&table));
        }
    }
    state = 1;
    let [[_, middle, high, whole], ..] = table.clock().increments;
    let turns_per_tick =
        f64::from(whole) + f64::from(high) * 2_f64.powi(-32) + f64::from(middle) * 2_f64.powi(-64);
    for k in 0..RATES {
        let tick = next_tick(&mut state, k);
        let now = table.at_tick(tick);
        let quaternion = now.quaternion().map(Into::into);
        let omega = [now.omega(), now.omega_body()].concat().into_iter().map(Float::to_f64);
        // the first tick at or after a turning point, or before it by a rounding
        let turns = table.turning_points(tick.saturating_sub(1)).take(3).filter(|_| turns_per_tick < 0.5);
        let mut turns = turns.map(|turn| {
            (turn.tick + i64::from(turn.fraction * turns_per_tick > 2_f64.powi(-50)), i32::from(turn.upward))
        });
        let turning = match turns.find(|(first, _)| *first >= tick) {
            Some((first, upper)) => format!("{first} {upper}"),
            None => "-".to_owned(),
        };
        writeln!(lines, "{}{turning}", bits(quaternion.into_iter().chain(omega))).expect("memory");
    }
    Expected { table: format!("{table:?}"), lines }
}

/// Bits of numbers, with a space after each.
fn bits(numbers: impl IntoIterator<Item = f64>) -> String {
    numbers.into_iter().map(|x| format!("{:x} ", x.to_bits())).collect()
}

/// Scalars with u and the tip as the C evaluator has them: in units of length in floating point, of s in fixed point.
trait Printed: TableScalar + Into<f64> + Debug {
    const NAME: &'static str;

    fn u(sample: &Sample<'_, Self>) -> Self {
        sample.u()
    }

    fn tip(sample: &Sample<'_, Self>) -> Complex<Self> {
        sample.tip_over_s()
    }
}

impl Printed for I2F30 {
    const NAME: &'static str = "q31";
}

impl Printed for I2F14 {
    const NAME: &'static str = "q15";
}

impl Printed for f32 {
    const NAME: &'static str = "f32";

    fn u(sample: &Sample<'_, Self>) -> Self {
        sample.u()
    }

    fn tip(sample: &Sample<'_, Self>) -> Complex<Self> {
        sample.tip()
    }
}

impl Printed for f64 {
    const NAME: &'static str = "f64";

    fn tip(sample: &Sample<'_, Self>) -> Complex<Self> {
        sample.tip()
    }
}

fn line<R: Printed>(text: &mut String, sample: &Sample<'_, R>) {
    let (phi, u, tip) = (sample.orientation(), R::u(sample), R::tip(sample));
    let numbers = [phi.alpha.re, phi.alpha.im, phi.beta.re, phi.beta.im, u, tip.re, tip.im];
    let nutation = sample.nutation_phase().to_bits() >> 32;
    writeln!(text, "{nutation:x} {}", bits(numbers.map(Into::into))).expect("memory");
}

/// Compares the output of a program with the expected one of each case.
pub(crate) fn assert_lines(printed: &str, cases: &[Case], expected: impl Fn(&Case) -> String) {
    let mut printed = printed.lines();
    for case in cases {
        for (index, line) in expected(case).lines().enumerate() {
            assert_eq!(printed.next(), Some(line), "{} {}: line {index}", case.file, case.scalar);
        }
    }
    assert_eq!(printed.next(), None);
}
