//! Constants of a motion in extended precision: [`State`](crate::State) → [`FirstIntegrals`] →
//! [`BranchPoints`] → [`Regime`], [`TipClass`].

mod first_integrals;

mod cubic;

mod branch_points;

mod regime;

pub(crate) mod normal_force;

pub use branch_points::BranchPoints;
pub(crate) use first_integrals::ReducedPoint;
pub use first_integrals::{FirstIntegrals, Sign, Signs};
pub use regime::{Regime, TipClass};
