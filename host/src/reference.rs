//! Reference for the core: the paper's integrals by quadrature in numbers of 640 bits (192 digits). It shares no formula with the core.
//!
//! The arithmetic is dashu's, with 192 digits. The phases of the quadrature have a relative error of 1e-37, which at tick 2^62 is below 1e-17 rad.
//!
//! | module | contents |
//! |---|---|
//! | [`float640`] | arithmetic in numbers of 640 bits |
//! | `nutation` | rates of a motion, and their integrals over a nutation |
//! | `launch_constants` | constants from branch points or a state |
//! | [`quadrature`] | orientation and rates at a time by quadrature |

pub mod float640;
mod nutation;

mod launch_constants;
pub mod quadrature;
