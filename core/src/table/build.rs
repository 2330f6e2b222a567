//! Build of a table: from the equations of a motion to the polynomials of half a period. A set-up goes from file to file:
//!
//! ```text
//! ephemeris.rs     set_up: a motion, a memory             -> a table
//!   limits.rs        allowed error, capacity              -> limits of its parts
//!   set_up.rs      begin
//!     mean_rates.rs  motion/period                        -> mean rates of the phases, and their errors
//!     path.rs        turning point u = e₁                 -> first span (span.rs)
//!   set_up.rs      build: for each span of half a period
//!     path.rs        phases at the centre                 -> origin of the expansion
//!       expansion.rs   recurrence.rs, series.rs           -> power series of the phases
//!     polynomial.rs  expansion/parameters.rs              -> polynomials of α and β
//!     launch_place.rs  phase of the launch                -> nutation phase at t = 0
//!     cut.rs         polynomials                          -> segments, and cells that refer to them
//!   ephemeris.rs   finish: rates, launch                  -> clock
//!     bound.rs       errors of all parts                  -> error bounds
//! ```
//!
//! An expansion multiplies series of unlike size, each in units of its own exponent (`series`). The polynomials of α and β are only
//! halved and added: all are in units of 2^-62 (`polynomial`).

mod series;

mod span;

mod limits;

mod expansion;

mod mean_rates;

mod bound;

mod polynomial;

mod path;

mod launch_place;

mod cut;

mod set_up;

mod ephemeris;

pub use ephemeris::SetUpError;
pub use set_up::SetUp;
