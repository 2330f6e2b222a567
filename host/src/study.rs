//! Random motions of every regime, and the core's ephemeris held against an evaluation that shares nothing with it.
//!
//! The truth ([`exact`]) is the paper's own integrals, with their poles, in double-double (32 digits): time and
//! arguments as integrals over the nutation phase, by Gauss and Legendre's rule on panels graded towards the turning
//! points, behind which all singularities lie. It shares no formula with the core's regularised law, no series, no
//! stepping, no mean rates. What the rule leaves is some 1e-28 of the integral (tested by other panels, and against
//! vectors of 30 digits), and the times asked for are solved for, not rounded.

pub mod corners;
mod draw;
pub mod exact;
pub mod gauss;
pub mod motions;
pub mod places;
pub mod random;
pub mod states;
pub mod tally;
pub mod trial;
pub mod trigonometry;
#[cfg(test)]
mod vectors;
pub mod wide;
