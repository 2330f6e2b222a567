//! Constants of the recurrence by which the law is expanded, and how far it has come.

use crate::law::block::{Factor, TERMS};

/// Constant factors of the recurrence for one slow phase. The variation of its denominator is computed in the memory of
/// the rate's integral.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct SlowFactors {
    pub(super) from_square: Factor,
    pub(super) from_divisor: Factor,
    /// Factors of δ and of the variation of D dχ/dx in that of the denominator.
    pub(super) shares: [Factor; 2],
    pub(super) negligible: i64,
}

impl SlowFactors {
    pub(super) const ZERO: Self = Self {
        from_square: Factor::ZERO,
        from_divisor: Factor::ZERO,
        shares: [Factor::ZERO; 2],
        negligible: 0,
    };
}

/// Recurrence of the coefficients: its constant factors, and how far it has come.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Recurrence {
    pub(super) slow: [SlowFactors; 2],
    /// Factor of cos²χ in η, and factors of cos²χ and of its square in δ.
    pub(super) from_square: [Factor; 3],
    /// Factor from the units of δ to those of ξ.
    pub(super) to_drive: Factor,
    pub(super) to_sine: Factor,
    pub(super) to_cosine: Factor,
    /// Magnitudes below which a term of sin χ, cos χ and ξ is negligible.
    pub(super) negligible: [i64; 3],
    /// Derivatives θ' by y.
    pub(super) theta: [f64; 2],
    /// Larger of the derivatives ψ_A' and ψ_B' by y.
    pub(super) psi: f64,
    /// Index of the next coefficients.
    pub(super) next: usize,
    /// Whether the last coefficients are negligible.
    pub(super) before: bool,
}

impl Recurrence {
    /// Recurrence that has nothing left to compute.
    pub(super) const ENDED: Self = Self {
        slow: [SlowFactors::ZERO; 2],
        from_square: [Factor::ZERO; 3],
        to_drive: Factor::ZERO,
        to_sine: Factor::ZERO,
        to_cosine: Factor::ZERO,
        negligible: [0; 3],
        theta: [0.0; 2],
        psi: 0.0,
        next: TERMS,
        before: false,
    };
}
