//! The truth against motions known to 30 digits, and against itself on other panels.

use super::*;
use crate::study::random::Random;
use crate::study::vectors::{self, number, periods};
use serde_json::Value;
use toytop::{Phi, Signs, Start};

/// A vector that is given by branch points, all exact in f64.
fn vector(name: &str) -> (Numbers, Value) {
    let json = vectors::read(name);
    let params = |key: &str| number(&json["params"][key]);
    let sign = |key: &str| if json[key] == -1 { Sign::Minus } else { Sign::Plus };
    let numbers = Numbers {
        a: params("A"),
        c: params("C"),
        s: params("s"),
        p: params("p"),
        g: 1.0,
        e: ["e1", "e2", "e3"].map(|key| number(&json[key])),
        signs: Signs { l_plus_n: sign("s_plus"), l_minus_n: sign("s_minus") },
        start: Start {
            theta: params("theta0"),
            arg_alpha: params("arg_alpha0"),
            arg_beta: params("arg_beta0"),
        },
    };
    (numbers, json)
}

/// 2 √(|Δα|² + |Δβ|²) against the strings of a sample, which are read as f64.
fn error(phi: &Phi<Dd>, sample: &Value) -> f64 {
    let part = |found: Dd, key: &str, i: usize| (found - number(&sample[key][i]).into()).to_f64().powi(2);
    let Phi { alpha, beta } = phi;
    let sum = part(alpha.re, "alpha", 0)
        + part(alpha.im, "alpha", 1)
        + part(beta.re, "beta", 0)
        + part(beta.im, "beta", 1);
    2.0 * sum.sqrt()
}

#[test]
fn samples_known_to_thirty_digits() {
    let rule = Rule::new();
    let names = [
        "generic_pp",
        "generic_pm",
        "generic_mp",
        "generic_mm",
        "small_A",
        "lagrange",
        "fast_spin",
        "e3_1",
        "e1_m1",
        "e2_1",
        "planar",
        "near_vertical_pass",
        "near_downward_pass",
        "near_separatrix_e2_1",
        "near_separatrix_straddle",
        "tiny_nutation",
    ];
    let mut checked = 0;
    for name in names {
        let (numbers, json) = vector(&format!("exact_{name}"));
        let exact = Exact::new(&numbers, &rule);
        let (start, period) = (exact.start(), exact.period());
        let relative = (period.t.to_f64() / number(&json["period"]["T"]) - 1.0).abs();
        assert!(relative < 3e-16, "{name}: period off by {relative:e}");
        let samples = json["samples"].as_array().expect("samples").iter();
        let huge = json["huge_samples"].as_array().expect("samples").iter();
        for sample in samples.chain(huge) {
            let t = number(&sample["t"]);
            let periods = periods(sample);
            // where it is in the period: time after the start, less whole periods, by steps of bisection
            let rest = (Dd::from(t) - period.t * periods.into()).to_f64();
            let place = by_bisection(&exact, &start, rest);
            let there = exact.go(&start, place);
            let point = exact.at_time(&exact.later(&there, &period, periods), place, t);
            let error = error(&exact.phi(&point, t), sample);
            assert!(error < 4e-16, "{name} at {t}: {error:e}");
            checked += 1;
        }
    }
    assert!(checked > 300);
}

/// χ at a time, to some 1e-6.
fn by_bisection(exact: &Exact<'_>, start: &Point, t: f64) -> Dd {
    let (mut low, mut high) = (start.chi.to_f64() - 12.0, start.chi.to_f64() + 12.0);
    while high - low > 1e-6 {
        let middle = 0.5 * (low + high);
        if exact.go(start, middle.into()).t.to_f64() < t { low = middle } else { high = middle }
    }
    low.into()
}

/// With other panels what changes is the error of the quadrature. It is some 1e-28 of what is integrated: after 10^9
/// periods still below the rounding of f64.
#[test]
fn other_panels_the_same_truth() {
    let rule = Rule::new();
    let mut worst = [0.0_f64; 3];
    for stream in 0..300 {
        let numbers = Numbers::random(&mut Random::new(7, stream));
        let exact = Exact::new(&numbers, &rule);
        if exact.e2_minus_e1 == Dd::ZERO || exact.e3_minus_e2 == Dd::ZERO {
            continue;
        }
        let finer = Exact { depths: exact.depths.map(|depth| 0.4 * depth), ..exact.clone() };
        let [(t, alpha, beta), (finer_t, finer_alpha, finer_beta)] = [exact, finer].map(|exact| {
            let Point { t, turned: [alpha, beta], .. } = exact.period();
            (t, alpha, beta)
        });
        let off = [t - finer_t, alpha - finer_alpha, beta - finer_beta].map(|off| off.abs().to_f64());
        let size = [t.to_f64(), 1.0 + alpha.abs().to_f64(), 1.0 + beta.abs().to_f64()];
        for ((worst, off), size) in worst.iter_mut().zip(off).zip(size) {
            *worst = worst.max(off / size);
        }
    }
    assert!(worst.iter().all(|worst| *worst < 1e-26 && *worst > 0.0), "{worst:?}");
}
