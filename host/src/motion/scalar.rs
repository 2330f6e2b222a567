//! Scalar types of the core.

/// Scalar types of the core.
#[derive(Clone, Copy, PartialEq)]
#[cfg_attr(feature = "program", derive(clap::ValueEnum))]
pub enum Scalar {
    /// Double precision
    F64,
    /// Single precision
    F32,
    /// Fixed point of 32 bits
    Q31,
    /// Fixed point of 16 bits
    Q15,
}

impl Scalar {
    /// All scalar types.
    pub const ALL: [Self; 4] = [Self::F64, Self::F32, Self::Q31, Self::Q15];

    /// Name on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::F64 => "f64",
            Self::F32 => "f32",
            Self::Q31 => "q31",
            Self::Q15 => "q15",
        }
    }
}
