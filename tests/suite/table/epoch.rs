//! Launches at any tick of a running counter, ticks of any length, and the exchange of tables between two ticks.

use std::sync::mpsc;
use std::thread;
use toytop::{
    Cursor, Ephemeris, EphemerisF32, EphemerisMemory, EphemerisScalar, EphemerisView, Event, ReadyEphemeris,
    SetUp, Tick,
};
use toytop_tests::{Table, launched_at, tolerance, vectors, widened, worst};

const NAMES: [&str; 5] =
    ["generic_AneC", "fig3_diff_e3_3", "vertical_pass_e2_1", "regular_precession", "sleeping_stable"];

fn tick(ticks: u32, seconds: u32) -> Tick {
    Tick::ratio(ticks, seconds).unwrap()
}

fn table<R: EphemerisScalar>(name: &str, tick: Tick, epoch: i64) -> Table<R, 512> {
    launched_at(&vectors::motion(name), tick, epoch)
}

/// Ticks of both signs, up to some 10^18.
fn ticks() -> impl Iterator<Item = i64> {
    (0..62).flat_map(|bits| [1_i64 << bits, -(1_i64 << bits), (1_i64 << bits) / 3])
}

/// The bound is tight enough to detect a wrong increment: eight short ticks are one long tick.
#[test]
fn the_bound_far_away_is_near_the_error() {
    let errors = NAMES.map(|name| {
        let (short, long) = (table::<f64>(name, tick(16, 1), 0), table::<f64>(name, tick(2, 1), 0));
        worst(ticks().filter(|n| n.checked_mul(8).is_some()).map(|n| {
            let distance = long.at_tick(n).orientation().distance(&short.at_tick(8 * n).orientation());
            let bound = [(&long, n), (&short, 8 * n)].map(|(table, n)| table.error_bound_at(n));
            distance / bound.iter().sum::<f64>()
        }))
    });
    tolerance::OF_THE_BOUND.check("with another tick", worst(errors));
}

/// A launch at tick `epoch` is that at tick 0, with other tick numbers, whatever the length of a tick. The two differ by the truncation of
/// phases, which is a part of both bounds.
fn epochs_agree<R: EphemerisScalar + Into<f64>>() {
    const FAR: i64 = 1 << 62;
    for name in NAMES {
        for (ticks, seconds) in [(1000, 1), (16, 1), (1, 60), (1, 86_400), (7, u32::MAX)] {
            let tick = tick(ticks, seconds);
            let original = table::<R>(name, tick, 0);
            let [[turns_per_tick, _], ..] = original.clock().exact_step;
            for epoch in [1, 250, -3, -1_000_000_000, 1_000_000_000_000_007, FAR, -FAR] {
                let launched = table::<R>(name, tick, epoch);
                let label = format!("{name}, {ticks} ticks in {seconds} s, epoch {epoch}");
                assert_eq!(launched.error_bound(), original.error_bound(), "{label}");
                assert_eq!(launched.rate_error_bound(), original.rate_error_bound(), "{label}");
                let at =
                    |table: &EphemerisView<R>, n| [table.error_bound_at(n), table.rate_error_bound_at(n)];
                for past in [-2_000_000_000, -1000, -2, 0, 1, 77, 4096, 1_000_000_007_i64] {
                    let (now, then) = (launched.at_tick(epoch + past), original.at_tick(past));
                    let distance = widened(now.orientation()).distance(&widened(then.orientation()));
                    assert!(distance <= original.error_bound().constant, "{label}, {past}: {distance:e}");
                    let angles = [now, then].map(|x| x.tip_angle().map_or(0.0, |angle| angle.to_radians()));
                    let turns = (angles[0] - angles[1]).abs() / std::f64::consts::TAU;
                    let turns = turns.min((turns - 2_f64.powi(32)).abs());
                    assert!(turns <= 1e-6 * (1.0 + angles[0].abs()), "{label}, {past}: {angles:?}");
                    assert_eq!(at(&launched, epoch + past), at(&original, past), "{label}, {past}");
                    let turn = |table: &EphemerisView<R>, from: i64| {
                        let Event { tick, share, upward } = table.turning_points(from).next()?;
                        Some((((tick - from) as f64 + share) * turns_per_tick, upward))
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
}

#[test]
fn a_launch_at_any_tick_gives_the_same_motion() {
    epochs_agree::<f64>();
    epochs_agree::<f32>();
    epochs_agree::<fixed::types::I2F30>();
}

/// Two threads exchange two tables: one samples every tick, as an interrupt does, and the other sets tables up.
#[test]
fn tables_are_handed_over_while_they_are_sampled() {
    const EXCHANGES: i64 = 5;
    type Memory = EphemerisMemory<EphemerisF32>;
    let set_up = |memory: &'static mut EphemerisMemory<_>, name, epoch| -> ReadyEphemeris<'static, f32> {
        let motion = vectors::motion(name);
        memory.set_up(&mut SetUp::within(1e-3), &motion, tick(16, 1), epoch, &mut || {}).unwrap()
    };
    let first = set_up(Box::leak(Box::new(Memory::new())), "generic_AneC", 0);
    let spare = set_up(Box::leak(Box::new(Memory::new())), "fig3_diff_e3_3", 100);
    let (ready, fresh) = mpsc::sync_channel::<ReadyEphemeris<'static, f32>>(1);
    let (done, used) = mpsc::sync_channel::<ReadyEphemeris<'static, f32>>(1);
    let interrupt = thread::spawn(move || {
        let (mut cursor, mut exchanges) = (Cursor::new(first, 0), Vec::new());
        while exchanges.len() < EXCHANGES as usize {
            if let Ok(table) = fresh.try_recv() {
                exchanges.push(cursor.tick() + 1);
                done.send(cursor.exchange(table)).unwrap();
            }
            let tick = cursor.tick() + 1;
            let sampled = cursor.next().orientation();
            assert_eq!(cursor.tick(), tick);
            assert_eq!(sampled, cursor.table().at_tick(tick).orientation());
        }
        exchanges
    });
    ready.send(spare).unwrap();
    for epoch in 1..EXCHANGES {
        let memory = used.recv().unwrap().into_memory();
        ready.send(set_up(memory, "generic_AneC", epoch)).unwrap();
    }
    let exchanges = interrupt.join().unwrap();
    assert!(exchanges.is_sorted_by(|a, b| a < b), "{exchanges:?}");
}

/// A table can be read after its set-up only.
#[test]
fn memory_has_a_table_after_a_set_up() {
    let [easy, hard, rising] =
        ["exact_generic_pp", "near_separatrix_straddle", "exact_aperiodic"].map(vectors::motion);
    let tick = tick(1000, 1);
    let mut memory = EphemerisMemory::<Ephemeris<f64, 48>>::new();
    assert!(memory.get().is_none());
    let mut set_up = SetUp::new();
    assert!(memory.set_up(&mut set_up, &easy, tick, 0, &mut || {}).is_ok());
    assert!(memory.get().unwrap().error_bound().after(1e9) < 1e-12);
    for (truncation, motion) in [(1e-19, &hard), (1e-15, &rising), (f64::INFINITY, &easy), (-1.0, &easy)] {
        assert!(memory.set_up(&mut SetUp::new(), &easy, tick, 0, &mut || {}).is_ok());
        assert!(memory.set_up(&mut SetUp::within(truncation), motion, tick, 0, &mut || {}).is_err());
        assert!(memory.get().is_none());
    }
}
