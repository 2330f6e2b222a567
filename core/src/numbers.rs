//! Numbers: products of integers, phases, scalars, complex numbers.

pub(crate) mod product;

pub(crate) mod phase;

pub mod scalar;

pub(crate) mod complex;
