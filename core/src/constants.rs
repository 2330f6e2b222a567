//! Constants of a motion in extended precision: [`State`](crate::State) → [`FirstIntegrals`] →
//! [`BranchPoints`] → [`Regime`], [`TipClass`].

mod reduced_point;

mod first_integrals;

pub(crate) mod cubic;

mod branch_points;

mod regime;

pub use branch_points::BranchPoints;
pub use first_integrals::{FirstIntegrals, Sign, Signs};
pub(crate) use reduced_point::ReducedPoint;
pub(crate) use regime::is_steady;
pub use regime::{Regime, TipClass};
