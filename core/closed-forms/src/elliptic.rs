//! Elliptic functions and integrals: Jacobi's sn, cn, dn, am; Weierstrass's ℘, ℘', ζ, σ; the arithmetic-geometric
//! mean and Carlson's R_F.
//!
//! Small differences (the complementary parameter, the differences of the roots) are separate arguments, so that no
//! digit is lost near a degenerate case.

pub(crate) mod elementary;

pub(crate) mod carlson;

pub(crate) mod theta;

pub(crate) mod lattice;

mod jacobi;

mod weierstrass;

pub use carlson::{agm, carlson_rf};
pub use jacobi::{Jacobi, JacobiValues};
pub use weierstrass::Weierstrass;
