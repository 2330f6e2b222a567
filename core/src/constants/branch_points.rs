//! Branch points e₁ <= e₂ <= 1 <= e₃ of the hyperelliptic curve, and their differences (paper, section 3.2).
//!
//! On the motion, (s/2)(e₄² - u²) u'² = g (u - e₁)(u - e₂)(u - e₃). The differences are computed without cancellation.

mod from_reduced_point;

mod from_integrals;

use crate::body::{ParameterError, Top, check_range};
use crate::constants::{FirstIntegrals, Signs};
use crate::scalar::{Extended, Float, Ring, numeric_struct};

numeric_struct! {
    /// Branch points and their differences; none has a unit.
    #[derive(Clone, Copy, Debug, PartialEq)]
    #[cfg_attr(feature = "defmt", derive(defmt::Format))]
    #[non_exhaustive]
    pub struct BranchPoints<F = f64> {
        /// Least u of the motion, e₁ >= -1.
        pub e1,
        /// Greatest u of the motion, e₂ <= 1.
        pub e2,
        /// Third branch point, e₃ >= 1; infinite without torque, like its differences.
        pub e3,
        /// 1 + e₁ >= 0.
        pub one_plus_e1,
        /// 1 - e₂ >= 0.
        pub one_minus_e2,
        /// e₂ - e₁ >= 0.
        pub e2_minus_e1,
        /// e₃ - e₂ >= 0.
        pub e3_minus_e2,
        /// e₃ - 1 >= 0.
        pub e3_minus_one,
    }
}

/// Largest e₃. Beyond it the torque has less effect than the rounding of a state.
const MAX_E3: f64 = 1e14;

impl BranchPoints {
    /// First integrals of branch points and signs (equation (3.6)). Without torque they are not determined, and l = n = 0.
    pub fn integrals(&self, top: &Top, signs: Signs) -> FirstIntegrals {
        self.map(Extended::from).extended_integrals(top, signs).map(Float::to_f64)
    }
}

impl BranchPoints<Extended> {
    /// Branch points from three numbers, with exact differences.
    pub(crate) fn from_roots([e1, e2, e3]: [f64; 3]) -> Result<Self, ParameterError> {
        check_range(-1.0..=1.0, "e1", e1, "in [-1, e2]")?;
        check_range(e1..=1.0, "e2", e2, "in [e1, 1]")?;
        check_range(1.0..=MAX_E3, "e3", e3, "in [1, 1e14]")?;
        let [one, e1, e2, e3] = [1.0, e1, e2, e3].map(Extended::from);
        Ok(Self {
            e1,
            e2,
            e3,
            one_plus_e1: one + e1,
            one_minus_e2: one - e2,
            e2_minus_e1: e2 - e1,
            e3_minus_e2: e3 - e2,
            e3_minus_one: e3 - one,
        })
    }

    /// First integrals in extended precision.
    pub(crate) fn extended_integrals(&self, top: &Top, signs: Signs) -> FirstIntegrals<Extended> {
        let Top { a, c, p, g, .. } = *top;
        let scale = (a * p * g).doubled();
        let plus = (scale * self.one_plus_e1 * self.one_plus_e2() * self.one_plus_e3()).sqrt();
        let minus = (scale * self.one_minus_e1() * self.one_minus_e2 * self.e3_minus_one).sqrt();
        let l_plus_n = signs.l_plus_n.times(plus);
        let l_minus_n = signs.l_minus_n.times(minus);
        let n = (l_plus_n - l_minus_n).halved();
        let spin = top.spin(n);
        // h = p g (e₁ + e₂ + e₃) + (C ⟨ω, r⟩² - n²/A)/2
        let h = p * g * (self.e1 + self.e2 + self.e3) + (c * spin.squared() - n.squared() / a).halved();
        FirstIntegrals { l: (l_plus_n + l_minus_n).halved(), n, h, spin, l_plus_n, l_minus_n }
    }
}

impl<F: Float> BranchPoints<F> {
    /// Difference 1 - e₁.
    pub fn one_minus_e1(&self) -> F {
        self.one_minus_e2 + self.e2_minus_e1
    }

    /// Sum 1 + e₂.
    pub fn one_plus_e2(&self) -> F {
        self.one_plus_e1 + self.e2_minus_e1
    }

    /// Sum 1 + e₃.
    pub fn one_plus_e3(&self) -> F {
        F::from_f64(2.0) + self.e3_minus_one
    }

    /// Difference e₃ - e₁.
    pub fn e3_minus_e1(&self) -> F {
        self.e3_minus_e2 + self.e2_minus_e1
    }
}
