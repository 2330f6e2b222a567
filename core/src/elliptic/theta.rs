//! Four theta functions of a nome q <= e^{-π}: six terms of their series are enough for extended precision.

use crate::complex::Complex;
use crate::elliptic::elementary::{Wide, sin_cos};
use crate::scalar::{Extended, Ring};

/// Theta functions of one nome.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Theta {
    nome: Extended,
}

/// Values of the theta functions. ϑ₁ and ϑ₂ are divided by their common factor 2 q^{1/4}, which could underflow and
/// cancels in every quotient.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Values {
    /// ϑ₁(v) / (2 q^{1/4}).
    pub(crate) one: Wide,
    /// Derivative of `one` with respect to v.
    pub(crate) one_slope: Wide,
    /// ϑ₂(v) / (2 q^{1/4}).
    pub(crate) two: Wide,
    /// ϑ₃(v).
    pub(crate) three: Wide,
    /// ϑ₄(v).
    pub(crate) four: Wide,
}

/// Number of terms. For |Im v| <= -½ ln q, the range of the reduced arguments, the n-th term is at most q^{n² - n},
/// and the first omitted term is below 1e-40.
const TERMS: usize = 6;

impl Theta {
    /// Theta functions of a nome in [0, e^{-π}].
    pub(crate) fn new(nome: Extended) -> Self {
        Self { nome }
    }

    /// Values at v, for |Im v| <= -½ ln q.
    ///
    /// sin (2n+1)v / sin v, and the corresponding quotients of the other functions, are polynomials in cos 2v with a
    /// three-term recurrence. Each term is multiplied by its power of q within the recurrence, so that no intermediate
    /// result overflows or underflows, and ϑ₁ keeps its relative precision at its zero.
    pub(crate) fn at(&self, v: Wide) -> Values {
        let q = self.nome;
        let square = q.squared();
        let (sine, cosine) = sin_cos(v);
        let one = Complex::ONE;
        // 2 cos 2v and its derivative with respect to v
        let (doubled_sine, doubled_cosine) = ((sine + sine) * cosine, (cosine + sine) * (cosine - sine));
        let (c, slope) = (doubled_cosine + doubled_cosine, -(doubled_sine + doubled_sine));
        let slope = slope + slope;

        // ϑ₁ / sin v with its derivative, and ϑ₂ / cos v: terms ∓q^{n(n+1)} W_n, with W_{n+1} = c W_n - W_{n-1}
        let (mut odd, mut odd_slope, mut even) =
            (Sum::starting(one, one), Sum::default(), Sum::starting(one, one));
        let (mut step, mut skip) = (square, square); // q^{2n+2} and q^{4n+2}
        for _ in 1..TERMS {
            let (c, slope) = (c.scaled(step), slope.scaled(step));
            let grown = c * odd_slope.last + slope * odd.last;
            odd_slope.add(-grown - odd_slope.before.scaled(skip));
            odd.add(-(c * odd.last) - odd.before.scaled(skip));
            even.add(c * even.last - even.before.scaled(skip));
            (step, skip) = (step * square, skip * square.squared());
        }
        // ϑ₃ and ϑ₄: terms (±1)ⁿ q^{n²} 2 cos 2nv; half of the term n = 0
        let (mut plain, mut alternating) = (Sum::starting(c.scaled(q), one + one), Sum::default());
        alternating.total = -plain.total;
        let (mut step, mut skip, mut positive) = (q * square, square.squared(), true); // q^{2n+1} and q^{4n}
        for _ in 2..TERMS {
            plain.add(c.scaled(step) * plain.last - plain.before.scaled(skip));
            alternating.total = alternating.total + if positive { plain.last } else { -plain.last };
            (step, skip, positive) = (step * square, skip * square.squared(), !positive);
        }
        Values {
            one: sine * odd.total,
            one_slope: cosine * odd.total + sine * odd_slope.total,
            two: cosine * even.total,
            three: one + plain.total,
            four: one + alternating.total,
        }
    }

    /// Eisenstein series E₂ = 1 - 24 Σ n q^{2n}/(1 - q^{2n}) = -ϑ₁'''(0)/ϑ₁'(0).
    pub(crate) fn eisenstein(&self) -> Extended {
        const POWERS: u32 = 13;
        let square = self.nome.squared();
        let mut power = Extended::ONE;
        let sum = (1..=POWERS).fold(Extended::ZERO, |sum, n| {
            power = power * square;
            sum + power * f64::from(n).into() / (Extended::ONE - power)
        });
        Extended::ONE - sum * 24.0.into()
    }
}

/// Sum of terms that follow a recurrence: the total, and the last two terms.
#[derive(Clone, Copy, Debug)]
struct Sum {
    total: Wide,
    last: Wide,
    before: Wide,
}

impl Default for Sum {
    fn default() -> Self {
        Self { total: Complex::ZERO, last: Complex::ZERO, before: Complex::ZERO }
    }
}

impl Sum {
    /// Sum with its first term, and the term that precedes it in the recurrence.
    fn starting(first: Wide, before: Wide) -> Self {
        Self { total: first, last: first, before }
    }

    fn add(&mut self, term: Wide) {
        self.before = self.last;
        self.last = term;
        self.total = self.total + term;
    }
}
