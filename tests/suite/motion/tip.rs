//! Tip curve: angle, velocity, class, and the normal force.

use toytop::{Complex, Phase, Stepper, TipClass};
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
        assert_eq!(vectors::motion(name).tip_class(), class, "{name}");
    }
}
