//! A table in floating point or in fixed point: set-up and evaluation.

use super::input::Input;
use super::invariants;
use fixed::types::{I2F14, I2F30};
use toytop::{Complex, Level, Phase, SizedTable, Table, TableScalar, TableSettings};

pub(super) fn run_fixed(bytes: &[u8]) {
    let mut input = Input::new(bytes);
    if input.byte().is_multiple_of(2) {
        run_scalar::<I2F30, 16>(&mut input);
    } else {
        run_scalar::<I2F14, 32>(&mut input);
    }
}

pub(super) fn run(bytes: &[u8]) {
    let mut input = Input::new(bytes);
    match input.byte() % 4 {
        0 => run_scalar::<f32, 16>(&mut input),
        1 => run_scalar::<f64, 16>(&mut input),
        2 => run_scalar::<f32, 64>(&mut input),
        _ => run_scalar::<f64, 64>(&mut input),
    }
}

/// Checks a table of one scalar and capacity, for a motion, a tick length and times from the input.
fn run_scalar<R: TableScalar + Into<f64>, const SEGMENTS: usize>(input: &mut Input<'_>)
where
    R::Quantity: Into<f64>,
{
    let Ok(motion) = input.motion() else { return };
    let Ok(tick) = input.tick(&motion) else { return };
    let Ok(table) = SizedTable::<R, SEGMENTS>::new(
        &motion,
        TableSettings { truncation: Some(input.truncation()), ..tick.into() },
    ) else {
        return;
    };
    let bound = table.error_bound();
    invariants::finite("error bound", [bound.constant, bound.per_tick]);
    assert!(bound.constant > 0.0 && bound.per_tick >= 0.0, "{bound:?}");
    // a defect of the norm is an orientation error; where the bound is 0.1 rad or more, only finite numbers are
    // required
    let error = if bound.constant < 0.1 { 1.1 * bound.constant + 1e-7 } else { f64::MAX };
    let number = |z: Complex<R::Quantity>| [z.re.into(), z.im.into()];

    for _ in 0..4 {
        let (n, t) = (input.wide(), input.signed(-12.0, 20.0));
        let now = table.at_tick(n);
        let mut cursor = table.cursor(n);
        assert_eq!(cursor.next(&table).orientation(), now.orientation());
        let next = cursor.next(&table);
        // after the last tick the motion goes on, and only its number wraps
        if let Some(n) = n.checked_add(1) {
            assert_eq!(table.at_tick(n).orientation(), next.orientation());
        }
        let samples = [now, next, table.at(t), table.at(n as f64)];
        for sample in samples {
            invariants::orientation("sample", sample.orientation(), error);
            invariants::attitude("attitude", &sample.attitude_state(), error);
            invariants::finite("tip", number(sample.tip()));
            invariants::finite("tip velocity", number(sample.tip_velocity()));
            let tip = sample.tip_over_s();
            invariants::finite("tip", [tip.re.into(), tip.im.into()]);
            assert_eq!(sample.tip_angle().is_none(), motion.regime().is_vertical());
            assert!(sample.nutation_phase() >= Phase::ZERO);
        }
        events(&table, n, t);
    }
}

/// Checks that events of every kind are in order and not before the requested tick.
fn events<R: TableScalar>(table: &Table<R>, n: i64, t: f64) {
    let level = Level::from_u(t - t.round());
    let crossings = level.map(|level| table.crossings(level, n).take(3).collect::<Vec<_>>());
    let found = [
        table.turning_points(n).take(3).collect(),
        crossings.unwrap_or_default(),
        table.tip_angles(Phase::from_turns(t), n).take(3).collect(),
    ];
    for events in found {
        let mut before = (n, 0.0);
        for event in events {
            assert!(
                (0.0..1.0).contains(&event.fraction) && (event.tick, event.fraction) >= before,
                "{event:?} after {before:?}"
            );
            invariants::finite("time", [table.time_of(&event)]);
            before = (event.tick, event.fraction);
        }
    }
}
