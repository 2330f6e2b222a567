//! Random launches near every degenerate case: each must keep its error bound or be refused with a typed error. The error is also compared
//! with the change of the motion by a change of the input in its last place.

pub mod input;
pub mod reading;
pub mod tally;
pub mod trial;
