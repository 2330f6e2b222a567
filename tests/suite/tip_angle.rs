//! The tip angle of an ephemeris, continued along the motion, in every scalar.

use fixed::types::{I2F14, I2F30};
use toytop::{Ephemeris, EphemerisScalar, Motion, Sign, Signs, Start, Stepper, Tick, Top, TopParameters};
use toytop_tests::{boxed, greater, tolerance, vectors};

/// Greatest error of the tip angle over the samples of all exact vectors, near 0 and after 10⁹ periods, as a distance of the tip, in units
/// of s. The error of the angle itself must be less than a quarter turn.
fn greatest_error<R: EphemerisScalar, const SEGMENTS: usize>() -> f64 {
    let tick = Tick::hertz(1000).unwrap();
    let (mut greatest, mut through_the_centre) = (0.0, 0);
    for vector in vectors::all().into_iter().filter(|vector| vector.is_exact()) {
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
        let motion = vectors::named(name).motion().unwrap();
        let ephemeris = Ephemeris::<f32, 16>::new(&motion, Tick::hertz(1000).unwrap()).unwrap();
        assert_eq!([0.0, 0.1].map(|t| ephemeris.at(t).tip_angle()), [None; 2], "{name}");
    }
}

/// Whole turns are counted: after 10⁹ periods the angle is 10⁹ times the advance of a period, to the rounding of `f64`.
#[test]
fn whole_turns_are_counted_however_far() {
    let tick = Tick::hertz(1000).unwrap();
    for name in ["exact_generic_pm", "exact_generic_pp", "exact_e2_1", "exact_e1_m1", "exact_lagrange"] {
        let motion = vectors::named(name).motion().unwrap();
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

/// A slender top, A/(ps) = 2^-6: the periodic part of the angle goes around 0 within half a period.
#[test]
fn a_slender_top_turns_many_times_a_period() {
    let top = Top::sliding(&TopParameters {
        transverse_inertia: 1.0 / 64.0,
        axial_inertia: 1.0 / 64.0,
        com_height: 1.0,
        mass_moment: 1.0,
        gravity: 1.0,
        ..TopParameters::default()
    })
    .unwrap();
    let mut most_turns = 0.0_f64;
    for signs in [Signs::default(), Signs { l_minus_n: Sign::Minus, ..Signs::default() }] {
        for e in [[-0.9, 0.9375, 1.25], [0.0, 0.5, 4.0], [-0.5, 1.0, 1.0625], [-1.0, 0.25, 1.5]] {
            let motion = Motion::from_branch_points(&top, e, signs, &Start::default()).unwrap();
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

/// A sample of a cursor has the same tip angle, to the bit, as the sample of its tick, also for an aperiodic motion.
#[test]
fn a_cursor_has_the_angle_of_its_tick() {
    for name in ["exact_generic_pm", "exact_aperiodic", "exact_e2_1"] {
        let motion = vectors::named(name).motion().unwrap();
        let ephemeris = Ephemeris::<f32, 128>::new(&motion, Tick::hertz(100).unwrap()).unwrap();
        for first in [-500, (1 << 40) - 3] {
            let mut cursor = ephemeris.cursor(first);
            for n in first..first + 1000 {
                let sample = cursor.next(&ephemeris);
                assert_eq!(cursor.tick(), n, "{name}");
                assert_eq!(sample.tip_angle(), ephemeris.at_tick(n).tip_angle(), "{name}: tick {n}");
            }
        }
    }
}
