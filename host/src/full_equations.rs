//! The full 3-D equations of motion: the reference that shares no formula with the core, and the baselines.
//!
//! | module | contents |
//! |---|---|
//! | [`newton_euler`] | equations with the force of the plane, at one instant |
//! | [`full_solver`] | integration with a tolerance |
//! | [`solution`] | full solver taken from a scenario to given times |
//! | [`baseline`] | integration in equal steps: what one would write without the core |

pub mod baseline;
pub mod full_solver;
pub mod newton_euler;
pub mod solution;
