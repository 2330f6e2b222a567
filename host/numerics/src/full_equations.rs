//! Full 3-D equations of motion: a reference that shares no formula with the core, and baselines.
//!
//! | module | contents |
//! |---|---|
//! | [`newton_euler`] | equations with the force of the plane, at one time |
//! | [`full_solver`] | integration with a tolerance |
//! | [`solution`] | full solver of a scenario at given times |
//! | [`baseline`] | integration in equal steps, as programs do without the core |

pub mod baseline;
pub mod full_solver;
pub mod newton_euler;
pub mod solution;
