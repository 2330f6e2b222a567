//! Tip curve: angle, velocity, class, and the normal force.

use toytop::{Complex, Motion, Phase, Signs, Start, Stepper, TipClass};
use toytop_tests::{greater, vectors};

/// Tip of a stepper at one time.
struct Tip {
    c: Complex<f64>,
    velocity: Complex<f64>,
    angle: Option<Phase>,
    angle_rate: f64,
}

impl Tip {
    fn of(stepper: &Stepper<f64>) -> Self {
        let (c, velocity) = (stepper.tip(), stepper.tip_velocity());
        Self { c, velocity, angle: stepper.tip_angle(), angle_rate: stepper.tip_angle_rate() }
    }
}

/// φ and c agree along a motion, φ is continuous, and φ' and c' are their derivatives.
#[test]
fn angle_and_velocity_are_derivatives() {
    let (mut phi_worst, mut speed_worst) = (0.0_f64, 0.0_f64);
    for vector in vectors::all() {
        let motion = vector.motion().unwrap();
        let mut stepper = Stepper::<f64>::new(&motion);
        let dt = motion.period_advance().map_or(1.0, |averages| averages.period.min(10.0)) * 1e-4;
        let mut before = Tip::of(&stepper);
        for _ in 0..15_000 {
            stepper.step(dt);
            let middle = Tip::of(&stepper);
            stepper.step(dt);
            let after = Tip::of(&stepper);
            let difference = (after.c - before.c).scaled(0.5 / dt);
            let scale = motion.top().tip_scale() / (dt * 1e4);
            speed_worst = greater(speed_worst, (difference - middle.velocity).norm_squared().sqrt() / scale);
            if let (Some(a), Some(b), Some(c)) = (before.angle, middle.angle, after.angle) {
                // c = ±ρ e^{iφ}
                let direction = Complex::cis(-b);
                let along: Complex<f64> = middle.c * direction;
                assert!(along.im.abs() <= 1e-13 * motion.top().tip_scale(), "{}", vector.name);
                let passes = motion.tip_class() == TipClass::ThroughOrigin;
                assert!(passes || along.re >= 0.0, "{}", vector.name);
                let slope = (c - a).to_radians() / (2.0 * dt);
                // near the vertical φ' is large for a short time, so the comparison is made elsewhere
                if middle.c.modulus() > 0.05 * motion.top().tip_scale() {
                    phi_worst = greater(phi_worst, (slope - middle.angle_rate).abs() * dt * 1e4);
                }
            } else {
                assert!(motion.regime().is_vertical());
            }
            before = after;
        }
    }
    assert!(phi_worst < 2e-2 && phi_worst > 1e-9, "{phi_worst:e}");
    assert!(speed_worst < 2e-3 && speed_worst > 1e-9, "{speed_worst:e}");
}

/// Classes of the curves in figures 2 and 3 of the paper.
#[test]
fn the_figures_of_the_paper() {
    let expected = [
        ("fig2_same_e3_1", TipClass::Smooth),
        ("fig2_same_e3_2", TipClass::Smooth),
        ("fig2_same_e3_100", TipClass::Smooth),
        ("fig3_diff_e3_1", TipClass::Smooth),
        ("fig3_diff_e3_1.1", TipClass::Smooth),
        ("fig3_diff_e3_1.3", TipClass::Smooth),
        ("fig3_diff_e3_1.85", TipClass::Cusp),
        ("fig3_diff_e3_2.5", TipClass::Loops),
        ("fig3_diff_e3_3", TipClass::Loops),
        ("vertical_pass_e2_1", TipClass::ThroughOrigin),
        ("e1_m1_l_eq_minus_n", TipClass::ThroughOrigin),
        ("planar_e1m1_e2p1", TipClass::ThroughOrigin),
    ];
    for (name, class) in expected {
        assert_eq!(vectors::named(name).motion().unwrap().tip_class(), class, "{name}");
    }
}

/// The criterion against the sampled curve: φ' changes sign exactly where there are loops.
#[test]
fn loops_are_where_the_angle_runs_back() {
    let top = vectors::named("generic_AneC").top();
    let mut seen = [0_u32; 2];
    for i in 0..400 {
        let fraction = |k: f64| (f64::from(i) * k).fract();
        let e1 = -0.95 + 1.8 * fraction(0.618);
        let e2 = e1 + (0.98 - e1) * (0.05 + 0.9 * fraction(0.414));
        let e3 = 1.01 + 6.0 * fraction(0.732);
        let margin = e3 * (e2 - e1) - (1.0 - e1 * e2);
        if margin.abs() < 1e-2 {
            continue;
        }
        let signs = Signs { l_minus_n: toytop::Sign::Minus, ..Signs::default() };
        let motion = Motion::from_branch_points(&top, [e1, e2, e3], signs, &Start::default()).unwrap();
        let period = motion.period_advance().unwrap().period;
        let mut stepper = Stepper::<f64>::new(&motion);
        let (mut forward, mut backward) = (false, false);
        for _ in 0..2000 {
            stepper.step(period / 2000.0);
            let rate = stepper.tip_angle_rate();
            (forward, backward) = (forward || rate > 0.0, backward || rate < 0.0);
        }
        let loops = forward && backward;
        assert_eq!(motion.tip_class() == TipClass::Loops, loops, "{e1} {e2} {e3}");
        seen[usize::from(loops)] += 1;
    }
    assert!(seen[0] > 20 && seen[1] > 20, "both kinds must occur: {seen:?}");
}

/// Least normal forces of the paper's own motions: in figure 2, with e3 = 100, a real top would leave the plane.
#[test]
fn least_normal_force() {
    for (name, least) in [("fig2_same_e3_100", -15.7), ("fast_spin", -9.5), ("generic_state", -0.17)] {
        let force = vectors::named(name).motion().unwrap().min_normal_force().unwrap();
        assert!((force - least).abs() < 0.06, "{name}: {force}");
    }
    assert_eq!(vectors::named("lagrange_exact").motion().unwrap().min_normal_force(), None);
    assert_eq!(vectors::named("regular_precession").motion().unwrap().min_normal_force(), Some(1.0));
    // against u'' from differences of u' along the motion
    let motion = vectors::named("generic_AneC").motion().unwrap();
    let mut stepper = Stepper::<f64>::new(&motion);
    let (mut least, mut before, dt) = (f64::INFINITY, stepper.attitude_state().udot(), 1e-3);
    for _ in 0..6000 {
        stepper.step(dt);
        let now = stepper.attitude_state().udot();
        least = least.min(1.0 + motion.top().com_height() * (now - before) / dt);
        before = now;
    }
    assert!((least - motion.min_normal_force().unwrap()).abs() < 1e-5);
}
