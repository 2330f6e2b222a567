//! Tables with ticks of one length and epoch are compared with those of others, and with exact orientations at far ticks.

use fixed::types::I2F30;
use toytop::{Complex, Event, Motion, Orientation, Table, TableScalar, Tick};
use toytop_tests::{
    HeapTable, SAME, by_branch_points, check, kilohertz, released_from_rest, table_from_epoch, table_of,
    tolerance, top_of, toy, vectors, widened, worst,
};

const NAMES: [&str; 5] =
    ["generic_AneC", "fig3_diff_e3_3", "vertical_pass_e2_1", "regular_precession", "sleeping_stable"];

fn tick(ticks: u32, seconds: u32) -> Tick {
    Tick::ratio(ticks, seconds).unwrap()
}

fn table<R: TableScalar>(name: &str, tick: Tick, epoch: i64) -> HeapTable<R, 512> {
    table_from_epoch(&vectors::motion(name), tick, epoch).unwrap()
}

/// The bound is tight enough to detect a wrong increment: eight short ticks are one long tick. The ticks have both signs, up to some 10^17.
#[test]
fn the_bound_far_away_is_near_the_error() {
    let errors = NAMES.map(|name| {
        let (short, long) = (table::<f64>(name, tick(16, 1), 0), table::<f64>(name, tick(2, 1), 0));
        let ticks = (0..60).flat_map(|bits| [1_i64 << bits, -(1_i64 << bits), (1_i64 << bits) / 3]);
        worst(ticks.map(|n| {
            let distance = long.at_tick(n).orientation().distance(&short.at_tick(8 * n).orientation());
            let bound = [(&long, n), (&short, 8 * n)].map(|(table, n)| table.error_bound().after(n as f64));
            distance / bound.iter().sum::<f64>()
        }))
    });
    check("with another tick", worst(errors), tolerance::TICKS_OF_TWO_LENGTHS);
}

/// A launch at tick `epoch` is that at tick 0, with other tick numbers, whatever the length of a tick. The two differ by the truncation of
/// phases, which is a part of both bounds.
fn epochs_agree<R: TableScalar + Into<f64>>() {
    const FAR: i64 = 1 << 62;
    for (name, (ticks, seconds)) in NAMES.into_iter().flat_map(|name| {
        [(1000, 1), (16, 1), (1, 60), (1, 86_400), (7, 1_000_000)].map(|ratio| (name, ratio))
    }) {
        let original = table::<R>(name, tick(ticks, seconds), 0);
        let [[_, middle, high, whole], ..] = original.clock().increments;
        let turns_per_tick =
            f64::from(whole) + f64::from(high) * 2_f64.powi(-32) + f64::from(middle) * 2_f64.powi(-64);
        for epoch in [1, 250, -3, -1_000_000_000, 1_000_000_000_000_007, FAR, -FAR] {
            let launched = table::<R>(name, tick(ticks, seconds), epoch);
            let label = format!("{name}, {ticks} ticks in {seconds} s, epoch {epoch}");
            assert_eq!(launched.error_bound(), original.error_bound(), "{label}");
            assert_eq!(launched.rate_error_bound(), original.rate_error_bound(), "{label}");
            for past in [-2_000_000_000, -1000, -2, 0, 1, 77, 4096, 1_000_000_007_i64] {
                let (now, then) = (launched.at_tick(epoch + past), original.at_tick(past));
                let distance = widened(now.orientation()).distance(&widened(then.orientation()));
                assert!(distance <= original.error_bound().constant, "{label}, {past}: {distance:e}");
                let angles = [now, then].map(|x| x.tip_angle().map_or(0.0, |angle| angle.to_radians()));
                let turns = (angles[0] - angles[1]).abs() / std::f64::consts::TAU;
                let turns = turns.min((turns - 2_f64.powi(32)).abs());
                assert!(turns <= 1e-6 * (1.0 + angles[0].abs()), "{label}, {past}: {angles:?}");
                let turn = |table: &Table<R>, from: i64| {
                    let Event { tick, fraction, upward } = table.turning_points(from).next()?;
                    Some((((tick - from) as f64 + fraction) * turns_per_tick, upward))
                };
                match (turn(&launched, epoch + past), turn(&original, past)) {
                    (Some((moved, moved_upward)), Some((phase, upward))) => {
                        let allowed = 2_f64.powi(-49) + turns_per_tick * f64::EPSILON;
                        assert!((moved - phase).abs() <= allowed, "{label}, {past}: {moved} {phase}");
                        assert_eq!(moved_upward, upward, "{label}, {past}");
                    }
                    turns => assert_eq!(turns, (None, None), "{label}, {past}"),
                }
            }
        }
    }
}

#[test]
fn a_launch_at_any_tick_gives_the_same_motion() {
    epochs_agree::<f64>();
    epochs_agree::<f32>();
    epochs_agree::<I2F30>();
}

/// A time between two ticks keeps the bound for ticks of any length, beside a table with a millisecond a tick.
#[test]
fn times_between_long_ticks_keep_the_bound() {
    let motion = released_from_rest(&toy(), 0.35, 150.0);
    let short = table_of::<f64, 48>(&motion, kilohertz());
    for (ticks, seconds) in [(1, 86_400), (1, 60), (7, 3), (3, 7_654_321), (1, 100_000_000), (u32::MAX, 1)] {
        let long = table_of::<f64, 48>(&motion, tick(ticks, seconds));
        let per_time = f64::from(ticks) / f64::from(seconds);
        for t in [1.2345, -0.1, 1e-7, 59.9, 86_400.0, -12_345.678, 1e6 / 3.0, 4e9] {
            let [found, truth] = [long.at(t), short.at(t)];
            let allowed = long.error_bound().after(t * per_time) + short.error_bound().after(1000.0 * t);
            let error = found.orientation().distance(&truth.orientation());
            assert!(error <= allowed, "{ticks}/{seconds}, {t}: {error:e} of {allowed:e}");
            let [found, truth] = [found, truth].map(|sample| sample.tip_angle().unwrap());
            // the tip is at least 0.3 of its greatest distance from the centre
            let error = (found - truth).to_radians().abs();
            assert!(error <= 8.0 * allowed, "{ticks}/{seconds}, {t}: tip angle {error:e} of {allowed:e}");
        }
    }
}

/// Motion with A/(ps) = 1/4096, whose nutation near the vertical is sixty times as fast as on average.
fn slender() -> Motion {
    by_branch_points(&top_of([1.0, 1.0, 4096.0, 1.0], 1.0), [-0.75, 0.75, 1.0625], SAME)
}

/// Orientations by `tests/reference/far_ticks.py`, at ticks in the fast part of the period.
#[test]
fn the_bound_holds_where_the_motion_is_fastest() {
    let table = table_of::<f64, 4096>(&slender(), Tick::hertz(1_000_000).unwrap());
    for (tick, alpha, beta) in [
        (
            29_201_518_562_686,
            Complex::new(0.642_841_678_073_326_4, 0.679_154_844_079_357_8),
            Complex::new(-0.232_292_210_962_675_66, 0.267_476_360_490_950_2),
        ),
        (
            8_269_342_170_972_171_531,
            Complex::new(-0.934_918_856_283_512_4, -0.030_439_268_095_030_02),
            Complex::new(-0.288_948_535_189_001_6, -0.203_737_397_488_773_1),
        ),
    ] {
        let error = table.at_tick(tick).orientation().distance(&Orientation { alpha, beta });
        let allowed = table.error_bound().after(tick as f64);
        assert!((0.01 * allowed..allowed).contains(&error), "tick {tick}: {error:e} of {allowed:e}");
    }
}

/// Times beyond the last tick that can be counted, with a tick of half a second, so that t is a whole number of
/// ticks.
#[test]
fn time_goes_on_beyond_the_ticks_that_are_counted() {
    let table = table_of::<f64, 4096>(&slender(), Tick::hertz(2).unwrap());
    let at = |t: f64| table.at(t).orientation();
    // neighbours in f64 are 512 units of time, 1024 ticks, apart below 2^62 and twice as far above
    let border = 2_f64.powi(62);
    let mut cursor = table.cursor(i64::MAX);
    // the tick number of the cursor wraps, and its phases continue
    let mut next = || cursor.next(&table).orientation();
    next();
    assert_eq!(at(border), next());
    for _ in 0..2047 {
        next();
    }
    assert_eq!(at(border + 1024.0), next());
    assert_eq!(at(-border), table.at_tick(i64::MIN).orientation());
    // a time twice as far in the other direction is a different instant
    assert_ne!(at(-2.0 * border), at(-border));
    assert_ne!(at(1e20), at(1e22));
}
