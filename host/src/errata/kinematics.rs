//! Sections 2.1 and 3.1: the angular velocity as a matrix, DL, and ω in terms of the integrals.

use super::instant::{Instant, TOP};
use super::{Erratum, Residuals, greatest_difference};
use crate::full_equations::full_solver::{FullState, cross, dot};
use crate::full_equations::newton_euler::accelerations;
use num_complex::Complex64 as C;

pub(super) const ERRATA: [Erratum; 4] = [
    Erratum {
        place: "section 2.1, eqn:omega, matrix in the middle",
        against: "Φ'Φ⁻¹",
        printed: "1/2 ((iω₃, ω₂ + iω₁), (-ω₂ + iω₁, iω₃))",
        corrected: "1/2 ((iω₃, -ω₂ + iω₁), (ω₂ + iω₁, -iω₃))",
        residuals: omega,
    },
    Erratum {
        place: "section 2.1, eqn:Omega, matrix in the middle",
        against: "Φ⁻¹Φ'",
        printed: "1/2 ((iΩ₃, Ω₂ + iΩ₁), (-Ω₂ + iΩ₁, iΩ₃))",
        corrected: "1/2 ((iΩ₃, -Ω₂ + iΩ₁), (Ω₂ + iΩ₁, -iΩ₃))",
        residuals: body_omega,
    },
    Erratum {
        place: "section 3.1, DL",
        against: "m' - [ω, m], by Newton's and Euler's equations",
        printed: "DL = (C - A)⟨ω, r⟩ [r, ω] + ps⟨[r, k], ω⟩ [r, [k, ω]] + p [r, k]",
        corrected: "DL = (C - A)⟨ω, r⟩ [r, ω] + ps⟨[r, k], ω⟩ [r, [k, ω]] - p [r, k]",
        residuals: derivative,
    },
    Erratum {
        place: "section 3.1, proof of the proposition on the equations of motion",
        against: "ω₃",
        printed: "⟨ω, k⟩ = l/A + (1/A - 1/C) n u",
        corrected: "⟨ω, k⟩ = l/A + (1/C - 1/A) n u",
        residuals: vertical_rate,
    },
];

/// Matrices of a vector: as printed, and as it follows from the identification of R³ with su(2) in section 2.1.
fn matrices([x1, x2, x3]: [f64; 3]) -> [[C; 4]; 2] {
    let half = |re: f64, im: f64| C::new(0.5 * re, 0.5 * im);
    let printed = [half(0.0, x3), half(x2, x1), half(-x2, x1), half(0.0, x3)];
    let corrected = [half(0.0, x3), half(-x2, x1), half(x2, x1), half(0.0, -x3)];
    [printed, corrected]
}

/// Product of two matrices, given by rows.
fn product([a, b, c, d]: [C; 4], [e, f, g, h]: [C; 4]) -> [C; 4] {
    [a * e + b * g, a * f + b * h, c * e + d * g, c * f + d * h]
}

fn inverse([a, b, c, d]: [C; 4]) -> [C; 4] {
    [d, -b, -c, a]
}

fn omega() -> Residuals {
    let instant = Instant::generic();
    let truth = product(instant.rate, inverse(instant.phi));
    Ok(matrices(instant.omega).map(|matrix| greatest_difference(&matrix, &truth)))
}

fn body_omega() -> Residuals {
    let instant = Instant::generic();
    let truth = product(inverse(instant.phi), instant.rate);
    Ok(matrices(instant.body).map(|matrix| greatest_difference(&matrix, &truth)))
}

fn derivative() -> Residuals {
    let instant = Instant::generic();
    let FullState { omega, .. } = instant.state;
    let (r, q, k) = (instant.axis, instant.normal, [0.0, 0.0, 1.0]);
    let (axial, ps) = ((TOP.c - TOP.a) * instant.spin(), TOP.p * TOP.s);
    // derivative of m = Aω + axial r + ps u' q, with ω' and u'' from Newton's and Euler's equations
    let found = accelerations(&TOP, &instant.state);
    let (r_dot, rise) = (cross(omega, r), instant.udot);
    let q_dot = cross(r_dot, k);
    let m: [f64; 3] = std::array::from_fn(|i| TOP.a * omega[i] + axial * r[i] + ps * rise * q[i]);
    let turn = cross(omega, m);
    let (gyroscopic, lifting) = (cross(r, omega), cross(r, cross(k, omega)));
    let differences = [1.0, -1.0].map(|sign| {
        let difference: [f64; 3] = std::array::from_fn(|i| {
            let m_dot =
                TOP.a * found.omega[i] + axial * r_dot[i] + ps * (found.height * q[i] + rise * q_dot[i]);
            let dl = axial * gyroscopic[i] + ps * dot(q, omega) * lifting[i] + sign * TOP.p * q[i];
            m_dot - turn[i] - dl
        });
        dot(difference, difference).sqrt()
    });
    Ok(differences)
}

fn vertical_rate() -> Residuals {
    let instant = Instant::generic();
    let residual =
        |factor: f64| (instant.l / TOP.a + factor * instant.n * instant.u - instant.omega[2]).abs();
    Ok([residual(1.0 / TOP.a - 1.0 / TOP.c), residual(1.0 / TOP.c - 1.0 / TOP.a)])
}
