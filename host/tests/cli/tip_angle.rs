//! Tests of the tip angle φ of the ephemeris against that of the stepper, which follows it from step to step.

use super::{branch_points, samples, scenario};
use std::f64::consts::PI;

/// Case: e1, e2, e3, sign of l - n, θ(0), times.
type Case = ([f64; 3], i32, f64, &'static str);

const CASES: [Case; 12] = [
    ([0.2, 0.8, 1.5], 1, 0.4, "-700,-3.1,0,0.1,2,900"),
    ([0.2, 0.8, 3.0], -1, -2.0, "-700,-3.1,0,0.1,2,900"),
    // through the centre at e1, at e2, at both, and starting there
    ([-1.0, 0.6, 1.4], -1, 0.4, "-650,-3.1,0,0.1,2,900"),
    ([-0.3, 1.0, 1.3], 1, PI, "-700,-3.1,0,0.1,2,900"),
    ([-1.0, 1.0, 1.3], 1, 0.0, "-700,-3.1,0,0.1,2,900"),
    // past the centre at so small a distance that φ changes by almost π in a very short time
    ([0.1, 0.999_999_999_999, 1.5], 1, 0.4, "-701,-3.1,0,0.1,2,903"),
    ([0.2, 0.9995, 1.0005], 1, 0.4, "-700,-3.1,0,0.1,2,900"),
    // regular precession, slow and fast
    ([0.5, 0.5, 1.7], -1, 0.4, "-700,-3.1,0,0.1,2,900"),
    ([0.5, 0.5, 1.7], 1, 0.4, "-700,-3.1,0,0.1,2,900"),
    // aperiodic: rising, falling before it rises, falling very little
    ([0.2, 1.0, 1.0], 1, 0.4, "-700,-50,-3.1,0,0.1,2,30,60,900"),
    ([-0.5, 1.0, 1.0], -1, -3.0, "-700,-50,-3.1,0,0.1,2,30,60,900"),
    ([0.999, 1.0, 1.0], 1, -1.0, "-4000,-300,-3.1,0,2,300,1200,4000"),
];

#[test]
fn tip_angle_agrees_with_the_stepper() {
    for (index, (e, minus, theta, times)) in CASES.into_iter().enumerate() {
        let start = format!("nutation_phase = {theta}\narg_alpha = 2.9\narg_beta = 1.1\n");
        let file = scenario(&format!("tip_angle{index}"), &(branch_points(e, minus) + &start));
        let [stepped, double, single] = [
            &["--method", "stepper", "--steps-per-period", "16384"][..],
            &["--scalar", "f64"],
            &["--scalar", "f32"],
        ]
        .map(|arguments| samples(&file, times, arguments));
        for ((stepped, double), single) in stepped.iter().zip(double).zip(single) {
            let phi = stepped["phi"].as_f64().expect("a number");
            let off = [double, single].map(|sample| (sample["phi"].as_f64().expect("a number") - phi).abs());
            assert!(off[0] < 1e-9 && off[1] < 2e-5, "{e:?} at {}: {phi}, off by {off:?}", stepped["t"]);
        }
    }
}

/// At times that no stepper reaches, φ grows at the constant rate (l + n)/(4A) after the axis has risen.
#[test]
fn an_aperiodic_motion_goes_on_for_ever() {
    let file = scenario("tip_angle_for_ever", &branch_points([0.2, 1.0, 1.0], 1));
    let phi = |times: &str| -> Vec<f64> {
        samples(&file, times, &[]).iter().map(|sample| sample["phi"].as_f64().expect("a number")).collect()
    };
    let found = phi("1000,1e9,-1000,-1e9");
    // l + n = √(2Ap(1+e1)(1+e2)(1+e3))
    let rate = (2.0 * 1.1 * 0.9 * 1.2 * 4.0_f64).sqrt() / 4.4;
    for pair in found.chunks(2) {
        let growth = (pair[1] - pair[0]).abs() / (1e9 - 1e3);
        assert!((growth / rate - 1.0).abs() < 1e-15, "{growth} {rate}");
    }
}
