//! Build of a table: from the equations of a motion to the polynomials of half a period. A set-up goes from file to file:
//!
//! ```text
//! set_up.rs              motion, settings, memory       -> table
//!   error_budget.rs        allowed error                  -> allowed errors of its parts
//!   half_period.rs         for each cell: segments that are short enough
//!     motion/period          motion                         -> period, and integrals of the phase equations
//!     mean_rates.rs          motion, period                 -> mean rates of the phases, and their errors
//!     stored_segment.rs      polynomials on the span        -> stored coefficients, and bounds on errors and speeds
//!   path.rs                for each span: two expansions, from its beginning to its centre and from there to its end
//!     expansion.rs           recurrence.rs, series.rs       -> power series of the phases
//!     expansion/cayley_klein.rs                             -> power series of a and b
//!     polynomial.rs          power series                   -> polynomials of a and b on the span
//!     launch_phases.rs       χ of the launch                -> nutation phase and mean phases of the launch
//!   launch_clock.rs        mean rates, launch phases      -> clock, and with read/tip_angle.rs its tip angle
//!   half_period/bound.rs   errors of all parts            -> error bounds
//! interval.rs            spans, cells and segments as parts of half a period
//! ```
//!
//! The tabulated a and b are α and β without their mean rotation. Series have an exponent each (`series`). The
//! polynomials of a and b are only halved and added: all are in units of 2^-62 (`polynomial`).
//!
//! `pause` is called between the parts of a set-up that take long: nodes of a quadrature, coefficients of an expansion, and segments.

mod series;

mod expansion;

mod error_budget;

mod polynomial;

mod interval;

mod launch_phases;

mod path;

mod half_period;

mod launch_clock;

mod set_up;

pub use set_up::{SetUpError, TableSettings, Workspace};

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
