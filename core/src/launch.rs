//! Set-up: runs once per throw, may refuse, computes in double-double.
//!
//! [`State`] → [`FirstIntegrals`] → [`BranchPoints`] → [`Motion`], in this order; a stage knows earlier ones only.

mod averages;
mod branch_points;
mod cell;
mod economise;
mod first_integrals;
mod motion;
mod normal_force;
mod rates;
mod regime;
mod seek;
mod start;
mod state;
mod tabulate;

pub use averages::Averages;
pub use branch_points::BranchPoints;
pub(crate) use cell::{CELLS, Cell};
pub(crate) use economise::Polynomial;
pub use first_integrals::{FirstIntegrals, Sign, Signs};
pub(crate) use motion::Course;
pub use motion::Motion;
pub(crate) use rates::Rates;
pub use regime::{Pace, Regime, TipClass};
pub use start::Start;
pub use state::{Release, State};
pub(crate) use tabulate::{Fineness, Tabulated, tabulate};
