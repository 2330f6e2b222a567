//! Build of a table: from the equations of a motion to the polynomials of half a period. A set-up goes from file to file:
//!
//! ```text
//! set_up.rs            motion, settings, memory   -> table
//!   error_budget.rs      allowed error              -> allowed errors of its parts
//!   mean_rates.rs        motion, period             -> mean rates of the phases
//!   half_period.rs       mean rates                 -> cells and segments
//!     tabulation.rs        half a period              -> spans, cells and segments
//!     path.rs              a span                     -> power series of the phases, polynomials of a and b
//!     segment.rs           polynomials on a segment   -> stored coefficients, bounds on errors and speeds
//!   launch_clock.rs      mean rates, launch phases  -> clock
//!   error_bound.rs       half a period, mean rates  -> error bounds
//! ```
//!
//! The tabulated a and b are α and β without their mean rotation. To tabulate χ and the two slow phases would be simpler, but a tick would then
//! take a third sine and two more products. A span whose series are not accurate with sixteen terms is halved (`error_budget`). A power
//! series carries its own exponent (`series`). The polynomials of a and b need none, because they are only halved and added: all are
//! in units of 2^-62 (`polynomial`).
//!
//! `pause` is called between the parts of a set-up that take long: nodes of a quadrature, coefficients of an expansion, and segments.

mod error_budget;

mod interval;

mod mean_rates;

mod path;

mod segment;

mod tabulation;

mod set_up_error;

mod half_period;

mod launch_clock;

mod error_bound;

mod set_up;

pub use set_up::{TableSettings, Workspace};
pub use set_up_error::SetUpError;

#[cfg(test)]
mod tests {
    use crate::{InitialAngles, Motion, Signs, Top, TopParameters};

    /// Nutating motion of a sliding top.
    pub(super) fn nutating_motion() -> Motion {
        let parameters = TopParameters {
            transverse_inertia: 1.0,
            axial_inertia: 0.7,
            com_height: 1.0,
            mass_moment: 1.0,
            ..TopParameters::default()
        };
        let top = Top::sliding(&parameters).unwrap();
        let e = [-0.5, 0.5, 1.5];
        Motion::from_branch_points(&top, e, Signs::default(), &InitialAngles::default()).unwrap()
    }
}
