//! First integrals l, n and h (Proposition 1 of the paper), and the signs of l + n and l - n.

use crate::scalar::{Float, Ring, numeric_struct};

numeric_struct! {
    /// First integrals l, n and h: two components of the angular momentum, and the energy. The other numbers follow from
    /// them, except `spin` where C = 0.
    #[derive(Clone, Copy, Debug, PartialEq)]
    #[cfg_attr(feature = "defmt", derive(defmt::Format))]
    #[non_exhaustive]
    pub struct FirstIntegrals<F = f64> {
        /// Vertical angular momentum l = ⟨m, k⟩, kg m²/s.
        pub l,
        /// Axial angular momentum n = ⟨m, r⟩ = C ⟨ω, r⟩ + K, kg m²/s.
        pub n,
        /// Energy h = T + V, J; V = 0 at the height of the tip. The constant energy of a rotor relative to the body is left out.
        pub h,
        /// Axial rate ⟨ω, r⟩ of the body, rad/s: (n - K)/C; a further constant where C = 0.
        pub spin,
        /// Sum l + n, kg m²/s.
        pub l_plus_n,
        /// Difference l - n, kg m²/s.
        pub l_minus_n,
    }
}

impl<F: Float> FirstIntegrals<F> {
    /// Signs of l + n and l - n; + where the number is 0.
    pub fn signs(&self) -> Signs {
        Signs { l_plus_n: Sign::new(self.l_plus_n), l_minus_n: Sign::new(self.l_minus_n) }
    }
}

/// Sign, + or -.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Sign {
    /// Positive, +.
    #[default]
    Plus,
    /// Negative, -.
    Minus,
}

impl Sign {
    /// Sign of x; + for 0.
    pub fn new<R: Ring>(x: R) -> Self {
        if x < R::ZERO { Self::Minus } else { Self::Plus }
    }

    /// Product ±x.
    pub fn times<R: Ring>(self, x: R) -> R {
        match self {
            Self::Plus => x,
            Self::Minus => -x,
        }
    }

    /// Integer ±1.
    pub fn as_i32(self) -> i32 {
        match self {
            Self::Plus => 1,
            Self::Minus => -1,
        }
    }
}

/// Signs of l + n and l - n. They are equal if |l| > |n|. In a launch from a state, 0 counts as +.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Signs {
    /// Sign of l + n.
    pub l_plus_n: Sign,
    /// Sign of l - n.
    pub l_minus_n: Sign,
}
