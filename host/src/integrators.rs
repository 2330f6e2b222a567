//! Output of an integrator, compared with the exact motion.
//!
//! | module | contents |
//! |---|---|
//! | [`trajectory`] | times and orientations from a file |
//! | `phases` | phase errors of nutation, precession and spin |
//! | [`scorer`] | errors of a trajectory, and drifts of l, n and h |
//! | [`order`] | order of convergence of several step sizes |

pub mod trajectory;

mod phases;

pub mod order;
pub mod scorer;
