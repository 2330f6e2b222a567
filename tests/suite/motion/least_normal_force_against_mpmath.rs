//! The least normal force is compared with stationary points at 400 digits, and with the border where the top leaves the plane.

use toytop::{Release, Signs};
use toytop_tests::vectors::{self, entries, number, triple};
use toytop_tests::{by_branch_points, released, top_of};

/// Least normal force against stationary points at 400 digits (`tests/reference/normal_force.py`): slender tops, down
/// to A/(ps) = 1e-6, and motions with several small differences.
#[test]
fn every_digit_is_right() {
    let json = vectors::json("normal_force.json");
    let cases = entries(&json["cases"]);
    let mut lifted = 0;
    for case in cases {
        let [a, p, s, least] = ["A", "p", "s", "least"].map(|key| number(&case[key]));
        let motion = by_branch_points(&top_of([a, a, s, p], 1.0), triple(&case["e"]), Signs::default());
        let force = motion.min_normal_force().unwrap();
        assert!((force / least - 1.0).abs() <= f64::EPSILON, "{case}: {force:e} against {least:e}");
        lifted += u32::from(force < 0.0);
    }
    assert_eq!(vectors::motion("lagrange_exact").min_normal_force(), None);
    assert!(cases.len() == 301 && lifted == 84, "{} cases, {lifted} of them lift off", cases.len());
}

/// Upright axis with a rate ω of the tilt: N = 1 - s ω²/g there, which is the minimum over the motion where it is not
/// positive. It is exactly 0 in the case of equality, and has the correct sign one unit in the last place of ω on
/// either side.
#[test]
fn the_force_on_the_border_of_lift_off_is_exactly_zero() {
    for (s, rate) in [(1.0, 1.0), (0.25, 2.0), (0.5, 3.0), (4.0, 1.5), (0.03125, 20.0), (1024.0, 0.0625)] {
        for (a, c, p) in [(1.0, 1.0, 1.0), (0.3, 0.2, 1.7), (1e-3, 2e-3, 0.4), (17.0, 5.0, 0.9)] {
            for spin in [5.0, 0.0, -3.0, 40.0, 0.7] {
                let force = |nutation: f64| {
                    let top = top_of([a, c, s, p], s * rate * rate);
                    let release = Release { spin, nutation, ..Release::default() };
                    released(&top, &release).min_normal_force().unwrap()
                };
                assert_eq!(force(rate).to_bits(), 0, "s = {s}, A = {a}, spin {spin}: {:e}", force(rate));
                for (near, sign) in [(rate.next_up(), -1.0), (rate.next_down(), 1.0)] {
                    // 1 - (1 + x)² to first order; for smaller ω the minimum is elsewhere and not larger
                    let expected = -2.0 * (near - rate) / rate;
                    let found = force(near);
                    let close = (found / expected - 1.0).abs() < 1e-9;
                    assert!(found * sign > 0.0 && (close || found < expected), "{found:e}, {expected:e}");
                    assert!(sign > 0.0 || close, "{found:e}, {expected:e}");
                }
            }
        }
    }
}
