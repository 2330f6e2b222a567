//! The tip angle of an ephemeris, continued along the motion, in every scalar.

use fixed::types::{I2F14, I2F30};
use toytop::{Ephemeris, EphemerisScalar, Sign, Signs, Stepper, Tick};
use toytop_tests::{boxed, by_branch_points, greater, kilohertz, tolerance, top_of, vectors};

/// Greatest error of the tip angle over the samples of all exact vectors, near 0 and after 10⁹ periods, as a distance of the tip, in units
/// of s. The error of the angle itself must be less than a quarter turn.
fn greatest_error<R: EphemerisScalar, const SEGMENTS: usize>() -> f64 {
    let tick = kilohertz();
    let (mut greatest, mut through_the_centre) = (0.0, 0);
    for vector in vectors::tabulated().filter(vectors::Vector::is_exact) {
        let motion = vector.motion().unwrap();
        let Ok(ephemeris) = Ephemeris::<R, SEGMENTS>::new(&motion, tick) else { continue };
        through_the_centre += u32::from(motion.tip_class() == toytop::TipClass::ThroughOrigin);
        for sample in vector.samples() {
            let radius = sample.c.modulus() / motion.top().tip_scale();
            let (Some(truth), true) = (sample.tip_angle, radius > 1e-2) else { continue };
            let ours = ephemeris.at(sample.t).tip_angle().unwrap().to_radians();
            let off = (ours - truth).abs();
            assert!(off < 0.25, "{} at {}: {ours} for {truth}", vector.name, sample.t);
            greatest = greater(greatest, off * radius);
        }
    }
    assert!(through_the_centre >= 4, "{through_the_centre}");
    greatest
}

#[test]
fn against_thirty_digits_in_every_scalar() {
    tolerance::TIP_ANGLE[0].check("f64", greatest_error::<f64, 256>());
    tolerance::TIP_ANGLE[1].check("f32", greatest_error::<f32, 256>());
    tolerance::TIP_ANGLE[2].check("q31", greatest_error::<I2F30, 1024>());
    tolerance::TIP_ANGLE[3].check("q15", greatest_error::<I2F14, 256>());
}

/// An axis that is always vertical has no tip angle.
#[test]
fn a_vertical_axis_has_none() {
    for name in ["sleeping_stable", "sleeping_unstable", "hanging"] {
        let motion = vectors::motion(name);
        let ephemeris = Ephemeris::<f32, 16>::new(&motion, kilohertz()).unwrap();
        assert_eq!([0.0, 0.1].map(|t| ephemeris.at(t).tip_angle()), [None; 2], "{name}");
    }
}

/// Whole turns are counted: after 10⁹ periods the angle is 10⁹ times the advance of a period, to the rounding of `f64`.
#[test]
fn whole_turns_are_counted_however_far() {
    let tick = kilohertz();
    for name in ["exact_generic_pm", "exact_generic_pp", "exact_e2_1", "exact_e1_m1", "exact_lagrange"] {
        let motion = vectors::motion(name);
        let advance = motion.period_advance().unwrap();
        let ephemeris = Ephemeris::<f64, 64>::new(&motion, tick).unwrap();
        let start = ephemeris.at(0.0).tip_angle().unwrap();
        for periods in [1.0, -1.0, 3.0, 1e6, -1e9] {
            let after = ephemeris.at(periods * advance.period).tip_angle().unwrap();
            let (ours, truth) = ((after - start).to_radians(), periods * advance.phi_per_period());
            // error by the rounding of the period
            let allowed = 1e-9 + 1e-15 * periods.abs() * (1.0 + advance.period);
            assert!((ours - truth).abs() < allowed, "{name}, {periods} periods: {ours} for {truth}");
        }
    }
}

/// Branch points of a tip that passes the centre so closely that the angle changes by almost π in a very short time.
const PAST_THE_CENTRE: [f64; 3] = [0.1, 0.999_999_999_999, 1.5];

/// A slender top, A/(ps) = 2^-6: the periodic part of the angle goes around 0 within half a period.
#[test]
fn a_slender_top_turns_many_times_a_period() {
    let top = top_of([1.0 / 64.0, 1.0 / 64.0, 1.0, 1.0], 1.0);
    let mut most_turns = 0.0_f64;
    for signs in [Signs::default(), Signs { l_minus_n: Sign::Minus, ..Signs::default() }] {
        for e in
            [[-0.9, 0.9375, 1.25], [0.0, 0.5, 4.0], [-0.5, 1.0, 1.0625], [-1.0, 0.25, 1.5], PAST_THE_CENTRE]
        {
            let motion = by_branch_points(&top, e, signs);
            let period = motion.period_advance().unwrap().period;
            let tick = Tick::hertz(1 << 20).unwrap();
            let (double, single) = (boxed::<f64, 4096>(&motion, tick), boxed::<f32, 4096>(&motion, tick));
            let mut stepper = Stepper::<f64>::new(&motion);
            const STEPS: u32 = 1 << 14;
            let mean = motion.period_advance().unwrap().phi_per_period() / f64::from(STEPS);
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
