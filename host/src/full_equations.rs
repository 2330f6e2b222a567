//! Full 3-D equations of motion: a reference that shares no formula with the core.
//!
//! | module | contents |
//! |---|---|
//! | [`equations`] | equations of Euler and Poisson, by the momentum |
//! | [`newton_euler`] | equations with the force of the plane, at one time |
//! | [`full_solver`] | integration with a tolerance |
//! | [`solution`] | full solver of a scenario at given times |

pub mod full_solver;
pub mod newton_euler;
pub mod solution;

pub use toytop_model::equations;
