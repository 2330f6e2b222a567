//! Launches towards every degenerate corner: does each keep its bound or get a typed refusal, and how large is its error
//! beside what the last place of its own input does?

pub mod input;
pub mod reading;
pub mod tally;
pub mod trial;
