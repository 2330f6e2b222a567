//! Events of a table are compared with instants that a dense search at forty digits found (`tests/reference/events.py`).

use fixed::types::{I2F14, I2F30};
use std::f64::consts::TAU;
use toytop::scalar::Float;
use toytop::{
    Event, Level, Motion, Phase, SizedTable, Table, TableF64, TableScalar, TableSettings, Tick, Top,
    TopParameters,
};
use toytop_tests::vectors::{self, entries, number};
use toytop_tests::{
    check_all, greater, kilohertz, released_from_rest, table_if_it_fits, table_of, tolerance, top_of, toy,
};

/// Events of a kind and its value from a tick.
fn found<R: TableScalar>(view: &Table<R>, motion: &Motion, kind: &str, value: f64, from: i64) -> Vec<Event> {
    const MAX_EVENTS: usize = 12;
    let mut events: Vec<Event> = match kind {
        "turning" => view.turning_points(from).take(MAX_EVENTS).collect(),
        "level" => view.crossings(Level::from_u(value).unwrap(), from).take(MAX_EVENTS).collect(),
        "circle" => {
            let levels = Level::from_circle(motion.top(), value * motion.top().tip_scale()).unwrap();
            levels.into_iter().flat_map(|level| view.crossings(level, from).take(MAX_EVENTS)).collect()
        }
        "tip_angle" => view.tip_angles(Phase::from_turns(value), from).take(MAX_EVENTS).collect(),
        _ => Level::lift_off(motion)
            .map_or(Vec::new(), |level| view.crossings(level, from).take(MAX_EVENTS).collect()),
    };
    events.sort_by(|a, b| a.tick.cmp(&b.tick).then(a.fraction.total_cmp(&b.fraction)));
    events
}

/// Greatest errors: of u (or of the radius) at its crossings, of the tip angle times the radius, of the time of a turning point in
/// periods.
fn greatest_errors<R: TableScalar>() -> [f64; 3] {
    let (mut errors, mut compared) = ([0.0; 3], 0);
    for case in entries(&vectors::json("events.json")["cases"]) {
        let motion = vectors::motion(case["motion"].as_str().unwrap());
        let Some(view) = table_if_it_fits::<R, 1024>(&motion, Tick::hertz(1024).unwrap()) else { continue };
        let (kind, value) = (case["kind"].as_str().unwrap(), case["value"].as_f64().unwrap_or_default());
        let from = case["from_tick"].as_i64().unwrap();
        let (events, truths) = (found(&view, &motion, kind, value, from), entries(&case["events"]));
        assert!(events.len() >= truths.len(), "{case}: {events:?}");
        for (event, truth) in events.iter().zip(truths) {
            let (after, slope) = (number(&truth["after"]), number(&truth["slope"]).abs());
            let ticks = (event.tick - from) as f64 + event.fraction;
            let off = (ticks / 1024.0 - after).abs();
            let sample = view.at_event(event);
            let radius = sample.tip().modulus().to_f64() / motion.top().tip_scale();
            let (quantity, error) = match kind {
                "turning" => (2, off / motion.period_advance().map_or(1.0, |advance| advance.period)),
                "tip_angle" => (1, off * slope * radius * TAU),
                // the normal force falls steeply with u, so that its own error is many times that of u
                "lift_off" => (0, off * sample.udot().to_f64().abs()),
                _ => (0, off * slope),
            };
            let bound = view.error_bound().after(ticks + from as f64) + slope * f64::EPSILON;
            // in 16 bits the rate of the tip angle changes within the error of the time
            let allowed = if quantity == 1 && R::TERMS == 3 { 2.0 * bound } else { bound };
            assert!(quantity == 2 || error <= allowed, "{case}: {error:e} of {bound:e} at {event:?}");
            assert!(error < 0.01, "{case}: {event:?}");
            assert!(kind != "level" || event.upward == (number(&truth["slope"]) > 0.0), "{case}: {event:?}");
            errors[quantity] = greater(errors[quantity], error);
            compared += 1;
        }
    }
    assert!(compared > 150, "{compared}");
    errors
}

#[test]
fn events_are_where_a_dense_search_finds_them() {
    let what = ["u", "tip angle", "turning"];
    check_all(what, greatest_errors::<f64>(), tolerance::EVENTS_F64);
    // set-up follows the motion to a fraction of the error that the scalar allows, so that a turning point is less exact than in f64
    check_all(what, greatest_errors::<f32>(), tolerance::EVENTS_F32);
    check_all(what, greatest_errors::<I2F30>(), tolerance::EVENTS_Q31);
    check_all(what, greatest_errors::<I2F14>(), tolerance::EVENTS_Q15);
}

/// For a top released from rest, tick 0 is a turning point, the tilt of the release is reached there or at no time, and the tip is opposite
/// to the direction in which the axis leans. It is exactly a turning point also in a table with a large error.
#[test]
fn a_release_from_rest_is_an_event_at_tick_0() {
    for (tilt, spin, truncation) in
        [(0.35, 150.0, 1e-6), (1.1, 60.0, 1e-4), (2.8, 5.0, 1e-5), (0.01, 20.0, 1e-3)]
    {
        let motion = released_from_rest(&toy(), tilt, spin);
        let view = table_of::<f64, 512>(&motion, kilohertz());
        let first = view.turning_points(0).next().unwrap();
        assert_eq!((first.tick, first.fraction, first.upward), (0, 0.0, true), "{tilt}");
        let angle = view.tip_angles(Phase::HALF, 0).next().unwrap();
        assert!(view.time_of(&angle) < tolerance::EVENTS_AT_A_CUSP, "{tilt}: {angle:?}");
        let coarse = SizedTable::<f32, 64>::new(
            &motion,
            TableSettings { truncation: Some(truncation), ..kilohertz().into() },
        )
        .unwrap();
        let half_period = motion.period_advance().unwrap().period / 2.0;
        let [now, next] = [0, 1].map(|tick| coarse.turning_points(tick).next().unwrap());
        assert_eq!((now.tick, now.fraction), (0, 0.0), "{tilt}");
        assert_eq!((next.tick, next.upward), ((1000.0 * half_period).floor() as i64, !now.upward), "{tilt}");
    }
}

/// From the first tick of all, and up to the last, no event is lost.
#[test]
fn the_first_and_the_last_ticks_have_events() {
    let view = table_of::<f64, 512>(&released_from_rest(&toy(), 0.35, 60.0), kilohertz());
    let level = Level::from_tilt(0.36).unwrap();
    let from = |n: i64| -> [Vec<i64>; 3] {
        [
            view.turning_points(n).take(40).map(|event| event.tick).collect(),
            view.crossings(level, n).take(40).map(|event| event.tick).collect(),
            view.tip_angles(Phase::QUARTER, n).take(40).map(|event| event.tick).collect(),
        ]
    };
    for first in [i64::MIN, i64::MIN + 1, i64::MIN + 511, i64::MIN + 513, i64::MAX - 2000, i64::MAX - 200] {
        for (kind, (found, later)) in from(first).into_iter().zip(from(first + 100)).enumerate() {
            let expected: Vec<_> = found.iter().filter(|tick| **tick >= first + 100).collect();
            assert!(found.windows(2).all(|pair| pair[0] <= pair[1]), "{kind} from {first}");
            assert!(
                later.iter().zip(expected).all(|(a, b)| a == b),
                "{kind} from {first}: {found:?} {later:?}"
            );
        }
    }
    let [second, third] = [1, 2].map(|index| from(0)[0][index]);
    for first in [i64::MIN, i64::MIN + 300, i64::MAX - 300] {
        let gap = from(first)[0][0] - first;
        assert!((0..=third - second + 1).contains(&gap), "{first}: {gap}");
        let count = from(first).map(|events| events.len());
        assert!(first > 0 || count == [40; 3], "{first}: {count:?}");
    }
}

/// Events that do not occur are not found: u of a precession has no turning points, a level above e₂ is not crossed, and a vertical axis
/// has no tip angle.
#[test]
fn events_that_do_not_occur_are_not_found() {
    let steady = vectors::motion("regular_precession");
    let steady = TableF64::new(&steady, kilohertz()).unwrap();
    assert_eq!(steady.turning_points(0).next(), None);
    assert_eq!(steady.crossings(Level::from_u(0.9).unwrap(), 0).next(), None);
    let sleeping = vectors::motion("sleeping_stable");
    let sleeping = TableF64::new(&sleeping, kilohertz()).unwrap();
    assert_eq!(sleeping.tip_angles(Phase::ZERO, 0).next(), None);
    let generic = vectors::motion("exact_generic_pp");
    let view = TableF64::new(&generic, kilohertz()).unwrap();
    for u in [0.626, 1.0, -0.344, -1.0] {
        assert_eq!(view.crossings(Level::from_u(u).unwrap(), 0).next(), None, "{u}");
    }
    assert_eq!(Level::lift_off(&vectors::motion("exact_lagrange")), None);
}

/// A level has the cosine or the tilt that it was made of, to one rounding, and a level that does not exist is refused.
#[test]
fn a_level_has_the_cosine_or_tilt_that_it_was_made_of() {
    for u in [-1.0, -0.999_999, -0.3, 0.0, 1e-9, 0.8, 0.999_999_999, 1.0] {
        assert!((Level::from_u(u).unwrap().u() - u).abs() <= 0.5 * f64::EPSILON, "{u}");
    }
    for tilt in [0.0, 1e-9, 0.36, 1.6, 3.1] {
        let error = Level::from_tilt(tilt).unwrap().tilt() - tilt;
        assert!(error.abs() <= f64::EPSILON * tilt, "{tilt} {error:e}");
    }
    for bad in [Level::from_u(1.5), Level::from_tilt(-0.1), Level::from_tilt(f64::NAN)] {
        assert!(bad.is_err());
    }
    assert!(Level::from_circle(&toy(), 0.0).is_err() && Level::from_circle(&toy(), 2.0).is_err());
    let free = TopParameters { transverse_inertia: 1.25, axial_inertia: 0.75, ..TopParameters::default() };
    // a free body has no length s: the radius is the sine of the tilt
    let levels = Level::from_circle(&Top::free(&free).unwrap(), 0.6).unwrap();
    assert!(levels.iter().all(|level| (level.u().abs() - 0.8).abs() < 1e-15), "{levels:?}");
}

/// A regular precession passes every tip angle at equal intervals.
#[test]
fn a_precession_passes_each_angle_once_a_turn() {
    let motion = vectors::motion("exact_regular_precession_pm");
    let view = TableF64::new(&motion, kilohertz()).unwrap();
    let turn = 1000.0 * core::f64::consts::TAU / view.mean_tip_angle_rate().abs();
    let times: Vec<_> = view.tip_angles(Phase::from_turns(0.3), -5).take(6).collect();
    for pair in times.windows(2) {
        let gap = (pair[1].tick - pair[0].tick) as f64 + pair[1].fraction - pair[0].fraction;
        assert!((gap / turn - 1.0).abs() < 1e-13, "{gap} {turn}");
        let angle = view.at_event(&pair[1]).tip_angle().unwrap();
        assert!((angle - Phase::from_turns(0.3)).principal().to_turns().abs() < 1e-14);
    }
}

/// The tip of a fast top needs hundreds of nutations for a turn, and no angle is missed or found twice.
#[test]
fn a_slow_drift_reaches_every_angle() {
    let top = top_of([1.0, 0.5, 1.0, 1.0], 1.0);
    let motion = released_from_rest(&top, 0.5, 60.0);
    let view = table_of::<f64, 512>(&motion, kilohertz());
    let advance = motion.period_advance().unwrap();
    assert!(advance.phi_radians.abs() < 0.03);
    let turn = TAU / advance.phi_radians.abs() * advance.period;
    let mut before = f64::NEG_INFINITY;
    for event in view.tip_angles(Phase::from_turns(0.2), 0).take(12) {
        let t = view.time_of(&event);
        let angle = view.at_event(&event).tip_angle().unwrap();
        assert!((angle - Phase::from_turns(0.2)).principal().to_turns().abs() < 1e-13, "{t}");
        // a top released from rest has cusps, so that its tip angle is monotone
        assert!(
            before.is_infinite() || (t - before - turn).abs() < 1.1 * advance.period,
            "{t} after {before}"
        );
        before = t;
    }
    assert!(before > 10.0 * turn);
}
