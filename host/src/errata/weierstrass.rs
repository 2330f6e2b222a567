//! Weierstrass's functions by theta series, for the formulas of section 5, without the functions of core.

use num_complex::Complex64 as C;
use std::f64::consts::PI;

/// Functions ℘, ζ and σ of the lattice with real roots E₁ > E₂ > E₃, for |Im z| up to a few half periods, because arguments are not reduced.
#[derive(Clone, Copy, Debug)]
pub(super) struct Lattice {
    /// Real half period, where ℘ = E₁.
    pub(super) real: f64,
    /// Modulus of the imaginary half period, where ℘ = E₃.
    pub(super) imaginary: f64,
    nome: f64,
    /// Value of ζ at the real half period.
    eta: f64,
}

impl Lattice {
    pub(super) fn new([e1, e2, e3]: [f64; 3]) -> Self {
        // K(m)/√(E₁-E₃) = π/(2 agm(√(E₁-E₃), √(E₁-E₂))), and the imaginary half period with √(E₂-E₃) in place of √(E₁-E₂)
        let [whole, upper, lower] = [e1 - e3, e1 - e2, e2 - e3].map(f64::sqrt);
        let half = |smaller: f64| 0.5 * PI / mean(whole, smaller);
        let (real, imaginary) = (half(upper), half(lower));
        let mut lattice = Self { real, imaginary, nome: (-PI * imaginary / real).exp(), eta: 0.0 };
        let [_, first, _, third] = lattice.theta(C::new(0.0, 0.0));
        lattice.eta = -PI * PI / (12.0 * real) * (third / first).re;
        lattice
    }

    /// Function θ₁ and its first three derivatives at πz/(2 real).
    fn theta(&self, z: C) -> [C; 4] {
        let v = z * (0.5 * PI / self.real);
        let mut sums = [C::new(0.0, 0.0); 4];
        for n in 0..12 {
            let odd = f64::from(2 * n + 1);
            let sign = if n % 2 == 0 { 2.0 } else { -2.0 };
            let weight = sign * self.nome.powf(0.25 * odd * odd);
            let (sine, cosine) = ((v * odd).sin() * weight, (v * odd).cos() * weight);
            let terms = [sine, cosine * odd, -sine * odd * odd, -cosine * odd * odd * odd];
            sums.iter_mut().zip(terms).for_each(|(sum, term)| *sum += term);
        }
        sums
    }

    pub(super) fn sigma(&self, z: C) -> C {
        let scale = 0.5 * PI / self.real;
        let [_, at_zero, ..] = self.theta(C::new(0.0, 0.0));
        (z * z * (self.eta / (2.0 * self.real))).exp() * self.theta(z)[0] / (at_zero * scale)
    }

    pub(super) fn zeta(&self, z: C) -> C {
        let [value, first, ..] = self.theta(z);
        z * (self.eta / self.real) + first / value * (0.5 * PI / self.real)
    }

    pub(super) fn p(&self, z: C) -> C {
        let scale = 0.5 * PI / self.real;
        let [value, first, second, _] = self.theta(z);
        let slope = first / value;
        (slope * slope - second / value) * (scale * scale) - self.eta / self.real
    }

    pub(super) fn p_slope(&self, z: C) -> C {
        let scale = 0.5 * PI / self.real;
        let [value, first, second, third] = self.theta(z);
        let slope = first / value;
        let sum = third / value - second / value * slope * 3.0 + slope * slope * slope * 2.0;
        -sum * (scale * scale * scale)
    }
}

/// Arithmetic-geometric mean of two numbers.
fn mean(mut a: f64, mut b: f64) -> f64 {
    for _ in 0..8 {
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
    }
    a
}

/// One of the two integrals below, as a function of (root, end, others).
pub(super) type Integral = fn(f64, f64, [f64; 2]) -> f64;

/// Integral ∫ du/√|4 (u - root)(u - others)| from `root` to `end`, by u = root ± y², where the integrand is smooth.
pub(super) fn from_root(root: f64, end: f64, others: [f64; 2]) -> f64 {
    smooth_half(end, root, |u| others.iter().map(|other| (u - other).abs()).product::<f64>().sqrt().recip())
}

/// Integral ∫ √|4 (u - root)(u - others)| du from `root` to `end`, which the paper prints in place of [`from_root`].
pub(super) fn printed_from_root(root: f64, end: f64, others: [f64; 2]) -> f64 {
    smooth_half(end, root, |u| {
        let size: f64 = others.iter().map(|other| (u - other).abs()).product();
        4.0 * (u - root).abs() * size.sqrt()
    })
}

/// Integral ∫ f(root ± y²) dy for y from 0 to √|end - root|, by the trapezoid rule in a variable in which the integrand vanishes fast at
/// both ends.
fn smooth_half(end: f64, root: f64, f: impl Fn(f64) -> f64) -> f64 {
    let length = (end - root).abs().sqrt();
    let node = |i: i32| {
        // y = length (1 + tanh(π/2 sinh x))/2
        let x = 0.05 * f64::from(i);
        let inner = 0.5 * PI * x.sinh();
        let y = 0.5 * length * (1.0 + inner.tanh());
        let weight = 0.25 * PI * length * x.cosh() / inner.cosh().powi(2);
        f(root + (y * y).copysign(end - root)) * weight
    };
    0.05 * (-70..=70).map(node).sum::<f64>()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// ℘'² = 4(℘-E₁)(℘-E₂)(℘-E₃), ζ' = -℘, σ' = ζσ, and Legendre's relation.
    #[test]
    fn they_are_weierstrass_functions() {
        let roots = [0.9, 0.2, -1.1];
        let lattice = Lattice::new(roots);
        let step = 1e-4;
        for z in [C::new(0.3, 0.4), C::new(-0.7, 0.2), C::new(0.1, -1.2)] {
            let cubic: C = roots.iter().map(|root| lattice.p(z) - root).product();
            let square = lattice.p_slope(z) * lattice.p_slope(z);
            assert!((square - cubic * 4.0).norm() < 1e-13 * square.norm());
            let slope = |f: &dyn Fn(C) -> C| (f(z + step) - f(z - step)) / (2.0 * step);
            assert!(
                (slope(&|z| lattice.zeta(z)) + lattice.p(z)).norm() < 1e-6 * lattice.p(z).norm().max(1.0)
            );
            assert!((slope(&|z| lattice.sigma(z)) / lattice.sigma(z) - lattice.zeta(z)).norm() < 1e-6);
        }
        let (real, imaginary) = (C::new(lattice.real, 0.0), C::new(0.0, lattice.imaginary));
        let legendre = lattice.zeta(real) * imaginary - lattice.zeta(imaginary) * real;
        assert!((legendre - C::new(0.0, 0.5 * PI)).norm() < 1e-14);
        assert!(
            (lattice.p(real) - roots[0]).norm() < 1e-14 && (lattice.p(imaginary) - roots[2]).norm() < 1e-14
        );
    }
}
