//! Weierstrass's and Jacobi's functions against 30 digits (`tests/reference/elliptic.py`), and the relations between them.
//!
//! Errors of f(z) are in units of |f| + |z f'|: relative, but for what a rounding of z itself does.

use serde_json::Value;
use toytop::Complex;
use toytop::exact::{Jacobi, Weierstrass, carlson_rf};
use toytop_tests::{greater, tolerance, vectors};

fn number(json: &Value) -> f64 {
    vectors::number(json).unwrap()
}

fn complex(json: &Value) -> Complex<f64> {
    Complex::new(number(&json[0]), number(&json[1]))
}

fn modulus(z: Complex<f64>) -> f64 {
    z.re.hypot(z.im)
}

fn entries(json: &Value) -> &Vec<Value> {
    json.as_array().unwrap()
}

/// The lattices of the reference, each with its points (z, truth).
fn lattices() -> Vec<(Weierstrass, Value)> {
    let json = vectors::json("elliptic.json");
    let lattice = |json: &Value| {
        let gaps = ["upper_gap", "lower_gap"].map(|key| number(&json[key]));
        (Weierstrass::from_gaps(gaps[0], gaps[1]).unwrap(), json.clone())
    };
    entries(&json["lattices"]).iter().map(lattice).collect()
}

#[test]
fn weierstrass_against_thirty_digits() {
    let mut worst = [0.0_f64; 5];
    for (lattice, json) in lattices() {
        for point in entries(&json["points"]) {
            let z = complex(&point["z"]);
            let [p, slope, zeta, ln] = ["p", "p_prime", "zeta", "ln_sigma"].map(|key| complex(&point[key]));
            let [g2, _] = lattice.invariants();
            let curvature = (p * p).scaled(6.0) - Complex::new(0.5 * g2, 0.0);
            let size = modulus(z);
            let off = |ours: Complex<f64>, truth: Complex<f64>, rate: Complex<f64>| {
                modulus(ours - truth) / (modulus(truth) + size * modulus(rate))
            };
            // ln σ is given modulo 2πi
            let mut ours_ln = lattice.ln_sigma(z) - ln;
            ours_ln.im -= std::f64::consts::TAU * (ours_ln.im / std::f64::consts::TAU).round();
            let (sine, cosine) = ln.im.sin_cos();
            let sigma = Complex::new(cosine, sine).scaled(ln.re.exp());
            let in_range = ln.re.abs() < 300.0;
            let errors = [
                off(lattice.p(z), p, slope),
                off(lattice.p_prime(z), slope, curvature),
                off(lattice.zeta(z), zeta, p),
                // e^{ln σ} of the truth has the rounding of its own exponent
                if in_range {
                    off(lattice.sigma(z), sigma, sigma * (zeta + ln.scaled(1.0 / size)))
                } else {
                    0.0
                },
                modulus(ours_ln) / (1.0 + modulus(ln) + size * modulus(zeta)),
            ];
            for (worst, error) in worst.iter_mut().zip(errors) {
                *worst = greater(*worst, error);
            }
        }
    }
    for (what, error) in ["p", "p'", "zeta", "sigma", "ln sigma"].iter().zip(worst) {
        tolerance::WEIERSTRASS.check(what, error);
    }
}

#[test]
fn half_periods_and_quasi_periods() {
    let mut worst = 0.0_f64;
    for (lattice, json) in lattices() {
        let truth = ["half_periods", "quasi_periods"].map(|key| [0, 1].map(|i| number(&json[key][i])));
        for (ours, truth) in lattice.half_periods().iter().zip(truth[0]) {
            worst = greater(worst, (ours / truth - 1.0).abs());
        }
        // one of the two can be the small difference of large numbers
        let size = truth[1].iter().fold(0.0_f64, |size, eta| size.max(eta.abs()));
        for (ours, truth) in lattice.quasi_periods().iter().zip(truth[1]) {
            worst = greater(worst, (ours - truth).abs() / size);
        }
        // and back from the half periods
        let [real, imaginary] = lattice.half_periods();
        if real.max(imaginary) < 4.0 * real.min(imaginary) {
            let again = Weierstrass::from_half_periods(real, imaginary).unwrap();
            let scale = lattice.roots()[0] - lattice.roots()[2];
            for (ours, given) in again.roots().iter().zip(lattice.roots()) {
                worst = greater(worst, (ours - given).abs() / scale);
            }
        }
    }
    tolerance::HALF_PERIODS.check("half periods", worst);
}

/// ℘ takes e₁, e₂, e₃ at the half periods, where each difference has its double zero.
#[test]
fn roots_at_the_half_periods() {
    for (lattice, _) in lattices() {
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
}

#[test]
fn jacobi_against_thirty_digits() {
    let (mut functions, mut amplitude, mut quarter) = (0.0_f64, 0.0_f64, 0.0_f64);
    for json in entries(&vectors::json("elliptic.json")["jacobi"]) {
        let (m, m1) = (number(&json["m"]), number(&json["m1"]));
        let jacobi = Jacobi::new(m, m1).unwrap();
        quarter = greater(quarter, (jacobi.quarter_period() / number(&json["quarter_period"]) - 1.0).abs());
        assert!((carlson_rf(0.0, m1, 1.0) / jacobi.quarter_period() - 1.0).abs() < 1e-15, "{m1}");
        for point in entries(&json["points"]) {
            let [u, sn, cn, dn, am] = ["u", "sn", "cn", "dn", "am"].map(|key| number(&point[key]));
            let ours = jacobi.at(u);
            let off = |ours: f64, truth: f64, slope: f64| {
                let size = truth.abs() + (u * slope).abs();
                if size == 0.0 { ours.abs() } else { (ours - truth).abs() / size }
            };
            let errors =
                [off(ours.sn, sn, cn * dn), off(ours.cn, cn, sn * dn), off(ours.dn, dn, m * sn * cn)];
            functions = errors.into_iter().fold(functions, greater);
            amplitude = greater(amplitude, off(ours.am, am, dn));
        }
    }
    tolerance::JACOBI.check("sn, cn, dn", functions);
    tolerance::JACOBI.check("am", amplitude);
    tolerance::HALF_PERIODS.check("K", quarter);
}

/// ℘ is sn: ℘(z) = e₃ + (e₁ - e₃)/sn²(√(e₁ - e₃) z), on the real axis; two codes without a common line.
#[test]
fn weierstrass_and_jacobi_agree() {
    for (lattice, json) in lattices() {
        let [upper, lower] = ["upper_gap", "lower_gap"].map(|key| number(&json[key]));
        let whole = upper + lower;
        let jacobi = Jacobi::new(lower / whole, upper / whole).unwrap();
        for share in [0.1, 0.35, 0.8, 0.999] {
            let u = share * jacobi.quarter_period();
            let [_, _, from_e3] = lattice.differences(Complex::new(u / whole.sqrt(), 0.0));
            let sn = jacobi.at(u).sn;
            assert!(
                (from_e3.re * sn * sn / whole - 1.0).abs() < 1e-14 && from_e3.im.abs() < 1e-14 * from_e3.re
            );
        }
    }
}

#[test]
fn what_is_no_lattice_is_refused() {
    let parameter = |result: Result<Weierstrass, toytop::LaunchError>| result.unwrap_err().parameter();
    assert_eq!(parameter(Weierstrass::from_gaps(0.0, 1.0)), "upper_gap");
    assert_eq!(parameter(Weierstrass::from_gaps(1.0, f64::NAN)), "lower_gap");
    assert_eq!(parameter(Weierstrass::from_roots([0.0, 1.0, -1.0])), "upper_gap");
    assert_eq!(parameter(Weierstrass::from_half_periods(1.0, 201.0)), "imaginary_half_period");
    assert_eq!(parameter(Weierstrass::from_half_periods(-1.0, 1.0)), "real_half_period");
    assert_eq!(Jacobi::new(0.5, 0.6).unwrap_err().parameter(), "m1");
    assert_eq!(Jacobi::new(1.0, 0.0).unwrap_err().parameter(), "m1");
    // at the ends of the domain there are still numbers
    for gaps in [(1e90, 1e-200), (1e-200, 1e90)] {
        let lattice = Weierstrass::from_gaps(gaps.0, gaps.1).unwrap();
        let [real, imaginary] = lattice.half_periods();
        let z = Complex::new(0.3 * real, 0.4 * imaginary);
        for value in [lattice.p(z), lattice.p_prime(z), lattice.zeta(z), lattice.ln_sigma(z)] {
            assert!(value.re.is_finite() && value.im.is_finite(), "{gaps:?}: {value:?}");
        }
    }
}
