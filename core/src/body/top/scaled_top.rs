//! Parameters of a top in the number type of a set-up stage, in units that keep every product in range.

use crate::scalar::{Float, times_power_of_two};
use crate::top::Top;

/// Units of inertia and length, powers of two, in which A and p are in [1, 2) and no product leaves the range.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Units {
    /// Unit of inertia, and so of angular momentum and of energy, in the caller's.
    pub(crate) inertia: f64,
    /// Unit of length, in the caller's.
    length: f64,
}

impl Units {
    pub(crate) fn new(top: &Top) -> Self {
        // the largest power of two that is not above a positive number
        let power = |x: f64| f64::from_bits(x.to_bits() & (0x7ff << 52));
        let p = top.p.to_f64();
        let (inertia, moment) = (power(top.a), if p > 0.0 { power(p) } else { 1.0 });
        Self { inertia, length: inertia / moment }
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
    /// Parameters in the units of `Units`.
    pub fn new(top: &Top) -> Self {
        Self::in_units(top, &Units::new(top))
    }

    /// Parameters in the units of the caller.
    pub fn as_given(top: &Top) -> Self {
        Self::in_units(top, &Units { inertia: 1.0, length: 1.0 })
    }

    fn in_units(top: &Top, &Units { inertia, length }: &Units) -> Self {
        // division by a power of two
        let exponent = |unit: f64| (unit.to_bits() >> 52) as i32 - 1023;
        let per = |x: f64, exponent: i32| F::from_f64(times_power_of_two(x, -exponent));
        let (inertia, length) = (exponent(inertia), exponent(length));
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

    /// Rate τ = ⟨ω, r⟩ - n/A of a body with this axial rate, rad per unit time; (1/C - 1/A) n without a rotor.
    pub(crate) fn tau(&self, spin: F) -> F {
        (self.a - self.c) / self.a * spin - self.k / self.a
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::TopParameters;

    /// The units inside are powers of two: what is a quotient of given numbers keeps its bits.
    #[test]
    fn units_inside_make_inertia_and_moment_one() {
        let top = TopParameters { com_height: 0.03, gravity: 9.81, ..TopParameters::default() };
        for scale in [1e-40, 1.0, 3e30] {
            let [transverse_inertia, axial_inertia] = [3e-5, 2e-5].map(|x| x * scale);
            let top =
                Top::sliding(&TopParameters { transverse_inertia, axial_inertia, mass: 0.05 * scale, ..top })
                    .unwrap();
            let (given, inside) = (ScaledTop::<f64>::as_given(&top), ScaledTop::<f64>::new(&top));
            assert!((1.0..2.0).contains(&inside.a) && (1.0..2.0).contains(&inside.p));
            assert_eq!(inside.c / inside.a, given.c / given.a);
            assert_eq!(inside.p * inside.g / inside.a, given.p * given.g / given.a);
            assert_eq!(inside.p * inside.s / inside.a, given.p * given.s / given.a);
        }
    }
}
