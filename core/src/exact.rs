//! Closed forms of the paper, and the elliptic functions that they use.
//!
//! Where the paper solves a motion in elementary or elliptic functions, this module has the solution as a function of
//! time. It is evaluated in extended precision and rounded to `f64` at the end, and is slower than an
//! [ephemeris](crate::Ephemeris), which can represent every motion. Its purpose is independent verification: it uses
//! no time step, no table and no quadrature.
//!
//! Error of an orientation, for every form and at any time up to 1e9 periods: below 1e-15 rad, plus the rounding of
//! the phases at t = 0 in the launch. This holds also where several differences of the branch points are small. Two
//! cases have larger errors, stated there: [`E3EqualsE4`] where e₃ and e₄ differ by a rounding, and
//! [`RegularPrecession`] where u is not exactly constant.
//!
//! | motion | condition | functions | item |
//! |---|---|---|---|
//! | no torque | free body, or g = 0 | trigonometric | [`FreeBody`] |
//! | planar pendulum | s = 0, l = n = 0 | Jacobi's | [`Pendulum`] |
//! | constant tilt | e₁ = e₂, or upright | trigonometric | [`RegularPrecession`] |
//! | aperiodic | e₂ = e₃ = 1 | hyperbolic, and Weierstrass's if the tip slides | [`Aperiodic`] |
//! | toy top | e₃ = e₄ | Weierstrass's | [`E3EqualsE4`] |
//! | Lagrange top | s = 0 | Weierstrass's | [`Lagrange`] |
//!
//! [`ClosedForm`] selects the one that applies. All other motions of a toy top need hyperelliptic functions.
//!
//! The elliptic functions are public: [`Weierstrass`](crate::elliptic::Weierstrass) (℘, ℘', ζ, σ, ln σ of a complex argument), [`Jacobi`](crate::elliptic::Jacobi) (sn, cn,
//! dn, am with the complementary parameter), [`agm`](crate::elliptic::agm), [`carlson_rf`](crate::elliptic::carlson_rf).
//!
//! The paper's other formulas are in [`hyperelliptic`] (the curve and its integrals), [`lagrangian`] (T, V, L, DL),
//! [`tip_curve`] and [`moebius`].
//!
//! ```
//! use toytop::{exact::ClosedForm, TopParameters, Motion, Release, State, Top};
//! let top = Top::fixed(&TopParameters { transverse_inertia: 7.5e-5, axial_inertia: 2.0e-5, mass_moment: 1.5e-3, gravity: 9.81, ..TopParameters::default() })?; // A, C about the tip, p, g
//! let state = State::release(&Release { tilt: 0.5, spin: 200.0, ..Release::default() })?;
//! let motion = Motion::launch(&top, &state)?;
//! let form = ClosedForm::of(&motion).expect("a Lagrange top always has one");
//! let height = form.at(0.75).u();
//! assert!((motion.branch_points().e1..=motion.branch_points().e2).contains(&height));
//! # Ok::<(), toytop::ParameterError>(())
//! ```

// The parts of the solutions.
mod sigma_quotient;

mod orientation;

mod periods;

// The solutions, one for each kind of motion that has one.
mod free_body;

mod precession;

mod aperiodic;

mod e3_equals_e4;

mod lagrange;

mod pendulum;

mod closed_form;

// The paper's other formulas.
pub mod hyperelliptic;

pub mod lagrangian;

pub mod moebius;

pub mod tip_curve;

pub use aperiodic::Aperiodic;
pub use closed_form::{ClosedForm, NoClosedForm};
pub use e3_equals_e4::E3EqualsE4;
pub use free_body::FreeBody;
pub use lagrange::Lagrange;
pub use pendulum::Pendulum;
pub use precession::{RegularPrecession, Stability, SteadyPrecession};
