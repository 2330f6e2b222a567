//! Build of a table: the mean rates, the polynomials of half a period, and the error bounds.

pub(super) mod mean_rates;

pub(super) mod polynomial;

mod series;

mod span;

mod start_search;

pub(super) mod errors;

mod path;

pub(super) mod builder;

pub(super) mod bound;
