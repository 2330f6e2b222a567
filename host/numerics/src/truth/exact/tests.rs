//! Tests of the truth against motions known to 30 digits, and against itself with other panels.

use super::*;
use crate::input::random::Random;
use crate::truth::precise::to_f64;
use crate::truth::vectors::{self, digits, error, number, relative, samples};
use serde_json::Value;
use toytop::{Signs, Start};

/// Reference vector that is given by branch points, all exact in f64.
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

#[test]
fn samples_known_to_thirty_digits() {
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
        let exact = Exact::new(&numbers);
        let period = exact.period().expect("a period");
        let off = relative(&period, &json["period"]["T"]);
        assert!(off < 1e-29, "{name}: period off by {off:e}");
        for sample in samples(&json) {
            let error = error(&exact.at(&digits(&sample["t"])), sample);
            assert!(error < 1e-28, "{name} at {}: {error:e}", sample["t"]);
            checked += 1;
        }
    }
    assert!(checked > 300);
}

/// With other panels only the error of the quadrature changes; at tick 2^62 it is still below 1e-15 rad.
#[test]
fn other_panels_the_same_truth() {
    let mut worst = 0.0_f64;
    for stream in 0..60 {
        let numbers = Numbers::random(&mut Random::new(7, stream));
        let exact = Exact::new(&numbers);
        if exact.course() != Course::Nutating {
            continue;
        }
        let finer = exact.clone().with_passage(1);
        let [Some(passage), Some(finer)] = [&exact.passage, &finer.passage] else { panic!("both nutate") };
        for (i, (a, b)) in passage.half.iter().zip(&finer.half).enumerate() {
            let size = if i == 0 { to_f64(a) } else { 1.0 + to_f64(a).abs() };
            worst = worst.max(to_f64(&(a - b)).abs() / size);
        }
    }
    assert!(worst < 1e-35 && worst > 0.0, "{worst:e}");
}

/// The time of the place at a time is this time, also at large times.
#[test]
fn a_place_and_its_time() {
    let mut worst = 0.0_f64;
    for stream in 0..60 {
        let mut random = Random::new(8, stream);
        let exact = Exact::new(&Numbers::random(&mut random));
        let (Some(period), Some(passage)) = (exact.period(), &exact.passage) else { continue };
        for time in [random.share(), -random.share(), 1e15 * random.share()] {
            let time = &period * precise(time);
            let (place, [t, alpha, _]) = passage.at(&exact.law, &exact.coarse, &time);
            let [back, alpha_back, _] = passage.passed(&exact.law, &place);
            worst = worst.max(to_f64(&((&back - &time) / &period)).abs());
            assert!(to_f64(&((t - time) / &period)).abs() < 1e-40);
            assert!(to_f64(&(alpha - alpha_back)).abs() < 1e-20);
        }
    }
    assert!(worst < 1e-20, "{worst:e}");
}
