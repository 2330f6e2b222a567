//! What follows from a moment of an ephemeris in each scalar: against the same in `f64`.

use fixed::types::{I2F14, I2F30};
use toytop::{Complex, Ephemeris, EphemerisF64, Tabular, Tick};
use toytop_tests::{greater, tolerance, vectors, worst};

/// Errors of the pose, of the tip as wide as there is, and of the tip in the scalar, near and far: as shares of the greatest rate
/// and of the length.
fn moments<R: Tabular + Into<f64>, const S: usize, const N: usize>(tip_in_s: bool) -> [f64; 3]
where
    R::Wide: Into<f64>,
{
    let motion = vectors::named("generic_AneC").motion().unwrap();
    let tick = Tick::hertz(1000).unwrap();
    let double = EphemerisF64::new(&motion, tick).unwrap();
    let ephemeris = Ephemeris::<R, S, N>::new(&motion, tick).unwrap();
    let length = motion.top().tip_scale();
    let mut greatest = [0.0_f64; 3];
    for n in (-5000..5000).step_by(7).chain([1 << 40, -(1 << 40)]) {
        let (ours, truth) = (ephemeris.at_tick(n), double.at_tick(n));
        let (pose, exact) = (ours.pose(), truth.pose());
        let wide = ours.wide_tip();
        let wide = Complex::new(wide.re.into(), wide.im.into());
        let tip: Complex<f64> = Complex::new(ours.tip().re.into(), ours.tip().im.into());
        let unit = if tip_in_s { length } else { 1.0 };
        let rate = exact.omega().iter().fold(1.0_f64, |rate, w| rate.max(w.abs()));
        let misses = pose.omega().into_iter().zip(exact.omega()).map(|(w, exact)| (w.into() - exact) / rate);
        let misses = misses.chain([pose.u().into() - exact.u(), (pose.udot().into() - exact.udot()) / rate]);
        let off = |tip: Complex<f64>| (tip - truth.tip()).norm_squared().sqrt() / length;
        let now = [worst(misses.map(f64::abs)), off(wide), off(tip.scaled(unit))];
        greatest.iter_mut().zip(now).for_each(|(greatest, now)| *greatest = greater(*greatest, now));
    }
    greatest
}

#[test]
fn what_follows_from_a_moment_in_every_scalar() {
    for (errors, allowed) in [
        (moments::<f32, 64, 6>(false), tolerance::MOMENT_F32),
        (moments::<I2F30, 64, 6>(true), tolerance::MOMENT_Q31),
        (moments::<I2F14, 64, 4>(true), tolerance::MOMENT_Q15),
    ] {
        for (what, (error, allowed)) in
            ["pose", "wide tip", "tip"].iter().zip(errors.into_iter().zip(allowed))
        {
            allowed.check(what, error);
        }
    }
}
