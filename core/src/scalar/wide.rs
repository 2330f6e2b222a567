//! Floating-point numbers with a significand of one or two words of 64 bits, computed in integers.
//!
//! A launch computes in 128 bits, so that small differences that the `f64` input determines exactly keep their digits.

mod words;

mod number;

mod arithmetic;

mod conversion;

pub use number::{Extended, Extended64, Wide};
