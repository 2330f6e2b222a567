//! `toytop errata`: errors of the printed paper. `tests/reference/errata.py` evaluates each formula as printed and as corrected, and a test
//! compares the residuals.

use crate::output::{self, Format};
use crate::{Failure, Report};
use clap::Args;
use serde_json::json;

/// Errors of the printed paper and their corrections
#[derive(Args)]
#[command(after_help = "Example: toytop errata --format csv")]
pub struct ErrataArgs {
    /// Form of the output
    #[arg(long, default_value = "table")]
    format: Format,
}

pub fn run(arguments: &ErrataArgs) -> Result<Report, Failure> {
    let record = |(number, erratum): (u64, Erratum)| {
        let Erratum { place, against, printed, corrected, residuals } = erratum;
        json!({
            "number": number,
            "place": place,
            "against": against,
            "printed": printed,
            "corrected": corrected,
            "residual_printed": residuals[0],
            "residual_corrected": residuals[1],
        })
    };
    let records: Vec<_> = (1..).zip(ERRATA).map(record).collect();
    Ok(output::render(arguments.format, &json!({ "slips": records }), table).into())
}

/// Text of all errata: place, quantity that the formula is compared with, and both versions with their residuals.
fn table() -> String {
    let lines = |(number, erratum): (u64, &Erratum)| {
        let Erratum { place, against, printed, corrected, residuals: [wrong, right] } = erratum;
        let right = if *right == 0.0 { "0".to_owned() } else { format!("< {right:e}") };
        format!(
            "{number:2}  {place}\n    against              {against}\n    printed    {wrong:>8.2}  {printed}\n    \
             corrected  {right:>8}  {corrected}\n"
        )
    };
    let heading = "               residual\n".to_owned();
    (1..).zip(&ERRATA).fold(heading, |text, erratum| text + &lines(erratum))
}

/// Wrong formula of the paper with its correction.
pub struct Erratum {
    /// Place in the paper: a label or a section.
    pub place: &'static str,
    /// Quantity that the formula is compared with; a residual is their largest difference.
    pub against: &'static str,
    /// Formula as printed.
    pub printed: &'static str,
    /// Corrected formula.
    pub corrected: &'static str,
    /// Residual of the printed formula, to two decimals, and a power of ten above that of the corrected one; 0 where it is exact.
    pub residuals: [f64; 2],
}

/// All errors with a formula that can be evaluated, in the order of the paper.
pub const ERRATA: [Erratum; 18] = [
    Erratum {
        place: "section 2.1, eqn:omega, matrix in the middle",
        against: "Φ'Φ⁻¹",
        printed: "1/2 ((iω₃, ω₂ + iω₁), (-ω₂ + iω₁, iω₃))",
        corrected: "1/2 ((iω₃, -ω₂ + iω₁), (ω₂ + iω₁, -iω₃))",
        residuals: [1.30, 1e-15],
    },
    Erratum {
        place: "section 2.1, eqn:Omega, matrix in the middle",
        against: "Φ⁻¹Φ'",
        printed: "1/2 ((iΩ₃, Ω₂ + iΩ₁), (-Ω₂ + iΩ₁, iΩ₃))",
        corrected: "1/2 ((iΩ₃, -Ω₂ + iΩ₁), (Ω₂ + iΩ₁, -iΩ₃))",
        residuals: [1.12, 1e-15],
    },
    Erratum {
        place: "section 3.1, DL",
        against: "m' - [ω, m], by Newton's and Euler's equations",
        printed: "DL = (C - A)⟨ω, r⟩ [r, ω] + ps⟨[r, k], ω⟩ [r, [k, ω]] + p [r, k]",
        corrected: "DL = (C - A)⟨ω, r⟩ [r, ω] + ps⟨[r, k], ω⟩ [r, [k, ω]] - p [r, k]",
        residuals: [1.76, 1e-15],
    },
    Erratum {
        place: "section 3.1, proof of the proposition on the equations of motion",
        against: "ω₃",
        printed: "⟨ω, k⟩ = l/A + (1/A - 1/C) n u",
        corrected: "⟨ω, k⟩ = l/A + (1/C - 1/A) n u",
        residuals: [0.12, 0.0],
    },
    Erratum {
        place: "section 3.4, proof, first display of w±1 (the second, √(s/2) (1 - e₄²)(l ∓ n)/A, is right)",
        against: "α'/α, β'/β, γ'/γ, δ'/δ, with eqn:abgdints",
        printed: "w±1 = √(s/2) (l ∓ n)/(ps)",
        corrected: "w±1 = -√(s/2) (l ∓ n)/(ps)",
        residuals: [1.63, 1e-15],
    },
    Erratum {
        place: "section 3.4, proof, both lines for ±i (Ω₃ ± ω₃) dt",
        against: "±i (Ω₃ ± ω₃)",
        printed: "(u - e₄²)/(1 - e₄²) w∓1 du/w + i (u ± 1)(1/C - 1/A) n dt",
        corrected: "(u² - e₄²)/(1 - e₄²) w∓1 du/w + i (u ± 1)(1/C - 1/A) n dt",
        residuals: [0.11, 1e-15],
    },
    Erratum {
        place: "section 3.4, end of the proof: dα/α at infinity",
        against: "its residue, by contour quadrature (Table 1 has -1)",
        printed: "the singular part is dξ/ξ",
        corrected: "the singular part is -dξ/ξ",
        residuals: [2.00, 1e-15],
    },
    Erratum {
        place: "section 4.1, proof of the proposition on dφ",
        against: "z = β/δ and c = -s (r₁ + ir₂), as section 4.1 has named them",
        printed: "the curve z = 2sαβ",
        corrected: "the curve c = 2sαβ",
        residuals: [0.22, 1e-15],
    },
    Erratum {
        place: "section 4.2, proof, second chain, X = (1 + e₁)(1 - e₂)/((1 - e₁)(1 + e₂))",
        against: "the sign of φ' at u = e₁ and u = e₂: share of 1000 random motions classified wrongly",
        printed: "loops: -(1 - e₃)/(1 + e₃) < X < -(1 + e₃)/(1 - e₃)",
        corrected: "loops: X < (e₃ - 1)/(e₃ + 1)",
        residuals: [1.00, 0.0],
    },
    Erratum {
        place: "section 5.1.1, text after eqn:wofx",
        against: "u of the full solution at t(x)",
        printed: "the ℘-function is shifted by ω₁",
        corrected: "the ℘-function is shifted by ω₂",
        residuals: [3.89, 1e-15],
    },
    Erratum {
        place: "section 5.1.1, a and b",
        against: "u(a) = -1 and u(b) = 1",
        printed: "a = ±(ω₁ + ∫ √R(u) du from -1 to e₁), b = ±∫ √R(u) du from e₂ to 1",
        corrected: "a = ±(ω₁ + ∫ du/√R(u) from -1 to e₁), b = ±∫ du/√R(u) from e₂ to 1",
        residuals: [0.40, 1e-14],
    },
    Erratum {
        place: "section 5.1.1, last sentence, with eqn:degtint and t(x) as printed",
        against: "the direction of x' = u'/w, u' of the full solution at t(x)",
        printed: "x moves on the imaginary axis in the negative direction: x' = -i|x'|",
        corrected: "x moves on the imaginary axis in the positive direction: x' = i|x'|",
        residuals: [2.00, 1e-15],
    },
    Erratum {
        place: "section 5.3.1, a and b",
        against: "u(a) = -1 and u(b) = 1",
        printed: "a = ±∫ √R(u) du from -1 to e₁, b = ±i ∫ √(-R(u)) du from e₁ to 1",
        corrected: "a = ±∫ du/√R(u) from -1 to e₁, b = ±i ∫ du/√(-R(u)) from e₁ to 1",
        residuals: [1.12, 1e-15],
    },
    Erratum {
        place: "section 5.3.2, proposition on t, last term",
        against: "the time at which the full solution is at u(x)",
        printed: "2 (ζ(ω₃) - ζ(b - ω₃)) x",
        corrected: "2 (ζ(ω₃) + ζ(b - ω₃)) x",
        residuals: [1.58, 1e-14],
    },
    Erratum {
        place: "section 5.3.3, proposition, p (with l corrected)",
        against: "α of the full solution",
        printed: "p = -w₋₁/(2w₊₁)",
        corrected: "p = w₋₁/(2w₊₁)",
        residuals: [0.35, 1e-14],
    },
    Erratum {
        place: "section 5.3.3, proposition, l (with p corrected)",
        against: "α of the full solution",
        printed: "l = w₋₁/4 - w₋₁/(1 - e₄²) + ζ(a - ω₃) - p (ζ(a + b) + ζ(a - b))",
        corrected: "l = w₋₁/4 - w₋₁/(1 - e₄²) + ζ(a - ω₃) - p (ζ(a + b) - ζ(a - b))",
        residuals: [0.29, 1e-14],
    },
    Erratum {
        place: "section 5.3.3, proof: what the lower half of Table 2 lists",
        against: "its first entry, residue 1 at (-1, -w₋₁), by contour quadrature",
        printed: "the poles of the logarithmic differential of β",
        corrected: "the poles of the logarithmic differential of δ",
        residuals: [1.00, 1e-14],
    },
    Erratum {
        place: "section 5.3.3, eqn:aperform, second line",
        against: "the parameter of the full solution that it names",
        printed: "β = k₂ exp(l₂x) σ(x + a)/σ(x + ω₃) (σ(x - b)/σ(x + b))^p",
        corrected: "δ = k₂ exp(l₂x) σ(x + a)/σ(x + ω₃) (σ(x - b)/σ(x + b))^p",
        residuals: [1.40, 1e-14],
    },
];
