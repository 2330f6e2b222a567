//! Random motions of every regime, for which the core's ephemeris is compared with the truth ([`toytop_host::truth`]).

pub(crate) mod corners;
mod draw;
pub(crate) mod launches;
pub(crate) mod tally;
pub(crate) mod trial;
