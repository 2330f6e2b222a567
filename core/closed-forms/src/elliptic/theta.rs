//! Four theta functions of a nome q <= e^{-π}, and their derivatives.

use crate::elliptic::elementary::{ValueAndSlope, WideComplex, complex_sine_cosine, real};
use toytop::Complex;
use toytop::scalar::{Extended, Ring};

/// ϑ₁(v)/(2q^¼), ϑ₂(v)/(2q^¼), ϑ₄(v)/2 and ϑ₃(v)/2 with their derivatives, for |Im v| <= -ln q.
///
/// Each term with cos kv or sin kv is at most q^{k²/4 - k/2 - 1/2} times the largest one; the first omitted term is below 1e-33.
pub(crate) fn thetas(nome: Extended, v: WideComplex) -> [ValueAndSlope; 4] {
    const TERMS: u32 = 14;
    let (sine, cosine) = complex_sine_cosine(v);
    let starting = |x: f64| ValueAndSlope { value: real(x.into()), slope: Complex::ZERO };
    let [mut one, mut two, mut four, mut three] = [0.0, 0.0, 0.5, 0.5].map(starting);
    let mut sine_k = sine;
    let mut cosine_k = cosine;
    // q^{(k² - 1)/4} for odd k, q^{k²/4} for even k
    let mut weight = Extended::ONE;
    let mut next = nome;
    let mut step = nome.squared();
    for k in 1..=TERMS {
        let alternating = if k & 2 == 0 { weight } else { -weight };
        let number = Extended::from(f64::from(k));
        let sine_slope = cosine_k.scaled(number);
        let cosine_slope = -sine_k.scaled(number);
        if k & 1 == 1 {
            one.add(sine_k.scaled(alternating), sine_slope.scaled(alternating));
            two.add(cosine_k.scaled(weight), cosine_slope.scaled(weight));
        } else {
            four.add(cosine_k.scaled(alternating), cosine_slope.scaled(alternating));
            three.add(cosine_k.scaled(weight), cosine_slope.scaled(weight));
        }
        (sine_k, cosine_k) = (sine_k * cosine + cosine_k * sine, cosine_k * cosine - sine_k * sine);
        (weight, next, step) = (next, weight * step, step * nome);
    }
    [one, two, four, three]
}

/// Eisenstein series E₂ = -ϑ₁'''(0)/ϑ₁'(0).
pub(crate) fn eisenstein(nome: Extended) -> Extended {
    const TERMS: u32 = 7;
    let square = nome.squared();
    let mut first = Extended::ZERO;
    let mut third = Extended::ZERO;
    let mut weight = Extended::ONE;
    let mut step = square;
    for n in 0..TERMS {
        let k = Extended::from(f64::from(2 * n + 1));
        (first, third) = (first + weight * k, third + weight * k * k.squared());
        (weight, step) = (-(weight * step), step * square);
    }
    third / first
}
