//! Nutation period, and the change of the slow phases over one period.

mod division;

mod advance;

mod quadrature;

pub(crate) use advance::Period;
pub use advance::PeriodAdvance;
