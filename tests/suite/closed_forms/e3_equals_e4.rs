//! Section 5.1, e₃ = e₄: the paper's formulas written out with the public Weierstrass functions, with the printed
//! errors corrected, against the closed form in core, which computes them in another way.

use super::curve::{I, narrow, of};
use num_complex::Complex64 as C;
use std::f64::consts::{FRAC_PI_2, PI};
use toytop::{InitialPhases, Motion, Orientation, Signs};
use toytop_closed_forms::E3EqualsE4;
use toytop_closed_forms::elliptic::{Weierstrass, carlson_rf};
use toytop_tests::{SIGNS, check, greater, top_of};

/// Value of e₃ = e₄ for A = C = 5/4, s = p = 1.
const E3: f64 = 1.5;

/// Motion in the paper's symbols, with initial conditions u = e₂, α > 0, β in iℝ₊.
struct Paper {
    motion: Motion,
    e1: f64,
    e2: f64,
    lattice: Weierstrass,
    omega1: C,
    omega2: C,
    w_minus: f64,
    w_plus: f64,
    a: C,
    b: C,
}

impl Paper {
    fn new(e1: f64, e2: f64, signs: Signs) -> Self {
        let top = top_of([1.25, 1.25, 1.0, 1.0], 1.0);
        let start = InitialPhases { theta: PI, arg_alpha: 0.0, arg_beta: FRAC_PI_2 };
        let motion = Motion::from_branch_points(&top, [e1, e2, E3], signs, &start).unwrap();
        let lattice = Weierstrass::from_gaps(e2 - e1, e1 + E3).unwrap();
        let [omega2, omega1] = lattice.half_periods();
        let (omega1, omega2) = (-I * omega1, C::from(omega2));
        let integrals = motion.first_integrals();
        let w_minus = 2_f64.sqrt() * (E3 - 1.0) * integrals.l_plus_n / top.transverse_inertia();
        let w_plus = 2_f64.sqrt() * (E3 + 1.0) * integrals.l_minus_n / top.transverse_inertia();
        // ∫ du/√R (printed as √R) from -1 to e₁ and from e₂ to 1
        let to_e1 = (1.0 + e1).sqrt()
            * carlson_rf((e2 - e1) * (e1 + E3), (e2 - e1) * (E3 - 1.0), (e1 + E3) * (1.0 + e2));
        let to_one = (1.0 - e2).sqrt()
            * carlson_rf((e2 - e1) * (e2 + E3), (e2 - e1) * (1.0 + E3), (e2 + E3) * (1.0 - e1));
        let a = (omega1 + to_e1) * -w_minus.signum();
        let b = C::from(to_one * w_plus.signum());
        Self { motion, e1, e2, lattice, omega1, omega2, w_minus, w_plus, a, b }
    }

    fn zeta(&self, z: C) -> C {
        of(|z| self.lattice.zeta(z), z)
    }

    fn sigma(&self, z: C) -> C {
        of(|z| self.lattice.sigma(z), z)
    }

    fn u(&self, x: C) -> C {
        of(|z| self.lattice.p(z), x - self.omega2) + (self.e1 + self.e2 - E3) / 3.0
    }

    fn w(&self, x: C) -> C {
        of(|z| self.lattice.p_prime(z), x - self.omega2)
    }

    fn t(&self, x: C) -> C {
        let linear = x * ((self.e1 + self.e2 + 2.0 * E3) / 3.0);
        I * 2_f64.sqrt() * (self.zeta(x - self.omega2) + self.zeta(self.omega2) - linear)
    }

    /// Orientation Φ by equations (5.6), (5.7) and (5.8).
    fn phi(&self, x: C) -> Orientation<f64> {
        let (a, b, omega2) = (self.a, self.b, self.omega2);
        let k1 = self.sigma(omega2) / self.sigma(a) * ((1.0 + self.e2) / 2.0).sqrt();
        let k2 = I * self.sigma(omega2) / self.sigma(b) * ((1.0 - self.e2) / 2.0).sqrt();
        let l1 = self.zeta(a - omega2) + self.w_minus / (2.0 * (E3 - 1.0));
        let l3 = self.zeta(b - omega2) + self.w_plus / (2.0 * (E3 + 1.0));
        let alpha = k1 * (l1 * x).exp() * self.sigma(x - a) / self.sigma(x - omega2);
        let beta = k2 * (-l3 * x).exp() * self.sigma(x + b) / self.sigma(x + omega2);
        Orientation { alpha: narrow(alpha), beta: narrow(beta) }
    }
}

fn papers() -> impl Iterator<Item = Paper> {
    let pairs = [(-0.4, 0.6), (0.2, 0.9), (-0.9, -0.3)];
    pairs.into_iter().flat_map(|(e1, e2)| SIGNS.map(|signs| Paper::new(e1, e2, signs)))
}

/// Generic points of the x-plane.
const POINTS: [C; 4] = [C::new(0.3, 0.2), C::new(-0.7, 0.5), C::new(0.0, -0.9), C::new(1.1, 1.7)];

/// u(x) and w(x) lie on the curve w² = 4 (u - e₁)(u - e₂)(u + e₃) with du = w dx, and u(0) = e₂.
#[test]
fn eqn_x_eqn_uofx_eqn_wofx() {
    for paper in papers() {
        assert!((paper.u(C::from(0.0)) - paper.e2).norm() < 1e-15);
        assert!((paper.u(paper.omega1) - paper.e1).norm() < 1e-15);
        for x in POINTS {
            let (u, w) = (paper.u(x), paper.w(x));
            let curve = (u - paper.e1) * (u - paper.e2) * (u + E3) * 4.0;
            assert!((w * w - curve).norm() < 1e-13 * (1.0 + curve.norm()));
            let h = C::from(1e-5);
            let slope = (paper.u(x + h) - paper.u(x - h)) / (h * 2.0);
            assert!((slope - w).norm() < 1e-8 * (1.0 + w.norm().powi(2)));
        }
        // the points a and b lie over (-1, w₋₁) and (1, w₊₁)
        let (a, b) = (paper.a, paper.b);
        assert!((paper.u(a) + 1.0).norm() < 1e-14 && (paper.w(a) - paper.w_minus).norm() < 1e-13);
        assert!((paper.u(b) - 1.0).norm() < 1e-14 && (paper.w(b) - paper.w_plus).norm() < 1e-13);
    }
}

/// The paper's α and β along the imaginary axis, over three periods, equal those of core at the paper's t.
#[test]
fn eqn_degabgd_eqn_ks_eqn_ls() {
    let mut worst = 0.0_f64;
    for paper in papers() {
        let form = E3EqualsE4::new(&paper.motion).unwrap();
        for share in [-2.9, -1.4, -0.999, -0.3, 0.0, 0.001, 0.7, 1.0, 2.2, 3.0] {
            let x = -paper.omega1 * share;
            let t = paper.t(x);
            assert!(t.im.abs() < 1e-13 && t.re * share >= 0.0);
            let attitude = form.at(t.re);
            assert!((attitude.u() - paper.u(x).re).abs() < 1e-13 && paper.u(x).im.abs() < 1e-13);
            worst = greater(worst, attitude.orientation.distance(&paper.phi(x)));
        }
    }
    check("e3 = e4", worst, 1e-13);
}
