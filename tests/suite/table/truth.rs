//! Ephemeris against exact values: the orientation up to 10⁹ periods, and the other quantities of a sample.

use fixed::types::{I2F14, I2F30};
use toytop::{Ephemeris, EphemerisScalar, SetUpError, Stepper};
use toytop_tests::vectors::{self, Vector};
use toytop_tests::{greater, kilohertz, tolerance, widened, worst};

/// Largest orientation errors of a vector's samples: over the first periods, and near 10³, 10⁶ and 10⁹ periods.
fn errors<R: EphemerisScalar + Into<f64>, const S: usize>(vector: &Vector) -> Result<[f64; 4], SetUpError> {
    let ephemeris = Ephemeris::<R, S>::new(&vector.motion().unwrap(), kilohertz())?;
    let bound = ephemeris.error_bound();
    // the bound is still small after a hundred years; the rates of f32 and fixed point have 64 bits
    let small = if R::ROUNDING < 1e-12 { bound.constant } else { 1e-5 };
    assert!(bound.per_tick > 0.0 && bound.per_tick * 3e12 < small, "{}: {bound:?}", vector.name);
    let mut worst = [0.0_f64; 4];
    let first = vector.samples().into_iter().map(|sample| (1.0, sample));
    for (periods, sample) in first.chain(vector.huge_samples()) {
        let error = widened(ephemeris.at(sample.t).orientation()).distance(&sample.phi);
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

/// Errors with the smallest of three table sizes that is large enough.
fn errors_f64(vector: &Vector) -> [f64; 4] {
    let larger = |_| errors::<f64, 256>(vector).or_else(|_| errors::<f64, 1024>(vector));
    errors::<f64, 32>(vector).or_else(larger).unwrap_or_else(|error| panic!("{}: {error}", vector.name))
}

fn exact() -> impl Iterator<Item = Vector> {
    vectors::tabulated().filter(Vector::is_exact)
}

/// Errors for inputs taken as exact, at any distance: they show the precision of set-up in extended precision.
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

/// Greatest error at any time, with the smaller of two tables that is large enough.
fn greatest<R: EphemerisScalar + Into<f64>, const S: usize, const LARGER: usize>(least_gap: f64) -> f64 {
    let vectors = exact().filter(|vector| vector.gap() == 0.0 || vector.gap() >= least_gap);
    let errors =
        vectors.flat_map(|vector| errors::<R, S>(&vector).or_else(|_| errors::<R, LARGER>(&vector)).unwrap());
    worst(errors)
}

#[test]
fn truth_to_a_thousand_million_periods_in_f32_and_fixed_point() {
    tolerance::EPHEMERIS_F32.check("f32", greatest::<f32, 64, 256>(0.0));
    tolerance::EPHEMERIS_Q31.check("q31", greatest::<I2F30, 32, 256>(1e-4));
    tolerance::EPHEMERIS_Q15.check("q15", greatest::<I2F14, 32, 128>(1e-4));
}

/// Errors of every vector, including those with decimal inputs, over its first periods.
#[test]
fn truth_on_every_vector() {
    for vector in vectors::tabulated() {
        let rounding = if vector.gap() > 0.0 && vector.gap() < 1e-5 { 1e-8 } else { 1e-11 };
        let [first, ..] = errors_f64(&vector);
        assert!(first < rounding, "{}: {first:.1e}", vector.name);
    }
}

/// The attitude state of a sample agrees with that of the stepper: u, u', ω, and the tip.
#[test]
fn attitude_states_agree_with_the_vectors() {
    let mut worst = [0.0_f64; 4];
    for vector in exact().filter(|vector| vector.gap() == 0.0 || vector.gap() > 1e-3) {
        let motion = vector.motion().unwrap();
        let ephemeris = Ephemeris::<f64, 512>::new(&motion, kilohertz()).unwrap();
        for sample in vector.samples() {
            let ours = ephemeris.at(sample.t);
            let attitude = ours.attitude_state();
            let scale = attitude.omega().iter().fold(1.0_f64, |scale, w| scale.max(w.abs()));
            assert_eq!(attitude.orientation, ours.orientation());
            let tip = (ours.tip() - sample.c).norm_squared().sqrt() / motion.top().tip_scale();
            let errors =
                [(attitude.u() - sample.u).abs(), (attitude.udot() - sample.udot).abs() / scale, tip];
            worst.iter_mut().zip(errors).for_each(|(worst, error)| *worst = greater(*worst, error));
        }
        let (start, state) =
            (Stepper::<f64>::new(&motion).attitude_state(), ephemeris.at_tick(0).attitude_state());
        for (ours, stepped) in state.omega().iter().zip(start.omega()) {
            worst[3] = greater(worst[3], (ours - stepped).abs());
        }
    }
    for ((what, allowed), error) in ["u", "u'", "tip", "omega"].iter().zip(tolerance::ATTITUDE_F64).zip(worst)
    {
        allowed.check(what, error);
    }
}
