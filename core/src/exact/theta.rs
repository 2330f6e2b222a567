//! The four theta functions of one nome q <= e^{-π}, where five terms of their series reach the last digit of `f64`.

use super::elementary::sin_cos;
use crate::complex::Complex;

/// The nome and its powers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Theta {
    nome: f64,
}

/// ϑ₁ and ϑ₂ without their common factor 2 q^{1/4}, which would underflow and always cancels; ϑ₃ and ϑ₄.
#[derive(Clone, Copy, Debug)]
pub(super) struct Values {
    /// ϑ₁ / (2 q^{1/4}).
    pub(super) one: Complex<f64>,
    /// Its derivative.
    pub(super) one_slope: Complex<f64>,
    /// ϑ₂ / (2 q^{1/4}).
    pub(super) two: Complex<f64>,
    /// ϑ₃.
    pub(super) three: Complex<f64>,
    /// ϑ₄.
    pub(super) four: Complex<f64>,
}

/// For |Im v| <= -½ ln q, up to which arguments are reduced, the n-th term is q^{n²}: the sixth is below 1e-33.
const TERMS: usize = 6;

impl Theta {
    /// The series of a nome in (1e-301, e^{-π}].
    pub(super) fn new(nome: f64) -> Self {
        Self { nome }
    }

    /// At v, |Im v| <= -½ ln q.
    ///
    /// sin (2n+1)v / sin v and the like are polynomials of cos 2v by a three-term recurrence; each is multiplied with its
    /// power of q as it grows, so that neither leaves the range, and ϑ₁ keeps its relative precision at its zero.
    pub(super) fn at(&self, v: Complex<f64>) -> Values {
        let q = self.nome;
        let (sine, cosine) = sin_cos(v);
        let (double_sine, double_cosine) = sin_cos(v + v);
        let (c, slope) = (double_cosine + double_cosine, double_sine.scaled(-4.0)); // 2 cos 2v and its derivative
        let one = Complex::ONE;

        // ϑ₁ / sin v with its derivative, ϑ₂ / cos v: terms ∓q^{n(n+1)} W_n, W_{n+1} = c W_n - W_{n-1}
        let (mut odd, mut odd_slope, mut even) =
            (Sum::starting(one, one), Sum::default(), Sum::starting(one, one));
        let (mut step, mut skip) = (q * q, q * q); // q^{2n+2} and q^{4n+2}
        for _ in 1..TERMS {
            let (c, slope) = (c.scaled(step), slope.scaled(step));
            let grown = c * odd_slope.last + slope * odd.last;
            odd_slope.add(-grown - odd_slope.before.scaled(skip));
            odd.add(-(c * odd.last) - odd.before.scaled(skip));
            even.add(c * even.last - even.before.scaled(skip));
            (step, skip) = (step * q * q, skip * q * q * q * q);
        }
        // ϑ₃, ϑ₄: terms (±1)ⁿ q^{n²} 2 cos 2nv; the term n = 0 counts half
        let (mut plain, mut alternating) = (Sum::starting(c.scaled(q), one + one), Sum::default());
        alternating.total = -plain.total;
        let (mut step, mut skip, mut sign) = (q * q * q, q * q * q * q, 1.0); // q^{2n+1} and q^{4n}
        for _ in 2..TERMS {
            plain.add(c.scaled(step) * plain.last - plain.before.scaled(skip));
            alternating.total = alternating.total + plain.last.scaled(sign);
            (step, skip, sign) = (step * q * q, skip * q * q * q * q, -sign);
        }
        Values {
            one: sine * odd.total,
            one_slope: cosine * odd.total + sine * odd_slope.total,
            two: cosine * even.total,
            three: one + plain.total,
            four: one + alternating.total,
        }
    }

    /// 1 - 24 Σ n q^{2n}/(1 - q^{2n}) = -ϑ₁'''(0)/ϑ₁'(0), the Eisenstein series E₂.
    pub(super) fn eisenstein(&self) -> f64 {
        const POWERS: u32 = 7;
        let square = self.nome * self.nome;
        let mut power = 1.0;
        let sum = (1..=POWERS).fold(0.0, |sum, n| {
            power *= square;
            sum + f64::from(n) * power / (1.0 - power)
        });
        1.0 - 24.0 * sum
    }
}

/// A sum of terms by a recurrence: the total, and the last two terms.
#[derive(Clone, Copy, Debug, Default)]
struct Sum {
    total: Complex<f64>,
    last: Complex<f64>,
    before: Complex<f64>,
}

impl Sum {
    /// With a first term, and the one that the recurrence has before it.
    fn starting(first: Complex<f64>, before: Complex<f64>) -> Self {
        Self { total: first, last: first, before }
    }

    fn add(&mut self, term: Complex<f64>) {
        self.before = self.last;
        self.last = term;
        self.total = self.total + term;
    }
}
