//! An ephemeris in floating point: set-up and evaluation.

use super::input::Input;
use super::sound;
use toytop::{Complex, Ephemeris, Tabular, Turns};

pub(super) fn run(bytes: &[u8]) {
    let mut input = Input::new(bytes);
    let choice = input.byte();
    match choice % 4 {
        0 => check::<f32, 16, 8>(&mut input),
        1 => check::<f64, 16, 12>(&mut input),
        2 => check::<f32, 3, 4>(&mut input),
        _ => check::<f64, 2, 2>(&mut input),
    }
}

/// Of one scalar and size, for a motion, a tick and moments that the input says.
pub(super) fn check<R: Tabular + Into<f64>, const SEGMENTS: usize, const TERMS: usize>(input: &mut Input<'_>)
where
    R::Wide: Into<f64>,
{
    let Ok(motion) = input.motion() else { return };
    let Ok(tick) = input.tick(&motion) else { return };
    let Ok(ephemeris) = Ephemeris::<R, SEGMENTS, TERMS>::within(&motion, tick, input.truncation()) else {
        return;
    };
    let bound = ephemeris.error_bound();
    sound::finite("error bound", [bound.constant, bound.per_tick]);
    assert!(bound.constant > 0.0 && bound.per_tick >= 0.0, "{bound:?}");
    // a defect of the norm is one of the orientation; a bound that says nothing asks for nothing but numbers
    let error = if bound.constant < 0.1 { 1.1 * bound.constant + 1e-7 } else { f64::MAX };
    let number = |z: Complex<R::Wide>| [z.re.into(), z.im.into()];

    for _ in 0..4 {
        let (n, t) = (input.wide(), input.signed(-12.0, 20.0));
        let mut cursor = ephemeris.cursor(n);
        let moments =
            [ephemeris.at_tick(n), cursor.next(), cursor.next(), ephemeris.at(t), ephemeris.at(n as f64)];
        let [now, same, next, ..] = moments;
        assert_eq!(now.phi(), same.phi());
        assert_eq!(ephemeris.at_tick(n.wrapping_add(1)).phi(), next.phi());
        for moment in moments {
            sound::orientation("moment", moment.phi(), error);
            sound::pose("pose", &moment.pose(), error);
            sound::finite("tip", number(moment.wide_tip()));
            let (_, tip) = moment.phi_and_tip();
            sound::finite("tip", [tip.re.into(), tip.im.into()]);
            assert!(moment.nutation_phase() >= Turns::ZERO);
        }
        if let Some(point) = ephemeris.next_turning_point(n) {
            assert!(point.tick >= n || n == i64::MIN, "{point:?} from {n}");
        }
    }
}
