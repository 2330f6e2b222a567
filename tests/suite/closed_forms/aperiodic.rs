//! Section 5.3, e₂ = e₃ = 1: the paper's formulas written out, with the printed errors corrected, against the closed
//! form in core; and the closed form at extreme times.

use super::curve::{I, narrow, of};
use num_complex::Complex64 as C;
use std::f64::consts::FRAC_PI_2;
use toytop::{Complex, InitialPhases, Motion, Orientation, Sign, Signs, Stepper, Top};
use toytop_closed_forms::Aperiodic;
use toytop_closed_forms::elliptic::{Weierstrass, carlson_rf};
use toytop_tests::{check, greater, top_of};

const E4: f64 = 1.5;

/// Motion in the paper's symbols, with initial conditions u = e₁, α > 0, β in iℝ₊. A = C = 5/4, s = p = 1.
struct Paper {
    motion: Motion,
    e1: f64,
    lattice: Weierstrass,
    omega3: C,
    w_minus: f64,
    w_plus: C,
    a: C,
    b: C,
}

fn motion(top: &Top, e1: f64, sign: Sign) -> Motion {
    let signs = Signs { l_plus_n: sign, l_minus_n: Sign::Plus };
    let start = InitialPhases { theta: 0.0, arg_alpha: 0.0, arg_beta: FRAC_PI_2 };
    Motion::from_branch_points(top, [e1, 1.0, 1.0], signs, &start).unwrap()
}

fn sliding() -> Top {
    top_of([1.25, 1.25, 1.0, 1.0], 1.0)
}

impl Paper {
    fn new(e1: f64, sign: Sign) -> Self {
        let motion = motion(&sliding(), e1, sign);
        let (below, above) = (E4 - e1, E4 + e1);
        let lattice = Weierstrass::from_gaps(below, above).unwrap();
        let [real, imaginary] = lattice.half_periods();
        let omega3 = C::new(real, imaginary);
        let w_minus = 2_f64.sqrt() * (1.0 - E4 * E4) * motion.first_integrals().l / 1.25;
        // ∫ du/√R from -1 to e₁, ∫ du/√(-R) from e₁ to 1 (printed as √R, √(-R))
        let to_e1 = (1.0 + e1).sqrt() * carlson_rf((1.0 + E4) * above, (E4 - 1.0) * below, below * above);
        let to_one = (1.0 - e1).sqrt() * carlson_rf((E4 - 1.0) * above, (E4 + 1.0) * below, below * above);
        let p_prime = |x: C| of(|z| lattice.p_prime(z), x - omega3);
        let a = C::from(if (p_prime(C::from(to_e1)).re > 0.0) == (w_minus > 0.0) { to_e1 } else { -to_e1 });
        let b = -I * to_one;
        Self { motion, e1, lattice, omega3, w_minus, w_plus: p_prime(b), a, b }
    }

    fn zeta(&self, z: C) -> C {
        of(|z| self.lattice.zeta(z), z)
    }

    fn sigma(&self, z: C) -> C {
        of(|z| self.lattice.sigma(z), z)
    }

    fn u(&self, x: C) -> C {
        of(|z| self.lattice.p(z), x - self.omega3) + self.e1 / 3.0
    }

    /// Logarithm log(-σ(x - b)/σ(x + b)), in the branch that is 0 at x = 0 and real for x between ±b.
    fn log(&self, x: C) -> C {
        (-self.sigma(x - self.b) / self.sigma(x + self.b)).ln()
    }

    /// Time by equations (5.14) to (5.16).
    fn t(&self, x: C) -> C {
        let zetas = self.zeta(self.omega3) + self.zeta(self.b - self.omega3);
        let pole = (self.log(x) + zetas * x * 2.0) / self.w_plus;
        let rest = x * (1.0 + self.e1 / 3.0) - self.zeta(x - self.omega3) - self.zeta(self.omega3);
        I * 2_f64.sqrt() * (rest + pole * (1.0 - E4 * E4))
    }

    /// Orientation with α by equation (5.17).
    fn phi(&self, x: C) -> Orientation<f64> {
        let (a, b, omega3) = (self.a, self.b, self.omega3);
        let p = self.w_minus / (self.w_plus * 2.0);
        let k = self.sigma(omega3) / self.sigma(a) * ((1.0 + self.e1) / 2.0).sqrt();
        let l = self.zeta(a - omega3) + self.w_minus / 4.0
            - self.w_minus / (1.0 - E4 * E4)
            - p * (self.zeta(a + b) - self.zeta(a - b));
        let alpha = (l * x - p * self.log(x)).exp() * k * self.sigma(x - a) / self.sigma(x - omega3);
        let beta = I * ((1.0 - self.u(x)) / 2.0).sqrt();
        Orientation { alpha: narrow(alpha), beta: narrow(beta) }
    }
}

/// The paper's t, α and β on the path from 0 to ±b equal those of core.
#[test]
fn eqn_tpolydiv_eqn_aperform() {
    let mut worst = 0.0_f64;
    let cases =
        [-0.8, -0.25, 0.5, 0.9].into_iter().flat_map(|e1| [Sign::Plus, Sign::Minus].map(|sign| (e1, sign)));
    for (e1, sign) in cases {
        let paper = Paper::new(e1, sign);
        let form = Aperiodic::new(&paper.motion).unwrap();
        for share in [-0.99, -0.9, -0.35, 0.0, 1e-6, 0.2, 0.6, 0.95, 0.999] {
            let x = paper.b * share;
            let t = paper.t(x);
            assert!(t.im.abs() < 1e-13 && t.re * share >= 0.0, "{t}");
            let attitude = form.at(t.re);
            worst = greater(worst, attitude.orientation.distance(&paper.phi(x)));
        }
    }
    check("aperiodic", worst, 1e-13);
}

/// Where 1 - u has no correct digits, the axis is upright, the norm is 1, and α rotates at its final rate, (l/A +
/// τ)/2 = n/(2C).
#[test]
fn upright_to_rounding_at_any_time() {
    let slid = top_of([1.25, 0.75, 0.5, 1.5], 3.0);
    for top in [top_of([1.25, 0.75, 0.0, 1.5], 3.0), slid, sliding()] {
        for (e1, sign) in [(-0.4, Sign::Plus), (0.8, Sign::Minus), (-1.0, Sign::Plus)] {
            let motion = motion(&top, e1, sign);
            let form = Aperiodic::new(&motion).unwrap();
            let rate = 0.5 * motion.first_integrals().n / top.axial_inertia();
            for sense in [1.0, -1.0] {
                for t in [60.0, 1e3, 1e6, 1e12, 1e15, 1e300].map(|t| sense * t) {
                    let attitude = form.at(t);
                    assert!((attitude.orientation.norm_squared() - 1.0).abs() < 1e-13, "{e1} {t}");
                    assert!((attitude.u() - 1.0).abs() < 1e-13 && attitude.udot().abs() < 1e-13, "{e1} {t}");
                    assert!(attitude.omega().iter().all(|w| w.is_finite()), "{e1} {t}");
                }
                let turned = form.at(sense * 400.0).orientation.alpha
                    * form.at(sense * 300.0).orientation.alpha.conj();
                let (sine, cosine) = (sense * 100.0 * rate).sin_cos();
                assert!(
                    (turned - Complex::new(cosine, sine)).norm_squared() < 1e-24,
                    "{e1} {turned:?} {rate}"
                );
            }
        }
    }
}

/// The tip angle counts whole turns as the stepper does with its step of 0.01 s, and is the argument of αβ; the tip and its angle change together.
#[test]
fn the_tip_angle_counts_whole_turns() {
    let mut turns = 0.0_f64;
    for com_height in [0.0, 0.5, 30.0] {
        let top = top_of([1.25, 0.75, com_height, 1.5], 3.0);
        for (e1, sign, theta) in [
            (-0.4, Sign::Plus, 0.0),
            (-0.999, Sign::Minus, 1.0),
            (0.9, Sign::Plus, -3.0),
            (-1.0, Sign::Plus, 0.5),
        ] {
            let signs = Signs { l_plus_n: sign, l_minus_n: Sign::Plus };
            let start = InitialPhases { theta, arg_alpha: 0.3, arg_beta: 1.0 };
            let motion = Motion::from_branch_points(&top, [e1, 1.0, 1.0], signs, &start).unwrap();
            let form = Aperiodic::new(&motion).unwrap();
            assert!((2e-15..1e-13).contains(&form.error_bound()));
            for sense in [-1.0, 1.0] {
                let mut stepper = Stepper::<f64>::new(&motion);
                for step in 1..=3000 {
                    stepper.step(sense * 0.01);
                    if step % 30 > 0 {
                        continue;
                    }
                    let t = sense * 0.01 * f64::from(step);
                    let (angle, tip) = (form.tip_angle(t), form.tip(t));
                    let apart = (angle - stepper.tip_angle().unwrap()).to_radians();
                    assert!(apart.abs() < 1e-4, "{com_height} {e1} {t}: {apart:e}");
                    let direction = Complex::<f64>::cis(angle);
                    let across = tip.im * direction.re - tip.re * direction.im;
                    assert!(across.abs() < 1e-13 * (1.0 + com_height), "{com_height} {e1} {t}: {across:e}");
                    turns = turns.max(angle.to_f64().abs());
                }
            }
        }
    }
    assert!(turns > 3.0, "{turns}");
}
