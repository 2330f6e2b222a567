//! Section 4: the curve of the tip and the condition for loops.

use super::instant::{Instant, TOP};
use super::{Erratum, Residuals};
use crate::input::random::Random;
use num_complex::Complex64 as C;

pub(super) const ERRATA: [Erratum; 2] = [
    Erratum {
        place: "section 4.1, proof of the proposition on dφ",
        against: "z = β/δ and c = -s (r₁ + ir₂), as section 4.1 has named them",
        printed: "the curve z = 2sαβ",
        corrected: "the curve c = 2sαβ",
        residuals: name_of_the_curve,
    },
    Erratum {
        place: "section 4.2, proof, second chain, X = (1 + e₁)(1 - e₂)/((1 - e₁)(1 + e₂))",
        against: "the sign of φ' at u = e₁ and u = e₂: share of 1000 random motions classified wrongly",
        printed: "loops: -(1 - e₃)/(1 + e₃) < X < -(1 + e₃)/(1 - e₃)",
        corrected: "loops: X < (e₃ - 1)/(e₃ + 1)",
        residuals: loops,
    },
];

fn name_of_the_curve() -> Residuals {
    let instant = Instant::generic();
    let [alpha, beta, _, delta] = instant.phi;
    let [r1, r2, _] = instant.axis;
    let claimed = 2.0 * TOP.s * alpha * beta;
    Ok([beta / delta, -TOP.s * C::new(r1, r2)].map(|curve| (curve - claimed).norm()))
}

fn loops() -> Residuals {
    const MOTIONS: u32 = 1000;
    let mut random = Random::new(1, 0);
    let mut wrong = [0_u32; 2];
    for _ in 0..MOTIONS {
        let e1 = random.between(-0.99, 0.95);
        let (e2, e3) = (random.between(e1 + 0.01, 0.99), random.scale(1.01, 20.0));
        // eqn:constants with 2Ap = 1 and different signs; φ' has the sign of l - nu
        let plus = ((1.0 + e1) * (1.0 + e2) * (1.0 + e3)).sqrt();
        let minus = -((1.0 - e1) * (1.0 - e2) * (e3 - 1.0)).sqrt();
        let turning = |u: f64| plus * (1.0 - u) + minus * (1.0 + u);
        let truth = turning(e1) * turning(e2) < 0.0;
        let x = (1.0 + e1) * (1.0 - e2) / ((1.0 - e1) * (1.0 + e2));
        let bound = (e3 - 1.0) / (e3 + 1.0);
        for (count, told) in wrong.iter_mut().zip([bound < x && x < 1.0 / bound, x < bound]) {
            *count += u32::from(told != truth);
        }
    }
    Ok(wrong.map(|count| f64::from(count) / f64::from(MOTIONS)))
}
