//! Quantities of a sample of an ephemeris in each scalar, against those in `f64`.

use fixed::types::{I2F14, I2F30};
use toytop::{Complex, Ephemeris, EphemerisF64, EphemerisScalar, Tick};
use toytop_tests::{greater, tolerance, vectors, worst};

/// Largest errors of the attitude state, of the tip in the type of lengths and rates, and of the tip in the scalar, at near and distant
/// ticks, relative to the greatest rate and to the length.
fn greatest_errors<R: EphemerisScalar + Into<f64>, const S: usize>() -> [f64; 3]
where
    R::Wide: Into<f64>,
{
    let motion = vectors::named("generic_AneC").motion().unwrap();
    let tick = Tick::hertz(1000).unwrap();
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
