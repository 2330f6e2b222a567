//! Section 4: the curve of the tip, its angle and its velocity, and the criterion for loops and cusps compared with the sampled curve.

use proptest::prelude::*;
use toytop::{Complex, InitialPhases, Motion, Signs, Stepper, TipClass, Top};
use toytop_tests::{DIFFERENT, SAME, by_branch_points, keep, top_of, vectors};

fn top() -> Top {
    top_of([1.1, 0.8, 0.6, 0.9], 1.0)
}

fn motion(e: [f64; 3], signs: Signs) -> Motion {
    by_branch_points(&top(), e, signs)
}

/// A(1 - u²)φ' = l - nu (equation (4.1)) at a tilt.
fn turning(motion: &Motion, u: f64) -> f64 {
    motion.first_integrals().l - motion.first_integrals().n * u
}

/// Rate φ' of the tip angle at a tilt.
fn rate(motion: &Motion, u: f64) -> f64 {
    turning(motion, u) / (motion.top().transverse_inertia() * (1.0 - u * u))
}

/// Height u = l/n at which the angle changes direction (equation (4.2)).
fn turning_height(motion: &Motion) -> f64 {
    motion.first_integrals().l / motion.first_integrals().n
}

/// Tip position c and velocity c' at `count` instants of a period (or of ten units of time).
fn sampled(motion: &Motion, count: u32) -> Vec<(Complex<f64>, Complex<f64>)> {
    let time = motion.period_advance().map_or(10.0, |averages| averages.period);
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
    #![proptest_config(crate::motion::properties::config(400))]

    /// Proposition 6: the paper's condition on e₃, the equivalent one on l/n, equation (4.2), and the sampled curve
    /// agree.
    #[test]
    fn prop_loop_cusp_or_wobbly_arc(
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
    fn prop_cusps((low, width) in (-0.95_f64..0.9, 0.1_f64..0.9)) {
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
        let period = motion.period_advance().map_or(1.0, |averages| averages.period.min(10.0));
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
    assert!(worst[0] < 2e-3 && worst[1] < 2e-2 && worst.iter().all(|error| *error > 1e-9), "{worst:?}");
}

/// Classes of the curves in figures 2 and 3 of the paper.
#[test]
fn the_figures_of_the_paper() {
    for (class, names) in [
        (
            TipClass::Smooth,
            "fig2_same_e3_1 fig2_same_e3_2 fig2_same_e3_100 fig3_diff_e3_1 fig3_diff_e3_1.1 fig3_diff_e3_1.3",
        ),
        (TipClass::Cusp, "fig3_diff_e3_1.85"),
        (TipClass::Loops, "fig3_diff_e3_2.5 fig3_diff_e3_3 generic_AneC"),
        (TipClass::ThroughOrigin, "vertical_pass_e2_1 e1_m1_l_eq_minus_n planar_e1m1_e2p1"),
    ] {
        for name in names.split(' ') {
            assert_eq!(vectors::motion(name).tip_class(), class, "{name}");
        }
    }
}

/// For e₁ = e₂ the curve is a circle of radius s√(1 - e²), at constant speed.
#[test]
fn tip_of_regular_precession_is_a_circle() {
    for signs in [SAME, DIFFERENT] {
        let motion = motion([0.5, 0.5, 1.7], signs);
        assert_eq!(motion.tip_class(), TipClass::Circle);
        let radius = 0.6 * 0.75_f64.sqrt();
        for (c, velocity) in sampled(&motion, 100) {
            assert!((c.modulus() - radius).abs() < 1e-15);
            assert!((velocity.modulus() - radius * rate(&motion, 0.5).abs()).abs() < 1e-14);
            assert!((c.conj() * velocity).re.abs() < 1e-15);
        }
    }
}

/// For e₂ = 1 or e₁ = -1 the curve passes through the centre, where φ jumps by half a turn unless ρ has a sign; with
/// both it is a straight segment.
#[test]
fn tip_through_the_centre() {
    for (e, at) in [([0.2, 1.0, 1.6], 500), ([-1.0, 0.4, 1.6], 0)] {
        let motion = motion(e, DIFFERENT);
        let class = TipClass::ThroughOrigin;
        assert_eq!(motion.tip_class(), class);
        let samples = sampled(&motion, 1000);
        assert!(samples[at].0.modulus() < 1e-6, "{:?}", samples[at]);
        let (before, after) = (samples[(at + 990) % 1000], samples[at + 10]);
        // the direction of c is reversed, the velocity is continuous, and φ' is finite there
        assert!((before.0.conj() * after.0).re < 0.0 && (before.1.conj() * after.1).re > 0.0);
        assert_eq!(turning(&motion, if at == 0 { -1.0 } else { 1.0 }), 0.0);
    }
    let straight = motion([-1.0, 1.0, 1.6], SAME);
    assert_eq!(straight.tip_class(), TipClass::ThroughOrigin);
    assert_eq!((straight.first_integrals().l, straight.first_integrals().n), (0.0, 0.0));
    let samples = sampled(&straight, 1000);
    let far = samples.iter().map(|(c, _)| *c).max_by(|a, b| a.modulus().total_cmp(&b.modulus())).unwrap();
    assert!((far.modulus() - 0.6).abs() < 1e-5, "out to s");
    assert!(samples.iter().all(|(c, _)| (far.conj() * *c).im.abs() < 1e-15));
}

/// For e₃ = 1, w₊₁ = 0 and l = n, the curve is smooth for either free sign (figures 2 and 3 begin with the same
/// curve), and with C = A the argument of β is constant.
#[test]
fn tip_at_e3_equal_to_one() {
    let spherical = top_of([1.0, 1.0, 1.0, 1.0], 1.0);
    let [first, second] = [SAME, DIFFERENT].map(|signs| {
        let start = InitialPhases { arg_beta: 0.4, ..InitialPhases::default() };
        Motion::from_branch_points(&spherical, [0.7, 0.9, 1.0], signs, &start).unwrap()
    });
    for motion in [&first, &second] {
        assert_eq!(motion.first_integrals().l_minus_n, 0.0);
        assert_eq!(motion.tip_class(), TipClass::Smooth);
        assert_eq!(turning_height(motion), 1.0);
        assert!(!runs_back(motion));
        let mut stepper = Stepper::<f64>::new(motion);
        for _ in 0..8000 {
            stepper.step(0.001);
            assert!((stepper.orientation().beta.arg() - 0.4).abs() < 1e-12);
        }
    }
    for (one, other) in sampled(&first, 4000).into_iter().zip(sampled(&second, 4000)) {
        assert!((one.0 - other.0).modulus() < 1e-12);
    }
}

/// For e₂ = e₃ = 1 the tip tends to the centre without reaching it; upright or hanging, it stays at the centre.
#[test]
fn tip_spirals_in_or_rests() {
    let aperiodic = motion([0.2, 1.0, 1.0], SAME);
    assert_eq!(aperiodic.tip_class(), TipClass::Spiral);
    let radii: Vec<f64> = sampled(&aperiodic, 200).into_iter().map(|(c, _)| c.modulus()).collect();
    assert!(radii.windows(2).skip(1).all(|pair| pair[1] < pair[0]) && radii[199] > 0.0 && radii[199] < 0.01);
    let start = InitialPhases { theta: std::f64::consts::PI, ..InitialPhases::default() };
    let sleeping = Motion::from_branch_points(&top(), [0.2, 1.0, 1.0], SAME, &start).unwrap();
    let hanging = motion([-1.0, -1.0, 1.5], SAME);
    let stable = motion([1.0, 1.0, 1.5], SAME);
    for motion in [&sleeping, &hanging, &stable] {
        assert_eq!(motion.tip_class(), TipClass::Point);
        assert!(
            sampled(motion, 20)
                .into_iter()
                .all(|(c, velocity)| c.modulus() == 0.0 && velocity.modulus() == 0.0)
        );
    }
}
