//! Ticks far from 0: the error bound holds where the motion is fastest, and beyond the range in which ticks are
//! counted.

use toytop::{Complex, Motion, Orientation, Signs, Tick};
use toytop_tests::{boxed, by_branch_points, top_of};

/// Motion with A/(ps) = 1/4096, whose nutation near the vertical is sixty times as fast as on average.
fn slender() -> Motion {
    let top = top_of([1.0, 1.0, 4096.0, 1.0], 1.0);
    by_branch_points(&top, [-0.75, 0.75, 1.0625], Signs::default())
}

/// Orientations by `tests/reference/far_ticks.py`, at ticks in the fast part of the period.
const TRUTHS: [(i64, [f64; 4]); 2] = [
    (
        29_201_518_562_686,
        [
            0.642_841_678_073_326_4,
            0.679_154_844_079_357_8,
            -0.232_292_210_962_675_66,
            0.267_476_360_490_950_2,
        ],
    ),
    (
        8_269_342_170_972_171_531,
        [
            -0.934_918_856_283_512_4,
            -0.030_439_268_095_030_02,
            -0.288_948_535_189_001_6,
            -0.203_737_397_488_773_1,
        ],
    ),
];

#[test]
fn the_bound_holds_where_the_motion_is_fastest() {
    let ephemeris = boxed::<f64, 4096>(&slender(), Tick::hertz(1_000_000).unwrap());
    for (tick, [re_alpha, im_alpha, re_beta, im_beta]) in TRUTHS {
        let truth =
            Orientation { alpha: Complex::new(re_alpha, im_alpha), beta: Complex::new(re_beta, im_beta) };
        let error = ephemeris.at_tick(tick).orientation().distance(&truth);
        let allowed = ephemeris.error_bound_at(tick);
        assert!((0.05 * allowed..allowed).contains(&error), "tick {tick}: {error:e} of {allowed:e}");
    }
}

/// Times beyond the last tick that can be counted, with a tick of half a second, so that t is a whole number of
/// ticks.
#[test]
fn time_goes_on_beyond_the_ticks_that_are_counted() {
    let ephemeris = boxed::<f64, 4096>(&slender(), Tick::hertz(2).unwrap());
    // neighbours in f64 are 512 units of time, 1024 ticks, apart below 2^62 and twice as far above
    let border = 2_f64.powi(62);
    let mut cursor = ephemeris.cursor(i64::MAX);
    let _ = cursor.next();
    // the tick number of the cursor wraps, and its phases continue
    let beyond = cursor.next().orientation();
    assert_eq!(ephemeris.at(border).orientation(), beyond);
    for _ in 0..2047 {
        let _ = cursor.next();
    }
    assert_eq!(ephemeris.at(border + 1024.0).orientation(), cursor.next().orientation());
    let mut back = ephemeris.cursor(i64::MIN);
    assert_eq!(ephemeris.at(-border).orientation(), back.next().orientation());
    // a time twice as far in the other direction is a different instant
    assert_ne!(ephemeris.at(-2.0 * border).orientation(), ephemeris.at(-border).orientation());
    assert_ne!(ephemeris.at(1e20).orientation(), ephemeris.at(1e22).orientation());
}
