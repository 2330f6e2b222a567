//! Section 5.3, e₂ = e₃ = 1: the paper's formulas written out, with the printed errors corrected, against the closed
//! form in core; and the closed form at extreme times.

use std::f64::consts::FRAC_PI_2;
use toytop::elliptic::{Weierstrass, carlson_rf};
use toytop::exact::Aperiodic;
use toytop::{Complex, Motion, Orientation, Sign, Signs, Start, Top};
use toytop_tests::complex::{C, I, from, to};
use toytop_tests::{greater, tolerance, top_of};

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
    let start = Start { theta: 0.0, arg_alpha: 0.0, arg_beta: FRAC_PI_2 };
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
        let p_prime = |x: C| from(lattice.p_prime(to(x - omega3)));
        let a = C::from(if (p_prime(C::from(to_e1)).re > 0.0) == (w_minus > 0.0) { to_e1 } else { -to_e1 });
        let b = -I * to_one;
        Self { motion, e1, lattice, omega3, w_minus, w_plus: p_prime(b), a, b }
    }

    fn zeta(&self, z: C) -> C {
        from(self.lattice.zeta(to(z)))
    }

    fn sigma(&self, z: C) -> C {
        from(self.lattice.sigma(to(z)))
    }

    fn u(&self, x: C) -> C {
        from(self.lattice.p(to(x - self.omega3))) + self.e1 / 3.0
    }

    /// Logarithm log(-σ(x - b)/σ(x + b)), in the branch that is 0 at x = 0 and real for x between ±b.
    fn log(&self, x: C) -> C {
        (-self.sigma(x - self.b) / self.sigma(x + self.b)).ln()
    }

    /// Integral ∫ du/((u - 1) w), equation (5.15).
    fn i1(&self, x: C) -> C {
        let zetas = self.zeta(self.omega3) + self.zeta(self.b - self.omega3);
        (self.log(x) + zetas * x * 2.0) / self.w_plus
    }

    /// Integral ∫ (u + 1) du/w, equation (5.16).
    fn i2(&self, x: C) -> C {
        x * (1.0 + self.e1 / 3.0) - self.zeta(x - self.omega3) - self.zeta(self.omega3)
    }

    fn t(&self, x: C) -> C {
        I * 2_f64.sqrt() * (self.i2(x) + self.i1(x) * (1.0 - E4 * E4))
    }

    fn phi(&self, x: C) -> Orientation<f64> {
        let (a, b, omega3) = (self.a, self.b, self.omega3);
        let p = C::from(self.w_minus) / (self.w_plus * 2.0);
        let k = self.sigma(omega3) / self.sigma(a) * ((1.0 + self.e1) / 2.0).sqrt();
        let l = self.zeta(a - omega3) + self.w_minus / 4.0
            - self.w_minus / (1.0 - E4 * E4)
            - p * (self.zeta(a + b) - self.zeta(a - b));
        let alpha = k * (l * x - p * self.log(x)).exp() * self.sigma(x - a) / self.sigma(x - omega3);
        Orientation { alpha: to(alpha), beta: to(I * ((C::from(1.0) - self.u(x)) / 2.0).sqrt()) }
    }
}

fn papers() -> Vec<Paper> {
    [-0.8, -0.25, 0.5, 0.9]
        .map(|e1| [Sign::Plus, Sign::Minus].map(|sign| Paper::new(e1, sign)))
        .into_iter()
        .flatten()
        .collect()
}

/// The point a lies over (-1, w₋₁), the point b over u = 1, and x = 0 over u = e₁.
#[test]
fn the_uniformization() {
    for paper in papers() {
        assert!((paper.u(C::from(0.0)) - paper.e1).norm() < 1e-15);
        assert!((paper.u(paper.a) + 1.0).norm() < 1e-14 && (paper.u(paper.b) - 1.0).norm() < 1e-14);
        let w = from(paper.lattice.p_prime(to(paper.a - paper.omega3)));
        assert!((w - paper.w_minus).norm() < 1e-13);
    }
}

#[test]
fn eqn_i1_and_eqn_i2() {
    for paper in papers() {
        for share in [0.1, -0.4, 0.8] {
            let (x, h) = (paper.b * share, C::from(1e-5));
            let slope = |f: &dyn Fn(C) -> C| (f(x + h) - f(x - h)) / (h * 2.0);
            let u = paper.u(x);
            assert!((slope(&|x| paper.i1(x)) - C::from(1.0) / (u - 1.0)).norm() < 1e-6);
            assert!((slope(&|x| paper.i2(x)) - (u + 1.0)).norm() < 1e-8);
        }
    }
}

/// The paper's t, α and β on the path from 0 to ±b equal those of core.
#[test]
fn eqn_tpolydiv_eqn_aperform() {
    let mut worst = 0.0_f64;
    for paper in papers() {
        let form = Aperiodic::new(&paper.motion).unwrap();
        for share in [-0.99, -0.9, -0.35, 0.0, 1e-6, 0.2, 0.6, 0.95, 0.999] {
            let x = paper.b * share;
            let t = paper.t(x);
            assert!(t.im.abs() < 1e-13 && t.re * share >= 0.0, "{t}");
            let attitude = form.at(t.re);
            worst = greater(worst, attitude.orientation.distance(&paper.phi(x)));
        }
    }
    tolerance::AS_THE_PAPER_HAS_IT.check("aperiodic", worst);
}

/// u = e₁ + (1 - e₁) tanh² v, |β| = √((1 - e₁)/2) sech v, dt/dv = √(2D/(g (1 - e₁))).
#[test]
fn the_elementary_form() {
    let fixed = top_of([1.25, 0.75, 0.0, 1.5], 3.0);
    let slid = top_of([1.25, 0.75, 0.5, 1.5], 3.0);
    for (top, e1) in [(fixed, -0.4), (fixed, 0.9), (slid, -0.4), (slid, 0.9)] {
        let form = Aperiodic::new(&motion(&top, e1, Sign::Minus)).unwrap();
        for t in [-6.0, -1.5, 0.0, 0.25, 3.0, 9.0] {
            let (v, attitude) = (form.v(t), form.at(t));
            let u = e1 + (1.0 - e1) * v.tanh().powi(2);
            let beta = ((1.0 - e1) / 2.0).sqrt() / v.cosh();
            assert!((attitude.u() - u).abs() < 1e-14);
            assert!((attitude.orientation.beta.norm_squared().sqrt() / beta - 1.0).abs() < 1e-13);
            let h = 1e-4;
            let slope = 2.0 * h / (form.v(t + h) - form.v(t - h));
            let d = top.transverse_inertia() / top.mass_moment() + top.com_height() * (1.0 - u * u);
            assert!((slope / (2.0 * d / (3.0 * (1.0 - e1))).sqrt() - 1.0).abs() < 1e-7);
            if top.com_height() == 0.0 {
                assert!((v - t * (1.5 * 3.0 * (1.0 - e1) / 2.5_f64).sqrt()).abs() < 1e-14 * (1.0 + v.abs()));
            }
        }
    }
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
                    "{e1} {turned:?} {rate} {} {sense}",
                    top.com_height()
                );
            }
        }
    }
}
