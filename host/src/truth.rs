//! Two references: the paper's integrals by quadrature in numbers of 640 bits (192 digits), and an integration of the full 3-D equations.
//!
//! Both use the core's type `Orientation`. The quadrature shares no formula with the core. The integration takes the state at t = 0 from the
//! core if a launch is given by branch points.
//!
//! The arithmetic of the quadrature is dashu's. Its relative error is 1e-37, which at tick 2^62 is below 1e-17 rad.
//!
//! | module | contents |
//! |---|---|
//! | [`motion_input`] | top, and branch points or a state |
//! | [`float640`] | arithmetic in numbers of 640 bits |
//! | `nutation` | rates of a motion, and their integrals over a nutation |
//! | `launch_constants` | constants from branch points or a state |
//! | [`quadrature`] | orientation and rates at a time by quadrature |
//! | [`full_solver`] | integration of the full 3-D equations |

pub mod motion_input;

pub mod float640;
mod nutation;

mod launch_constants;
pub mod quadrature;

pub mod full_solver;
