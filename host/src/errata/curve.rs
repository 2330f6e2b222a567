//! Section 3.4: the integrals for the Cayley-Klein parameters.

use super::instant::{Instant, TOP, e4_squared};
use super::{Erratum, Residuals, greatest_difference};
use crate::errata::contour::residue_at_infinity;
use num_complex::Complex64 as C;
use toytop::exact::hyperelliptic::Curve;
use toytop::{Motion, Signs, Start, Top, TopParameters};

pub(super) const ERRATA: [Erratum; 3] = [
    Erratum {
        place: "section 3.4, proof, first display of w±1 (the second, √(s/2) (1 - e₄²)(l ∓ n)/A, is right)",
        against: "α'/α, β'/β, γ'/γ, δ'/δ, with eqn:abgdints",
        printed: "w±1 = √(s/2) (l ∓ n)/(ps)",
        corrected: "w±1 = -√(s/2) (l ∓ n)/(ps)",
        residuals: logarithmic_rates,
    },
    Erratum {
        place: "section 3.4, proof, both lines for ±i (Ω₃ ± ω₃) dt",
        against: "±i (Ω₃ ± ω₃)",
        printed: "(u - e₄²)/(1 - e₄²) w∓1 du/w + i (u ± 1)(1/C - 1/A) n dt",
        corrected: "(u² - e₄²)/(1 - e₄²) w∓1 du/w + i (u ± 1)(1/C - 1/A) n dt",
        residuals: sums_of_rates,
    },
    Erratum {
        place: "section 3.4, end of the proof: dα/α at infinity",
        against: "its residue, by contour quadrature (Table 1 has -1)",
        printed: "the singular part is dξ/ξ",
        corrected: "the singular part is -dξ/ξ",
        residuals: at_infinity,
    },
];

/// Function w on the motion, w = i√(s/2) (e₄² - u²) u', for which eqn:t is true.
fn w(instant: &Instant) -> C {
    C::new(0.0, (0.5 * TOP.s).sqrt() * (e4_squared() - instant.u * instant.u) * instant.udot)
}

/// Numbers w₋₁ and w₊₁ by the first display.
fn first_display(instant: &Instant) -> [f64; 2] {
    let factor = (0.5 * TOP.s).sqrt() / (TOP.p * TOP.s);
    [factor * (instant.l + instant.n), factor * (instant.l - instant.n)]
}

fn logarithmic_rates() -> Residuals {
    let instant = Instant::generic();
    let (u, udot, w) = (instant.u, instant.udot, w(&instant));
    let truth: [C; 4] = std::array::from_fn(|i| instant.rate[i] / instant.phi[i]);
    let ratio = (u * u - e4_squared()) / (1.0 - e4_squared());
    let drift = C::new(0.0, 0.5 * instant.tau());
    Ok([1.0, -1.0].map(|sign| {
        let [minus, plus] = first_display(&instant).map(|value| sign * ratio * value / w);
        let below = |sum: C| sum * udot / (2.0 * (u - 1.0));
        let above = |sum: C| sum * udot / (2.0 * (u + 1.0));
        let ours = [
            above(1.0 + minus) + drift,
            below(1.0 - plus) - drift,
            below(1.0 + plus) + drift,
            above(1.0 - minus) - drift,
        ];
        greatest_difference(&ours, &truth)
    }))
}

fn sums_of_rates() -> Residuals {
    let instant = Instant::generic();
    let (u, udot, w) = (instant.u, instant.udot, w(&instant));
    let truth = [instant.body[2] + instant.omega[2], instant.omega[2] - instant.body[2]];
    let truth = truth.map(|rate| C::new(0.0, rate));
    // the corrected first display, so that only the error of this formula remains
    let [minus, plus] = first_display(&instant).map(|value| -value);
    Ok([u, u * u].map(|power| {
        let ratio = (power - e4_squared()) / (1.0 - e4_squared());
        let line = |value: f64, factor: f64| ratio * value * udot / w + C::new(0.0, factor * instant.tau());
        greatest_difference(&[line(minus, u + 1.0), line(plus, u - 1.0)], &truth)
    }))
}

fn at_infinity() -> Residuals {
    let top = Top::sliding(&TopParameters {
        transverse_inertia: TOP.a,
        axial_inertia: TOP.c,
        com_height: TOP.s,
        mass_moment: TOP.p,
        gravity: TOP.g,
        ..TopParameters::default()
    });
    let motion = top.and_then(|top| {
        Motion::from_branch_points(&top, [-0.3, 0.6, 1.4], Signs::default(), &Start::default())
    });
    let Ok(motion) = motion else { return Ok([f64::NAN; 2]) };
    let curve = Curve::of(&motion);
    let residue = residue_at_infinity(&curve, 0.3, |at, _| curve.logarithms(at)[0]);
    Ok([1.0, -1.0].map(|claimed| (residue.re - claimed).hypot(residue.im)))
}
