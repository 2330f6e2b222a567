//! Build of a table: the mean rates, the polynomials of half a period, and the error bounds.

pub(super) mod mean_rates;

mod span;

pub(super) mod errors;

pub(super) mod bound;

mod start;

mod series;

pub(super) mod path;

pub(super) mod builder;
