//! Top in units that keep every product in range.

use super::Top;
use crate::scalar::{Float, exponent, ldexp, power_of_two};

/// Parameters by the paper's symbols. The units of inertia and length are powers of two: A and p are in [1, 2).
#[derive(Clone, Copy, Debug)]
pub struct ScaledTop<F> {
    /// Transverse moment of inertia A.
    pub a: F,
    /// Axial moment of inertia C.
    pub c: F,
    /// Distance of the centre of mass from the tip.
    pub s: F,
    /// Mass moment.
    pub p: F,
    /// Gravity.
    pub g: F,
    /// Momentum of the rotor.
    pub k: F,
}

impl<F: Float> ScaledTop<F> {
    /// Parameters of a top.
    pub fn new(top: &Top) -> Self {
        let [leading, remainder] = top.p.to_parts();
        let inertia = inertia_exponent(top);
        let moment = if leading > 0.0 { exponent(leading) - 1 } else { 0 };
        let scaled = |x: f64, exponent: i32| F::from_f64(ldexp(x, -exponent));
        let [a, c, k] = [top.a, top.c, top.k].map(|x| scaled(x, inertia));
        let [s, g] = [top.s, top.g].map(|x| scaled(x, inertia - moment));
        Self { a, c, s, p: scaled(leading, moment) + scaled(remainder, moment), g, k }
    }

    /// Unit of the energy of the axis: the weight p g, or 1 without it.
    pub(crate) fn weight_or_one(&self) -> F {
        if self.g > F::ZERO { self.p * self.g } else { F::ONE }
    }

    /// Length D(u) = A/p + s (1 - u²), from 1 - u².
    pub fn d(&self, sine_squared: F) -> F {
        self.a / self.p + self.s * sine_squared
    }

    /// Quotient A/(ps) = e₄² - 1.
    pub fn a_over_ps(&self) -> F {
        self.a / (self.p * self.s)
    }

    /// Factor κ = 1/(2 A p g), which makes κ l² dimensionless.
    pub(crate) fn kappa(&self) -> F {
        F::ONE / (self.a * self.p * self.g).doubled()
    }

    /// Axial rate ⟨ω, r⟩ = (n - K)/C of the body, rad/s; 0 where C = 0, because n does not determine it.
    pub(crate) fn spin(&self, n: F) -> F {
        if self.c > F::ZERO { (n - self.k) / self.c } else { F::ZERO }
    }
}

/// Exponent of the unit of inertia, angular momentum and energy.
fn inertia_exponent(top: &Top) -> i32 {
    exponent(top.a) - 1
}

impl Top {
    /// Unit of inertia, angular momentum and energy of the [`ScaledTop`].
    pub(crate) fn inertia_unit(&self) -> f64 {
        power_of_two(inertia_exponent(self))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::TopParameters;
    use crate::scalar::Extended;

    const TOP: TopParameters = TopParameters::TOY;

    /// The units are powers of two, so that quotients of given numbers keep their bits.
    #[test]
    fn units_inside_make_inertia_and_moment_one() {
        for scale in [1e-40, 1.0, 3e30] {
            let [transverse_inertia, axial_inertia] = [3e-5, 2e-5].map(|x| x * scale);
            let top =
                Top::sliding(&TopParameters { transverse_inertia, axial_inertia, mass: 0.05 * scale, ..TOP })
                    .unwrap();
            let (inside, p) = (ScaledTop::<f64>::new(&top), top.mass_moment());
            assert!((1.0..2.0).contains(&inside.a) && (1.0..2.0).contains(&inside.p));
            assert_eq!(inside.c / inside.a, top.c / top.a);
            assert_eq!(inside.p * inside.g / inside.a, p * top.g / top.a);
            assert_eq!(inside.p * inside.s / inside.a, p * top.s / top.a);
        }
    }

    #[test]
    fn the_mass_moment_is_exact() {
        let top = Top::sliding(&TOP).unwrap();
        assert!(top.p.to_parts()[1] != 0.0);
        assert_eq!(top.mass_moment(), 0.05 * 0.03);
        let unit = ScaledTop::<Extended>::new(&top).p / top.p;
        assert_eq!(unit, power_of_two(1 - exponent(0.05 * 0.03)).into());
    }
}
