//! Section 4: the class, angle and velocity of the tip are compared with the sampled curve.

use proptest::prelude::*;
use toytop::{Complex, FirstIntegrals, Motion, Signs, Stepper, TipClass};
use toytop_tests::{DIFFERENT, SAME, by_branch_points, check_all, keep, tolerance, top_of, vectors};

fn motion(e: [f64; 3], signs: Signs) -> Motion {
    by_branch_points(&top_of([1.1, 0.8, 0.6, 0.9], 1.0), e, signs)
}

/// Rate φ' = (l - nu)/(A(1 - u²)) of the tip angle at a tilt (equation (4.1)).
fn rate(motion: &Motion, u: f64) -> f64 {
    let FirstIntegrals { l, n, .. } = motion.first_integrals();
    (l - n * u) / (motion.top().transverse_inertia() * (1.0 - u * u))
}

/// Height u = l/n at which the angle changes direction (equation (4.2)).
fn turning_height(motion: &Motion) -> f64 {
    motion.first_integrals().l / motion.first_integrals().n
}

/// Tip position c and velocity c' at `count` instants of a period (or of ten units of time).
fn sampled(motion: &Motion, count: u32) -> Vec<(Complex<f64>, Complex<f64>)> {
    let time = motion.period_advance().map_or(10.0, |advance| advance.period);
    let mut stepper = Stepper::<f64>::new(motion);
    let samples = (0..count).map(|_| {
        let tip = (stepper.tip(), stepper.tip_velocity());
        stepper.step(time / f64::from(count));
        tip
    });
    samples.collect()
}

/// Whether the angle decreases on some part of the sampled curve and increases on another.
fn runs_back(motion: &Motion) -> bool {
    let turning = |(c, velocity): (Complex<f64>, Complex<f64>)| (c.conj() * velocity).im;
    let all: Vec<f64> = sampled(motion, 4000).into_iter().map(turning).collect();
    let largest = all.iter().fold(0.0_f64, |largest, x| largest.max(x.abs()));
    all.iter().any(|&x| x > 1e-9 * largest) && all.iter().any(|&x| x < -1e-9 * largest)
}

proptest! {
    #![proptest_config(crate::motion::random_tops::config(400))]

    /// Proposition 6: the paper's condition on e₃, the equivalent one on l/n, equation (4.2), and the sampled curve
    /// agree.
    #[test]
    fn loops_are_where_prop_6_states(
        (low, width, height) in (-0.98_f64..0.9, 0.02_f64..0.98, -2.5_f64..1.5),
        same in any::<bool>(),
    ) {
        let e2 = low + (0.98 - low) * width;
        let e = [low, e2, 1.0 + 10_f64.powf(height)];
        let motion = motion(e, if same { SAME } else { DIFFERENT });
        let margin = e[2] * (e2 - low) - (1.0 - low * e2);
        prop_assume!(margin.abs() > 1e-4);
        let loops = !same && margin > 0.0;
        let height = turning_height(&motion);
        prop_assert_eq!(low < height && height < e2, loops);
        prop_assert_eq!(motion.tip_class(), if loops { TipClass::Loops } else { TipClass::Smooth });
        prop_assert_eq!(runs_back(&motion), loops);
        if loops {
            // equation (4.2) at the height where the angle changes direction, and φ' = 0 there
            let integrals = motion.first_integrals();
            let ratio = integrals.l_plus_n / integrals.l_minus_n;
            prop_assert!(((height + 1.0) / (height - 1.0) - ratio).abs() < 1e-11 * ratio.abs());
            prop_assert!(rate(&motion, height).abs() < 1e-12 * rate(&motion, e2).abs().max(1.0));
        }
    }

    /// On the border e₃ = (1 - e₁e₂)/(e₂ - e₁) there is a cusp: the velocity of the tip is 0 at u = e₂, and only
    /// there.
    #[test]
    fn cusps_are_where_prop_6_states((low, width) in (-0.95_f64..0.9, 0.1_f64..0.9)) {
        let e2 = low + (0.97 - low) * width;
        let motion = motion([low, e2, (1.0 - low * e2) / (e2 - low)], DIFFERENT);
        prop_assert_eq!(motion.tip_class(), TipClass::Cusp);
        prop_assert!((turning_height(&motion) - e2).abs() < 1e-13);
        let speeds: Vec<f64> = sampled(&motion, 1000).into_iter().map(|(_, velocity)| velocity.modulus()).collect();
        let fastest = speeds.iter().fold(0.0_f64, |fastest, x| fastest.max(*x));
        prop_assert!(speeds[500] < 1e-6 * fastest, "half a period: {:e}", speeds[500]);
        prop_assert!(speeds[0] > 1e-3 * fastest);
        prop_assert!(!runs_back(&motion));
    }
}

/// φ and c agree along a motion, φ is continuous, and φ' and c' are their derivatives.
#[test]
fn angle_and_velocity_are_derivatives() {
    let mut worst = [0.0_f64; 2];
    for vector in vectors::all() {
        let motion = vector.motion().unwrap();
        let scale = motion.top().tip_scale();
        let period = motion.period_advance().map_or(1.0, |advance| advance.period.min(10.0));
        let dt = period * 1e-4;
        let mut after = Stepper::<f64>::new(&motion);
        for _ in 0..15_000 {
            let before = after;
            after.step(dt);
            let middle = after;
            after.step(dt);
            let difference = (after.tip() - before.tip()).scaled(0.5 / dt);
            keep(&mut worst, [(difference - middle.tip_velocity()).modulus() * period / scale, 0.0]);
            let [Some(a), Some(b), Some(c)] = [before, middle, after].map(|at| at.tip_angle()) else {
                assert!(motion.regime().is_vertical());
                continue;
            };
            // c = ±ρ e^{iφ}
            let along: Complex<f64> = middle.tip() * Complex::cis(-b);
            assert!(along.im.abs() <= 1e-13 * scale, "{}", vector.name);
            assert!(motion.tip_class() == TipClass::ThroughOrigin || along.re >= 0.0, "{}", vector.name);
            // near the vertical φ' is large for a short time, so the comparison is made elsewhere
            if middle.tip().modulus() > 0.05 * scale {
                let slope = (c - a).to_radians() / (2.0 * dt);
                keep(&mut worst, [0.0, (slope - middle.tip_angle_rate()).abs() * period]);
            }
        }
    }
    check_all(["c'", "phi'"], worst, tolerance::TIP_CURVE_DERIVATIVES);
}

/// Classes of the curves in figures 2 and 3 of the paper, and of those that Proposition 6 does not cover.
#[test]
fn the_vectors_have_their_classes() {
    for (class, names) in [
        (TipClass::Smooth, "fig2_same_e3_1 fig2_same_e3_2 fig2_same_e3_100 fig3_diff_e3_1 fig3_diff_e3_1.1"),
        (TipClass::Smooth, "fig3_diff_e3_1.3 exact_e3_1"),
        (TipClass::Cusp, "fig3_diff_e3_1.85"),
        (TipClass::Loops, "fig3_diff_e3_2.5 fig3_diff_e3_3 generic_AneC"),
        (
            TipClass::ThroughOrigin,
            "vertical_pass_e2_1 e1_m1_l_eq_minus_n planar_e1m1_e2p1 exact_state_vertical",
        ),
        (TipClass::Circle, "regular_precession regular_precession_fast"),
        (TipClass::Spiral, "aperiodic aperiodic_AneC"),
        (TipClass::Point, "sleeping_stable sleeping_unstable hanging"),
    ] {
        for name in names.split(' ') {
            assert_eq!(vectors::motion(name).tip_class(), class, "{name}");
        }
    }
}
