//! Samples of a table are compared with the reference vectors up to 10⁹ periods. Errors are within their stated bounds, and reach a part of them.

use core::array::from_fn;
use fixed::types::{I2F14, I2F30};
use toytop::{Complex, TableF64, TableScalar};
use toytop_tests::vectors::{self, Vector};
use toytop_tests::{
    check_all, greater, keep, kilohertz, length, table_if_it_fits, table_of, tolerance, widened,
};

/// Largest errors of a vector's samples: of the orientation over the first periods, and near 10³, 10⁶ and 10⁹ periods; of u, of u' relative
/// to ω or 1, and of the tip, in the type of lengths and in the scalar itself, relative to its length. `None` if the table is too
/// small.
fn errors<R: TableScalar<Quantity: Into<f64>> + Into<f64>, const S: usize>(
    vector: &Vector,
) -> Option<[f64; 8]> {
    let motion = vector.motion().unwrap();
    let table = table_if_it_fits::<R, S>(&motion, kilohertz())?;
    let (bound, scale) = (table.error_bound(), motion.top().tip_scale());
    // the bound is still small after a hundred years; the rates of f32 and fixed point have 64 bits
    let small = if R::ROUNDING < 1e-12 { bound.constant } else { 1e-5 };
    assert!(bound.per_tick > 0.0 && bound.per_tick * 3e12 < small, "{}: {bound:?}", vector.name);
    let mut worst = [0.0_f64; 8];
    let first = vector.samples().into_iter().map(|sample| (1.0, sample));
    for (periods, truth) in first.chain(vector.huge_samples()) {
        let sample = table.at(truth.t);
        let phi = widened(sample.orientation());
        let error = phi.distance(&truth.phi);
        let allowed = bound.after(truth.t * 1000.0);
        assert!(!vector.is_exact() || error <= allowed, "{}: {error:.1e} of {allowed:.1e}", vector.name);
        let age = [10.0, 1e4, 1e7].iter().filter(|limit| periods > **limit).count();
        let [first, thousand, million, billion] = from_fn(|index| if index == age { error } else { 0.0 });
        let [mut u, mut udot, mut tip_error, mut narrow_error] = [0.0; 4];
        if periods == 1.0 {
            let rate = length(sample.omega().map(Into::into)).max(1.0);
            let (tip, narrow) = (sample.tip(), sample.tip_over_s());
            let tip = Complex::new(tip.re.into(), tip.im.into());
            let narrow = Complex::new(narrow.re.into(), narrow.im.into());
            u = (sample.u().into() - truth.u).abs();
            let slope = (sample.udot().into() - truth.udot).abs();
            let allowed = table.rate_error_bound().after(truth.t * 1000.0);
            assert!(
                !vector.is_exact() || slope <= allowed,
                "{}: u' {slope:.1e} of {allowed:.1e}",
                vector.name
            );
            udot = slope / rate;
            tip_error = (tip - truth.c).modulus() / scale;
            narrow_error = (narrow - truth.c.scaled(1.0 / scale)).modulus();
        }
        keep(&mut worst, [first, thousand, million, billion, u, udot, tip_error, narrow_error]);
    }
    Some(worst)
}

/// Largest errors of the vectors with exact inputs, with the smaller of two tables that is large enough.
fn greatest<R: TableScalar<Quantity: Into<f64>> + Into<f64>, const S: usize, const LARGER: usize>(
    least_gap: f64,
) -> [f64; 8] {
    let mut greatest = [0.0; 8];
    for vector in vectors::tabulated().filter(Vector::is_exact) {
        if vector.gap() == 0.0 || vector.gap() >= least_gap {
            keep(&mut greatest, errors::<R, S>(&vector).or_else(|| errors::<R, LARGER>(&vector)).unwrap());
        }
    }
    greatest
}

const QUANTITIES: [&str; 8] =
    ["3 periods", "1e3 periods", "1e6 periods", "1e9 periods", "u", "u'", "tip", "tip in the scalar"];

#[test]
fn tables_in_f64_are_right_for_1e9_periods() {
    check_all(QUANTITIES, greatest::<f64, 64, 1024>(0.0), tolerance::SAMPLES_F64);
}

#[test]
fn tables_in_f32_and_fixed_point_are_right_for_1e9_periods() {
    check_all(QUANTITIES, greatest::<f32, 64, 256>(0.0), tolerance::SAMPLES_F32);
    check_all(QUANTITIES, greatest::<I2F30, 32, 256>(1e-4), tolerance::SAMPLES_Q31);
    check_all(QUANTITIES, greatest::<I2F14, 32, 128>(1e-4), tolerance::SAMPLES_Q15);
}

/// Errors of every vector, including those with decimal inputs, over its first periods.
#[test]
fn tables_of_every_vector_are_right() {
    let mut greatest = [0.0; 2];
    for vector in vectors::tabulated() {
        let small = errors::<f64, 32>(&vector);
        let [first, ..] = small.or_else(|| errors::<f64, 1024>(&vector)).unwrap();
        let near_separatrix = vector.gap() > 0.0 && vector.gap() < 1e-5;
        keep(&mut greatest, if near_separatrix { [0.0, first] } else { [first, 0.0] });
    }
    check_all(["any input", "near the separatrix"], greatest, tolerance::SAMPLES_OF_EVERY_VECTOR);
}

/// Greatest rounding error of a tick over its bound, against a table in `f64` with the same clock.
fn share_of_bound<R: TableScalar + Into<f64>>() -> f64 {
    let motion = vectors::motion("exact_generic_pm");
    let table = table_of::<R, 256>(&motion, kilohertz());
    let double = TableF64::new(&motion, kilohertz()).unwrap();
    let worst = (0..300_000).map(|n| 7919 * n).fold(0.0, |worst: f64, n| {
        greater(worst, widened(table.at_tick(n).orientation()).distance(&double.at_tick(n).orientation()))
    });
    worst / table.error_bound().constant
}

#[test]
fn errors_of_ticks_reach_a_part_of_their_bounds() {
    let shares = [share_of_bound::<f32>(), share_of_bound::<I2F30>(), share_of_bound::<I2F14>()];
    for (share, least) in shares.into_iter().zip([0.2, 0.4, 0.2]) {
        assert!((least..1.0).contains(&share), "{shares:?}");
    }
}
