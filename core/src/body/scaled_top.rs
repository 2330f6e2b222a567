//! Parameters of a top in units that keep every product in range.

use super::Top;
use crate::scalar::{Extended, Float, Ring, exponent, power_of_two, times_power_of_two};

/// Units of inertia and length, powers of two, in which A and p are in [1, 2) and no product leaves the range.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Units {
    /// Exponent of the unit of inertia, angular momentum and energy.
    inertia: i32,
    /// Exponent of the unit of length.
    length: i32,
}

impl Units {
    pub(crate) fn new(top: &Top) -> Self {
        let p = top.mass_moment();
        let (inertia, moment) = (exponent(top.a) - 1, if p > 0.0 { exponent(p) - 1 } else { 0 });
        Self { inertia, length: inertia - moment }
    }

    pub(crate) fn inertia(&self) -> f64 {
        power_of_two(self.inertia)
    }
}

/// Parameters of a top by the paper's symbols.
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
    /// Parameters in the units inside.
    pub fn new(top: &Top) -> Self {
        Self::in_units(top, Units::new(top))
    }

    fn in_units(top: &Top, Units { inertia, length }: Units) -> Self {
        let per = |x: f64, exponent: i32| F::from_f64(times_power_of_two(x, -exponent));
        let [leading, rest] = top.p.parts();
        let moment = |p: f64| per(p, inertia - length);
        let [a, c, k] = [top.a, top.c, top.k].map(|x| per(x, inertia));
        let [s, g] = [top.s, top.g].map(|x| per(x, length));
        Self { a, c, s, p: moment(leading) + moment(rest), g, k }
    }

    /// Factor κ = 1/(2 A p g), which makes κ l² dimensionless.
    pub(crate) fn kappa(&self) -> F {
        F::ONE / (self.a * self.p * self.g).doubled()
    }

    /// Axial rate ⟨ω, r⟩ = (n - K)/C of the body, rad per unit time; 0 where C = 0, because n does not determine it.
    pub(crate) fn spin(&self, n: F) -> F {
        if self.c > F::ZERO { (n - self.k) / self.c } else { F::ZERO }
    }
}

impl Top {
    /// Branch point e₄ = √(1 + A/(ps)) (equation (3.5) of the paper), which u never reaches; `None` unless the tip slides.
    pub fn e4(&self) -> Option<f64> {
        let ScaledTop { a, s, p, .. } = ScaledTop::<Extended>::new(self);
        (self.s > 0.0).then(|| (Extended::ONE + a / (p * s)).sqrt().to_f64())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::TopParameters;

    const TOP: TopParameters = TopParameters {
        transverse_inertia: 3e-5,
        axial_inertia: 2e-5,
        com_height: 0.03,
        mass: 0.05,
        mass_moment: 0.0,
        gravity: 9.81,
        rotor_momentum: 0.0,
    };

    fn as_given<F: Float>(top: &Top) -> ScaledTop<F> {
        ScaledTop::in_units(top, Units { inertia: 0, length: 0 })
    }

    /// The units inside are powers of two: what is a quotient of given numbers keeps its bits.
    #[test]
    fn units_inside_make_inertia_and_moment_one() {
        for scale in [1e-40, 1.0, 3e30] {
            let [transverse_inertia, axial_inertia] = [3e-5, 2e-5].map(|x| x * scale);
            let top =
                Top::sliding(&TopParameters { transverse_inertia, axial_inertia, mass: 0.05 * scale, ..TOP })
                    .unwrap();
            let (given, inside) = (as_given::<f64>(&top), ScaledTop::<f64>::new(&top));
            assert!((1.0..2.0).contains(&inside.a) && (1.0..2.0).contains(&inside.p));
            assert_eq!(inside.c / inside.a, given.c / given.a);
            assert_eq!(inside.p * inside.g / inside.a, given.p * given.g / given.a);
            assert_eq!(inside.p * inside.s / inside.a, given.p * given.s / given.a);
        }
    }

    #[test]
    fn the_mass_moment_is_exact() {
        let top = Top::sliding(&TOP).unwrap();
        assert!(top.p.parts()[1] != 0.0);
        assert_eq!(top.mass_moment(), 0.05 * 0.03);
        assert_eq!(as_given::<Extended>(&top).p, top.p);
    }
}
