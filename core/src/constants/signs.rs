//! Signs of l + n and l - n.

use crate::scalar::Ring;

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
