//! Pictures and pages.
//!
//! | module | contents |
//! |---|---|
//! | [`plot`] | curve of the tip |
//! | `bounds` | bounds between which the axis stays |
//! | `cycle` | time in which a motion repeats itself |
//! | `span` | motion over a span of time |
//! | `charts` | tilt and precession against time, potential |
//! | `animation` | animation of the top, frame by frame |
//! | `camera`, `sphere` | projection of space; the axis on its sphere |
//! | [`figures`] | figures of the paper, and charts |
//! | `accuracy` | error of each scalar against its cost |
//! | `fit` | residuals of a fit, error of its prediction |
//! | `heat_map` | column of a sweep over two axes |
//! | `work_precision` | error of an integrator against its work |
//! | [`view`] | page for a browser |

#[cfg(feature = "program")]
pub mod accuracy;
#[cfg(feature = "program")]
pub(crate) mod animation;
mod bounds;
#[cfg(feature = "program")]
mod camera;
#[cfg(feature = "program")]
pub(crate) mod charts;
mod cycle;
#[cfg(feature = "program")]
pub mod figures;
#[cfg(feature = "program")]
pub(crate) mod fit;
#[cfg(feature = "program")]
pub(crate) mod heat_map;
pub mod plot;
#[cfg(feature = "program")]
pub(crate) mod span;
#[cfg(feature = "program")]
pub(crate) mod sphere;
pub mod view;
#[cfg(feature = "program")]
pub(crate) mod work_precision;
