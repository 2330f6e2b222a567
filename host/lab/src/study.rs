//! Random motions of every regime, and the core's ephemeris held against the truth ([`toytop_host::truth`]).

pub mod corners;
mod draw;
pub mod tally;
pub mod throws;
pub mod trial;
