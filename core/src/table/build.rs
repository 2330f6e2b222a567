//! Build of a table: from the equations of a motion to the polynomials of half a period.
//!
//! A set-up goes along half a nutation period from span to span. On each span it expands the phases around the centre (`expansion`), in which
//! products of series need an exponent of their own for every series (`series`). The parameters α and β follow as polynomials in units of 2^-62
//! (`polynomial`), for which halvings and sums are enough. They are cut into segments (`cut`) as short as the limits demand (`limits`).

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
