//! Truth of a motion to more than thirty digits ([`exact`]): the paper's integrals, with their poles, in numbers of 192 bits (57 digits). Time
//! and arguments are integrals over the nutation phase, computed by the Gauss-Legendre rule on panels that are shorter near the turning
//! points, beyond which all singularities lie. The truth shares no formula and no arithmetic with the core: it uses neither the regularised
//! law nor its series or its stepping, and every operation is dashu's. The relative error of the rule is some 1e-37 (tested by other
//! panels, and against vectors of 30 digits), which at tick 2^62 is still below 1e-17 rad; times are exact.

pub mod exact;
pub(crate) mod gauss;
pub(crate) mod law;
pub mod motions;
pub mod precise;
pub mod state_constants;
pub mod states;
#[cfg(test)]
mod vectors;
