//! Section 4: the curve of the tip, its angle, and the criterion for loops and cusps compared with the sampled curve.

use crate::full::solver;
use proptest::prelude::*;
use toytop::exact::tip_curve::{TipCurve, loop_margin};
use toytop::su2::{sphere_point, stereographic};
use toytop::{Complex, Motion, Sign, Signs, Start, Stepper, TipClass, Top, TopParameters};
use toytop_tests::{greater, tolerance, vectors};

const SAME: Signs = Signs { l_plus_n: Sign::Plus, l_minus_n: Sign::Plus };
const DIFFERENT: Signs = Signs { l_plus_n: Sign::Plus, l_minus_n: Sign::Minus };

fn top() -> Top {
    Top::sliding(&TopParameters {
        transverse_inertia: 1.1,
        axial_inertia: 0.8,
        com_height: 0.6,
        mass_moment: 0.9,
        gravity: 1.0,
        ..TopParameters::default()
    })
    .unwrap()
}

fn motion(e: [f64; 3], signs: Signs) -> Motion {
    Motion::from_branch_points(&top(), e, signs, &Start::default()).unwrap()
}

fn size(z: Complex<f64>) -> f64 {
    z.norm_squared().sqrt()
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

/// Proposition 4: the curve is the projection of -sr, and 2sαβ, and s 2z/(|z|² + 1) with z = β/δ, the image of 0
/// under the Möbius transformation and the stereographic image of -r; |c| = s√(1 - u²).
#[test]
fn prop_c_is_two_s_alpha_beta() {
    let mut worst = 0.0_f64;
    for vector in vectors::all().into_iter().filter(|vector| !vector.motion().unwrap().regime().is_vertical())
    {
        let motion = vector.motion().unwrap();
        let (curve, scale) = (TipCurve::new(&motion), motion.top().tip_scale());
        let mut stepper = Stepper::<f64>::new(&motion);
        for _ in 0..50 {
            stepper.step(0.05);
            let (phi, tip) = (stepper.orientation(), stepper.tip());
            let [r1, r2, u] = phi.axis();
            worst = greater(worst, size(tip - Complex::new(-scale * r1, -scale * r2)) / scale);
            let z = phi.moebius(Some(Complex::ZERO));
            let image = stereographic([-r1, -r2, -u]);
            if let (Some(z), Some(image)) = (z, image) {
                // near the pole, 1 - ζ has lost digits in proportion to 1 + |z|²
                let scale = (1.0 + z.norm_squared()) * (1.0 + size(z));
                worst = greater(worst, size(z - image) / scale);
            }
            let [xi, eta, _] = sphere_point(z);
            worst = greater(worst, size(tip - Complex::new(scale * xi, scale * eta)) / scale);
            if u.abs() < 0.9 {
                worst = greater(worst, (size(tip) - curve.rho(u)).abs() / scale);
            }
        }
    }
    tolerance::GROUP.check("c", worst);
}

/// Equation (4.1): φ' and dφ/du along the full solution are functions of u alone.
#[test]
fn prop_eqn_dphi() {
    let mut worst = 0.0_f64;
    for e in [[-0.3, 0.6, 1.4], [0.7, 0.9, 2.5], [-0.8, -0.1, 6.0], [0.1, 0.8, 1.0]] {
        for signs in [SAME, DIFFERENT] {
            let motion = motion(e, signs);
            let (curve, mut path) = (TipCurve::new(&motion), solver(&motion));
            for i in 1..20 {
                let state = path.advance_to(0.31 * f64::from(i)).unwrap();
                let [r1, r2, u] = state.axis();
                let [w1, w2, w3] = state.omega;
                // r' = ω × r, and φ' = (r₁ r₂' - r₂ r₁')/(r₁² + r₂²)
                let (v1, v2) = (w2 * u - w3 * r2, w3 * r1 - w1 * u);
                let rate = (r1 * v2 - r2 * v1) / (r1 * r1 + r2 * r2);
                worst = greater(worst, (curve.rate(u) - rate).abs() / rate.abs().max(1.0));
                let udot = state.axis_height_rate();
                let slope = curve.slope(u, udot) * udot;
                worst = greater(worst, (slope - rate).abs() / rate.abs().max(1.0));
            }
        }
    }
    tolerance::EQUATIONS.check("dφ", worst);
}

proptest! {
    #![proptest_config(crate::properties::config(400))]

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
        let (curve, points) = (TipCurve::new(&motion), motion.branch_points());
        let margin = loop_margin(&points);
        let direct = e[2] * (e2 - low) - (1.0 - low * e2);
        prop_assert!((margin - direct).abs() < 1e-14 * e[2]);
        prop_assume!(margin.abs() > 1e-4);
        let loops = !same && margin > 0.0;
        let height = curve.turning_height().unwrap();
        prop_assert_eq!(low < height && height < e2, loops);
        prop_assert_eq!(motion.tip_class(), if loops { TipClass::Loops } else { TipClass::Smooth });
        prop_assert_eq!(curve.class(), motion.tip_class());
        prop_assert_eq!(runs_back(&motion), loops);
        if loops {
            // equation (4.2) at the height where the angle changes direction, and φ' = 0 there
            let integrals = motion.first_integrals();
            let ratio = integrals.l_plus_n / integrals.l_minus_n;
            prop_assert!(((height + 1.0) / (height - 1.0) - ratio).abs() < 1e-11 * ratio.abs());
            prop_assert!(curve.rate(height).abs() < 1e-12 * curve.rate(e2).abs().max(1.0));
        }
    }

    /// On the border e₃ = (1 - e₁e₂)/(e₂ - e₁) there is a cusp: the velocity of the tip is 0 at u = e₂, and only
    /// there.
    #[test]
    fn prop_cusps((low, width) in (-0.95_f64..0.9, 0.1_f64..0.9)) {
        let e2 = low + (0.97 - low) * width;
        let motion = motion([low, e2, (1.0 - low * e2) / (e2 - low)], DIFFERENT);
        prop_assert_eq!(motion.tip_class(), TipClass::Cusp);
        let curve = TipCurve::new(&motion);
        prop_assert_eq!(curve.class(), TipClass::Cusp);
        prop_assert!((curve.turning_height().unwrap() - e2).abs() < 1e-13);
        let speeds: Vec<f64> = sampled(&motion, 1000).into_iter().map(|(_, velocity)| size(velocity)).collect();
        let fastest = speeds.iter().fold(0.0_f64, |fastest, x| fastest.max(*x));
        prop_assert!(speeds[500] < 1e-6 * fastest, "half a period: {:e}", speeds[500]);
        prop_assert!(speeds[0] > 1e-3 * fastest);
        prop_assert!(!runs_back(&motion));
    }
}

/// For e₁ = e₂ the curve is a circle of radius s√(1 - e²), at constant speed.
#[test]
fn tip_of_regular_precession_is_a_circle() {
    for signs in [SAME, DIFFERENT] {
        let motion = motion([0.5, 0.5, 1.7], signs);
        let curve = TipCurve::new(&motion);
        assert_eq!((motion.tip_class(), curve.class()), (TipClass::Circle, TipClass::Circle));
        let radius = 0.6 * 0.75_f64.sqrt();
        assert!(curve.bounding_circles().iter().all(|r| (r - radius).abs() < 1e-15));
        for (c, velocity) in sampled(&motion, 100) {
            assert!((size(c) - radius).abs() < 1e-15);
            assert!((size(velocity) - radius * curve.rate(0.5).abs()).abs() < 1e-14);
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
        let curve = TipCurve::new(&motion);
        assert_eq!((motion.tip_class(), curve.class()), (TipClass::ThroughOrigin, TipClass::ThroughOrigin));
        assert!(curve.bounding_circles().contains(&0.0));
        let samples = sampled(&motion, 1000);
        assert!(size(samples[at].0) < 1e-6, "{:?}", samples[at]);
        let (before, after) = (samples[(at + 990) % 1000], samples[at + 10]);
        // the direction of c is reversed, the velocity is continuous, and φ' is finite
        assert!((before.0.conj() * after.0).re < 0.0 && (before.1.conj() * after.1).re > 0.0);
        assert!(curve.rate(if at == 0 { -1.0 } else { 1.0 }).is_finite());
    }
    let straight = motion([-1.0, 1.0, 1.6], SAME);
    assert_eq!(TipCurve::new(&straight).class(), TipClass::ThroughOrigin);
    assert_eq!(TipCurve::new(&straight).turning_height(), None);
    let samples = sampled(&straight, 1000);
    let far = samples.iter().map(|(c, _)| *c).max_by(|a, b| size(*a).total_cmp(&size(*b))).unwrap();
    assert!((size(far) - 0.6).abs() < 1e-5, "out to s");
    assert!(samples.iter().all(|(c, _)| (far.conj() * *c).im.abs() < 1e-15));
}

/// For e₃ = 1, w₊₁ = 0 and l = n, the curve is smooth for either free sign (figures 2 and 3 begin with the same
/// curve), and with C = A the argument of β is constant.
#[test]
fn tip_at_e3_equal_to_one() {
    let spherical = Top::sliding(&TopParameters {
        transverse_inertia: 1.0,
        axial_inertia: 1.0,
        com_height: 1.0,
        mass_moment: 1.0,
        gravity: 1.0,
        ..TopParameters::default()
    })
    .unwrap();
    let [first, second] = [SAME, DIFFERENT].map(|signs| {
        let start = Start { arg_beta: 0.4, ..Start::default() };
        Motion::from_branch_points(&spherical, [0.7, 0.9, 1.0], signs, &start).unwrap()
    });
    for motion in [&first, &second] {
        let curve = TipCurve::new(motion);
        assert_eq!(motion.first_integrals().l_minus_n, 0.0);
        assert_eq!((motion.tip_class(), curve.class()), (TipClass::Smooth, TipClass::Smooth));
        assert_eq!(curve.turning_height(), Some(1.0));
        assert!(!runs_back(motion));
        let mut stepper = Stepper::<f64>::new(motion);
        for _ in 0..8000 {
            stepper.step(0.001);
            assert!((stepper.orientation().beta.arg() - 0.4).abs() < 1e-12);
        }
    }
    for (one, other) in sampled(&first, 4000).into_iter().zip(sampled(&second, 4000)) {
        assert!(size(one.0 - other.0) < 1e-12);
    }
}

/// For e₂ = e₃ = 1 the tip tends to the centre without reaching it; upright or hanging, it stays at the centre.
#[test]
fn tip_spirals_in_or_rests() {
    let aperiodic = motion([0.2, 1.0, 1.0], SAME);
    let curve = TipCurve::new(&aperiodic);
    assert_eq!((aperiodic.tip_class(), curve.class()), (TipClass::Spiral, TipClass::Spiral));
    let radii: Vec<f64> = sampled(&aperiodic, 200).into_iter().map(|(c, _)| size(c)).collect();
    assert!(radii.windows(2).skip(1).all(|pair| pair[1] < pair[0]) && radii[199] > 0.0 && radii[199] < 0.01);
    let start = Start { theta: std::f64::consts::PI, ..Start::default() };
    let sleeping = Motion::from_branch_points(&top(), [0.2, 1.0, 1.0], SAME, &start).unwrap();
    let hanging = motion([-1.0, -1.0, 1.5], SAME);
    let stable = motion([1.0, 1.0, 1.5], SAME);
    for motion in [&sleeping, &hanging, &stable] {
        assert_eq!((motion.tip_class(), TipCurve::new(motion).class()), (TipClass::Point, TipClass::Point));
        assert!(sampled(motion, 20).into_iter().all(|(c, velocity)| size(c) == 0.0 && size(velocity) == 0.0));
    }
}

/// Figures 2 and 3: both criteria for the paper's own motions.
#[test]
fn figures_2_and_3_by_both_criteria() {
    let mut cusps = 0;
    for vector in vectors::all().into_iter().filter(|vector| vector.name.starts_with("fig")) {
        let motion = vector.motion().unwrap();
        assert_eq!(TipCurve::new(&motion).class(), motion.tip_class(), "{}", vector.name);
        cusps += u32::from(motion.tip_class() == TipClass::Cusp);
    }
    assert_eq!(cusps, 1);
}
