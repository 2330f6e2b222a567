//! Everything in fixed point: ephemerides of 32 and of 16 bits, and the stepper.

use super::ephemeris;
use super::input::Input;
use super::sound;
use fixed::types::{I2F14, I2F30};
use toytop::FixedStepper;

pub(super) fn run(bytes: &[u8]) {
    let mut input = Input::new(bytes);
    let choice = input.byte();
    match choice % 4 {
        0 => ephemeris::check::<I2F30, 16, 8>(&mut input),
        1 => ephemeris::check::<I2F14, 8, 4>(&mut input),
        2 => stepper::<8, 6>(&mut input),
        _ => stepper::<2, 16>(&mut input),
    }
}

fn stepper<const SEGMENTS: usize, const TERMS: usize>(input: &mut Input<'_>) {
    let Ok(motion) = input.motion() else { return };
    let Ok(tick) = input.tick(&motion) else { return };
    let Ok(mut stepper) = FixedStepper::<SEGMENTS, TERMS>::new(&motion, tick) else { return };
    let bound = stepper.error_bound();
    sound::finite("error bound", [bound.constant, bound.per_tick]);
    let back = input.byte().is_multiple_of(2);
    for _ in 0..100 {
        if back {
            stepper.step_back()
        } else {
            stepper.step()
        }
        let (phi, tip) = stepper.phi_and_tip();
        sound::orientation("stepper", phi, 2e-8);
        assert!((f64::from(phi.u()) - f64::from(stepper.u())).abs() < 2e-8, "{} {}", phi.u(), stepper.u());
        assert!(f64::from(tip.norm_squared()) <= 1.0 + 1e-7, "{tip:?}");
        assert_eq!(stepper.tip_angle().is_none(), motion.regime().is_vertical());
    }
}
