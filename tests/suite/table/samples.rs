//! Quantities of a sample of an ephemeris in each scalar, against those in `f64`.

use fixed::types::{I2F14, I2F30};
use toytop::{
    Complex, Ephemeris, EphemerisF32, EphemerisF64, EphemerisScalar, EphemerisView, Level, Stepper,
};
use toytop_tests::{greater, kilohertz, tolerance, vectors, worst};

/// Largest errors of the attitude state, of the tip in the type of lengths and rates, and of the tip in the scalar, at near and distant
/// ticks, relative to the greatest rate and to the length.
fn greatest_errors<R: EphemerisScalar + Into<f64>, const S: usize>() -> [f64; 3]
where
    R::Wide: Into<f64>,
{
    let motion = vectors::motion("generic_AneC");
    let tick = kilohertz();
    let double = EphemerisF64::new(&motion, tick).unwrap();
    let ephemeris = Ephemeris::<R, S>::new(&motion, tick).unwrap();
    let length = motion.top().tip_scale();
    let mut greatest = [0.0_f64; 3];
    for n in (-5000..5000).step_by(7).chain([1 << 40, -(1 << 40)]) {
        let (ours, truth) = (ephemeris.at_tick(n), double.at_tick(n));
        let (attitude, exact) = (ours.attitude_state(), truth.attitude_state());
        let wide = ours.tip();
        let wide = Complex::new(wide.re.into(), wide.im.into());
        let tip = ours.orientation().tip_over_s();
        let tip = Complex::new(tip.re.into(), tip.im.into());
        let rate = exact.omega().iter().fold(1.0_f64, |rate, w| rate.max(w.abs()));
        let misses =
            attitude.omega().into_iter().zip(exact.omega()).map(|(w, exact)| (w.into() - exact) / rate);
        let misses =
            misses.chain([attitude.u().into() - exact.u(), (attitude.udot().into() - exact.udot()) / rate]);
        let off = |tip: Complex<f64>| (tip - truth.tip()).norm_squared().sqrt() / length;
        let now = [worst(misses.map(f64::abs)), off(wide), off(tip.scaled(length))];
        greatest.iter_mut().zip(now).for_each(|(greatest, now)| *greatest = greater(*greatest, now));
    }
    greatest
}

#[test]
fn samples_in_every_scalar() {
    for (errors, allowed) in [
        (greatest_errors::<f32, 64>(), tolerance::SAMPLE_F32),
        (greatest_errors::<I2F30, 512>(), tolerance::SAMPLE_Q31),
        (greatest_errors::<I2F14, 256>(), tolerance::SAMPLE_Q15),
    ] {
        for (what, (error, allowed)) in
            ["attitude", "tip", "tip in the scalar"].iter().zip(errors.into_iter().zip(allowed))
        {
            allowed.check(what, error);
        }
    }
}

/// A quantity has one name and one value, whether it is asked of a sample, of its attitude state or of the stepper.
#[test]
fn samples_and_the_stepper_have_the_same_quantities() {
    let motion = vectors::motion("generic_AneC");
    let ephemeris = EphemerisF64::new(&motion, kilohertz()).unwrap();
    let mut stepper = Stepper::<f64>::new(&motion);
    let (mut rounding, mut greatest) = (0.0_f64, 0.0_f64);
    for n in 1..=200 {
        stepper.step(0.001);
        let sample = ephemeris.at_tick(n);
        let [attitude, stepped] = [sample.attitude_state(), stepper.attitude_state()];
        let [ours, others, steps] = [
            (
                [sample.axis(), sample.omega(), sample.omega_body()],
                sample.quaternion(),
                [sample.u(), sample.udot()],
            ),
            (
                [attitude.axis(), attitude.omega(), attitude.omega_body()],
                attitude.quaternion(),
                [attitude.u(), attitude.udot()],
            ),
            (
                [stepped.axis(), stepped.omega(), stepped.omega_body()],
                stepped.quaternion(),
                [stepped.u(), stepped.udot()],
            ),
        ]
        .map(|(vectors, quaternion, scalars)| {
            vectors.into_iter().flatten().chain(quaternion).chain(scalars).collect::<Vec<f64>>()
        });
        let off = |others: &[f64]| worst(ours.iter().zip(others).map(|(x, y)| (x - y).abs()));
        (rounding, greatest) = (greater(rounding, off(&others)), greater(greatest, off(&steps)));
    }
    tolerance::ATTITUDE_SAMPLE.check("attitude state and sample", rounding);
    tolerance::STEPPER_SAMPLE.check("stepper and sample", greatest);
}

/// An iterator has the samples of its ticks, also through a view, which knows how many segments fit.
#[test]
fn an_iterator_has_the_samples_of_its_ticks() {
    let motion = vectors::motion("generic_AneC");
    let ephemeris = EphemerisF32::new(&motion, kilohertz()).unwrap();
    let view: &EphemerisView<f32> = &ephemeris;
    assert_eq!(view.capacity(), 25);
    for (sample, n) in view.samples(-3).zip(-3..100) {
        assert_eq!(sample.orientation(), ephemeris.at_tick(n).orientation(), "{n}");
    }
}

/// The cosine of a level is that which it was made of, to one rounding.
#[test]
fn a_level_has_the_cosine_that_it_was_made_of() {
    for u in [-1.0, -0.999_999, -0.3, 0.0, 1e-9, 0.8, 0.999_999_999, 1.0] {
        assert!((Level::of_u(u).unwrap().u() - u).abs() <= 0.5 * f64::EPSILON, "{u}");
    }
}
