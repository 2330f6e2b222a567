//! Section 5.3, e₂ = e₃ = 1: the uniformisation, time, and the Cayley-Klein parameters.

use super::weierstrass::{Integral, Lattice, from_root, printed_from_root};
use super::{Erratum, Residuals};
use crate::errata::contour::residue;
use crate::full_equations::full_solver::{
    FULL_SOLVER_TOLERANCE, FullSolver, FullSolverError, FullState, FullTop,
};
use num_complex::Complex64 as C;
use toytop::exact::hyperelliptic::Curve;
use toytop::{Motion, Signs, Start, Top, TopParameters};

pub(super) const ERRATA: [Erratum; 6] = [
    Erratum {
        place: "section 5.3.1, a and b",
        against: "u(a) = -1 and u(b) = 1",
        printed: "a = ±∫ √R(u) du from -1 to e₁, b = ±i ∫ √(-R(u)) du from e₁ to 1",
        corrected: "a = ±∫ du/√R(u) from -1 to e₁, b = ±i ∫ du/√(-R(u)) from e₁ to 1",
        residuals: ends,
    },
    Erratum {
        place: "section 5.3.2, proposition on t, last term",
        against: "the time at which the full solution is at u(x)",
        printed: "2 (ζ(ω₃) - ζ(b - ω₃)) x",
        corrected: "2 (ζ(ω₃) + ζ(b - ω₃)) x",
        residuals: time,
    },
    Erratum {
        place: "section 5.3.3, proposition, p (with l corrected)",
        against: "α of the full solution",
        printed: "p = -w₋₁/(2w₊₁)",
        corrected: "p = w₋₁/(2w₊₁)",
        residuals: exponent,
    },
    Erratum {
        place: "section 5.3.3, proposition, l (with p corrected)",
        against: "α of the full solution",
        printed: "l = w₋₁/4 - w₋₁/(1 - e₄²) + ζ(a - ω₃) - p (ζ(a + b) + ζ(a - b))",
        corrected: "l = w₋₁/4 - w₋₁/(1 - e₄²) + ζ(a - ω₃) - p (ζ(a + b) - ζ(a - b))",
        residuals: slope,
    },
    Erratum {
        place: "section 5.3.3, proof: what the lower half of Table 2 lists",
        against: "its first entry, residue 1 at (-1, -w₋₁), by contour quadrature",
        printed: "the poles of the logarithmic differential of β",
        corrected: "the poles of the logarithmic differential of δ",
        residuals: table,
    },
    Erratum {
        place: "section 5.3.3, eqn:aperform, second line",
        against: "the parameter of the full solution that it names",
        printed: "β = k₂ exp(l₂x) σ(x + a)/σ(x + ω₃) (σ(x - b)/σ(x + b))^p",
        corrected: "δ = k₂ exp(l₂x) σ(x + a)/σ(x + ω₃) (σ(x - b)/σ(x + b))^p",
        residuals: second_line,
    },
];

/// A = C = s = g = 1, p = 0.8, so e₄² = 2.25; u = e₁ at t = 0, l = n > 0.
const TOP: FullTop = FullTop { a: 1.0, c: 1.0, s: 1.0, p: 0.8, g: 1.0, k: 0.0 };
const E1: f64 = -0.2;
const E4: f64 = 1.5;

struct Case {
    lattice: Lattice,
    omega3: C,
    a: C,
    b: C,
    w_minus: f64,
    w_plus: C,
    /// Point of the motion at which the formulas are evaluated.
    x: C,
    /// log(-σ(x-b)/σ(x+b)), 0 at x = 0.
    log: C,
}

impl Case {
    fn new() -> Self {
        let centre = E1 / 3.0;
        let lattice = Lattice::new([E4, E1, -E4].map(|e| e - centre));
        let omega3 = C::new(lattice.real, -lattice.imaginary);
        // w₋₁ belongs to l + n = 2l; a has the sign for which ℘'(a - ω₃) = w₋₁
        let l = (2.0 * TOP.a * TOP.p * (1.0 + E1)).sqrt();
        let w_minus = (2.0 * TOP.s).sqrt() * (1.0 - E4 * E4) * l / TOP.a;
        let a = C::new(from_root(E1, -1.0, [E4, -E4]), 0.0);
        let a = if (lattice.p_slope(a - omega3).re < 0.0) == (w_minus < 0.0) { a } else { -a };
        let b = C::new(0.0, from_root(E1, 1.0, [E4, -E4]));
        let x = -0.6 * b;
        let mut case = Self {
            lattice,
            omega3,
            a,
            b,
            w_minus,
            w_plus: lattice.p_slope(b - omega3),
            x,
            log: C::new(0.0, 0.0),
        };
        case.log = case.continued_log();
        case
    }

    /// Value at x of the branch that is 0 at x = 0, continued from there.
    fn continued_log(&self) -> C {
        const STEPS: u32 = 64;
        let quotient = |share: u32| {
            let x = self.x * (f64::from(share) / f64::from(STEPS));
            -self.lattice.sigma(x - self.b) / self.lattice.sigma(x + self.b)
        };
        (0..STEPS).map(|share| (quotient(share + 1) / quotient(share)).ln()).sum()
    }

    fn u(&self, x: C) -> C {
        self.lattice.p(x - self.omega3) + E1 / 3.0
    }

    /// Time by the proposition on t, with this sign in its last term.
    fn time(&self, sign: f64) -> C {
        let (x, zeta) = (self.x, |z: C| self.lattice.zeta(z));
        let second = -zeta(x - self.omega3) - zeta(self.omega3) + x * (1.0 + E1 / 3.0);
        let ends = zeta(self.omega3) + zeta(self.b - self.omega3) * sign;
        let third = (self.log + ends * 2.0 * x) * (1.0 - E4 * E4) / self.w_plus;
        C::new(0.0, (2.0 * TOP.s).sqrt()) * (second + third)
    }

    /// Parameters α and δ by the proposition, with these signs of p and in l.
    fn alpha_and_delta(&self, sign_p: f64, sign_l: f64) -> [C; 2] {
        let Self { lattice, omega3, a, b, w_minus, w_plus, x, log } = *self;
        let (sigma, zeta) = (|z: C| lattice.sigma(z), |z: C| lattice.zeta(z));
        let p = sign_p * w_minus / (2.0 * w_plus);
        let ends = zeta(a + b) + zeta(a - b) * sign_l;
        let l = w_minus / 4.0 - w_minus / (1.0 - E4 * E4) + zeta(a - omega3) - p * ends;
        let k = (0.5 * (1.0 + E1)).sqrt() * sigma(omega3) / sigma(a);
        // e^{∓iπp} times the branch that is e^{±iπp} at x = 0
        let [plus, minus] = [1.0, -1.0].map(|sign| ((l * x - p * log) * sign).exp() * k);
        [plus * sigma(x - a) / sigma(x - omega3), minus * sigma(x + a) / sigma(x + omega3)]
    }

    /// Time at which the full solution is at u(x), by Newton's iteration with its u and u', and its state at this time.
    fn full(&self) -> Result<(f64, FullState), FullSolverError> {
        let momentum = (8.0 * TOP.a * TOP.p * (1.0 + E1)).sqrt();
        let state = super::at_turning_point(&TOP, E1, [momentum, 0.0]);
        let solver = FullSolver::new(TOP, state, FULL_SOLVER_TOLERANCE);
        let (mut t, target) = (1.0, self.u(self.x).re);
        for _ in 0..20 {
            let state = solver.clone().advance_to(t)?;
            t -= (state.axis()[2] - target) / state.axis_height_rate();
        }
        Ok((t, solver.clone().advance_to(t)?))
    }
}

fn ends() -> Residuals {
    let case = Case::new();
    let integrals: [Integral; 2] = [printed_from_root, from_root];
    Ok(integrals.map(|integral| {
        let a = C::new(integral(E1, -1.0, [E4, -E4]), 0.0);
        let b = C::new(0.0, integral(E1, 1.0, [E4, -E4]));
        (case.u(a) + 1.0).norm().max((case.u(b) - 1.0).norm())
    }))
}

fn time() -> Residuals {
    let case = Case::new();
    let (truth, _) = case.full()?;
    Ok([-1.0, 1.0].map(|sign| (case.time(sign) - truth).norm()))
}

fn exponent() -> Residuals {
    let case = Case::new();
    let ([re, im], alpha) = (case.full()?.1.alpha, |sign| case.alpha_and_delta(sign, -1.0)[0]);
    Ok([-1.0, 1.0].map(|sign| (alpha(sign) - C::new(re, im)).norm()))
}

fn slope() -> Residuals {
    let case = Case::new();
    let ([re, im], alpha) = (case.full()?.1.alpha, |sign| case.alpha_and_delta(1.0, sign)[0]);
    Ok([1.0, -1.0].map(|sign| (alpha(sign) - C::new(re, im)).norm()))
}

fn table() -> Residuals {
    let top = Top::sliding(&TopParameters {
        transverse_inertia: TOP.a,
        axial_inertia: TOP.c,
        com_height: TOP.s,
        mass_moment: TOP.p,
        gravity: TOP.g,
        ..TopParameters::default()
    });
    let motion = top.and_then(|top| {
        Motion::from_branch_points(&top, [E1, 1.0, 1.0], Signs::default(), &Start::default())
    });
    let Some(curve) = motion.ok().and_then(|motion| Curve::aperiodic(&motion)) else {
        return Ok([f64::NAN; 2]);
    };
    let place = curve.zeros()[3];
    Ok([1, 3].map(|part| {
        let found = residue(&curve, &place, 0.1, |at| curve.logarithms(at)[part]);
        (found.re - 1.0).hypot(found.im)
    }))
}

fn second_line() -> Residuals {
    let case = Case::new();
    let FullState { alpha: [re, im], beta, .. } = case.full()?.1;
    let line = case.alpha_and_delta(1.0, -1.0)[1];
    Ok([C::new(beta[0], beta[1]), C::new(re, -im)].map(|parameter| (line - parameter).norm()))
}
