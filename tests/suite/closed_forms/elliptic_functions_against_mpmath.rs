//! Weierstrass's and Jacobi's functions are compared with 30 digits (`tests/reference/elliptic.py`).
//!
//! Errors of f(z) are in units of |f| + 1e-13 |z f'|: relative, with an allowance for the rounding of z in extended precision.

use serde_json::Value;
use toytop::Complex;
use toytop::scalar::Float;
use toytop_closed_forms::elliptic::{Jacobi, Weierstrass, carlson_rf};
use toytop_tests::vectors::{self, complex, entries, number};
use toytop_tests::{check, check_all, greater, keep, tolerance};

fn modulus(z: Complex<f64>) -> f64 {
    z.re.hypot(z.im)
}

/// Lattices of a file of the reference, each with its points (z, expected values).
fn lattices(file: &str) -> Vec<(Weierstrass, Value)> {
    let lattice = |json: &Value| {
        let [upper, lower] = ["upper_gap", "lower_gap"].map(|key| number(&json[key]));
        (Weierstrass::from_gaps(upper, lower).unwrap(), json.clone())
    };
    entries(&vectors::json(file)["lattices"]).iter().map(lattice).collect()
}

/// Allowance for the rounding of z in extended precision, relative to |z f'|.
const OF_ARGUMENT: f64 = 1e-13;

/// Error of f(z), relative to |f| + 1e-13 |z f'|.
fn off(ours: Complex<f64>, truth: &Value, z_slope: f64) -> f64 {
    let [re, im] = [0, 1].map(|i| vectors::exact_number(&truth[i]));
    let apart = Complex::new((re - ours.re.into()).to_f64(), (im - ours.im.into()).to_f64());
    modulus(apart) / (modulus(Complex::new(re.to_f64(), im.to_f64())) + OF_ARGUMENT * z_slope)
}

/// Error of a real function relative to |f| + 1e-13 |z f'|; absolute where both are 0.
fn off_real(ours: f64, truth: &Value, z_slope: f64) -> f64 {
    let truth = vectors::exact_number(truth);
    let apart = (truth - ours.into()).to_f64().abs();
    let size = truth.to_f64().abs() + OF_ARGUMENT * z_slope.abs();
    if size == 0.0 { apart } else { apart / size }
}

/// Notes the errors of ℘, ℘' and ζ at a point.
fn note(worst: &mut [f64; 3], lattice: &Weierstrass, point: &Value) {
    let z = complex(&point["z"]);
    let [p, slope] = ["p", "p_prime"].map(|key| complex(&point[key]));
    let [g2, _] = lattice.invariants();
    let curvature = (p * p).scaled(6.0) - Complex::new(0.5 * g2, 0.0);
    let size = modulus(z);
    keep(
        worst,
        [
            off(lattice.p(z), &point["p"], size * modulus(slope)),
            off(lattice.p_prime(z), &point["p_prime"], size * modulus(curvature)),
            off(lattice.zeta(z), &point["zeta"], size * modulus(p)),
        ],
    );
}

#[test]
fn weierstrass_functions_agree_with_thirty_digits() {
    let (mut worst, mut logarithm, mut sigma) = ([0.0_f64; 3], 0.0_f64, 0.0_f64);
    for (lattice, json) in lattices("elliptic.json") {
        for point in entries(&json["points"]) {
            let z = complex(&point["z"]);
            let [zeta, ln] = ["zeta", "ln_sigma"].map(|key| complex(&point[key]));
            let size = modulus(z);
            note(&mut worst, &lattice, point);
            // ln σ is determined modulo 2πi
            let ours = lattice.ln_sigma(z);
            let mut apart = ours - ln;
            apart.im -= std::f64::consts::TAU * (apart.im / std::f64::consts::TAU).round();
            logarithm = greater(logarithm, modulus(apart) / (1.0 + modulus(ours) + modulus(ln)));
            if ln.re.abs() < 300.0 {
                // e^{ln σ} of the expected value has the rounding of its own exponent
                let truth = Complex::new(ln.im.cos(), ln.im.sin()).scaled(ln.re.exp());
                let error = modulus(lattice.sigma(z) - truth) / modulus(truth);
                sigma = greater(sigma, error / (1.0 + modulus(ln) + size * modulus(zeta)));
            }
        }
    }
    // four quotients of the root differences a decade from 1e-28 to 1e28
    for (lattice, json) in lattices("elliptic_sweep.json") {
        entries(&json["points"]).iter().for_each(|point| note(&mut worst, &lattice, point));
    }
    check_all(["p", "p'", "zeta"], worst, tolerance::ELLIPTIC_P_AND_ZETA);
    check("ln sigma", logarithm, tolerance::ELLIPTIC_LN_SIGMA);
    check("sigma", sigma, tolerance::ELLIPTIC_SIGMA);
}

#[test]
fn half_periods_and_quasi_periods_agree_with_thirty_digits() {
    let mut worst = 0.0_f64;
    for (lattice, json) in lattices("elliptic.json") {
        for (values, key) in
            [(lattice.half_periods(), "half_periods"), (lattice.quasi_periods(), "quasi_periods")]
        {
            for (ours, truth) in values.into_iter().zip(entries(&json[key])) {
                worst = greater(worst, off_real(ours, truth, 0.0));
            }
        }
    }
    check("half periods", worst, tolerance::ELLIPTIC_HALF_PERIODS);
}

/// ℘ has the values e₁, e₂, e₃ at the half periods, where each difference has a double zero. Differences of given roots are exact.
#[test]
fn p_has_the_roots_at_the_half_periods() {
    for (lattice, _) in lattices("elliptic.json") {
        let [real, imaginary] = lattice.half_periods();
        let points = [Complex::new(real, 0.0), Complex::new(real, imaginary), Complex::new(0.0, imaginary)];
        for (i, z) in points.into_iter().enumerate() {
            let scale = lattice.roots()[0] - lattice.roots()[2];
            assert!(modulus(lattice.differences(z)[i]) < 1e-29 * scale, "{z:?}");
            assert!(
                (lattice.p(z).re - lattice.roots()[i]).abs() < 1e-15 * scale
                    && lattice.p(z).im.abs() < 1e-15 * scale
            );
        }
    }
    let [_, middle, _] = Weierstrass::from_roots([1.0, 1e-17, -1.0]).unwrap().roots();
    assert!((middle / (2e-17 / 3.0) - 1.0).abs() < 1e-15, "{middle:e}");
}

#[test]
fn jacobi_functions_agree_with_thirty_digits() {
    let (mut functions, mut quarter) = (0.0_f64, 0.0_f64);
    for json in entries(&vectors::json("elliptic.json")["jacobi"]) {
        let (m, m1) = (number(&json["m"]), number(&json["m1"]));
        let jacobi = Jacobi::new(m, m1).unwrap();
        quarter = greater(quarter, off_real(jacobi.quarter_period(), &json["quarter_period"], 0.0));
        assert!((carlson_rf(0.0, m1, 1.0) / jacobi.quarter_period() - 1.0).abs() < 1e-15, "{m1}");
        for point in entries(&json["points"]) {
            let [u, sn, cn, dn] = ["u", "sn", "cn", "dn"].map(|key| number(&point[key]));
            let ours = jacobi.at(u);
            let values = [
                ("sn", ours.sn, cn * dn),
                ("cn", ours.cn, sn * dn),
                ("dn", ours.dn, m * sn * cn),
                ("am", ours.am, dn),
            ];
            for (key, ours, slope) in values {
                functions = greater(functions, off_real(ours, &point[key], u * slope));
            }
        }
    }
    // four complementary parameters a decade down to 1e-300
    for entry in entries(&vectors::json("elliptic_sweep.json")["jacobi"]) {
        let m1 = number(&entry["m1"]);
        let jacobi = Jacobi::new(1.0 - m1, m1).unwrap();
        quarter = greater(quarter, off_real(jacobi.quarter_period(), &entry["quarter_period"], 0.0));
    }
    check("sn, cn, dn, am", functions, tolerance::ELLIPTIC_SN_CN_DN_AM);
    check("K", quarter, tolerance::ELLIPTIC_K);
}

#[test]
fn invalid_lattices_are_refused() {
    let parameter = |result: Result<Weierstrass, toytop::ParameterError>| result.unwrap_err().parameter();
    assert_eq!(parameter(Weierstrass::from_gaps(0.0, 1.0)), "upper_gap");
    assert_eq!(parameter(Weierstrass::from_gaps(1.0, f64::NAN)), "lower_gap");
    assert_eq!(parameter(Weierstrass::from_roots([0.0, 1.0, -1.0])), "upper_gap");
    assert_eq!(parameter(Weierstrass::from_roots([0.0, f64::NAN, -1.0])), "roots");
    assert_eq!(Jacobi::new(0.5, 0.6).unwrap_err().parameter(), "m1");
    assert_eq!(Jacobi::new(1.0, 0.0).unwrap_err().parameter(), "m1");
    // at the limits of the domain the values are finite
    for gaps in [(1e90, 1e-200), (1e-200, 1e90)] {
        let lattice = Weierstrass::from_gaps(gaps.0, gaps.1).unwrap();
        let [real, imaginary] = lattice.half_periods();
        let z = Complex::new(0.3 * real, 0.4 * imaginary);
        for value in [lattice.p(z), lattice.p_prime(z), lattice.zeta(z), lattice.ln_sigma(z)] {
            assert!(value.re.is_finite() && value.im.is_finite(), "{gaps:?}: {value:?}");
        }
    }
}
