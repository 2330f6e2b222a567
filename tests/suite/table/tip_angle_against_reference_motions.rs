//! The tip angle of a table, continued along the motion, is compared with the reference vectors and the stepper.

use fixed::types::{I2F14, I2F30};
use toytop::{Motion, Orientation, State, Stepper, TableScalar, Tick, TipClass};
use toytop_tests::{
    DIFFERENT, SAME, by_branch_points, check, greater, kilohertz, table_if_it_fits, table_of, tolerance,
    top_of, vectors,
};

/// Greatest error of the tip angle over the samples of all exact vectors, near 0 and up to 10⁹ periods, as a distance of the tip, in units
/// of s. The error of the angle itself must be less than a quarter turn.
fn greatest_error<R: TableScalar, const SEGMENTS: usize>() -> f64 {
    let (mut greatest, mut through_the_centre) = (0.0, 0);
    for vector in vectors::tabulated().filter(vectors::Vector::is_exact) {
        let motion = vector.motion().unwrap();
        let Some(table) = table_if_it_fits::<R, SEGMENTS>(&motion, kilohertz()) else { continue };
        through_the_centre += u32::from(motion.tip_class() == TipClass::ThroughOrigin);
        let first = vector.samples().into_iter().map(|sample| (1.0, sample));
        for (periods, sample) in first.chain(vector.huge_samples()) {
            let radius = sample.c.modulus() / motion.top().tip_scale();
            let (Some(truth), true) = (sample.tip_angle, radius > 1e-2) else { continue };
            let ours = table.at(sample.t).tip_angle().unwrap().to_radians();
            // whole turns are counted modulo 2^32, and an f64 does not show small parts of many
            let off = (ours - truth).abs();
            let off = off.min((off - std::f64::consts::TAU * 2_f64.powi(32)).abs());
            let off = if periods > 1.0 { greater(off - truth.abs() * f64::EPSILON, 0.0) } else { off };
            assert!(off < 0.25, "{} at {}: {ours} for {truth}", vector.name, sample.t);
            greatest = greater(greatest, off * radius);
        }
    }
    assert!(through_the_centre >= 4, "{through_the_centre}");
    greatest
}

#[test]
fn tip_angles_agree_with_thirty_digits_in_every_scalar() {
    check("f64", greatest_error::<f64, 256>(), tolerance::TIP_ANGLE_F64);
    check("f32", greatest_error::<f32, 256>(), tolerance::TIP_ANGLE_F32);
    check("q31", greatest_error::<I2F30, 1024>(), tolerance::TIP_ANGLE_Q31);
    check("q15", greatest_error::<I2F14, 256>(), tolerance::TIP_ANGLE_Q15);
}

/// A slender top, A/(ps) = 2^-6: the periodic part of the angle goes around 0 within half a period.
#[test]
fn a_slender_top_turns_many_times_a_period() {
    let top = top_of([1.0 / 64.0, 1.0 / 64.0, 1.0, 1.0], 1.0);
    let mut most_turns = 0.0_f64;
    for signs in [SAME, DIFFERENT] {
        // the last passes the centre so closely that the angle changes by almost π in a very short time
        let past_the_centre = [0.1, 0.999_999_999_999, 1.5];
        for e in
            [[-0.9, 0.9375, 1.25], [0.0, 0.5, 4.0], [-0.5, 1.0, 1.0625], [-1.0, 0.25, 1.5], past_the_centre]
        {
            let motion = by_branch_points(&top, e, signs);
            let period = motion.period_advance().unwrap().period;
            let tick = Tick::hertz(1 << 20).unwrap();
            let (double, single) =
                (table_of::<f64, 4096>(&motion, tick), table_of::<f32, 4096>(&motion, tick));
            let mut stepper = Stepper::<f64>::new(&motion);
            const STEPS: u32 = 1 << 14;
            let mean = motion.period_advance().unwrap().phi_radians / f64::from(STEPS);
            for step in 1..2 * STEPS {
                stepper.step(period / f64::from(STEPS));
                let truth = stepper.tip_angle().unwrap().to_radians();
                let radius = stepper.tip().modulus();
                most_turns = most_turns.max((truth - mean * f64::from(step)).abs());
                if step % 37 == 0 && radius > 1e-2 {
                    let t = period / f64::from(STEPS) * f64::from(step);
                    let ours = [double.at(t).tip_angle(), single.at(t).tip_angle()];
                    for angle in ours.map(|angle| angle.unwrap().to_radians()) {
                        assert!((angle - truth).abs() < 1e-2, "{e:?} at {t}: {angle} for {truth}");
                    }
                }
            }
        }
    }
    assert!(most_turns > std::f64::consts::PI, "{most_turns}");
}

/// An upright top that spins: α turns, but there is no tip angle.
#[test]
fn a_vertical_axis_has_no_tip_angle_and_no_rate_of_it() {
    let top = top_of([1.25, 0.75, 0.625, 1.0], 1.0);
    let state = State::new(Orientation::IDENTITY, [0.0, 0.0, 40.0]).unwrap();
    let table = table_of::<f64, 8>(&Motion::launch(&top, &state).unwrap(), kilohertz());
    assert_eq!((table.at_tick(5).tip_angle(), table.mean_tip_angle_rate()), (None, 0.0));
    assert_ne!(table.at_tick(0).orientation(), table.at_tick(5).orientation());
}
