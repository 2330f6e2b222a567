//! Another tick length and another tick 0 for the same table, against tables that were set up with them, and the exchange
//! of tables between two ticks.

use std::sync::mpsc;
use std::thread;
use toytop::exact::Aperiodic;
use toytop::scalar::Float;
use toytop::{Ephemeris, EphemerisScalar, EphemerisView, Motion, Sampler, Tick};
use toytop_tests::{boxed, tolerance, vectors, widened, worst};

const NAMES: [&str; 6] = [
    "generic_AneC",
    "fig3_diff_e3_3",
    "vertical_pass_e2_1",
    "regular_precession",
    "sleeping_stable",
    "aperiodic_AneC",
];

fn tick(ticks: u32, seconds: u32) -> Tick {
    Tick::ratio(ticks, seconds).unwrap()
}

fn table<R: EphemerisScalar>(name: &str, tick: Tick) -> Box<Ephemeris<R, 512>> {
    boxed::<R, 512>(&vectors::named(name).motion().unwrap(), tick)
}

/// Ticks of both signs, up to some 10^18, where the tables differ by the rounding of their increments.
fn ticks() -> impl Iterator<Item = i64> {
    (0..62).flat_map(|bits| [1_i64 << bits, -(1_i64 << bits), (1_i64 << bits) / 3])
}

/// Distance of two tables at a tick, over the sum of their bounds there.
fn apart<A: EphemerisScalar + Into<f64>, B: EphemerisScalar + Into<f64>>(
    a: &EphemerisView<A>,
    b: &EphemerisView<B>,
    n: i64,
) -> f64 {
    let distance = widened(a.at_tick(n).orientation()).distance(&widened(b.at_tick(n).orientation()));
    let bound = a.error_bound().after(n as f64) + b.error_bound().after(n as f64);
    let (omega_a, omega_b) =
        (a.at_tick(n).omega().map(Float::to_f64), b.at_tick(n).omega().map(Float::to_f64));
    let change = omega_a.iter().zip(omega_b).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt();
    let rate_bound = a.rate_error_bound().after(n as f64) + b.rate_error_bound().after(n as f64);
    worst([distance / bound, change / rate_bound])
}

/// Factor by which the bound of the rates of a changed table may grow faster than that of a table set up anew.
const UNKNOWN: f64 = 3.0;

/// Both tables keep their bounds, and the bound of the changed one is not far above that of the other.
fn new_ticks_agree<R: EphemerisScalar + Into<f64>>() {
    for name in NAMES {
        let errors = [(700, 3), (1, 1), (16_000, 1)].map(|(hertz, seconds)| {
            let new = tick(hertz, seconds);
            let (mut changed, fresh) = (table::<R>(name, tick(1000, 7)), table::<f64>(name, new));
            changed.set_tick(new);
            let original = table::<R>(name, tick(1000, 7));
            let [bound, due] = [changed.error_bound(), table::<R>(name, new).error_bound()];
            assert!(bound.constant >= due.constant && bound.constant < due.constant * 1.001, "{name}");
            let ratio = 1000.0 / 7.0 / (f64::from(hertz) / f64::from(seconds));
            assert!(bound.per_tick > 0.9 * due.per_tick, "{name}: {bound:?} {due:?}");
            // the increments of a set-up may be off by less than a unit by chance
            let most = original.error_bound().per_tick * (ratio + 3.0) + 3.0 * due.per_tick;
            assert!(bound.per_tick < most, "{name}: {bound:?} {due:?}");
            let [rate, rate_due] = [changed.rate_error_bound(), table::<R>(name, new).rate_error_bound()];
            assert!(
                rate.constant >= rate_due.constant && rate.constant < rate_due.constant * 1.001,
                "{name}"
            );
            // the changed table does not contain the tilt and the speed of the axis, which only the motion has
            let speed =
                changed.at_tick(0).omega().map(|part| part.to_f64().powi(2)).iter().sum::<f64>().sqrt();
            let most = original.rate_error_bound().per_tick * (ratio + 3.0)
                + UNKNOWN * (rate_due.per_tick + speed * due.per_tick);
            assert!(
                (0.9 * rate_due.per_tick..most).contains(&rate.per_tick),
                "{name}: {rate:?} {rate_due:?}"
            );
            // times do not change, and the tip angle counts its turns as before
            for t in [0.0, 0.37, -211.3, 1.0e4] {
                let (a, b) = (changed.at(t), original.at(t));
                let distance = widened(a.orientation()).distance(&widened(b.orientation()));
                assert!(distance <= bound.constant, "{name}, t = {t}: {distance:e}");
                let angles = [a, b].map(|sample| sample.tip_angle().map_or(0.0, |angle| angle.to_f64()));
                assert!((angles[0] - angles[1]).abs() < 1e-4, "{name}: {angles:?}");
            }
            worst(ticks().map(|n| apart(&changed, &fresh, n)))
        });
        assert!(worst(errors) <= 1.0, "{name}: {errors:?}");
    }
}

#[test]
fn a_table_with_new_ticks_is_as_one_that_was_set_up_with_them() {
    new_ticks_agree::<f64>();
    new_ticks_agree::<f32>();
    new_ticks_agree::<fixed::types::I2F30>();
}

/// The bound holds where only the rounding of the increments differs, and is tight enough to detect a
/// wrong increment: eight old ticks are one new tick.
#[test]
fn the_bound_far_away_is_near_the_error() {
    let errors = NAMES.map(|name| {
        let (original, mut changed) = (table::<f64>(name, tick(16, 1)), table::<f64>(name, tick(16, 1)));
        changed.set_tick(tick(2, 1));
        worst(ticks().filter(|n| n.checked_mul(8).is_some()).map(|n| {
            let distance = changed.at_tick(n).orientation().distance(&original.at_tick(8 * n).orientation());
            let bound =
                [(&changed, n), (&original, 8 * n)].map(|(table, n)| table.error_bound().after(n as f64));
            distance / bound.iter().sum::<f64>()
        }))
    });
    tolerance::OF_THE_BOUND.check("after a change of the tick", worst(errors));
}

/// After a delay by ticks and parts of a tick, the same instants have other tick numbers.
fn delays_agree<R: EphemerisScalar + Into<f64>>() {
    for name in NAMES {
        let original = table::<R>(name, tick(16, 1));
        for delay in [0.0, 250.0, -3.0, 0.25, 4097.625, -1.0e9, 1.0e15] {
            let mut changed = table::<R>(name, tick(16, 1));
            changed.delay(delay);
            let [before, after] = [original.error_bound(), changed.error_bound()];
            let (constant, of_ticks) =
                (after.constant - before.constant, before.after(delay) - before.constant);
            assert!(after.per_tick == before.per_tick && constant >= of_ticks);
            assert!(constant <= of_ticks + 1e-3 * before.constant, "{name}, {delay}: {constant:e}");
            // a difference of one unit of a phase may carry into the bits that are used
            let rounding = before.constant;
            let [rate, rate_now] = [original.rate_error_bound(), changed.rate_error_bound()];
            assert!(rate_now.per_tick == rate.per_tick && rate_now.constant >= rate.after(delay));
            assert!(rate_now.constant <= rate.after(delay) + 1e-3 * rate.constant, "{name}, {delay}");
            let close = constant + rounding;
            for n in [-2_000_000_000, -1000, -2, 0, 1, 77, 4096, 1_000_000_007_i64] {
                let (now, then) = (changed.at_tick(n), original.at((n as f64 - delay) / 16.0));
                let distance = widened(now.orientation()).distance(&widened(then.orientation()));
                // a time of 1e14 units is 1/64 off in f64
                let exact = delay.abs() < 1e12;
                assert!(distance < close || !exact, "{name}, delay {delay}, tick {n}: {distance:e}");
                let whole = delay as i64;
                if delay == whole as f64 {
                    let then = original.at_tick(n - whole);
                    let distance = widened(now.orientation()).distance(&widened(then.orientation()));
                    assert!(distance < close, "{name}, delay {delay}, tick {n}: {distance:e}");
                    let angles = [now, then].map(|x| x.tip_angle().map_or(0.0, |angle| angle.to_radians()));
                    assert!((angles[0] - angles[1]).abs() <= 1e-12 * (1.0 + angles[0].abs()), "{angles:?}");
                    let turn =
                        original.next_turning_point(n - whole).map(|turn| (turn.tick + whole, turn.upper));
                    assert_eq!(
                        changed.next_turning_point(n).map(|turn| (turn.tick, turn.upper)),
                        turn,
                        "{name}"
                    );
                }
            }
            changed.delay(-delay);
            for n in [-1000, 0, 77] {
                let [back, was] = [&changed, &original].map(|table| widened(table.at_tick(n).orientation()));
                let distance = back.distance(&was);
                assert!(distance < rounding, "{name}, {delay}: {distance:e}");
            }
        }
    }
}

#[test]
fn a_delayed_table_gives_the_same_instants() {
    delays_agree::<f64>();
    delays_agree::<f32>();
    delays_agree::<fixed::types::I2F30>();
}

#[test]
fn a_delay_that_is_no_number_changes_nothing_but_a_rounding() {
    let original = table::<f64>("generic_AneC", tick(16, 1));
    for delay in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let mut changed = table::<f64>("generic_AneC", tick(16, 1));
        changed.delay(delay);
        assert_eq!(changed.at_tick(5).orientation(), original.at_tick(5).orientation());
    }
}

/// An aperiodic motion agrees with its closed form for any position of the rise on the clock.
#[test]
fn a_rise_is_moved_with_its_ticks() {
    let motion: Motion = vectors::named("aperiodic_AneC").motion().unwrap();
    let form = Aperiodic::new(&motion).unwrap();
    for (delay, (hertz, seconds)) in [(0.0, (8, 1)), (1234.5, (3, 1)), (-1e6, (64, 1)), (5e9, (1, 3))] {
        let mut changed = table::<f64>("aperiodic_AneC", tick(16, 1));
        changed.delay(delay);
        changed.set_tick(tick(hertz, seconds));
        let rate = f64::from(hertz) / f64::from(seconds);
        let centre = (delay / 16.0 * rate) as i64;
        let mut tilted = 0;
        for n in (-400..400).map(|n| centre + n) {
            let truth = form.at(n as f64 / rate - delay / 16.0).orientation;
            let distance = changed.at_tick(n).orientation().distance(&truth);
            assert!(distance < 1e-12 + 1e-15 * delay.abs(), "delay {delay}, tick {n}: {distance:e}");
            tilted += usize::from(truth.beta.norm_squared() > 1e-4);
        }
        assert!(tilted > 3, "{tilted}");
        for far in [centre - 100_000, centre + 100_000] {
            assert!(changed.at_tick(far).u() > 1.0 - 1e-14);
        }
        // the phases of the cursor stop and start at the same ticks
        let mut cursor = changed.cursor(centre - 400);
        for n in -400..400 {
            assert_eq!(cursor.next(&changed).orientation(), changed.at_tick(centre + n).orientation());
        }
    }
}

/// Two threads exchange two tables: one samples every tick, as an interrupt does, and the other sets tables up.
#[test]
fn tables_are_handed_over_while_they_are_sampled() {
    const EXCHANGES: i64 = 5;
    let leaked = |name| Box::leak(table::<f32>(name, tick(16, 1)));
    let names = ["generic_AneC", "fig3_diff_e3_3"];
    let [first, spare] = names.map(leaked);
    spare.delay(100.0);
    let (ready, fresh) = mpsc::sync_channel::<&'static mut EphemerisView<f32>>(1);
    let (done, used) = mpsc::sync_channel::<&'static mut EphemerisView<f32>>(1);
    let interrupt = thread::spawn(move || {
        let (mut sampler, mut exchanges) = (Sampler::new(first, 0), Vec::new());
        while exchanges.len() < EXCHANGES as usize {
            if let Ok(table) = fresh.try_recv() {
                exchanges.push(sampler.tick() + 1);
                done.send(sampler.exchange(table)).unwrap();
            }
            let tick = sampler.tick() + 1;
            let sampled = sampler.next().orientation();
            assert_eq!(sampler.tick(), tick);
            assert_eq!(sampled, sampler.table().at_tick(tick).orientation());
        }
        exchanges
    });
    ready.send(spare).unwrap();
    for _ in 1..EXCHANGES {
        let table = used.recv().unwrap();
        table.delay(1.0);
        ready.send(table).unwrap();
    }
    let exchanges = interrupt.join().unwrap();
    assert!(exchanges.is_sorted_by(|a, b| a < b), "{exchanges:?}");
}
