//! Against truth: the orientation to 10⁹ periods, and what follows from a moment.

use super::kilohertz;
use toytop::{Ephemeris, NoFit, Stepper, Tabular};
use toytop_tests::vectors::{self, Vector};
use toytop_tests::{greater, orientation_error, tolerance, widened};

/// Worst orientation errors of a vector's samples: over the first periods, and near 10³, 10⁶ and 10⁹ periods.
fn errors<R: Tabular + Into<f64>, const S: usize, const N: usize>(
    vector: &Vector,
) -> Result<[f64; 4], NoFit> {
    let ephemeris = Ephemeris::<R, S, N>::new(&vector.motion().unwrap(), kilohertz())?;
    let bound = ephemeris.error_bound();
    // it says something after a hundred years, too
    assert!(bound.per_tick > 0.0 && bound.per_tick * 3e12 < bound.constant, "{}: {bound:?}", vector.name);
    let mut worst = [0.0_f64; 4];
    let first = vector.samples().into_iter().map(|sample| (1.0, sample));
    for (periods, sample) in first.chain(vector.huge_samples()) {
        let error = orientation_error(widened(ephemeris.at(sample.t).phi()), sample.phi);
        let decade = [10.0, 1e4, 1e7, f64::INFINITY].iter().position(|&limit| periods < limit).unwrap();
        worst[decade] = greater(worst[decade], error);
        if vector.is_exact() {
            let allowed = bound.after(sample.t * 1000.0);
            assert!(
                error <= allowed,
                "{}: {error:.1e} rad at {}, bound {allowed:.1e}",
                vector.name,
                sample.t
            );
        }
    }
    Ok(worst)
}

/// The smallest of three sizes that fits.
fn errors_f64(vector: &Vector) -> [f64; 4] {
    let larger = |_| errors::<f64, 256, 12>(vector).or_else(|_| errors::<f64, 1024, 12>(vector));
    errors::<f64, 32, 11>(vector).or_else(larger).unwrap_or_else(|error| panic!("{}: {error}", vector.name))
}

fn exact() -> impl Iterator<Item = Vector> {
    vectors::all().into_iter().filter(Vector::is_exact)
}

/// Inputs taken as exact, at any distance: the figures of the set-up in double-double.
#[test]
fn truth_to_a_thousand_million_periods_in_f64() {
    let mut worst = [0.0_f64; 4];
    for vector in exact() {
        worst.iter_mut().zip(errors_f64(&vector)).for_each(|(worst, error)| *worst = greater(*worst, error));
    }
    for (what, error) in ["3", "1e3", "1e6", "1e9"].iter().zip(worst) {
        tolerance::EPHEMERIS_F64.check(&format!("{what} periods"), error);
    }
}

#[test]
fn truth_to_a_thousand_million_periods_in_f32() {
    let mut worst = 0.0_f64;
    for vector in exact() {
        let errors = errors::<f32, 64, 6>(&vector).or_else(|_| errors::<f32, 256, 7>(&vector)).unwrap();
        worst = errors.into_iter().fold(worst, greater);
    }
    tolerance::EPHEMERIS_F32.check("any time", worst);
}

/// Every vector, with decimal inputs too, over its first periods.
#[test]
fn truth_on_every_vector() {
    for vector in vectors::all() {
        let rounding = if vector.gap() > 0.0 && vector.gap() < 1e-5 { 1e-8 } else { 1e-11 };
        let [first, ..] = errors_f64(&vector);
        assert!(first < rounding, "{}: {first:.1e}", vector.name);
    }
}

/// The pose of a moment is that of the stepper: u, u', ω, and the tip.
#[test]
fn what_follows_from_a_moment() {
    let mut worst = [0.0_f64; 4];
    for vector in exact().filter(|vector| vector.gap() == 0.0 || vector.gap() > 1e-3) {
        let motion = vector.motion().unwrap();
        let ephemeris = Ephemeris::<f64, 512, 12>::new(&motion, kilohertz()).unwrap();
        for sample in vector.samples() {
            let moment = ephemeris.at(sample.t);
            let pose = moment.pose();
            let scale = pose.omega().iter().fold(1.0_f64, |scale, w| scale.max(w.abs()));
            assert_eq!(pose.phi, moment.phi());
            let tip = (moment.tip() - sample.c).norm_squared().sqrt() / motion.top().tip_scale();
            let errors = [(pose.u() - sample.u).abs(), (pose.udot() - sample.udot).abs() / scale, tip];
            worst.iter_mut().zip(errors).for_each(|(worst, error)| *worst = greater(*worst, error));
        }
        let (start, state) = (Stepper::<f64>::new(&motion).pose(), ephemeris.at_tick(0).pose());
        for (ours, stepped) in state.omega().iter().zip(start.omega()) {
            worst[3] = greater(worst[3], (ours - stepped).abs());
        }
    }
    for ((what, allowed), error) in ["u", "u'", "tip", "omega"].iter().zip(tolerance::MOMENT_F64).zip(worst) {
        allowed.check(what, error);
    }
}
