//! The paper's closed forms, and the elliptic functions they are made of.
//!
//! Where the paper integrates a motion in elementary or elliptic functions, here is that solution as a function of time,
//! in `f64`. It is no faster than an [ephemeris](crate::Ephemeris), which takes every motion; it is here as a second
//! witness, found by another way: no step, no table, no quadrature.
//!
//! | motion | condition | functions | item |
//! |---|---|---|---|
//! | constant tilt | e₁ = e₂, or upright | trigonometric | [`RegularPrecession`] |
//! | aperiodic | e₂ = e₃ = 1 | hyperbolic, and Weierstrass's if the tip slides | [`Aperiodic`] |
//! | toy top | e₃ = e₄ | Weierstrass's | [`E3EqualsE4`] |
//! | Lagrange top | s = 0 | Weierstrass's | [`Lagrange`] |
//!
//! [`ClosedForm`] chooses. Everything else a toy top does is hyperelliptic.
//!
//! The functions themselves are useful elsewhere: [`Weierstrass`] (℘, ℘', ζ, σ, ln σ of a complex argument), [`Jacobi`]
//! (sn, cn, dn, am with the complementary parameter), [`agm`], [`carlson_rf`].
//!
//! Beyond the solutions, the paper's other formulas as code: [`hyperelliptic`] (the curve and its integrals), [`lagrangian`]
//! (T, V, L, DL), [`tip_curve`] and [`moebius`].
//!
//! ```
//! use toytop::{exact::ClosedForm, Heaviness, Motion, Release, State, Top};
//! let top = Top::fixed(7.5e-5, 2.0e-5, 1.5e-3, 9.81)?; // A, C about the tip, p, g
//! let state = State::release(&Release { tilt: 0.5, spin: 200.0, ..Release::default() })?;
//! let motion = Motion::launch(&top, &state)?;
//! let form = ClosedForm::of(&motion).expect("a Lagrange top always has one");
//! let height = form.at(0.75).u();
//! assert!((motion.branch_points().e1..=motion.branch_points().e2).contains(&height));
//! # Ok::<(), toytop::LaunchError>(())
//! ```

mod agm;
mod aperiodic;
mod closed_form;
mod e3_equals_e4;
mod elementary;
pub mod hyperelliptic;
pub(crate) mod jacobi;
mod lagrange;
pub mod lagrangian;
pub mod moebius;
mod orientation;
mod periods;
mod precession;
mod sigma_quotient;
mod tall_lattice;
mod theta;
pub mod tip_curve;
mod weierstrass;

pub use agm::{agm, carlson_rf};
pub use aperiodic::Aperiodic;
pub use closed_form::{ClosedForm, NoClosedForm};
pub use e3_equals_e4::E3EqualsE4;
pub use jacobi::{Jacobi, JacobiValues};
pub use lagrange::Lagrange;
pub use precession::{RegularPrecession, Stability, SteadyPrecession};
pub use weierstrass::Weierstrass;
