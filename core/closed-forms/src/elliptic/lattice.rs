//! Weierstrass's functions on rectangular lattices in extended precision.

use crate::elliptic::carlson::carlson_rf;
use crate::elliptic::elementary::{
    ValueAndSlope, WideComplex, complex_exp, complex_ln, exp, half_pi, imaginary, quotient, real,
};
use crate::elliptic::theta::{eisenstein, thetas};
use toytop::Complex;
use toytop::scalar::{Extended, Float, Ring};

/// Lattice of the periods 2ω and 2ω', with ω > 0 and ω' = i|ω'|; ℘ has the values e₁ > e₂ > e₃ at ω, ω + ω', ω'.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Lattice {
    pub(crate) roots: [Extended; 3],
    /// Half periods ω and |ω'|.
    pub(crate) half_periods: [Extended; 2],
    /// Whether ω > |ω'|. The theta functions then belong to the lattice rotated by a right angle, whose nome is at most e^{-π} too.
    is_rotated: bool,
    /// Logarithm of the nome q.
    ln_nome: Extended,
    nome: Extended,
    /// Factor U in the argument v = Uz of the theta functions: π/2ω, or iπ/2|ω'|.
    unit: WideComplex,
    /// Factors that make the slope of the first theta function and the values of the others 1 at 0.
    scales: [WideComplex; 4],
    /// Coefficient c in σ(z) = e^{cz²} ϑ₁(Uz)/(U ϑ₁'(0)).
    pub(crate) sigma_exponent: Extended,
}

/// Half period, or 0. A theta function is named by the half period at which it is 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum LatticeHalfPeriod {
    Origin,
    Omega,
    OmegaPrime,
    /// Sum ω + ω'.
    Sum,
}

impl LatticeHalfPeriod {
    /// Sum of 0 and a half period, or of ω and ω'.
    pub(crate) fn plus(self, other: Self) -> Self {
        if self == Self::Origin { other } else { Self::Sum }
    }
}

impl Lattice {
    /// Lattice from the differences of the roots, e₁ - e₂ and e₂ - e₃, both > 0.
    pub(crate) fn from_gaps(upper_gap: Extended, lower_gap: Extended) -> Self {
        // ω = R_F(0, e₁ - e₂, e₁ - e₃), and |ω'| likewise with e₂ - e₃
        let [real_half, imaginary_half] =
            [upper_gap, lower_gap].map(|gap| carlson_rf(Extended::ZERO, gap, upper_gap + lower_gap));
        let third = |x: Extended| x / 3.0.into();
        let roots = [
            third(upper_gap.doubled() + lower_gap),
            third(lower_gap - upper_gap),
            -third(upper_gap + lower_gap.doubled()),
        ];
        let is_rotated = real_half > imaginary_half;
        let (width, height) =
            if is_rotated { (imaginary_half, real_half) } else { (real_half, imaginary_half) };
        let ln_nome = -(half_pi().doubled() * height / width);
        let nome = exp(ln_nome);
        let size = half_pi() / width;
        let unit = if is_rotated { imaginary(size) } else { real(size) };
        let sigma_exponent = (unit * unit).re * eisenstein(nome) / 6.0.into();
        let half_periods = [real_half, imaginary_half];
        let unscaled = Self {
            roots,
            half_periods,
            is_rotated,
            ln_nome,
            nome,
            unit,
            scales: [Complex::ONE; 4],
            sigma_exponent,
        };
        let [origin, omega, omega_prime, sum] = unscaled.thetas(Complex::ZERO);
        let at_zero = [origin.slope, omega.value, omega_prime.value, sum.value];
        Self { scales: at_zero.map(|z| quotient(Complex::ONE, z)), ..unscaled }
    }

    /// Quasi-periods ζ(ω) and ζ(ω')/i. The longer period has the term of Legendre's relation.
    pub(crate) fn quasi_periods(&self) -> [Extended; 2] {
        let [real_half, imaginary_half] = self.half_periods.map(|half| self.sigma_exponent.doubled() * half);
        let [omega, omega_prime] = self.half_periods;
        if self.is_rotated {
            [real_half + half_pi() / omega_prime, imaginary_half]
        } else {
            [real_half, imaginary_half - half_pi() / omega]
        }
    }

    /// Theta functions at Uz with their derivatives by z, in the order of [`LatticeHalfPeriod`], for z within a period of 0.
    pub(crate) fn thetas(&self, z: WideComplex) -> [ValueAndSlope; 4] {
        let [one, two, four, three] = thetas(self.nome, self.unit * z).map(|theta| theta.by(self.unit));
        if self.is_rotated { [one, four, two, three] } else { [one, two, four, three] }
    }

    /// Theta function that is 0 at a half period. It costs as much as all four.
    pub(crate) fn theta(&self, half: LatticeHalfPeriod, z: WideComplex) -> ValueAndSlope {
        let [origin, omega, omega_prime, sum] = self.thetas(z);
        match half {
            LatticeHalfPeriod::Origin => origin,
            LatticeHalfPeriod::Omega => omega,
            LatticeHalfPeriod::OmegaPrime => omega_prime,
            LatticeHalfPeriod::Sum => sum,
        }
    }

    /// Logarithmic derivative of the theta function that is 0 at a half period.
    pub(crate) fn log_slope(&self, half: LatticeHalfPeriod, z: WideComplex) -> WideComplex {
        self.theta(half, z).log_slope()
    }

    /// Argument minus the nearest period, and that period by numbers of 2ω and 2ω'.
    fn reduced(&self, z: WideComplex) -> (WideComplex, [f64; 2]) {
        let [real_period, imaginary_period] = self.half_periods.map(Ring::doubled);
        let n = libm::round((z.re / real_period).to_f64());
        let m = libm::round((z.im / imaginary_period).to_f64());
        (Complex::new(z.re - real_period * n.into(), z.im - imaginary_period * m.into()), [n, m])
    }

    /// Values of the theta functions, scaled to slope 1 of the first and value 1 of the others at 0.
    pub(crate) fn scaled_thetas(&self, z: WideComplex) -> [WideComplex; 4] {
        let [origin, omega, omega_prime, sum] = self.thetas(z);
        let [a, b, c, d] = self.scales;
        [origin.value * a, omega.value * b, omega_prime.value * c, sum.value * d]
    }

    /// √(℘ - e₁), √(℘ - e₂) and √(℘ - e₃), as quotients of theta functions.
    fn root_differences(&self, z: WideComplex) -> [WideComplex; 3] {
        let [origin, omega, omega_prime, sum] = self.scaled_thetas(self.reduced(z).0);
        [omega, sum, omega_prime].map(|theta| quotient(theta, origin))
    }

    /// ℘ minus each of the three roots, computed without the subtraction.
    pub(crate) fn differences(&self, z: WideComplex) -> [WideComplex; 3] {
        self.root_differences(z).map(|root| root * root)
    }

    /// ℘(z), from the root of least magnitude.
    pub(crate) fn p(&self, z: WideComplex) -> WideComplex {
        let [_, difference, _] = self.differences(z);
        let [_, middle, _] = self.roots;
        difference + real(middle)
    }

    /// ℘'(z) = -2 √((℘ - e₁)(℘ - e₂)(℘ - e₃)).
    pub(crate) fn p_prime(&self, z: WideComplex) -> WideComplex {
        let [first, second, third] = self.root_differences(z);
        let product = first * second * third;
        -(product + product)
    }

    /// σ(z) as a value and the exponent of a factor, and ζ(z).
    fn sigma_parts(&self, z: WideComplex) -> (WideComplex, WideComplex, WideComplex) {
        let (reduced, [n, m]) = self.reduced(z);
        let theta = self.theta(LatticeHalfPeriod::Origin, reduced);
        // ϑ₁(v + nπ + mπτ) = (-1)^{n+m} q^{-m²} e^{-2imv} ϑ₁(v)
        let rows = Extended::from(if self.is_rotated { n } else { m });
        let rate = -(self.unit.times_i().scaled(rows.doubled()));
        let sum = n + m;
        let odd = sum - 2.0 * libm::floor(0.5 * sum);
        let constant = Complex::new(-(self.ln_nome * rows.squared()), half_pi() * (2.0 * odd).into());
        let [scale, ..] = self.scales;
        (
            theta.value * scale,
            (z * z).scaled(self.sigma_exponent) + rate * reduced + constant,
            z.scaled(self.sigma_exponent.doubled()) + rate + theta.log_slope(),
        )
    }

    /// ζ(z).
    pub(crate) fn zeta(&self, z: WideComplex) -> WideComplex {
        self.sigma_parts(z).2
    }

    /// A logarithm of σ(z).
    pub(crate) fn ln_sigma(&self, z: WideComplex) -> WideComplex {
        let (value, exponent, _) = self.sigma_parts(z);
        exponent + complex_ln(value)
    }

    /// σ(z).
    pub(crate) fn sigma(&self, z: WideComplex) -> WideComplex {
        let (value, exponent, _) = self.sigma_parts(z);
        value * complex_exp(exponent)
    }
}
