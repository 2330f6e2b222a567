//! Events of an ephemeris against instants that a dense search at forty digits found (`tests/reference/events.py`).

use fixed::types::{I2F14, I2F30};
use toytop::scalar::Float;
use toytop::{
    Ephemeris, EphemerisF64, EphemerisScalar, EphemerisView, Event, Level, Motion, Phase, Release, State,
    Tick, Top,
};
use toytop_tests::{Table, boxed, greater, kilohertz, tolerance, top_of, vectors};

/// Search for an event from a tick, with the expected instants and the slopes of the searched quantity there.
struct Case {
    motion: String,
    kind: String,
    value: f64,
    from: i64,
    events: Vec<[f64; 2]>,
}

fn cases() -> Vec<Case> {
    let json = vectors::json("events.json");
    let number = |text: &serde_json::Value| text.as_str().unwrap().parse::<f64>().unwrap();
    let case = |case: &serde_json::Value| Case {
        motion: case["motion"].as_str().unwrap().to_owned(),
        kind: case["kind"].as_str().unwrap().to_owned(),
        value: case["value"].as_f64().unwrap_or(f64::NAN),
        from: case["from_tick"].as_i64().unwrap(),
        events: case["events"]
            .as_array()
            .unwrap()
            .iter()
            .map(|e| [number(&e["after"]), number(&e["slope"])])
            .collect(),
    };
    json["cases"].as_array().unwrap().iter().map(case).collect()
}

/// Events of a case, as many as expected, in ticks after its first tick.
fn found<R: EphemerisScalar>(view: &EphemerisView<R>, motion: &Motion, case: &Case) -> Vec<f64> {
    let (from, most) = (case.from, case.events.len() + 1);
    let mut events: Vec<Event> = match case.kind.as_str() {
        "turning" => view.turning_points(from).take(most).collect(),
        "level" => view.crossings(Level::of_u(case.value).unwrap(), from).take(most).collect(),
        "circle" => {
            let levels = Level::of_circle(motion.top(), case.value * motion.top().tip_scale()).unwrap();
            levels.into_iter().flat_map(|level| view.crossings(level, from).take(most)).collect()
        }
        "tip_angle" => view.tip_angles(Phase::new(case.value), from).take(most).collect(),
        _ => Level::of_lift_off(motion)
            .map_or(Vec::new(), |level| view.crossings(level, from).take(most).collect()),
    };
    events.sort_by_key(|event| event.tick);
    let after = |event: &Event| (event.tick - from) as f64 + event.share;
    let mut ticks: Vec<f64> = events.iter().map(after).collect();
    ticks.sort_by(f64::total_cmp);
    ticks
}

/// Greatest errors: of u (or of the radius) at its crossings, of the tip angle times the radius, of the time of a turning point in
/// periods.
fn greatest_errors<R: EphemerisScalar, const SEGMENTS: usize>() -> [f64; 3] {
    let tick = Tick::hertz(1024).unwrap();
    let (mut errors, mut compared) = ([0.0; 3], 0);
    for case in cases() {
        let motion = vectors::named(&case.motion).motion().unwrap();
        let Ok(view) = Ephemeris::<R, SEGMENTS>::new(&motion, tick).map(Box::new) else { continue };
        let ticks = found(&view, &motion, &case);
        let label = format!("{} {} {} from {}", case.motion, case.kind, case.value, case.from);
        assert!(ticks.len() >= case.events.len(), "{label}: {ticks:?} for {:?}", case.events);
        for (index, ([after, slope], ours)) in case.events.iter().zip(&ticks).enumerate() {
            let off = (ours / 1024.0 - after).abs();
            let (kind, error) = match case.kind.as_str() {
                "turning" => (2, off / motion.period_advance().map_or(1.0, |advance| advance.period)),
                "tip_angle" => {
                    let event = view.tip_angles(Phase::new(case.value), case.from).nth(index).unwrap();
                    let radius = view.at_event(&event).tip().modulus().to_f64() / motion.top().tip_scale();
                    (1, off * slope.abs() * radius * std::f64::consts::TAU)
                }
                // the normal force falls steeply with u, so that its own error is many times that of u
                "lift_off" => (
                    0,
                    off * view
                        .at_event(
                            &view
                                .crossings(Level::of_lift_off(&motion).unwrap(), case.from)
                                .nth(index)
                                .unwrap(),
                        )
                        .udot()
                        .to_f64()
                        .abs(),
                ),
                _ => (0, off * slope.abs()),
            };
            let bound = view.error_bound().after(ours + case.from as f64) + slope.abs() * f64::EPSILON;
            // in 16 bits the rate of the tip angle changes within the error of the time
            let allowed = if kind == 1 && R::TERMS == 3 { 2.0 * bound } else { bound };
            assert!(kind == 2 || error <= allowed, "{label}: {error:e} of {bound:e} at event {index}");
            assert!(error < 0.01, "{label}: event {index} at {ours} ticks, {} by truth", after * 1024.0);
            errors[kind] = greater(errors[kind], error);
            compared += 1;
        }
    }
    assert!(compared > 150, "{compared}");
    errors
}

#[test]
fn events_are_where_a_dense_search_finds_them() {
    let scalars = [
        ("f64", tolerance::EVENTS_F64, greatest_errors::<f64, 1024>()),
        ("f32", tolerance::EVENTS_F32, greatest_errors::<f32, 1024>()),
        ("q31", tolerance::EVENTS_Q31, greatest_errors::<I2F30, 1024>()),
        ("q15", tolerance::EVENTS_Q15, greatest_errors::<I2F14, 1024>()),
    ];
    for (name, _, [u, angle, time]) in scalars {
        println!("{name}: u {u:.1e}, tip angle {angle:.1e}, turning points {time:.1e}");
    }
    for (name, budgets, errors) in scalars {
        for (budget, (what, error)) in budgets.iter().zip(["u", "tip angle", "turning"].iter().zip(errors)) {
            budget.check(&format!("{what}, {name}"), error);
        }
    }
}

fn released(top: &Top, tilt: f64, spin: f64) -> Table<f64, 512> {
    let release = Release { tilt, spin, ..Release::default() };
    boxed(&Motion::launch(top, &State::release(&release).unwrap()).unwrap(), kilohertz())
}

/// For a top released from rest, tick 0 is a turning point, the tilt of the release is reached there or at no time, and the tip is opposite
/// to the direction in which the axis leans.
#[test]
fn a_release_from_rest_is_an_event_at_tick_0() {
    let top = *vectors::motion("si_toytop_150").top();
    for (tilt, spin) in [(0.35, 150.0), (1.1, 60.0), (0.01, 20.0)] {
        let view = released(&top, tilt, spin);
        let first = view.turning_points(0).next().unwrap();
        assert_eq!((first.tick, first.share, first.upward), (0, 0.0, true), "{tilt}");
        let angle = view.tip_angles(Phase::HALF, 0).next().unwrap();
        assert!(view.time_of(&angle) < 1e-6, "{tilt}: {angle:?}");
    }
}

/// The start of a release from rest is exactly a turning point, also in a table with a large error.
#[test]
fn a_release_from_rest_starts_at_a_turning_point_of_a_coarse_table() {
    let top = *vectors::motion("si_toytop_150").top();
    for (tilt, spin, truncation) in
        [(0.35, 150.0, 1e-6), (1.1, 60.0, 1e-4), (2.8, 5.0, 1e-5), (0.01, 20.0, 1e-3)]
    {
        let release = Release { tilt, spin, ..Release::default() };
        let motion = Motion::launch(&top, &State::release(&release).unwrap()).unwrap();
        let coarse = Ephemeris::<f32, 64>::within(&motion, kilohertz(), truncation).unwrap();
        let half_period = motion.period_advance().unwrap().period / 2.0;
        let [now, next] = [0, 1].map(|tick| coarse.turning_points(tick).next().unwrap());
        assert_eq!((now.tick, now.share), (0, 0.0), "{tilt}");
        assert_eq!((next.tick, next.upward), ((1000.0 * half_period).floor() as i64, !now.upward), "{tilt}");
    }
}

/// Events continue without end, alternate, and have the same distances after 2^40 ticks as at the start.
#[test]
fn events_go_on_for_ever() {
    let top = *vectors::motion("si_toytop_150").top();
    let view = released(&top, 0.35, 60.0);
    let level = Level::of_tilt(0.36).unwrap();
    let gaps = |from: i64| -> Vec<f64> {
        let events: Vec<_> = view.crossings(level, from).skip_while(|event| !event.upward).take(5).collect();
        assert!(events.windows(2).all(|pair| pair[0].upward != pair[1].upward));
        assert_eq!(events.len(), 5);
        events
            .windows(2)
            .map(|pair| (pair[1].tick - pair[0].tick) as f64 + pair[1].share - pair[0].share)
            .collect()
    };
    for (near, far) in gaps(0).into_iter().zip(gaps(1 << 40)) {
        assert!((near - far).abs() < 1e-10, "{near} {far}");
    }
    let last = view.turning_points(i64::MAX - 3).last();
    assert!(last.is_none_or(|event| event.tick >= i64::MAX - 3), "{last:?}");
    assert_eq!(view.tip_angles(Phase::QUARTER, i64::MAX - 3).next(), None);
}

/// From the first tick of all, and up to the last, no event is lost.
#[test]
fn the_first_and_the_last_ticks_have_events() {
    let top = *vectors::motion("si_toytop_150").top();
    let view = released(&top, 0.35, 60.0);
    let level = Level::of_tilt(0.36).unwrap();
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
                later.iter().zip(&expected).all(|(a, b)| a == *b),
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
    let steady = EphemerisF64::new(&steady, kilohertz()).unwrap();
    assert_eq!(steady.turning_points(0).next(), None);
    assert_eq!(steady.crossings(Level::of_u(0.9).unwrap(), 0).next(), None);
    let sleeping = vectors::motion("sleeping_stable");
    let sleeping = EphemerisF64::new(&sleeping, kilohertz()).unwrap();
    assert_eq!(sleeping.tip_angles(Phase::ZERO, 0).next(), None);
    let generic = vectors::motion("exact_generic_pp");
    let view = EphemerisF64::new(&generic, kilohertz()).unwrap();
    for u in [0.626, 1.0, -0.344, -1.0] {
        assert_eq!(view.crossings(Level::of_u(u).unwrap(), 0).next(), None, "{u}");
    }
    assert_eq!(Level::of_lift_off(&vectors::motion("exact_lagrange")), None);
    for bad in [Level::of_u(1.5), Level::of_tilt(-0.1), Level::of_tilt(f64::NAN)] {
        assert!(bad.is_err());
    }
    assert!(Level::of_circle(generic.top(), 0.0).is_err() && Level::of_circle(generic.top(), 2.0).is_err());
}

/// A regular precession passes every tip angle at equal intervals.
#[test]
fn a_precession_passes_each_angle_once_a_turn() {
    let motion = vectors::motion("exact_regular_precession_pm");
    let view = EphemerisF64::new(&motion, kilohertz()).unwrap();
    let turn = 1000.0 / view.mean_tip_angle_rate().abs();
    let times: Vec<_> = view.tip_angles(Phase::new(0.3), -5).take(6).collect();
    for pair in times.windows(2) {
        let gap = (pair[1].tick - pair[0].tick) as f64 + pair[1].share - pair[0].share;
        assert!((gap / turn - 1.0).abs() < 1e-13, "{gap} {turn}");
        let angle = view.at_event(&pair[1]).tip_angle().unwrap();
        assert!((angle - Phase::new(0.3)).principal().to_f64().abs() < 1e-14);
    }
}

/// The tip of a fast top needs hundreds of nutations for a turn, and no angle is missed or found twice.
#[test]
fn a_slow_drift_reaches_every_angle() {
    let top = top_of([1.0, 0.5, 1.0, 1.0], 1.0);
    let release = Release { tilt: 0.5, spin: 60.0, ..Release::default() };
    let motion = Motion::launch(&top, &State::release(&release).unwrap()).unwrap();
    let view = boxed::<f64, 512>(&motion, kilohertz());
    let advance = motion.period_advance().unwrap();
    assert!(advance.phi_per_period().abs() < 0.03);
    let turn = std::f64::consts::TAU / advance.phi_per_period().abs() * advance.period;
    let mut before = f64::NEG_INFINITY;
    for event in view.tip_angles(Phase::new(0.2), 0).take(12) {
        let t = view.time_of(&event);
        let angle = view.at_event(&event).tip_angle().unwrap();
        assert!((angle - Phase::new(0.2)).principal().to_f64().abs() < 1e-13, "{t}");
        // a top released from rest has cusps, so that its tip angle is monotone
        assert!(
            before.is_infinite() || (t - before - turn).abs() < 1.1 * advance.period,
            "{t} after {before}"
        );
        before = t;
    }
    assert!(before > 10.0 * turn);
}
