//! Random motions of every regime, for which the core's ephemeris is compared with the truth ([`toytop_host::truth`]).

pub mod corners;
mod draw;
pub mod tally;
pub mod throws;
pub mod trial;
