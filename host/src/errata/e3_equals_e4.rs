//! Section 5.1, e₃ = e₄: the uniformisation and the direction in which x moves.

use super::weierstrass::{Integral, Lattice, from_root, printed_from_root};
use super::{Erratum, Residuals};
use crate::full_equations::full_solver::{
    FULL_SOLVER_TOLERANCE, FullSolver, FullSolverError, FullState, FullTop,
};
use num_complex::Complex64 as C;

pub(super) const ERRATA: [Erratum; 3] = [
    Erratum {
        place: "section 5.1.1, text after eqn:wofx",
        against: "u of the full solution at t(x)",
        printed: "the ℘-function is shifted by ω₁",
        corrected: "the ℘-function is shifted by ω₂",
        residuals: shift,
    },
    Erratum {
        place: "section 5.1.1, a and b",
        against: "u(a) = -1 and u(b) = 1",
        printed: "a = ±(ω₁ + ∫ √R(u) du from -1 to e₁), b = ±∫ √R(u) du from e₂ to 1",
        corrected: "a = ±(ω₁ + ∫ du/√R(u) from -1 to e₁), b = ±∫ du/√R(u) from e₂ to 1",
        residuals: ends,
    },
    Erratum {
        place: "section 5.1.1, last sentence, with eqn:degtint and t(x) as printed",
        against: "the direction of x' = u'/w, u' of the full solution at t(x)",
        printed: "x moves on the imaginary axis in the negative direction: x' = -i|x'|",
        corrected: "x moves on the imaginary axis in the positive direction: x' = i|x'|",
        residuals: direction,
    },
];

/// A = C = s = p = g = 1, so e₄² = 2; u = e₂ at t = 0.
const TOP: FullTop = FullTop { a: 1.0, c: 1.0, s: 1.0, p: 1.0, g: 1.0, k: 0.0 };
const E: [f64; 3] = [-0.3, 0.6, std::f64::consts::SQRT_2];

struct Case {
    lattice: Lattice,
    /// (e₁ + e₂ - e₃)/3.
    centre: f64,
}

impl Case {
    fn new() -> Self {
        let [e1, e2, e3] = E;
        let centre = (e1 + e2 - e3) / 3.0;
        Self { lattice: Lattice::new([e2, e1, -e3].map(|e| e - centre)), centre }
    }

    /// ω₁ and ω₂.
    fn half_periods(&self) -> [C; 2] {
        [C::new(0.0, -self.lattice.imaginary), C::new(self.lattice.real, 0.0)]
    }

    fn u(&self, x: C, shift: C) -> C {
        self.lattice.p(x - shift) + self.centre
    }

    /// Time t(x) as printed.
    fn time(&self, x: C) -> f64 {
        let [e1, e2, e3] = E;
        let omega2 = self.half_periods()[1];
        let bracket =
            self.lattice.zeta(x - omega2) + self.lattice.zeta(omega2) - x * ((e1 + e2 + 2.0 * e3) / 3.0);
        (C::new(0.0, (2.0 * TOP.s).sqrt()) * bracket).re
    }

    /// Point x on the path of the motion, with the full solution there.
    fn on_the_way(&self) -> Result<(C, FullState), FullSolverError> {
        let x = C::new(0.0, 0.7);
        let [e1, e2, e3] = E;
        // eqn:constants, signs + and -; at u = e₂, where u' = 0
        let plus = (2.0 * TOP.a * TOP.p * (1.0 + e1) * (1.0 + e2) * (1.0 + e3)).sqrt();
        let minus = -(2.0 * TOP.a * TOP.p * (1.0 - e1) * (1.0 - e2) * (e3 - 1.0)).sqrt();
        let state = super::at_turning_point(&TOP, e2, [plus, minus]);
        let full = FullSolver::new(TOP, state, FULL_SOLVER_TOLERANCE).advance_to(self.time(x))?;
        Ok((x, full))
    }
}

fn shift() -> Residuals {
    let case = Case::new();
    let (x, full) = case.on_the_way()?;
    Ok(case.half_periods().map(|shift| (case.u(x, shift) - full.axis()[2]).norm()))
}

fn ends() -> Residuals {
    let case = Case::new();
    let [e1, e2, e3] = E;
    let [omega1, omega2] = case.half_periods();
    let integrals: [Integral; 2] = [printed_from_root, from_root];
    Ok(integrals.map(|integral| {
        let a = omega1 + integral(e1, -1.0, [e2, -e3]);
        let b = C::new(integral(e2, 1.0, [e1, -e3]), 0.0);
        (case.u(a, omega2) + 1.0).norm().max((case.u(b, omega2) - 1.0).norm())
    }))
}

fn direction() -> Residuals {
    let case = Case::new();
    let (x, full) = case.on_the_way()?;
    let rate = full.axis_height_rate() / case.lattice.p_slope(x - case.half_periods()[1]);
    let direction = rate / rate.norm();
    Ok([-1.0, 1.0].map(|claimed| (direction - C::new(0.0, claimed)).norm()))
}
