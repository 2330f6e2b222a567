//! Random launches near every degenerate case: each must keep its error bound or be refused with a typed error. The error is also compared
//! with the change of the motion by a change of the input in its last place.

pub(crate) mod input;
pub(crate) mod reading;
pub(crate) mod tally;
pub(crate) mod trial;
