//! Constants of a motion in extended precision: first integrals, branch points, regime, tip class, least normal force.
//!
//! Each follows from the one before: [`State`](crate::State) → [`FirstIntegrals`] → [`BranchPoints`] → [`Regime`],
//! [`TipClass`].

mod first_integrals;

mod branch_points;

mod regime;

mod tip_class;

mod conditioning;

pub(crate) mod normal_force;

pub use branch_points::BranchPoints;
pub(crate) use branch_points::{LowerPair, LowerPairSearch, Roots};
pub(crate) use conditioning::Conditioning;
pub use first_integrals::{FirstIntegrals, Sign, Signs};
pub(crate) use first_integrals::{MovingAxis, ReducedPoint};
pub use regime::Regime;
pub use tip_class::TipClass;
